"""TABLE-DIGITS: what the last printed digit of a tabulated law, or the scatter of measured points, does to the velocities.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
A value rounded to the place q is off by up to q/2.  A derivative is a weighted sum of values, so at worst it is off by q/2 times
the sum of its weights' sizes.  The weights are found from tables of zeros with a single one.  Measured points that scatter by
twice their standard deviation to each side have this width in place of q.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from coursework.equations.codegen.tabulated import TableLaw
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.system import compile_system, compile_values
from coursework.results.checks.close_to_motion.drift import shortest_length
from coursework.results.checks.evidence import LIMIT, Evidence, scales_of
from coursework.results.checks.result import Finding, Verdict, percent, skipped
from coursework.system.arrays import Array, as_columns
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Law
from coursework.words.sentences import joined, say

# A table with more decimals than this was computed, not rounded for print.
_MOST_DECIMALS = 12
# Relative error with which a printed decimal is read and converted.
_ROUND_OFF = 1e-14
# Nodes of the tables from which weights are found: the ends have no influence on the middle node.
_NODES = 25
_MIDDLE = _NODES // 2
# Sixth differences of points that scatter by 1: sqrt(924) times as large, and sqrt(924/70) = 3.6 times the fourth ones; those of
# a smooth law with five nodes or more a period at most 1.4 times the fourth ones.
_SIXTH, _ALTERNATE, _FEWEST = 924**0.5, 2.5, 16
_MEDIAN = 0.6745  # of the size of a normal variable of unit deviation
_COMPUTED = 1e-9  # share of the range of a table: a smaller scatter is the round-off of a program


@frozen
class Noise:
    """The largest errors of one column that the rounding of the law `name`, or else its `scatter`, allows, in `unit`.

    `inside` and `end` are the errors inside the table and at its end; `worst` is the error in the rows, in `row` (from 0).
    `scale` is that of the column, `order` 1 for a velocity and 2 for an acceleration.
    """

    name: str
    decimals: int | None
    scatter: float
    column: str
    unit: str
    inside: float
    end: float
    worst: float
    row: int
    scale: float

    order: int

    @property
    def told(self) -> str:
        """Return the name of the column for a sentence; an acceleration is written as a derivative."""
        return self.column if self.order == 1 else f"d {self.column[1:]}/d t"

    @property
    def share(self) -> float:
        """Return the worst case as a share of the column's scale."""
        return self.worst / self.scale


def table_digits(evidence: Evidence) -> Finding:
    """The printed digits of every tabulated law leave velocities and accelerations within 5 % of their scales."""
    laws = [law for law in evidence.variant.laws if law.table]
    if not laws:
        return skipped(say("check.TABLE-DIGITS.skip"))
    if not len(evidence.exact.t) or evidence.restricted:
        return skipped(say("check.unknown"))
    found = [noise for law in laws for noise in _noises(evidence, law)]
    if not found:
        return Finding("PASS", say("check.TABLE-DIGITS.all", names=tuple(law.name for law in laws)))
    worst = max(found, key=lambda noise: noise.share)
    told = [
        say(
            f"check.TABLE-DIGITS.{'scatters' if noise.scatter else 'allows'}", decimals=noise.decimals, scatter=noise.scatter,
            name=noise.name, column=noise.told, inside=noise.inside, end=noise.end, unit=noise.unit, share=percent(noise.share),
        )
        for noise in found
    ]  # fmt: skip
    verdict: Verdict = "PASS" if worst.share <= LIMIT else "COARSE"
    if verdict == "COARSE":
        told.append(say("check.TABLE-DIGITS.smooth" if worst.scatter else "check.TABLE-DIGITS.coarse"))
    unit, row = say("unit.of_the_scale"), worst.row + 1
    return Finding(verdict, joined(told), worst.share, LIMIT, unit, worst.column, row, cured=False)


def decimals(law: Law) -> int | None:
    """Return the number of decimals that all values of a table share, None if there are too many for a printed table."""
    values = np.array([value for _, value in law.table])
    for count in range(_MOST_DECIMALS + 1):
        scaled = values * 10.0**count
        if np.all(np.abs(scaled - np.round(scaled)) <= _ROUND_OFF * np.maximum(1.0, np.abs(scaled))):
            return count
    return None


def scatter(law: Law) -> float:
    """Return twice the standard deviation with which the points of a table scatter about a smooth curve, 0 if they do not.

    Differences of high order of a smooth law are small; those of scattered points alternate.
    """
    nodes, values = np.array(law.table).T
    if len(values) < _FEWEST or not np.allclose(np.diff(nodes), np.diff(nodes)[0], rtol=1e-3):
        return 0.0
    fourth, sixth = (float(np.median(np.abs(np.diff(values, order)))) for order in (4, 6))
    deviation = sixth / _SIXTH / _MEDIAN
    return 2 * deviation if sixth > _ALTERNATE * fourth and deviation > _COMPUTED * np.ptp(values) else 0.0


@cache
def amplification(method: str, order: int) -> tuple[float, ...]:
    """Return half the sum of the sizes of a derivative's weights, for the nodes of a table from its end inwards.

    Multiplied by q/d^order (q the last place, d the spacing) this is the worst error of the derivative of `order` 0, 1 or 2: 0.5
    for the value itself; for the five-point formulas 0.75 inside and 5.33 at the end; applied twice 1.125 and 16.4.  The last
    entry holds for all inner nodes.
    """
    columns = []
    for place in range(_NODES):
        rows = tuple((float(node), float(node == place)) for node in range(_NODES))
        pieces = TableLaw("", rows, method).pieces[order]
        columns.append(np.append(pieces[:, 0], np.sum(pieces[-1])))
    sums = 0.5 * np.sum(np.abs(np.array(columns)), axis=0)
    return tuple(float(max(sums[place], sums[-1 - place])) for place in range(_MIDDLE + 1))


def _noises(evidence: Evidence, law: Law) -> list[Noise]:
    """Return the effect of rounding on the velocities that the law moves, and on their accelerations.

    For a law of position these come from its first and second derivative.  A drive is a velocity: the velocities have the
    rounding of its values, the accelerations that of its first derivative.
    """
    is_drive = law in evidence.variant.drive
    count = decimals(law)
    exact = evidence.exact
    last_place, scattered = 0.0 if count is None else 10.0**-count, scatter(law)
    if scattered <= last_place:  # it is the rounding
        scattered = 0.0
    width = 2 * scattered or last_place
    if not width or law.of not in {"t", *exact.names}:
        return []
    first, last = law.table[0][0], law.table[-1][0]
    spacing = (last - first) / (len(law.table) - 1)
    place = (exact.column(law.of) - first) / spacing
    from_end = np.clip(np.floor(np.minimum(place, len(law.table) - 1 - place)), 0, _MIDDLE).astype(int)
    rate = np.abs(_rate(evidence, law.of))
    moved = _moved_by(evidence, law.name) if is_drive else {}
    found = []
    for order in range(1, min(evidence.order, 2) + 1):
        derivative = order - 1 if is_drive else order
        weights = np.array(amplification(law.method, derivative))
        sizes = width / spacing**derivative * rate**derivative
        scales = _scales(evidence, order)
        if not scales:
            continue
        if is_drive:
            largest_of = {name: float(np.max(weights[from_end] * sizes * moved[name])) for name in scales if name in moved}
            column = max(largest_of, key=lambda name: largest_of[name] / scales[name], default="")
            if not column or not largest_of[column]:
                continue
            sizes = sizes * moved[column]
        else:
            column, lever = _touched(evidence, scales)
            sizes = sizes / lever
        worst = weights[from_end] * sizes
        row, largest = int(np.argmax(worst)), float(np.max(sizes))
        shown, unit = ("d" * (order - 1)) + column, evidence.unit(column) + ("²" if order == 2 else "")
        inside, end = float(weights[-1]) * largest, float(weights[0]) * largest
        share = float(worst[row]), row, scales[column]
        found.append(Noise(law.name, count, scattered, shown, unit, inside, end, *share, order))
    return found


def _rate(evidence: Evidence, argument: str) -> Array:
    """Return d argument/dt (n,)."""
    exact = evidence.exact
    rates = {coordinate.name: coordinate.rate for coordinate in evidence.variant.coordinates}
    return exact.column(rates[argument]) if argument in rates else np.gradient(exact.column(argument), exact.step)


def _scales(evidence: Evidence, order: int) -> dict[str, float]:
    """Return the scales of the judged velocities (`order` 1), or by the same rule of their derivatives (`order` 2)."""
    exact = evidence.exact
    names = [name for name in evidence.names if name in exact.velocity_names]
    if order == 1:
        return {name: evidence.scale[name] for name in names}
    columns = [np.gradient(exact.column(name), exact.step) for name in names]
    spreads, sizes = [float(np.ptp(column)) for column in columns], [float(np.max(np.abs(column))) for column in columns]
    return dict(
        zip(names, scales_of(spreads, sizes, [evidence.unit(name) for name in names], [1e-300] * len(names)), strict=True)
    )


def _touched(evidence: Evidence, scales: dict[str, float]) -> tuple[str, float]:
    """Return the column in which an error of a length shows most, and the lever (m) by which that error is divided.

    The error of a speed is that of the length; if no column is a speed, that of an angular velocity is divided by the shortest
    length.
    """
    speeds = [name for name in scales if evidence.unit(name) == "m/s"]
    column = min(speeds or scales, key=lambda name: scales[name])
    return column, 1.0 if speeds else shortest_length(evidence)


def _moved_by(evidence: Evidence, drive: str) -> dict[str, Array]:
    """Return by how much (n,) each unknown velocity changes with a drive, in the exact rows.

    The equations are linear in both: A u = b gives du = A⁻¹ db, and the accelerations change with the drive's derivative
    likewise.  The smaller effect of positions that drift with the drive's integral is left out.
    """
    exact, equations = evidence.exact, evidence.equations
    system = compile_system(equations, equations.equations)
    matrix, right, _ = system.matrices(exact.t, exact.coordinates)
    slopes = [equations.symbols.partial(equation.right_side, symbol(drive)) for equation in equations.equations]
    change = as_columns(compile_values(equations, slopes)[1](exact.t, *exact.coordinates.T), exact.t.shape)
    found = np.abs(np.linalg.pinv(matrix) @ change.reshape(right.shape)[..., None])[..., 0]
    for passage in evidence.passages:  # there the equations say 0 = 0
        found[passage.is_at(exact.t)] = 0.0
    return dict(zip(system.unknowns, found.T, strict=True))
