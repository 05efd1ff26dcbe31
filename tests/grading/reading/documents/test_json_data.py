"""Tables and named values of JSON as programs write it."""

from __future__ import annotations

import json

import pytest

from coursework.grading.reading.documents.json_data import _spread, document_of_json
from coursework.grading.reading.limits import Refused, Room

COLUMNS = [["t", "w"], ["0", "5"], ["0.1", "7"]]


def tables(text: str, rows: int = 600, columns: int = 40) -> list[list[list[str]]]:
    return [
        [[cell.text for cell in row] for row in table.rows]
        for table in document_of_json(text, "json", Room(rows, columns)).tables
    ]


@pytest.mark.parametrize(("text", "table"), [
    ('{"t": [0, 0.1], "w": [5, 7]}', COLUMNS), ('[{"t": 0, "w": 5}, {"t": 0.1, "w": 7}]', COLUMNS),
    ('[["t", "w"], [0, 5], [0.1, 7]]', COLUMNS), ('{"data": {"t": [0, 0.1], "w": [5, 7]}}', COLUMNS),
    ('{"t": [0, 0.1, 0.2], "w": [5, 7]}', [["t", "w"], ["0", "5"], ["0.1", "7"], ["0.2", ""]]),  # a column that ends early
    ('[{"t": 0}, {"t": 0.1, "w": 7}]', [["t", "w"], ["0"], ["0.1", "7"]]),
    # as pandas writes it: split, by columns, by rows
    ('{"columns": ["t", "w"], "data": [[0, 5], [0.1, 7]]}', COLUMNS),
    ('{"t": {"0": 0, "1": 0.1}, "w": {"0": 5, "1": 7}}', COLUMNS),
    ('{"0": {"t": 0, "w": 5}, "1": {"t": 0.1, "w": 7}}', COLUMNS), ('{"a": {"t": 0, "w": 5}, "b": {"t": 0.1, "w": 7}}', COLUMNS),
    ('{"header": ["t", "w"], "by": "hand", "rows": [[0, 5], [0.1, 7]]}', COLUMNS),
    ('{"t": [0, 0.1], "w": {"1": [5, 7], "2": [3, 4]}}', [["t", "w1", "w2"], ["0", "5", "3"], ["0.1", "7", "4"]]),
    ('{"t": [0, 0.1], "rates": {"w": [5, 7]}}', COLUMNS),
    # several numbers under one name
    ('{"t": [0, 0.1], "q": [[1, 2], [3, 4]]}', [["t", "q1", "q2"], ["0", "1", "3"], ["0.1", "2", "4"]]),
    ('[{"t": 0, "q": [1, 2]}]', [["t", "q1", "q2"], ["0", "1", "2"]]),
    ('[{"t": 0, "q": {"a": 1, "b": 2}}]', [["t", "a", "b"], ["0", "1", "2"]]),
    # a column in each record, as programs of graphs write them
    ('[{"name": "w", "unit": "1/s", "values": [5, 7, 9]}, {"name": "q", "values": [1, 2, 3]}]',
     [["w, 1/s", "q"], ["5", "1"], ["7", "2"], ["9", "3"]]),
    ('[{"is": "line", "of": "w", "x": [0, 1, 2], "y": [5, 7, 9]}, {"is": "line", "of": "q", "x": [0, 1, 2], "y": [1, 2, 3]}]',
     [["", "w", "q"], ["0", "5", "1"], ["1", "7", "2"], ["2", "9", "3"]]),
    ('[{"n": "w", "y": [5, 7, 9]}, {"n": "w", "y": [1, 2, 3]}]',  # one name: rows
     [["n", "y1", "y2", "y3"], ["w", "5", "7", "9"], ["w", "1", "2", "3"]]),
    ('[{"n": "w", "y": [5, 7]}, {"n": "q", "y": [1, 2]}]', [["n", "y1", "y2"], ["w", "5", "7"], ["q", "1", "2"]]),  # not longer
    ('[{"t": 0, "t": 1}]', [["t", "t"], ["0", "1"]]), ('{"t": [0, NaN], "w": [5, 7]}', [["t", "w"], ["0", "5"], ["NaN", "7"]]),
])  # fmt: skip
def test_columns_and_rows_and_records_are_one_table(text: str, table: list[list[str]]) -> None:
    assert tables(text) == [table]


def test_two_schemes_under_names_of_their_own_are_two_tables() -> None:
    assert tables('{"euler": {"t": [0, 0.1], "w": [5, 7]}, "rk4": {"t": [0, 0.1], "w": [5, 8]}}') == [
        COLUMNS, [*COLUMNS[:2], ["0.1", "8"]],
    ]  # fmt: skip


@pytest.mark.parametrize("text", [
    '{"columns": ["t"], "data": [[0, 5], 3]}', '{"t": [0, 0.1], "q": [[1, 2], [3]]}', '{"t": [0, 0.1], "q": [[1, 2]]}',
    "[[0, 5], [1, 6], [2, [3]]]", "[[0, 5]]", '{"t": [0, 1]}', '[{"t": 0}]', '{"lhs": "w1", "rhs": "2*w2"}',
])  # fmt: skip
def test_lists_of_different_kinds_or_a_single_one_are_no_table(text: str) -> None:
    assert tables(text) == []


@pytest.mark.parametrize(("text", "lines"), [
    ('{"lhs": "w1", "rhs": "2*w2"}', "w1 = 2*w2"),
    ('[{"left": "w1", "right": "2*w2"}, {"left": "w3", "right": "4"}]', "w1 = 2*w2|w3 = 4"),
    ('[{"t": 0, "w": 5}, {"eq": "w1 = 2"}]', "w1 = 2"),
    ('{"t": [0, 1], "w": [5, 7], "eq": ["w1 = 2", "w2 = 3"]}', "w1 = 2|w2 = 3"),
    ('{"t": [0, 1], "w": [5, 7], "by": "hand"}', ""), ('[1, "a", "w1 = 2"]', "a|w1 = 2"),
])  # fmt: skip
def test_equations_whole_or_in_two_sides_stand_beside_tables(text: str, lines: str) -> None:
    found = [line.text for line in document_of_json(text, "json", Room(600, 40)).lines]
    assert "|".join(line for line in found if not line.startswith(("lhs", "rhs", "left", "right"))) == lines


@pytest.mark.parametrize(("text", "name"), [
    ('{"x": {"y": {"t": [0, 1], "w": [5, 6]}}}', "x.y"), ('{"t": [0, 1], "w": [5, 6]}', "[]"),
    ('{"x": [[[0, 1], [1, 2]]]}', "x[1]"),
    ('{"' + "n" * 90 + '": {"t": [0, 1], "w": [5, 6]}}', "n" * 80),
])  # fmt: skip
def test_a_table_is_called_by_the_names_that_lead_to_it(text: str, name: str) -> None:
    (table,) = document_of_json(text, "json", Room(600, 40)).tables
    assert str(table.place) == f"entry “{name}”"


def test_no_more_rows_and_columns_than_are_read() -> None:
    assert tables('{"t": [0, 0.1, 0.2], "w": [5, 6, 7], "u": [1, 2, 3]}', 2, 2) == [[["t", "w"], ["0", "5"]]]


def test_numbers_and_texts_beside_a_name_are_lines() -> None:
    document = document_of_json('{"wAB": 0.35, "first": "w1 = V/r\\nw2 = 2*w1", "vC": "3/4"}', "json", Room(600, 40))
    assert [line.text for line in document.lines] == ["wAB = 0.35", "w1 = V/r", "w2 = 2*w1", "vC = 3/4"]
    assert not document.tables


def test_numbers_in_a_list_have_no_name_and_are_no_lines() -> None:
    assert [line.text for line in document_of_json('[0.35, "w1 = 2"]', "json", Room(600, 40)).lines] == ["w1 = 2"]


def test_a_record_in_each_line_is_a_table_if_every_line_is_whole() -> None:
    assert tables('{"t": 0, "w": 5},\n{"t": 0.1, "w": 7}\n') == [COLUMNS]
    for damaged in ('{"t": 0, "w": 5}\n{"t": 0.1, "w": ]}', '{"t": 0, "w": 5}\n{"t": 0.1,', '{"t": }'):
        with pytest.raises(Refused) as refused:
            tables(damaged)
        assert refused.value.trouble.code == "json_damaged"


@pytest.mark.parametrize(("count", "lines"), [(6_660, ["w1 = 2"]), (6_670, [])])
def test_behind_twenty_thousand_values_nothing_is_read(count: int, lines: list[str]) -> None:
    text = json.dumps({name: {"x": [*range(count)]} for name in "abc"} | {"d": "w1 = 2"})
    assert [line.text for line in document_of_json(text, "json", Room(600, 40)).lines] == lines


@pytest.mark.parametrize(("lists", "long", "columns"), [(10, 3, 10), (11, 3, 3), (11, 10, 10), (11, 11, 1)])
def test_ten_lists_are_columns_and_more_are_rows(lists: int, long: int, columns: int) -> None:
    assert len(_spread("w", [[0] * long] * lists)) == columns
