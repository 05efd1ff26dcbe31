"""Numbers, symbols and equations of individual variants in the form in which the pages print them.

Enters: a variant, values, formulas.  Leaves: runs of text and displayed equations, as plain data for the templates.
Used by `sheet.py`, `key.py` and `class_page.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.report.formulas.display import display, marked, marked_text
from coursework.report.formulas.typst_math import Setter
from coursework.report.text.symbols import Rates, symbol
from coursework.report.text.text_runs import ITALIC, printed, runs, with_letters
from coursework.report.text.words import Words
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.variant import Law, Variant
from coursework.words.templates import clean

Equation = dict[str, str]  # Typst math and plain text
LONGEST = 200


def symbol_runs(variant: Variant, name: str) -> list[dict[str, str]]:
    """Return the symbol of a name as runs of text."""
    return [symbol(name, rates_of(variant)).run]


def symbol_text(variant: Variant, name: str) -> str:
    """Return the symbol of a name as text for a sentence, such as "ω₃"; a single letter is marked to be set in italics."""
    text = symbol(name, rates_of(variant)).text
    return f"{ITALIC[0]}{text}{ITALIC[1]}" if len(text) == 1 else text


def time_text(variant: Variant, key: str, words: Words) -> str:
    """Return the step or end (`key`) of the table, preceded by its formula if the file has one."""
    value = words.amount(words.numbers.plain(getattr(variant.time, key)), "s")
    formula = variant.times.get(("time", key))
    if formula is None:
        return value
    return f"{Setter(typst=False, rates=rates_of(variant)).set(formula).source} = {value}"


def lettered(variant: Variant, text: str) -> list[dict[str, str]]:
    """Return a sentence of our own as runs, with the variant's names as symbols; values in it must be clean already."""
    return runs(with_letters(printed(text), "th"), (*variant.columns, *variant.values, *(law.name for law in variant.laws)))


def rates_of(variant: Variant) -> Rates:
    """Return the velocities of a table, for the symbols of their derivatives."""
    return Rates(frozenset(variant.velocities))


def datum(text: str, unit: str, words: Words) -> str:
    """Return a datum with the digits with which it was drawn, and its unit."""
    return words.amount(words.numbers.dressed(clean(text, LONGEST)), unit)


def equation(variant: Variant, left: Formula, right: Formula, words: Words, name: str = "") -> Equation:
    """Return a displayed equation with `name` in its margin."""
    shown = marked(display(left, right, rates_of(variant), name), words("decimal"))
    return {"math": shown.math, "text": shown.text, "name": shown.name}


def drives(variant: Variant, words: Words) -> tuple[list[Equation], list[str]]:
    """Return the laws of the drive as equations, and sentences on those given by tables and on the functions."""
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
