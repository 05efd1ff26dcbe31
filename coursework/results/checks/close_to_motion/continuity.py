"""CONTINUITY: the exact motion has no jump, and the table changes from row to row as the exact motion does.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
A large change in one interval is a jump only if it stays large however short the interval gets.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.geometry.drives.drive import breaks
from coursework.motion.integration.exact_motion import refine
from coursework.motion.integration.hermite import hermite
from coursework.results.checks.evidence import LIMIT, Evidence, worst
from coursework.results.checks.result import Finding, percent, skipped
from coursework.system.angles import whole_turns

Array = NDArray[Any]
HALVINGS = 40
# Fewest rows in which there is a change to judge.
_FEWEST_ROWS = 2
# A break within this share of its time of an interval counts as inside.
_AT_BREAK = 1e-9
# Just before a break, where the formula after it does not hold yet, rounding included.
_BEFORE = 1e-12
# A velocity that changes by less than this share of the largest goes on.
_GOES_ON = 1e-6
# A jump is judged against this share of the largest value near it, too: a pulse between two rows leaves no trace in their range.
_NEAR = 0.1
# Number of suspect intervals that are examined one by one.
_MOST_SUSPECTS = 5


class Jump(NamedTuple):
    """A change by `share` of the scale of `column` that remains at `time` (s), in the interval after row `row` (from 0)."""

    share: float
    column: str
    row: int
    time: float


def continuity(evidence: Evidence) -> Finding:
    """No curve jumps, and no change between two rows is off by more than 5 % of the scale."""
    if evidence.compared < _FEWEST_ROWS or not evidence.names:
        return skipped(evidence.say("check.CONTINUITY.skip"))
    unit = evidence.say("unit.of_the_scale")
    if (jump := evidence.once("jump", lambda: jump_of_exact(evidence))) is not None:
        sentence = evidence.say(
            "check.CONTINUITY.fail", name=jump.column, share=percent(jump.share), time=jump.time, row=jump.row + 1
        )
        return Finding("FAIL", sentence, jump.share, LIMIT, unit, jump.column, jump.row + 1)
    shares = np.abs(np.diff(evidence.errors, axis=0))
    row, place = worst(shares)
    name, value = evidence.names[place], float(shares[row, place])
    found = {"name": name, "share": percent(value), "row": row + 1, "next": row + 2}
    if value <= LIMIT:
        is_broken = _jumps_at_breaks(evidence)
        how = ("broken" if is_broken else "pass") if value else ("broken_same" if is_broken else "same")
        sentence = evidence.say(f"check.CONTINUITY.{how}", **found)
        return Finding("PASS", sentence, value, LIMIT, unit, name, row + 1)
    return Finding("COARSE", evidence.say("check.CONTINUITY.coarse", **found), value, LIMIT, unit, name, row + 1)


def jump_of_exact(evidence: Evidence) -> Jump | None:
    """Return the largest jump of the exact motion away from the breaks of `pieces` laws, None if there is none."""
    exact = evidence.exact
    if len(exact.t) < 2 or evidence.restricted:
        return None
    found = _suspects(evidence)
    for time in breaks(evidence.variant):
        begin, end = (exact.t[found.row] + part * exact.step for part in (found.left, found.right))
        found = found.kept(~((begin * (1 - _AT_BREAK) <= time) & (time <= end * (1 + _AT_BREAK))))
    order = np.argsort(-np.nan_to_num(found.shares(evidence), nan=np.inf), kind="stable")[:_MOST_SUSPECTS]
    jumps = (_looked_into(evidence, int(found.row[place]), int(found.column[place])) for place in order)
    return max((jump for jump in jumps if jump is not None), default=None)


def _jumps_at_breaks(evidence: Evidence) -> bool:
    """Return whether a velocity jumps at a break of a `pieces` law, which may also go on from the value that it had."""
    exact = evidence.exact
    times = np.array([time for time in breaks(evidence.variant) if exact.t[0] < time < exact.t[-1]])
    if not len(times):
        return False
    row = np.searchsorted(exact.t, times, side="right") - 1
    _, position = _between(evidence, row, (times - exact.t[row]) / exact.step)
    try:
        before, after = (evidence.rates.table(at, position)[0] for at in (times * (1 - _BEFORE), times))
    except (ArithmeticError, ValueError, OutsideTable):
        return True
    return not np.allclose(before, after, rtol=_GOES_ON, atol=_GOES_ON * float(np.abs(exact.velocities).max()))


class _Brackets(NamedTuple):
    """Parts of intervals, one for each (`row`, `column`): from share `left` to `right`, with the values `low` and `high`."""

    row: Array
    column: Array
    left: Array
    right: Array
    low: Array
    high: Array

    def kept(self, chosen: Array) -> _Brackets:
        return _Brackets(*(part[chosen] for part in self))

    def shares(self, evidence: Evidence) -> Array:
        change = self.high - self.low
        change = np.abs(np.where(evidence.angles[self.column], change - whole_turns(change), change))
        least = np.array([evidence.least(name) for name in evidence.names])
        return np.where(change < least[self.column], 0.0, change / evidence.scales[self.column])


def _suspects(evidence: Evidence) -> _Brackets:
    """Return the changes that stay large, however often halved, on the cubics through the exact rows.

    These cubics have the exact positions and rates at the rows; they can jump only where the motion jumps.  Every interval and
    column is halved by itself, and the half with the larger change is kept.
    """
    exact, rates = evidence.exact, evidence.rates
    places = np.array([exact.names.index(name) for name in evidence.names])
    table = exact.rows[:, places]
    row, column = (part.ravel() for part in np.indices((len(table) - 1, len(places))))
    found = _Brackets(
        row, column, np.zeros(len(row)), np.ones(len(row)), table[row, column], table[row + 1, column],
    )  # fmt: skip
    for _ in range(HALVINGS):
        found = found.kept(~(found.shares(evidence) <= LIMIT))
        if not len(found.row):
            return found
        middle = (found.left + found.right) / 2
        time, position = _between(evidence, found.row, middle)
        with np.errstate(all="ignore"):
            try:
                values = np.hstack([position, rates.table(time, position)[0]])[np.arange(len(time)), places[found.column]]
            except (ArithmeticError, ValueError, OutsideTable):
                values = np.full(len(time), np.nan)
        first, second = found._replace(right=middle, high=values), found._replace(left=middle, low=values)
        is_first = ~(first.shares(evidence) <= second.shares(evidence))
        found = _Brackets(*(np.where(is_first, one, other) for one, other in zip(first, second, strict=True)))
    return found.kept(~(found.shares(evidence) <= LIMIT))


def _between(evidence: Evidence, row: Array, part: Array) -> tuple[Array, Array]:
    """Return times and positions (n, m) at a `part` of the interval after each row, on the cubics through the exact rows."""
    exact = evidence.exact
    size, h = exact.coordinates.shape[1], exact.step
    begin, end = exact.coordinates[row], exact.coordinates[row + 1]
    out, into = h * exact.velocities[row, :size], h * exact.velocities[row + 1, :size]
    return exact.t[row] + part * h, hermite(begin, end, out, into, part[:, None])


def _looked_into(evidence: Evidence, row: int, place: int) -> Jump | None:
    """Return the jump of one column of the exact motion itself in one interval, None if there is none."""
    exact, rates, name = evidence.exact, evidence.rates, evidence.names[place]
    index, scale = exact.names.index(name), evidence.scales[place]

    def value(time: float, q: Array) -> float:
        return float(np.array([*q, *rates.evaluate(time, *q.tolist())])[index])

    begin, end = float(exact.t[row]), float(exact.t[row + 1])
    q, low, high = exact.coordinates[row], float(exact.rows[row, index]), float(exact.rows[row + 1, index])
    try:
        for _ in range(HALVINGS):
            middle = (begin + end) / 2
            there = refine(rates, q.tolist(), np.array([begin, middle]))[0][-1]
            between = value(middle, there)
            if abs(between - low) > abs(high - between):
                end, high = middle, between
            else:
                begin, q, low = middle, there, between
            scale = max(scale, _NEAR * abs(between))
            if abs(high - low) <= LIMIT * scale:
                return None
    except (ArithmeticError, ValueError, OutsideTable):
        return None  # no value there: the motion is unknown inside this interval, so nothing is said against it
    return Jump(abs(high - low) / scale, name, row, begin)
