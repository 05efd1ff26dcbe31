"""An upper bound of a determinant, so that it can be judged without units.

Enters: the determinant as shown, and the data.  Leaves: a positive number, or 0 if no bound is known.  Used by `blocks.py`.
Relative to it, sin(φ1 - φ2) decides, not r1 r2 sin(φ1 - φ2): metres and millimetres give the same result.
"""

from __future__ import annotations

import math

from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Variant


def largest(determinant: Formula, variant: Variant) -> float:
    """Return the bound: sines and cosines count as 1, differences as sums; 0 if no bound is found."""
    lengths = [given.value for given in variant.given if given.si == "m"]
    typical = max(map(abs, lengths), default=1.0)
    values = {name: abs(value) for name, value in variant.values.items()} | {"pi": math.pi}
    for coordinate in variant.coordinates:
        if coordinate.unit == "m":
            values[coordinate.name] = max(abs(coordinate.start_or_guess or 0.0), typical)
    return _bound(determinant, values)


def _bound(tree: Formula, values: dict[str, float]) -> float:
    if tree.op == "call":
        return 1.0 if tree.name in {"sin", "cos"} else 0.0
    if tree.op == "number":
        return abs(float(tree.name))
    if tree.op == "name":
        return values.get(tree.name, 0.0)
    parts = [_bound(arg, values) for arg in tree.args]
    if tree.op in {"+", "-"}:
        return parts[0] + parts[1]
    if tree.op == "*":
        return parts[0] * parts[1]
    if tree.op == "/":
        return parts[0] / parts[1] if parts[1] and tree.args[1].op in {"number", "name"} else 0.0
    if tree.op == "^":
        return float(parts[0] ** float(tree.args[1].name)) if tree.args[1].op == "number" else 0.0
    return parts[0]
