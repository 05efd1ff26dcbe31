"""What of a file has a fault already, so that nothing is said of what only follows from it.

Enters: paths with faults.  Leaves: `Broken`.
Used by `reader.py`, `whole_file.py` and `at_start.py`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from coursework.variant.formula.alphabet import spell_path
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath


class Broken:
    """Places of a file with a fault of their own."""

    def __init__(self, paths: Iterable[KeyPath] = ()) -> None:
        self._paths = {spell_path(path) for path in paths}
        self._around = {path[:length] for path in self._paths for length in range(len(path) + 1)}

    def has(self, *path: str | int) -> bool:
        """Return whether something at a path, in it, or around it has a fault."""
        return path in self._around or any(path[:length] in self._paths for length in range(len(path)))

    def sound(self, variant: Variant) -> Variant:
        """Return the variant without the data that stand in for faulty ones: what needs them has no value."""
        return replace(variant, given=tuple(given for given in variant.given if not self.has("given", given.name)))

    def without_groups(self, variant: Variant) -> Variant:
        """Return the variant with nothing in the place of a faulty group: of what kind it is, is not sure."""
        groups = tuple(
            replace(group, start_points=(), lengths=(), guides=(), coordinates=(), angle=None)
            if self.has("group", index)
            else group
            for index, group in enumerate(variant.groups)
        )
        return replace(variant, groups=groups)
