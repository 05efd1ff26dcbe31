"""All faults of the groups of a chain, each group alone and all as a chain, before anything is assembled.

Enters: a `Variant`, the shapes of the kinds, the sections that have faults already.  Leaves: faults.
Used by `whole_file.py`, and by `mechanism/mechanism.py` for kinds that only the mechanism knows.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter

from coursework.variant.formula.tree import named
from coursework.variant.judging.broken import Broken
from coursework.variant.record.entries import Group, reached
from coursework.variant.record.roles import entries, letters_of, mode_meaning
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import Shape
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say, say_count

_KEYS = {"from": "points", "lengths": "lengths", "guides": "guides", "coordinates": "coordinates"}


def faults_of_groups(variant: Variant, shapes: Mapping[str, Shape], broken: Broken) -> list[Fault]:
    """Return every fault of the groups: missing entries, a missing mode, an impossible order, points defined in a circle.

    Nothing more is reported about a group, or a coordinate, that is `broken`.
    """
    own = [
        fault
        for number, group in enumerate(variant.groups, start=1)
        if group.kind in shapes and not broken.has("group", number - 1, "kind")
        for fault in _own(number, group, shapes[group.kind], variant, broken)
    ]
    return own + [*_shared(variant, broken)] + ([*_order(variant)] or [*_circles(variant)])


def _own(number: int, group: Group, shape: Shape, variant: Variant, broken: Broken) -> Iterator[Fault]:
    found = {"from": group.start_points, "guides": group.guides, "lengths": group.lengths, "coordinates": group.coordinates}
    for key, right in shape.counts.items():
        count = len(found[key])
        faulty = any(broken.has("group", number - 1, name) for name in ((key, "guide") if key == "guides" else (key,)))
        if count not in right and not faulty:
            wanted = say_count(f"fault.shape.{_KEYS[key]}", right[-1])
            key = "guide" if key == "guides" and variant.line_of("group", number - 1, "guide") else key  # as the file says
            roles = _roles(key, group, shape, count, variant)
            told = say("fault.V343", number=number, kind=group.kind, wanted=wanted, found=count, roles=roles)
            yield Fault(told, variant.file, variant.line_of("group", number - 1, key) or group.line)
    own = [c for c in variant.coordinates if c.name in group.coordinates]
    if broken.has("group", number - 1, "coordinates") or not own:
        return
    if shape.driven and own[0].rate not in variant.known_rates and not broken.has("coordinates", own[0].name, "rate"):
        key = "fault.V344" if variant.motor is None else "fault.V747"
        yield Fault(say(key, number=number, kind=group.kind, rate=own[0].rate), variant.file, group.line)
    open_start = any(c.start_or_guess is None and not broken.has("coordinates", c.name, "start") for c in own)
    if shape.modes and not group.mode and open_start and not broken.has("group", number - 1, "mode"):
        plus, minus = (mode_meaning(shape, mode, letters_of(shape, group)) for mode in (1, -1))
        place = say("place.group_of", number=number, names=", ".join(group.coordinates))
        yield Fault(say("fault.V307", kind=group.kind, plus=plus, minus=minus), variant.file, group.line, 0, place)


def _shared(variant: Variant, broken: Broken) -> Iterator[Fault]:
    """Yield a fault for each coordinate in two groups: each coordinate moves one link, on which other groups may hang."""
    first: dict[str, int] = {}
    for number, group in enumerate(variant.groups, start=1):
        for name in () if broken.has("group", number - 1, "coordinates") else group.coordinates:
            if (before := first.setdefault(name, number)) != number:
                turns = next((c.unit == "rad" for c in variant.coordinates if c.name == name), True)
                told = say(f"fault.V348.{'turns' if turns else 'slides'}", number=number, name=name, before=before)
                yield Fault(told, variant.file, variant.line_of("group", number - 1, "coordinates") or group.line)


def _roles(key: str, group: Group, shape: Shape, count: int, variant: Variant) -> Sentence | str:
    """Return the roles of the missing entries of a list, or of all its entries if there are too many."""
    written, key = key, "guides" if key == "guide" else key
    most = shape.counts[key][-1]
    if not most:
        return say("fault.shape.take_out", key=written)
    # A length is named by letters; if a point has no name, by the letter of the kind.
    letters = letters_of(shape, replace(group, meets=group.meets or shape.letters[-1]))
    told = entries(shape, key, letters, count + 1 if count < most else 1)
    if key == "guides" and not count:
        through = variant.points[0][0] if variant.points else "A"
        lines = [f'{{ through = "{through}", angle = "{turned} deg" }}' for turned in (0, 90)]
        line = f"guide = {lines[0]}" if most == 1 else f"guides = [{', '.join(lines)}]"
        return say("fault.shape.write", roles=told, line=line)
    return say("fault.shape.missing" if count < most else "fault.shape.all", roles=told)


def _order(variant: Variant) -> Iterator[Fault]:
    """Yield a fault for each group that uses something only a later group, or the group itself, gives."""
    coordinates = {c.name for c in variant.coordinates}
    driven = {c.name for c in variant.coordinates if c.rate in variant.known_rates}
    known = coordinates - {name for group in variant.groups for name in group.coordinates}
    met: set[str] = set()
    for number, group in enumerate(variant.groups, start=1):
        if late := _later(group, met, known | {*group.coordinates}, variant):
            told = say("fault.V341", number=number, kind=group.kind, late=late)
            yield Fault(told, variant.file, group.line)
        elif own := [name for name in group.coordinates if name in _needed(group, variant) and name not in driven]:
            yield Fault(say("fault.V349", number=number, kind=group.kind, own=own[0]), variant.file, group.line)
        known.update(group.coordinates)
        if group.meets:
            met.add(group.meets)


def _later(group: Group, met: set[str], known: set[str], variant: Variant) -> str:
    """Return the point or coordinate that a group needs before the chain has it, "" if there is none."""
    coordinates, points = {c.name for c in variant.coordinates}, dict(variant.points)
    later = {other.meets for other in variant.groups}
    late = (
        name for name in _needed(group, variant) if name not in points and name not in met and name != group.meets
    )  # see `_circles`
    return next((name for name in late if (name in coordinates and name not in known) or name in later), "")


def _needed(group: Group, variant: Variant) -> Collection[str]:
    """Return the names in the formulas that place a group, and in those of the points and laws that these need."""
    laws = {law.name: law.formula or named(law.of) for law in variant.functions if law.formula or law.of}
    return reached([name for formula in group.formulas for name in formula.names()], {**laws, **dict(variant.points)})


def _circles(variant: Variant) -> Iterator[Fault]:
    """Yield a fault for points that are defined in a circle, if there are any."""
    needs = {name: {*formula.names()} for name, formula in variant.points}
    for group in variant.groups:
        if group.meets:
            needs[group.meets] = {name for formula in group.formulas for name in formula.names()}
    sorter = TopologicalSorter({name: [other for other in needed if other in needs] for name, needed in needs.items()})
    try:
        sorter.prepare()
    except CycleError as error:
        circle = error.args[1][::-1]
        told = say("fault.V345" if len(circle) > 2 else "fault.V346", circle=" → ".join(circle))
        met = {group.meets: group.line for group in variant.groups}
        yield Fault(told, variant.file, met.get(circle[0]) or variant.nearest_line("points", circle[0]))
