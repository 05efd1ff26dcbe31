"""The mechanism and velocity equations that all variants of one template share, made once.

Enters: a `Variant`.  Leaves: its `Mechanism` and `VelocityEquations`, which keep all facts found about the structure.
Used by `way_to_motion.py` and `scene/model/model.py`: the variants of a class of five hundred differ only in their data.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from coursework.equations.reduction.equations import VelocityEquations, differentiate
from coursework.mechanism.mechanism import Mechanism, build
from coursework.system.frozen import changing
from coursework.variant.record.variant import Coordinate, Given, Law, Time, Variant


@changing
class Structure:
    """What variants that differ only in their data share; errors are not kept, so each variant reports its own lines."""

    _mechanism: Mechanism | None = None
    _equations: VelocityEquations | None = None

    def mechanism(self, variant: Variant) -> Mechanism:
        """Return the mechanism of one of the variants.  Raises `InputError` as `build` does."""
        self._mechanism = self._mechanism or build(variant)
        return replace(self._mechanism, variant=variant)

    def equations(self, mechanism: Mechanism) -> VelocityEquations:
        """Return the velocity equations of one of the variants.  Raises `InputError` as `differentiate` does."""
        self._equations = self._equations or differentiate(mechanism)
        return replace(self._equations, variant=mechanism.variant)


@lru_cache(maxsize=64)  # a class has one or a few, and the whole catalogue fits when it is run repeatedly
def structures(_without_data: Variant) -> Structure:
    """Return the structure of all variants that are equal without their data."""
    return Structure()


def structure_of(variant: Variant) -> Structure:
    """Return the structure of a variant, which it shares with all variants that differ only in their data."""
    return structures(without_data(variant))


def without_data(variant: Variant) -> Variant:
    """Return a variant without its data and lines: the part that all variants of one template have in common."""
    return replace(
        variant, name="", path=None, title="", source="", teaches="", remarks=(), quotes=(), plausibility=(), ask=(),
        given=tuple(Given(given.name, 1.0, given.si, "", "") for given in variant.given),
        coordinates=tuple(Coordinate(c.name, c.rate, None, c.unit) for c in variant.coordinates),
        drive=tuple(map(_without_times, variant.drive)), functions=tuple(map(_without_times, variant.functions)),
        time=Time(1.0, 1.0, None, None), lines={}, forces=None,
    )  # fmt: skip


def _without_times(law: Law) -> Law:
    """Return a law with numbers in place of the times at which its pieces begin, because these are data of each run."""
    return replace(law, pieces=tuple((float(place), piece) for place, (_, piece) in enumerate(law.pieces)))
