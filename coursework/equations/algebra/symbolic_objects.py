"""An expression -> SymPy's object of it, for whoever goes on by hand; and which SymPy that is.

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
    """Return SymPy's object of an expression."""
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
    """Return the version of SymPy, "" where it is not installed: no table and no page needs it.

    It is not loaded: the metadata of a package take forty times as long as its own file.
    """
    spec = find_spec("sympy")
    if spec is None or spec.origin is None:
        return ""
    return Path(spec.origin).with_name("release.py").read_text(encoding="utf-8").split('"')[1]
