"""Which formula of a variant has no value at a place, each looked at alone: the one that is not finite is charged.

Enters: a `Variant`, a time and coordinates.  Leaves: a fault with the line.  Used where a computation has ended in no number.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from contextlib import suppress
from graphlib import TopologicalSorter

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, evaluate_any
from coursework.variant.record.variant import Law, Variant
from coursework.variant.toml.positions import KeyPath
from coursework.words.errors import Fault
from coursework.words.sentences import joined, say

# Parts of a time: what a product of doubles may lie beyond it, and where a value is compared with the one just before.
_ROUNDED, _BEFORE = 1e-15, 1e-6


def without_value(variant: Variant, t: float, position: Mapping[str, float]) -> Fault | None:
    """Return a fault for the first law, equation or point without a finite value at time `t` (s) and a position (rad, m).

    Of a mechanism that forces move the forces too; `position` has the free rates then.
    """
    values: dict[str, complex] = {"pi": math.pi, **variant.values, "t": t, **position}
    values |= dict.fromkeys((name for name in variant.sought if name not in values), 1.0)
    for section, law in in_order(variant):
        if law.table:
            values |= {law.name: _within(law, values[law.of].real)} if law.of in values else {}
            continue
        place = next((place for place in reversed(range(len(law.pieces))) if law.pieces[place][0] <= t), 0)
        path: KeyPath = (section, law.name, "pieces", place, 1) if law.pieces else (section, law.name)
        formula = law.pieces[place][1] if law.pieces else law.formula
        if formula is not None and (fault := _judged(variant, path, law.name, formula, values, t)):
            return fault
    for path, formula in variant.formulas():
        if fault := _judged(variant, path, str(path[1]) if path[0] == "points" else "", formula, values, t):
            return fault
    moving = variant.forces.measured() if variant.forces is not None and variant.forces.motor is not None else ()
    return next((fault for path, formula, _ in moving if (fault := _judged(variant, path, "", formula, values, t))), None)


def law_without_value(variant: Variant, times: Iterable[float]) -> Fault | None:
    """Return a fault for the first law that has no finite value at one of some times (s), whatever the position."""
    return next((fault for t in times if (fault := without_value(variant, t, {}))), None)


def known_value(formula: Formula, values: Mapping[str, float]) -> float | None:
    """Return what a formula is worth with some values, None where it has other names or no finite value."""
    with suppress(FormulaFault):
        return evaluate(formula, values) if {*formula.names()} <= {*values, "pi"} else None
    return None


def in_order(variant: Variant) -> list[tuple[str, Law]]:
    """Return section and law of every law, each after those it needs.  Raises `graphlib.CycleError` for one that needs itself."""
    laws = {law.name: (section, law) for section in ("drive", "functions") for law in getattr(variant, section)}
    needs = {
        name: [needed for formula in law.formulas for needed in formula.names() if needed in laws]
        for name, (_, law) in laws.items()
    }
    return [laws[name] for name in TopologicalSorter(needs).static_order()]


def _within(law: Law, argument: float) -> float:
    """Return the value of the node before an argument: beyond its table a law tells of itself."""
    return next((value for at, value in reversed(law.table) if at <= argument), law.table[0][1])


def _judged(variant: Variant, path: KeyPath, name: str, formula: Formula, values: dict[str, complex], t: float) -> Fault | None:
    """Keep the value of a formula under its name; return a fault where it has none, nothing where a name is not known yet."""
    if not {*formula.names()} <= values.keys():
        return None
    try:
        value = evaluate_any(formula, values)
    except FormulaFault as fault:
        place = ".".join(map(str, path[:2]))
        if path[0] == "constraint":
            place = say("place.constraint", name=variant.constraints[int(path[1])].name)
        place = say("place.column", place=place, column=fault.column)
        reason = joined([fault.message, say("hint.just_before")]) if _is_rounding(formula, values, t) else fault.message
        told = say("fault.V019", time=t, reason=reason)
        return Fault(told, variant.file, variant.nearest_line(*path), 0, place)
    if name:
        values[name] = value
    return None


def _is_rounding(formula: Formula, values: dict[str, complex], t: float) -> bool:
    """Return whether a formula goes to a value just before a time, so that only the last bit of the time takes it away."""
    with suppress(FormulaFault):
        near, before = (abs(evaluate_any(formula, values | {"t": t * (1 - part)})) for part in (_ROUNDED, _BEFORE))
        return near < before
    return False
