"""TABLE-DIGITS: what the last printed digit of a tabulated law does to the velocities and accelerations.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
A value rounded to the place q lies up to q/2 beside the true one; a derivative is a weighted sum of values, so in the worst
case it is off by q/2 times the sum of the sizes of its weights.  The weights are read off tables of zeros with a single one.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from coursework.checks.drift import shortest_length
from coursework.checks.evidence import LIMIT, OF_SIZE, OF_UNIT, Evidence
from coursework.checks.result import Finding, percent, skipped
from coursework.codegen.tabulated import TableLaw
from coursework.sentences import joined, say
from coursework.variant.record import Law

Array = NDArray[np.float64]
# A table with more decimals than this was computed, not rounded for print.
_MOST_DECIMALS = 12
# A number read and converted lies this part of itself beside the decimal it was printed as.
_ROUND_OFF = 1e-14
# Nodes of the tables of weights: the middle one is beyond the reach of both ends.
_NODES = 25
_MIDDLE = _NODES // 2


@dataclass(frozen=True, slots=True)
class Noise:
    """What the rounding of the law `name` allows one column to be off: `inside` the table, at its `end`, and where the rows
    are (`worst`, in row `row` from 0), in `unit`; `scale` of the column.
    """

    name: str
    decimals: int
    column: str
    unit: str
    inside: float
    end: float
    worst: float
    row: int
    scale: float

    @property
    def share(self) -> float:
        """Return the worst case as a share of the column's scale."""
        return self.worst / self.scale


def table_digits(evidence: Evidence) -> Finding:
    """The printed digits of every tabulated law leave velocities and accelerations within 5 % of their scales."""
    laws = [law for law in (*evidence.variant.drive, *evidence.variant.functions) if law.table]
    if not laws:
        return skipped(say("check.TABLE-DIGITS.skip"))
    if evidence.exact is None or not len(evidence.exact.t) or evidence.restricted:
        return skipped(say("check.unknown"))
    found = [noise for law in laws for noise in _noises(evidence, law)]
    if not found:
        return Finding("PASS", say("check.TABLE-DIGITS.all", names=tuple(law.name for law in laws)))
    worst = max(found, key=lambda noise: noise.share)
    told = [
        say(
            "check.TABLE-DIGITS.allows", decimals=noise.decimals, name=noise.name, column=noise.column, inside=noise.inside,
            end=noise.end, unit=noise.unit, share=percent(noise.share),
        )
        for noise in found
    ]  # fmt: skip
    verdict = "PASS" if worst.share <= LIMIT else "COARSE"
    if verdict == "COARSE":
        told.append(say("check.TABLE-DIGITS.coarse"))
    return Finding(
        "PASS" if verdict == "PASS" else "COARSE", joined(told), worst.share, LIMIT, say("unit.of_the_scale"), worst.column,
        worst.row + 1, cured=False,
    )  # fmt: skip


def decimals(law: Law) -> int | None:
    """Return the decimals that all values of a table share, None where they are too many to have been printed."""
    values = np.array([value for _, value in law.table])
    for count in range(_MOST_DECIMALS + 1):
        scaled = values * 10.0**count
        if np.all(np.abs(scaled - np.round(scaled)) <= _ROUND_OFF * np.maximum(1.0, np.abs(scaled))):
            return count
    return None


@cache
def amplification(method: str, order: int) -> tuple[float, ...]:
    """Return for the nodes of a table, the nearest end first, half the sum of the sizes of the weights of its derivative.

    Times q/d^order, q the last place and d the spacing, that is the worst case of the derivative of `order` 0, 1 or 2: 0.5 of
    the value itself; for the five-point formulas 0.75 inside and 5.33 at the end; applied twice 1.125 and 16.4.  The last
    entry holds inside.
    """
    columns = []
    for place in range(_NODES):
        rows = tuple((float(node), float(node == place)) for node in range(_NODES))
        pieces = TableLaw("", rows, method).pieces[order]
        columns.append(np.append(pieces[:, 0], np.sum(pieces[-1])))
    sums = 0.5 * np.sum(np.abs(np.array(columns)), axis=0)
    return tuple(float(max(sums[place], sums[-1 - place])) for place in range(_MIDDLE + 1))


def _noises(evidence: Evidence, law: Law) -> list[Noise]:
    """Return what rounding does to the velocities that the law moves, and to their accelerations.

    A law of position has them as its first and second derivative; a drive is a velocity, so its table is one derivative
    further: the velocities have its own rounding, the accelerations that of its first derivative.
    """
    is_drive = law in evidence.variant.drive
    count = decimals(law)
    exact = evidence.exact
    assert exact is not None
    if count is None or law.of not in {"t", *exact.names}:
        return []
    first, last = law.table[0][0], law.table[-1][0]
    spacing = (last - first) / (len(law.table) - 1)
    place = (exact.column(law.of) - first) / spacing
    from_end = np.clip(np.floor(np.minimum(place, len(law.table) - 1 - place)), 0, _MIDDLE).astype(int)
    rate = np.abs(_rate(evidence, law.of))
    found = []
    for order in (1, 2):
        touched = _touched(evidence, order, law.name if is_drive else "")
        if order > evidence.order or touched is None:
            continue
        derivative = order - 1 if is_drive else order
        weights = np.array(amplification(law.method, derivative))
        sizes = 10.0**-count / spacing**derivative * rate**derivative
        worst = weights[from_end] * sizes
        column, unit, scale, lever = touched
        row = int(np.argmax(worst))
        fastest = float(np.max(sizes))
        found.append(
            Noise(
                law.name, count, column, unit, float(weights[-1]) * fastest / lever, float(weights[0]) * fastest / lever,
                float(worst[row]) / lever, row, scale,
            )
        )  # fmt: skip
    return found


def _rate(evidence: Evidence, argument: str) -> Array:
    """Return d argument/dt (n,)."""
    exact = evidence.exact
    assert exact is not None
    rates = {coordinate.name: coordinate.rate for coordinate in evidence.variant.coordinates}
    return exact.column(rates[argument]) if argument in rates else np.gradient(exact.column(argument), exact.step)


def _touched(evidence: Evidence, order: int, drive: str) -> tuple[str, str, float, float] | None:
    """Return the column that an error shows in most, its unit and scale, and what the error is divided by there (m, m⁻¹ or 1).

    The error is one of a speed, or of an angular velocity where the `drive` is one.  A column of its unit is off by as much;
    where there is none, an angular velocity by that over the shortest length, a speed by that times this length.  None where
    no column but the drives is left.
    """
    exact = evidence.exact
    assert exact is not None
    rates = {coordinate.rate: coordinate.unit for coordinate in evidence.variant.coordinates}
    turns = rates.get(drive) == "rad"
    alike = [name for name in evidence.names if evidence.unit(name) == ("rad/s" if turns else "m/s")]
    names = alike or [name for name in evidence.names if name in exact.velocity_names]
    if not names:
        return None
    scales = {name: evidence.scale[name] for name in names}
    if order == 2:
        columns = {name: np.gradient(exact.column(name), exact.step) for name in names}
        ranges = {name: float(np.ptp(column)) for name, column in columns.items()}
        scales = {
            name: max(ranges[name], OF_SIZE * float(np.max(np.abs(column))), OF_UNIT * max(ranges.values()))
            for name, column in columns.items()
        }
    name = min(scales, key=lambda key: scales[key])
    unit = evidence.unit(name) + ("²" if order == 2 else "")
    length = 1.0 if alike else shortest_length(evidence)
    return f"d{name}" if order == 2 else name, unit, max(scales[name], 1e-300), 1 / length if turns else length
