"""The value and the time derivative of one formula node in each row, from those of its arguments.

Enters: a node and the components of its arguments.  Leaves: `Moving` components, not finite in rows without a value.
Used by `reason.py` only, to explain a failure; no number of the results comes from here.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula


class Moving(NamedTuple):
    """A quantity in some rows: its `value` and its time derivative `slope` (per second)."""

    value: Array
    slope: Array


Components = tuple[Moving, ...]  # one of a scalar, two of a vector
Rule = Callable[[Array], Array]
_CALLS: dict[str, tuple[Rule, Rule]] = {
    "sin": (np.sin, np.cos),
    "cos": (np.cos, lambda x: -np.sin(x)),
    "tan": (np.tan, lambda x: 1 / np.cos(x) ** 2),
    "asin": (np.arcsin, lambda x: 1 / np.sqrt(1 - x**2)),
    "acos": (np.arccos, lambda x: -1 / np.sqrt(1 - x**2)),
    "atan": (np.arctan, lambda x: 1 / (1 + x**2)),
    "sqrt": (np.sqrt, lambda x: 1 / (2 * np.sqrt(x))),
    "exp": (np.exp, np.exp),
    "log": (np.log, lambda x: 1 / x),
    "abs": (np.abs, np.sign),
}


def applied(node: Formula, args: list[Components]) -> Components:
    """Return the components of `node`; `args` are those of its arguments."""
    if node.op == "pair":
        return args[0][0], args[1][0]
    if node.op == "@":
        length, angle = args[0][0], args[1][0]
        return _times(length, _called("cos", angle)), _times(length, _called("sin", angle))
    if node.op == "part":
        return (args[0]["xy".index(node.name.lstrip("."))],)
    if node.op == "neg":
        return tuple(Moving(-part.value, -part.slope) for part in args[0])
    if node.op == "call":
        single = [arg[0] for arg in args]
        return (_turned(*single) if node.name == "atan2" else _called(node.name, single[0]),)
    longest = max(len(arg) for arg in args)
    broad = [arg if len(arg) == longest else arg * longest for arg in args]
    return tuple(_ARITHMETIC[node.op](*parts) for parts in zip(*broad, strict=True))


def _called(name: str, arg: Moving) -> Moving:
    value, slope = _CALLS[name]
    return Moving(value(arg.value), _moved(slope(arg.value), arg.slope))


def _moved(factor: Array, slope: Array) -> Array:
    """Return factor*slope; 0 if the argument is constant (`slope` 0 in all rows), even where `factor` is not finite."""
    return factor * slope if slope.any() else np.zeros_like(slope)


def _turned(y: Moving, x: Moving) -> Moving:
    size = x.value**2 + y.value**2
    return Moving(np.arctan2(y.value, x.value), _moved(x.value / size, y.slope) - _moved(y.value / size, x.slope))


def _times(a: Moving, b: Moving) -> Moving:
    return Moving(a.value * b.value, a.slope * b.value + a.value * b.slope)


def _over(a: Moving, b: Moving) -> Moving:
    value = a.value / b.value
    return Moving(value, (a.slope - value * b.slope) / b.value)


def _power(a: Moving, b: Moving) -> Moving:
    return Moving(np.power(a.value, b.value), _moved(b.value * np.power(a.value, b.value - 1), a.slope))  # exponents are numbers


_ARITHMETIC: dict[str, Callable[[Moving, Moving], Moving]] = {
    "+": lambda a, b: Moving(a.value + b.value, a.slope + b.slope),
    "-": lambda a, b: Moving(a.value - b.value, a.slope - b.slope),
    "*": _times, "/": _over, "^": _power,
}  # fmt: skip
