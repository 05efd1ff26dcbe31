"""Special points (Assur's points) of a link that three legs hold: where the lines of two legs meet.

Enters: the motion, and what each leg determines at a point of the link.  Leaves: `SpecialPoint`s, the nearest first.
Used by `polygons.py`.
The line of a bar that leads to a point of the link is the bar's own; the line of a guide is the perpendicular to it.  All points
of the link on such a line have the same velocity component along it, which the leg gives; where two lines meet, two components
are known.  The image of that point lies on the lines of both legs, and from it the third leg is drawn as in a dyad.
Source: L. V. Assur, Groups of class III; I. I. Artobolevsky, Theory of mechanisms, method of special points.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import numpy as np

from coursework.drawing.plans.vectors import Line
from coursework.system.arrays import Complex
from coursework.system.frozen import frozen

PARALLEL = 1e-9  # sine of the angle below which two lines count as parallel
FAR = 5.0  # times the largest distance between the legs: a point farther away fits on no paper
LETTERS = ("S", "T", "U", "W", *(f"S{k}" for k in range(1, 100)))


@frozen
class Leg:
    """What holds a link at its `point`, at places `at` (n,): the image lies on `line`, which has the direction `along` (n,)."""

    point: str
    line: Line
    at: Complex
    along: Complex


@frozen
class SpecialPoint:
    """A point of a link, at places (n,), where the lines of two `legs` meet."""

    at: Complex
    legs: tuple[Leg, Leg]


def special_points(legs: Sequence[Leg], row: int) -> Iterator[SpecialPoint]:
    """Yield the special points of a link, the nearest in a row (from 0) first; none of parallel lines, and none far away.

    A point where the lines of all legs meet is left out: there the group has a dead point.
    """
    here = [complex(leg.at[row]) for leg in legs]
    reach = FAR * max(abs(a - b) for a, b in itertools.combinations(here, 2))
    found = []
    for pair in itertools.combinations(legs, 2):
        if pair[0].point == pair[1].point or (at := _meeting(*pair)) is None:
            continue
        way = max(abs(at[row] - place) for place in here)
        if way <= reach and any(_holds(leg, at, row) for leg in legs if leg not in pair):
            found.append((way, SpecialPoint(at, pair)))
    yield from (special for _, special in sorted(found, key=lambda one: one[0]))


def special_name(names: Sequence[str]) -> str:
    """Return a letter for a special point that is not the name of a point or an image.

    >>> special_name(["A", "s", "T"])
    'U'
    """
    taken = {name.lower() for name in names}
    return next(letter for letter in LETTERS if letter.lower() not in taken)


def _meeting(one: Leg, other: Leg) -> Complex | None:
    """Return where the lines of two legs meet (n,), None if they are parallel in some row."""
    first, second = 1j * one.along / np.abs(one.along), 1j * other.along / np.abs(other.along)
    sine = (first.conjugate() * second).imag
    if np.min(np.abs(sine)) <= PARALLEL:
        return None
    return np.asarray(one.at + first * ((other.at - one.at).conjugate() * second).imag / sine)


def _holds(leg: Leg, at: Complex, row: int) -> bool:
    """Return whether a leg keeps its link from turning about a place."""
    arm, along = complex(leg.at[row] - at[row]), complex(leg.along[row])
    return abs((arm.conjugate() * along).real) > PARALLEL * abs(along) * abs(arm)
