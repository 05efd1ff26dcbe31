"""Drawings that print to scale, as figures of a page.

Enters: a `PageContext` and drawings.  Leaves: parts.
Used by `accuracy_figures.py`, the sections that show a drawing and `assigning/`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from coursework.drawing.paper import record
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Figure, Paragraph, Part, Runs
from coursework.report.text.text_runs import ITALIC, printed
from coursework.report.text.words import Words

_AMOUNT = r"[\d.,·⁻⁰¹²³⁴-⁹]*[\d⁰¹²³⁴-⁹]"
OF_MM = rf"1\s(?:mm|мм)\s=\s{_AMOUNT}\s[^\s.,，。]+|μ\S*\s=\s{_AMOUNT}\s\([^)]+\)/(?:mm|мм)"  # the scale of a plan
WIDTH = 170.0  # mm; the text width of A4 with margins of 20 mm


def drawn(context: PageContext, drawing: record.Drawing) -> Figure:
    """Return a drawing as a figure of the page, its words in the page's language."""
    caption = scale_on_paper(context.words, printed(context.told(drawing.caption)), context.lettered)
    alt = context.told(drawing.alt)
    return Figure(drawing.svg, drawing.width, drawing.height, alt, caption, drawing.exact, id=drawing.id)


def scale_on_paper(words: Words, caption: str, lettered: Callable[[str], Runs]) -> Runs:
    """Return a caption as runs, its words on the scale for paper only: on a screen a drawing has another size."""
    said = re.escape(words("drawing.scale", scale="1")).replace("1", r"[\d.,:]*\d")
    before, scale, behind = (*re.split(rf"((?:[,，]\s*)?(?:{said}|{OF_MM}))", caption, maxsplit=1), "", "")[:3]
    return [*lettered(before), {"o": scale}, *lettered(behind)] if scale else lettered(caption)


def drawn_parts(context: PageContext, drawing: record.Drawing) -> list[Part]:
    """Return a drawing followed by the steps of its construction, numbered."""
    figure = drawn(context, drawing)
    # A small letter in a step is the image of a point, even if a datum has that name.
    told = [printed(f"{number}. {context.told(step)}") for number, step in enumerate(drawing.steps, start=1)]
    numbered = [context.lettered(_with_letters(step, drawing.letters), data=False) for step in told]
    return [figure, *(Paragraph(step, "note") for step in numbered)]


def _with_letters(step: str, letters: tuple[str, ...]) -> str:
    """Return a step in which the letters of point names ("b'", "BC", "P₁") are marked, so that they are set as in a formula."""
    if not letters:
        return step
    one = f"[{''.join(map(re.escape, letters))}]"
    many = f"[{''.join(re.escape(letter) for letter in letters if letter.isupper())}]" if any(map(str.isupper, letters)) else one
    # Two small letters are a unit (mm), not a line between two points.
    named = re.compile(rf"(?<![A-Za-z0-9_/₀-₉])(?:{one}[₀-₉]*|(?:{many}[₀-₉]*)+)(?![A-Za-z0-9_/₀-₉])")
    own = re.compile(one)
    return named.sub(lambda found: own.sub(lambda letter: f"{ITALIC[0]}{letter[0]}{ITALIC[1]}", found[0]), step)
