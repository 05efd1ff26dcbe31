"""Text on its way to a page, split into runs that are set like a book.

Enters: sentences of the tool.  Leaves: plain strings and runs.
Used by `report/` and `assigning/`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from coursework.page_text import HAN
from coursework.report.numbers import superscript
from coursework.report.symbols import GREEK, symbol

LONGEST_NAME = 200  # characters of a name or title

Run = dict[str, str]


_WORD = rf"[^\W{HAN}]"  # a letter, digit or _; words of other letters end where Chinese begins, without a space
_LETTER = rf"[^\W\d_{HAN}]"
_RUN = re.compile(
    rf"(?<!{_WORD})(?P<letter>{_LETTER}\u0307?)(?:_(?P<low>[^\W_{HAN}]{{1,4}})(?!{_WORD})|(?P<digits>[₀-₉]+))"
    rf"|\ue000(?P<own>.)\ue001"
    rf"|(?P<greek>(?<!{_LETTER})[α-ωϕ]\u0307?(?!{_LETTER}))"
    rf"|(?P<raised>(?<=[\d\w)])[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    rf"|(?P<typed>(?<!{_WORD})(?<!-)--[a-z]+(?:-[a-z]+)*(?: (?:h/)?\d[A-Za-z0-9./-]*(?<!\.))?)"
)
ITALIC = ("\ue000", "\ue001")  # around a letter of our own words; `clean` removes both from all other text
_RAISED = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]")
_NAMELIKE = re.compile(r"\d|(?<=.)[A-Z]")  # w3, VMx: no word of a sentence looks like that
_TIMES = re.compile(r"(?<=[\w)])\*(?=[\w(])")
_POWER = re.compile(rf"(?<!{_WORD})(?<!\.)(\d+(?:\.\d+)?)[eE]([+-]?\d+)(?!{_WORD})")
_NEGATIVE = re.compile(rf"(?<!{_WORD})(?<![.)])-(?=\d)")
_COMPONENT = re.compile(rf"(?<!{_WORD})(?<!\.)[A-Z]\d?\.[va]?[xy](?!{_WORD})")  # A.x, B2.vy
_PLAIN_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "01234567890123456789−")


def runs(text: str, names: Iterable[str] = ()) -> list[Run]:
    """Split a sentence into runs, to be set like a book.

    A run is {"t": text}, {"v": letter, "s": subscript}, {"p": raised} or {"c": what is typed}: "V_My", "φ₁", "ω", "10⁻⁷",
    "--step h/19", and those of `names` that are symbols beyond doubt ("phi1", "w3"); the rest stays text.
    """
    text = _spelt(text, names)
    found: list[Run] = []
    end = 0
    for match in _RUN.finditer(text):
        if match.start() > end:
            found.append({"t": text[end : match.start()]})
        if match["raised"]:
            found.append({"p": match["raised"].translate(_PLAIN_DIGITS)})
        elif match["typed"]:
            found.append({"c": match["typed"]})
        else:
            low = (match["low"] or match["digits"] or "").translate(_PLAIN_DIGITS)
            found.append({"v": match["letter"] or match["own"] or match["greek"], "s": low})
        end = match.end()
    if end < len(text):
        found.append({"t": text[end:]})
    return found


def printed(text: str) -> str:
    """Return a sentence of the tool as a printer sets it: 1.5e-07 as a power of ten, "2*r" with a dot, "A.x" as x_A."""
    text = _POWER.sub(lambda match: f"{match[1]}·10{superscript(str(int(match[2])))}", text)
    text = _NEGATIVE.sub("−", _TIMES.sub("·", text))
    return _COMPONENT.sub(lambda match: symbol(match[0]).text, text)


def derivative(name: str) -> list[Run]:
    """Return "dphi2/dphi1" or "d2phi2/dphi12" as runs: dφ₂/dφ₁, d²φ₂/dφ₁²."""
    above, _, below = name.partition("/")
    twice = above.startswith("d2")
    above, below = above[2 if twice else 1 :], below[1:-1] if twice else below[1:]
    raised = "²" if twice else ""
    return runs(f"d{raised}\u2009{symbol(above).text}/d\u2009{symbol(below).text}{raised}")


def numeral(text: str) -> str | list[Run]:
    """Return a formatted number for a cell: as it is, or as runs where it holds a power of ten."""
    return runs(text) if _RAISED.search(text) else text


def _spelt(text: str, names: Iterable[str]) -> str:
    sure = {name for name in names if len(name) > 1 and (name in GREEK or _NAMELIKE.search(name))}
    if not sure:
        return text
    pattern = "|".join(sorted(map(re.escape, sure), key=len, reverse=True))
    return re.sub(rf"(?<!{_WORD})(?<!\.)({pattern})(?!{_WORD}|\()", lambda match: symbol(match[1]).text, text)
