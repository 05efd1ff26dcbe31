"""Whether the written velocity equations agree with the geometry of the file.

Enters: the written equations, the equations derived from the geometry, closed positions.  Leaves: `Agreement`: which equations
agree and which cannot be judged.  Raises `InputError` naming each equation that contradicts.  Used by `unseen_signs.py`,
`turning.py`, `virtual_power.py`, `motion_results.py`, `motion_equations.py` and `derived.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.closure import CONFIGURATIONS, Closure, compile_closure
from coursework.motion.geometry.judging.compared import looked_at
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen
from coursework.variant.record.entries import reached
from coursework.variant.record.held import followed
from coursework.variant.record.variant import Binding, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# Rank tolerance for rows scaled to length 1: far above round-off, far below the effect of a wrong coefficient or sign.
TOLERANCE = 1e-8
# The same for equations that contradict each other although they fix every velocity: far above what a start with few digits does.
_CLASH = 1e-2
# Pseudo-random data: each value is moved by up to half of `_SPREAD` of itself, each by a different share.
_SPREAD, _GOLDEN = 0.02, 0.6180339887498949
_SMOOTH = {"number", "symbol", "pi", "+", "*", "sin", "cos", "tan", "exp"}


@frozen
class Agreement:
    """Which written equations the geometry confirms.

    `agreed` holds their names; `unjudged` the names of those that it cannot judge, each with the velocities in it that the
    geometry does not determine.
    """

    agreed: tuple[str, ...] = ()
    unjudged: tuple[tuple[str, tuple[str, ...]], ...] = ()


def require_agreement(equations: VelocityEquations, closure: Closure) -> Agreement:
    """Return which written equations the geometry confirms; raise `InputError` naming each that it contradicts.

    An equation is judged only if the geometry determines its velocities: an undetermined unknown could have any coefficient.
    A result that holds for all data is computed once for all variants of a template.
    """
    if not any(equation.written for equation in equations.equations):
        return Agreement()
    zeros = tuple(given.name for given in equations.variant.given if not given.value)
    always = equations.once(("agreed", zeros), lambda: _whatever_the_data(equations, closure))
    return _judged(equations, *looked_at(equations, closure)) if always is None else always


def agrees(equations: VelocityEquations, closure: Closure) -> bool:
    """Return whether the geometry confirms every written equation for the given data.  Raises `InputError` as above."""
    return not _judged(equations, *looked_at(equations, closure)).unjudged


def confirmed(equations: VelocityEquations, closure: Closure | None, start: Sequence[float]) -> tuple[str, ...]:
    """Return the written equations that the geometry confirms.

    Without position equations contacts alone may give all of them in every position, as in a train of gears; else none is.
    """
    if closure is not None or not given_by_geometry(equations):
        return closure.agreed if closure is not None else ()
    shares = np.array([[_GOLDEN * row * place % 1 for place in range(len(start) + 1)] for row in range(1, CONFIGURATIONS + 1)])
    turns = [1.0 if one.unit == "rad" else abs(at) for one, at in zip(equations.variant.coordinates, start, strict=True)]
    with suppress(InputError):  # what does not fit is told where rows are compared with the links
        found = _judged(equations, equations.variant.time.end * shares[:, 1], np.array(start) + shares[:, 1:] * turns)
        return () if found.unjudged else found.agreed
    return ()


def _whatever_the_data(equations: VelocityEquations, closure: Closure) -> Agreement | None:
    """Return what the geometry confirms for all values of the data (zeros stay zero), None if that is not certain.

    Sums, products, sines and whole powers of the data that are equal for data taken at random are equal for all data.
    """
    variant = equations.variant
    if variant.functions or not _is_smooth(equations):
        return None
    values = {one.name: one.value * (1 + _SPREAD * (_GOLDEN * k % 1 - 0.5)) for k, one in enumerate(variant.given, start=1)}
    with suppress(InputError):
        others = replace(equations, variant=variant.with_values(values))
        near = compile_closure(others, closure.start.tolist())
        if near is not None and len(near.configurations[0]) == CONFIGURATIONS:
            looked = looked_at(others, near)
            return _judged(others, *looked) if len(looked[0]) > 1 else None  # a start with drives at rest hides every sign
    return None


def _is_smooth(equations: VelocityEquations) -> bool:
    """Return whether all formulas are smooth (no roots, no absolute values), so that what holds for some data holds for all."""
    both = (*equations.from_closure, *equations.equations, *equations.bound)
    written = [position.expression for position in equations.positions]
    written += [part for equation in both for part in equation.parts]
    parts = {part for expression in written for part in expression.walk()}
    return all(part.op in _SMOOTH or (part.op == "^" and part.args[1].value.denominator == 1) for part in parts)


def _judged(equations: VelocityEquations, times: Array, positions: Array) -> Agreement:
    """Return what the geometry confirms, by comparing the equations as rows at several closed positions (c, m).

    Each equation is a row (A | b).  If the A of a written row lies in the row space of the derived ones, its b must agree with
    theirs; the written rows that are left must not contradict each other.
    """
    _require_free(equations, times, positions)
    written = [equation for equation in equations.equations if equation.written and equation.coefficients]
    derived = given_by_geometry(equations)
    first = len(derived)
    matrix, right, _ = compile_system(equations, [*derived, *written]).matrices(times, positions)
    every = np.concatenate([matrix, right[:, :, None]], axis=2)
    scale = np.max(np.abs(every), axis=1, keepdims=True, initial=0.0)
    every = every / np.where(scale > 0, scale, 1.0)
    lengths = np.linalg.norm(every, axis=2, keepdims=True)
    every = every / np.where(lengths > 0, lengths, 1.0)
    # Where the written equations contradict each other too, they are charged instead, or the drives.
    if _clashing(every[:, :first]).all() and not _clashing(every[:, first:]).all():
        raise InputError(_clash(equations, derived, every[:, :first], _clashing))
    if len(written) and _contradictory(every[:, :first]).all() and not _contradictory(every[:, first:]).all():
        beside = _beside(equations, derived, times, positions)
        if _contradictory(beside).all():
            raise InputError(_clash(equations, derived, beside, _contradictory))
    # A dead point, where the geometry alone cannot follow its drive, is reported elsewhere.
    sound = every[~_contradictory(every[:, :first])]
    if _contradictory(sound).any():
        raise InputError(_faults(equations, derived, written, sound))
    known = sound[:, :first, :-1]
    regular = _ranks(known) == np.max(_ranks(known), initial=0)
    known, axes = known[regular], np.eye(known.shape[2])
    follows = [gives(known, sound[regular, place, :-1]) for place in range(first, sound.shape[1])]
    unknown = [name for name, axis in zip(equations.unknowns, axes, strict=True) if not gives(known, axis)]
    agreed = [one.name for one in equations.equations if one.written and not one.coefficients]  # held against the drives
    agreed += [one.name for one, does in zip(written, follows, strict=True) if does]
    rest = [one for one, does in zip(written, follows, strict=True) if not does]
    return Agreement(
        tuple(agreed), tuple((one.name, tuple(name for name in unknown if name in one.coefficients)) for one in rest)
    )


def given_by_geometry(equations: VelocityEquations) -> list[VelocityEquation]:
    """Return the velocity equations that are derived from points, links and closures, not written in the file."""
    return [*(one for one in equations.equations if not one.written), *equations.from_closure, *equations.bound]


def gives(rows: Array, one: Array) -> bool:
    """Return whether the row `one`, (n,) or (c, n), lies in the row space of `rows` (c, k, n) at every configuration."""
    with_it = np.concatenate([rows, np.broadcast_to(one, (len(rows), rows.shape[2]))[:, None]], axis=1)
    return bool(len(rows)) and bool(np.all(_ranks(with_it) == _ranks(rows)))


def _faults(
    equations: VelocityEquations, derived: Sequence[VelocityEquation], written: Sequence[VelocityEquation], every: Array
) -> list[Fault]:
    """Return a fault for each written equation that alone contradicts the derived ones, else one for those that do together."""
    file, first = equations.variant.file, len(derived)
    alone = [place for place in range(first, every.shape[1]) if _contradictory(every[:, [*range(first), place]]).any()]
    if not alone:
        suspects = set(range(first, every.shape[1]))
        others = [[*range(row), *range(row + 1, every.shape[1])] for row in sorted(suspects)]  # all rows but a written one
        for culprits in _contradictory(every[_contradictory(every)][:, others]):
            suspects -= {first + place for place in np.flatnonzero(culprits).tolist()}
        found = [written[place - first] for place in sorted(suspects)]
        if not found:
            return [Fault(say("fault.V301", sections=_sections(equations)), file, written[0].line)]
        if len(found) > 1:
            names = "; ".join(f"{each.name} (:{each.line})" for each in found)
            return [Fault(say("fault.V303", names=names, sections=_sections(equations)), file, found[0].line)]
        alone = sorted(suspects)
    faults = []
    for place in alone:
        one = written[place - first]
        rows = every[:, [*range(first), place]]
        bound = next((bound for bound in equations.variant.bindings if bound.name in one.coefficients), None)
        about = _of_bound(bound, equations, rows) if bound else ""
        known = {"name": one.name, "sections": _sections(equations), "advice": say("fault.contradicts.derive")}
        faults.append(Fault(say("fault.V302", **known, about=about), file, one.line))
    return faults


def _beside(equations: VelocityEquations, derived: Sequence[VelocityEquation], times: Array, positions: Array) -> Array:
    """Return the derived equations as rows (c, k, n + 1) at positions that are no dead points, because nothing closes there."""
    moved = positions + _SPREAD * (_GOLDEN * np.arange(1, positions.size + 1).reshape(positions.shape) % 1 - 0.5)
    matrix, right, _ = compile_system(equations, derived).matrices(times, moved)
    return np.concatenate([matrix, right[:, :, None]], axis=2)


def _clash(
    equations: VelocityEquations, derived: Sequence[VelocityEquation], every: Array, have_none: Callable[[Array], Flags]
) -> list[Fault]:
    """Return a fault that names the derived equations of which one at least must be wrong; `have_none` tests for a solution."""
    rest = [np.delete(every, place, axis=1) for place in range(len(derived))]
    suspects = [one for one, others in zip(derived, rest, strict=True) if not have_none(others).all()]
    names = tuple(one.name for one in suspects or derived)
    line = equations.variant.nearest_line("closure") if equations.from_closure else derived[0].line
    return [Fault(say("fault.V320", names=names, sections=_sections(equations)), equations.variant.file, line)]


def _sections(equations: VelocityEquations) -> tuple[str, ...]:
    """Return the names of the sections of the file that describe its geometry."""
    if equations.from_closure:
        if ("closure",) in equations.variant.lines:
            return "[points]", "[closure]"
        variant = equations.variant
        return "[points]", *(["[frame]"] if variant.holds else []), *(["[drive]"] if variant.driven else [])
    return "[points]", "[[group]]" if equations.variant.groups else "closure = …" if equations.positions else "[unknowns]"


def _of_bound(bound: Binding, equations: VelocityEquations, rows: Array) -> Sentence:
    """Return a sentence about the bound unknown in the last row: whether the row would agree with the unknown's sign reversed.

    Only a velocity along a direction can have its sign reversed; the rate of a link cannot.
    """
    turned = rows.copy()
    turned[:, -1, equations.unknowns.index(bound.name)] *= -1
    agrees_turned = bound.along is not None and not _contradictory(turned).any()
    key = "fault.bound.other_way" if agrees_turned else "fault.bound.is_right"
    return say(key, name=bound.name, line=equations.variant.nearest_line("unknowns", bound.name))


def _of_still_point(name: str, variant: Variant) -> Sentence | None:
    """Return how a driven point is made to move if no coordinate places it; None if one does."""
    point, _, axis = name.partition(".")
    places = dict(variant.points)
    if point not in places or f"V{point}{axis}" not in followed(variant):
        return None
    if {one.name for one in variant.coordinates} & reached([point], places):
        return None
    return say("fault.V304.still", point=point, axis=axis, law=f"V{point}{axis}")


def _require_free(equations: VelocityEquations, times: Array, positions: Array) -> None:
    """Raise `InputError` if driven coordinates alone move something that [closure] holds or drives otherwise."""
    variant = equations.variant
    bound = [equation for equation in equations.from_closure if not equation.coefficients]
    if not bound:
        return
    faults = []
    rights = compile_system(equations, bound).matrices(times, positions)[1]
    for equation, largest in zip(bound, np.max(np.abs(rights), axis=0), strict=True):
        if largest > TOLERANCE:
            told = _of_still_point(equation.name, variant) or say(
                "fault.V304.moved", name=equation.name, largest=float(largest), because=equation.because
            )
            faults.append(Fault(told, variant.file, variant.line_of("closure")))
    if faults:
        raise InputError(faults)


def _clashing(rows: Array) -> Flags:
    """Return which of the systems (…, k, n) fix every velocity in them yet have no solution: no dead point explains that."""
    kept = np.append(np.any(rows[..., :-1] != 0, axis=tuple(range(rows.ndim - 1))), True)
    rows = rows[..., kept]
    return np.asarray((_ranks(rows[..., :-1], _CLASH) == rows.shape[-1] - 1) & (_ranks(rows, _CLASH) == rows.shape[-1]))


def _contradictory(rows: Array) -> Flags:
    """Return which of the systems (…, k, n), with their right sides in the last column, have no solution (…)."""
    return np.asarray(_ranks(rows) > _ranks(rows[..., :-1]))


def _ranks(matrices: Array, tolerance: float = TOLERANCE) -> NDArray[np.int_]:
    """Return the ranks (…) of matrices (…, k, n)."""
    sizes = np.linalg.svd(matrices, compute_uv=False)
    largest = np.maximum(np.max(sizes, axis=-1, keepdims=True, initial=0.0), 1e-300)
    return np.asarray(np.sum(sizes > tolerance * largest, axis=-1))
