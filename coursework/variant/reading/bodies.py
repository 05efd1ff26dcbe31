"""The bodies of a mechanism as a file gives them: groups of a chain, links, the frame.

Enters: checked sections of a file.  Leaves: records of `record.py`; faults stay with the `Parts`.  Used by `reader.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.variant.formula.tree import Formula
from coursework.variant.reading import schema
from coursework.variant.reading.parts import Parts
from coursework.variant.reading.stand_ins import NAMELESS
from coursework.variant.record.variant import Frame, Group, Guide, Link
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentences import closest, say


def read_group(index: int, entry: schema.Group, parts: Parts) -> Group:
    """Return one group of a chain, or its crank."""
    path = ("group", index)

    listed: list[tuple[KeyPath, schema.Guide]] = [((*path, "guide"), entry.guide)] if entry.guide else []
    listed += [((*path, "guides", i), guide) for i, guide in enumerate(entry.guides)]
    guides = tuple(
        Guide(
            parts.formula((*at, "through"), g.through, "vector"),
            parts.scalar((*at, "angle"), g.angle, wanted="rad"),
            parts.scalar((*at, "offset"), g.offset, wanted="m"),
        )
        for at, g in listed
    )
    for place, coordinate in enumerate(entry.coordinates):
        if coordinate != NAMELESS and parts.names.kinds.get(parts.names.canonical(coordinate)) != "coordinate":
            known = [name for name, kind in parts.names.kinds.items() if kind == "coordinate"]
            text = say("fault.V080", coordinate=coordinate, hint=closest(coordinate, known))
            parts.undeclared((*path, "coordinates", place), {"coordinate"}, text)
    return Group(
        entry.kind,
        tuple(parts.formula((*path, "from", i), text, "vector") for i, text in enumerate(entry.start_points)),
        parts.names.canonical(entry.meets) if entry.meets else None,
        tuple(parts.scalar((*path, "lengths", i), value, wanted="m") for i, value in enumerate(entry.lengths)),
        tuple(parts.names.canonical(coordinate) for coordinate in entry.coordinates),
        int(entry.mode or 0),
        guides,
        parts.scalar((*path, "offset"), entry.offset if entry.offset is not None else 0, wanted="m"),
        parts.scalar((*path, "angle"), entry.angle, wanted="rad") if entry.angle is not None else None,
        parts.source.positions.find(path)[0],
    )


def read_link(key: str, entry: schema.Link, links: list[str], parts: Parts) -> Link:
    """Return one rigid body."""
    points = tuple(parts.known_point(("links", key, "points", place), point) for place, point in enumerate(entry.points))
    roles = (("wheel", entry.wheel), ("contact", entry.contact))
    wheel, contact = (parts.known_point(("links", key, role), name) if name else None for role, name in roles)
    if entry.rate and parts.names.canonical(entry.rate) not in parts.names.velocities:
        text = say("fault.V078", rate=entry.rate, hint=closest(entry.rate, parts.names.velocities))
        parts.undeclared(("links", key, "rate"), {"rate", "unknown", "drive"}, text)
    slides = None if entry.slides is None else str(entry.slides)
    if slides is not None and (slides == key or slides not in links):
        others = [link for link in links if link != key]
        parts.say(("links", key, "slides"), say("fault.V079", slides=slides, hint=closest(slides, others)))
    rate = parts.names.canonical(entry.rate) if entry.rate else None
    return Link(key, points, rate, wheel, contact, slides)


def read_frame(entry: schema.Frame, parts: Parts) -> Frame:
    """Return the fixed link."""
    hinges = tuple(parts.known_point(("frame", "hinges", place), point) for place, point in enumerate(entry.hinges))

    def pairs(section: str, entries: Sequence[object], place: str, size: str, si: str) -> tuple[tuple[Formula, Formula], ...]:
        return tuple(
            (
                parts.formula(("frame", section, i, place), getattr(one, place), "vector"),
                parts.scalar(("frame", section, i, size), getattr(one, size), wanted=si),
            )
            for i, one in enumerate(entries)
        )

    return Frame(
        hinges, pairs("rails", entry.rails, "through", "angle", "rad"), pairs("circles", entry.circles, "center", "radius", "m")
    )
