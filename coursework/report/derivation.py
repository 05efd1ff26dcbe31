"""The sections with equations: the drive, the constraints, the way to the velocities.

Enters: a `Desk`.  Leaves: displayed equations with the words around them.
"""

from __future__ import annotations

from coursework.formula.tree import Formula
from coursework.report import equations
from coursework.report.desk import Desk
from coursework.report.display import math_equation
from coursework.report.lettering import clean, runs
from coursework.report.parts import Bullets, Display, Equations, Paragraph, Part, Runs
from coursework.report.source import Block, Solution
from coursework.sentences import say
from coursework.variant.record import Law


def drive(desk: Desk) -> list[Part]:
    """The velocities that are known functions of time, and the laws of the configuration."""
    variant, say = desk.run.variant, desk.words
    parts: list[Part] = []
    if variant.drive:
        key = "drive.point" if variant.driven else "drive.rates"
        parts.append(Paragraph(desk.say(key, point=clean(variant.driven or ""))))
        parts += _laws(desk, variant.drive)
    else:
        parts.append(Paragraph(runs(say("drive.none"))))
    if variant.functions:
        parts.append(Paragraph(runs(say("drive.functions"))))
        parts += _laws(desk, variant.functions)
    return parts


def _laws(desk: Desk, laws: tuple[Law, ...]) -> list[Part]:
    tabulated = [Paragraph(runs(_tabulated(desk, law))) for law in laws if law.table]
    displayed = [_law(desk, law) for law in laws if not law.table]
    return [*([Equations(displayed)] if displayed else []), *tabulated]


def _law(desk: Desk, law: Law) -> Display:
    if law.formula is not None:
        return _display(desk, Formula("name", name=law.name), law.formula)
    symbol = desk.symbol(law.name)
    lines, texts = [], []
    for start, formula in law.pieces:
        when = desk.words("drive.pieces", time=desk.quantity(start, "s"))
        lines.append(f'{equations.math(formula, desk.rates)} quad "{when}"')
        texts.append(f"{equations.text(formula, desk.rates)} {when}")
    return Display(f"{symbol.typst} = cases({', '.join(lines)})", f"{symbol.text} = {'; '.join(texts)}")


def _tabulated(desk: Desk, law: Law) -> str:
    say = desk.words
    known = f"drive.method.{law.method}"
    return say(
        "drive.table",
        symbol=desk.symbol(law.name).text,
        of=desk.symbol(law.of).text,
        count=len(law.table),
        first=desk.numbers.plain(law.table[0][0]),
        last=desk.numbers.plain(law.table[-1][0]),
        method=say(known) if say.has(known) else clean(law.method),
    )


def _display(desk: Desk, left: Formula, right: Formula, name: str = "", before: Runs | None = None) -> Display:
    return Display(
        math_equation(left, right, desk.rates),
        equations.text_equation(left, right, desk.rates),
        name=clean(name, 40),
        before=before or [],
    )


def constraints(desk: Desk) -> list[Part]:
    """Every velocity equation with its reason; redundant ones say so."""
    shown = []
    for equation in desk.run.equations:
        reason = desk.rich(equation.because) if equation.derived else desk.quoted(equation.because)
        if equation.derived:
            remark = desk.words("constraints.derived")
            reason = [*reason, {"t": f" ({remark})" if reason else f"({remark})"}]
        display = _display(desk, equation.left, equation.right, equation.name, reason)
        if not equation.used:
            display = Display(display.math, display.text, display.name, display.before, desk.say("constraints.unused"))
        shown.append(display)
    notes = [Bullets([desk.rich(note) for note in desk.run.reduction.notes])] if desk.run.reduction.notes else []
    return [Paragraph(desk.say("constraints.intro")), Equations(shown), *notes] if shown else []


def derivation(desk: Desk) -> list[Part]:
    """Block by block: which equation gives what, the determinant, and when it vanishes."""
    blocks = desk.run.reduction.blocks
    if not blocks:
        return []
    unknowns = [name for block in blocks for name in block.unknowns]
    parts: list[Part] = [Paragraph(desk.say("derivation.intro", unknowns=desk.symbol_list(unknowns)))]
    shown = dict.fromkeys(name for solution in desk.run.solutions for _, formula in solution for name in formula.names())
    for name in shown:
        if name in desk.run.partials:
            law, by = desk.run.partials[name]
            symbols = {"symbol": desk.symbol_list([name]), "law": desk.symbol_list([law]), "by": desk.symbol_list([by])}
            parts.append(Paragraph(desk.say("derivation.partial", **symbols)))
    found: set[str] = set()
    for number, (block, solution) in enumerate(zip(blocks, desk.run.solutions, strict=True), start=1):
        parts += _solved(desk, block, solution, number, found) if solution else _numeric(desk, block)
        found |= set(block.unknowns)
    return parts


def _solved(desk: Desk, block: Block, solution: Solution, number: int, found: set[str]) -> list[Part]:
    used = [name for _, formula in solution for name in formula.names() if name in found]
    known = desk.symbol_list(list(dict.fromkeys(used)))
    key = "derivation.from_with" if known else "derivation.from"
    origin = desk.words.count(key, len(block.equations), equations=_names(desk, block), known=known)
    shown = [_display(desk, Formula("name", name=name), formula) for name, formula in solution]
    parts: list[Part] = [Paragraph(runs(origin)), Equations(shown)]
    if block.determinant is not None:
        delta = Formula("name", name=f"Delta{number}")
        parts.append(Equations([_display(desk, delta, block.determinant, before=_vanishing(desk, block.meaning))]))
    return parts


def _vanishing(desk: Desk, meaning: str) -> Runs:
    if meaning == say("determinant.never"):
        return desk.say("derivation.never")
    meaning = desk.told(meaning).rstrip(".")
    if not meaning:
        return desk.say("derivation.determinant")
    return desk.lettered(desk.words("derivation.vanishes", meaning=meaning))


def _numeric(desk: Desk, block: Block) -> list[Part]:
    sentence = desk.words(
        "derivation.numeric",
        count=len(block.unknowns),
        unknowns=desk.symbol_list(block.unknowns),
        equations=_names(desk, block),
    )
    if meaning := desk.told(block.meaning).rstrip("."):
        sentence += " " + desk.words("derivation.numeric_vanishes", meaning=meaning)
    return [Paragraph(desk.lettered(sentence))]


def _names(desk: Desk, block: Block) -> str:
    return desk.words.listing([f"({clean(name, 40)})" for name in block.equations])
