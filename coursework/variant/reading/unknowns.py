"""An unknown velocity as a file gives it: its unit, and which velocity of the geometry it is.

Enters: checked entries of [unknowns].  Leaves: name and SI unit, and a `Binding`; faults stay with the `Parts`.
Used by `reader.py`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from coursework.variant.reading import schema
from coursework.variant.reading.parts import Parts
from coursework.variant.record.variant import Binding
from coursework.words.sentences import closest, say

_OF_LINK = re.compile(r"link\s+(\S+)\Z")
_SPEED, _RATE = "m/s", "1/s"


def read_unknown(key: str, entry: str | schema.Unknown, parts: Parts) -> tuple[str, str]:
    """Return name and SI unit of an unknown velocity."""
    if isinstance(entry, str):
        return parts.names.canonical(key), parts.unit(("unknowns", key), entry)
    return parts.names.canonical(key), parts.unit(("unknowns", key, "unit"), entry.unit)


def read_binding(
    key: str, entry: str | schema.Unknown, unknowns: Mapping[str, str], file: schema.VariantFile, parts: Parts
) -> Binding | None:
    """Return which velocity of the geometry an unknown is, None where its entry does not say; `unknowns` has the SI units."""
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
        if link and links and link not in links:  # in a chain of groups links have the numbers of their rates
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
