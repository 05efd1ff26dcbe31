"""The places where a line of a page on the screen may not break: in a number with its unit, a short equation, quotient or label.

Enters: sentences, as runs or with gaps.  Leaves: their runs in groups; the runs of a kept group stay on one line.
Used by `words/page_runs.py` and `report/live/page.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from itertools import pairwise
from typing import NamedTuple

from coursework.words.scripts import without_chinese

LONGEST = 30  # most characters kept on one line; a telephone shows 40
KEPT = ("\ue003", "\ue004")  # marks around text to keep on one line; they are removed from foreign text
_APART = "\u200b"  # replaces each Chinese sign during the search, as patterns without their ranges compile faster
_SIGN = rf"[^\s{_APART}]"  # a character between two spaces
_OF_QUOTIENT = r"[\w.,;·()|²³√−-]"
_BEGIN = rf"(?<!{_SIGN})"
_THIN, _NARROW = "\u2009", "\u202f"
_GAP = " \u00a0\x1f"  # the last stands for both of these during the search: where they are named, compiling takes twice as long
_DIGITS = "0123456789"
_NUMBER = r"(?:[−-]?\d[\d.,]*(?:·10[−-]?\d+)?|\{\w+\})"  # or a gap of a sentence, filled by a script
_NAMED = r"[NН]|rad|deg|rpm|min|mm|cm|ms|µs|m|s|рад|град|мин|хв|мм|см|мкс|мс|м|с"
_UNIT = rf"(?:(?:{_NAMED})(?:/(?:{_NAMED})[²2]?)?|1/(?:s|с)|%)"
_ROW = r"(?:[Rr]ows?|[Ll]ink|[Ss]leeve|[Ww]heel|[Сс]трок\w?|[Рр]яд\w{0,3}|[Зз]вен\w{0,2}|[Лл]анк\w{0,3}|[Кк]олес\w{0,2})"
_RELATIONS, _JOINING, _FUNCTIONS = "=≈<>≤≥", "+−·×", ("sin", "cos", "tan", "tg")
_RELATION, _JOINED, _FUNCTION = f"[{_RELATIONS}]", f"[{_JOINING}]", f"(?:{'|'.join(_FUNCTIONS)})"
_TERM = rf"(?:{_SIGN}{{0,8}}\([^()]{{1,20}}\)(?!{_SIGN})|{_SIGN}{{1,18}})"
_PRODUCT = rf"(?:{_FUNCTION}[{_GAP}])?{_TERM}(?:[{_GAP}](?={_FUNCTION})(?:{_FUNCTION}[{_GAP}])?{_TERM})*"
# Products with signs between them, told with a term less for each, as it would take half as long again to compile.
_SUM = rf"(?:{_FUNCTION}[{_GAP}])?{_TERM}(?:[{_GAP}](?:{_JOINED}[{_GAP}]|(?={_FUNCTION}))(?:{_FUNCTION}[{_GAP}])?{_TERM})*"
_WHOLE = rf"(?![{_GAP}]{_RELATION}[{_GAP}])"  # not a part of a chain a = b = c, which would then break at some of its signs
# Before each pattern, of what a text must hold a piece for it to be looked through: half of the searches are saved.
_TOGETHER = (
    (
        _RELATIONS,
        rf"(?<!{_RELATION}[{_GAP}]){_BEGIN}{_SUM}(?:[{_GAP}]{_RELATION}[{_GAP}]{_SUM}(?!{_SIGN}))+(?:[{_GAP}]{_UNIT}(?!\w))?{_WHOLE}",
    ),
    # In a longer equation, its sign and the term before it.
    (_RELATIONS, rf"{_BEGIN}{_SIGN}{{1,24}}[{_GAP}]{_RELATION}(?!{_SIGN})"),
    (_JOINING, rf"{_BEGIN}{_PRODUCT}(?:[{_GAP}]{_JOINED}[{_GAP}]{_PRODUCT})+(?!{_SIGN})(?:[{_GAP}]{_UNIT}(?!\w))?"),
    (_JOINING, rf"{_BEGIN}{_JOINED}[{_GAP}]{_PRODUCT}(?!{_SIGN})"),  # in a longer sum, its sign and the term after it
    ("-", r"(?<![\w-])\w{2,12}(?:-\w{1,12}){1,2}(?![\w-])(?:[ \u00a0]\d(?:\(\d\))?(?!\w|\.\d))?"),  # Runge-Kutta 4
    ("-", rf"{_APART}-{_APART}"),  # the same in Chinese, where a line may break at any other place of the name
    (f"{_DIGITS}{{", rf"{_NUMBER}[{_GAP}]{_UNIT}(?!\w)[.,;:)]*"),
    ("/", rf"{_BEGIN}{_OF_QUOTIENT}+(?:/{_OF_QUOTIENT}+)+(?!{_SIGN})"),  # (m/s)/mm too
    (f"{_DIGITS}{{", rf"(?<!\w)(?:\w{{1,14}}:[{_GAP}](?!\{{scheme)|{_ROW}[{_GAP}]){_NUMBER}"),
    (_FUNCTIONS, rf"{_FUNCTION}[{_GAP}]{_SIGN}{{1,12}}(?!{_SIGN})"),
    (_DIGITS, rf"{_BEGIN}[−-]?\d+[{_GAP}][α-ωϕ]{_SIGN}{{0,6}}(?!{_SIGN})"),
)
_JOINTS = re.compile(rf"[{_GAP}/-]")  # every piece to keep contains one; table cells rarely do
_WORTH_A_LOOK = re.compile(rf"[{_RELATIONS}{_JOINING}/%{{]|\d|\w-\w|{_FUNCTION}")


class Group(NamedTuple):
    """Consecutive runs, on one line if `kept`."""

    kept: bool
    runs: list[dict[str, str]]


def line_groups(runs: Sequence[dict[str, str]]) -> list[Group]:
    """Return the runs of a sentence in groups; a run of text is split where a group begins or ends in it.

    >>> [(kept, [run["t"] for run in runs]) for kept, runs in line_groups([{"t": "an error of 21 % in all"}])]
    [(False, ['an error of ']), (True, ['21 %']), (False, [' in all'])]
    """
    places = _together("".join(map(_text, runs)))
    if not places:
        return [Group(kept=False, runs=list(runs))]
    groups: list[Group] = []
    at = 0
    for run in runs:
        size = len(_text(run))
        for begin, end, kept in _cut(at, at + size, places) if "t" in run else [(at, at + size, _inside(at, places))]:
            piece = {**run, "t": run["t"][begin - at : end - at]} if "t" in run else run
            if groups and groups[-1].kept == kept and begin not in {place[0] for place in places}:
                groups[-1].runs.append(piece)
            else:
                groups.append(Group(kept, [piece]))
        at += size
    return groups


def marked(sentence: str) -> str:
    r"""Return a sentence whose gaps a script fills, with the `KEPT` marks around the parts to keep on one line.

    >>> marked("dashed: {scheme}, h = {h} s")
    'dashed: {scheme}, \ue003h = {h} s\ue004'
    """
    for begin, end in reversed(_together(sentence)):
        sentence = f"{sentence[:begin]}{KEPT[0]}{sentence[begin:end]}{KEPT[1]}{sentence[end:]}"
    return sentence


def _text(run: dict[str, str]) -> str:
    return "".join(run.get(key, "") for key in "tvspc")


def _inside(place: int, places: tuple[tuple[int, int], ...]) -> bool:
    return any(begin <= place < end for begin, end in places)


@lru_cache(maxsize=2048)  # the desk renders the same sentences repeatedly
def _together(text: str) -> tuple[tuple[int, int], ...]:
    """Return the spans (start, end) that no line may break, in order; they do not overlap or exceed `LONGEST` characters."""
    text = text.replace(_THIN, _GAP[-1]).replace(_NARROW, _GAP[-1])
    if not _JOINTS.search(text) or not _WORTH_A_LOOK.search(text):
        return ()
    text = without_chinese(text, _APART)
    kept: list[tuple[int, int]] = []
    held = {*text, *(name for name in _FUNCTIONS if name in text)}
    asked = (_made(pattern) for pieces, pattern in _TOGETHER if not held.isdisjoint(pieces))
    for begin, end in sorted(match.span() for pattern in asked for match in pattern.finditer(text)):
        first, last = kept[-1] if kept else (0, 0)
        if kept and begin < last:
            if max(end, last) - first <= LONGEST:
                kept[-1] = (first, max(end, last))
        elif end - begin <= LONGEST:
            kept.append((begin, end))
    return tuple(kept)


@cache
def _made(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern)


def _cut(begin: int, end: int, places: tuple[tuple[int, int], ...]) -> Iterator[tuple[int, int, bool]]:
    """Yield (start, end, whether kept) of the pieces of a run of text."""
    ends = sorted({begin, end, *(place for pair in places for place in pair if begin < place < end)})
    for first, last in pairwise(ends):
        yield first, last, _inside(first, places)
