"""Word's equations (OMML, which RTF uses too) -> text on one line.

Enters: a `FormulaNode`, names without prefix.  Leaves: text.  Source: ECMA-376, part 1, section 22.1.
Used by `docx.py` and `rtf.py`.
"""

from __future__ import annotations

from collections.abc import Callable

from coursework.grading.reading.documents.formulas.formula_text import (
    FUNCTIONS,
    accented,
    applied,
    enclosed,
    fraction,
    index,
    matrix_of,
    power,
    root,
    rows_of,
)
from coursework.grading.reading.documents.formulas.formula_tree import FormulaNode

# The elements that have a meaning; of all others only the contents are read.
ELEMENTS = frozenset({
    "oMath", "r", "t", "e", "f", "fPr", "type", "num", "den", "sSub", "sSup", "sSubSup", "sPre", "sub", "sup", "rad", "deg", "d",
    "dPr", "begChr", "endChr", "func", "fName", "acc", "accPr", "chr", "nary", "eqArr", "m", "mr", "bar", "limLow", "limUpp",
    "lim", "br",
})  # fmt: skip


def text_of_omml(node: FormulaNode) -> str:
    """Return a formula as text, with one line per row of a system."""
    special = _WAYS.get(node.name)
    return special(node) if special else _inside(node)


def _inside(node: FormulaNode | None) -> str:
    if node is None:
        return ""
    return "".join(part if isinstance(part, str) else text_of_omml(part) for part in node.inside)


def _part(node: FormulaNode, name: str) -> str:
    return _inside(node.child(name))


def _property(node: FormulaNode, group: str, name: str, otherwise: str) -> str:
    """Return the sign `name` from the properties `group` of an element, `otherwise` if they do not give it."""
    properties = node.child(group)
    found = properties.child(name) if properties else None
    return otherwise if found is None else found.values.get("val", "")[:5]


def _delimited(node: FormulaNode) -> str:
    parts = [_inside(part) for part in node.children if part.name == "e"]
    return enclosed(_property(node, "dPr", "begChr", "("), ", ".join(parts), _property(node, "dPr", "endChr", ")"))


def _run(node: FormulaNode) -> str:
    """Return the text of a run; a function name with a run of its own is separated from the name before it."""
    text = _inside(node)
    return f" {text.strip()} " if text.strip() in FUNCTIONS else text


def _fraction(node: FormulaNode) -> str:
    """Return a fraction; one without a bar is a vector of two rows."""
    parts = _part(node, "num"), _part(node, "den")
    return matrix_of([[part] for part in parts]) if _property(node, "fPr", "type", "") == "noBar" else fraction(*parts)


_WAYS: dict[str, Callable[[FormulaNode], str]] = {
    "f": _fraction,
    "sSub": lambda node: index(_part(node, "e"), _part(node, "sub")),
    "sSup": lambda node: power(_part(node, "e"), _part(node, "sup")),
    "sSubSup": lambda node: power(index(_part(node, "e"), _part(node, "sub")), _part(node, "sup")),
    "sPre": lambda node: power(index(_part(node, "e"), _part(node, "sub")), _part(node, "sup")),
    "rad": lambda node: root(_part(node, "e"), _part(node, "deg")),
    "d": _delimited,
    "func": lambda node: applied(_part(node, "fName"), _part(node, "e")),
    "acc": lambda node: accented(_part(node, "e"), _property(node, "accPr", "chr", "\u0302")),
    "nary": lambda node: f" ∑({_inside(node)}) ",
    "eqArr": lambda node: rows_of([_inside(part) for part in node.children if part.name == "e"]),
    "m": lambda node: matrix_of([list(map(_inside, row.children)) for row in node.children if row.name == "mr"]),
    "r": _run,
    "br": lambda node: "\n",
    "dPr": lambda node: "",
    "fPr": lambda node: "",
    "accPr": lambda node: "",
}
