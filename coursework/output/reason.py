"""Why a quantity has no real value: the formulas of the file, evaluated node by node over the rows.

Enters: a `Variant` and a `Motion`.  Leaves: the first node whose arguments are finite and whose value is not.
Used by `gate.py` only, after something went wrong; what is shown never comes from here.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.formula.tree import Formula, spelled
from coursework.integration.motion import Motion
from coursework.variant.record import Variant

Array = NDArray[np.float64]
Value = tuple[Array, ...]  # one component, or two of a vector
_FUNCTIONS = {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2}
_ARITHMETIC = {"+": np.add, "-": np.subtract, "*": np.multiply, "/": np.divide, "^": np.power}
_KINDS = {"acos": "cosine", "asin": "cosine", "sqrt": "root", "log": "logarithm", "/": "division", "^": "power"}


@dataclass(frozen=True, slots=True)
class Reason:
    """`place` of the formula in the file; `node` with the numbers it was given; `kind` of trouble; `names` in its argument."""

    place: tuple[str | int, ...]
    node: str
    kind: str
    names: tuple[str, ...]


class _Unknown(Exception):
    """A name whose rows are not known here."""


class _NotFinite(Exception):
    """The node at which a value is lost."""

    def __init__(self, node: Formula, numbers: list[float]) -> None:
        super().__init__()
        self.node, self.numbers = node, numbers


class Formulas:
    """The formulas of a file and the rows of everything they speak about."""

    def __init__(self, variant: Variant, motion: Motion) -> None:
        self.variant = variant
        known = {"pi": math.pi, **variant.values}
        self.values: dict[str, Value] = {name: (np.full(len(motion.t), value),) for name, value in known.items()}
        self.values |= {"t": (motion.t,), **{name: (column,) for name, column in zip(motion.names, motion.rows.T, strict=True)}}

    def of_motion(self) -> Reason | None:
        """Return why a row of the table has no value: a law or a constraint without one."""
        for section, laws in (("functions", self.variant.functions), ("drive", self.variant.drive)):
            for law in laws:
                if law.formula and law.name not in self.values and (reason := self._of((section, law.name), law.formula)):
                    return reason
        for index, constraint in enumerate(self.variant.constraints):
            for side in (constraint.left, constraint.right):
                if reason := self._of(("constraint", index, "equation"), side):
                    return reason
        return None

    def of_point(self, name: str) -> Reason | None:
        """Return why a point has no place; the points before it and the laws may be why."""
        if reason := self.of_motion():
            return reason
        for point, formula in self.variant.points:
            reason = self._of(("points", point), formula)
            if reason or point == name:
                return reason
        return None

    def _of(self, place: tuple[str | int, ...], formula: Formula) -> Reason | None:
        """Evaluate a formula; keep its rows, or return why it has none."""
        try:
            self.values[str(place[1])] = self._value(formula)
        except _Unknown:
            return None
        except _NotFinite as lost:
            node = lost.node
            argument = node.args[-1] if node.op == "/" else node.args[0] if node.args else node
            names = tuple(name for name in argument.names() if name != "pi")
            kind = _KINDS.get(node.name if node.op == "call" else node.op, "other")
            lengths = [name for name in names if any(given.name == name and given.si == "m" for given in self.variant.given)]
            if kind == "cosine" and len(names) == len(lengths) == 3:
                kind = "triangle"
            return Reason(place, _shown(node, lost.numbers), kind, names)
        return None

    def _value(self, node: Formula) -> Value:
        if node.op == "number":
            return (np.full(len(self.values["t"][0]), float(node.value)),)
        if node.op == "name":
            if node.name not in self.values:
                raise _Unknown
            return self.values[node.name]
        args = [self._value(arg) for arg in node.args]
        with np.errstate(all="ignore"):
            value = _applied(node, args)
        flat = [component for arg in args for component in arg]
        lost = np.logical_and.reduce([np.isfinite(part) for part in flat]) & ~np.logical_and.reduce(
            [np.isfinite(part) for part in value]
        )
        if lost.any():
            row = int(np.argmax(lost))
            raise _NotFinite(node, [float(part[row]) for part in flat])
        return value


def _applied(node: Formula, args: list[Value]) -> Value:
    """Return the value of one node from those of its arguments."""
    if node.op == "pair":
        return args[0][0], args[1][0]
    if node.op == "@":
        return args[0][0] * np.cos(args[1][0]), args[0][0] * np.sin(args[1][0])
    if node.op == "part":
        return (args[0]["xy".index(node.name.lstrip("."))],)
    if node.op == "neg":
        return tuple(-part for part in args[0])
    if node.op == "call":
        function = np.abs if node.name == "abs" else _FUNCTIONS.get(node.name) or getattr(np, node.name)
        return (np.asarray(function(*(arg[0] for arg in args))),)
    longest = max(len(arg) for arg in args)
    broad = [arg if len(arg) == longest else arg * longest for arg in args]
    return tuple(np.asarray(_ARITHMETIC[node.op](*parts)) for parts in zip(*broad, strict=True))


def _shown(node: Formula, args: list[float]) -> str:
    """Return the node with the numbers it was given, such as acos(1.37)."""
    numbers: Mapping[int, str] = {index: f"{value:.3g}" for index, value in enumerate(args)}
    if node.op == "call":
        return f"{node.name}({', '.join(numbers.values())})"
    if node.op in _ARITHMETIC and len(args) == 2:
        left, right = (f"({text})" if text.startswith("-") else text for text in numbers.values())
        return f"{left}{node.op}{right}"
    return spelled(node)[:60]
