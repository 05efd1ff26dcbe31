r"""Vectors by components, added by name or as they stand, v_A + v_BA = v_B, (a) i + (b) j = (c, d) -> an equation for each axis.

Enters: a text, what a name means.  Leaves: the text with two equations in place of each that relates such vectors, without the
lines that only say what their names are; unchanged if there is none.  Nothing is computed.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise

from coursework.grading.reading.equations.notation.signs import closing, depths, plain_signs
from coursework.grading.reading.equations.systems.parts import at_signs
from coursework.grading.reading.limits import EQUATION_CHARACTERS

# Arrows, hats and bold letters of vectors
_VECTOR_SIGN = re.compile(
    r"\\(?:vec|overrightarrow|overline|bar|hat|mathbf|boldsymbol|bm)\s*\{?\s*\\?([^\W\d]\w{0,9})\s*\}?|[\u20d7\u0302\u0305]"
)
_INDEX = re.compile(r"_\s*\{\s*(\w{1,9})\s*\}")
_UNIT = re.compile(
    r"(?P<before>.*?)(?:(?<=[\w)\]}])\s*[*·⋅]?\s*|^)(?<!\w)(?P<axis>[ij])|(?P<axis_>[ij])\s*[*·⋅]?\s*(?P<behind>[(\w\\].*)"
)
_UNITS = re.compile(r"(?<![\w^])[ij](?!\w)")
_OTHERWISE = re.compile(r"(?<![^\W\d_])e\}?\s*\^|\bexp\b|^\s*[ij]\s*:?=", re.MULTILINE)
_NAMED = re.compile(r"(?:(.+?)\s*[*·⋅]\s*)?([^\W\d]\w{0,20})")
_PLUS = re.compile(r"(?<=[\w)\]}])\s*[-+](?=\s*[\w(\[\\])")
_CELL = re.compile("[,;]")
_OPEN, _MOST_LINES, _PASSES = {")": "(", "]": "["}, 400, 3

Cells = tuple[str, str]


def by_axes(text: str, meaning: Callable[[str], str | None], is_name: Callable[[str], bool]) -> str:
    r"""Return a text with an equation for each axis in place of those of vectors.

    >>> by_axes("u = (a, b)\nv = (c, 0)\nu - 2*v = 0", {}.get, bool).split("\n")
    ['', '', '(a) - 2*(c) = 0; (b) - 2*(0) = 0']
    >>> by_axes("(a) i + b*j = (c, d)", {}.get, bool), by_axes("w = (a, b)", {}.get, bool)
    ('(a) = (c); b = (d)', 'w = (a, b)')
    """
    lines = text.split("\n")
    if not any(map(_may_be, lines[:_MOST_LINES])):
        return text
    said = _Vectors(meaning, is_name)
    sides = {
        place: plain.strip(" \t$.,;").split("=")
        for place, line in enumerate(lines[:_MOST_LINES])
        if 1 <= line.count("=") <= _PASSES and len(line) <= EQUATION_CHARACTERS and (plain := _plain(line))
    }
    # Of complex numbers, exp(i*phi), i is no axis, nor where the text says what it is.
    said.has_units = not _OTHERWISE.search(text) and any({"i", "j"} <= {*_UNITS.findall("=".join(one))} for one in sides.values())
    for _ in range(_PASSES):
        for place, both in sides.items():
            said.look_at(place, both)
    for place, equations in said.equations.items():
        lines[place] = "; ".join(equations)
    for place in said.used() - said.equations.keys():
        lines[place] = ""
    return "\n".join(lines) if said.equations else text


def _may_be(line: str) -> bool:
    """Return whether a line may have a vector: two cells in brackets, or a unit."""
    if "=" not in line or len(line) > EQUATION_CHARACTERS:
        return False
    return (any(sign in line for sign in ",;") and any(sign in line for sign in "([")) or _UNITS.search(line) is not None


def _plain(line: str) -> str:
    line = line.replace(r"\left", "").replace(r"\right", "")
    return plain_signs(_INDEX.sub(r"_\1", _VECTOR_SIGN.sub(lambda found: found[1] or "", line))).replace("&", "")


@dataclass
class _Vectors:
    """The vectors that a text names, where it does, and the equations of lines that relate vectors."""

    meaning: Callable[[str], str | None]
    is_name: Callable[[str], bool]
    has_units: bool = False
    cells: dict[str, Cells] = field(default_factory=dict)
    lines: dict[str, int] = field(default_factory=dict)
    needs: dict[int, set[str]] = field(default_factory=dict)
    equations: dict[int, list[str]] = field(default_factory=dict)

    def look_at(self, place: int, sides: list[str]) -> None:
        """Take what one line says: the vector of a name, or an equation of vectors."""
        if place in self.equations or place in self.lines.values():
            return
        needed = set[str]()
        read = [self._side(side.strip(), needed) for side in sides]
        known = [one for one in read if one is not None]
        first = sides[0].strip()
        if read[0] is None and len(known) == len(read) - 1 > 0 and _NAMED.fullmatch(first) and first.isidentifier():
            components = [self.meaning(f"{first}{axis}") or self.meaning(f"{first}_{axis}") for axis in "xy"]
            self.cells[first], self.needs[place] = known[0], needed
            if any(components):
                self.equations[place] = [f"{name} = {cell}" for name, cell in zip(components, known[0], strict=True) if name]
            elif len(known) > 1:
                self.equations[place] = _equated(known)
            else:
                self.lines[first] = place
        elif len(known) == len(read) and any(map(any, known)):
            self.equations[place], self.needs[place] = _equated(known), needed

    def used(self) -> set[int]:
        """Return the places of the lines that name the vectors which stand in the equations."""
        found, open_ = set[int](), [*self.equations]
        while open_:
            places = {self.lines[name] for name in self.needs.get(open_.pop(), ()) if name in self.lines} - found
            found |= places
            open_ += places
        return found

    def _side(self, side: str, needed: set[str]) -> Cells | None:
        inside = depths(side)
        cuts = [found.end() - 1 for found in _PLUS.finditer(side) if inside[found.end() - 1] == 0]
        terms = [side[begin:end].strip() for begin, end in zip([0, *cuts], [*cuts, len(side)], strict=True)]
        read = [self._term(term, needed) for term in terms if term]
        if not read or None in read:
            return None
        x, y = (" ".join(one[axis] for one in read if one and one[axis]).removeprefix("+ ") for axis in (0, 1))
        return x, y

    def _term(self, term: str, needed: set[str]) -> Cells | None:
        sign, body = (term[0], term[1:].strip()) if term[0] in "+-" else ("+", term)
        if body == "0":
            return "", ""
        if body in self.cells:
            needed.add(body)
            return _times(sign, "", self.cells[body])
        if self.has_units and (unit := _UNIT.fullmatch(body)) and (factor := unit["before"] or unit["behind"]):
            cell = f"{sign} {factor}"
            return (cell, "") if "i" in {unit["axis"], unit["axis_"]} else ("", cell)
        if (named := _NAMED.fullmatch(body)) and named[2] in self.cells and self._is_factor(named[1] or ""):
            needed.add(named[2])
            return _times(sign, named[1] or "", self.cells[named[2]])
        return self._as_it_stands(sign, body)

    def _as_it_stands(self, sign: str, body: str) -> Cells | None:
        inside = depths(body)
        begin = next((at for at in reversed(range(len(body) - 1)) if inside[at] <= 0), -1) + 1  # where its last brackets open
        if body[-1:] not in _OPEN or body[begin] != _OPEN[body[-1]] or inside[-1] != 0:
            return None
        cells = [cell.strip() for cell in at_signs(_CELL, body[begin + 1 : -1])]
        factor = body[:begin].rstrip()
        is_function = factor and factor[-1] not in "*·⋅"
        if len(cells) != 2 or not all(cells) or is_function or not any(re.search(r"[^\W\d]", one) for one in cells):
            return None
        factor = factor.rstrip("*·⋅ ")
        return _times(sign, factor, (cells[0], cells[1])) if self._is_factor(factor) else None

    def _is_factor(self, factor: str) -> bool:
        """Return whether a factor is a number: it has names of numbers alone, so that it is no matrix."""
        is_one = -1 not in depths(factor) and not re.search(r"[\[,;]", factor)
        return is_one and all(map(self.is_name, re.findall(r"[^\W\d]\w*", factor)))


def _times(sign: str, factor: str, cells: Cells) -> Cells:
    product = f"{sign} {factor}{'*' if factor else ''}"
    x, y = (f"{product}{cell if closing(cell, 0) == len(cell) - 1 > 0 else f'({cell})'}" for cell in cells)
    return x, y


def _equated(sides: list[Cells]) -> list[str]:
    return [
        f"{one[axis] or '0'} = {other[axis] or '0'}"
        for one, other in pairwise(sides)
        for axis in (0, 1)
        if one[axis] or other[axis]
    ]
