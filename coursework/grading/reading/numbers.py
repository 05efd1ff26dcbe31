"""The text of one cell -> its number and how it was printed, or why it has no number.

Enters: a cell's text and the file's decimal mark.  Leaves: `PrintedNumber`.
Our own pattern decides what a number is, never `float()` alone.
Used by whatever reads a file of a student or of a platform.
"""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import NamedTuple

from coursework.grading.reading.student_work import Flag
from coursework.grading.reading.unit_names import WORDS, unit_of

_PLAIN = str.maketrans({
    **{chr(0xFF10 + digit): str(digit) for digit in range(10)}, "．": ".", "，": ",", "＋": "+", "－": "-", "＝": "=",
    "−": "-", "–": "-", "‐": "-", "‑": "-", "\u00a0": " ", "\u202f": " ", "\u2009": " ", "\u2007": " ", "\u3000": " ",
    "’": "'", "ʼ": "'", "Е": "e", "е": "e", "\ufeff": "", "\u200b": "", "\u200e": "", "\u200f": "", "⋅": "·", "×": "·", "∙": "·",
})  # fmt: skip
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_POWER = re.compile(r"\s*(?:[·*xх]\s*10\s*\^?|\*\^)\s*[({]?\s*([-+]?[0-9⁰¹²³⁴-⁹⁻⁺]{1,4})[)}]?")
# Signs that people put around a number ("≈3.02", "**3.02**", "(3.02)", "3.02*", "3.02 ✓") and remarks beside it on its accuracy
# or source.  A unit may stand beside it too, but the unit of the column comes from its header or from the values.
_BEFORE, _BEHIND = "≈≃≅~$*_`|([{'\"\\ ", "*_`$|)]};:,.!?'\"†‡§✓✔✗✘❌✅←◄\\ "
_BESIDE = re.compile(
    r"\s*(?:(?:±|\+/-|\+-)\s?[0-9.,]{1,9}|\([0-9]{1,2}\)|[(\[][^()\[\]]{1,40}[)\]]|(?:←|<-|<=|//|#)\D{1,60}|[⁰¹²³⁴-⁹]{1,2})"
)
# An angle in degrees, minutes and seconds, 93°23'31"; below, the decimals of a degree that minutes and seconds are taken to give.
_SEXAGESIMAL = re.compile(
    r"([-+]?)([0-9]{1,4})\s*°\s*([0-5]?[0-9]|60)\s*['′](?:\s*([0-5]?[0-9]|60)(?:[.,]([0-9]{1,6}))?\s*(?:\"|″|''))?"
)
_MINUTE, _SECOND = 1, 3
_ERROR = re.compile(
    r"#.*|[-+]?nan(?:\(.*\))?|[-+]?inf(?:inity)?|[-+]?∞|n/?a|[-+]?1[.,]#.*|undefined|err:.*|ошибка.*|помилка.*|div/0!?",
    re.IGNORECASE,
)
_MONTHS = "|".join(WORDS["months"])
_DATE = re.compile(
    rf"\d{{1,4}}\s?[-./ ]\s?(?:{_MONTHS})[а-яіїa-z]*\.?(?:\s?[-./ ]\s?\d{{2,4}})?"
    rf"|(?:{_MONTHS})[а-яіїa-z]*[-./ ]+\d{{1,4}}"
    r"|\d{1,2}[./-]\d{1,2}[./-](?:\d{4}|\d{2})|\d{4}-\d{1,2}-\d{1,2}(?:[t ].*)?|\d{1,2}月\d{1,2}日|\d{4}年\d{1,2}月.*"
    r"|\d{1,2}:\d{2}(?::\d{2})?",
    re.IGNORECASE,
)


def _pattern(mark: str, other: str) -> re.Pattern[str]:
    whole = rf"[1-9][0-9]{{0,2}}(?P<group>[ '{other}])[0-9]{{3}}(?:(?P=group)[0-9]{{3}}){{0,4}}|[0-9]{{1,40}}"
    return re.compile(
        rf"(?P<sign>[-+]?)\s?(?:(?P<whole>{whole})(?:{mark}(?P<part>[0-9]{{0,40}}))?|{mark}(?P<bare>[0-9]{{1,40}}))"
        r"(?:\s?[eEdD]\s?(?P<power>[-+]?[0-9]{1,4}))?"
    )


_PLAINLY = re.compile(r"-?[0-9]+\.[0-9]+")  # most cells: nothing stands around such a number
_NUMBER = {".": _pattern(r"\.", ","), ",": _pattern(",", r"\.")}


_STORED_DIGITS = 15
ROUNDED = 0.505  # of one unit of the last place: the most that rounding for print changes a number


class PrintedNumber(NamedTuple):
    """A cell: its text, its value (NaN if `flag`), the power of ten of its last digit, its count of significant digits."""

    text: str
    value: float
    place: int
    digits: int
    flag: Flag

    @property
    def is_number(self) -> bool:
        """Return whether the cell holds a number."""
        return not self.flag

    @property
    def last_place(self) -> float:
        """Return the value of one unit of the last digit."""
        return 10.0 ** max(self.place, -300)

    @property
    def stands_for_number(self) -> bool:
        """Return whether the cell holds a number, or held one until a spreadsheet spoilt it."""
        return self.flag in {"", "error", "date", "formula"}


def no_number(text: str, flag: Flag) -> PrintedNumber:
    """Return a cell that has no number, and why."""
    return PrintedNumber(text, math.nan, 0, 0, flag)


NOTHING = no_number("", "missing")


def differ(first: PrintedNumber, second: PrintedNumber, factor: float = 1.0, other: float = 1.0) -> bool:
    """Return whether two cells are numbers that differ by more than rounding; the factors convert them to a common unit."""
    rounded = ROUNDED * (first.last_place * factor + second.last_place * other)
    return first.is_number and second.is_number and abs(first.value * factor - second.value * other) > rounded


def plain_text(text: str) -> str:
    """Return a cell's text in the form in which numbers are read.

    Digits, minus and blanks become the usual ones, a power of ten becomes e, and signs around the number are removed.

    >>> [plain_text(text) for text in ("≈3,02", "**3.02**", "−3.02(1)", "3.02 рад/с", "1,2·10^-3 *", "3.02 m2")]
    ['3,02', '3.02', '-3.02', '3.02', '1,2e-3', '3.02 m2']
    """
    whole = text.translate(_PLAIN).strip()
    bare = whole.removeprefix('"').removeprefix("=").lstrip(_BEFORE).replace("{,}", ",")
    end = max(found.end() if (found := pattern.match(bare)) else 0 for pattern in _NUMBER.values())
    number, beside = bare[:end], bare[end:]
    if power := _POWER.match(beside):
        number, beside = f"{number}e{power[1].translate(_RAISED)}", beside[power.end() :]
    if not number:
        return whole
    is_beside = not (rest := beside.strip(_BEHIND)) or unit_of(rest) or _BESIDE.fullmatch(beside)
    return number if is_beside else whole


@lru_cache(maxsize=8192)
def _matched(text: str) -> tuple[str, re.Match[str] | None, re.Match[str] | None]:
    """Return a cell's plain text and its matches with a decimal comma and with a point; cached: a cell is read several times."""
    plain = text if _PLAINLY.fullmatch(text) else plain_text(text)
    return plain, _NUMBER[","].fullmatch(plain), _NUMBER["."].fullmatch(plain)


def looks_numeric(text: str) -> bool:
    """Return whether a cell is a number with either decimal mark, or an angle in degrees, minutes and seconds."""
    plain, by_comma, by_point = _matched(text)
    return by_comma is not None or by_point is not None or _SEXAGESIMAL.fullmatch(plain) is not None


def marks(texts: list[str]) -> tuple[int, int, int, int]:
    """Count the cells by decimal mark: only a comma fits, only a point fits, both fit and it has a comma, both and a point."""
    comma = point = either_comma = either_point = 0
    for text in texts:
        if "," not in text and "." not in text and "，" not in text and "．" not in text:
            continue
        plain, by_comma, by_point = _matched(text)
        if by_comma and not by_point:
            comma += 1
        elif by_point and not by_comma:
            point += 1
        elif by_comma and by_point:
            either_comma += "," in plain
            either_point += "." in plain
    return comma, point, either_comma, either_point


def printed(text: str, mark: str, strict: bool = False) -> PrintedNumber:
    r"""Return what a cell says; `mark` is the file's decimal mark, `strict` is True if the file uses both marks.

    A cell that only the other mark fits is read with that mark.  A cell that both marks fit is read with the file's mark;
    with `strict` it counts as text if it contains only the other mark.

    >>> printed("1 234,50", ",")
    PrintedNumber(text='1 234,50', value=1234.5, place=-2, digits=6, flag='')
    >>> printed("-93°30'36\"", ",")
    PrintedNumber(text='-93°30\'36"', value=-93.51, place=-3, digits=5, flag='')
    """
    plain, by_comma, by_point = _matched(text)
    if not plain or plain in {"-", "--", "---", "—", "…", ".", "*"}:
        return no_number(text, "missing")
    other = "," if mark == "." else "."
    match, second = (by_comma, by_point) if mark == "," else (by_point, by_comma)
    if not match or (strict and other in plain and mark not in plain):
        if match and second:
            return no_number(text, "text")
        match = match or second
    if match:
        return _read(text, match)
    if angle := _SEXAGESIMAL.fullmatch(plain):
        return _in_degrees(text, angle)
    if _ERROR.fullmatch(plain):
        return no_number(text, "error")
    return no_number(text, "date" if _DATE.fullmatch(plain) else "text")


def _in_degrees(text: str, angle: re.Match[str]) -> PrintedNumber:
    sign, degrees, minutes, seconds, part = angle.groups()
    place = -_MINUTE if seconds is None else -_SECOND - len(part or "")
    value = int(degrees) + int(minutes) / 60 + float(f"{seconds or 0}.{part or 0}") / 3600
    return PrintedNumber(text, -value if sign == "-" else value, place, len(str(int(value))) - place, "")


def filled_in(text: str, mark: str) -> PrintedNumber:
    """Return the number in a field of a form, where nothing may stand beside the number.

    >>> filled_in("85", ".").value, filled_in("85*", ".").flag
    (85.0, 'text')
    """
    bare = text.translate(_PLAIN).strip().removeprefix("=").strip('"').removeprefix("'").strip()
    return printed(text, mark) if plain_text(text) == bare else no_number(text, "text")


def _read(text: str, match: re.Match[str]) -> PrintedNumber:
    sign, digits, group, behind, bare, exponent = match.groups()
    whole = digits.replace(group, "") if group else digits or "0"
    part = bare or behind or ""
    power = int(exponent) if exponent else 0
    value = float(f"{sign}{whole}.{part or '0'}e{power}")
    figures = (whole + part).lstrip("0")
    if not math.isfinite(value) or (value == 0 and figures):
        return no_number(text, "error")
    return PrintedNumber(text, value, power - len(part), len(figures), "")


def stored(text: str) -> PrintedNumber:
    """Return a number that a spreadsheet stored; its place and digits count at most 15 digits, as the rest is noise."""
    match = _NUMBER["."].fullmatch(text.strip().removesuffix(".0"))  # some programs store an integer so
    if not match:
        return no_number(text, "error")
    read = _read(text, match)
    if read.flag or read.digits <= _STORED_DIGITS:
        return read
    short = _NUMBER["."].fullmatch(f"{read.value:.15g}")
    return read if short is None else _read(f"{read.value:.15g}", short)._replace(value=read.value)
