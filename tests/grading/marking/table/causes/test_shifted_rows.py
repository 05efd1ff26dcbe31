"""When rows are put back: the table must have half of its cells right then, and more than a row more than it has as it stands."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table.causes import shifted

ROWS = 20
NAMES = {0: "as_it_is", -1: "late", 1: "early"}


def made(monkeypatch: pytest.MonkeyPatch, **right: range) -> list[float] | None:
    """Return the table of one column 0, 1, 2, … put back, where these rows are right as they stand, one late, one early."""
    rights = {by: np.isin(np.arange(ROWS), list(right.get(name, ()))).astype(float) for by, name in NAMES.items()}
    return put_back(monkeypatch, rights)


def put_back(monkeypatch: pytest.MonkeyPatch, rights: dict[int, np.ndarray]) -> list[float] | None:
    """Return that table put back, where so much of each row is right one or no row further on."""
    values = np.arange(float(ROWS))[:, None]
    printed = SimpleNamespace(
        key=SimpleNamespace(table=values),
        of_task=np.full(values.shape, fill_value=False),
        student=SimpleNamespace(values=values, units=np.full((ROWS, 1), 0.1)),
    )
    monkeypatch.setattr(shifted, "_right", lambda printed, stands, by: rights[by])
    counts = {by: int(right.sum()) for by, right in rights.items() if by}
    monkeypatch.setattr(shifted, "alike_rows", lambda key, student, stands: None)
    monkeypatch.setattr(shifted, "shifts", lambda alike: counts)
    found = shifted.put_back(printed)
    return None if found is None else found.values[:, 0].tolist()


@pytest.mark.parametrize(("is_right_until", "is_put_back"), [(8, True), (18, True), (19, False), (20, False)])
def test_a_row_that_stands_twice_is_taken_away(monkeypatch, is_right_until, is_put_back):
    """Right up to there, one row late from there on: put back all but the last is right, which must be more than one gained."""
    found = made(monkeypatch, as_it_is=range(is_right_until), late=range(is_right_until, ROWS))
    assert (found is not None) is is_put_back
    if found is not None:
        assert len(found) == ROWS and np.isnan(found[-1])
        assert found[:-1] == [float(row) for row in range(ROWS) if row not in {is_right_until}]


@pytest.mark.parametrize(("is_right_until", "is_put_back"), [(5, True), (18, True), (19, False)])
def test_a_row_that_is_left_out_gets_an_empty_one(monkeypatch, is_right_until, is_put_back):
    found = made(monkeypatch, as_it_is=range(is_right_until), early=range(is_right_until, ROWS))
    assert (found is not None) is is_put_back
    if found is not None:
        assert np.isnan(found[is_right_until])
        assert [value for value in found if not np.isnan(value)] == [float(row) for row in range(ROWS - 1)]


@pytest.mark.parametrize(("right", "is_put_back"), [(range(10), False), (range(10, 20), True), (range(11, 20), False)])
def test_less_than_half_of_a_table_is_not_looked_at_closer(monkeypatch, right, is_put_back):
    """Of rows that are one late the last half is right, or a row less; before the slip they say nothing."""
    assert (made(monkeypatch, late=right) is not None) is is_put_back


def test_of_two_rows_the_one_goes_that_is_less_right_where_it_stands(monkeypatch):
    """Row 8 is half right as it stands and the next one wholly, one late: what was written twice is row 8."""
    rights = {0: [1.0] * 7 + [0.5] + [0.0] * 12, -1: [0.0] * 7 + [0.2] + [1.0] * 12, 1: [0.0] * ROWS}
    found = put_back(monkeypatch, {by: np.array(right) for by, right in rights.items()})
    assert found is not None and found[:-1] == [float(row) for row in range(ROWS) if row != 7]


def test_several_rows_that_are_left_out_get_empty_ones(monkeypatch):
    """A table that begins at row 4, one without rows 6 to 10, and one that has three rows more from row 7 on."""
    none, nan = np.zeros(ROWS), float("nan")
    numbers = [float(row) for row in range(ROWS)]
    assert repr(put_back(monkeypatch, {0: none, -1: none, 1: none, 3: none + 1})) == repr([nan] * 3 + numbers[:17])
    first = (np.arange(ROWS) < 5).astype(float)
    assert repr(put_back(monkeypatch, {0: first, -1: none, 1: none, 5: 1 - first})) == repr(
        numbers[:5] + [nan] * 5 + numbers[5:15]
    )
    first = (np.arange(ROWS) < 6).astype(float)
    found = put_back(monkeypatch, {0: first, -1: none, 1: none, -3: (np.arange(ROWS) > 8).astype(float)})
    assert repr(found) == repr(numbers[:6] + numbers[9:] + [nan] * 3)
