"""Forces as computed with one typical mistake, against which a marker compares a wrong answer.

Enters: a `ForceAnalysis`.  Leaves: the unknown forces (n, unknowns) for each slip, by its code.  Computed on request only.
Used by `grading/marking/key/forces.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np

from coursework.effects.effects import Action
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.kinetostatics.kinetostatics import react_to
from coursework.effects.rows import SECOND, Rows
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula

Slip = Callable[[Rows, Action], Action | None]  # maps an action to the mistaken one, or to None if it is forgotten


def _without(effect: str, _: Rows, one: Action) -> Action | None:
    """Return None for an action of this effect, which is forgotten (without inertia: statics); other actions unchanged."""
    return None if one.effect == effect else one


def _inertia_turned(rows: Rows, one: Action) -> Action | None:
    """Return forces and couples of inertia with the wrong sign."""
    if one.effect == "inertia" and one.couple is None and one.force is not None:
        return replace(one, force=-one.force)
    return _couple_turned(rows, one)


def _couple_turned(_: Rows, one: Action) -> Action | None:
    """Return couples of inertia with the wrong sign, forces unchanged."""
    return replace(one, couple=-one.couple) if one.effect == "inertia" and one.couple is not None else one


def _joint_of(rows: Rows, one: Action, *effects: str) -> Formula | None:
    """Return the joint of a link at which these effects may wrongly be placed, None if its place is unknown."""
    return rows.scheme.own_point(one.body) if one.effect in effects else None


def _about_the_joint(rows: Rows, one: Action) -> Action | None:
    """Return the couple of inertia with J about a joint of the link, J + m d^2, although the force of inertia acts in S."""
    if one.couple is None or (own := _joint_of(rows, one, "inertia")) is None:
        return one
    body = rows.scheme.by_name[one.body]
    far = np.abs(rows.vector(body.centre) - rows.vector(own)) ** 2 * rows.mass(body)
    return replace(one, couple=one.couple - far * rows.epsilon(body))


def _acceleration_of_the_joint(rows: Rows, one: Action) -> Action | None:
    """Return the force of inertia with the acceleration of a joint of the link in place of that of its centre of mass."""
    if one.force is None or (own := _joint_of(rows, one, "inertia")) is None:
        return one
    body = rows.scheme.by_name[one.body]
    arm = rows.vector(own) - rows.vector(body.centre)
    second = rows.vector(body.centre, SECOND) + (1j * rows.epsilon(body) - rows.omega(body) ** 2) * arm
    return replace(one, force=np.asarray(-rows.mass(body) * second))


def _arm_of_the_joint(rows: Rows, one: Action) -> Action | None:
    """Return forces of inertia and weight that act in a joint of the link, not in S, so that their moment arms are wrong."""
    own = _joint_of(rows, one, "inertia", "weight")
    return one if one.force is None or own is None else replace(one, at=rows.vector(own))


SLIPS: dict[str, Slip] = {
    "no_weight": partial(_without, "weight"), "no_inertia": partial(_without, "inertia"), "inertia_turned": _inertia_turned,
    "couple_turned": _couple_turned, "about_the_joint": _about_the_joint,
    "acceleration_of_the_joint": _acceleration_of_the_joint, "arm_of_the_joint": _arm_of_the_joint,
}  # fmt: skip


def slipped(found: ForceAnalysis) -> dict[str, Array]:
    """Return the unknown forces that result from each slip."""
    rows, actions = found.rows, found.actions
    changed = {code: [slip(rows, one) for one in actions] for code, slip in SLIPS.items()}
    return {code: react_to(rows, tuple(one for one in kept if one is not None)).rows for code, kept in changed.items()}
