"""Formulas -> formulas of a spreadsheet, with English names and decimal points, as Excel and LibreOffice store them.

Enters: `Formula`s and the cells of their names.  Leaves: text without the equals sign.  Used inside `workbook/`.

A spreadsheet reads -2^2 as (-2)^2 and ATAN2 with x first; a piecewise law becomes nested IFs, a tabulated law INDEX of its
coefficients in the row found by MATCH.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from coursework.variant.formula.tree import Formula, factors

Cell = Callable[[Formula], str]
_CALLS = {"log": "LN"}  # other functions have the same names in capitals
_SUM, _PRODUCT, _POWER, _ATOM = 1, 2, 3, 4
_LEVELS = {"+": _SUM, "-": _SUM, "neg": _SUM, "*": _PRODUCT, "/": _PRODUCT, "^": _POWER}


def spreadsheet(tree: Formula, names: Mapping[str, str], table: Callable[[str, Formula], str] | None = None) -> str:
    """Return a formula of a spreadsheet; `names` gives the cell of each name, `table` writes a tabulated law.

    >>> from coursework.variant.formula.reader import parse
    >>> spreadsheet(parse("-a^2*atan2(y, x) - (b - 3)"), {"a": "_a", "b": "_b", "x": "B2", "y": "C2"})
    '(-(_a^2))*ATAN2(B2,C2)-(_b-3)'
    """

    def inner(node: Formula, least: int = _SUM) -> str:
        text = written(node)
        return f"({text})" if _LEVELS.get(node.op, _ATOM) < least else text

    def written(node: Formula) -> str:
        match node.op:
            case "number":
                return f"({node.name})" if "/" in node.name else node.name
            case "name":
                return "PI()" if node.name == "pi" else names[node.name]
            case "call":
                return called(node)
            case "neg":
                text, factor = inner(node.args[0], _PRODUCT), next(factors(node.args[0], "*/"))[0]
                if factor.op == "^":  # a spreadsheet would take the minus before it to the power too
                    power = inner(factor, _POWER)
                    text = f"({power}){text[len(power) :]}"
                return f"-{text}"
        first, second = node.args
        level = _LEVELS[node.op]
        if node.op == "^":
            return f"{inner(first, _ATOM)}^{inner(second, _ATOM)}"
        return f"{inner(first, level)}{node.op}{inner(second, level + 1)}"

    def called(node: Formula) -> str:
        if node.name.startswith("_table_"):
            assert table is not None
            return table(node.name, node.args[0])
        if node.name == "piecewise":
            time, *parts, last = node.args
            text = inner(last)
            for piece, end in zip(parts[-2::-2], parts[::-2], strict=True):
                text = f"IF({inner(end)}>{inner(time)},{inner(piece)},{text})"
            return text
        args = node.args[::-1] if node.name == "atan2" else node.args
        return f"{_CALLS.get(node.name, node.name.upper())}({','.join(map(inner, args))})"

    return inner(tree)
