"""Why a motion under forces cannot be followed any further: its links, its free coordinates alone, or the forces.

Enters: `EquationsOfMotion`, the states passed since the last row.  Leaves: `Open`.
Used by `dynamics.py`, `scene/motor_scene.py`, `regime.py` and `grading/marking/key/free_rows.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

LIMIT = "limit position"  # of the free coordinates alone: a dead point that the links pass
CHANGE = "change point"
_NODES, _APART, _EXACT = 8, 1.5, 1e-4  # nodes of the polynomial, their ratio, the share from which a determinant is exact
_SMALL = 0.1  # a determinant below this share of its largest value counts as vanishing


class Open(ArithmeticError):
    """No closed position is nearby: the mechanism is at a dead point, or a step was too wide; `at` is the time (s), if known.

    `kind` is "too steep" if the forces, not the links, make the motion impossible to follow, `LIMIT` if the links move on and
    only the free coordinates turn back, and `CHANGE` if two motions meet.
    """

    def __init__(self, at: float = math.nan, kind: str = "dead point") -> None:
        super().__init__("no closed position")
        self.at, self.kind = at, kind


def why_ended(motion: EquationsOfMotion, at: float, passed: Sequence[Sequence[float]]) -> Open:
    """Return why a motion ends after its last state at `at` (s): a determinant vanishes, or the forces are too steep.

    `passed` holds time, all coordinates and free rates of the first row and of each state since the last row.  Near a vanishing
    determinant the other velocities are those of the free coordinates divided by it.  A link with mass cannot become that fast;
    then the free coordinates, or one motion that they make together, come to rest there and turn back.  Where other velocities
    stay finite whatever the free ones are, it is a change point.
    """
    rows = np.array(passed)
    if motion.others and len(rows) > 2:
        found = [np.abs(np.broadcast_to(one, len(rows))) for one in motion.table(*rows.T)]
        least = min(found[-motion.determinants :], key=lambda one: float(one[-1] / one.max()))
        if least[-1] < _SMALL * least.max():
            fastest = np.max([found[place] for place in motion.others], axis=0)
            reach = _reach(motion, rows)
            # The limit lies halfway: rates of massless links grow as 1/determinant, other rates do not grow at all.
            as_fast = fastest[-1] ** 2 * least[-1] < fastest[1] ** 2 * least[1]
            meet = reach[-1] ** 2 * least[-1] < reach[1] ** 2 * least[1]
            return Open(_vanishes(rows[:, 0], least), CHANGE if meet else LIMIT if as_fast else "dead point")
    return Open(at, "too steep")


def _reach(motion: EquationsOfMotion, rows: Array) -> Array:
    """Return the largest other velocity that a free rate of 1 gives in each row, with all other free rates at rest."""
    found, count = [], len(motion.free)
    for rates in (np.zeros(count), *np.eye(count)):
        table = motion.table(*np.column_stack([rows[:, :-count], np.tile(rates, (len(rows), 1))]).T)
        found.append([np.broadcast_to(table[place], len(rows)) for place in motion.others])
    return np.asarray(np.max(np.abs(np.array(found[1:]) - found[0]), axis=(0, 1)))


def _vanishes(t: Array, sizes: Array) -> float:
    """Return when (s) decreasing sizes vanish: the time is a polynomial in them, by Neville's rule.

    It is smooth there, whether links pass their limit, so that the determinant falls evenly, or stop, so that its square does.
    The last states are left out: their positions hardly close, so that their determinants are not exact.  It lies
    nearer to the last state than the first of those looked at does.
    """
    nodes = list[int]()
    for place in range(len(t) - 1, 0, -1):
        if sizes[place] >= (_APART * sizes[nodes[-1]] if nodes else _EXACT * sizes[1]) and len(nodes) < _NODES:
            nodes.append(place)
    at, found = sizes[nodes], t[nodes]
    for order in range(1, len(nodes)):
        found = (at[:-order] * found[1:] - at[order:] * found[:-1]) / (at[:-order] - at[order:])
    return float(np.clip(found[0], t[nodes[-1]], 2 * t[-1] - t[nodes[-1]]))


def laws_of_forces(variant: Variant) -> list[Formula]:
    """Return the formulas of loads and torques."""
    loads = variant.forces.loads if variant.forces is not None else ()
    torques = variant.motor.torques if variant.motor is not None else ()
    return [law for one in (*loads, *torques) if (law := one.torque or one.force) is not None]


def too_steep(variant: Variant) -> Iterator[Sentence]:
    """Yield what can make the forces of a file too steep."""
    constants = {*variant.values, "pi"}
    yield say("dynamics.steep_masses")
    if any(not constants.issuperset(law.names()) for law in laws_of_forces(variant)):
        yield say("dynamics.steep_laws")
    if variant.forces is not None and variant.forces.springs:
        yield say("dynamics.steep_springs")
