"""Text of a TOML file -> the line and column of every key, which the standard reader does not keep.

Enters: TOML that the standard reader has accepted.  Leaves: `Positions`.  Used by `reader.py` only.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\]]+?)\s*\]\]?")
_KEY = re.compile(r"""\s*((?:"[^"]*"|'[^']*'|[\w-]+)(?:\s*\.\s*(?:"[^"]*"|'[^']*'|[\w-]+))*)\s*=\s*""")
_INNER_KEY = re.compile(r"""[{,]\s*("[^"]*"|'[^']*'|[\w-]+)\s*=\s*""")

Path = tuple[str | int, ...]


@dataclass(slots=True)
class Positions:
    """Line, column of the value (both from 1) of each key path; list entries are counted from 0."""

    places: dict[Path, tuple[int, int]] = field(default_factory=dict)

    def find(self, path: Path) -> tuple[int, int]:
        """Return (line, column) of the nearest known ancestor of `path`, (0, 0) if there is none."""
        while path:
            if path in self.places:
                return self.places[path]
            path = path[:-1]
        return (0, 0)


def locate(text: str) -> Positions:
    """Return the positions of all keys of `text`."""
    positions = Positions()
    table: Path = ()
    counts: dict[Path, int] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        if header := _HEADER.match(line):
            table = _split(header[2])
            if header[1] == "[[":
                counts[table] = counts.get(table, -1) + 1
                table = (*table, counts[table])
            positions.places.setdefault(table, (number, header.start(2) + 1))
        elif key := _KEY.match(line):
            path = (*table, *_split(key[1]))
            positions.places.setdefault(path, (number, key.end() + 1))
            for inner in _INNER_KEY.finditer(line, key.end()):
                positions.places.setdefault((*path, *_split(inner[1])), (number, inner.end() + 1))
    return positions


def _split(dotted: str) -> Path:
    parts = re.findall(r"""\s*(?:"([^"]*)"|'([^']*)'|([\w-]+))\s*""", dotted)
    return tuple(next(word for word in part if word) if any(part) else "" for part in parts)
