"""Terms of written equations that are zero for the data of the file, so that a wrong sign there has no effect.

Enters: velocity equations and their closure.  Leaves: the closure with the agreeing and unjudged equations and such terms.
Used by `way_to_motion.py`.
An example is u*sin(gamma) with a horizontal guide.  Other data show whether its sign is right: if the equation still agrees
with the geometry, the sign is right; if not, the equation is right for these data only.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.motion.geometry.closure import Closure, compile_closure
from coursework.motion.geometry.judging.agreement import agrees, require_agreement
from coursework.motion.geometry.judging.open_loops import require_loops_closed
from coursework.motion.geometry.judging.rigid import require_hinges_at_rest, require_rigid
from coursework.motion.geometry.judging.turning import require_turning
from coursework.variant.formula.made import as_read
from coursework.variant.formula.tree import Formula, on_axes, signed
from coursework.variant.record.no_value import known_value
from coursework.words.errors import InputError

# Change of a datum for the trial: this share of it, or this much (rad, m) if it is zero.
_MOVED = 0.01
# `_ANY` gives trial values to names that are no data; a term below `_ZERO` at these values is zero.
_ANY, _ZERO = 0.6180339887498949, 1e-12


def judged(equations: VelocityEquations, closure: Closure | None) -> Closure | None:
    """Return the closure with the verdict on the written equations.  Raises `InputError` naming each contradictory one."""
    if closure is None:
        return None
    try:
        found = require_agreement(equations, closure)
    except InputError as error:
        require_hinges_at_rest(equations, closure)
        require_loops_closed(equations, closure, error.faults)
        require_rigid(equations, closure)
        raise
    rigid = require_rigid(equations, closure)
    require_turning(equations, closure, rigid)
    closure = replace(closure, agreed=found.agreed, unjudged=found.unjudged)
    return replace(closure, unseen=_unseen_signs(equations, closure))


def _unseen_signs(equations: VelocityEquations, closure: Closure) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the written equations that agree for these data only, each with its terms that these data make zero."""
    found = []
    for one in equations.equations:
        zero = _zeros(one, equations) if one.name in closure.agreed else []
        if zero and not _agrees_otherwise(one, zero, equations, closure):
            found.append((one.name, tuple(dict.fromkeys(map(_shown, zero)))))
    return tuple(found)


def _shown(term: Formula) -> str:
    plain = on_axes(term)
    return as_read(plain.args[0] if plain.op == "neg" else plain)


def _zeros(one: VelocityEquation, equations: VelocityEquations) -> list[Formula]:
    """Return the terms in the sums of a written equation that contain a datum and are zero in every position."""
    data = equations.variant.values
    names = {name for side in one.written or () for name in side.names()}
    values = {name: data.get(name, _ANY * (2 + place)) for place, name in enumerate(sorted(names))}
    terms = [term for side in one.written or () for term in _terms(side)]
    sizes = [(term, known_value(term, values)) for term in terms if data.keys() & {*term.names()}]
    return [term for term, size in sizes if size is not None and abs(size) < _ZERO]


def _terms(formula: Formula) -> Iterator[Formula]:
    """Yield the terms of every sum in a formula, outer sums first."""
    for part in (formula, *(node for node in formula.walk() if node.op in {"+", "-"})):
        yield from (term for term, _ in signed(part))


def _agrees_otherwise(one: VelocityEquation, zero: list[Formula], equations: VelocityEquations, closure: Closure) -> bool:
    """Return whether an equation still agrees with the geometry after the data in its zero terms have been changed."""
    moved = {name for term in zero for name in term.names()}
    variant = equations.variant
    values = {datum.name: datum.value * (1 + _MOVED) or _MOVED for datum in variant.given if datum.name in moved}
    others = [each for each in equations.equations if not each.written]
    own = replace(equations, variant=variant.with_values(values), equations=(*others, one))
    try:
        near = compile_closure(own, closure.start.tolist())
        return near is not None and agrees(own, near)
    except InputError:
        return False
