"""Tabulated laws in a workbook: their nodes and coefficients in columns, their values by INDEX and MATCH.

Enters: the tabulated laws of a run.  Leaves: columns beside the data, and formulas that read them.  Used inside `workbook/`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from coursework.equations.codegen.tabulated import TableLaw
from coursework.takeaway.workbook.names import letters

_CALLED = re.compile(r"_table_(.+)_(\d)")
SHEET = "Data"
FIRST = 2  # the number of the first row of coefficients


class Tables:
    """The laws on sheet Data from `column` on; each has columns of nodes, of coefficients of its value and of its slope."""

    def __init__(self, laws: Mapping[str, TableLaw], column: int) -> None:
        self.laws = laws
        self.starts: dict[str, int] = {}
        for name, law in laws.items():
            self.starts[name] = column
            column += 1 + sum(law.pieces[order].shape[1] for order in (0, 1)) + 1
        self.end = column

    def columns(self) -> Iterator[tuple[int, str, list[float]]]:
        """Yield number, head and values of every column."""
        for name, law in self.laws.items():
            column = self.starts[name]
            yield column, law.name, law.nodes[:-1].tolist()
            for order, head in ((0, name), (1, f"{name}′")):
                for power, values in enumerate(law.pieces[order].T):
                    column += 1
                    yield column, f"{head}·u^{power}", values.tolist()

    def value(self, called: str, argument: str) -> str:
        """Return the formula of a law, or of its slope, for an argument: a polynomial in u = 0 … 1 within an interval."""
        found = _CALLED.fullmatch(called)
        assert found is not None
        name, order = found[1], int(found[2])
        law, start = self.laws[name], self.starts[name]
        last = FIRST + law.intervals - 1

        def ranged(column: int) -> str:
            return f"{SHEET}!${letters(column)}${FIRST}:${letters(column)}${last}"

        row = f"MATCH(MAX({argument},{law.first!r}),{ranged(start)},1)"
        u = f"(({argument})-INDEX({ranged(start)},{row}))/{law.step!r}"
        first = start + 1 + (law.pieces[0].shape[1] if order else 0)
        text = ""
        for column in reversed(range(first, first + law.pieces[order].shape[1])):
            coefficient = f"INDEX({ranged(column)},{row})"
            text = f"{coefficient}+{u}*({text})" if text else coefficient
        return f"({text})"
