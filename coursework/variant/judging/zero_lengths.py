"""Links without length: their angular velocities mean nothing, so they are refused before anything is computed.

Enters: a `Variant` and its `Source`.  Leaves: faults.  Used by `reader.py` only.  Source: hard case H16.
"""

from __future__ import annotations

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, spelled
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say


def faults_of_zero_lengths(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each length behind @ or of a group that is zero, and for each velocity that only zeros multiply."""
    lengths: list[tuple[KeyPath, Formula]]
    lengths = [(path, node.args[0]) for path, formula in variant.formulas() for node in formula.walk() if node.op == "@"]
    lengths += [(("group", i, "lengths", j), f) for i, group in enumerate(variant.groups) for j, f in enumerate(group.lengths)]
    found = dict.fromkeys((path, spelled(length)) for path, length in lengths if _is_zero(length, variant))
    faults = [source.fault(path, say("fault.V087", text=text)) for path, text in found]
    return faults or _lost(variant, source)


def _lost(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each unknown velocity of the written equations that stands only beside a length of zero."""
    kept: set[str] = set()
    beside: dict[str, tuple[str, int]] = {}
    for index, constraint in enumerate(variant.constraints):
        for side in (constraint.left, constraint.right):
            for name, zero in _beside_zero(side, variant, ""):
                if zero:
                    beside.setdefault(name, (zero, index))
                else:
                    kept.add(name)
    faults = []
    for name, (zero, index) in beside.items():
        if name not in kept and name in variant.sought:
            message = say("fault.V088", name=name, zero=zero)
            faults.append(source.fault(("constraint", index, "equation"), message))
    return faults


def _beside_zero(tree: Formula, variant: Variant, zero: str) -> list[tuple[str, str]]:
    """Return every name with the factor of zero it stands beside, "" for none."""
    if tree.op == "name":
        return [(tree.name, zero)]
    if tree.op == "*":
        first, second = tree.args
        return [
            *_beside_zero(first, variant, zero or (spelled(second) if _is_zero(second, variant) else "")),
            *_beside_zero(second, variant, zero or (spelled(first) if _is_zero(first, variant) else "")),
        ]
    return [entry for arg in tree.args for entry in _beside_zero(arg, variant, zero)]


def _is_zero(length: Formula, variant: Variant) -> bool:
    if not {*length.names()} <= {*variant.values, "pi"}:
        return False
    try:
        return evaluate(length, variant.values) == 0
    except FormulaFault:
        return False
