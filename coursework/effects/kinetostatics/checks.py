"""The checks of forces, one record each: agreement of the methods, power, and what the joints can bear.

Enters: a `ForceAnalysis`, and that of the exact rows, if any.  Leaves: a `Finding` of each kind.
Used by `scene/motion_results.py`.  Words stand under [check.CODE]; to add one: write its function and a record in `FORCE_CHECKS`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from coursework.effects.effects import Action, add_wrench
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.kinetostatics.unseen_loads import unseen_loads
from coursework.equations.five_point import NODES, five_point_derivative
from coursework.mechanism.joints import FRAME
from coursework.motion.geometry.drives.drive import breaks, drive_values
from coursework.results.checks.close_to_motion.rows import AT_ROW
from coursework.results.checks.result import Check, Finding, Verdict, floored, skipped
from coursework.system.arrays import Array
from coursework.words.sentences import joined, say

AGREE = 1e-10  # largest difference of two methods for the same result, as a share of the largest
POWER_SHARE = 1e-3
LEAST_DIGITS = 6.0
_ALL_DIGITS = 16.0
_CLOSE = 0.05  # share of the largest drive
_BESIDE, _JUMP = 1e-9, 1e-6  # the drive jumps if it changes by more than _JUMP of its largest within _BESIDE of a break


def _graded(
    key: str, value: float, limit: float, worse: Verdict, row: int, column: str | None = None, /, **told: object
) -> Finding:
    """Return the finding for a share with an upper limit; beyond the limit the verdict is `worse`."""
    verdict = "PASS" if value <= limit else worse
    sentence = say(f"check.{key}.{verdict.lower()}", row=row, **told)
    return Finding(verdict, sentence, value, limit, say("unit.relative"), column, row)


def _agreement(found: Array | None, other: Array, names: tuple[str, ...], largest: float, code: str) -> Finding:
    if found is None:
        return skipped(say(f"check.{code}.skip"))
    known = np.isfinite(found) & np.isfinite(other)
    if not known.any() or not largest:
        return skipped(say("check.forces.none"))
    share = np.where(known, np.abs(np.nan_to_num(found) - np.nan_to_num(other)), 0.0) / largest
    row, column = np.unravel_index(int(np.argmax(share)), share.shape)
    value, name = float(share[row, column]), names[int(column)]
    return _graded(code, value, AGREE, "FAIL", int(row) + 1, name, value=value, name=name)


def _virtual_power(own: ForceAnalysis, exact: ForceAnalysis | None) -> Finding:
    found = _by_power(own)
    # The links in a scheme's rows may have drifted, so that they move as no mechanism can; the exact rows are closed.
    found = _by_power(exact) if found.verdict == "FAIL" and exact is not None else found
    alone = next((one.line for one in own.equations.variant.plausibility if one.code == "CONTACT"), None)
    if found.verdict == "PASS" or alone is None:
        return found
    return replace(found, sentence=joined([found.sentence, say("check.VIRTUAL-POWER.alone", line=alone)]))


def _by_power(own: ForceAnalysis) -> Finding:
    drives = np.column_stack([own.column(name) for name in own.drive_names]) if own.drive_names else np.zeros((own.rows.count, 0))
    return _agreement(own.by_power, drives, own.drive_names, own.reactions.largest, "VIRTUAL-POWER")


def _groups(own: ForceAnalysis, _: ForceAnalysis | None) -> Finding:
    return _agreement(own.by_groups, own.reactions.rows, own.reactions.names, own.reactions.largest, "GROUPS")


def outer_sum(own: ForceAnalysis) -> Array:
    """Return the sum (n, 3) of all outer and inertial forces, and of their moments about the origin; it should be zero."""
    rows = own.rows
    bodies = rows.scheme.by_name
    total = np.zeros((rows.count, 3))
    actions = list(own.actions)
    for name, unknown in zip(own.reactions.names, rows.scheme.unknowns, strict=True):
        outside = (unknown.off == FRAME and unknown.on in bodies) or (unknown.on == FRAME and unknown.off in rows.scheme.pins)
        if not outside:
            continue
        value = np.nan_to_num(own.column(name)) * (1.0 if unknown.off == FRAME else -1.0)
        if unknown.direction.kind == "couple":
            actions.append(Action("reactions", unknown.on, couple=value))
        elif unknown.at is not None:
            actions.append(Action("reactions", unknown.on, value * rows.along(unknown), rows.vector(unknown.at)))
    for action in actions:
        add_wrench(total, action, 0.0)
    return total


def _sum(own: ForceAnalysis, _: ForceAnalysis | None) -> Finding:
    if not np.isfinite(own.reactions.rows).all():
        return skipped(say("check.REACTIONS-SUM.skip"))
    left = np.abs(outer_sum(own)) / np.array([1.0, 1.0, own.rows.length])
    largest = own.reactions.largest
    if not largest:
        return skipped(say("check.forces.none"))
    value, row = float(left.max()) / largest, int(np.argmax(left.max(axis=1))) + 1
    return _graded("REACTIONS-SUM", value, AGREE, "FAIL", row, value=value)


def _power(own: ForceAnalysis, exact: ForceAnalysis | None) -> Finding:
    """Return the finding about power and energy; what acts between the rows and shows in none of them is told first of all."""
    of = exact or own
    blows = _blows(of)
    times, found = [say("check.STEP.time", time=time) for time in blows], _balance(own, exact, blows)
    told = [say("check.POWER.blow", times=joined(times, "join.numbers"))] if times else []
    for one in unseen_loads(of):
        key = "check.POWER.pole" if one.is_pole else "check.POWER.jump"
        told.append(say(key, name=one.name, row=one.row + 1, next=one.row + 2, time=one.time))
        if one.is_pole and found.verdict != "FAIL":
            found = Finding("FAIL", told[-1], row=one.row + 1)
    return replace(found, headline=joined(told)) if told else found


def _balance(own: ForceAnalysis, exact: ForceAnalysis | None, blows: Sequence[float] = ()) -> Finding:
    """Return whether the power given is the change of the energy; at the times (s) of `blows` the drive jumps."""
    of = exact or own
    t = of.rows.motion.t
    if len(t) < NODES:
        return skipped(say("check.POWER.skip"))
    energy = of.energy
    step = float(t[1] - t[0])
    changed = five_point_derivative(energy.kinetic + energy.potential, step)
    given = energy.drive + energy.loads + energy.friction + energy.dampers
    known = np.isfinite(given)  # where a law begins like a root of the time, the first row has no acceleration and no drive
    moved = five_point_derivative(energy.kinetic, step)
    scale = float(max(np.abs(values[known]).max(initial=0.0) for values in (given, energy.drive, changed, moved)))
    if not scale:
        return skipped(say("check.forces.none" if known.any() else "check.POWER.skip"))
    # The one-sided formulas at the ends are far less accurate.
    off = np.where(known, np.abs(given - changed) / scale, -1.0)[2:-2]
    for time in breaks(of.equations.variant):  # a change of formula makes a kink in the energy: five rows across it give no slope
        # A row on a kink ends five good ones; one on a jump has the energy behind it and ends none before it.
        off[np.abs(t[2:-2] - time) < 2 * step * (1 + (AT_ROW if time in blows else -AT_ROW))] = -1.0
    if off.max() < 0:
        return skipped(say("check.POWER.skip"))
    row, value = int(np.argmax(off)) + 3, float(off.max())
    return _graded("POWER", value, POWER_SHARE, "COARSE", row, value=value)


def _blows(of: ForceAnalysis) -> list[float]:
    """Return the times (s) at which the drive jumps, and with it the velocities of masses: no force of a row acts there."""
    variant, t = of.equations.variant, of.rows.motion.t
    times = np.array([time for time in breaks(variant) if len(t) and time < t[-1]])
    names = [law.name for law in variant.drive]
    if not (len(times) and names and of.rows.scheme.forces.masses):
        return []
    before, after = (drive_values(of.equations, names, times * (1 + side * _BESIDE)) for side in (-1, 1))
    # Against the largest of all rows: a drive that grows from rest is small on both sides, but it does not jump.
    usual = np.abs(drive_values(of.equations, names, t)).max(axis=0)
    jumps = np.abs(after - before) > _JUMP * np.maximum(usual, np.maximum(np.abs(before), np.abs(after)))
    return [float(time) for time in times[jumps.any(axis=1)]]


def contacts(own: ForceAnalysis) -> list[tuple[str, Array, Array]]:
    """Return name, N and |T|/N (n,) of each rolling contact, in the rows where they have a value; inf where T alone acts."""
    names, found = own.reactions.names, list[tuple[str, Array, Array]]()
    for name in names:
        if name[0] == "N" and (beside := f"T{name[1:]}") in names:
            normal, along = own.column(name), np.abs(own.column(beside))
            known = np.isfinite(normal) & np.isfinite(along)
            bare = np.where(along > 0, np.inf, 0.0)
            share = np.divide(along, np.abs(normal), out=bare, where=known & (normal != 0))
            found.append((name, np.where(known, normal, np.nan), np.where(known, share, np.nan)))
    return found


def _contact(own: ForceAnalysis, _: ForceAnalysis | None) -> Finding:
    found = contacts(own)
    if not found or not own.reactions.rows.size:
        return skipped(say("check.CONTACT.skip"))
    found = [one for one in found if np.isfinite(one[1]).any()]
    if not found:
        return skipped(say("check.CONTACT.open"))
    # The worst contact: one that lifts off, or that needs the most friction.
    name, normal, share = max(found, key=lambda one: (bool(_lifted(*one[1:]).any()), float(np.nanmax(one[2]))))
    worst, friction, lifted = int(np.nanargmax(share)) + 1, float(np.nanmax(share)), int(_lifted(normal, share).sum())
    told = say(
        "check.CONTACT.bare" if np.isinf(friction) else "check.CONTACT.lifts" if lifted else "check.CONTACT.pass",
        name=name, least=float(np.nanmin(normal)), most=float(np.nanmax(normal)), count=lifted,
        number=int(np.isfinite(normal).sum()), friction=friction, row=worst,
    )  # fmt: skip
    return Finding("PASS", told, friction if np.isfinite(friction) else None, None, "", name, worst)


def _lifted(normal: Array, share: Array) -> Array:
    """Return the rows (n,) in which nothing presses, although the contact has to hold."""
    return np.asarray((normal < 0) | np.isinf(share))


def _condition(own: ForceAnalysis, _: ForceAnalysis | None) -> Finding:
    condition = own.reactions.condition
    if not len(condition):
        return skipped(say("check.forces.none"))
    if not np.isfinite(condition).any():
        names = tuple(n for n, column in zip(own.reactions.names, own.reactions.rows.T, strict=True) if np.isnan(column).any())
        unknowns, equations = len(own.reactions.names), int(own.reactions.matrix.shape[1])
        told = say("check.FORCE-CONDITION.redundant", names=names, number=unknowns, count=equations)
        return Finding("SKIP", told, unjudged=say("summary.reactions", number=len(names), all=unknowns))
    row = int(np.argmax(condition)) + 1
    digits = floored(max(0.0, _ALL_DIGITS - float(np.log10(condition.max()))), 1) if np.isfinite(condition.max()) else 0.0
    good = digits >= LEAST_DIGITS
    sentence = say("check.FORCE-CONDITION.pass" if good else "check.FORCE-CONDITION.coarse", digits=digits, row=row)
    return Finding("PASS" if good else "COARSE", sentence, digits, LEAST_DIGITS, say("unit.digits", number=digits), row=row)


def _accuracy(own: ForceAnalysis, exact: ForceAnalysis | None) -> Finding:
    """Return the finding about the drive computed from the scheme's rows, where it is furthest from the exact one."""
    if exact is own:
        return skipped(say("check.STABLE.skip"))
    if exact is None:
        return skipped(say("check.unknown"))
    if not own.drive_names or not exact.reactions.largest:
        return skipped(say("check.forces.none"))
    count = min(own.rows.count, exact.rows.count)
    pairs = [(name, own.column(name)[:count], exact.column(name)[:count]) for name in own.drive_names]
    name, found, true = max(pairs, key=lambda one: float(np.nan_to_num(np.abs(one[1] - one[2])).max()))
    if np.nanmax(np.abs(true)) < AGREE * exact.reactions.largest:
        return skipped(say("check.forces.none"))  # no drive is needed
    row = int(np.nanargmax(np.abs(found - true)))
    values = {"found": float(found[row]), "true": float(true[row]), "off": float(abs(found[row] - true[row]))}
    share, unit = values["off"] / float(np.nanmax(np.abs(true))), own.units[own.names.index(name)]
    return _graded("FORCE-ACCURACY", share, _CLOSE, "COARSE", row + 1, name, **values, name=name, unit=unit, share=share)


def _friction(own: ForceAnalysis, _: ForceAnalysis | None) -> Finding:
    empty = np.isnan(own.reactions.rows).all(axis=1)
    locked = np.flatnonzero(empty & np.isfinite(own.reactions.condition))
    if empty.any() and not len(locked):
        return skipped(say("check.FRICTION.not_unique"))
    if len(locked):
        told = {"count": len(locked), "number": own.rows.count, "row": int(locked[0]) + 1}
        return Finding("FAIL", say("check.FRICTION.locked", **told), row=int(locked[0]) + 1)
    from coursework.effects.friction.friction import standing

    power = own.energy.friction
    row = int(np.argmin(power))
    lost, still = float(-power[row]), np.flatnonzero(standing(own.reactions.friction))
    told = {"count": len(still), "still": int(still[0]) + 1} if len(still) else {}
    return Finding("PASS", say(f"check.FRICTION.{'still' if told else 'pass'}", power=lost, row=row + 1, **told), row=row + 1)


FORCE_CHECKS: tuple[Check, ...] = (
    Check("VIRTUAL-POWER", "computation", _virtual_power),
    Check("GROUPS", "computation", _groups),
    Check("REACTIONS-SUM", "computation", _sum),
    Check("POWER", "motion", _power),
    Check("FORCE-ACCURACY", "motion", _accuracy),
    Check("CONTACT", "computation", _contact),
    Check("FRICTION", "computation", _friction),
    Check("FORCE-CONDITION", "computation", _condition, is_least=True),
)


def check_forces(own: ForceAnalysis, exact: ForceAnalysis | None) -> tuple[Finding, ...]:
    """Return the findings of all checks of forces; friction is judged where something rubs."""
    rubs = bool(own.rows.scheme.forces.friction)
    return tuple(check.finding(own, exact) for check in FORCE_CHECKS if rubs or check.code != "FRICTION")
