"""The solution of the chosen equations for the velocities, block by block, and the first step by hand.

Enters: a `PageContext`.  Leaves: displayed equations with the words around them.  Used by `sections.py`.
"""

from __future__ import annotations

from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.textbook.cramer import Cramer, cramer
from coursework.equations.reduction.textbook.solution import Solution
from coursework.report.formulas import typst_math as setting
from coursework.report.formulas.display import display, marked_text
from coursework.report.sections.derivation.first_step import first_step
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Display, Equations, Paragraph, Part, Runs
from coursework.report.text.text_runs import printed, runs
from coursework.variant.formula.made import summed
from coursework.variant.formula.tree import Formula, named, number
from coursework.words.sentences import say


def solution(context: PageContext) -> list[Part]:
    """Return each block in the order of solving, as a formula, by Cramer's rule or as a sentence; then the scheme's step."""
    reduction = context.run.reduction
    parts: list[Part] = []
    for law, by in context.run.partials.values():
        above, below = context.lettering(law), context.lettering(by)
        symbols = {"symbol": f"∂{above}/∂{below}", "law": above, "by": below}
        parts.append(Paragraph(context.say("derivation.partial", **symbols)))
    found: set[str] = set()
    worked = cramer(context.run.scene.equations, reduction, [bool(formulas) for formulas in context.run.solutions])
    for number_of, (block, formulas, shown) in enumerate(
        zip(reduction.blocks, context.run.solutions, worked, strict=True), start=1
    ):
        delta = f"Delta{number_of}" if len(reduction.blocks) > 1 else "Delta"
        if shown is not None:
            parts += _by_cramer(context, block, shown, formulas, delta)
        elif formulas:
            parts += _single(context, block, formulas, delta, found)
        else:
            parts.append(_numeric(context, block))
        found |= set(block.unknowns)
    return [*parts, *first_step(context)]


def _single(context: PageContext, block: Block, formulas: Solution, delta: str, found: set[str]) -> list[Part]:
    """Return a block solved by formulas: the equations it follows from, the formulas, where the determinant is zero."""
    used = dict.fromkeys(name for _, formula in formulas for name in formula.names() if name in found)
    key = "derivation.from_with" if used else "derivation.from"
    origin = context.words(key, equations=_names(context, block), known=context.symbol_list(used))
    shown = [_set(context, named(name), formula) for name, formula in formulas]
    shown[0] = Display(shown[0].math, shown[0].text, before=runs(origin), after=_vanishing(context, block, delta))
    return [Equations(shown, compact=True)]


def _set(context: PageContext, left: Formula, right: Formula) -> Display:
    return display(left, context.angles.put_in(right), context.rates)


def _by_cramer(context: PageContext, block: Block, shown: Cramer, formulas: Solution, delta: str) -> list[Part]:
    """Return a block of two by Cramer's rule: the equations with gathered right sides, three determinants, the quotients."""
    say_, angles = context.words, context.angles
    names = [named(name) for name in shown.unknowns]
    put_in = context.symbol_list(shown.put_in)
    key = "derivation.cramer_put_in" if put_in else "derivation.cramer"
    intro = say_(key, equations=_names(context, block), unknowns=context.symbol_list(shown.unknowns), known=put_in)
    rows = [
        display(_gathered(row, names), angles.put_in(side), context.rates)
        for row, side in zip(shown.coefficients, shown.right_sides, strict=True)
    ]
    determinants = [_set(context, named(delta), shown.determinant)]
    for place, numerator in enumerate(shown.numerators, start=1):
        determinants.append(_named(context, delta, place, numerator))
    quotients = [_quotient(context, name, delta, place, formula) for place, (name, formula) in enumerate(formulas, start=1)]
    quotients[-1] = Display(quotients[-1].math, quotients[-1].text, after=_vanishing(context, block, delta, shown.determinant))
    return [Paragraph(runs(intro)), *(Equations(lines, flow=True) for lines in (rows, determinants, quotients))]


def _gathered(row: tuple[Formula, Formula], names: list[Formula]) -> Formula:
    """Return a11 w1 + a12 w2; a negative term is subtracted, and one with the coefficient 0 is left out."""
    signed = [(part.args[0], -1) if part.op == "neg" else (part, 1) for part in row]
    terms = [(Formula("*", (part, name)), sign) for (part, sign), name in zip(signed, names, strict=True) if part != number(0)]
    return summed(terms)


def _delta(context: PageContext, delta: str, place: int) -> tuple[str, str]:
    """Return the name of the determinant for the unknown at `place`, in Typst math and as text: Δ₃₁ for Δ₃ and place 1."""
    symbol = context.symbol(delta)
    low = f"{symbol.subscript}{place}"
    return f"Δ_({low})" if len(low) == 1 else f"Δ_({' '.join(low)})", context.symbol(f"Delta{low}").text


def _named(context: PageContext, delta: str, place: int, numerator: Formula) -> Display:
    made = _set(context, named("Delta"), numerator)
    math, text = _delta(context, delta, place)
    return Display(made.math.replace("Δ", math, 1), made.text.replace("Δ", text, 1))


def _quotient(context: PageContext, name: str, delta: str, place: int, formula: Formula) -> Display:
    """Return w1 = Delta1 / Delta = formula."""
    symbol, below = context.symbol(name), context.symbol(delta)
    math, text = _delta(context, delta, place)
    right = context.angles.put_in(formula)
    short = display(named(name), right, context.rates)
    if "\\" in short.math:  # a formula of several lines stands without the determinants
        return short
    source = f"{symbol.typst} = frac({math}, {below.typst}) = {setting.math(right, context.rates)}"
    return Display(source, f"{symbol.text} = {text} / {below.text} = {setting.text(right, context.rates)}")


def _vanishing(context: PageContext, block: Block, delta: str, determinant: Formula | None = None) -> Runs:
    """Return the sentence on where the determinant is zero and what that means; empty if there is none or it is a number."""
    shown = determinant or block.determinant
    if shown is None or not set(shown.names()) - {"pi"}:
        return []  # a plain number is never zero
    text = setting.text_equation(named(delta), context.angles.put_in(shown), context.rates, in_sentence=True)
    text = marked_text(text, context.numbers.mark)
    if block.meaning == say("determinant.never"):
        return context.lettered(context.words("derivation.never", determinant=text))
    meaning = printed(context.told(block.meaning)).rstrip(".")
    return context.lettered(context.words("derivation.vanishes", determinant=text, meaning=meaning))


def _numeric(context: PageContext, block: Block) -> Part:
    named = {"unknowns": context.symbol_list(block.unknowns), "equations": _names(context, block)}
    if block.size > 2:
        sentence = context.words("derivation.numeric", count=block.size, **named)
    else:
        sentence = context.words.count("derivation.long", block.size, **named)
    meaning = printed(context.told(block.meaning)).rstrip(".")
    if meaning and block.meaning != say("determinant.never"):
        sentence = context.words.sentences([sentence, context.words("derivation.numeric_vanishes", meaning=meaning)])
    return Paragraph(context.lettered(sentence))


def _names(context: PageContext, block: Block) -> str:
    return context.words.listing([f"({context.equation(name)})" for name in block.equations])
