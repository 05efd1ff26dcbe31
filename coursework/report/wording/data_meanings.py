"""What the data of a file mean: as its author says, else as its points, guides and drive use them.

Enters: a `Mechanism`.  Leaves: texts, or sentences that are written in the language of a page later.
Used by `statement.py` and `assigning/handout.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from coursework.drawing.outline.lengths import lengths
from coursework.mechanism.groups import group_kind
from coursework.mechanism.mechanism import Mechanism
from coursework.report.text.text_runs import LONGEST_NAME
from coursework.report.wording.drive_meanings import drive_meanings
from coursework.variant.formula.tree import Formula, terms
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say
from coursework.words.templates import clean


def meanings(mechanism: Mechanism) -> dict[str, str]:
    """Return what each datum means: the file's own words; the two points that it keeps apart; what else it is used for; or "".

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
    """Return what each coordinate measures where that is a length: between two points, or along a guide; else ""."""
    variant = mechanism.variant
    found = ends_kept(mechanism, [coordinate.name for coordinate in variant.coordinates])
    lengths_only = {coordinate.name for coordinate in variant.coordinates if coordinate.unit == "m"}
    for group in variant.groups:
        slides = [name for name in group.coordinates if name in lengths_only]
        for name, guide in zip(reversed(slides), reversed(group.guides), strict=False):
            if guide.through.op == "name":
                found[name] = found[name] or say("datum.along", point=clean(guide.through.name))
        carried = len(slides) > len(group.guides) > 0 and group.meets and group.start_points[0].op == "name"
        if carried:  # along a slide on the block that the group meets: RPP
            found[slides[0]] = found[slides[0]] or clean(group.start_points[0].name + str(group.meets))
    return found


def ends_kept(mechanism: Mechanism, names: Iterable[str]) -> dict[str, str]:
    """Return the two points whose distance each name is, in the author's order: "AB", or "" where it is none."""
    places = [name for name, _ in mechanism.points]
    kept = {length.name: ends for ends, length in reversed(lengths(mechanism).items()) if length.op == "name"}
    order = {name: place for place, name in enumerate(places)}
    return {name: "".join(sorted(kept.get(name, ()), key=lambda end: order.get(end, len(order)))) for name in names}


def _placed(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield the coordinates of the points that the file puts somewhere."""
    for point, formula in mechanism.points:
        if formula.op == "pair":
            for axis, part in zip("xy", formula.args, strict=True):
                if part.op == "name":
                    yield part.name, say(f"datum.{axis}", point=clean(point))


def _guided(variant: Variant) -> Iterator[tuple[str, str]]:
    """Yield radii of fixed circles, directions of guides, and how far something moves beside its guide."""
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
    """Yield the angles of a bar from the one whose coordinate it turns with: E = D + r5 @ (phi3 + gamma), C = D + r3 @ phi3."""
    moving = {coordinate.name for coordinate in mechanism.variant.coordinates}
    bars = dict(_bars(mechanism))
    for point, formula in _sides(mechanism):
        parts = [*terms(formula)]
        if [part.op for part in parts] != ["name", "@"]:
            continue
        angles = [part.name for part in terms(parts[1].args[1]) if part.op == "name"]
        turning = [name for name in angles if name in moving]
        for name in angles:
            if len(turning) == 1 and name not in moving:
                bar = clean(bars.get(turning[0], ""))
                yield name, say("datum.turned", name=bar or turning[0], ends=clean(parts[0].name + point))


def _sides(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield every way to a point that the file knows: its own, and both ways round the contour of a group."""
    yield from mechanism.points
    for group in mechanism.variant.groups:
        yield from ((group.meets, side) for side in group_kind(group.kind).closure(group)[0] if group.meets)


def _bars(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield the coordinates that are the angle of a bar, with its ends in the direction in which the angle is measured."""
    for point, formula in _sides(mechanism):
        parts = [*terms(formula)]
        if formula.op == "+" and [part.op for part in parts] == ["name", "@"] and parts[1].args[1].op == "name":
            yield parts[1].args[1].name, parts[0].name + point
