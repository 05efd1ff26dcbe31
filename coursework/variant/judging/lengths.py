"""Links without length, whose angular velocities mean nothing, and of a negative one: refused before anything is computed.

Enters: a `Variant` and its `Source`.  Leaves: faults.  Used by `whole_file.py`; the sentence about a length that becomes negative
during the motion is told by `motion/geometry/chain.py`.  Source: hard case H16.
"""

from __future__ import annotations

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, spelled
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def faults_of_lengths(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each length behind @ or of a group that is zero, for each of a dyad that is negative, and for each
    velocity that only zeros multiply.
    """
    lengths: list[tuple[KeyPath, Formula]]
    lengths = [(path, node.args[0]) for path, formula in variant.formulas() for node in formula.walk() if node.op == "@"]
    lengths += [(("group", i, "lengths", j), f) for i, group in enumerate(variant.groups) for j, f in enumerate(group.lengths)]
    found = dict.fromkeys((path, spelled(length)) for path, length in lengths if _value(length, variant) == 0)
    faults = [source.fault(path, say("fault.V087", text=text)) for path, text in found]
    return faults + _negative(variant, source) or _lost(variant, source)


def refused_length(reason: str) -> Sentence:
    """Return what is told of a group with a length that no rod can have."""
    return say("fault.V308", reason=reason)


def _negative(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each rod of a dyad whose length is below zero; a crank that is given so only points the other way."""
    faults = []
    for i, group in enumerate(variant.groups):
        for j, length in enumerate(group.lengths if len(group.coordinates) > 1 else ()):
            value = _value(length, variant)
            if value is not None and value < 0:
                reason = say("group.positive.alone", what=spelled(length), found=value, row=0)
                faults.append(source.fault(("group", i, "lengths", j), refused_length(reason)))
    return faults


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
            *_beside_zero(first, variant, zero or (spelled(second) if _value(second, variant) == 0 else "")),
            *_beside_zero(second, variant, zero or (spelled(first) if _value(first, variant) == 0 else "")),
        ]
    return [entry for arg in tree.args for entry in _beside_zero(arg, variant, zero)]


def _value(length: Formula, variant: Variant) -> float | None:
    """Return a length that follows from the data alone (m), None for any other."""
    if not {*length.names()} <= {*variant.values, "pi"}:
        return None
    try:
        return evaluate(length, variant.values)
    except FormulaFault:
        return None
