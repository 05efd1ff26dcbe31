"""The foot of a sheet that is true to scale: the bar by which a print is checked, and what is said of the scales.

Enters: a sheet and sentences.  Leaves: items on the sheet.
Used by `polygon_sheet.py`, `drawing.py` and `layout.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from coursework.drawing.paper.sheet import ITALIC, SMALL_LETTER, Sheet
from coursework.words.sentences import say

FOOT = 17.0  # mm for the bar and the scales
BAR = 100.0  # mm, printed; a test reads it back from the PDF
BAR_PEN = 'stroke="#010101" stroke-width="0.5" stroke-linecap="butt"'  # a colour of its own, so that it can be found
THIN = 'stroke="black" stroke-width="0.35"'


def draw_foot(sheet: Sheet, lines: Sequence[str], written: Callable[[str], str]) -> None:
    """Draw the bar and write up to three sentences beside it; the field of the sheet then is the whole sheet."""
    left, base = 3.0, sheet.height - 5.0
    sheet.field = (0.0, 0.0, sheet.width, sheet.height)
    sheet.line(complex(left, base), complex(left + BAR, base), BAR_PEN, ' data-bar="100"')
    for k in range(11):
        tick = 2.4 if k % 5 == 0 else 1.4
        sheet.line(complex(left + 10 * k, base), complex(left + 10 * k, base - tick), THIN)
    sheet.text(complex(left, base - 4.2), (written(say("drawing.bar", length=f"{BAR:g}")), "", ""), size=SMALL_LETTER)
    for k, line in enumerate(lines):
        sheet.text(complex(left + BAR + 7, sheet.height - FOOT + 4.6 + 4.2 * k), (written(line), "", ""), size=SMALL_LETTER)
    at = complex(sheet.width - 12, sheet.height - 4.5)
    for way, name, shift in ((8 + 0j, "x", 0.6 + 0.8j), (-8j, "y", -2.6 + 0.5j)):
        sheet.arrow(at, at + way, 'stroke="black" stroke-width="0.2"', head=1.6)
        sheet.text(at + way + shift, (name, "", ""), look=ITALIC)
