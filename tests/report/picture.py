"""The picture of the README:  python -m tests.report.picture  writes reports/picture.png anew.

Three pages of the PDF of variant 31 beside each other: the first, the one with the graphs, the first with checks.
"""

from __future__ import annotations

import re
from pathlib import Path

import pymupdf

import coursework
from coursework.report.pages import build_model
from coursework.report.pages.pdf import render_pdf

PICTURE = Path(__file__).parents[2] / "reports" / "picture.png"
SHOWN = ("Graphs", "Appendix A.")  # what the second and the third page hold
GAP = 12.0  # points between pages
DOTS = 84  # per inch; three pages then fit the width of a page on the web


def picture_of(pdf: bytes) -> bytes:
    """Return the PNG of the pages shown."""
    pages, sheet = pymupdf.open(stream=pdf, filetype="pdf"), pymupdf.open()
    texts = [page.get_text() for page in pages]
    shown = [
        0,
        *(
            next(number for number, text in enumerate(texts) if re.search(rf"\n(?:\d+\s+)?{re.escape(head)}", text))
            for head in SHOWN
        ),
    ]
    width, height = pages[0].rect.width, pages[0].rect.height
    wide = sheet.new_page(width=3 * width + 2 * GAP, height=height)
    wide.draw_rect(wide.rect, color=None, fill=(0.75, 0.75, 0.75))
    for place, number in enumerate(shown):
        left = place * (width + GAP)
        frame = pymupdf.Rect(left, 0, left + width, height)
        wide.draw_rect(frame, color=None, fill=(1, 1, 1))
        wide.show_pdf_page(frame, pages, number)
    return bytes(wide.get_pixmap(dpi=DOTS).tobytes("png"))


if __name__ == "__main__":
    PICTURE.write_bytes(picture_of(render_pdf(build_model(coursework.solve("31")))))
