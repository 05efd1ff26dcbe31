"""The laws of a file as a page shows them: drives, functions of the configuration, tables.

Enters: a `PageContext` and `Law` records.  Leaves: displayed equations, sentences.  Used by `statement.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from coursework.mechanism.joints import FRAME
from coursework.report.formulas import typst_math
from coursework.report.formulas.display import display
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Display, Equations, Paragraph, Part
from coursework.report.text.text_runs import printed, runs
from coursework.variant.formula.made import degrees_in
from coursework.variant.formula.tree import Formula, named, spelled
from coursework.variant.record.variant import Law
from coursework.words.templates import clean

if TYPE_CHECKING:
    from coursework.variant.record.forces import Motor

_TIME = re.compile("t(?= =)")  # the t in "from t = 0.3 s", which is a symbol among words


def laws_shown(context: PageContext, laws: tuple[Law, ...]) -> list[Part]:
    """Return the laws as displayed equations, and those given by a table as sentences."""
    tabulated = [Paragraph(runs(_tabulated(context, law))) for law in laws if law.table]
    shown = [_law(context, law) for law in laws if not law.table]
    return [*([Equations(shown, flow=True)] if shown else []), *tabulated]


def _law(context: PageContext, law: Law) -> Display:
    per_second = _per_second(context, law)
    if law.formula is not None:
        shown, after = display(named(law.name), law.formula, context.rates), per_second(law.formula)
        return replace(shown, math=shown.math + after.math, text=shown.text + after.text)
    symbol = context.symbol(law.name)
    lines, texts = [], []
    for start, formula in law.pieces:
        when = context.words("drive.pieces", time=context.quantity(start, "s"))
        in_words = _TIME.sub('"t"', when)
        after = per_second(formula)
        lines.append(f'{typst_math.math(formula, context.rates)}{after.math} quad "{in_words}"')
        texts.append(f"{typst_math.text(formula, context.rates)}{after.text} {when}")
    return Display(f"{symbol.typst} = cases({', '.join(lines)})", f"{symbol.text} = {'; '.join(texts)}")


def _per_second(context: PageContext, law: Law) -> Callable[[Formula], Display]:
    """Return what follows a formula of a law: the second below the degrees of a drive that is one number, as in "20 deg/s"."""
    is_drive = law in context.run.variant.drive

    def after(formula: Formula) -> Display:
        is_rate = is_drive and bool(degrees_in(formula.args[0] if formula.op == "neg" else formula))
        return Display('"/s"', "/s") if is_rate else Display("", "")

    return after


def _tabulated(context: PageContext, law: Law) -> str:
    words = context.words
    known, unit = f"drive.method.{law.method}", context.run.variant.unit_of(law.of)
    return words(
        "drive.table",
        symbol=context.lettering(law.name),
        of=context.lettering(law.of),
        count=len(law.table),
        first=context.quantity(law.table[0][0], unit),
        last=context.quantity(law.table[-1][0], unit),
        method=words(known) if words.has(known) else clean(law.method),
    )


def moved_by_forces(context: PageContext, motor: Motor) -> list[Part]:
    """Return the sentences on which rates are free and which torques act."""
    say = context.words
    told = [say.count("dynamics.free", len(motor.rates), rates=context.symbol_list(motor.rates))]
    told += [
        say("dynamics.motor" if one.source == FRAME else "dynamics.between", link=clean(one.on), other=clean(one.source),
            law=printed(clean(spelled(one.torque))))
        for one in motor.torques if one.torque is not None
    ]  # fmt: skip
    if not motor.torques:
        told.append(say("dynamics.none"))
    return [Paragraph(context.lettered(say.sentences(told)))]
