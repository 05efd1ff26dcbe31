"""Dimensions for one group: the choices to try, the motion that each gives, and the one that is taken.

Enters: a kind, the paths over a whole turn of the points it hangs on, the body that may carry a guide.  Leaves: `Placement`,
rounded as it is written in a file.  Used by `chain.py`.

Nothing here knows a kind by its name: its shape says how many pivots, lengths and guides are free, and its `solve` whether a
choice closes.  The choices are tried in a fixed order, so that the same kinds always give the same file.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np

from coursework.mechanism.groups import AtDeadPoint, CannotAssemble, GroupKind, GroupMotion, Guide, Pair
from coursework.mechanism.groups.kind import Known
from coursework.mechanism.groups.plane import Vectors, vectors
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.vocabulary import GROUP_KINDS

ROWS, COARSE = 720, 30  # rows of a turn in which a choice must close; first it is tried in every 30th row only
_DIRECTIONS = range(0, 360, 15)  # degrees
_HALF = range(0, 180, 15)  # degrees; half a turn is enough, because a guide points both ways
# Sizes in units of the amplitude of the point a group hangs on: pivots, lengths, distances of guides from its middle.
_PIVOTS, _LENGTHS, _BESIDE = (2.5, 3.0, 4.0), (2.0, 2.5, 3.0, 4.0), (1.0, 2.0, 0.0)
_SOUND, _AMPLE = 0.3, 0.6  # absolute scaled determinants (0 to 1): smaller is too near a dead point; larger scores no better
_STILL = 0.1  # of the amplitude, or rad: a coordinate that moves less counts as still
_LIKE, _ROUND, _CLEAR = 0.3, 0.02, 0.3  # subtracted from a score: for another amplitude, per odd angle, per crowded or still item


@frozen
class End:
    """A point that a group may hang on: its `name` and its `path` (rows,) m during the motion.

    Its body turns with the coordinate `turns` through `angle` (rows,) rad; `turns` is "" if the body only translates.
    """

    name: str
    path: Vectors
    turns: str
    angle: Array

    @property
    def middle(self) -> complex:
        """Return the middle of the bounding box of the path (m)."""
        x, y = self.path.real, self.path.imag
        return complex(x.min() + x.max(), y.min() + y.max()) / 2

    @property
    def amplitude(self) -> float:
        """Return the largest distance of the path from its middle (m)."""
        return float(np.abs(self.path - self.middle).max())


@frozen
class Placement:
    """`pivots` (m), `fixed` guides as a point (m) and an angle (degrees), `lengths` (m), and the angle `carried` (degrees).

    `carried` is the angle of a guide on the body that carries it, None without such a guide.
    """

    pivots: tuple[complex, ...]
    fixed: tuple[tuple[complex, int], ...]
    lengths: tuple[float, ...]
    carried: int | None


def place(
    kind: GroupKind, ends: Sequence[End], carrier: End | None, taken: Sequence[complex]
) -> tuple[Placement, GroupMotion] | None:
    """Return the best placement of a group on `ends` and its motion in all rows, None if no choice closes.

    `taken` (m) are positions already occupied.
    """
    rated = [
        (_score(kind, found, trial, ends, carrier, taken), -number, trial)
        for number, trial in enumerate(_trials(kind, ends, carrier))
        if (found := _solved(kind, trial, ends, carrier, COARSE)) is not None
    ]
    for _, _, trial in sorted(rated, key=lambda entry: entry[:2], reverse=True):
        if (found := _solved(kind, trial, ends, carrier, 1)) is not None:
            return trial, found
    return None


def _trials(kind: GroupKind, ends: Sequence[End], carrier: End | None) -> Iterator[Placement]:
    shape = kind.shape
    hung = ends[0] if ends else carrier
    assert hung is not None
    middle, size = hung.middle, hung.amplitude
    if len(ends) > 1:
        size = float(np.abs(ends[0].path - ends[1].path).mean()) / 3
    unit = 10.0 ** (math.floor(math.log10(size * 1.05)) - 1)
    missing = shape.points - len(ends)
    pivots = [_near(middle, far * size, angle, unit) for far in _PIVOTS for angle in _DIRECTIONS]
    beside = [(_near(middle, off * size, angle + 90, unit), angle) for off in _BESIDE for angle in _HALF]
    fixed = shape.guides - (carrier is not None)
    for chosen in itertools.product(pivots, repeat=missing):
        for lengths in itertools.product(_LENGTHS, repeat=shape.lengths[-1]):
            rods = tuple(_rounded(part * size, unit) for part in lengths)
            for guides in itertools.product(beside, repeat=fixed):
                for angle in _DIRECTIONS if carrier is not None else (None,):
                    yield Placement(chosen, guides, rods, angle)


def _near(middle: complex, far: float, degrees: int, unit: float) -> complex:
    place = middle + far * complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
    return complex(_rounded(place.real, unit), _rounded(place.imag, unit))


def _rounded(value: float, unit: float) -> float:
    return round(round(value / unit) * unit, 9) + 0.0


def _solved(kind: GroupKind, trial: Placement, ends: Sequence[End], carrier: End | None, every: int) -> GroupMotion | None:
    """Return the motion of the group in every `every`-th row, None if it does not close or comes near a dead point."""
    points = [_pair(end.path[::every]) for end in ends] + [_pair(np.array([pivot])) for pivot in trial.pivots]
    guides = [Guide(_pair(np.array([through])), math.radians(angle)) for through, angle in trial.fixed]
    if carrier is not None and trial.carried is not None:
        guides.append(Guide(_pair(carrier.path[::every]), carrier.angle[::every] + math.radians(trial.carried)))
    known = Known(points, [np.array([length]) for length in trial.lengths], guides, np.zeros(1), None)
    assert kind.solve is not None
    try:
        found = kind.solve(known, 1)
    except (CannotAssemble, AtDeadPoint):
        return None
    return found if np.abs(found.scaled_determinant).min() >= _SOUND else None


def _pair(path: Vectors) -> Pair:
    return Pair(np.column_stack([path.real, path.imag]))


def _score(
    kind: GroupKind, found: GroupMotion, trial: Placement, ends: Sequence[End], carrier: End | None, taken: Sequence[complex]
) -> float:
    """Return how good a choice is: far from dead points, nothing still, the next point moves as far as this one, no crowding."""
    hung = ends[0] if ends else carrier
    assert hung is not None
    met = End("", vectors(found.meets.position), "", np.zeros(1))
    sound = min(float(np.abs(found.scaled_determinant).min()), _AMPLE)
    lively = met.amplitude / hung.amplitude
    odd = sum(angle % 90 != 0 for _, angle in trial.fixed) + ((trial.carried or 0) % 90 != 0)
    places = [met.middle, *trial.pivots, *(through for through, _ in trial.fixed)]
    crowded = sum(abs(new - old) < hung.amplitude for new in places for old in taken)
    angles = GROUP_KINDS[kind.name]
    scales = [1.0 if place < angles else hung.amplitude for place in range(found.coordinates.shape[1])]
    still = int((np.ptp(np.unwrap(found.coordinates, axis=0), axis=0) < _STILL * np.array(scales)).sum())
    return sound - _LIKE * abs(math.log2(max(lively, 1e-6))) - _ROUND * odd - _CLEAR * (crowded + still)
