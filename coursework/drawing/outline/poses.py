"""Rows of a motion -> positions of the points of an outline, driven velocities, and how far sliders travel.

Enters: an `Outline`, velocity equations and motions.  Leaves: `Poses`, points as complex numbers x + iy in m.
Used by `drawing/figures.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from coursework.drawing.outline.outline import Outline, Rail, Slot
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import Symbols, Vector, symbol
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, with_names


@frozen
class Poses:
    """Positions `at` (name -> (n,), m) of an outline's points, and values `drive` of laws (name -> (n,)) at times `t`."""

    t: Array
    at: Mapping[str, Complex]
    drive: Mapping[str, Array]

    def pose(self, row: int) -> dict[str, complex]:
        """Return the positions of one row (from 0)."""
        return {name: complex(places[row]) for name, places in self.at.items()}

    def velocity(self, name: str) -> Complex:
        """Return the driven velocity of a point (m/s); a component that no law gives is 0."""
        none = np.zeros(len(self.t))
        return np.asarray(self.drive.get(f"V{name}x", none) + 1j * self.drive.get(f"V{name}y", none))

    def along(self, base: str, toward: str) -> Complex:
        """Return the unit vectors from one point to another."""
        return unit_vectors(self.at[toward] - self.at[base])

    def line(self, slot: Slot) -> tuple[float, float, float]:
        """Return the offset of a slot's line from its point (m, to the left), and the range of its riders along the line."""
        along, at = self.along(slot.base, slot.toward), self.at[slot.at]
        places = [(self.at[rider] - at) * along.conjugate() for rider in slot.riders]
        beside = float(places[0][0].imag)
        return beside, float(min(np.min(p.real) for p in places)), float(max(np.max(p.real) for p in places))

    def slot_ends(self, slot: Slot) -> tuple[Complex, Complex]:
        """Return the ends (n,) of the line on which riders slide: from beside the slot's point to the farthest riders."""
        along, (beside, low, high) = self.along(slot.base, slot.toward), self.line(slot)
        start = self.at[slot.at] + 1j * along * beside
        return np.asarray(start + along * min(low, 0.0)), np.asarray(start + along * max(high, 0.0))

    def travel(self, rail: Rail) -> tuple[complex, complex, float, float]:
        """Return a point on a rail, its direction, and the least and greatest distance of its rider from there along it (m)."""
        start, along = complex(self.at[rail.at][0]), complex(self.along(rail.base, rail.toward)[0])
        ways = ((self.at[rail.rider] - start) * along.conjugate()).real if rail.rider else np.zeros(1)
        return start, along, float(ways.min()), float(ways.max())


def unit_vectors(way: Complex) -> Complex:
    """Return the unit vectors (n,) of vectors (n,), 0 for a vector of length 0."""
    return np.asarray(way / np.where(way == 0, 1, np.abs(way)))


def drawn_vectors(outline: Outline, symbols: Symbols) -> list[Vector]:
    """Return the points of an outline as expressions; a joint without a name in the file has its letter on the drawing only."""
    drawn = dict(outline.points)

    def known(name: Formula) -> Formula:
        return name if name.name in symbols.vectors or name.name not in drawn else with_names(drawn[name.name], known)

    return [symbols.vectors.get(name) or symbols.vector(with_names(formula, known)) for name, formula in outline.points]


def read_poses(outline: Outline, equations: VelocityEquations) -> Callable[[Array, Array], Poses]:
    """Return `read(t, coordinates)` for rows (n,) and (n, m), compiled once."""
    wanted = [part for vector in drawn_vectors(outline, equations.symbols) for part in vector]
    laws = tuple(law.name for law in equations.variant.drive)
    names = tuple(name for name, _ in outline.points)
    rows = compile_rows(equations, [*wanted, *map(symbol, laws)], 0)

    def read(t: Array, coordinates: Array) -> Poses:
        values = rows(t, coordinates)
        at = {name: values[:, 2 * k] + 1j * values[:, 2 * k + 1] for k, name in enumerate(names)}
        return Poses(t, at, dict(zip(laws, values[:, 2 * len(names) :].T, strict=True)))

    return read


def all_rows(equations: VelocityEquations, motion: Motion) -> bool:
    """Return whether a motion has all coordinates; a motion restricted to some columns does not."""
    return len(motion.coordinate_names) == len(equations.variant.coordinates)
