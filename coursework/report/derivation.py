"""The sections with equations: the drive, the constraints, the way to the velocities.

Enters: a `PageContext`.  Leaves: displayed equations with the words around them.
"""

from __future__ import annotations

from coursework.formula.tree import Formula
from coursework.page_text import clean
from coursework.reduction.blocks import Block
from coursework.reduction.solution import Solution
from coursework.report import equations
from coursework.report.display import math_equation
from coursework.report.page_context import PageContext
from coursework.report.parts import Bullets, Display, Equations, Paragraph, Part, Runs
from coursework.report.text_runs import runs
from coursework.sentences import say
from coursework.variant.record import Law


def drive(context: PageContext) -> list[Part]:
    """The velocities that are known functions of time, and the laws of the configuration."""
    variant, say = context.run.variant, context.words
    parts: list[Part] = []
    if variant.drive:
        key = "drive.point" if variant.driven else "drive.rates"
        parts.append(Paragraph(context.say(key, point=clean(variant.driven or ""))))
        parts += _laws(context, variant.drive)
    else:
        parts.append(Paragraph(runs(say("drive.none"))))
    if variant.functions:
        parts.append(Paragraph(runs(say("drive.functions"))))
        parts += _laws(context, variant.functions)
    return parts


def _laws(context: PageContext, laws: tuple[Law, ...]) -> list[Part]:
    tabulated = [Paragraph(runs(_tabulated(context, law))) for law in laws if law.table]
    displayed = [_law(context, law) for law in laws if not law.table]
    return [*([Equations(displayed)] if displayed else []), *tabulated]


def _law(context: PageContext, law: Law) -> Display:
    if law.formula is not None:
        return _display(context, Formula("name", name=law.name), law.formula)
    symbol = context.symbol(law.name)
    lines, texts = [], []
    for start, formula in law.pieces:
        when = context.words("drive.pieces", time=context.quantity(start, "s"))
        lines.append(f'{equations.math(formula, context.rates)} quad "{when}"')
        texts.append(f"{equations.text(formula, context.rates)} {when}")
    return Display(f"{symbol.typst} = cases({', '.join(lines)})", f"{symbol.text} = {'; '.join(texts)}")


def _tabulated(context: PageContext, law: Law) -> str:
    say = context.words
    known = f"drive.method.{law.method}"
    return say(
        "drive.table",
        symbol=context.symbol(law.name).text,
        of=context.symbol(law.of).text,
        count=len(law.table),
        first=context.numbers.plain(law.table[0][0]),
        last=context.numbers.plain(law.table[-1][0]),
        method=say(known) if say.has(known) else clean(law.method),
    )


def _display(context: PageContext, left: Formula, right: Formula, name: str = "", before: Runs | None = None) -> Display:
    return Display(
        math_equation(left, right, context.rates),
        equations.text_equation(left, right, context.rates),
        name=clean(name, 40),
        before=before or [],
    )


def constraints(context: PageContext) -> list[Part]:
    """Every velocity equation with its reason; redundant ones say so."""
    shown = []
    for equation in context.run.equations:
        reason = context.rich(equation.because) if equation.derived else context.quoted(equation.because)
        if equation.derived:
            remark = context.words("constraints.derived")
            reason = [*reason, {"t": f" ({remark})" if reason else f"({remark})"}]
        display = _display(context, equation.left, equation.right, equation.name, reason)
        if not equation.used:
            display = Display(display.math, display.text, display.name, display.before, context.say("constraints.unused"))
        shown.append(display)
    notes = [Bullets([context.rich(note) for note in context.run.reduction.notes])] if context.run.reduction.notes else []
    return [Paragraph(context.say("constraints.intro")), Equations(shown), *notes] if shown else []


def derivation(context: PageContext) -> list[Part]:
    """Block by block: which equation gives what, the determinant, and when it vanishes."""
    blocks = context.run.reduction.blocks
    if not blocks:
        return []
    unknowns = [name for block in blocks for name in block.unknowns]
    parts: list[Part] = [Paragraph(context.say("derivation.intro", unknowns=context.symbol_list(unknowns)))]
    shown = dict.fromkeys(name for solution in context.run.solutions for _, formula in solution for name in formula.names())
    for name in shown:
        if name in context.run.partials:
            law, by = context.run.partials[name]
            symbols = {"symbol": context.symbol_list([name]), "law": context.symbol_list([law]), "by": context.symbol_list([by])}
            parts.append(Paragraph(context.say("derivation.partial", **symbols)))
    found: set[str] = set()
    for number, (block, solution) in enumerate(zip(blocks, context.run.solutions, strict=True), start=1):
        parts += _solved(context, block, solution, number, found) if solution else _numeric(context, block)
        found |= set(block.unknowns)
    return parts


def _solved(context: PageContext, block: Block, solution: Solution, number: int, found: set[str]) -> list[Part]:
    used = [name for _, formula in solution for name in formula.names() if name in found]
    known = context.symbol_list(list(dict.fromkeys(used)))
    key = "derivation.from_with" if known else "derivation.from"
    origin = context.words.count(key, len(block.equations), equations=_names(context, block), known=known)
    shown = [_display(context, Formula("name", name=name), formula) for name, formula in solution]
    parts: list[Part] = [Paragraph(runs(origin)), Equations(shown)]
    if block.determinant is not None:
        delta = Formula("name", name=f"Delta{number}")
        parts.append(Equations([_display(context, delta, block.determinant, before=_vanishing(context, block.meaning))]))
    return parts


def _vanishing(context: PageContext, meaning: str) -> Runs:
    if meaning == say("determinant.never"):
        return context.say("derivation.never")
    meaning = context.told(meaning).rstrip(".")
    if not meaning:
        return context.say("derivation.determinant")
    return context.lettered(context.words("derivation.vanishes", meaning=meaning))


def _numeric(context: PageContext, block: Block) -> list[Part]:
    sentence = context.words(
        "derivation.numeric",
        count=len(block.unknowns),
        unknowns=context.symbol_list(block.unknowns),
        equations=_names(context, block),
    )
    if meaning := context.told(block.meaning).rstrip("."):
        sentence += " " + context.words("derivation.numeric_vanishes", meaning=meaning)
    return [Paragraph(context.lettered(sentence))]


def _names(context: PageContext, block: Block) -> str:
    return context.words.listing([f"({clean(name, 40)})" for name in block.equations])
