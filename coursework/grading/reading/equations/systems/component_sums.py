r"""Vectors by components, added by name or as they stand, v_A + v_BA = v_B, (a) i + (b) j = (c, d) -> an equation for each axis.

Enters: lines, what a name means.  Leaves: the lines, two equations in place of each that relates such vectors, without those
that only say what the names are; v_A is v_Ax and v_Ay where no line says it.  Nothing is computed.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from coursework.grading.reading.equations.notation.signs import closing, depths, plain_signs
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
_VELOCITY = re.compile(r"([vV])_?([A-Z]\w?)")
_BEFORE = re.compile(r"^(?:[^-+*/=()\[\]\d_]*[,:\s](?=[vV]_?[A-Z])|[^-+*/=()\[\],;]{1,40}:\s+)")  # words, or the label of a line
_PLUS = re.compile(r"(?<=[\w)\]}])\s*[-+](?=\s*[\w(\[\\])")
_BRACKET = re.compile(r"(?<![\w)\]])[(\[]|(?<=[\w)])\s+[(\[]|(?<=\d)[(\[]")
_BY_POINTS = re.compile(r"[-+\s]*(?:[vV]_?[A-Z]{1,2}|[^\W\d]\w{0,2}(?:\s*k)?\s*[*x]\s*[A-Z]{2})(?:\s*[-+]|$)")  # v_A + ω × AB
_FACTOR = re.compile(r"[^\W\d]\w*")
_OWN = re.compile(r"[a-zα-ω]\w{0,2}")  # a factor that the student names; K is a matrix
_DECIMAL = re.compile(r"\d,\d")
_MOST_LINES, _PASSES, _DEEP = 400, 3, 5

Cells = tuple[str, str]


def by_axes(lines: Sequence[str], meaning: Callable[[str], str | None], is_name: Callable[[str], bool]) -> list[str]:
    r"""Return lines with an equation for each axis in place of those of vectors.

    >>> by_axes(["u = (a, b)", "v = (c, 0)", "u - 2*v = 0"], {}.get, bool)
    ['', '', '(a) - 2*(c) = 0; (b) - 2*(0) = 0']
    >>> by_axes(["v_E = v_A + w2 (-p sin f, p cos f)", "v = r (a, b)", "w3 = atan2(a, b)"], {}.get, bool)
    ['v_Ex = v_Ax + w2*(-p sin f); v_Ey = v_Ay + w2*(p cos f)', 'v = r (a, b)', 'w3 = atan2(a, b)']
    >>> by_axes(["(a) i + b*j = (c, d)", "w = (a, b)"], {}.get, bool), by_axes(["v_B - v_A = [a; b]"], {}.get, bool)
    (['(a) = (c); b = (d)', 'w = (a, b)'], ['v_Bx - v_Ax = (a); v_By - v_Ay = (b)'])
    """
    found = [*lines]
    vectors = {place for place, line in enumerate(lines[:_MOST_LINES]) if may_be_of_vectors(line)}
    if not vectors:
        return found
    said = _Vectors(meaning, is_name)
    sides = {
        place: _BEFORE.sub("", plain.strip(" \t$.,;"), count=1).split("=")
        for place, line in enumerate(lines[:_MOST_LINES])
        if 1 <= line.count("=") <= _PASSES and len(line) <= EQUATION_CHARACTERS and (plain := _plain(line))
    }
    text = "\n".join(lines)
    # Of complex numbers, exp(i*phi), i is no axis, nor where the text says what it is.
    said.has_units = not _OTHERWISE.search(text) and any({"i", "j"} <= {*_UNITS.findall("=".join(one))} for one in sides.values())
    for _ in range(_PASSES):
        for place, both in sides.items():
            said.look_at(place, both)
    said.as_axes = True
    for place in sorted(vectors & sides.keys()):
        said.look_at(place, sides[place])
    used = said.used() - said.equations.keys()
    for name, place in said.lines.items():
        of_axes = (velocity := _VELOCITY.fullmatch(name)) and re.search(rf"\b{velocity[1]}_?\{{?{velocity[2]}_?[xy]\b", text)
        if velocity and (of_axes or place not in used):
            said.equations[place] = _equated([_axes(velocity), said.cells[name]])
    for place in used:
        found[place] = ""
    for place, equations in said.equations.items():
        found[place] = "; ".join(equations)
    return found


def may_be_of_vectors(line: str) -> bool:
    """Return whether a line may have a vector: two cells in brackets, or a unit."""
    if "=" not in line or len(line) > EQUATION_CHARACTERS:
        return False
    return (any(sign in line for sign in ",;") and any(sign in line for sign in "([")) or _UNITS.search(line) is not None


def _plain(line: str) -> str:
    line = re.sub(r"\\[,;:!](?=[\s\w\\-])|\\(?:left|right)(?![a-z])", " ", line)
    return plain_signs(_INDEX.sub(r"_\1", _VECTOR_SIGN.sub(lambda found: found[1] or "", line))).replace("&", "")


@dataclass
class _Vectors:
    """The vectors that a text names, where it does, and the equations of lines that relate vectors."""

    meaning: Callable[[str], str | None]
    is_name: Callable[[str], bool]
    has_units: bool = False
    as_axes: bool = False
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
        if sum(map(bool, read)) and len(sides) > 2:
            # What is said of points alone, the components beside it say.
            kept = [at for at, side in enumerate(sides) if at == 0 or not self._is_of_points(side)]
            sides, read = [sides[at] for at in kept], [read[at] for at in kept]
        known = [one for one in read if one is not None]
        first = sides[0].strip()
        if read[0] is None and len(known) == len(read) - 1 > 0 and _NAMED.fullmatch(first) and first.isidentifier():
            components = [self.meaning(f"{first}{axis}") or self.meaning(f"{first}_{axis}") for axis in "xy"]
            self.cells[first], self.needs[place] = known[0], needed
            if any(components):
                said = [
                    f"{name} = {one[axis] or '0'}"
                    for one in known
                    for axis, name in enumerate(components)
                    if name and self.meaning(one[axis].strip("+( )")) != name  # v_K = (vKx, vKy) = …
                ]
                self.equations[place] = said + _equated(known, [axis for axis, name in enumerate(components) if not name])
            elif len(known) > 1:
                self.equations[place] = _equated(known)
            else:
                self.lines[first] = place
        elif len(known) == len(read) and any(map(any, known)):
            self.equations[place], self.needs[place] = _equated(known), needed

    def _is_of_points(self, side: str) -> bool:
        """Return whether a side adds vectors of points that no line gives by components, v_A + ω × AB."""
        return not _BY_POINTS.sub("", side.strip()) and not {*_FACTOR.findall(side)} <= self.cells.keys()

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
        if self.as_axes and (velocity := _VELOCITY.fullmatch(body)):
            x, y = _axes(velocity)
            return f"{sign} {x}", f"{sign} {y}"
        return self._as_it_stands(sign, body, needed)

    def _as_it_stands(self, sign: str, body: str, needed: set[str]) -> Cells | None:
        """Return two cells in brackets, or a sum of i and j in them, with the factors before and behind."""
        for opened in _BRACKET.finditer(body):
            begin = opened.end() - 1
            end = closing(body, begin)
            content, before, behind = body[begin + 1 : end], body[:begin].strip(" *·⋅"), body[end + 1 :].strip(" *·⋅.'ᵀ")
            if not self._is_factor(before) or not self._is_factor(behind):
                continue
            if cut := _cut(content):
                cells = content[:cut].strip(), content[cut + 1 :].strip()
            elif self.has_units and _UNITS.search(content) and max(depths(content)) < _DEEP:
                x, y = self._side(content, needed) or ("", "")
                cells = x or "0", y or "0"
            else:
                continue
            if all(cells) and any(re.search(r"[^\W\d]", one) for one in cells):
                return _times(sign, "*".join(filter(None, (before, behind))), cells)
        return None

    def _is_factor(self, factor: str) -> bool:
        """Return whether a factor is a number: it has names of numbers alone, so that it is no matrix."""
        is_one = -1 not in depths(factor) and not re.search(r"[\[,;⇒→]|^/", factor)
        return is_one and all(self.is_name(one) or _OWN.fullmatch(one) for one in _FACTOR.findall(factor))


def _axes(velocity: re.Match[str]) -> Cells:
    letter, point = velocity.groups()
    return f"{letter}_{point}x", f"{letter}_{point}y"


def _times(sign: str, factor: str, cells: Cells) -> Cells:
    product = f"{sign} {factor}{'*' if factor else ''}"
    x, y = (f"{product}{cell if closing(cell, 0) == len(cell) - 1 > 0 else f'({cell})'}" for cell in cells)
    return x, y


def _cut(content: str) -> int:
    """Return where the only comma or semicolon between two cells stands, 0 if there is none or another."""
    inside = depths(content)
    found = [
        at for at, sign in enumerate(content) if sign in ",;" and not inside[at] and not _DECIMAL.match(content, max(at - 1, 0))
    ]
    return found[0] if len(found) == 1 else 0


def _equated(sides: list[Cells], axes: Sequence[int] = (0, 1)) -> list[str]:
    return [
        f"{one[axis] or '0'} = {other[axis] or '0'}"
        for one, other in pairwise(sides)
        for axis in axes
        if one[axis] or other[axis]
    ]
