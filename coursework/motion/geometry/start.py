"""The coordinates at t = 0: from the file, from a chain of groups, or adapted to changed data.

Enters: velocity equations and the variant's start values.  Leaves: the start (m,), rad or m.
Used by `way_to_motion.py`, by models of many sets and by the live page.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations, differentiate
from coursework.equations.reduction.system import compile_values
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

# A start value that differs by more than this (rad or m) is another position, not a rounded value.
START_TOLERANCE = 1e-6
# A Newton correction larger than `_WIDE` (rad or m) leads to another assembly; one below `_SETTLED` ends the iteration.
_WIDE, _SETTLED = 10.0, 1e-12
_ROUNDED = 0.02  # largest rounding error of a start value with two digits (rad or m); a wrong order of entries gives more


def start_values(equations: VelocityEquations) -> list[float]:
    """Return the coordinates at t = 0; groups give those the file leaves out, the closure those that follow from other data.

    Raises `InputError` if a written start is not the position in which the groups close, or if no closed one lies nearby.
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
            size = size_of(coordinate.written) or 1.0  # shown in the unit that was typed
            typed = coordinate.written if size_of(coordinate.written) else coordinate.unit
            known = {"name": coordinate.name, "unit": typed, "start": coordinate.start / size, "closed": float(value) / size}
            faults.append(_fault(say("fault.V332", **known), coordinate, variant))
    if faults:
        raise InputError(_swaps(equations) or faults)
    return [float(value) for value in closed]


def _swaps(equations: VelocityEquations) -> list[Fault]:
    """Return a fault for a group that closes at the start values with `from` or `coordinates` reversed; empty if none does."""
    variant = equations.variant
    if _closes_near_start(variant):
        return []  # the order is right, but a digit is wrong
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
    """Return whether the groups of a variant close at its start values, within the rounding of these."""
    with suppress(InputError, ArithmeticError):
        closed = chain_positions(differentiate(build(variant)), np.zeros(1))[0].tolist()
        starts = zip(variant.coordinates, closed, strict=True)
        return all(coordinate.start is None or abs(coordinate.start - value) < _ROUNDED for coordinate, value in starts)
    return False


def _closed(closure: Closure, start: Array, moved: list[int]) -> Array:
    """Return the closed position nearest to `start`, changing only the coordinates in `moved`."""
    q = start.copy()
    columns = [closure.free.index(place) for place in moved]
    kept = kept_at_start(closure.equations, len(columns))
    rows, target = [*kept], np.zeros(len(closure.names))
    target[rows] = [float(value) for value in kept.values()]
    for _ in range(MAX_NEWTON):
        residual, jacobian = closure.residual(0.0, q, target)
        step = np.linalg.lstsq(jacobian[np.ix_(rows, columns)], -residual[rows], rcond=None)[0]
        size = float(np.max(np.abs(step), initial=0.0))
        if not size < _WIDE:
            break
        q[moved] += step
        if size < _SETTLED:
            return q
    variant = closure.equations.variant
    raise InputError([_fault(say("fault.V333"), variant.coordinates[moved[0]], variant)])


def kept_at_start(equations: VelocityEquations, most: int) -> dict[int, Fraction]:
    """Return the position equations, by index, that hold at the start for other data, with their values.

    A loop is zero, and what else is held keeps its value before; only loops if there are more than `most` of both.
    """
    positions, before = equations.positions, equations.variant.before or equations.variant
    loops = {place: Fraction(0) for place, position in enumerate(positions) if position.closes}
    held = [place for place, position in enumerate(positions) if position.target == "start" and place not in loops]
    if not loops or not held or len(loops) + len(held) > most:
        return loops
    values, _ = compile_values(replace(equations, variant=before), [positions[place].expression for place in held])
    with suppress(ArithmeticError, ValueError):
        now = values(0.0, *(one.start_or_guess for one in before.coordinates))
        return loops | {place: Fraction(repr(float(value))) for place, value in zip(held, now, strict=True)}
    return loops


def _fault(message: Sentence, coordinate: Coordinate, variant: Variant) -> Fault:
    return Fault(message, variant.file, variant.line_of("coordinates", coordinate.name))
