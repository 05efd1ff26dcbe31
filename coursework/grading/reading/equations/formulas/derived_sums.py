"""The derivative of a written-out sum by time, d/dt(r1 cos φ1 + …), diff(…, t), (…)' -> the sum that it is.

Enters: a line in plain signs, the names of the variant.  Leaves: the line with the derivatives worked out.
Used by `plain_text.py`.  What cannot be derived becomes a call of no known function, so that nobody reads a product d/d*t in it.
"""

from __future__ import annotations

import re
from functools import partial, reduce

from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.formulas.repair import sides_of
from coursework.grading.reading.equations.notation.signs import depths
from coursework.variant.formula.made import sum_of
from coursework.variant.formula.reader import parse_equation
from coursework.variant.formula.tree import Formula, FormulaFault, named, number, spelled

_BY_TIME = r"(?:\(\(?\s*[d∂]\s*\)?\s*/\s*\(?\s*[d∂]\s*t\s*\)?\)|\b[d∂]\s*/\s*[d∂]\s*t\b)"
_BEFORE = re.compile(rf"{_BY_TIME}\s*\*?\s*(?=[(\[])")  # d/dt (…)
_CALLED = re.compile(r"'?\b(?:diff|Diff|D|der)\s*(?=[(\[])")  # diff(…, t)
_LAST = re.compile(r",\s*t\s*$")
_OVER = re.compile(r"\b[d∂]\s*(?=[(\[])")  # d(…)/dt
_OVER_TIME = re.compile(r"\s*\)?\s*/\s*\(?\s*[d∂]\s*t\b\s*\)?")
_BEHIND = re.compile(r"\s*(?:\^\s*)?'|\.diff\(\s*t\s*\)")  # (…)', (…).diff(t)
_SUM = re.compile(r"[-+*/\s]")
_LEFT = re.compile(_BY_TIME)
_UNKNOWN, _MOST = " derivative() ", 12


class _NotKnown(ValueError):
    """A formula has no derivative that is known here."""


def with_sums_derived(text: str, spellings: Spellings) -> str:
    """Return a line in which each derivative by time of a sum or product in brackets is worked out."""
    if not re.search(r"[d∂]\s*t\b|'|[dD](?:iff|er)?\s*[(\[]|\.diff", text):
        return text
    return reduce(lambda line, _: _one_derived(line, spellings), range(_MOST), text)


def with_the_rest_unread(text: str) -> str:
    """Return a line in which a derivative that is left, of a product without brackets, is no quotient d/d*t."""
    return _LEFT.sub(_UNKNOWN, text)


def _one_derived(text: str, spellings: Spellings) -> str:
    inside = depths(text)
    for place, sign in enumerate(text):
        if sign not in "([":
            continue
        end = next((at for at in range(place + 1, len(text)) if inside[at] < inside[place]), None)
        if end is None:
            break
        content, begin, after = text[place + 1 : end], place, end + 1
        if found := _ends(_BEFORE, text, place):
            begin = found.start()
        elif (found := _ends(_CALLED, text, place)) and _LAST.search(content):
            begin, content = found.start(), _LAST.sub("", content)
        elif (found := _ends(_OVER, text, place)) and (over := _OVER_TIME.match(text, after)):
            begin, after = found.start(), over.end()
            begin -= over[0].count(")") - over[0].count("(")
        elif (behind := _BEHIND.match(text, after)) and not text[:place].rstrip()[-1:].isalnum():
            after = behind.end()
        else:
            continue
        if _SUM.search(content.strip()):  # a name alone is read as its rate
            sides = (derived(_read(side, spellings), spellings) for side in content.split("="))  # D[a == b, t]
            return f"{text[:begin]}{' = '.join(sides)}{text[after:]}"
    return text


def _ends(pattern: re.Pattern[str], text: str, place: int) -> re.Match[str] | None:
    """Return the match of a pattern that ends at a place."""
    return next((found for found in pattern.finditer(text, place - 40, place + 1) if found.end() == place), None)


def _read(text: str, spellings: Spellings) -> Formula | None:
    try:
        return parse_equation(f"{sides_of(text, spellings).texts[0]} = 0")[0]
    except FormulaFault:
        return None


def derived(tree: Formula | None, spellings: Spellings) -> str:
    """Return the derivative of a formula by time as text; if it has none, a call that no reader takes for an equation."""
    try:
        return f"({spelled(_derivative(tree, spellings))})" if tree else _UNKNOWN
    except _NotKnown:
        return _UNKNOWN


def _derivative(tree: Formula, spellings: Spellings) -> Formula:
    """Return the derivative of a formula by time.  Raises `_NotKnown` where it has none that is known here."""
    derived = partial(_derivative, spellings=spellings)
    if tree.op == "number" or (tree.op == "name" and tree.name == "pi"):
        return number(0)
    if tree.op == "name":
        meant = spellings.canonical(tree.name)
        if meant == "t":
            return number(1)
        if meant in spellings.rates:
            return named(spellings.rates[meant])
        if meant in spellings.data:
            return number(0)
        if (function := spellings.functions.get(meant or "")) is not None:
            return derived(function)
    elif tree.op == "neg":
        return Formula("neg", (derived(tree.args[0]),))
    elif tree.op in {"+", "-"}:
        return sum_of(tree.op, *map(derived, tree.args))
    elif tree.op == "*":
        first, second = tree.args
        return sum_of("+", _product(derived(first), second), _product(first, derived(second)))
    elif tree.op == "/" and derived(tree.args[1]) == number(0):
        return Formula("/", (derived(tree.args[0]), tree.args[1]))
    elif tree.op == "^" and tree.args[1].op == "number":
        base, power = tree.args
        return _product(_product(power, Formula("^", (base, number(power.value - 1)))), derived(base))
    elif tree.op == "call" and tree.name in {"sin", "cos"}:
        (angle,) = tree.args
        turned = Formula("call", (angle,), "cos" if tree.name == "sin" else "sin")
        return _product(turned if tree.name == "sin" else Formula("neg", (turned,)), derived(angle))
    elif tree.op == "call" and tree.name == "sqrt":
        return Formula("/", (derived(tree.args[0]), Formula("*", (number(2), tree))))
    raise _NotKnown


def _product(first: Formula, second: Formula) -> Formula:
    return number(0) if number(0) in (first, second) else Formula("*", (first, second))
