"""Terms of written equations that are zero with the data of the file: a sign turned there changes nothing, and is not judged.

Enters: velocity equations and their closure.  Leaves: the closure with what agrees, what is not judged, and such terms.
Used by `way_to_motion.py`.
u*sin(gamma) is such a term where the guide is horizontal.  With other data it shows whether its sign is right: where the
equation agrees with the geometry for them too, it is; where not, the equation is right for these data only.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.motion.geometry.agreement import agrees, require_agreement
from coursework.motion.geometry.closure import Closure, compile_closure
from coursework.motion.geometry.open_loops import require_loops_closed
from coursework.motion.geometry.rigid import require_rigid
from coursework.motion.geometry.turning import require_turning
from coursework.variant.formula.tree import Formula, on_axes, signed, spelled
from coursework.variant.record.no_value import known_value
from coursework.words.errors import InputError

# Of a datum, or of one that is zero (rad, m): so far it is moved.
_MOVED = 0.01
# Values of what is no datum, and the size below which a term of such values is zero.
_ANY, _ZERO = 0.6180339887498949, 1e-12


def judged(equations: VelocityEquations, closure: Closure | None) -> Closure | None:
    """Return a closure with what it says of the written equations.  Raises `InputError` naming each that it contradicts."""
    if closure is None:
        return None
    try:
        found = require_agreement(equations, closure)
    except InputError:
        require_loops_closed(equations, closure)
        require_rigid(equations, closure)
        raise
    require_rigid(equations, closure)
    require_turning(equations, closure)
    closure = replace(closure, agreed=found.agreed, unjudged=found.unjudged)
    return replace(closure, unseen=_unseen_signs(equations, closure))


def _unseen_signs(equations: VelocityEquations, closure: Closure) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the written equations that agree with these data only, each with its terms that are zero with them."""
    found = []
    for one in equations.equations:
        zero = _zeros(one, equations) if one.name in closure.agreed else []
        if zero and not _agrees_otherwise(one, zero, equations, closure):
            found.append((one.name, tuple(dict.fromkeys(map(_shown, zero)))))
    return tuple(found)


def _shown(term: Formula) -> str:
    plain = on_axes(term)
    return spelled(plain.args[0] if plain.op == "neg" else plain)


def _zeros(one: VelocityEquation, equations: VelocityEquations) -> list[Formula]:
    """Return the terms of the sums of a written equation that hold a datum and are zero whatever moves."""
    data = equations.variant.values
    names = {name for side in one.written or () for name in side.names()}
    values = {name: data.get(name, _ANY * (2 + place)) for place, name in enumerate(sorted(names))}
    terms = [term for side in one.written or () for term in _terms(side)]
    sizes = [(term, known_value(term, values)) for term in terms if data.keys() & {*term.names()}]
    return [term for term, size in sizes if size is not None and abs(size) < _ZERO]


def _terms(formula: Formula) -> Iterator[Formula]:
    """Yield the terms of every sum in a formula, the outer ones first."""
    for part in (formula, *(node for node in formula.walk() if node.op in {"+", "-"})):
        yield from (term for term, _ in signed(part))


def _agrees_otherwise(one: VelocityEquation, zero: list[Formula], equations: VelocityEquations, closure: Closure) -> bool:
    """Return whether an equation agrees with the geometry also where the data in its zero terms are moved."""
    moved = {name for term in zero for name in term.names()}
    variant = equations.variant
    given = tuple(
        replace(datum, value=datum.value * (1 + _MOVED) if datum.value else _MOVED) if datum.name in moved else datum
        for datum in variant.given
    )
    others = [each for each in equations.equations if not each.written]
    own = replace(equations, variant=replace(variant, given=given), equations=(*others, one))
    try:
        near = compile_closure(own, closure.start.tolist())
        return near is not None and agrees(own, near)
    except InputError:
        return False
