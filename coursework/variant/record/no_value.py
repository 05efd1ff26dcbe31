"""Which formula of a variant has no value at some point: each one is evaluated alone to find the first that is not finite.

Enters: a `Variant`, a time and coordinates.  Leaves: a fault with the line.  Used where a computation gave no finite number.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from contextlib import suppress
from graphlib import TopologicalSorter

import numpy as np

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, evaluate_any
from coursework.variant.record.variant import Law, Variant
from coursework.variant.toml.positions import KeyPath
from coursework.words.errors import Fault
from coursework.words.sentences import joined, say

# Fractions of a time: the rounding of a product of doubles, and the distance to an earlier value for comparison.
_ROUNDED, _BEFORE = 1e-15, 1e-6


def without_value(variant: Variant, t: float, position: Mapping[str, float]) -> Fault | None:
    """Return a fault for the first law, equation or point without a finite value at time `t` (s) and a position (rad, m).

    Of a mechanism that forces move the forces too; `position` has the velocities then.
    """
    values: dict[str, complex] = {"pi": math.pi, **variant.values, "t": t, **position}
    values |= dict.fromkeys((name for name in variant.sought if name not in values), 1.0)
    for law in in_order(variant):
        if law.name in position:  # the free rate of a mechanism that forces move stands among the laws
            continue
        if law.table:
            values |= {law.name: _within(law, values[law.of].real)} if law.of in values else {}
            continue
        place = next((place for place in reversed(range(len(law.pieces))) if law.pieces[place][0] <= t), 0)
        path: KeyPath = (*variant.path_of(law.name), *(("pieces", place, 1) if law.pieces else ()))
        formula = law.pieces[place][1] if law.pieces else law.formula
        if formula is not None and (fault := _judged(variant, path, law.name, formula, values, t)):
            return fault
    for path, formula in variant.formulas():
        if fault := _judged(variant, path, str(path[1]) if path[0] == "points" else "", formula, values, t):
            return fault
    moving = variant.forces.measured() if variant.forces is not None and variant.forces.motor is not None else ()
    return next((fault for path, formula, _ in moving if (fault := _judged(variant, path, "", formula, values, t))), None)


def law_without_value(variant: Variant, times: Iterable[float]) -> Fault | None:
    """Return a fault for the first law without a finite value at one of the `times` (s), whatever the position."""
    return next((fault for t in times if (fault := without_value(variant, t, {}))), None)


def known_value(formula: Formula, values: Mapping[str, float]) -> float | None:
    """Return the value of a formula for some `values`, None if it has other names or no finite value."""
    with suppress(FormulaFault):
        return evaluate(formula, values) if {*formula.names()} <= {*values, "pi"} else None
    return None


def in_order(variant: Variant) -> list[Law]:
    """Return every law after those it needs.  Raises `graphlib.CycleError` if one needs itself."""
    laws = {law.name: law for law in variant.laws}
    needs = {
        name: [needed for formula in law.formulas for needed in formula.names() if needed in laws] for name, law in laws.items()
    }
    return [laws[name] for name in TopologicalSorter(needs).static_order()]


def _within(law: Law, argument: float) -> float:
    """Return the value on the line between two nodes; outside its table the law reports the error itself."""
    nodes, values = zip(*law.table, strict=True)
    return float(np.interp(argument, nodes, values))


def _judged(variant: Variant, path: KeyPath, name: str, formula: Formula, values: dict[str, complex], t: float) -> Fault | None:
    """Store the value of a formula under its name; return a fault if it has none, None if a name is not known yet."""
    if not {*formula.names()} <= values.keys():
        return None
    try:
        value = evaluate_any(formula, values)
    except FormulaFault as fault:
        place = ".".join(map(str, path[:2]))
        if path[0] == "constraint":
            place = say("place.constraint", name=next(one.name for one in variant.constraints if one.path == path))
        place = say("place.column", place=place, column=fault.column)
        reason = joined([fault.message, say("hint.just_before")]) if _is_rounding(formula, values, t) else fault.message
        told = say("fault.V019", time=t, reason=reason)
        return Fault(told, variant.file, variant.nearest_line(*path), 0, place)
    if name:
        values[name] = value
    return None


def _is_rounding(formula: Formula, values: dict[str, complex], t: float) -> bool:
    """Return whether a formula tends to a value just before the time `t`, so that only the rounding of `t` removes it."""
    with suppress(FormulaFault):
        near, before = (abs(evaluate_any(formula, values | {"t": t * (1 - part)})) for part in (_ROUNDED, _BEFORE))
        return near < before
    return False
