"""The formula of a scheme as a lecture writes it, made from its tableau.

Enters: a `Scheme`.  Leaves: (Typst math, plain text) of each line.  Used by the section about the method.
"""

from __future__ import annotations

from fractions import Fraction

from coursework.drawing.paper.symbols import LOWERED
from coursework.motion.schemes import Scheme, Sum

_A_LINE = 2  # slopes on one line
# For a motion under forces: first the rates, from the accelerations, then the coordinates, from the new rates.
SEMI_IMPLICIT = (
    ("v_(i+1) = v_i + h a(t_i, q_i, v_i)", "v_{i+1} = v_i + h a(t_i, q_i, v_i)"),
    ("q_(i+1) = q_i + h v_(i+1)", "q_{i+1} = q_i + h v_{i+1}"),
)


def lines(scheme: Scheme) -> tuple[tuple[str, str], ...]:
    """Return the slopes k1, k2 … two per line, then the step; one line only if no slope is used twice (Euler, midpoint)."""
    read = [place for row in (*scheme.inner, scheme.outer) for place, _ in row.terms]
    if scheme.slopes <= _A_LINE and len(read) == len(set(read)):
        inside: list[str] = []
        for stage in range(scheme.slopes):
            inside.append(_slope(scheme, stage, inside))
        whole = f"q_(i+1) = {_moved(scheme.outer, inside)}"
        return ((whole, whole.replace("q_(i+1)", "q_{i+1}")),)
    typst = [f"k_{stage + 1}" for stage in range(scheme.slopes)]
    plain = [f"k{stage + 1}".translate(LOWERED) for stage in range(scheme.slopes)]
    shown = []
    for first in range(0, scheme.slopes, _A_LINE):
        stages = range(first, min(first + _A_LINE, scheme.slopes))
        shown.append(
            (
                ", quad ".join(f"{typst[stage]} = {_slope(scheme, stage, typst)}" for stage in stages),
                ", ".join(f"{plain[stage]} = {_slope(scheme, stage, plain)}" for stage in stages),
            )
        )
    return (*shown, (f"q_(i+1) = {_moved(scheme.outer, typst)}", f"q_{{i+1}} = {_moved(scheme.outer, plain)}"))


def _slope(scheme: Scheme, stage: int, names: list[str]) -> str:
    node = scheme.nodes[stage]
    time = f"t_i + {_part(node)}" if node else "t_i"
    return f"f({time}, {_moved(scheme.inner[stage], names)})"


def _moved(row: Sum, names: list[str]) -> str:
    """Return q_i plus the increment that one row of the tableau gives."""
    if not row.terms:
        return "q_i"
    terms = [f"{'' if abs(whole) == 1 else f'{abs(whole)} '}{names[place]}" for place, whole in row.terms]
    total = ("-" if row.terms[0][1] < 0 else "") + terms[0]
    for (_, whole), term in zip(row.terms[1:], terms[1:], strict=True):
        total += f" {'-' if whole < 0 else '+'} {term}"
    is_bare = len(terms) == 1 and row.terms[0][1] > 0
    return f"q_i + {_part(row.factor)} {total if is_bare else f'({total})'}"


def _part(part: Fraction | int) -> str:
    """Return a fraction of the step h: "h", "h/2", "2/3 h"."""
    if part.numerator == 1:
        return "h" if part.denominator == 1 else f"h/{part.denominator}"
    return f"{part} h"
