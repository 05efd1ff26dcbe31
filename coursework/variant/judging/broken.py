"""What of a file has a fault already, so that nothing is said of what only follows from it.

Enters: entries (section and key) with faults.  Leaves: `Broken`.
Used by `reader.py`, `whole_file.py` and `at_start.py`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from coursework.variant.formula.alphabet import spell
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath


class Broken:
    """Entries of a file with a fault of their own; a path of one key is a whole section."""

    def __init__(self, entries: Iterable[KeyPath] = ()) -> None:
        self._entries = {tuple(spell(part) if isinstance(part, str) else part for part in entry) for entry in entries}

    def has(self, *path: str | int) -> bool:
        """Return whether an entry, or its section, has a fault; of a path of one key whether anything in the section has."""
        if len(path) == 1:
            return any(entry[:1] == path for entry in self._entries)
        return path in self._entries or path[:1] in self._entries

    def sound(self, variant: Variant) -> Variant:
        """Return the variant without the data that stand in for faulty ones: what needs them has no value."""
        return replace(variant, given=tuple(given for given in variant.given if not self.has("given", given.name)))
