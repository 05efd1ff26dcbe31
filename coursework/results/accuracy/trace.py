"""Rows of a scheme on the coursework's grid with many steps between them, and their error.

Enters: a scheme and rates, the rows examined, a reference.  Leaves: positions (n, m), errors.  Used by `methods.py`
and `study.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from coursework.motion.integration.loops import generate_loop
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import SCHEMES, Scheme, title_of
from coursework.results.accuracy.record import StudyRow
from coursework.system.arrays import Array

SETTLED = 0.5  # a method has reached its order if its local slopes differ by less


def trace(scheme: Scheme, rates: Rates, start: Sequence[float], step: float, marks: Sequence[int], substeps: int) -> Array:
    """Return the positions (n, m) in the rows `marks`, which begin with 0, with `substeps` steps a row; rows are `step` s apart.

    A step that ends at a break of the drives evaluates no slopes behind it, as `rates` say.
    """
    loop, q = generate_loop(scheme, rates), tuple(start)
    found = [q]
    at_breaks = rates.rows_at_breaks(step / substeps)
    for row, following in itertools.pairwise(marks):
        first, end = row * substeps, following * substeps
        for last in (*(place for place in at_breaks if first < place < end), end):
            begin, steps = first / substeps * step, last - first
            latest = rates.may_look_until(last / substeps * step)
            q = loop(begin, steps, min(step / substeps, (latest - begin) / steps), *q)
            first = last
        found.append(q)
    return np.array(found)


def slope(costs: Sequence[float], found: Sequence[float], floor: float) -> float | None:
    """Return the order of accuracy: the slope of log error against log cost by least squares.

    Only the finest three points between ten times the round-off `floor` and 0.1 count, because coarse steps have not reached
    the order yet.  None if fewer than two remain, or if the slopes between them show that the order is not reached.
    """
    kept, local = _counted(costs, found, floor), local_slopes(costs, found, floor)
    if not local or max(local) - min(local) > SETTLED:
        return None
    x, y = np.array(kept).T
    return float(-np.polyfit(x, y, 1)[0])


def orders_of(rows: Sequence[StudyRow], floor: float, least: float, *, end: bool = False) -> dict[str, float]:
    """Return method -> measured order for each method with steps whose order exceeds `least`; `floor` is a share of the size.

    Two points always lie on a line, and three may by luck: an order is measured only where the scheme can have it.
    """
    known: dict[str, int] = {title_of(scheme): scheme.order for scheme in SCHEMES.values()}
    found = {}
    for method in dict.fromkeys(row.method for row in rows):
        own = [row for row in rows if row.method == method and not row.failed and row.steps_or_tolerance.isdigit()]
        shares = [row.end_error / row.end_size if end else row.share for row in own]
        costs = [row.evaluations for row in own]
        measured = slope(costs, shares, floor)
        is_odd = not end and are_odd(local_slopes(costs, shares, floor), known.get(method))
        if measured is not None and measured > least and not is_odd:
            found[method] = measured
    return found


def are_odd(slopes: Sequence[float], order: int | None) -> bool:
    """Return whether local slopes are not those of a scheme of this `order`, None for a method without one.

    A single slope must be the order itself.  Several that agree may be an order higher, as Ralston's scheme has 3 where it only
    integrates a drive, and not more: then steps that are still too coarse agree by luck.
    """
    if order is None or not slopes:
        return False
    return abs(slopes[0] - order) > SETTLED if len(slopes) == 1 else min(slopes) > order + 1 + SETTLED


def local_slopes(costs: Sequence[float], found: Sequence[float], floor: float) -> list[float]:
    """Return the orders between neighbouring points, for the points that `slope` uses."""
    pairs = itertools.pairwise(_counted(costs, found, floor))
    return [float((log_error - further) / (finer - log_cost)) for (log_cost, log_error), (finer, further) in pairs]


def _counted(costs: Sequence[float], found: Sequence[float], floor: float) -> list[tuple[float, float]]:
    """Return the logarithms of cost and error of the finest three points between round-off and 0.1."""
    kept = [(np.log(cost), np.log(error)) for cost, error in zip(costs, found, strict=True) if 10 * floor < error < 0.1]
    return kept[-3:]
