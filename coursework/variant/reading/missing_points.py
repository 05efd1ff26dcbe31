"""A point that a file forgot, and names in several places: one fault, with the line to add.

Enters: the faults of a file, and its names.  Leaves: the faults.  Used by `reader.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from coursework.variant.reading.names import Names
from coursework.words.errors import Fault
from coursework.words.sentences import ranges, say

_AS_POINT, _AS_SYMBOL = "V059", "V053"


def told_once(faults: Sequence[Fault], names: Names) -> list[Fault]:
    """Return the faults; those about one name that is missing in several places, and a point in one of them, become one."""
    asked: dict[str, list[Fault]] = {}
    for fault in faults:
        if fault.code in {_AS_POINT, _AS_SYMBOL}:
            asked.setdefault(names.canonical(str(fault.message.values["name"])), []).append(fault)
    kept = list(faults)
    for name, found in asked.items():
        if len(found) > 1 and any(fault.code == _AS_POINT for fault in found):
            places = [coordinate if names.kinds.get(coordinate) == "given" else "0" for coordinate in (f"x{name}", f"y{name}")]
            line = f'{name} = "({", ".join(places)})"'
            first = min(found, key=lambda fault: (fault.line, fault.column))
            told = say("fault.V165", name=name, lines=ranges(fault.line for fault in found), line=line)
            kept = [
                replace(first, message=told) if fault is first else fault
                for fault in kept
                if fault is first or fault not in found
            ]
    return kept
