"""What the study says to a student, in words computed from its rows.

Enters: rows and orders.  Leaves: sentences.  Used by `study.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from coursework.accuracy.methods import CLOSED
from coursework.accuracy.record import StudyRow
from coursework.schemes import SCHEMES


def sentences_of(
    rows: Sequence[StudyRow], orders: Mapping[str, float], end_orders: Mapping[str, float], own: StudyRow
) -> tuple[str, ...]:
    """Return the findings: the own step, the better scheme at the same step, what equal accuracy costs, the end-row trap."""
    best = _first(rows, SCHEMES["rk4"].title)
    euler = _first(rows, SCHEMES["euler"].title)
    told = [f"{own.steps_or_tolerance} steps of {own.method}: {_size(own.max_error, own.unit)} off at worst{_time(own)}."]
    told.append(
        f"The same {best.steps_or_tolerance} steps of {best.method} are {_size(best.max_error, best.unit)} off: "
        f"{_round(euler.max_error / best.max_error)} times less error than Euler for "
        f"{best.evaluations / euler.evaluations:.3g} times the evaluations{_ratio(best, euler)}."
    )
    if steps := _steps_for(rows, best.max_error):
        ratio = steps / best.evaluations
        told.append(
            f"To be as good as {best.steps_or_tolerance} steps of {best.method}, Euler needs about {_round(steps)} steps: "
            f"{_round(ratio)} times the evaluations{_predicted(rows, steps, best)}."
        )
    projected = [row for row in rows if "1 Newton" in row.method and not row.failed]
    if projected:
        told.append(
            f"Euler with one Newton projection a step, {projected[0].steps_or_tolerance} steps: "
            f"{_size(projected[0].max_error, projected[0].unit)}, "
            f"{_round(euler.max_error / projected[0].max_error)} times less than without it."
        )
    closed = [row for row in rows if row.method == CLOSED and not row.failed]
    if closed:
        told.append(
            f"Newton on the position equations gives the same rows to {_size(closed[0].max_error, closed[0].unit)} with "
            f"{closed[0].evaluations} evaluations{_time(closed[0])}: {_round(closed[0].evaluations / best.evaluations)} times "
            f"the evaluations{_ratio(closed[0], best)} of {best.steps_or_tolerance} steps of {best.method}."
        )
    understated = euler.max_error / max(euler.end_error, 1e-300)
    if understated >= 1.1:
        told.append(
            f"The last row alone understates: there Euler is {_size(euler.end_error, euler.end_unit)} off, "
            f"{understated:.2g} times less than at its worst row."
        )
    for name, order in orders.items():
        if name in end_orders and end_orders[name] - order > 0.5 and any(name == s.title for s in SCHEMES.values()):
            told.append(
                f"Measured at the last row only, {name} would seem to have order {end_orders[name]:.1f}; "
                f"over the whole grid it is {order:.1f}."
            )
    return tuple(told)


def _first(rows: Sequence[StudyRow], method: str) -> StudyRow:
    return next(row for row in rows if row.method == method)


def _steps_for(rows: Sequence[StudyRow], error: float) -> float | None:
    """Return the Euler steps that reach `error`: from the finest row on, the error falls as 1/steps."""
    euler = [row for row in rows if row.method == SCHEMES["euler"].title and not row.failed]
    last = euler[-1]
    if not (0 < error < last.max_error):
        enough = [row for row in euler if row.max_error <= error]
        return float(enough[0].evaluations) if enough else None
    return last.evaluations * last.max_error / error


def _size(value: float, unit: str) -> str:
    if unit == "rad" and value >= 1e-3:
        return f"{value:.3g} rad ({math.degrees(value):.2g}°)"
    return f"{value:.3g} {unit}"


def _round(value: float) -> str:
    """Return a number with two digits, thousands apart."""
    if not math.isfinite(value) or value <= 0:
        return "many"
    digits = max(0, math.floor(math.log10(value)) - 1)
    return f"{round(value / 10**digits) * 10**digits:,.0f}".replace(",", " ") if value >= 10 else f"{value:.2g}"


def _time(row: StudyRow) -> str:
    return f", {_clock(row.seconds)}" if row.seconds is not None else ""


def _ratio(row: StudyRow, other: StudyRow) -> str:
    return f" and {row.seconds / other.seconds:.2g} times the time" if row.seconds and other.seconds else ""


def _predicted(rows: Sequence[StudyRow], steps: float, best: StudyRow) -> str:
    finest = [row for row in rows if row.method == SCHEMES["euler"].title and row.seconds][-1:]
    if not finest or not best.seconds or not finest[0].seconds:
        return ""
    spent = steps * finest[0].seconds / finest[0].evaluations
    return f", about {_clock(spent)} and {_round(spent / best.seconds)} times the time"


def _clock(value: float | None) -> str:
    value = value or 0.0
    for scale, unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= scale:
            return f"{value / scale:.0f} {unit}" if value >= 10 * scale else f"{value / scale:.2g} {unit}"
    return f"{value / 1e-9:.2g} ns"
