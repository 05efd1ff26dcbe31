"""The equations of motion.

Enters: a `PageContext`.  Leaves: displayed equations with the words around them.  Used by `sections.py`.
"""

from __future__ import annotations

from dataclasses import replace

from coursework.report.display import display
from coursework.report.page_context import PageContext
from coursework.report.parts import Bullets, Equations, Paragraph, Part


def equations(context: PageContext) -> list[Part]:
    """Every velocity equation with its reason; redundant ones say so."""
    shown = []
    for equation in context.run.equations:
        reason = context.rich(equation.because) if equation.derived else context.quoted(equation.because)
        if equation.derived:
            remark = context.words("constraints.derived")
            reason = [*reason, {"t": f" ({remark})" if reason else f"({remark})"}]
        one = display(equation.left, equation.right, context.rates, equation.name, reason)
        shown.append(one if equation.used else replace(one, after=context.say("constraints.unused")))
    notes = [Bullets([context.rich(note) for note in context.run.reduction.notes])] if context.run.reduction.notes else []
    return [Paragraph(context.say("constraints.intro")), Equations(shown), *notes] if shown else []
