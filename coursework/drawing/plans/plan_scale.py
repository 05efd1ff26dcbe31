"""The scale of a plan, the vectors that are too short for it, and lengths as a ruler reads them.

Enters: `Polygons`, a plan and a row.  Leaves: `PlanScale`, arrows, lengths in mm.
Used by `polygon_sheet.py`, `steps.py`, `check_plan.py` and `readings.py`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursework.drawing.paper.board import vector_scale
from coursework.system.frozen import frozen

if TYPE_CHECKING:
    from coursework.drawing.plans.vectors import Polygons

LONGEST = 80.0  # mm: limit for the longest vector
SMALL = 4.0  # mm: a shorter vector is drawn again in the inset
SEEN = 1e-7  # relative to the longest vector: a shorter one is round-off
READ = 0.5  # mm: lengths are read to this

Arrow = tuple[str, str, str, complex, complex]


def read_length(length: float) -> float:
    """Return a length (mm) as a ruler reads it."""
    return round(length / READ) * READ


@frozen
class PlanScale:
    """The scale of a plan: `unit` m/s or m/s² per mm; in the inset short vectors are `times` as long, 1 if there is no inset."""

    unit: float
    times: int
    longest: float

    def length(self, size: float, drawn: bool = True) -> tuple[float, float]:
        """Return length on paper (mm) and scale of a vector of a size; only a vector that is `drawn` can be enlarged."""
        if size <= SEEN * self.longest:
            return 0.0, self.unit
        length = size / self.unit
        times = self.times if drawn and length < SMALL else 1
        return length * times, self.unit / times


def scale_of(found: Polygons, plan: str, index: int) -> PlanScale:
    """Return the scale of a plan of a row (from 0): the smallest of 1, 2, 5 · 10^k per mm with no vector over 80 mm."""
    arrows = arrows_of(found, plan, index)
    longest = max((abs(vector) for *_, vector in arrows), default=0.0)
    unit = vector_scale(longest, LONGEST)
    small = short_ones([(kind, start, end, at / unit, vector / unit) for kind, start, end, at, vector in arrows])
    return PlanScale(unit, enlarged(small), longest)


def arrows_of(found: Polygons, plan: str, row: int) -> list[Arrow]:
    """Return kind, start, end, tail and vector of each arrow; the parts of an acceleration follow each other tip to tail."""
    from coursework.drawing.plans.vectors import ACCELERATION

    segments = [s for s in found.segments if s.plan == plan]
    here = [(s.kind, s.start, s.end, complex(s.vector[row])) for s in segments]
    tips = {end: vector for kind, _, end, vector in here if kind == "absolute"}
    first = {(start, end): vector for kind, start, end, vector in here if kind in {"normal", "coriolis"}}
    arrows = []
    for (kind, start, end, vector), segment in zip(here, segments, strict=True):
        at = tips.get(start, 0j)
        if segment.begins is not None:
            at = complex(segment.begins[row])
        elif kind == "tangential" or (kind == "sliding" and plan == ACCELERATION):
            at += first[start, end]
        arrows.append((kind, start, end, at, vector))
    return arrows


def short_ones(mm: list[Arrow]) -> list[tuple[str, str, str, complex]]:
    """Return the vectors that a joint of the plan would hide: kind, start, end, vector (mm)."""
    longest = max((abs(vector) for *_, vector in mm), default=0.0)
    kept = {(start, end): (kind, start, end, vector) for kind, start, end, _, vector in mm
            if kind in {"absolute", "relative", "sliding"} and SEEN * longest < abs(vector) < SMALL}  # fmt: skip
    return list(kept.values())


def enlarged(small: list[tuple[str, str, str, complex]]) -> int:
    """Return how many times short vectors are enlarged: the least power of ten that makes the longest of them visible."""
    times, longest = 1, max((abs(vector) for *_, vector in small), default=SMALL)
    while longest * times < SMALL:
        times *= 10
    return times
