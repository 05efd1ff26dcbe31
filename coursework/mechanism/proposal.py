"""The line for [unknowns] that says which velocity an unknown is, written with the names of the file, as a proposal.

Enters: a `Variant` and the name of a velocity that its geometry does not give.  Leaves: a sentence.
Used by `results/checks/computed_right/equations.py` and `report/sections/derivation/motion_equations.py`.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, count, permutations

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, evaluate, named, spelled, with_points
from coursework.variant.reading.implied_closure import across_rail, stays
from coursework.variant.record.entries import reached
from coursework.variant.record.variant import Link, Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_NEAR, _SHIFT = 0.01, 0.1  # share of a distance within which a start gives it; rad or m by which coordinates are moved
_ALONG = {"y": "0 deg", "x": "90 deg"}  # a point that keeps its height moves along x


def proposals(variant: Variant, names: Iterable[str]) -> list[Sentence]:
    """Return what to write for each velocity; one that the file says already only waits for the coordinates of its point."""
    bound = {binding.name for binding in variant.bindings}
    return [proposed(variant, name) for name in names if name not in bound]


def proposed(variant: Variant, name: str) -> Sentence:
    """Return what to write so that the geometry determines the velocity `name`.

    >>> import coursework
    >>> text = coursework.load("v102").path.read_text(encoding="utf-8")
    >>> bare = coursework.parse_variant(text.replace('u = { unit = "m/s", of = "C", along = "90 deg" }', 'u = "m/s"'))
    >>> print(proposed(bare, "u"))
    Write in [unknowns] u = { unit = "m/s", of = "C", along = "90 deg" }, if u is the velocity of C along its guide.
    """
    unit = dict(variant.unknowns).get(name)
    if unit is None:
        coordinate = next((c.name for c in variant.coordinates if c.rate == name), name)
        return _of_coordinate(variant, name, coordinate)
    if unit != "m/s":
        return _of_link(variant, name)
    guided = [*_guided(variant)]
    taken = {binding.point for binding in variant.bindings}
    named_after = [one for one in guided if len(name) > 1 and name.endswith(one[0])]
    free = [one for one in guided if one[0] not in taken]
    if not named_after and not free:
        point = next((point for point, _ in reversed(variant.points)), "B")
        return say("proposal.point", name=name, line=_line(name, "m/s", point, "0 deg"))
    point, along, relative = [*named_after, *free][0]
    key = "proposal.sliding" if relative else "proposal.guided"
    return say(key, name=name, point=point, relative=relative, line=_line(name, "m/s", point, along, relative))


def _of_coordinate(variant: Variant, name: str, coordinate: str) -> Sentence:
    """Return what [closure] must hold so that a coordinate is determined: that a point placed by it stays in its guide."""
    places = dict(variant.points)
    for through, angle in variant.frame.rails:
        held = across_rail(through, angle, variant)
        if through.op == "name" and coordinate in reached([through.name], places) and held not in variant.holds:
            holds = ", ".join(f'"{spelled(hold)}"' for hold in (*variant.holds, held))
            return say("proposal.rail", name=name, point=through.name, holds=holds)
    return say("proposal.coordinate", name=name, coordinate=coordinate)


@frozen
class Arm:
    """A `length` of the data from one point of a `link` to another, at the angle that is the coordinate `angle`."""

    link: str
    begin: str
    end: str
    length: str
    angle: str


def loose_arms(variant: Variant, start: Sequence[float]) -> list[Arm]:
    """Return two points of each link that nothing ties, and the datum and the coordinate by which the start (m,) does so."""
    values = dict(zip((one.name for one in variant.coordinates), start, strict=True))
    known = {**variant.values, "pi": math.pi}
    moved = ({name: value + shift for name, value in values.items()} for shift in (0.0, _SHIFT))
    poses = [with_points({**known, **position}, variant.points) for position in moved]
    turning = {one.rate: one.name for one in variant.coordinates if one.unit == "rad"}
    found: dict[str, Arm] = {}
    for link in variant.links:
        ends = [point for point in link.points if all(point in pose for pose in poses)]
        for begin, end in permutations(ends, 2) if link.rate in turning else ():
            now, then = (pose[end] - pose[begin] for pose in poses)
            angle = turning[link.rate or ""]
            beside = abs(now) * cmath.exp(1j * values[angle])
            lengths = [one.name for one in variant.given if one.si == "m" and abs(abs(one.value) - abs(now)) <= _NEAR * abs(now)]
            if abs(now - beside) <= _NEAR * abs(now) and abs(abs(then) - abs(now)) > _NEAR * abs(now) and len(lengths) == 1:
                found.setdefault(link.name, Arm(link.name, begin, end, lengths[0], angle))
    return [*found.values()]


def _of_link(variant: Variant, name: str) -> Sentence:
    """Return what to write for the rate of a link; the link is the one with the number in `name`, if there is one."""
    found = re.search(r"\d+$", name)
    digits = found[0] if found else ""
    known = {link.name for link in variant.links if link.rate != name}  # a chain numbers its links by their rates
    known |= {end[0] for c in variant.coordinates if c.unit == "rad" and (end := re.search(r"\d+$", c.rate))}
    if digits not in known and set(digits) <= known and len(digits) == 2:
        line = _line(name, "1/s", f"link {digits[0]}", relative=digits[1])
        return say("proposal.relative", name=name, link=digits[0], other=digits[1], line=line)
    unnamed = (link.name for link in variant.links if link.rate is None and not _only_shifted(link, variant))
    free = (str(number) for number in count(1) if str(number) not in known | {link.name for link in variant.links})
    link = digits or next(chain(unnamed, free))
    line = _line(name, "1/s", f"link {link}")
    return say("proposal.link" if link in known else "proposal.link_missing", name=name, link=link, line=line)


def _only_shifted(link: Link, variant: Variant) -> bool:
    """Return whether a link of several points is a rack or a block: its points keep their places beside each other."""
    first, *others = [named(point) for point in link.points] or [named("")]
    arms = [Formula("part", (Formula("-", (other, first)),), axis) for other in others for axis in "xy"]
    return bool(arms) and not link.wheel and stays(arms, variant)


def _line(name: str, unit: str, of: str, along: str = "", relative: str = "") -> str:
    keys = {"unit": unit, "of": of, "along": along, "relative": relative}
    listed = ", ".join(f'{key} = "{value}"' for key, value in keys.items() if value)
    return f"{name} = {{ {listed} }}"


def _guided(variant: Variant) -> Iterator[tuple[str, str, str]]:
    """Yield (point, direction, link or "") of all that slides: on a rail, along an axis, in a guide of a group, on a link."""
    contacts = {link.contact for link in variant.links}
    points = dict(variant.points)
    for through, angle in variant.frame.rails:
        if through.op == "name" and through.name in points and through.name not in contacts:
            yield through.name, _written(angle), ""
    for hold in variant.holds:
        if hold.op == "part" and hold.args[0].op == "name" and hold.args[0].name not in contacts:
            yield hold.args[0].name, _ALONG[hold.name], ""
    yield from ((group.meets, _written(group.guides[0].angle), "") for group in variant.groups if group.meets and group.guides)
    links = {link.name: link for link in variant.links}
    for link in variant.links:
        bar = links.get(link.slides or "")
        if bar is not None and link.points and (along := _direction(bar, variant)):
            yield link.points[0], along, bar.name


def _direction(bar: Link, variant: Variant) -> str:
    """Return the angle at which one point of a bar is placed from another, "" if the file does not write it this way."""
    for name, formula in variant.points:
        start, *vector = formula.args if formula.op in {"+", "-"} else (formula,)
        if name in bar.points and start.op == "name" and start.name in bar.points and vector and vector[0].op == "@":
            return _written(vector[0].args[1])
    return ""


def _written(angle: Formula) -> str:
    """Return an angle as a file writes it: a number in degrees if it is constant."""
    if set(angle.names()) <= {"pi"}:
        return f"{math.degrees(evaluate(angle, {})):.10g} deg"
    return spelled(angle)
