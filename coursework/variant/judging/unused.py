"""Parts of a file that nothing uses or counts: links and pivots left out, sleeves pinned, speeds as rates, lone guides, data.

Enters: a `Variant`, the dimensions of its names.  Leaves: remarks by the path of what they are about; pivots that no link has.
Used by `plausibility.py` and `left_out.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import chain

from coursework.variant.formula.tree import with_points
from coursework.variant.judging.dimension_check import Dimensions
from coursework.variant.record.blocks import blocks_of
from coursework.variant.record.entries import reached
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_ROUND_OFF = 1e-12
Found = tuple[str, KeyPath, Sentence]  # a code, what the remark is about, the remark


def parts_unused(variant: Variant, dimensions: Dimensions) -> Iterator[Found]:
    """Yield every such remark, and that the table ends before the requested end."""
    yield from _idle(variant, dimensions)
    of_links = (_links_left_out, _pinned_sleeves, _speeds_as_rates, _no_pivots)
    for found in (*of_links, _stiff_springs, _empty_guides, _untouched, _short_of_end):
        yield from found(variant)


def _links_left_out(variant: Variant) -> Iterator[Found]:
    """Yield the rates of a chain that no link of [links] has: if links are listed, only these are drawn and counted."""
    in_groups = {name for group in variant.groups for name in group.coordinates}
    turning = [c.rate for c in variant.coordinates if c.name in in_groups and c.unit == "rad"]
    missing = [rate for rate in turning if all(link.rate != rate for link in variant.links)]
    if variant.links and missing:
        yield "LINKS", ("links",), say("remark.links", rates=", ".join(missing))


def _pinned_sleeves(variant: Variant) -> Iterator[Found]:
    """Yield links that slide along a link with which they share a point: a pin there holds them."""
    points = {link.name: link.points for link in variant.links}
    for link in variant.links:
        for point in link.points:
            if point in points.get(link.slides or "", ()):
                yield "LINKS", ("links", link.name), say("remark.pinned", link=link.name, other=link.slides, point=point)


def _speeds_as_rates(variant: Variant) -> Iterator[Found]:
    """Yield links whose rate is a speed along a line: no column shows it, but forces and plans would turn the link so fast."""
    speeds = {one.rate: one.name for one in variant.coordinates if one.unit == "m"}
    for link in variant.links:
        if link.rate in speeds:
            told = say("remark.speed_as_rate", link=link.name, rate=link.rate, coordinate=speeds[link.rate])
            yield "LINKS", ("links", link.name), told


def _no_pivots(variant: Variant) -> Iterator[Found]:
    """Yield points of links that stand still and are no pivots of the frame: their links are counted and drawn without them."""
    points, moving = dict(variant.points), {*variant.names} - {*variant.values}
    moving |= {group.meets for group in variant.groups if group.meets}
    for link in variant.links:
        for point in link.held:
            if point in points and point not in variant.frame.hinges and not moving & reached([point], points):
                yield "PIVOT", ("links", link.name), say("remark.pivot", link=link.name, point=point)


def bare_hinges(variant: Variant) -> list[str]:
    """Return the pivots of the frame that no link has; a spring may end at one, a rope run over it."""
    held = {name for link in variant.links for name in link.held}
    return [point for point in variant.frame.hinges if variant.links and point not in held]


def _empty_guides(variant: Variant) -> Iterator[Found]:
    """Yield guides through a point that no link of [links] has: only the point it passes through slides in a guide."""
    held = {name for link in variant.links for name in (*link.held, link.contact)}.union(variant.frame.hinges)
    begun = {guide.through for group in variant.groups for guide in group.guides if group.meets}  # its pin slides there
    for place, (through, _) in enumerate(variant.frame.rails if variant.links else ()):
        if through.op == "name" and through.name not in held and through not in begun:
            yield "GUIDE", ("frame", "rails", place), say("remark.guide", point=through.name)


def _untouched(variant: Variant) -> Iterator[Found]:
    """Yield wheels if the file shows nothing that they roll on: a rail, a circle, a rack, or another link with the contact."""
    places = {formula: name for name, formula in variant.points}
    rails = {through.name if through.op == "name" else places.get(through) for through, _ in variant.frame.rails}
    for link in () if variant.frame.circles or blocks_of(variant) else variant.links:
        others = (name for one in variant.links if one is not link for name in (*one.points, one.contact))
        if link.contact and link.contact not in {*rails, *others}:
            yield "CONTACT", ("links", link.name), say("remark.contact", link=link.name, point=link.contact)


def _short_of_end(variant: Variant) -> Iterator[Found]:
    """Yield `end` if the step does not lead to it, for the table ends before it."""
    if variant.time.last != variant.time.end:
        yield "END", ("time", "end"), say("remark.last_row", last=variant.time.last, end=variant.time.end)


def _idle(variant: Variant, dimensions: Dimensions) -> Iterator[Found]:
    """Yield unused data, and drives that are neither a rate nor a velocity of the driven point and occur in no formula.

    Zeros are excluded, since they leave no term in an equation; so are files of velocity equations alone, in which offsets and
    positions of pivots do not occur.
    """
    formulas = chain((one for _, one in variant.formulas()), (one for place in dimensions.places for one in place.formulas))
    read = {*variant.rates, *(link.rate for link in variant.links), *(name for one in formulas for name in one.names())}
    read |= {f"V{variant.driven}{axis}" for axis in "xy"}
    for law in variant.drive:
        if law.name not in read and not (law.formula and known_value(law.formula, variant.values) == 0):
            yield "IDLE", ("drive", law.name), say("remark.idle", name=law.name)
    shown = variant.points or variant.groups
    unused = [given.name for given in variant.given if shown and given.value and given.name not in read]
    placed = {x: (x, y, point) for x, y, point in _places(variant) if {x, y} <= {*unused}}
    beside = {y for _, y, _ in placed.values()}
    for name in unused:
        if name in placed:
            x, y, point = placed[name]
            yield "UNUSED", ("given", name), say("remark.unused_place", x=x, y=y, point=point)
        elif name not in beside:
            yield "UNUSED", ("given", name), say("remark.unused", name=name)


def _stiff_springs(variant: Variant) -> Iterator[Found]:
    """Yield springs and dampers between two points whose distance is the same wherever the coordinates are."""
    known = {"pi": math.pi, **variant.values}
    # Of two coordinates neither the difference nor the sum stays the same from place to place.
    anywhere = ({c.name: at * (k + 1) + k for k, c in enumerate(variant.coordinates)} for at in (0.3, 0.8, 1.7))
    positions = [with_points(known | somewhere, variant.points) for somewhere in anywhere]
    for spring in variant.forces.springs if variant.forces else ():
        one, other = spring.ends
        if not {one, other} <= {*positions[0]} & {*positions[1]} & {*positions[2]}:  # the place of a pin of a chain, say
            continue
        lengths = [abs(at[one] - at[other]) for at in positions]
        if max(lengths) - min(lengths) <= _ROUND_OFF * max(*lengths, *(abs(at[one]) for at in positions)):
            yield "IDLE", ("forces", spring.name), say("remark.idle_spring", name=spring.name, one=one, other=other)


def _places(variant: Variant) -> Iterator[tuple[str, str, str]]:
    """Yield the names that data of a place have, such as xD and yD, with the point."""
    for point, _ in variant.points:
        yield from (
            (form.format("x", point), form.format("y", point), point) for form in ("{0}{1}", "{1}{0}", "{0}_{1}", "{1}_{0}")
        )
