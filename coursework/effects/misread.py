"""Forces as somebody finds them who has one thing wrong: what a marker holds a wrong answer against.

Enters: a `ForceAnalysis`.  Leaves: the unknown forces (n, unknowns) of each slip, by its code.  Computed on request only.
Used by `grading/marking/forces.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from coursework.effects.analysis import ForceAnalysis
from coursework.effects.effects import Action
from coursework.effects.force_scheme import Body
from coursework.effects.kinetostatics import react_to
from coursework.effects.rows import PLACE, SECOND, Rows
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula

Slip = Callable[[ForceAnalysis], Iterator[Action]]


def _no_weight(found: ForceAnalysis) -> Iterator[Action]:
    """The weight is forgotten."""
    yield from (one for one in found.actions if one.effect != "weight")


def _no_inertia(found: ForceAnalysis) -> Iterator[Action]:
    """The forces of inertia are forgotten: statics."""
    yield from (one for one in found.actions if one.effect != "inertia")


def _inertia_turned(found: ForceAnalysis) -> Iterator[Action]:
    """The forces and couples of inertia have the wrong sign."""
    for one in found.actions:
        if one.effect != "inertia":
            yield one
        elif one.couple is not None:
            yield replace(one, couple=-one.couple)
        elif one.force is not None:
            yield replace(one, force=-one.force)


def _couple_turned(found: ForceAnalysis) -> Iterator[Action]:
    """The couples of inertia alone have the wrong sign."""
    for one in found.actions:
        yield replace(one, couple=-one.couple) if one.effect == "inertia" and one.couple is not None else one


def _joint_of(rows: Rows, body: str) -> Formula | None:
    """Return the joint of a link in which somebody may think its forces act, None where it has no known place."""
    own = rows.scheme.own_point(body)
    return own if own is not None and (own, True, PLACE) in rows.values else None


def _about_the_joint(found: ForceAnalysis) -> Iterator[Action]:
    """J is taken about a joint of the link, J + m d^2, although the force of inertia stands in S."""
    rows = found.rows
    for one in found.actions:
        if one.effect == "inertia" and one.couple is not None and (own := _joint_of(rows, one.body)) is not None:
            body = _body(rows, one)
            far = np.abs(rows.vector(body.centre) - rows.vector(own)) ** 2 * rows.mass(body)
            yield replace(one, couple=one.couple - far * rows.epsilon(body))
        else:
            yield one


def _acceleration_of_the_joint(found: ForceAnalysis) -> Iterator[Action]:
    """The acceleration of a joint of the link stands for that of its centre of mass."""
    rows = found.rows
    for one in found.actions:
        if one.effect == "inertia" and one.force is not None and (own := _joint_of(rows, one.body)) is not None:
            body = _body(rows, one)
            arm = rows.vector(own) - rows.vector(body.centre)
            second = rows.vector(body.centre, SECOND) + (1j * rows.epsilon(body) - rows.omega(body) ** 2) * arm
            yield replace(one, force=np.asarray(-rows.mass(body) * second))
        else:
            yield one


def _arm_of_the_joint(found: ForceAnalysis) -> Iterator[Action]:
    """Forces of inertia and weight act in a joint of the link, not in S: their moment arms lead to the wrong point."""
    rows = found.rows
    for one in found.actions:
        own = _joint_of(rows, one.body) if one.effect in {"inertia", "weight"} and one.force is not None else None
        yield one if own is None else replace(one, at=rows.vector(own))


def _body(rows: Rows, action: Action) -> Body:
    return next(body for body in rows.scheme.bodies if body.name == action.body)


SLIPS: dict[str, Slip] = {
    "no_weight": _no_weight, "no_inertia": _no_inertia, "inertia_turned": _inertia_turned, "couple_turned": _couple_turned,
    "about_the_joint": _about_the_joint, "acceleration_of_the_joint": _acceleration_of_the_joint,
    "arm_of_the_joint": _arm_of_the_joint,
}  # fmt: skip


def slipped(found: ForceAnalysis) -> dict[str, Array]:
    """Return the unknown forces that each slip gives."""
    return {code: react_to(found.rows, tuple(slip(found))).rows for code, slip in SLIPS.items()}
