"""Remarks on probable slips in a file that can be computed; they change no status.

Enters: a `Variant`, the dimensions of its names, the places of grads.  Leaves: `Remark`s.  Used by `reader.py` only.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from coursework.variant.dimensions.exponents import LENGTH
from coursework.variant.formula.motion_units import UNITS, advised_unit
from coursework.variant.formula.tree import Formula, terms
from coursework.variant.formula.units import size_of
from coursework.variant.judging.dimension_check import Dimensions
from coursework.variant.judging.dimension_words import text_of
from coursework.variant.judging.unused import Found, parts_unused
from coursework.variant.record.no_value import known_value
from coursework.variant.record.places import Place, lengths_of
from coursework.variant.record.variant import Given, Remark, Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_TURN = 2 * math.pi
# The lengths of a mechanism have similar size: in 66 files the largest gap between neighbours was a factor of four.
_FAR = 30.0
_LENGTHS = ("mm", "cm", "m"), ("мм", "см", "м")
# 0.1047, 0.105, 3.14/30, 1/9.55: relative tolerance for a factor to count as the size of the unit.
_NEAR = 0.005
_MINUTE, _EARTH = 60.0, 9.81
_PLAIN = {"", "1"}  # SI units of data that may themselves be the factor


def remarks_on(
    variant: Variant, dimensions: Dimensions, source: Source, grads: Iterable[tuple[KeyPath, str]]
) -> tuple[Remark, ...]:
    """Return every remark on a file, in file order."""
    angles = tuple(_terms_of_angles(dimensions.places))
    phases = {term.name for _, term in angles if term.op == "name"}  # names that are a whole term of an angle
    slips = [*_angles(variant, dimensions, angles, phases), *_lengths(variant, dimensions)]
    told = {path for _, path, _ in slips}  # where a number looks wrong for want of a unit, that is said once
    found = [
        *slips, *(bare for bare in _bare(variant, dimensions, phases) if bare[1] not in told),
        *_left_out(variant, dimensions), *_weight(variant), *_of_forces(variant, dimensions), *frequencies_turned_twice(variant),
        *parts_unused(variant, dimensions),
        *(("GRAD", path, say("remark.grad", text=text, degrees=text.split("g")[0].strip())) for path, text in grads),
    ]  # fmt: skip
    lines = [(source.positions.find(source.path_of(path))[0], code, sentence) for code, path, sentence in found]
    return tuple(Remark(code, line, sentence) for line, code, sentence in sorted(lines))


def _angles(
    variant: Variant, dimensions: Dimensions, angles: Iterable[tuple[Place, Formula]], phases: Collection[str]
) -> Iterator[Found]:
    """Yield starts and phases of more than a turn, written in rad or without a unit: they may be degrees."""
    for coordinate in variant.coordinates:
        if (
            coordinate.start is not None
            and coordinate.unit == "rad"
            and (coordinate.start_has_no_unit or coordinate.written in {"rad", "рад"})
        ):
            yield from _turned(coordinate.name, coordinate.start, coordinate.text, ("coordinates", coordinate.name))
    for given in variant.given:
        if given.name in phases and given.unit in {"", "rad", "рад"} and not dimensions.known.get(given.name, {}):
            yield from _turned(given.name, given.value, given.text, ("given", given.name))
    for place, term in angles:
        size = float(term.name) if term.op == "number" and not term.si else 0.0
        if size > _TURN * (1 + 1e-12):
            yield "ANGLE", place.path, say("remark.angle_in", place=place.label, text=f"{size:.10g}", turns=size / _TURN)


def _turned(name: str, value: float, text: str, path: KeyPath) -> Iterator[Found]:
    if abs(value) > _TURN * (1 + 1e-12):
        yield "ANGLE", path, say("remark.angle", name=name, text=text, turns=abs(value) / _TURN)


def _weight(variant: Variant) -> Iterator[Found]:
    """Yield a gravity far from that of any planet: 9810 mm/s^2 written without its unit, say."""
    parts = (variant.forces.gravity if variant.forces else None) or ()
    size = math.hypot(*(known_value(part, variant.values) or 0.0 for part in parts))
    if size and not _EARTH / _FAR < size < _EARTH * _FAR:
        yield "GRAVITY", ("forces", "gravity"), say("remark.gravity", size=size, times=size / _EARTH)


def _of_forces(variant: Variant, dimensions: Dimensions) -> Iterator[Found]:
    """Yield the lengths of springs and pairs, written as numbers, that are far longer than the longest one of the data."""
    data = [given for given in variant.given if dimensions.known.get(given.name) == {LENGTH: 1}]
    longest = max(data, key=_size, default=None)
    if longest is None or variant.forces is None:
        return
    for path, formula, unit in variant.forces.measured():
        size = known_value(formula, {})
        if unit == "m" and size is not None and abs(size) >= _FAR * _size(longest) > 0:
            name = f"{path[1]}.{path[2]}"
            yield "LENGTH", path, say("remark.length_alone", name=name, text=f"{size:.6g} m", beside=_written(longest))


def _lengths(variant: Variant, dimensions: Dimensions) -> Iterator[Found]:
    """Yield lengths far from all others (the side of a gap with fewer of them), and negative lengths of links.

    If the file has a geometry, it shows which lengths are links; in equations alone, a factor of a rate looks like one.
    A length that only [drive] has is a travel, which may be short.
    """
    if not variant.points and not variant.groups:
        used = {name for _, formula in variant.formulas() for name in formula.names()}
        for given in variant.given:
            if given.name in used and given.value < 0 and dimensions.known.get(given.name) == {LENGTH: 1}:
                yield "LENGTH", ("given", given.name), say("remark.negative", name=given.name, text=_written(given))
    lengths = sorted((g for g in variant.given if g.value and dimensions.known.get(g.name) == {LENGTH: 1}), key=_size)
    travels = dimensions.only_in_drives
    longest = max((_size(given) for given in lengths if given.name not in travels), default=0.0)
    lengths = [given for given in lengths if given.name not in travels or _size(given) > longest]
    named: dict[str, tuple[Given, Sequence[Given]]] = {}
    for place in range(1, len(lengths)):
        below, above = lengths[:place], lengths[place:]
        if _size(above[0]) >= _FAR * _size(below[-1]) * (1 - 1e-12):
            few, many = (below, above) if len(below) < len(above) else (above, below[::-1])
            for given in few:
                named.setdefault(given.name, (given, many))
    for given, others in named.values():
        neighbour, better = others[0], _nearer(given, others[len(others) // 2], {other.unit for other in others})
        key = "remark.length" if better else "remark.length_alone"
        yield "LENGTH", ("given", given.name), say(
            key, name=given.name, text=_written(given), beside=_written(neighbour), better=f"{given.text} {better}"
        )  # fmt: skip


def _size(given: Given) -> float:
    return abs(given.value)


def _written(given: Given) -> str:
    return f"{given.text} {given.unit or 'm'}"


def _nearer(given: Given, middle: Given, written: Collection[str]) -> str:
    """Return the unit with which the same number would be nearest to the middle one of the others, "" if none brings it near.

    A unit in which one of the others is `written` comes first.
    """
    units = _LENGTHS[any("а" <= letter <= "я" for letter in given.unit)]
    apart = math.log(abs(float(given.text.replace("−", "-")))) - math.log(_size(middle))  # a quotient may be 0 or infinite
    near = [(abs(apart + math.log(float(UNITS[unit][0]))), unit) for unit in units]
    far, unit = min(near, key=lambda entry: (entry[0] >= math.log(_FAR) or entry[1] not in written, entry))
    return unit if far < math.log(_FAR) and unit != (given.unit or "m") else ""


def _bare(variant: Variant, dimensions: Dimensions, phases: Collection[str]) -> Iterator[Found]:
    """Yield data and starts without a unit in a file where others have one; plain numbers and zeros need none."""
    if dimensions.disagreement:
        return  # the dimensions of the others are then only a guess
    if not any(g.unit for g in variant.given) and not any(c.unit_was_given and c.text for c in variant.coordinates):
        return
    for given in variant.given:
        measured = dimensions.known.get(given.name)
        if not given.si and given.value and (measured or (measured is not None and given.name in phases)):
            yield "NO-UNIT", ("given", given.name), _without_unit(given.name, given.text, dimensions.si_of(given.name))
    for coordinate in variant.coordinates:
        if coordinate.start and coordinate.start_has_no_unit:
            yield "NO-UNIT", ("coordinates", coordinate.name), _without_unit(coordinate.name, coordinate.text, coordinate.unit)


def _without_unit(name: str, text: str, si: str) -> Sentence:
    return say("remark.no_unit", name=name, text=text, unit=advised_unit(si) or "SI")


def _left_out(variant: Variant, dimensions: Dimensions) -> Iterator[Found]:
    """Yield numbers that must have a dimension, times used as angles, and formulas that only units could make consistent."""
    if any(given.si for given in variant.given):
        # Whole lengths in the points and groups of the file: 0.27, but not the 0.5 of 0.5*r3.
        written = {length.name for length in lengths_of(variant) if length.op == "number"}
        for path, term, si in dimensions.numbers:
            if si == "m" and not written.isdisjoint(node.name for node in term.walk() if node.op == "number"):
                continue  # the length of a link, which the file gives as a number
            name = variant.constraints[int(path[1])].name
            yield "NUMBER", path, say("remark.number", term=text_of(term), name=name, unit=si)
    for path, whole in dimensions.times_as_angles:
        yield "TIME-AS-ANGLE", path, say("remark.time_as_angle", term=text_of(whole))
    if dimensions.disagreement:
        path, told = dimensions.disagreement
        yield "NO-UNIT", path, told


def _terms_of_angles(places: Iterable[Place]) -> Iterator[tuple[Place, Formula]]:
    """Yield each term of an angle, with its place: in sin, cos, tan, after @, or where an angle is required."""
    for place in places:
        for tree in place.formulas:
            if place.wanted == {} and place.path[-1] != "coefficient":  # the coefficient of friction is no angle
                yield from ((place, term) for term in terms(tree))
            for node in tree.walk():
                if node.op == "call" and node.name in {"sin", "cos", "tan"}:
                    yield from ((place, term) for term in terms(node.args[0]))
                elif node.op == "@":
                    yield from ((place, term) for term in terms(node.args[1]))


def frequencies_turned_twice(variant: Variant) -> Iterator[tuple[str, KeyPath, Sentence]]:
    """Yield a remark for each law that multiplies a datum with a unit of frequency by the size of this unit, pi/30 or 2*pi."""
    turned = {given.name: given for given in variant.given if given.si == "1/s"}
    if not turned:
        return
    plain = {given.name: given.value for given in variant.given if given.si in _PLAIN}
    told = set()
    for path, formula in _laws(variant):
        for name, factor, whole in _factors(formula, 1.0, formula, plain):
            given = turned.get(name)
            if given is None or (path, name) in told or not factor:
                continue
            size = size_of(given.unit) or 1.0
            # An author who counts turns per minute writes 2*pi for a turn, and may forget the minute.
            sizes = {size, math.pi / 30} - {1.0} | ({_TURN} if math.isclose(size, math.pi / 30) else set())
            key = "remark.rpm" if any(abs(factor / one - 1) < _NEAR for one in sizes) else ""
            if path[0] == "time" and factor == -_MINUTE and size < 1.0:
                key = "remark.rpm_turn"
            if key:
                told.add((path, name))
                known = {"name": name, "text": given.text, "unit": given.unit, "place": _place(path, variant)}
                yield "RPM", path, say(key, **known, term=text_of(whole))


def _place(path: KeyPath, variant: Variant) -> str:
    if path[0] == "constraint":
        return say("place.constraint", name=next(one.name for one in variant.constraints if one.path == path))
    return str(path[1])


def _laws(variant: Variant) -> Iterator[tuple[KeyPath, Formula]]:
    yield from variant.formulas_of_laws()
    for constraint in variant.constraints:
        yield from ((constraint.path, side) for side in constraint.sides)
    yield from variant.times.items()


def _factors(tree: Formula, factor: float, whole: Formula, plain: Mapping[str, float]) -> Iterator[tuple[str, float, Formula]]:
    """Yield (name, size of the number multiplying it, product containing it); the number is negative in a denominator."""
    if tree.op == "name":
        yield tree.name, factor, whole
    elif tree.op in {"neg", "+", "-"}:
        for arg in tree.args:
            yield from _factors(arg, factor, whole if factor != 1.0 else arg, plain)
    elif tree.op in {"*", "/"}:
        first, second = tree.args
        left, right = known_value(first, plain), known_value(second, plain)
        is_quotient = tree.op == "/"
        if left is None and right != 0:
            number = 1.0 if right is None else abs(1 / right if is_quotient else right)
            yield from _factors(first, factor * number, whole, plain)
        if right is None:
            number = factor * (1.0 if left is None else abs(left))
            yield from _factors(second, -number if is_quotient else number, whole, plain)
    else:
        for arg in tree.args:
            yield from _factors(arg, 1.0, arg, plain)
