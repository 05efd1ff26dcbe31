"""The table of what accuracy costs: the settings it tells, and a rule that ends the rows of each scheme."""

from itertools import groupby
from types import SimpleNamespace

import pytest

from coursework.report.sections.accuracy import _told
from tests.report.made import model_of
from tests.solved import solved


def test_a_rule_stands_below_the_last_row_of_each_scheme_but_the_last():
    (section,) = (one for one in model_of(solved("31")).sections if one.name == "accuracy")
    (table,) = (part for part in section.parts if part.kind == "table")
    sizes = [len([*rows]) for _, rows in groupby(str(row[0]).lstrip("▸ ") for row in table.rows)]
    ends = [sum(sizes[: place + 1]) - 1 for place in range(len(sizes) - 1)]
    assert table.rules == ends and len(ends) >= 3


@pytest.mark.parametrize("methods", [2, 6, 7, 12])
def test_of_each_method_the_cheapest_setting_is_told_and_of_as_many_as_fit_the_finest(methods: int) -> None:
    """Twelve lines: both of six methods, of seven all seven cheapest and five of the finest; none that failed."""
    rows = [
        SimpleNamespace(method=str(method), setting=setting, failed="x" if setting in {0, 4} else "")
        for method in range(methods)
        for setting in range(5)
    ]
    shown = [(row.method, row.setting) for row in _told(SimpleNamespace(rows=rows))]  # type: ignore[arg-type]
    finest = min(methods, 12 - methods)
    assert shown == [(str(one), setting) for one in range(methods) for setting in ((1, 3) if one < finest else (1,))]
