"""The meaning of the data of a file: in the author's words, else derived from its points, guides and drive.

Enters: a `Mechanism`.  Leaves: texts, or sentences that a page later writes in its language.
Used by `statement.py` and `assigning/handout.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from coursework.drawing.outline.lengths import lengths
from coursework.mechanism.groups import group_kind
from coursework.mechanism.mechanism import Mechanism
from coursework.report.text.text_runs import LONGEST_NAME
from coursework.variant.formula.tree import Formula, factors, signed, terms
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say
from coursework.words.templates import clean

_WAVES = {"sin", "cos"}
_BACKWARDS = {"x": "left", "y": "below"}
_LETTER = re.compile(r"[^\W\d_](?:\d+|[ij])?")  # the name of a point that is no word: A, P1, Ki


def meanings(mechanism: Mechanism) -> dict[str, str]:
    """Return the meaning of each datum: the file's own words, else the two points whose distance it is, else its use, else "".

    >>> import coursework
    >>> meanings(coursework.solve("v101").scene.mechanism)["p"]
    'angular frequency of the drive'
    """
    variant = mechanism.variant
    ends = ends_kept(mechanism, [given.name for given in variant.given])
    uses: dict[str, str] = {}
    for name, use in (*_placed(mechanism), *_guided(variant), *_turned(mechanism), *drive_meanings(variant)):
        uses.setdefault(name, use)
    return {
        given.name: clean(given.means, LONGEST_NAME) or clean(ends[given.name]) or uses.get(given.name, "")
        for given in variant.given
    }


def coordinate_meanings(mechanism: Mechanism) -> dict[str, str]:
    """Return what each coordinate measures if it is a length, between two points or along a guide; else ""."""
    variant = mechanism.variant
    found = ends_kept(mechanism, [coordinate.name for coordinate in variant.coordinates])
    lengths_only = {coordinate.name for coordinate in variant.coordinates if coordinate.unit == "m"}
    for group in variant.groups:
        slides = [name for name in group.coordinates if name in lengths_only]
        for name, guide in zip(reversed(slides), reversed(group.guides), strict=False):
            if guide.through.op == "name":
                found[name] = found[name] or say("datum.along", point=clean(guide.through.name))
        carried = len(slides) > len(group.guides) > 0 and group.meets and group.start_points[0].op == "name"
        if carried:  # RPP: the length along the slide, from its start point to the point that the group meets
            found[slides[0]] = found[slides[0]] or clean(group.start_points[0].name + str(group.meets))
    return found


def ends_kept(mechanism: Mechanism, names: Iterable[str]) -> dict[str, str]:
    """Return for each name the two points whose distance it is, in the author's order ("AB"), or "" if it is no distance."""
    places = [name for name, _ in mechanism.points]
    kept = {length.name: ends for ends, length in reversed(lengths(mechanism).items()) if length.op == "name"}
    order = {name: place for place, name in enumerate(places)}
    return {name: _between(sorted(kept.get(name, ()), key=lambda end: order.get(end, len(order)))) for name in names}


def _between(points: Sequence[str]) -> str:
    """Return two points as a distance: AB, XP1, or Origin–Pin if a name is a word."""
    return ("" if all(map(_LETTER.fullmatch, points)) else "–").join(points)


def _placed(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield (name, meaning) of the data that are the x or y of a point, from the origin or from another point."""
    for point, formula in mechanism.points:
        parts = [*terms(formula)]
        base = parts[0].name if [part.op for part in parts] == ["name", "pair"] and formula.op == "+" else ""
        for axis, part in zip("xy", parts[-1].args if base or formula.op == "pair" else (), strict=False):
            turned = part.args[0] if part.op == "neg" else part
            if turned.op == "name":
                key = f"datum.{axis if turned is part else _BACKWARDS[axis]}"
                yield turned.name, say(f"{key}_from" if base else key, point=clean(point), base=clean(base))


def _guided(variant: Variant) -> Iterator[tuple[str, str]]:
    """Yield (name, meaning) of radii of fixed circles, directions of guides, and offsets from a guide."""
    for centre, radius in variant.frame.circles:
        if centre.op == radius.op == "name":
            yield radius.name, say("datum.circle", point=clean(centre.name))
    guides = [(guide.through, guide.angle) for group in variant.groups for guide in group.guides]
    for through, angle in (*variant.frame.rails, *guides):
        if through.op == angle.op == "name":
            yield angle.name, say("datum.direction", point=clean(through.name))
    beside = [(guide.through, guide.offset) for group in variant.groups for guide in group.guides]
    beside += [(group.start_points[-1], group.offset) for group in variant.groups if group.start_points]
    for through, offset in beside:
        if through.op == offset.op == "name":
            yield offset.name, say("datum.offset", point=clean(through.name))


def _turned(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield (name, meaning) of constant angles between two bars: gamma in E = D + r5 @ (phi3 + gamma) if C = D + r3 @ phi3."""
    moving = {coordinate.name for coordinate in mechanism.variant.coordinates}
    bars = dict(_bars(mechanism))
    for point, formula in _sides(mechanism):
        parts = [*terms(formula)]
        if [part.op for part in parts] != ["name", "@"]:
            continue
        angles = {part.name: sign for part, sign in signed(parts[1].args[1]) if part.op == "name"}
        turning = [name for name in angles if name in moving]
        for name, sign in angles.items():
            if len(turning) == 1 and name not in moving and angles[turning[0]] > 0:
                ends = [clean(bars.get(turning[0], "")) or turning[0], clean(parts[0].name + point)]
                first, last = ends[::sign]  # phi - gamma: gamma is counted from this bar to the one at phi
                yield name, say("datum.turned", name=first, ends=last)


def _sides(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield (point, formula) for every formula of a point: its own, and both sides of the closed contour of a group."""
    yield from mechanism.points
    for group in mechanism.variant.groups:
        yield from ((group.meets, side) for side in group_kind(group.kind).closure(group)[0] if group.meets)


def _bars(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield each coordinate that is the angle of a bar, with the bar's ends in the direction that the angle measures."""
    for point, formula in _sides(mechanism):
        parts = [*terms(formula)]
        if formula.op == "+" and [part.op for part in parts] == ["name", "@"] and parts[1].args[1].op == "name":
            yield parts[1].args[1].name, parts[0].name + point


def drive_meanings(variant: Variant) -> Iterator[tuple[str, str]]:
    """Yield (name, meaning) of the constants of the drive, without doubtful ones; a name may come more than once.

    >>> import coursework
    >>> dict(drive_meanings(coursework.load("31")))["alpha"]
    'phase of the drive'
    """
    formulas = [(law.name, formula) for law in variant.drive for formula in law.formulas]
    of_one_piece = {law.name for law in variant.drive if len(law.formulas) == 1}
    for law, formula in formulas:
        turned = formula.args[0] if formula.op == "neg" else formula
        if turned.op == "name" and law in of_one_piece:  # in a law of several pieces it is the speed only for a while
            yield turned.name, say("datum.speed", name=law if turned is formula else f"−{law}")
    for _, formula in formulas:
        for wave in _waves(formula):
            if _swings(wave):
                yield from _inside(wave)
    headings = dict(_headings(formulas))
    for name, vector in headings.items():
        yield name, say("datum.heading", name=vector)
    turning = {coordinate.rate: coordinate.name for coordinate in variant.coordinates}
    for law, formula in formulas:
        for term in terms(formula):
            yield from _size(term, law, headings)
            if law in turning:
                yield from _swing(term, turning[law])


def _inside(wave: Formula) -> Iterator[tuple[str, str]]:
    """Yield (name, meaning) of the constants inside sin(p*t + alpha), sin(2*pi*f*t) or sin(2*pi*t/T)."""
    for part in terms(wave.args[0]):
        above, below = _product(part)
        names = [factor.name for factor in above if factor.op == "name"]
        turns = "pi" in names
        if part.op == "name" and part.name != "t":
            yield part.name, say("datum.phase")
        elif "t" in names:
            yield from ((name, say("datum.cycles" if turns else "datum.frequency")) for name in names if name not in {"t", "pi"})
            if turns:
                yield from ((factor.name, say("datum.repeats")) for factor in below if factor.op == "name")


def _headings(formulas: list[tuple[str, Formula]]) -> Iterator[tuple[str, str]]:
    """Yield ("beta", "VM") if VMx has the factor cos(beta) and VMy the factor sin(beta)."""
    turned = {(law, name) for law, formula in formulas for name in _constant_waves(formula)}
    for law, (function, angle) in sorted(turned):
        if law.endswith("x") and function == "cos" and (f"{law[:-1]}y", ("sin", angle)) in turned:
            yield angle, law[:-1]


def _constant_waves(formula: Formula) -> Iterator[tuple[str, str]]:
    for wave in _waves(formula):
        if wave.args[0].op == "name" and not _swings(wave):
            yield wave.name, wave.args[0].name


def _size(term: Formula, law: str, headings: dict[str, str]) -> Iterator[tuple[str, str]]:
    """Yield the meaning of V1 in V1*sin(p*t), V1*sin(p*t)*cos(beta) or V1*cos(beta), if it is the only size in the term."""
    above, below = _product(term)
    heading = next((headings[angle] for factor in above for _, angle in _constant_waves(factor) if angle in headings), None)
    sizes = [factor for factor in above if not [*_waves(factor)]]
    swinging = any(_swings(wave) for factor in above for wave in _waves(factor))
    if below or len(sizes) != 1 or sizes[0].op != "name" or not (swinging or heading):
        return
    yield sizes[0].name, say("datum.amplitude" if swinging else "datum.speed", name=heading or law)


def _swing(term: Formula, coordinate: str) -> Iterator[tuple[str, str]]:
    """Yield the meaning of A in A*p*cos(p*t), the rate of a coordinate that swings by A to each side."""
    above, below = _product(term)
    waves = [factor for factor in above if factor.op == "call" and _swings(factor)]
    sizes = [factor.name for factor in above if factor.op == "name"]
    if below or len(waves) != 1 or waves[0].name not in _WAVES or len(sizes) != 2 or len(above) != 3:
        return
    turned = [name for part in terms(waves[0].args[0]) for name in part.names() if "t" in part.names() and name != "t"]
    if len(turned) == 1 and turned[0] in sizes and sizes[0] != sizes[1]:
        yield next(name for name in sizes if name != turned[0]), say("datum.amplitude", name=coordinate)


def _waves(formula: Formula) -> Iterator[Formula]:
    return (node for node in formula.walk() if node.op == "call" and node.name in _WAVES)


def _swings(wave: Formula) -> bool:
    return "t" in wave.names()


def _product(tree: Formula) -> tuple[list[Formula], list[Formula]]:
    """Return the factors of the numerator and of the denominator."""
    found = [*factors(tree, "*/")]
    return [factor for factor, power in found if power > 0], [factor for factor, power in found if power < 0]
