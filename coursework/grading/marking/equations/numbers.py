"""The value of a checked formula from numbers for its names: many rows at once, without generated code or SymPy.

Enters: `Formula` trees and arrays.  Leaves: arrays; vectors are complex numbers.  NaN where there is no value.
Used by the marks of equations, where each line is new and evaluated once: to compile it would cost a thousand times more.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula

_CALLS: dict[str, Any] = {
    "sin": np.sin, "cos": np.cos, "tan": np.tan, "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "sqrt": np.sqrt,
    "exp": np.exp, "log": np.log, "abs": np.abs, "atan2": np.arctan2,
}  # fmt: skip


_ARITHMETIC: dict[str, Any] = {"+": np.add, "-": np.subtract, "*": np.multiply, "/": np.divide}
_OF_NUMBERS: dict[str, Any] = {
    "pair": lambda x, y: x + 1j * np.asarray(y),
    "@": lambda length, angle: length * np.exp(1j * np.asarray(angle)),
    "^": lambda base, power: np.power(np.asarray(base, dtype=float), power),
}


class NoValue(ValueError):
    """A formula has no value at all: a vector stands where a number is needed, or the other way round."""


def value_of(tree: Formula, names: Mapping[str, Any]) -> Any:
    """Return the value of a formula; `names` maps names to floats, arrays (n,), or complex arrays for points.

    Raises `NoValue`.
    """
    with np.errstate(all="ignore"):
        return computed(tree, names, {})


def size_of(tree: Formula, names: Mapping[str, Any]) -> Any:
    """Return the sum (n,) of the absolute values of a formula's terms, with which its value is compared."""
    with np.errstate(all="ignore"):
        return _size(tree, names)


def computed(tree: Formula, names: Mapping[str, Any], known: Mapping[int, Any]) -> Any:
    """Return the same as `value_of`, for callers that have silenced NumPy's warnings themselves.

    `known` maps the id of nodes to values that need not be computed again.
    """
    if id(tree) in known:
        return known[id(tree)]
    return combined(tree, [computed(arg, names, known) for arg in tree.args], names)


def combined(tree: Formula, args: list[Any], names: Mapping[str, Any]) -> Any:
    """Return the value of one node from the values of its arguments.  Raises `NoValue`."""
    op = tree.op
    if op in _ARITHMETIC:
        return _ARITHMETIC[op](*args)
    if op == "number":
        return float(tree.name)
    if op == "name":
        return names[tree.name]
    if op == "call":
        if any(np.iscomplexobj(arg) for arg in args):
            raise NoValue(f"{tree.name} of a vector")
        return _CALLS[tree.name](*args)
    if op == "part":
        return np.real(args[0]) if tree.name == "x" else np.imag(args[0])
    if op == "neg":
        return -args[0]
    if any(np.iscomplexobj(arg) for arg in args):
        raise NoValue(f'"{op}" with a vector')
    return _OF_NUMBERS[op](*args)


def _size(tree: Formula, names: Mapping[str, Any]) -> Any:
    if tree.op in {"+", "-"}:
        return _size(tree.args[0], names) + _size(tree.args[1], names)
    if tree.op == "neg":
        return _size(tree.args[0], names)
    if tree.op == "*":
        return _size(tree.args[0], names) * _size(tree.args[1], names)
    if tree.op == "/":
        return np.divide(_size(tree.args[0], names), np.abs(computed(tree.args[1], names, {})))
    return np.abs(computed(tree, names, {}))


def are_same(one: Array, other: Array, within: float) -> bool:
    """Return whether values (n,) differ from others by at most a part of the largest of those."""
    return bool(np.max(np.abs(one - other)) <= within * np.max(np.abs(other)))


def real(values: Any, *shape: int) -> Array:
    """Return a scalar value as an array of a shape.  Raises `NoValue` for a vector."""
    if np.iscomplexobj(values):
        raise NoValue("a vector stands where a number was expected")
    found = np.asarray(values, dtype=float)
    return found if found.shape == shape else np.broadcast_to(found, shape)
