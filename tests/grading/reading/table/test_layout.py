"""Which rows of a sheet are heads, which are the table, and where another table begins: as a person sees it."""

from __future__ import annotations

import pytest

from coursework.grading.reading.numbers import PrintedNumber, no_number, printed
from coursework.grading.reading.table.layout import Layout, layouts_of

COLUMNS = [("phi1", "rad"), ("phi2", "rad"), ("w1", "1/s"), ("w2", "1/s")]
ROWS = "0 1.5 2.5|0.1 1.7 2.4|0.2 1.8 2.9"


def cell_of(text: str) -> PrintedNumber:
    """Return a cell: a dash is an empty one, what begins with = a formula without a value."""
    return no_number(text, "formula") if text.startswith("=") else printed("" if text == "-" else text, ".")


def seen(layout: Layout) -> str:
    """Return a table as a text: heads with units, "(…)" what stands above if there are none, then the rows."""
    named = (head.candidates[0] if len(head.candidates) == 1 else head.text or "-" for head in layout.heads)
    heads = " ".join(name + f",{head.unit}" * bool(head.unit) for name, head in zip(named, layout.heads, strict=True))
    first = ("lying " if layout.transposed else "") + (heads if layout.has_heads else f"({' '.join(layout.above)})")
    return "|".join([first, *(" ".join(cell.text or "-" for cell in row) for row in layout.body)])


@pytest.mark.parametrize(("rows", "tables"), [
    (f"t phi1 w1|{ROWS}", [f"t phi1 w1|{ROWS}"]), (f"t phi1 w1|s deg rpm|{ROWS}", [f"t,s phi1,deg w1,rpm|{ROWS}"]),
    (f"t,s phi1 w1|ms deg x|{ROWS}", [f"t,s phi1,deg w1|{ROWS}"]),  # a head's own unit counts
    (f"{ROWS}|s deg rpm", [f"(  )|{ROWS}"]), (f"x y z|{ROWS}|a b c", [f"(x y z)|{ROWS}"]),
    ("2 3|phi1 w1|a b|c d|e f|phi2 w1 w2|0 1.5 2.5|0.1 1.7 2.4", ["( )|2 3", "phi2 w1 w2|0 1.5 2.5|0.1 1.7 2.4"]),
    (f"t phi1 w1|{ROWS}|#REF! #REF! #REF!|=A4 =B4 =C4", [f"t phi1 w1|{ROWS}|=A4 =B4 =C4"]),
    (f"t phi1 w1|{ROWS}|0.3 ? ?|0.4 1 ? ? ?|0.5 1 ?", [f"t phi1 w1|{ROWS}|0.5 1 ?"]),  # half of the cells are numbers
    ("t phi1|7|8", []), ("t|0|1", []), ("phi1 x|w1 y", []), ("t w1|0 5 ? ?|1 6 -", ["t w1 - -|0 5 ? ?|1 6 - -"]),
    ("t w1|s rpm|0 5|1 6", ["t,s w1,rpm|0 5|1 6"]), ("t w1 w2|a rpm b|0 5 6", ["t w1 w2|0 5 6"]),
    (f"t phi1 w1 x|{ROWS}|0.3 2 3 w1|0.4 3 5 phi1", [f"t phi1 w1 x|{ROWS.replace('|', ' -|')} -|0.3 2 3 w1|0.4 3 5 phi1"]),
    (f"phi1 1.5|w1 2|phi2 7|w2 8|t phi1 w1|{ROWS}", [f"t phi1 w1|{ROWS}"]),  # data above a table
    # another table, or the next page
    ("t phi1|0 1|1 2|t w1|0 5|1 6", ["t phi1|0 1|1 2", "t w1|0 5|1 6"]), ("t phi1|0 1|so far|1 2", ["t phi1|0 1|1 2"]),
    ("t phi1|0 1|1 2|a|b|c|t w1|0 5|1 6", ["t phi1|0 1|1 2", "t w1|0 5|1 6"]),
    (f"t phi1 w1|{ROWS}|t x y|0 1 2", [f"t phi1 w1|{ROWS}", "(t x y)|0 1 2"]),  # of something else
    (f"t phi1 w1|{ROWS}|t x|0 1 2", [f"t phi1 w1|{ROWS}|0 1 2"]), (f"t phi1 w1|{ROWS}|x y z|0 1 2", [f"t phi1 w1|{ROWS}|0 1 2"]),
    # side by side, where the second goes on
    ("t w1 t w1|0 1 0.2 3|0.1 2 0.3 4", ["t w1|0 1|0.1 2", "t w1|0.2 3|0.3 4"]),
    ("t w1 - t w1|0 1 - 0.2 3|0.1 2 - 0.3 4", ["t w1|0 1|0.1 2", "t w1|0.2 3|0.3 4"]),
    ("t w1 t w1|0 1 0.2 3|0.1 2 - -", ["t w1|0 1|0.1 2", "t w1|0.2 3"]),
    ("t w1 t w1|0 1 0 3|0.1 2 0.1 4", ["t w1 t w1|0 1 0 3|0.1 2 0.1 4"]),
    ("t w1 t w2|0 1 2 3|1 2 3 4", ["t w1 t w2|0 1 2 3|1 2 3 4"]),
    ("t w1 t w1|0 1 0.3 3|0.2 2 0.4 4|0.1 5 0.5 6", ["t w1 t w1|0 1 0.3 3|0.2 2 0.4 4|0.1 5 0.5 6"]),
    ("phi1 w1 phi1 w1|0 1 2 3|1 2 3 4", ["phi1 w1 phi1 w1|0 1 2 3|1 2 3 4"]),
    # lying
    ("t 0 0.1 0.2|phi1 1.5 1.7 1.8|w1 2 3 4", ["lying t phi1 w1|0 1.5 2|0.1 1.7 3|0.2 1.8 4"]),
    ("0 1 2|3 7 1|5 5 1|2 1 9", ["lying (   )|0 3 5 2|1 7 5 1|2 1 1 9"]), ("0 1 2|3 7 1|5 5 1", ["(  )|0 1 2|3 7 1|5 5 1"]),
    # numbers of rows without a head
    ("t w1|1 0 5|2 0.1 6|3 0.2 7", ["- t w1|1 0 5|2 0.1 6|3 0.2 7"]), ("t w1|1 0 5|2 0.1 6", ["t w1 -|1 0 5|2 0.1 6"]),
    ("t w1|7 0 5|2 0.1 6|3 0.2 7", ["t w1 -|7 0 5|2 0.1 6|3 0.2 7"]),
    ("t w1|1 0 5|2 7 6|3 0.2 7", ["t w1 -|1 0 5|2 7 6|3 0.2 7"]),
    ("t w1|0 5 ok|1 4 ok|2 8 ok", ["t w1 -|0 5 ok|1 4 ok|2 8 ok"]),
    ("phi1 w1|0 5 5|1 4 6|2 8 7", ["- phi1 w1|0 5 5|1 4 6|2 8 7"]), ("w1 w2|№|1 0 5|2 1 6|3 2 7", ["№ w1 w2|1 0 5|2 1 6|3 2 7"]),
    # numbers of columns below heads that span them
    ("t phi - w -|- 1 2 1 2|0 1.5 2.5 1 2", ["t phi1 phi2 w1 w2|0 1.5 2.5 1 2"]),
    ("x y|t phi - w|- 1 2 1|0 1.5 2.5 1", ["t phi1 phi2 w1|0 1.5 2.5 1"]),
    ("t phi,deg - w|- 1 2 1|0 1.5 2.5 1", ["t phi1,deg phi2,deg w1|0 1.5 2.5 1"]),
    ("t phi - w|- 0 2 1|0 1.5 2.5 1", ["(t phi  w)|- 0 2 1|0 1.5 2.5 1"]),
    ("- phi - -|- 1 3 4|0 1.5 2.5 1", ["( phi  )|- 1 3 4|0 1.5 2.5 1"]),  # these are no numbers of columns
])  # fmt: skip
def test_the_tables_of_a_sheet(rows: str, tables: list[str]) -> None:
    assert [seen(one) for one in layouts_of([[*map(cell_of, row.split())] for row in rows.split("|")], ".", COLUMNS)] == tables
