"""The foot of a sheet that is true to scale: a bar for checking a print, and words on the scales.

Enters: a sheet and sentences.  Leaves: items on the sheet.
Used by `polygon_sheet.py`, `drawing.py` and `layout.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from coursework.drawing.paper.board import COLUMN, EDGE
from coursework.drawing.paper.cover import Rectangle
from coursework.drawing.paper.sheet import ITALIC, SMALL_LETTER, Sheet
from coursework.drawing.paper.symbols import decimal
from coursework.words.sentences import say

FOOT = 17.0  # mm for the bar and the scales
BAR = 100.0  # mm, printed; a test reads it back from the PDF
BAR_PEN = 'stroke="#010101" stroke-width="0.5" stroke-linecap="butt"'  # a colour that nothing else has, so that a test finds it
ROUND_LENGTHS = tuple(m * 10.0**k for k in range(-6, 7) for m in (1, 2, 5))
LEAST_BAR = 20.0  # mm: least length of the bar on a screen
THIN = 'stroke="black" stroke-width="0.35"'


def sheet_over_foot(width: float, height: float) -> Sheet:
    """Return a sheet with a field as high, its edges included, and the foot below it."""
    return Sheet(width, height + FOOT, (EDGE, EDGE, width - EDGE, height))


def sheet_around(box: Rectangle) -> tuple[Sheet, complex]:
    """Return a sheet of at least a column's width over the foot, with room for a box about a pole, and the place of the pole."""
    left, top, right, bottom = box
    width = max(COLUMN, right - left + 2 * EDGE)
    return sheet_over_foot(width, bottom - top + 2 * EDGE), complex((width - right - left) / 2, EDGE - top)


def draw_foot(sheet: Sheet, scales: Sequence[str], title: str, of_mm: tuple[float, str], written: Callable[[str], str]) -> None:
    """Draw the bar and write scales and title beside it; afterwards the field of the sheet is the whole sheet.

    On a screen a millimetre has no fixed size, so there the bar shows a round amount; `of_mm` is (amount per mm, unit).
    """
    left, base = 3.0, sheet.height - 5.0
    sheet.field = (0.0, 0.0, sheet.width, sheet.height)
    sheet.items.append('<g class="paper">')
    sheet.line(complex(left, base), complex(left + BAR, base), BAR_PEN, ' data-bar="100"')
    marks = [(complex(left + 10 * k, base), 2.4j if k % 5 == 0 else 1.4j) for k in range(11)]
    sheet.strokes([(at, at - tick) for at, tick in marks], THIN)
    sheet.text(complex(left, base - 4.2), (written(say("drawing.bar", length=f"{BAR:g}")), "", ""), size=SMALL_LETTER)
    beside = [complex(left + BAR + 7, sheet.height - FOOT + 4.6 + 4.2 * k) for k in range(len(scales) + 1)]
    for at, line in zip(beside, scales, strict=False):
        sheet.text(at, (written(line), "", ""), size=SMALL_LETTER)
    sheet.items.append("</g>")
    sheet.text(beside[-1], (written(title), "", ""), size=SMALL_LETTER)
    _screen_bar(sheet, complex(left, base), of_mm, written)
    at = complex(sheet.width - 12, sheet.height - 4.5)
    for way, name, shift in ((8 + 0j, "x", 0.6 + 0.8j), (-8j, "y", -2.6 + 0.5j)):
        sheet.arrow(at, at + way, 'stroke="black" stroke-width="0.2"', head=1.6)
        sheet.text(at + way + shift, (name, "", ""), look=ITALIC)


def _screen_bar(sheet: Sheet, at: complex, of_mm: tuple[float, str], written: Callable[[str], str]) -> None:
    """Draw the bar that only a screen shows: a round length of the mechanism, or a round amount of its plan."""
    amount, unit = of_mm
    value = next((one for one in ROUND_LENGTHS if one >= LEAST_BAR * amount), 0.0)
    if not value or value > BAR * amount:
        return
    end = at + value / amount
    sheet.items.append('<g class="screen" display="none">')
    sheet.line(at, end, BAR_PEN.replace("#010101", "black"))
    sheet.strokes([(place, place - 2.4j) for place in (at, end)], THIN)
    sheet.text(at - 4.2j, (written(say("drawing.length", value=decimal(value), unit=unit)), "", ""), size=SMALL_LETTER)
    sheet.items.append("</g>")
