"""Variants of one template -> what they share: mechanism and velocity equations, made once for all of them.

Enters: a `Variant`.  Leaves: its `Mechanism` and `VelocityEquations`, which keep all that is found out about the structure.
Used by `way_to_motion.py` and `scene/model/model.py`: a class of five hundred differs in its data only.
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
    """What variants that differ in their data have in common; what is refused is not kept, so each is told by its own lines."""

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


@lru_cache(maxsize=64)  # a class has one or a few, and the catalogue, run again and again, fits whole
def structures(_without_data: Variant) -> Structure:
    """Return the structure of all variants that are the same without their data."""
    return Structure()


def structure_of(variant: Variant) -> Structure:
    """Return the structure of a variant: the same one for each that differs in its data only."""
    return structures(without_data(variant))


def without_data(variant: Variant) -> Variant:
    """Return a variant without its data: what all variants of one template have in common, lines of the file included."""
    return replace(
        variant, name="", path=None, title="", source="", teaches="", remarks=(), quotes=(), plausibility=(), ask=(),
        given=tuple(Given(given.name, 1.0, given.si, "", "") for given in variant.given),
        coordinates=tuple(Coordinate(c.name, c.rate, None, c.unit) for c in variant.coordinates),
        drive=tuple(map(_without_times, variant.drive)), functions=tuple(map(_without_times, variant.functions)),
        time=Time(1.0, 1.0, None, None), lines={}, forces=None,
    )  # fmt: skip


def _without_times(law: Law) -> Law:
    """Return a law without the times at which its pieces begin: they are numbers of each run, as the data are."""
    return replace(law, pieces=tuple((float(place), piece) for place, (_, piece) in enumerate(law.pieces)))
