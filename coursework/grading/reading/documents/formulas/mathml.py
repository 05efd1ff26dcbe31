"""MathML, in which OpenDocument stores its formulas -> text on one line.

Enters: a `FormulaNode`, names without prefix.  Leaves: text; if a formula only has a StarMath annotation, that is read.
Used by `odt.py`.
"""

from __future__ import annotations

from coursework.grading.reading.documents.formulas.formula_text import (
    MATRIX,
    accented,
    enclosed,
    fraction,
    index,
    matrix_of,
    power,
    root,
    rows_of,
)
from coursework.grading.reading.documents.formulas.formula_tree import FormulaNode
from coursework.grading.reading.documents.formulas.starmath import text_of_starmath

ELEMENTS = frozenset({
    "math", "semantics", "annotation", "mrow", "mi", "mn", "mo", "mtext", "mfrac", "msub", "msup", "msubsup", "msqrt", "mroot",
    "mfenced", "mover", "munder", "mtable", "mtr", "mtd", "mspace", "mstyle", "mpadded", "mphantom",
})  # fmt: skip


def text_of_mathml(node: FormulaNode) -> str:
    """Return a formula as text, with one line per row of a system; from its StarMath if the MathML is empty."""
    shown = _text(node)
    return shown if shown.strip() else text_of_starmath(_annotation(node))


def _annotation(node: FormulaNode) -> str:
    for part in node.children:
        if part.name == "annotation" and "starmath" in part.values.get("encoding", "").lower():
            return "".join(text for text in part.inside if isinstance(text, str))
        if found := _annotation(part):
            return found
    return ""


def _text(node: FormulaNode) -> str:
    name, parts = node.name, node.children
    if name in {"mi", "mn", "mo", "mtext"}:
        text = "".join(part for part in node.inside if isinstance(part, str)).strip()
        return f" {text} " if name == "mtext" and len(text) > 1 else text
    if name in {"annotation", "mphantom"}:
        return ""
    if name == "mspace":
        return "\n" if node.values.get("linebreak") == "newline" else " "
    if name == "mfrac" and len(parts) >= 2 and node.values.get("linethickness", "")[:1] == "0":  # a vector of two rows
        return matrix_of([[_text(part)] for part in parts])
    if name in _PAIRS and len(parts) >= 2:
        return _PAIRS[name](_text(parts[0]), _text(parts[1]))
    if name == "msubsup" and len(parts) >= 3:
        return power(index(_text(parts[0]), _text(parts[1])), _text(parts[2]))
    if name == "munder" and parts:
        return _text(parts[0])
    if name == "msqrt":
        return root(_row(node), "")
    if name == "mfenced":
        separator = node.values.get("separators", ",")[:1]
        body = separator.join(_text(part) for part in parts)
        return enclosed(node.values.get("open", "(")[:1], body, node.values.get("close", ")")[:1])
    if name == "mtable":
        return matrix_of([[_text(cell) for cell in row.children] for row in parts if row.name == "mtr"])
    return _row(node)


def _row(node: FormulaNode) -> str:
    """Return the parts in sequence; blanks around each name keep a product of two names from becoming one name."""
    pieces: list[str] = []
    for part in node.inside:
        if isinstance(part, str):
            pieces.append(part if part == "…" else "")
            continue
        piece = _text(part)
        pieces.append(f" {piece} " if part.name == "mi" else piece)
    text = "".join(pieces)
    braced = text.strip().removeprefix("{").strip(" ")
    if text.strip().startswith("{") and MATRIX.fullmatch(braced):  # a matrix after a brace has the rows of a system
        braced = rows_of(braced[1:-1].split("; "))
    return braced if "\n" in braced else text


_PAIRS = {
    "mfrac": fraction,
    "msub": index,
    "msup": power,
    "mover": accented,
    "mroot": root,
}
