"""What is told about the forces of a run: which effects are on, why the others are off, and what run.json records.

Enters: `Forces`, a `ForceAnalysis`.  Leaves: sentences, plain data.
Used by `commands/run.py`, `motion_results.py` and `report/output/record.py`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from coursework.effects.effects import EFFECTS, FRICTION, MOTOR, Effect
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.kinetostatics.flywheel import find_flywheel
from coursework.results.kinematics.extra import ExtraTable
from coursework.variant.record.forces import Forces
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


def effect_lines(forces: Forces, found: ForceAnalysis | None) -> list[Sentence]:
    """Return which effects a file turns on or off and why, and the cost of a row if the forces were `found`."""
    lines = [say("plan.effects")]
    for effect in EFFECTS:
        on = effect.named(forces)
        why = say("plan.on" if on else "plan.off", section=effect.section)
        cost = _cost(effect, found) if on and found is not None else None
        lines.append(
            say("plan.line", name=f"{effect.name:<20}", why=why if cost is None else joined([why, cost], "join.nothing"))
        )
    if found is not None:
        _, equations, unknowns = found.reactions.matrix.shape
        lines.append(say("plan.forces_cost", equations=equations, unknowns=unknowns, count=len(found.rows.scheme.bodies)))
    return lines


def _cost(effect: Effect, found: ForceAnalysis) -> Sentence:
    """Return the sentence about what an effect adds to every row."""
    if effect is FRICTION:
        from coursework.effects.friction.friction import MOST_ROUNDS

        return say("plan.effect_rounds", most=MOST_ROUNDS)
    if (motor := found.rows.scheme.forces.motor) is not None and effect is MOTOR:
        return say("plan.effect_slope", count=len(motor.rates))
    acts = [*effect.acts(found.rows)]
    couples = sum(one.couple is not None for one in acts)
    return say("plan.effect_acts", forces=len(acts) - couples, couples=couples)


def dynamics_table(found: ForceAnalysis) -> ExtraTable:
    """Return the columns of `dynamics.csv`: coordinates, rates, and the sum of kinetic and potential energy."""
    motion, variant = found.rows.motion, found.equations.variant
    names = (*motion.coordinate_names, *variant.rates)
    energy = found.energy.kinetic + found.energy.potential
    rows = np.column_stack([motion.t, *(motion.column(name) for name in names), energy])
    units = ("s", *(variant.unit_of(name) for name in names), "J")
    return ExtraTable(say("extra.dynamics"), ("t", *names, "energy"), units, rows)


def force_record(found: ForceAnalysis, period: float | None) -> dict[str, Any]:
    """Return the entries of run.json about forces: the largest reaction and its row, mean torque, flywheel, agreements."""
    reactions = found.reactions
    known = np.nan_to_num(np.abs(reactions.rows[:, : len(reactions.names) - len(found.drive_names)]))
    row, column = np.unravel_index(int(np.argmax(known)), known.shape) if known.size else (0, 0)
    wheel = find_flywheel(found, period)
    return {
        "scale": reactions.largest,
        "largest": {"name": reactions.names[int(column)], "row": int(row) + 1, "value": float(known.max(initial=0.0))},
        "not_unique": [n for n, of in zip(reactions.names, reactions.rows.T, strict=True) if np.isnan(of).any()],
        "mean_moment": None if wheel is None else wheel.mean,
        "excess": None if wheel is None else wheel.excess,
        "crossings": [] if wheel is None else list(wheel.crossings),
        "J_f": None if wheel is None else wheel.needed,
        "agreement": {
            "virtual_power": _share(found.by_power, reactions.rows[:, len(reactions.names) - len(found.drive_names) :], found),
            "groups": _share(found.by_groups, reactions.rows, found),
        },
    }


def _share(other: Any, own: Any, found: ForceAnalysis) -> float | None:
    """Return the difference of two methods as a share of the largest force; None if one of them is unknown."""
    if other is None or not own.size or not found.reactions.largest or not np.isfinite(own).all():
        return None
    return float(np.abs(other - own).max() / found.reactions.largest)
