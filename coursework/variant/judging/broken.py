"""The parts of a file that already have a fault, so that consequences of this fault are not reported.

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
    """The places of a file that have a fault of their own."""

    def __init__(self, paths: Iterable[KeyPath] = ()) -> None:
        self._paths = {spell_path(path) for path in paths}
        self._around = {path[:length] for path in self._paths for length in range(len(path) + 1)}

    def has(self, *path: str | int) -> bool:
        """Return whether there is a fault at a path, inside it, or around it."""
        return path in self._around or any(path[:length] in self._paths for length in range(len(path)))

    def sound(self, variant: Variant) -> Variant:
        """Return the variant without the stand-ins of faulty data, so that formulas with such data have no value."""
        return replace(variant, given=tuple(given for given in variant.given if not self.has("given", given.name)))

    def without_doubtful(self, variant: Variant) -> Variant:
        """Return the variant with each faulty group emptied, because its kind is uncertain, and faulty unknowns of any unit."""
        groups = tuple(
            replace(group, start_points=(), lengths=(), guides=(), coordinates=(), angle=None)
            if self.has("group", index)
            else group
            for index, group in enumerate(variant.groups)
        )
        unknowns = tuple((name, "" if self.has("unknowns", name) else si) for name, si in variant.unknowns)
        return replace(variant, groups=groups, unknowns=unknowns)
