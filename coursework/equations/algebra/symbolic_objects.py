"""An expression -> its SymPy object, for users who go on by hand; and the version of SymPy.

Enters: an `Expression`.  Leaves: a SymPy expression in real symbols.  Used by `blocks.py` and `scene_run.py`.
SymPy is loaded here and nowhere else.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from coursework.equations.algebra.expression import Expression

if TYPE_CHECKING:
    import sympy as sp

_NAMES = {"abs": "Abs", "+": "Add", "*": "Mul", "^": "Pow"}


def symbolic(part: Expression) -> sp.Expr:
    """Return the SymPy object of an expression."""
    import sympy as sp

    if part.op == "number":
        return sp.Rational(part.value.numerator, part.value.denominator)
    if part.op == "symbol":
        return sp.Symbol(part.name, real=True)
    args = [symbolic(arg) for arg in part.args]
    if part.op == "pi":
        return sp.pi
    if part.op == "piecewise":
        time, *pieces, last = args
        return sp.Piecewise(*((piece, end > time) for piece, end in zip(pieces[::2], pieces[1::2], strict=True)), (last, True))
    if part.op.startswith("_table_"):
        return sp.Function(part.op)(*args)
    return getattr(sp, _NAMES.get(part.op, part.op))(*args)


def sympy_version() -> str:
    """Return the version of SymPy, "" if it is not installed: no table and no page needs it.

    SymPy is not loaded, but its release file is read: the metadata of a package take forty times as long.
    """
    spec = find_spec("sympy")
    if spec is None or spec.origin is None:
        return ""
    return Path(spec.origin).with_name("release.py").read_text(encoding="utf-8").split('"')[1]
