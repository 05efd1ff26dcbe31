"""A line that is right but for a number, or a law of the drive, that is not the task's: which stands in place of which.

Enters: a wrong line, a `Probe`.  Leaves: `OwnNumber`.  Used by `equations.py`.
Equations are asked for, not numbers: whoever writes letters has no number to copy wrongly, and whoever gives the drive on a line
of its own loses nothing in the others. A number for another datum is a wrong length; a sign or a factor of a law is a slip.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np

from coursework.grading.marking.equations.linear import linear
from coursework.grading.marking.equations.numbers import NoValue, real, size_of, value_of
from coursework.grading.marking.equations.probe import Probe, with_data
from coursework.grading.marking.key.key import Key
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, constant, mapped, named, spelled
from coursework.variant.record.variant import Variant

_LONGEST, _MOST = 150, 200  # nodes of a line that is examined, and numbers tried in place of others
_OTHER = 1.1  # part of a datum's value for which a line is tried, too
_SAME = 1e-9  # relative difference up to which two numbers, or two laws up to a factor, are the same


@frozen
class OwnNumber:
    """What is `written` in place of `meant`, a datum or law of the task, and the line's tree with that instead."""

    written: str
    meant: str
    tree: Formula


def own_numbers(tree: Formula, key: Key, probe: Probe, near: float) -> Iterator[OwnNumber]:
    """Yield the ways to put one datum or law of the task into a line that leave at most `near` of its terms at each point.

    A line with a datum must be right for a mechanism with any other value of it, too: a factor may equal a datum by chance.
    """
    variant = key.variant
    if any(islice(tree.walk(), _LONGEST, None)):
        return
    try:
        told = {one.name: f"{one.name} = {one.text} {one.unit}".rstrip() for one in variant.given}
        told |= {law.name: f"{law.name} = {spelled(law.formula)}" for law in variant.drive if law.formula is not None}
        allowed = near * (float(np.median(real(size_of(tree, probe.names), probe.count))) or 1.0)
        for part, name in islice(_in_place_of(tree, variant, probe), _MOST):
            mended = _with(tree, part, named(name))
            if not np.all(np.abs(real(value_of(mended, probe.names), probe.count)) <= allowed):
                continue
            other = {name: _OTHER * variant.values[name]} if name in variant.values else {}
            if not other or linear(mended, with_data(key, probe, other)).is_near(near):
                yield OwnNumber(spelled(part), told[name], mended)
    except NoValue:
        return


def _in_place_of(tree: Formula, variant: Variant, probe: Probe) -> Iterator[tuple[Formula, str]]:
    """Yield parts of a line without coordinates and unknowns, each with a datum or driven velocity that it may stand for."""
    named_too = {*tree.names()}
    laws = {one.name: real(probe.names[one.name], probe.count) for one in variant.drive if one.formula is not None}
    numbers = [(one.name, one.value, one.si) for one in variant.given]
    numbers += [(name, float(law[0]), name) for name, law in laws.items() if np.ptp(law) <= _SAME * abs(law[0])]
    units = {si for name, _, si in numbers if name in named_too}  # where one length is a letter, no number is a length
    parts = dict.fromkeys(node for node in tree.walk() if {*node.names()} <= {"t", "pi", *variant.values})
    for part in sorted(parts, key=lambda part: "t" in part.names()):  # one number is likelier than a whole law
        if {*part.names()} <= {"pi"}:
            if part.op != "number" and (part.op == "name" or constant(part) is not None):
                continue  # 2*0.7 is a factor and a length
            value = float(real(value_of(part, probe.names), 1)[0])
            taken = {si for _, other, si in numbers if abs(value - other) <= _SAME * abs(other)}
            yield from ((part, name) for name, other, si in numbers if value * other > 0 and si not in taken | units)
        elif "t" in part.names():
            own = real(value_of(part, probe.names), probe.count)
            if not any(_are_same(np.abs(own), np.abs(law)) for law in laws.values()):
                yield from ((part, name) for name, law in laws.items() if name not in named_too and _is_other(own, law))


def _is_other(own: Array, law: Array) -> bool:
    """Return whether a law is no multiple of another one, which varies."""
    return bool(np.ptp(law)) and not _are_same(own * law[0], law * own[0])


def _are_same(one: Array, other: Array) -> bool:
    return bool(np.max(np.abs(one - other)) <= _SAME * np.max(np.abs(other)))


def _with(tree: Formula, part: Formula, by: Formula) -> Formula:
    """Return a formula with another one wherever a part of it stands."""
    return by if tree == part else mapped(tree, lambda arg: _with(arg, part, by))
