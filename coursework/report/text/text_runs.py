"""Sentences for a page, split into runs that are typeset as in a book.

Enters: sentences of the tool.  Leaves: plain strings and runs.
Used by `report/` and `assigning/`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import NamedTuple

from coursework.report.text.numbers import THIN, superscript
from coursework.report.text.symbols import GREEK, is_named_after, symbol
from coursework.words.line_ends import KEPT
from coursework.words.scripts import HAN_HERE, made_for

LONGEST_NAME = 200  # characters of a name or title
MOST_KEPT = 384  # sentences kept in a cache: the pages of a desk, or of a class, repeat nearly all of them

Run = dict[str, str]


_WORD = rf"[^\W{HAN_HERE}]"  # a letter, digit or _, but not Chinese, which follows other words without a space
_LETTER = rf"[^\W\d_{HAN_HERE}]"
_RUN = (
    rf"(?<!{_WORD})(?P<letter>{_LETTER}\u0307?)(?:_(?P<low>(?:[^\W_{HAN_HERE}]′*){{1,24}})(?!{_WORD})|(?P<digits>[₀-₉]+))"
    rf"|\ue000(?P<own>.)(?P<index>[^\ue001]*)\ue001"
    rf"|(?P<greek>(?<!{_LETTER})[α-ωϕ]\u0307?(?!{_LETTER}))"
    rf"|(?P<raised>(?<=[\d\w)])[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    rf"|(?P<typed>(?<!{_WORD})(?<!-)--[a-z]+(?:-[a-z]+)*(?: (?:h/)?\d[A-Za-z0-9./-]*(?<!\.))?)"
    rf"|(?P<unit>(?<=\u00a0){_LETTER}+/{_LETTER}+[²]?(?!{_WORD}))"
    rf"|\ue003(?P<kept>[^\ue004]*)\ue004"
)
# Marks around a letter of our own words, or a letter and its index; `clean` removes both from other text, as well as `KEPT`.
ITALIC = ("\ue000", "\ue001")
_RAISED = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]")
_NAMELIKE = re.compile(r"\d|(?<=.)[A-Z]")  # w3, VMx: no word of a sentence looks like that
_TIMES = re.compile(r"(?<=[\w)])\*(?=[\w(])")
_CHAIN = rf"(?<!{_WORD})(?<![–-])[A-Z]\d?(?:-[A-Z]\d?)+(?!{_WORD})(?![–-])"  # M-B-C
_EXPONENT = re.compile(r"(?<=[\w)])\^(\d+)(?!\w)")  # m/s^2, l^2
_ROOT = rf"(?<!{_WORD})sqrt\("
_OF_ONE_NAME = re.compile(r"\b(sin|cos|tan)\((\w+)\)")  # cos(phi2): cos φ₂
_MINUS = rf"(?<=[\d)⁻⁰¹²³⁴⁵⁶⁷⁸⁹]) - (?=[\w(])|(?<=\w) - (?=\w+·|[\d(])|(?<=(?<!{_WORD})\w) - (?=\w(?!{_WORD})|\w+\))"
_POWER = rf"(?<!{_WORD})(?<!\.)(\d+(?:\.\d+)?)[eE]([+-]?\d+)(?!{_WORD})"
_NEGATIVE = rf"(?<!{_WORD})(?<![.)])-(?=\d)|(?<=\()-(?=\w)"
_ARTICLES = "aAI"  # single letters that are also words of a sentence
_OF_A_FORMULA = r"(?:(?<!\(.)(?=\))|(?= ?[=+·/²³]| − | (?:sin|cos|tan)\b))"  # never follows an article; "(a)" is a number
_WORDS = re.compile(
    "a[mnst]|b[ey]|do|go|he|i[fnst]|m[ey]|no|o[fnr]|so|to|up|we|[cm]m|ms|kg"
)  # words and units, not a letter and its index
_ALSO_UNITS = "ms"
_RAISED_DIGITS = "²³⁴"
_COMPONENT = rf"(?<!{_WORD})(?<!\.)[A-Z]\d?\.[va]?[xy](?!{_WORD})"  # A.x, B2.vy
_POINT = re.compile(r"[A-Z](?:\d+|[ij])?")  # A, P1, Ki
_POINTS = rf"(?<!{_WORD})(?<![.–\ue003])(?:{_POINT.pattern})+(?!{_WORD})"
_PLAIN_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "01234567890123456789−")


class Names(NamedTuple):
    """The names of a variant: its `points`, the `columns` of its table, and data and laws as `others`."""

    points: tuple[str, ...]
    columns: tuple[str, ...]
    others: tuple[str, ...]


@lru_cache(maxsize=MOST_KEPT)
def with_names(text: str, names: Names, data: bool) -> tuple[Run, ...]:
    """Return a sentence as runs with names as symbols; single letters only if `data`.  The runs are cached: copy them."""
    points, every = {*names.points}, (*names.columns, *names.others)
    text = with_points(text, points)
    text = with_pairs(with_letters(text, {"t", "h", *every} - points), names.columns) if data else text
    return tuple(runs(text, (*every, "pi")))


def runs(text: str, names: Iterable[str] = ()) -> list[Run]:
    """Split a sentence into runs, to be typeset as in a book.

    A run is {"t": text}, {"v": letter, "s": subscript}, {"p": raised text}, {"c": text without line break} or
    {"o": text on paper only}, which is made elsewhere.  "V_My", "φ₁", "ω" become letters with subscripts, and so do those of
    `names` that are certainly symbols ("phi1", "w3", "phij"); the exponent of "10⁻⁷" is raised; "--step h/18", the unit after
    a number and `unbroken` text get no line break; the rest is text.
    """
    return [dict(run) for run in _split(text, tuple(names))]


@lru_cache(maxsize=MOST_KEPT)
def _split(text: str, names: tuple[str, ...]) -> tuple[Run, ...]:
    text = spelt(text, names)
    found: list[Run] = []
    end = 0
    for match in made_for(text, _RUN).finditer(text):
        if match.start() > end:
            found.append({"t": text[end : match.start()]})
        if match["raised"]:
            found.append({"p": match["raised"].translate(_PLAIN_DIGITS)})
        elif kept := match["typed"] or match["unit"] or match["kept"]:
            found.append({"c": kept})
        else:
            low = (match["low"] or match["digits"] or match["index"] or "").translate(_PLAIN_DIGITS)
            found.append({"v": match["letter"] or match["own"] or match["greek"], "s": low})
        end = match.end()
    if end < len(text):
        found.append({"t": text[end:]})
    return tuple(found)


def printed(text: str) -> str:
    """Return a sentence as it is printed: 1.5e-07 as a power of ten, "2*r^2 - 1" with dot, exponent and minus sign.

    "A.x" becomes x_A; a chain of points "M-B-C" gets dashes and no line break.
    """
    text = _sub(_POWER, lambda match: f"{'' if match[1] == '1' else f'{match[1]}·'}10{superscript(str(int(match[2])))}", text)
    text = _EXPONENT.sub(lambda match: superscript(match[1]), _sub(_ROOT, "√(", text, "sqrt("))
    text = _OF_ONE_NAME.sub(f"\\1{THIN}\\2", text)
    text = _sub(_NEGATIVE, "−", _sub(_MINUS, " − ", _TIMES.sub("·", text), " - "), "-")
    text = _sub(_CHAIN, lambda match: unbroken(match[0].replace("-", "–")), text, "-")
    return _sub(_COMPONENT, lambda match: symbol(match[0]).text, text, ".")


def _sub(pattern: str, replaced: str | Callable[[re.Match[str]], str], text: str, piece: str = "") -> str:
    """Return a text with what matches a pattern replaced; `piece` is in each match: without it nothing is made nor sought."""
    return made_for(text, pattern).sub(replaced, text) if piece in text else text


def begun(text: str) -> str:
    """Return a text with a capital first letter, as a sentence begins.

    >>> begun("explicit Euler")
    'Explicit Euler'
    """
    return text[:1].upper() + text[1:]


def unbroken(text: str) -> str:
    """Return text of our own, marked so that no line breaks within it when its sentence is split into runs."""
    return f"{KEPT[0]}{text}{KEPT[1]}"


def derivative(name: str) -> list[Run]:
    """Return "dphi2/dphi1" or "d2phi2/dphi12" as runs: dφ₂/dφ₁, d²φ₂/dφ₁²."""
    above, _, below = name.partition("/")
    twice = above.startswith("d2")
    above, below = above[2 if twice else 1 :], below[1:-1] if twice else below[1:]
    raised = "²" if twice else ""
    return runs(f"d{raised}\u2009{symbol(above).text}/d\u2009{symbol(below).text}{raised}")


def with_pairs(text: str, names: Iterable[str]) -> str:
    """Return a sentence in which `names` of a letter and its index are symbols: "37 % off in si" gets s_i; words stay words."""
    pairs = {name for name in names if len(name) == 2 and name.isascii() and name.isalpha() and not _WORDS.fullmatch(name)}
    pairs = {name for name in pairs if symbol(name).subscript}
    if not pairs:
        return text
    return _sub(rf"(?<!{_WORD})(?<![.–-])({'|'.join(sorted(pairs))})(?!{_WORD}|[(–-])", lambda it: symbol(it[1]).text, text)


def with_points(text: str, names: Iterable[str]) -> str:
    """Return a sentence in which point names with an index are marked as letters: "D5" as D₅, "XP1" as X and P₁."""
    points = set(names)

    def lettered(row: re.Match[str]) -> str:
        found = _POINT.findall(row[0])
        return (
            "".join(f"{ITALIC[0]}{name}{ITALIC[1]}" if name[1:] else name for name in found)
            if points.issuperset(found)
            else row[0]
        )

    return _sub(_POINTS, lettered, text)


def with_letters(text: str, names: Iterable[str]) -> str:
    """Return a sentence in which one-letter Latin `names` are marked as symbols: s in "21 % off in s", but not in "0.4 s"."""
    letters = {name for name in names if len(name) == 1 and name.isascii() and name.isalpha()}
    if articles := "".join(sorted(letters & set(_ARTICLES))):
        text = _sub(rf"(?<!{_WORD})([{articles}]){_OF_A_FORMULA}", rf"{ITALIC[0]}\1{ITALIC[1]}", text)
    letters -= set(_ARTICLES)
    if not letters:
        return text
    units, others = ("".join(sorted(letters & set(_ALSO_UNITS))), "".join(sorted(letters - set(_ALSO_UNITS))))
    either = [f"[{others}]"] if others else []
    either += [rf"(?<!\d[ \u00a0])[{units}]"] if units else []
    before, behind = (
        rf"(?<!{_WORD})(?<![.'’–\ue000-])(?<!/(?![A-Z]))(?<!--step )",
        rf"(?![^\W{_RAISED_DIGITS}])(?![\u2009\u202f]|[('’–-]\S)",
    )
    behind += r"(?!(?<=[A-Z])\. ?[A-Z])"  # V. R. Pasika
    return _sub(f"{before}({'|'.join(either)}){behind}", _lettered, text)


def _lettered(found: re.Match[str]) -> str:
    """Return a single letter marked as a symbol; w becomes ω, which needs no mark."""
    text = symbol(found[1]).text
    return f"{ITALIC[0]}{text}{ITALIC[1]}" if text.isascii() else text


def numeral(text: str) -> str | list[Run]:
    """Return a formatted number for a cell: unchanged, or as runs if it contains a power of ten."""
    return runs(text) if _RAISED.search(text) else text


def spelt(text: str, names: Iterable[str]) -> str:
    """Return a sentence in which those of `names` that are certainly symbols are replaced: "w3" by ω₃."""
    pattern = _of_symbols(tuple(names))
    return _sub(pattern, lambda match: symbol(match[1]).text, text) if pattern else text


@lru_cache(maxsize=MOST_KEPT)
def _of_symbols(names: tuple[str, ...]) -> str:
    """Return the pattern of those of `names` that are certainly symbols; "" if there are none."""
    sure = {name for name in names if len(name) > 1 and (name in GREEK or _NAMELIKE.search(name) or is_named_after(name))}
    either = "|".join(sorted(map(re.escape, sure), key=len, reverse=True))
    behind = rf"(?![^\W{HAN_HERE}{_RAISED_DIGITS}]|\()"  # a raised digit is not part of a name: l2²
    return rf"(?<!{_WORD})(?<!\.)({either}){behind}" if sure else ""
