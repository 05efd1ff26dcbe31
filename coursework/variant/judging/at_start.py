"""Check that the formulas of a file have values at t = 0, before anything is differentiated.

Enters: a `Variant` and its `Source`.  Leaves: faults.  Used by `reader.py` only.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate
from coursework.variant.judging.broken import Broken
from coursework.variant.record.no_value import in_order
from coursework.variant.record.variant import Law, Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say


def faults_at_start(variant: Variant, source: Source, broken: Broken) -> list[Fault]:
    """Return faults for laws, forces and velocity equations without a value at t = 0, or for laws that need themselves.

    If a law needs itself, directly or through others, only such laws are reported.  Anything `broken` has no value, and neither
    has a formula that needs it.  Formulas with points, tables or coordinates that a chain will give are not checked here.
    """
    laws = {law.name: law for law in (*variant.functions, *variant.drive)}
    places = {name: source.path_of(variant.path_of(name)) for name in laws}
    circles = {
        frozenset(circle): circle for name in reversed(laws) if (circle := _circle(name, laws))
    }  # each once, at its first law
    if circles:
        return [source.fault(places[circle[0]], say("fault.V057", circle=" → ".join(circle))) for circle in circles.values()]
    placed = [c for c in variant.coordinates if c.start is not None and not broken.has("coordinates", c.name)]
    values = {"t": 0.0, **broken.sound(variant).values, **{c.name: c.start for c in placed if c.start is not None}}
    faults: list[Fault] = []
    for law in in_order(variant):
        path = (*places[law.name], "pieces", 0, 1) if law.pieces else places[law.name]
        for formula in () if broken.has(*variant.path_of(law.name)) else law.formulas[:1]:
            if (value := _value(formula, values, path, source, faults)) is not None:
                values[law.name] = value
    if (forces := variant.forces) is not None:
        at_once = {**values, **{law.name: 0.0 for law in forces.free}, **dict(forces.motor.start if forces.motor else ())}
        for path, formula, _ in forces.measured():
            if not broken.has(*path[:2]):
                _value(formula, at_once, path, source, faults)
    for section, size, entries in (("rails", "angle", variant.frame.rails), ("circles", "radius", variant.frame.circles)):
        for place, (_, formula) in enumerate(entries):
            _value(formula, values, ("frame", section, place, size), source, faults)
    # Any velocities will do: an equation is linear in them; if it is not, this is reported elsewhere.
    values |= {name: 1.0 + 0.1 * place for place, name in enumerate(variant.sought)}
    for index, constraint in enumerate(variant.constraints):
        for side in () if constraint.is_closure or broken.has("constraint", index) else constraint.sides:
            _value(side, values, ("constraint", index, "equation"), source, faults)
    return faults


def _value(formula: Formula, values: Mapping[str, float], path: KeyPath, source: Source, faults: list[Fault]) -> float | None:
    """Return the value of a formula; None if it needs a name not known yet, or after a fault."""
    if not {*formula.names()} <= {*values, "pi"}:
        return None
    try:
        return evaluate(formula, values)
    except FormulaFault as fault:
        faults.append(source.fault(path, say("fault.V086", message=fault.message), fault.column))
        return None


def _circle(name: str, laws: Mapping[str, Law]) -> tuple[str, ...]:
    """Return the chain of names from a law back to itself, empty if there is none."""
    ways: list[tuple[str, ...]] = [(name,)]
    seen: set[str] = set()
    while ways:
        way = ways.pop()
        for needed in (n for formula in laws[way[-1]].formulas for n in formula.names() if n in laws):
            if needed == name:
                return (*way, name)
            if needed not in seen:
                seen.add(needed)
                ways.append((*way, needed))
    return ()
