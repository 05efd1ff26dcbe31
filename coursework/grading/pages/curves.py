"""The student's velocities and the key's on small graphs as in the report: dots, crosses and a line, told apart without colour.

Enters: rows of a table and of the key.  Leaves: the contents of an SVG of `SIZE`.  Used by `feedback.py`.
"""

from __future__ import annotations

from html import escape

import numpy as np

from coursework.report.graphs.graph_paper import EXACT_PEN, MOST_DOTS, axes, dots, field_for, letters, sparse
from coursework.report.text.numbers import Numbers
from coursework.report.text.symbols import Symbol, symbol
from coursework.report.text.words import Words
from coursework.system.arrays import Array, Flags
from coursework.words.sentences import Phrases

SIZE = (82.0, 34.0)  # mm
MOST_POINTS = 80
BEYOND = 0.25  # of the key's range: a point farther outside it is drawn at the edge
_DOTS = 'stroke="#0072b2" stroke-width="1.24" stroke-linecap="round"'
_DOTTED = EXACT_PEN.replace('"exact"', '"exact dotted"')
_CROSSES = 'class="crossed" fill="none"'  # the crosses stand at the corners of this line


def panel(name: Symbol, unit: str, t: Array, key: Array, found: Array, is_wrong: Flags, words: Phrases) -> str:
    """Return the graph of one column; points far outside the key's range are drawn at the edge."""
    numbers = Numbers(words.template("decimal"))
    room = BEYOND * (float(np.ptp(key)) or max(float(abs(key).max()), 1e-9))
    low, high = float(key.min()) - room, float(key.max()) + room
    held = np.clip(found, low, high)
    field = field_for(SIZE, [t], [key, held], numbers)
    behind = Words(words).behind
    inside = axes(field, numbers, letters(name) + escape(behind(unit)), letters(symbol("t")) + escape(behind(words.unit("s"))))
    line = field.path(sparse(t, MOST_POINTS), sparse(key, MOST_POINTS))
    is_right = ~is_wrong & np.isfinite(held)
    if is_right.all() and len(t) <= MOST_DOTS and line == field.path(t, held):  # one line shows both: its corners are the dots
        return f'{inside}<path {_DOTTED} d="{line}"/>'
    inside += f'<path {EXACT_PEN} d="{line}"/>'
    if is_right.any():
        inside += f'<path {_DOTS} d="{dots(field, t[~is_wrong], held[~is_wrong])}"/>'
    known = is_wrong & np.isfinite(held)
    if not known.any():
        return inside
    return f'{inside}<path {_CROSSES} d="{field.path(sparse(t[known], MOST_POINTS), sparse(held[known], MOST_POINTS))}"/>'
