"""Parts of a formula -> text on one line, in the notation that the reader of equations expects: fractions, indices, powers …

Enters: texts of the parts.  Leaves: text; a line break separates the rows of a system.
Used by `omml.py`, `mathml.py` and `starmath.py`.
"""

from __future__ import annotations

import re
import unicodedata
from itertools import accumulate

from coursework.grading.reading.documents.signs import plain_signs
from coursework.grading.reading.equations.notation.latex import in_one_piece

DOT = "\u0307"
_DOTS = {DOT, "˙", ".", "dot"}
MATRIX = re.compile(r"\s*\[[^\[\]]*\]\s*")
FUNCTIONS = {"sin", "cos", "tan", "tg", "ctg", "cot", "arcsin", "arccos", "arctan", "arctg", "asin", "acos", "atan", "ln",
              "log", "exp", "sqrt", "abs", "sgn"}  # fmt: skip
_PRIMES = {"'", "′", "’"}


def on_one_line(text: str) -> str:
    """Return a part without line breaks."""
    return text.replace("\n", " ")


def fraction(above: str, below: str) -> str:
    """Return a fraction in double parentheses, the form in which the reader of equations also recognises a time derivative."""
    above, below = on_one_line(above).strip(), on_one_line(below).strip()
    return f" (({above})/({below})) "


def index(body: str, sub: str) -> str:
    """Return a letter with its index as one name: φ with 3 is φ_3, V with M y is V_{My}."""
    name = re.sub(r"[^\w']+|_", "", unicodedata.normalize("NFKC", on_one_line(sub)))
    body = on_one_line(body).strip()
    if not name:
        return f" {body} "
    return f" {body}_{name} " if len(name) == 1 else f" {body}_{{{name}}} "


def power(body: str, exponent: str) -> str:
    """Return a power; a function's power stays before its argument, a prime and a degree sign stay signs."""
    body, exponent = on_one_line(body).strip(), on_one_line(exponent).strip()
    if exponent in _PRIMES:
        return f" {body}' "
    if exponent in {"°", "∘", "o", "º"}:
        return f" {body}° "
    if body.lower() in FUNCTIONS:
        return f" {body}^{exponent} "
    whole = body if re.fullmatch(r"[\w{}]+|\(.*\)", body) else f"({body})"
    return f" {whole}^{exponent} " if re.fullmatch(r"\d+", exponent) else f" {whole}^({exponent}) "


def dotted(body: str) -> str:
    """Return the rate of a name, with a dot over its first letter."""
    body = on_one_line(body).strip()
    return f" {body[:1]}{DOT}{body[1:]} "


def accented(body: str, sign: str) -> str:
    """Return a name under an accent: with a dot it is a rate, an arrow or a bar is dropped."""
    return dotted(body) if sign.strip() in _DOTS else f" {on_one_line(body).strip()} "


def root(body: str, degree: str) -> str:
    """Return a root."""
    return f" sqrt({on_one_line(body)}) " if degree.strip() in {"", "2"} else f" ({on_one_line(body)})^(1/({degree})) "


def applied(function: str, argument: str) -> str:
    """Return a function of its argument."""
    argument = on_one_line(argument).strip()
    return f" {function.strip()}{argument} " if _is_enclosed(argument) else f" {function.strip()}({argument}) "


def enclosed(begin: str, body: str, end: str) -> str:
    """Return a part in its brackets; a system loses its brace, and a matrix has its own brackets already."""
    if "\n" in body.strip("\n") or MATRIX.fullmatch(body):
        return body
    if begin in {"|", "‖"}:
        return f" abs({body}) "
    return f"{'(' if begin in '[{⟨(' and begin else begin}{body}{')' if end in ']}⟩)' and end else end}"


def rows_of(rows: list[str]) -> str:
    """Return a system with one line per row."""
    return "\n" + "\n".join(on_one_line(row) for row in rows) + "\n"


def matrix_of(rows: list[list[str]]) -> str:
    r"""Return a matrix in one piece, as in MATLAB; cells that contain "=" make it a system of equations.

    >>> matrix_of([["a", "0,5"], ["c", "d"]]), matrix_of([["a", "= b"], ["c", "= d"]])
    (' [a, 0.5; c, d] ', '\na = b\nc = d\n')
    """
    if any("=" in cell for row in rows for cell in row) or not any(map(str.strip, map("".join, rows))):
        return rows_of([" ".join(row) for row in rows])
    return in_one_piece(map(on_one_line, row) for row in rows)


def equations_in(text: str) -> list[str]:
    r"""Return the equations of a formula, one per line; a row without "=" is joined to the row that it continues or begins.

    >>> equations_in("a\n+ b = 0\nc = d\n + e")
    ['a + b = 0', 'c = d + e']
    """
    found: list[str] = []
    for row in text.replace("&", " ").split("\n"):
        bare = " ".join(plain_signs(row).split())
        if not bare:
            continue
        if found and not ("=" in found[-1] and "=" in bare and bare[:1] != "="):
            found[-1] += f" {bare}"
        else:
            found.append(bare)
    return found


def _is_enclosed(text: str) -> bool:
    """Return whether a text is enclosed in one pair of parentheses."""
    depths = [*accumulate({"(": 1, ")": -1}.get(sign, 0) for sign in text)]
    return text.startswith("(") and 0 in depths and depths.index(0) == len(text) - 1
