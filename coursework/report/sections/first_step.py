"""The scheme's lines, and the first step as a student does it by hand.

Enters: a `PageContext`.  Leaves: displayed equations.  Used by `solution.py`.
"""

from __future__ import annotations

from collections.abc import Collection

from coursework.motion.schemes import title_of
from coursework.report.formulas import lecture
from coursework.report.text.numbers import MINUS, first_of
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Display, Equations, Paragraph, Part

DECIMALS = 5  # of a result
DIGITS, MOST_DIGITS = 6, 15  # of a factor: as many as give the printed result
INDICES = "kinjm"  # letters that count the steps; a datum of the file may have one
MOST_LINES = 8  # coordinates written out; the others are done alike


def first_step(context: PageContext) -> list[Part]:
    """Return nothing for exact rows; for Euler its line for each coordinate and the step from row 1 in numbers."""
    run = context.run
    scheme = run.tableau
    if scheme is None:
        return []
    if scheme.slopes > 1:
        lines = Equations([Display(math, text) for math, text in lecture.lines(scheme)])
        return [Paragraph(context.say("derivation.scheme", scheme=context.told(title_of(scheme)))), lines]
    rate_of = {coordinate.name: coordinate.rate for coordinate in run.variant.coordinates}
    names = run.motion.coordinate_names[:MOST_LINES]
    index = index_of_steps(run.variant.names)
    steps = [_line(context, name, rate_of[name], index) for name in names]
    parts: list[Part] = [
        Paragraph(context.say("derivation.along", index=context.lettering(index), step=context.quantity(run.step, "s"))),
        Equations(steps, flow=True),
    ]
    if len(run.motion.t) > 1 and not run.settings.project and not run.settings.gain:
        numbers = [_numbers(context, name, rate_of[name]) for name in names]
        units = dict.fromkeys(context.unit(c.unit) for c in run.variant.coordinates if c.name in names)
        listed = context.words("join.comma").join(units)
        parts += [Paragraph(context.say("derivation.first_step", units=listed)), Equations(numbers, flow=True)]
    return parts


def index_of_steps(names: Collection[str]) -> str:
    """Return the letter that counts the steps: the first that the file gives no other meaning.

    >>> index_of_steps(["k", "L1", "i"])
    'n'
    """
    return next((letter for letter in INDICES if letter not in names), INDICES[0])


def _line(context: PageContext, name: str, rate: str, k: str) -> Display:
    q, w = context.symbol(name), context.symbol(rate)
    math = f"{q.typst} ({k} + 1) = {q.typst} ({k}) + {w.typst} ({k}) thin h"
    return Display(math, f"{q.text}({k} + 1) = {q.text}({k}) + {w.text}({k}) h")


def _numbers(context: PageContext, name: str, rate: str) -> Display:
    """Return phi1(1) = 1.63 + (-1.57554) * 0.02 = 1.59849, with the fewest digits that give the printed result."""
    motion, step = context.run.motion, context.run.step
    start, speed, end = first_of(motion, name), first_of(motion, rate), float(motion.column(name)[1])
    result = f"{end:.{DECIMALS}f}"
    written = ("", "", "")
    for digits in range(DIGITS, MOST_DIGITS + 1):
        written = (f"{start:.{digits}g}", f"{speed:.{digits}g}", f"{step:.{digits}g}")
        if f"{float(written[0]) + float(written[1]) * float(written[2]):.{DECIMALS}f}" == result:
            break
    begin, factor, h = (context.numbers.dressed(text) for text in written)
    factor = f"({factor})" if factor.startswith(MINUS) else factor
    q = context.symbol(name)
    text = f"{begin} + {factor} · {h} = {context.numbers.dressed(result)}"
    return Display(f'{q.typst} (1) = "{text}"', f"{q.text}(1) = {text}")
