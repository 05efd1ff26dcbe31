"""A handout -> from where each angle and length in its table is measured, and which direction is positive.

Enters: a `Handout`.  Leaves: rows of runs: symbols, what they are, from where measured, the positive direction.
Used by `sheet.py`.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from coursework.assigning.handout import Handout
from coursework.assigning.page_words import lettered, rates_of, symbol_runs
from coursework.drawing.lettering.turns import Signed, Turn, turns
from coursework.mechanism.mechanism import Mechanism
from coursework.report.formulas.display import marked_text
from coursework.report.formulas.typst_math import Setter
from coursework.report.text.numbers import POINT
from coursework.report.text.parts import Runs
from coursework.report.text.words import Words
from coursework.variant.formula.made import part_of_pi, summed
from coursework.variant.formula.tree import Formula, evaluate, named, signed, with_points
from coursework.variant.record.entries import Binding, Coordinate
from coursework.variant.record.held import followed
from coursework.variant.record.variant import Variant
from coursework.words.templates import clean

QUARTERS = ("right", "up", "left", "down")
_RIGHT_ANGLE = 1e-9  # rad: a direction as near as this to an axis lies on it


def sense_rows(handout: Handout, words: Words) -> list[list[Runs]]:
    """Return one row for each coordinate with its rate, each other velocity, and the velocity of a driven point."""
    variant, mechanism = handout.variant, handout.scene.mechanism
    found = {turn.coordinate: turn for turn in turns(mechanism, _values(handout))}
    rows: list[tuple[tuple[str, ...], str, str, str]] = []
    for one in variant.coordinates:
        turn = found.get(one.name)
        told = _angle(variant, one, turn, words) if one.unit == "rad" else _length(mechanism, one, words)
        rows.append(((one.name, one.rate), *told))
    rates = {one.rate for one in variant.coordinates}
    rows += [((name,), *_velocity(variant, name, words)) for name in variant.velocities if name not in rates]
    for point, laws in itertools.groupby(followed(variant).items(), lambda law: law[1][0]):
        axes = {law: axis for law, (_, axis) in laws}
        ways = words("join.comma").join(words(f"sheet.sense.{'right' if axis == 'x' else 'up'}") for axis in axes.values())
        rows.append((tuple(axes), words("sheet.sense.velocity", point=clean(point)), "", ways))
    return [[_symbols(variant, names), *(lettered(variant, text) for text in told)] for names, *told in rows]


def _values(handout: Handout) -> dict[str, complex]:
    """Return the values at the start by name, points as x + iy; names that depend on a law of time are left out."""
    variant = handout.variant
    names = [coordinate.name for coordinate in variant.coordinates]
    values: dict[str, complex] = {**variant.values, "pi": math.pi, **dict(zip(names, handout.start, strict=True))}
    return with_points(values, handout.scene.mechanism.points)


def _angle(variant: Variant, one: Coordinate, turn: Turn | None, words: Words) -> tuple[str, str, str]:
    link = next((link.name for link in variant.links if link.rate == one.rate), "")
    if turn is not None and turn.line:
        what = words("sheet.sense.angle", line=clean(turn.line))
    else:
        what = words("sheet.sense.angle_link", link=clean(link)) if link else words("sheet.sense.angle_only")
    if turn is None:
        return what, "", words("sheet.sense.untold")
    axis = _way(variant, turn.beside, words, "sheet.sense.axis")
    return what, axis, words("sheet.sense.counter" if turn.sense > 0 else "sheet.sense.clockwise")


def _length(mechanism: Mechanism, one: Coordinate, words: Words) -> tuple[str, str, str]:
    variant = mechanism.variant
    base, way = next(_arms(mechanism, one.name), ("", None))
    what = words("sheet.sense.distance")
    if way is None:
        return what, "", words("sheet.sense.untold")
    return what, _placed(mechanism, base, words), _way(variant, way, words, "sheet.sense")


def _placed(mechanism: Mechanism, name: str, words: Words) -> str:
    """Return the name of a point, with its place if it does not move: "K (0, h)"."""
    place = dict(mechanism.points).get(name)
    if place is None or place.op != "pair" or {*place.names()} & {*mechanism.variant.columns}:
        return clean(name)
    return f"{clean(name)} {_set(mechanism.variant, place, words)}"


def _velocity(variant: Variant, name: str, words: Words) -> tuple[str, str, str]:
    """Return what an unknown of the equations is: meaning, an empty origin, and its positive direction."""
    binding = next((one for one in variant.bindings if one.name == name), None)
    link = next((link.name for link in variant.links if link.rate == name), "")
    if binding is None and link:
        binding = Binding(name, link=link)
    if binding is None:
        return words("sheet.sense.of_equations"), "", words("sheet.sense.untold")
    key = ("link" if binding.link else "velocity") + ("_relative" if binding.relative else "")
    what = words(f"sheet.sense.{key}", point=clean(binding.point), link=clean(binding.link), relative=clean(binding.relative))
    if binding.along is None:
        return what, "", words("sheet.sense.counter")
    return what, "", _way(variant, tuple(signed(binding.along)), words, "sheet.sense")


def _way(variant: Variant, parts: Signed, words: Words, key: str) -> str:
    """Return a direction in words: along an axis, or at an angle to the x axis."""
    angle = summed(parts)
    if set(angle.names()) <= {"pi"}:
        value = evaluate(angle, {})
        quarter = round(2 * value / math.pi)
        if abs(value - quarter * math.pi / 2) < _RIGHT_ANGLE:
            return words(f"{key}.{QUARTERS[quarter % 4]}")
        text = f"{words.numbers.plain(math.degrees(value))}°"
    else:
        text = _set(variant, angle, words)
    return words(f"{key}.at", angle=text)


def _set(variant: Variant, formula: Formula, words: Words) -> str:
    """Return a formula as text; a comma between coordinates becomes a semicolon where the comma is the decimal mark."""
    text = Setter(typst=False, rates=rates_of(variant), in_sentence=True).set(formula).source
    mark = words("decimal")
    return marked_text(text if mark == POINT else text.replace(", ", "; "), mark)


def _arms(mechanism: Mechanism, name: str) -> Iterator[tuple[str, Signed]]:
    """Yield the point and the direction from which a length coordinate s is laid off, as in K + s @ angle or (s, 0)."""
    length = named(name)
    for side in _sides(mechanism):
        parts = list(signed(side))
        base = parts[0][0].name if parts[0][0].op == "name" and parts[0][1] > 0 else ""
        for part, sign in parts:
            if part.op == "@" and part.args[0] == length:
                turned = () if sign > 0 else ((named("pi"), 1),)
                yield base, (*signed(part.args[1]), *turned)
            if part.op == "pair" and length in part.args:
                quarter = part.args.index(length) + (0 if sign > 0 else 2)
                yield base, ((part_of_pi(Fraction(quarter, 2)), 1),)


def _sides(mechanism: Mechanism) -> Sequence[Formula]:
    points = [formula for _, formula in mechanism.points]
    return [*points, *(side for one in mechanism.constraints if one.is_closure for side in one.sides)]


def _symbols(variant: Variant, names: Sequence[str]) -> Runs:
    found: Runs = []
    for name in names:
        found += [{"t": ", "}, *symbol_runs(variant, name)] if found else symbol_runs(variant, name)
    return found
