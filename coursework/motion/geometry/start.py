"""The coordinates at t = 0: those the file gives, those a chain of groups gives, those other data have moved.

Enters: velocity equations and the variant's start values.  Leaves: the start (m,), rad or m.
Used by `way_to_motion.py` and by models of many sets.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations, differentiate
from coursework.mechanism.mechanism import build
from coursework.motion.geometry.chain import chain_positions
from coursework.motion.geometry.closure import MAX_NEWTON, Closure, compile_closure
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.formula.units import size_of
from coursework.variant.record.variant import Coordinate, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# A start value written with fewer digits than this (rad or m) is taken for another position, not for rounding.
START_TOLERANCE = 1e-6
# A correction beyond this (rad or m) leads to another assembly; below the other it is settled.
_WIDE, _SETTLED = 10.0, 1e-12
_ROUNDED = 0.02  # what a start value (rad or m) of two digits may be off, and one in the other order is not


def start_values(equations: VelocityEquations) -> list[float]:
    """Return the coordinates at t = 0; groups give those the file leaves out, the closure those that follow from other data.

    Raises `InputError` where a written start is not the position the groups close in, or none lies near the old one.
    """
    variant = equations.variant
    given = {name for group in variant.groups for name in group.coordinates}
    missing = [c for c in variant.coordinates if c.start_or_guess is None and c.name not in given]
    if missing:
        raise InputError([_fault(say("fault.V331", name=c.name), c, variant) for c in missing])
    if given:
        return _by_groups(equations)
    start = np.array([c.start_or_guess for c in variant.coordinates], dtype=float)
    moved = [place for place, c in enumerate(variant.coordinates) if c.start is None]
    closure = compile_closure(equations, start.tolist()) if moved else None
    return [float(value) for value in (start if closure is None else _closed(closure, start, moved))]


def _by_groups(equations: VelocityEquations) -> list[float]:
    variant = equations.variant
    closed = chain_positions(equations, np.zeros(1))[0]
    faults = []
    for coordinate, value in zip(variant.coordinates, closed, strict=True):
        if coordinate.start is not None and abs(coordinate.start - value) > START_TOLERANCE:
            size = size_of(coordinate.written) or 1.0  # said in the unit that was typed
            typed = coordinate.written if size_of(coordinate.written) else coordinate.unit
            known = {"name": coordinate.name, "unit": typed, "start": coordinate.start / size, "closed": float(value) / size}
            faults.append(_fault(say("fault.V332", **known), coordinate, variant))
    if faults:
        raise InputError(_swaps(equations) or faults)
    return [float(value) for value in closed]


def _swaps(equations: VelocityEquations) -> list[Fault]:
    """Return a fault for the group whose `from` or `coordinates`, in the other order, close where the start values are."""
    variant = equations.variant
    if _closes_near_start(variant):
        return []  # the order is right, a digit is not
    for index, group in enumerate(variant.groups):
        for key, old in (("from", group.start_points), ("coordinates", group.coordinates)):
            if len(old) < 2:
                continue
            name = "start_points" if key == "from" else key
            turned = replace(group, **{name: old[::-1]})  # type: ignore[arg-type]
            groups = (*variant.groups[:index], turned, *variant.groups[index + 1 :])
            if _closes_near_start(replace(variant, groups=groups)):
                listed = ", ".join(f'"{spelled(one) if isinstance(one, Formula) else one}"' for one in old[::-1])
                told = say("fault.V334", number=index + 1, kind=group.kind, key=key, swapped=f"[{listed}]")
                return [Fault(told, variant.file, variant.nearest_line("group", index, key))]
    return []


def _closes_near_start(variant: Variant) -> bool:
    """Return whether the groups of a variant close where its start values are, as far as these have digits."""
    with suppress(InputError, ArithmeticError):
        closed = chain_positions(differentiate(build(variant)), np.zeros(1))[0].tolist()
        starts = zip(variant.coordinates, closed, strict=True)
        return all(coordinate.start is None or abs(coordinate.start - value) < _ROUNDED for coordinate, value in starts)
    return False


def _closed(closure: Closure, start: Array, moved: list[int]) -> Array:
    """Return the closed position nearest to a start of which only the `moved` coordinates may change."""
    q = start.copy()
    columns = [closure.free.index(place) for place in moved]
    rows = [index for index, position in enumerate(closure.equations.positions) if position.target == "zero"]
    for _ in range(MAX_NEWTON):
        residual, jacobian = closure.residual(0.0, q, closure.origin)
        step = np.linalg.lstsq(jacobian[np.ix_(rows, columns)], -residual[rows], rcond=None)[0]
        size = float(np.max(np.abs(step), initial=0.0))
        if not size < _WIDE:
            break
        q[moved] += step
        if size < _SETTLED:
            return q
    variant = closure.equations.variant
    raise InputError([_fault(say("fault.V333"), variant.coordinates[moved[0]], variant)])


def _fault(message: Sentence, coordinate: Coordinate, variant: Variant) -> Fault:
    return Fault(message, variant.file, variant.line_of("coordinates", coordinate.name))
