"""A line of a program -> its equation: without declarations, the head of its function, "return", arrows to or from a name.

Enters: a line without comments, names.  Leaves: the line.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.grading.reading.equations.formulas.equations import TURNED, Names, names_in
from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.notation.signs import closing, depths, relates_two_sides
from coursework.grading.reading.equations.systems.parts import LIST, at_commas, at_signs

_TYPED = re.compile(
    r"\b(\w{1,40})\s*:\s*(?:[dD]ouble|[fF]loat|real|extended|integer|f64|f32|number)\s*="
)  # a declaration in Pascal, Rust, Python
_DECLARED = re.compile(r"^(?:static\s+)?(?:const|let|LET|var|double|float|int)\s+(?=\w{1,40}\s*=)")
# An equation that is assigned to a name: eq[1] := …, eq||1 := … in Maple, F(1) = … == … in MATLAB.
_KEPT = re.compile(
    r">?\s*([^\W\d]\w{0,20})(?:[\[({]\s*|\|\|)(\d{1,3})\s*[\])}]?\s*(?::=\s*(?=[^=]+=)|(=)(?!=)\s*(?=[^=]+==[^=]+$))"
)
# A function of a program, and the expression it returns.
_DEFINED = re.compile(
    r"\s*(?:def\s+(\w{1,40})\s*\([^()]*\)[^:()]{0,40}:|(?:[a-z]{2,9}\s+){0,2}(?:double|float|function|fn|func)\s+(\w{1,40})\s*\([^()]*\)"
    r"[^(){}=]{0,20}\{?)\s*(return\b[^}]*)?\}?\s*"
)
# A function without a name of its own: w3 = (t, y) => … in JavaScript, w3 <- function(t) … in R.
_UNNAMED = re.compile(
    r"^(?:(?:const|let|var)\s+)?(\w{1,40})\s*(?:=|<-)\s*(?:(?:\([\w\s,]*\)|\w{1,20})\s*=>|function\s*\([\w\s,]*\))\s*\{?\s*(?:return\s+)?"
    r"(?=[^{\[\s][^={}]*[*/])|\s*\}\s*;?\s*$"
)
# What a solver of Mathematica finds, {{w3 -> a*b, …}}, and what a calculator stores, a*b→w3.
_FOUND = re.compile(r"\s*(?:Out\[\d+\]\s*=\s*)?(\{*)\s*(\w{1,20})\s*(?:->|→)\s*(?=[^=]*[*/(])[^=]*$")
_RULE = re.compile(r"(?<=[{\s,])(\w{1,20})\s*(?:->|→)")
_STORED = re.compile(r"(?=[^=→*/]*[*/])([^=→]*?)\s*(?:→|->)\s*([^\W\d]\w{0,8})\s*;?\s*")
_RETURNED = re.compile(r"return\s+(?=\S)(?!.*=)")
_IN_CELLS = re.compile(r"^\s*([^\W\d]\w{0,12})\s*(?:[\[(][^\[\]()=|]{1,12}[\])]\s*)?\|\s*=")  # v [m/s] | =-r*w*SIN(phi)
_COLON = re.compile(r"\s*([^\W\d][\w.]{0,12})\s*:\s*(?!=)([^=:]*[*/][^=:]*|[^=:]+\$\s*)")  # v.P:c*ω.3*cos(φ.3), g: gamma$
_KEYED = re.compile(
    r"^\s*(?:return|[\w.]{1,20}\s*=)\s*\{[\w\s,]*?,?\s*(\w{1,12}\s*:[^{}:]+)\}[;\s]*$"
)  # return {w2, w3, vP: c*w3*…}
_NUMBER = re.compile(r"\s*-?\d++\.?\d*+\s*")
_BETWEEN_CELLS, _SUM, _IS_USED = re.compile("[,;]"), re.compile(r"[\w)]\s*[-+]\s*[\w(]"), re.compile(r"\s*[*@·=]")
_UNPACKED = re.compile(r"\(?[^\W\d]\w{0,20}(?:\s*,\s*[^\W\d]\w{0,20})+\)?\s*:?=")  # a11, a12 = …, …


def function_begun(line: str, sought: Sequence[str]) -> tuple[str, str] | None:
    """Return (name, formula in the same line) of the function that begins in a line, w3 for calc_w3; None if none does."""
    if (defined := _DEFINED.fullmatch(line)) is None:
        return None
    called = defined[1] or defined[2]
    meant = [one for one in called.split("_") if one in sought]
    return meant[0] if len(meant) == 1 else called, defined[3] or ""


def without_declarations(line: str, spellings: Spellings) -> str:
    """Return the equation that a line declares, finds, stores or keeps under a name of its own."""
    if "→" in line or "->" in line:
        if (found := _FOUND.match(line)) and (found[1] or spellings.canonical(found[2])):
            line = _RULE.sub(r"\1 = ", line[found.end(1) :].strip("{} ").join("{}"))
        line = f"{stored[2]} = {stored[1]}" if (stored := _STORED.fullmatch(line)) else line
    line = _UNNAMED.sub(lambda found: f"{found[1]} = " if found[1] else "", line) if _UNNAMED.match(line) else line
    line = _DECLARED.sub("", _TYPED.sub(r"\1 =", line))
    if (under := _KEPT.match(line)) and (under[3] or spellings.angle(under[1] + under[2]) is None):
        line = line[under.end() :]
    return _one_by_one(line) if _UNPACKED.match(line) else line


def as_value(line: str, function: str, sought: Sequence[str]) -> str:
    """Return what a line returns as the value of its function, if that is a velocity or has an angle in it."""
    if not (returned := _RETURNED.match(line)):
        return line
    rest = line[returned.end() :]  # a list of residuals is not the value of a name
    is_value = TURNED.search(rest) or function in sought
    return f"{function} = {rest}" if function and is_value and not rest.startswith("[") else rest


def with_sign(line: str, sought: Sequence[str], spellings: Spellings) -> str:
    """Return a line with "=" for the colon of Maxima, g: gamma$, and of SMath and JavaScript before the formula of a velocity."""
    line = _IN_CELLS.sub(r"\1 =", line)
    if keyed := _KEYED.search(line):
        line = keyed[1]
    found = _COLON.fullmatch(line)
    meant = spellings.canonical(found[1].replace(".", "")) if found else None
    return f"{found[1]} = {found[2]}" if found and (meant in sought or line.rstrip().endswith("$")) else line


def residuals(line: str, names: Names) -> list[str]:
    """Return the cells of a vector that a line is or defines, if each is a sum with a sought velocity: they are to vanish."""
    begun = LIST.match(line)
    end = closing(line, begun.end() - 1) if begun else 0
    if begun is None or end < begun.end() or "=" in line[begun.end() :] or _IS_USED.match(line, end + 1):
        return []
    cells = [cell.strip() for cell in at_signs(_BETWEEN_CELLS, line[begun.end() : end]) if cell.strip()]
    sought = {*names.expected.variant.sought}
    is_sum = [_SUM.search(cell) and not sought.isdisjoint(names_in(cell, names.spellings)) for cell in cells]
    return cells if len(cells) > 1 and all(is_sum) else []


def closed(line: str) -> str:
    """Return a line without the bracket of a list that opens in it and closes in a later line, or that closes in it.

    >>> closed("eqs = {a == b,"), closed("c == d}, {x, y}]"), closed("[a = b]")
    ('a == b,', 'c == d', 'a = b')
    """
    inside = depths(line)
    if line[:1] == "[" and line[-1:] == "]" and 0 not in inside[:-1] and not re.search(r"[,;]", line):
        return line[1:-1].strip()  # framed
    if (begun := LIST.match(line)) and inside[-1] == inside[begun.end() - 1] > 0:
        return line[begun.end() :].strip()
    end = inside.index(-1) if -1 in inside else 0
    return line[:end].strip() if line[end : end + 1] in {"]", "}"} and not relates_two_sides(line[end:]) else line


def _one_by_one(line: str) -> str:
    """Return a line that sets several names at once with a formula for each of them.

    >>> _one_by_one("a, b = 2*c, d*max(e, f)"), _one_by_one("r, l = 0.5, 2"), _one_by_one("phi1, phi2 = y")
    ('a = 2*c; b = d*max(e, f)', 'r = 0.5; l = 2', 'phi1, phi2 = y')
    """
    left, _, right = line.strip(" ;").partition("=")
    named, values = left.strip("() ").split(","), at_commas(right)
    is_data = all(map(_NUMBER.fullmatch, values))
    if len(named) != len(values) or not ("*" in right or is_data or TURNED.search(right)) or "=" in right:
        return line
    return "; ".join(f"{name.strip()} = {value.strip()}" for name, value in zip(named, values, strict=True))
