"""Sections of a file as records: unknown velocities, times, quoted rows, groups of a chain, links, the frame.

Enters: checked sections of a file.  Leaves: records of `record/`; the faults are collected by `Parts`.  Used by `reader.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence

from coursework.variant.formula.tree import Formula
from coursework.variant.reading import schema
from coursework.variant.reading.parts import Parts
from coursework.variant.reading.stand_ins import NAMELESS
from coursework.variant.record.variant import MAX_ROWS, Binding, Frame, Group, Guide, Link, Quote, Time, whole_steps
from coursework.variant.record.vocabulary import OF_FORCES, scheme_hint, scheme_names
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentences import closest, say

_OF_LINK = re.compile(r"link\s+(\S+)\Z")
_SPEED, _RATE = "m/s", "1/s"


def read_unknown(key: str, entry: str | schema.Unknown, parts: Parts) -> tuple[str, str]:
    """Return name and SI unit of an unknown velocity."""
    path, unit = (("unknowns", key), entry) if isinstance(entry, str) else (("unknowns", key, "unit"), entry.unit)
    return parts.names.canonical(key), parts.unit(path, unit)


def read_binding(
    key: str, entry: str | schema.Unknown, unknowns: Mapping[str, str], file: schema.VariantFile, parts: Parts
) -> Binding | None:
    """Return which velocity of the geometry an unknown is, None if its entry does not say; `unknowns` gives the SI units."""
    name, path = parts.names.canonical(key), ("unknowns", key)
    if isinstance(entry, str):
        return None
    relative = "" if entry.relative is None else str(entry.relative)
    if entry.of is None:
        if entry.along is not None or relative:
            point, link = next(reversed(file.points), "B"), next(iter(file.links), "4")
            parts.say(path, say("fault.V150", name=key, unit=entry.unit, point=point, link=link))
        return None
    of_link = _OF_LINK.match(entry.of.strip())
    links = [*file.links]
    for at, link in (("of", of_link[1] if of_link else ""), ("relative", relative)):
        if link and links and link not in links:  # in a chain of groups, links are named by the numbers of their rates
            parts.say((*path, at), say("fault.V151", link=link, hint=closest(link, links)))
    wanted = _RATE if of_link else _SPEED
    if unknowns[name] and unknowns[name] != wanted:
        of = say("fault.bound.link", link=of_link[1]) if of_link else say("fault.bound.point", point=entry.of)
        parts.say((*path, "unit"), say("fault.V152", name=key, of=of, unit=wanted, found=entry.unit))
    if of_link:
        if entry.along is not None:
            parts.say((*path, "along"), say("fault.V153", name=key, link=of_link[1]))
        return Binding(name, link=of_link[1], relative=relative)
    point = parts.known_point((*path, "of"), entry.of)
    if entry.along is None:
        parts.say(path, say("fault.V154", name=key, unit=entry.unit, point=entry.of))
        return None
    along = parts.scalar((*path, "along"), entry.along, wanted="rad")
    return Binding(name, point, along=along, relative=relative)


def read_time(entry: schema.Time, parts: Parts) -> Time:
    """Return step, end, period, row of the check and scheme."""
    step = parts.number(("time", "step"), entry.step, "s")
    end = parts.number(("time", "end"), entry.end, "s")
    period = None if entry.period is None else parts.number(("time", "period"), entry.period, "s")
    if step <= 0:
        parts.say(("time", "step"), say("fault.V063", step=step))
    elif end < step * (1 - 1e-9):
        parts.say(("time", "end"), say("fault.V071", end=end, step=step))
    elif MAX_ROWS < end / step < math.inf:  # a value that is not finite has its own fault
        parts.say(("time", "end"), say("fault.V076", number=end / step, max_rows=MAX_ROWS))
    elif parts.broken.isdisjoint({("time", "step"), ("time", "end")}) and math.isfinite(end / step):
        rows = whole_steps(step, end) + 1
        if entry.check_row is not None and entry.check_row > rows:
            parts.say(("time", "check_row"), say("fault.V077", check_row=entry.check_row, number=rows))
    if period is not None and period <= 0:
        parts.say(("time", "period"), say("fault.V064", period=period))
    return Time(step, end, period, entry.check_row, scheme=_scheme(entry.scheme, ("time", "scheme"), parts))


def _scheme(name: str | None, path: KeyPath, parts: Parts) -> str:
    """Return the name of a scheme, "" for none."""
    names = (*scheme_names(), *(OF_FORCES if "motor" in parts.source.data else ()))
    if name is not None and name not in names:
        parts.say(path, say("fault.V065", name=name, hint=scheme_hint(name, names), known=", ".join(names)))
    return name or ""


def read_quote(place: int, entry: schema.Quote, columns: list[str], time: Time, parts: Parts) -> Quote:
    """Return a number that a remark quotes."""
    if time.step > 0 and math.isfinite(time.end / time.step) and entry.row > time.steps + 1:
        parts.say(("quote", place, "row"), say("fault.V066", row=entry.row, number=time.steps + 1))
    column = parts.names.canonical(entry.column)
    if column not in columns:
        parts.undeclared(
            ("quote", place, "column"),
            {"coordinate", "rate", "unknown"},
            say("fault.V067", column=column, hint=closest(column, columns)),
        )
    return Quote(entry.row, column, entry.value.replace("−", "-"), _scheme(entry.scheme, ("quote", place, "scheme"), parts))


def read_group(index: int, entry: schema.Group, parts: Parts) -> Group:
    """Return one group of a chain, or its crank."""
    path = ("group", index)
    parts.once((*path, "from"), entry.start_points)

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
    known = [parts.names.canonical(name) for name, kind, _ in parts.names.declarations if kind == "coordinate"]
    for place, coordinate in enumerate(entry.coordinates):
        if coordinate != NAMELESS and parts.names.canonical(coordinate) not in known:
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
    if key == "0":
        parts.say(("links", key), say("fault.V163"))
    points = tuple(parts.known_point(("links", key, "points", place), point) for place, point in enumerate(entry.points))
    parts.once(("links", key, "points"), points)
    roles = (("wheel", entry.wheel), ("contact", entry.contact))
    wheel, contact = (parts.known_point(("links", key, role), name) if name else None for role, name in roles)
    if entry.rate and parts.names.canonical(entry.rate) not in parts.names.velocities:
        is_formula = any(sign in entry.rate for sign in "+-*/(")
        minus, negated = entry.rate.strip()[:1], entry.rate.strip()[1:].strip()
        clockwise = minus in {"-", "−"} and parts.names.canonical(negated) in parts.names.velocities
        one_name = "hint.one_name_clockwise" if clockwise else "hint.one_name"
        hint = parts.names.meant(entry.rate.partition("/")[0]) or (
            say(one_name, formula=entry.rate) if is_formula or clockwise else closest(entry.rate.strip(), parts.names.velocities)
        )
        text = say("fault.V078", rate=entry.rate, hint=hint)
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
    parts.once(("frame", "hinges"), hinges)

    def pairs(section: str, entries: Sequence[object], place: str, size: str, si: str) -> tuple[tuple[Formula, Formula], ...]:
        return tuple(
            (
                parts.formula(("frame", section, i, place), getattr(one, place), "vector"),
                parts.scalar(("frame", section, i, size), getattr(one, size), "still", wanted=si),
            )
            for i, one in enumerate(entries)
        )

    return Frame(
        hinges, pairs("rails", entry.rails, "through", "angle", "rad"), pairs("circles", entry.circles, "center", "radius", "m")
    )
