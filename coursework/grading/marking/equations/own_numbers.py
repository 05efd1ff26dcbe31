"""A line that is right but for its numbers: rounded data, or one or two numbers or a law of the drive that are not the task's.

Enters: a wrong line, a `Probe`.  Leaves: `OwnNumber`.  Used by `equations.py`.
Equations are asked for, not numbers: whoever writes letters has no number to copy wrongly, and whoever gives the drive on a line
of its own loses nothing in the others. A number for another datum is a wrong length; a sign or a factor of a law is a slip, and
so is twice or half a datum, and so is a law with other functions. A number stands for each datum that rounds to it, in mm or cm
as well as in m.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from decimal import Decimal
from itertools import chain, combinations, islice, product
from typing import Any

import numpy as np

from coursework.grading.marking.equations.edits import Values, places
from coursework.grading.marking.equations.linear import linear, usual_size
from coursework.grading.marking.equations.numbers import NoValue, are_same, computed, real, value_of
from coursework.grading.marking.equations.probe import Probe, with_data
from coursework.grading.marking.key.key import Key
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, constant, mapped, named, number, replaced, spelled
from coursework.variant.record.variant import Variant

_LONGEST, _MOST = 150, 200  # nodes of a line that is examined, and numbers tried in place of others
_ROUNDED, _COARSEST = 16, 0.05  # ways to read rounded numbers that are tried, and the part of a datum that rounding may change
_HALF = 0.505  # of the last digit, as for the cells of a table
_OTHER = 1.1  # part of a datum's value for which a line is tried, too
_SAME = 1e-9  # relative difference up to which two numbers, or two laws up to a factor, are the same
_PREFIXES = {"m": 1000, "c": 100}  # a line may be written in mm or cm


@frozen
class OwnNumber:
    """What is `written` in place of `meant`, a datum or law of the task, and the line's tree with that instead.

    Both texts are empty if the line's numbers are only rounded.
    """

    written: str
    meant: str
    tree: Formula


def own_numbers(tree: Formula, key: Key, probe: Probe, near: float) -> Iterator[OwnNumber]:
    """Yield the ways to put rounded data, and one other datum or law of the task, into a line that leave at most `near` of its
    terms at each point.

    A line with a datum must be right for a mechanism with any other value of it, too: a factor may equal a datum by chance.
    """
    variant = key.variant
    if any(islice(tree.walk(), _LONGEST, None)):
        return
    try:
        told = {one.name: f"{one.name} = {one.text} {one.unit}".rstrip() for one in variant.given}
        told |= {law.name: f"{law.name} = {spelled(law.formula)}" for law in variant.drive if law.formula is not None}
        allowed = near * usual_size(tree, probe)
        read = [*islice(_as_rounded(tree, variant, probe), _ROUNDED)]
        known: dict[int, Any] = {}  # values of the parts of all lines into which something is put
        for base in (tree, *(base for base, _ in read)):
            known |= Values(base, probe.names).known

        def is_right(mended: Formula, names: tuple[str, ...]) -> bool:
            with np.errstate(all="ignore"):  # only what was put in, and what holds it, is computed again
                left = computed(mended, probe.names, known)
            if not np.all(np.abs(real(left, probe.count)) <= allowed):
                return False
            others = ({name: _OTHER * variant.values[name]} for name in names if name in variant.values)
            return all(linear(mended, with_data(key, probe, other)).is_near(near) for other in others)

        yield from (OwnNumber("", "", base) for base, rounded in read if is_right(base, tuple(rounded)))
        bases = [(tree, {}), *read[:1]]
        numbers = [(base, [*_numbers_in(base[0], tree.names(), variant, probe)]) for base in bases]
        copied = ((*base, *one) for base, found in numbers for one in found)
        rounded_most = bases[-1]  # with p rounded, 2*VMx would be no multiple of VMx
        laws = ((*rounded_most, *one) for one in _laws_in(rounded_most[0], variant, probe))
        for base, rounded, part, by, name, meant in chain(islice(copied, _MOST), islice(laws, _MOST)):  # one number is likelier
            if is_right(mended := _with(base, part, by), (name,)):
                for of, digits in rounded.items():
                    part = _with(part, named(of), digits)
                yield OwnNumber(spelled(part), meant or told[name], mended)
        pairs = ((base, *pair) for base, found in numbers for pair in _pairs(found, probe))
        for (base, rounded), one, other in islice(pairs, _MOST):
            if is_right(mended := _with(_with(base, *one[:2]), *other[:2]), (*rounded, one[2], other[2])):
                yield OwnNumber(
                    ", ".join(spelled(part) for part, *_ in (one, other)),
                    ", ".join(meant or told[name] for *_, name, meant in (one, other)),
                    mended,
                )
    except NoValue:
        return


def _as_rounded(tree: Formula, variant: Variant, probe: Probe) -> Iterator[tuple[Formula, dict[str, Formula]]]:
    """Yield a line with data in place of some numbers that round them, of all first, and these numbers by datum."""
    numbers = [(path, node) for path, node, *_ in places(tree) if node.op == "number"]
    choices = [
        [(path, by, one.name, node) for one in variant.given for by, value, _ in _scaled(one.name, one.value, one.si)
         if _rounds(node, value, probe) and abs(float(node.value) - value) > _SAME * value]
        for path, node in numbers
    ]  # fmt: skip
    for chosen in product(*([*some, None] for some in choices if some)):
        read, rounded = tree, dict[str, Formula]()
        for path, by, name, node in filter(None, chosen):
            read, rounded[name] = replaced(read, path, by), node
        if rounded:
            yield read, rounded


def _scaled(name: str, value: float, si: str) -> Iterator[tuple[Formula, float, str]]:
    """Yield what a number in a line stands for if it is a datum in m, mm or cm, its size, and what is told of it if not in m."""
    datum = Formula("neg", (named(name),)) if value < 0 else named(name)  # its minus stands before the number
    yield datum, abs(value), ""
    for prefix, scale in _PREFIXES.items() if si in {"m", "m/s"} else ():
        yield Formula("*", (number(scale), datum)), scale * abs(value), f"{name} = {scale * value:g} {prefix}{si}"


def _rounds(part: Formula, value: float, probe: Probe) -> bool:
    """Return whether a number as written is a rounded value; a part that is no number, as 2*pi/3, must equal it."""
    if part.op != "number":
        return bool(abs(real(value_of(part, probe.names), 1)[0] - value) <= _SAME * value)
    digits = Decimal(part.name)
    last = digits.normalize() if digits == digits.to_integral_value() and "." not in part.name else digits
    return abs(float(digits) - value) <= min(_HALF * 10.0 ** int(last.as_tuple().exponent), _COARSEST * value)


def _numbers_in(
    tree: Formula, letters: Collection[str], variant: Variant, probe: Probe
) -> Iterator[tuple[Formula, Formula, str, str]]:
    """Yield numbers in a line, what each may stand for, the name in that, and what is told of it.

    Data and velocities that are `letters` in it are not meant by a number, and where one length is a letter, none is.
    """
    numbers = [(one.name, one.value, one.si) for one in variant.given]
    # Of a drive that rests no number is a copy: any term with a number would be taken away.
    numbers += [
        (name, float(law[0]), name) for name, law in _laws(variant, probe) if law[0] and np.ptp(law) <= _SAME * abs(law[0])
    ]
    units = {si for name, _, si in numbers if name in letters}
    known = [(*one, name, si) for name, value, si in numbers for one in _scaled(name, value, si)]
    for part in dict.fromkeys(node for node in tree.walk() if {*node.names()} <= {"pi"}):
        if part.op != "number" and (part.op == "name" or constant(part) is not None):
            continue  # 2*0.7 is a factor and a length
        if part.op == "number" and part.value == 1:
            continue  # 1*w3 is a velocity without its length
        taken = {(si, name) for _, value, _, name, si in known if _rounds(part, value, probe)}
        for by, value, meant, name, si in known:
            is_another = any(of == si and other != name for of, other in taken)
            if si not in units and not is_another and not any(_rounds(part, factor * value, probe) for factor in (2, 0.5)):
                yield part, by, name, meant


def _pairs(
    found: Collection[tuple[Formula, Formula, str, str]], probe: Probe
) -> Iterator[tuple[tuple[Formula, Formula, str, str], tuple[Formula, Formula, str, str]]]:
    """Yield two numbers in a line that round no datum, each with a datum that no number of the line rounds to."""
    known = {by: abs(float(real(value_of(by, probe.names), probe.count)[0])) for _, by, *_ in found}
    rounding = [one for one in found if _rounds(one[0], known[one[1]], probe)]
    parts, names = {part for part, *_ in rounding}, {name for *_, name, _ in rounding}
    strange = [one for one in found if one[0].op == "number" and one[0] not in parts and one[2] not in names]
    yield from (pair for pair in combinations(strange, 2) if pair[0][0] != pair[1][0] and pair[0][2] != pair[1][2])


def _laws_in(tree: Formula, variant: Variant, probe: Probe) -> Iterator[tuple[Formula, Formula, str, str]]:
    """Yield functions of time in a line, each with a law of the drive for which it may stand, as `_numbers_in` does."""
    laws = _laws(variant, probe)
    kinds = {one.name: _functions(one.formula) for one in variant.drive if one.formula is not None}
    for part in dict.fromkeys(node for node in tree.walk() if "t" in node.names()):
        if {*part.names()} <= {"t", "pi", *variant.values}:
            own = real(value_of(part, probe.names), probe.count)
            if not any(are_same(np.abs(own), np.abs(law), _SAME) for _, law in laws):
                like = _functions(part)
                others = (name for name, law in laws if name not in tree.names() and kinds[name] == like and _is_other(own, law))
                yield from ((part, by, name, "") for name in others for by, *_ in _scaled(name, 1.0, "m/s"))


def _laws(variant: Variant, probe: Probe) -> list[tuple[str, Array]]:
    return [(one.name, real(probe.names[one.name], probe.count)) for one in variant.drive if one.formula is not None]


def _functions(formula: Formula) -> frozenset[str]:
    """Return the functions in a formula, sines and cosines as one: a law that has others than the task's is no form of it."""
    return frozenset("sin" if node.name == "cos" else node.name for node in formula.walk() if node.op == "call")


def _is_other(own: Array, law: Array) -> bool:
    """Return whether a law is no multiple of another one, which varies."""
    return bool(np.ptp(law)) and not are_same(own * law[0], law * own[0], _SAME)


def _with(tree: Formula, part: Formula, by: Formula) -> Formula:
    """Return a formula with another one wherever a part of it stands."""
    if tree.op == part.op and tree == part:
        return by
    return mapped(tree, lambda arg: _with(arg, part, by)) if tree.args else tree
