"""The way from the chosen equations to the velocities, block by block, and what it means where that way is closed.

Enters: a `PageContext`.  Leaves: displayed equations with the words around them.  Used by `sections.py`.
"""

from __future__ import annotations

from coursework.formula.tree import Formula
from coursework.page_text import clean
from coursework.reduction.blocks import Block
from coursework.reduction.solution import Solution
from coursework.report.display import display
from coursework.report.page_context import PageContext
from coursework.report.parts import Equations, Paragraph, Part, Runs
from coursework.report.text_runs import runs
from coursework.sentences import say


def solution(context: PageContext) -> list[Part]:
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
    angles = context.angles
    shown = [display(Formula("name", name=name), angles.put_in(formula), context.rates) for name, formula in solution]
    parts: list[Part] = [Paragraph(runs(origin)), Equations(shown)]
    if block.determinant is not None:
        delta = Formula("name", name=f"Delta{number}")
        parts.append(Equations([display(delta, angles.put_in(block.determinant), context.rates, before=_vanishing(context, block.meaning))]))
    return parts


def _vanishing(context: PageContext, meaning: str) -> Runs:
    if meaning == say("determinant.never"):
        return context.say("derivation.never")
    return context.lettered(context.words("derivation.vanishes", meaning=context.told(meaning).rstrip(".")))


def _numeric(context: PageContext, block: Block) -> list[Part]:
    named = {"unknowns": context.symbol_list(block.unknowns), "equations": _names(context, block)}
    if block.size > 2:
        sentence = context.words("derivation.numeric", count=block.size, **named)
    else:
        sentence = context.words.count("derivation.long", block.size, **named)
    meaning = context.told(block.meaning).rstrip(".")
    if meaning and block.meaning != say("determinant.never"):
        sentence += " " + context.words("derivation.numeric_vanishes", meaning=meaning)
    return [Paragraph(context.lettered(sentence))]


def _names(context: PageContext, block: Block) -> str:
    return context.words.listing([f"({clean(name, 40)})" for name in block.equations])
