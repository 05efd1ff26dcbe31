"""A name that a file forgot to declare, and writes in several places: one fault, with the lines, and that to add for a point.

Enters: the faults of a file, and its names.  Leaves: the faults.  Used by `reader.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from coursework.variant.reading.names import Names
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, ranges, say

_AS_POINT, _AS_SYMBOL = "V059", "V053"


def told_once(faults: Sequence[Fault], names: Names) -> list[Fault]:
    """Return the faults; those about one name that is missing in several places become one."""
    asked: dict[str, list[Fault]] = {}
    for fault in faults:
        if fault.code in {_AS_POINT, _AS_SYMBOL}:
            asked.setdefault(names.canonical(str(fault.message.values["name"])), []).append(fault)
    kept = list(faults)
    for name, found in asked.items():
        if len(found) > 1:
            first = min(found, key=lambda fault: (fault.line, fault.column))
            told = _told(name, first, found, names)
            kept = [
                replace(first, message=told) if fault is first else fault
                for fault in kept
                if fault is first or fault not in found
            ]
    return kept


def _told(name: str, first: Fault, found: Sequence[Fault], names: Names) -> Sentence:
    """Return what is said at the `first` of the places in which one name is missing."""
    lines = ranges(sorted({fault.line for fault in found}))
    if any(fault.code == _AS_POINT for fault in found):
        places = [coordinate if names.kinds.get(coordinate) == "given" else "0" for coordinate in (f"x{name}", f"y{name}")]
        line = f'{name} = "({", ".join(places)})"'
        return say("fault.V165", name=name, lines=lines, line=line)
    if all(fault.line == first.line for fault in found):
        return first.message
    known: dict[str, Any] = dict(first.message.values)
    return say(first.message.key, **{**known, "hint": joined([known["hint"], say("fault.part.stands", lines=lines)])})
