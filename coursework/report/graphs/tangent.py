"""The figure that explains the error: one Euler step along the tangent, and the curve that bends away from it.

Enters: a `PageContext`.  Leaves: `figure#tangent`.  Used by `results.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.report.graphs import graph_paper
from coursework.report.graphs.graph_paper import EXACT_PEN, SCHEME_INK, Field, field_for, framed, sheet, smooth, words
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Figure
from coursework.report.wording.closeness import LocalError, evidence
from coursework.system.arrays import Array
from coursework.words.html_table import escaped

SIZE = (96.0, 24.0)  # mm; the screen of a phone shows it whole
LETTER = 1.9  # mm, the mean width of a letter
BESIDE = 0.35  # parts of a step shown before it and, at least, after it
FINE = 32  # points of the curve per step
SEEN = 0.6  # mm: a narrower gap cannot be seen, so there is no figure
NARROW = 5.0  # mm: a narrower gap has no room for words between its ends
ROOM, ROOM_BELOW = 0.25, 0.45  # parts of the range of values, for words above it and below it, where the axis is
CLEAR = 2.6  # mm from the middle of a word to a line that it must not touch
TANGENT_PEN = f'class="rows" fill="none" stroke="{SCHEME_INK}" stroke-width="0.42" stroke-dasharray="2.4 1.2"'
GAP_PEN = 'class="gap" fill="none" stroke="#111" stroke-width="0.3"'


def tangent_figure(context: PageContext, step: LocalError) -> Figure | None:
    """Return the enlarged step; None if its bend is too small to be seen."""
    exact = evidence(context).exact
    begin, end = step.row - 1, step.row
    rows = slice(max(begin - 1, 0), min(end + 2, len(exact.t)))
    q, rate = exact.column(step.column), exact.column(step.rate_name)
    t, curve = smooth(exact.t[rows], q[rows], rate[rows], FINE)
    h = float(exact.t[end] - exact.t[begin])
    kept = (t >= exact.t[begin] - BESIDE * h) & (t <= exact.t[end] + BESIDE * h)
    t, curve = t[kept], curve[kept]
    foot, top = (float(exact.t[begin]), float(q[begin])), (float(exact.t[end]), float(q[begin] + h * rate[begin]))
    gap = context.with_unit(context.numbers.scalar(abs(step.gap), 3), step.unit)
    times = [t, np.array([top[0] + _behind(gap) * h])]
    field = field_for(SIZE, times, [curve, np.array([foot[1], top[1]])], context.numbers)
    if abs(field.y(top[1]) - field.y(float(q[end]))) < NARROW:  # make room for the words beyond the gap
        high = field.high - field.low
        away = top[1] + ROOM * high if top[1] > q[end] else min(top[1], *curve[t >= top[0]]) - ROOM_BELOW * high
        field = field_for(SIZE, times, [curve, np.array([foot[1], top[1], away])], context.numbers)
    if abs(field.y(top[1]) - field.y(float(q[end]))) < SEEN:
        return None
    symbol = context.symbol(step.column)
    inside = framed(context, field, symbol, context.unit(step.unit))
    inside += f'<path {EXACT_PEN} d="{field.path(t, curve)}"/>'
    line = field.path(np.array([foot[0], top[0]]), np.array([foot[1], top[1]]))
    inside += f'<path {TANGENT_PEN} d="{line}"/>'
    inside += _gap(field, float(exact.t[end]), float(q[end]), top[1])
    inside += _gap_words(field, top, t, curve, gap)
    for at, value in (foot, top):
        inside += f'<circle class="dots" cx="{field.x(at):.2f}" cy="{field.y(value):.2f}" r="0.9" fill="{SCHEME_INK}"/>'
    told = {"symbol": symbol.text, "row": step.row, "next": step.row + 1, "gap": gap}
    said = [context.words("tangent.caption", **told)]
    if context.run.tableau is not None:  # exact rows stand on the curve
        said.append(context.words("tangent.rows"))
    caption = context.lettered(context.words.sentences(said))
    return Figure(sheet(field, inside), *SIZE, context.words("tangent.alt", **told), caption, id="tangent")


def _gap(field: Field, t: float, curve: float, tangent: float) -> str:
    """Return the line from the tangent to the curve at the end of the step, with a bar at each end."""
    x, first, last = field.x(t), field.y(tangent), field.y(curve)
    return f'<path {GAP_PEN} d="M{x - 1:.2f} {first:.2f}h2M{x:.2f} {first:.2f}V{last:.2f}M{x - 1:.2f} {last:.2f}h2"/>'


def _behind(gap: str) -> float:
    """Return how much must be shown after the step, in parts of it, so that the words of the gap have room there."""
    across = SIZE[0] - 1.5 * graph_paper.LEFT - graph_paper.RIGHT  # long words at the ticks take more
    wide = 2.5 + LETTER * len(gap)
    return max(BESIDE, wide * (1 + BESIDE) / (across - wide))


def _gap_words(field: Field, top: tuple[float, float], t: Array, curve: Array, gap: str) -> str:
    """Return the words on the gap's width at its right: between its ends, or beyond tangent and curve if it is narrow."""
    after = [field.y(float(value)) for value in curve[t >= top[0] - 1e-9 * abs(top[0])]]
    first, last = field.y(top[1]), after[0]
    middle = (first + last) / 2
    if abs(last - first) < NARROW:
        middle = max(first, *after) + CLEAR if first >= last else min(first, *after) - CLEAR
    return words(field.x(top[0]) + 1.8, middle + graph_paper.LETTERS / 3, escaped(gap))
