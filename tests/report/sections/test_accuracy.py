"""The table of what accuracy costs: a rule ends the rows of each scheme."""

from itertools import groupby

from tests.report.made import model_of
from tests.solved import solved


def test_a_rule_stands_below_the_last_row_of_each_scheme_but_the_last():
    (section,) = (one for one in model_of(solved("31")).sections if one.name == "accuracy")
    (table,) = (part for part in section.parts if part.kind == "table")
    sizes = [len([*rows]) for _, rows in groupby(str(row[0]).lstrip("▸ ") for row in table.rows)]
    ends = [sum(sizes[: place + 1]) - 1 for place in range(len(sizes) - 1)]
    assert table.rules == ends and len(ends) >= 3
