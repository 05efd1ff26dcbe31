"""Numbers, symbols and equations of individual variants as the pages set them.

Enters: a variant, values, formulas.  Leaves: runs and displayed equations, as plain data for the templates.
Used by `sheet.py`, `key.py` and `class_page.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.report.formulas.display import display, marked, marked_text
from coursework.report.formulas.typst_math import Setter
from coursework.report.text.symbols import Rates, symbol
from coursework.report.text.text_runs import ITALIC, printed, runs
from coursework.report.text.words import Words
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.variant import Law, Variant
from coursework.words.templates import clean

Equation = dict[str, str]  # Typst math and plain text
LONGEST = 200


def symbol_runs(variant: Variant, name: str) -> list[dict[str, str]]:
    """Return the symbol of a name as runs."""
    return [symbol(name, rates_of(variant)).run]


def symbol_text(variant: Variant, name: str) -> str:
    """Return the symbol of a name as text, for sentences: "ω₃"; a letter alone is marked, so that it is set as a symbol."""
    text = symbol(name, rates_of(variant)).text
    return f"{ITALIC[0]}{text}{ITALIC[1]}" if len(text) == 1 else text


def time_text(variant: Variant, key: str, words: Words) -> str:
    """Return the step or end of the table; where the file has a formula for it, that too."""
    value = words.amount(words.numbers.plain(getattr(variant.time, key)), "s")
    formula = variant.times.get(("time", key))
    if formula is None:
        return value
    return f"{Setter(typst=False, rates=rates_of(variant)).set(formula).source} = {value}"


def lettered(variant: Variant, text: str) -> list[dict[str, str]]:
    """Return a sentence of our own as runs, the names of the variant set as symbols; what is filled in is clean already."""
    laws = (law.name for law in (*variant.drive, *variant.functions))
    return runs(printed(text), (*variant.columns, *(given.name for given in variant.given), *laws))


def rates_of(variant: Variant) -> Rates:
    """Return the velocities of a table, as symbols of their derivatives know them."""
    return Rates(frozenset(variant.velocities))


def datum(text: str, unit: str, words: Words) -> str:
    """Return a datum with the digits it was drawn with, and its unit."""
    return words.amount(words.numbers.dressed(clean(text, LONGEST)), unit)


def equation(variant: Variant, left: Formula, right: Formula, words: Words, name: str = "") -> Equation:
    """Return a displayed equation; `name` stands at its margin."""
    shown = marked(display(left, right, rates_of(variant), name), words("decimal"))
    return {"math": shown.math, "text": shown.text, "name": shown.name}


def drives(variant: Variant, words: Words) -> tuple[list[Equation], list[str]]:
    """Return the laws of the drive as equations, and in words those that are tables or change their formula."""
    shown: list[Equation] = []
    told: list[str] = []
    for law in variant.drive:
        if law.formula is not None:
            shown.append(equation(variant, named(law.name), law.formula, words))
        elif law.pieces:
            shown += [equation(variant, named(law.name), piece, words, _from(at, words)) for at, piece in law.pieces]
        else:
            told.append(words("sheet.tabled", name=symbol_text(variant, law.name), file=clean(law.file, LONGEST)))
    return shown, told + [_function(variant, law, words) for law in variant.functions]


def _function(variant: Variant, law: Law, words: Words) -> str:
    name = symbol_text(variant, law.name)
    if law.table:
        return words("sheet.tabled", name=name, file=clean(law.file, LONGEST))
    plain = Setter(typst=False, rates=rates_of(variant))
    return "; ".join(f"{name} = {marked_text(plain.set(part).source, words('decimal'))}" for part in law.formulas)


def _from(time: float, words: Words) -> str:
    return words("sheet.from", time=words.amount(words.numbers.plain(time), "s"))


Plain = dict[str, Any]
