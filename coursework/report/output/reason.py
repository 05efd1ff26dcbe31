"""Why a quantity has no real value: the formulas of the file, evaluated node by node over the rows.

Enters: a `Variant` and a `Motion`.  Leaves: the first node whose arguments are finite and whose value is not.
Used by `gate.py` only, to explain a failure; no number of the results comes from here.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from coursework.equations.codegen.tabulated import OutsideTable, TableLaw
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.record.no_value import in_order
from coursework.variant.record.variant import Law, Variant
from coursework.variant.toml.positions import KeyPath

Rows = NDArray[np.intp]
_KINDS = {"acos": "cosine", "asin": "cosine", "sqrt": "root", "log": "logarithm", "/": "division", "^": "power"}


@frozen
class Reason:
    """A node without a value: `path` of its formula in the file, and `label`; `node` is its text with the numbers it was given.

    `kind` of trouble; `names` in its argument; `of_slope`: the node has a value, but does not change at a finite rate.
    """

    path: KeyPath
    label: str
    node: str
    kind: str
    names: tuple[str, ...]
    of_slope: bool


class _Unknown(Exception):
    """The error for a name whose rows are not known here."""


class _NotFinite(Exception):
    """The first node whose value, or its rate, is not finite."""

    def __init__(self, node: Formula, numbers: list[complex], of_slope: bool) -> None:
        super().__init__()
        self.node, self.numbers, self.of_slope = node, numbers, of_slope


class Formulas:
    """The formulas of a file and the rows of the names in them; `rates`: whether rates must be finite too."""

    def __init__(self, variant: Variant, motion: Motion, rates: bool) -> None:
        self.variant, self.t, self.rates = variant, motion.t, rates
        zero = np.zeros(len(self.t))
        known = {"pi": math.pi, **variant.values}
        self.values = {name: Moving(zero + value, zero) for name, value in known.items()}
        # The rate of an unknown velocity is sought, so it counts as 0: the other terms must be finite without it.
        self.values |= {name: Moving(motion.column(name), zero) for name in motion.velocity_names}
        moved = {coordinate.name: coordinate.rate for coordinate in variant.coordinates}
        for name in motion.coordinate_names:
            self.values[name] = Moving(motion.column(name), motion.column(moved[name]))
        self.values["t"] = Moving(self.t, zero + 1)

    def of_motion(self) -> Reason | None:
        """Return the first law or constraint without a value in some row, as the reason why the table lacks one; else None."""
        laws = map(self._of_law, in_order(self.variant))
        sides = (self._of(one.path, f"constraint {one.name}", side) for one in self.variant.constraints for side in one.sides)
        return next(filter(None, chain(laws, sides)), None)

    def of_point(self, name: str) -> Reason | None:
        """Return why a point has no position, or None; the cause may be a law, a constraint or an earlier point."""
        if reason := self.of_motion():
            return reason
        for point, formula in self.variant.points:
            reason = self._of(("points", point), f"points.{point}", formula, point)
            if reason or point == name:
                return reason
        return None

    def of_forces(self) -> Reason | None:
        """Return why a force has no value; the points and the laws may be why."""
        measured = self.variant.forces.measured() if self.variant.forces is not None else ()
        points = (self._of(("points", name), f"points.{name}", formula, name) for name, formula in self.variant.points)
        others = (self._of(path, ".".join(map(str, path)), formula) for path, formula, _ in measured)
        return next(filter(None, chain(points, others)), None)

    def _of_law(self, law: Law) -> Reason | None:
        path = self.variant.path_of(law.name)
        label = ".".join(path)
        if law.table:
            self._tabulate(law)
            return None
        if law.formula is not None:
            return self._of(path, label, law.formula, law.name)
        ends = [*(start for start, _ in law.pieces[1:]), math.inf]
        value, slope = np.full((2, len(self.t)), np.nan)
        for place, ((start, formula), end) in enumerate(zip(law.pieces, ends, strict=True)):
            chosen = np.flatnonzero((self.t >= start) & (self.t < end))
            if reason := self._of((*path, "pieces", place, 1), label, formula, law.name, chosen):
                return reason
            if law.name not in self.values:
                return None
            value[chosen], slope[chosen] = self.values.pop(law.name)
        self.values[law.name] = Moving(value, slope)
        return None

    def _tabulate(self, law: Law) -> None:
        if law.of not in self.values:
            return
        table, (argument, rate) = TableLaw(law.name, law.table, law.method), self.values[law.of]
        try:
            self.values[law.name] = Moving(table.function(0)(argument), table.function(1)(argument) * rate)
        except OutsideTable:  # reported elsewhere, long before a table is written
            self.values.pop(law.name, None)

    def _of(self, path: KeyPath, label: str, formula: Formula, name: str = "", rows: Rows | None = None) -> Reason | None:
        """Evaluate a formula in `rows` (None: all) and keep it under `name`, if any; return why it has no value, else None."""
        chosen = np.arange(len(self.t)) if rows is None else rows
        try:
            found = self._value(formula, chosen)
        except _Unknown:
            return None
        except _NotFinite as lost:
            return self._reason(path, label, lost)
        if name:
            self.values[name] = found
        return None

    def _reason(self, path: KeyPath, label: str, lost: _NotFinite) -> Reason:
        node = lost.node
        argument = node.args[-1] if node.op == "/" else node.args[0] if node.args else node
        names = tuple(name for name in argument.names() if name != "pi")
        kind = _KINDS.get(node.name if node.op == "call" else node.op, "other")
        lengths = [name for name in names if any(given.name == name and given.si == "m" for given in self.variant.given)]
        if kind == "cosine" and len(names) == len(lengths) == 3:
            kind = "triangle"
        return Reason(path, label, _shown(node, lost.numbers), kind, names, lost.of_slope)

    def _value(self, node: Formula, rows: Rows) -> Moving:
        if node.op == "number":
            return Moving(np.full(len(rows), float(node.value)), np.zeros(len(rows)))
        if node.op == "name":
            if node.name not in self.values:
                raise _Unknown
            return Moving(*(part[rows] for part in self.values[node.name]))
        args = [self._value(arg, rows) for arg in node.args]
        with np.errstate(all="ignore"):
            found = applied(node, args)
        known = np.logical_and.reduce([np.isfinite(arg.value) for arg in args])
        for of_slope in (False, True) if self.rates else (False,):
            lost = known & ~np.isfinite(found.slope if of_slope else found.value)
            if lost.any():
                raise _NotFinite(node, [arg.value[np.argmax(lost)] for arg in args], of_slope)
        return found


def _shown(node: Formula, args: list[complex]) -> str:
    """Return the node with the numbers it was given, such as acos(1.37)."""
    numbers = [f"{value:.3g}" for value in args]
    if node.op == "call":
        return f"{node.name}({', '.join(numbers)})"
    if node.op in "+-*/^" and not np.iscomplexobj(args):
        left, right = (f"({text})" if text.startswith("-") else text for text in numbers)
        return f"{left}{node.op}{right}"
    return spelled(node)[:60]


class Moving(NamedTuple):
    """A quantity in some rows: its `value` and its time derivative `slope` (per second); a vector is x + iy."""

    value: NDArray[Any]
    slope: NDArray[Any]


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


def applied(node: Formula, args: list[Moving]) -> Moving:
    """Return the quantity that a node makes of its arguments."""
    if node.op == "call":
        return _turned(*args) if node.name == "atan2" else _called(node.name, args[0])
    return _OPERATIONS[node.op](*args) if node.op != "part" else Moving(*(getattr(one, _SIDES[node.name]) for one in args[0]))


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


_SIDES = {"x": "real", "y": "imag"}
_OPERATIONS: dict[str, Callable[..., Moving]] = {
    "pair": lambda x, y: Moving(x.value + 1j * y.value, x.slope + 1j * y.slope),
    "@": lambda length, angle: _times(length, _called("exp", Moving(1j * angle.value, 1j * angle.slope))),
    "neg": lambda a: Moving(-a.value, -a.slope),
    "+": lambda a, b: Moving(a.value + b.value, a.slope + b.slope),
    "-": lambda a, b: Moving(a.value - b.value, a.slope - b.slope),
    "*": _times, "/": _over, "^": _power,
}  # fmt: skip
