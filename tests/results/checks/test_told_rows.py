"""A check that names a row names the one it found, with the time and the numbers that this row has in the table."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from coursework.variant.catalogue import names
from coursework.words.sentences import Sentence
from tests.sample import sampled
from tests.solved import solved


def sentences(told: Any) -> Iterator[Sentence]:
    if isinstance(told, Sentence):
        yield told
    inside = told.values.values() if isinstance(told, Sentence) else told if isinstance(told, (tuple, list)) else ()
    for one in inside:
        yield from sentences(one)


@pytest.mark.parametrize("name", sampled(names()))
def test_rows_times_and_numbers_of_sentences_are_those_of_the_table(name: str) -> None:
    run = solved(name)
    t, found = run.motion.t, 0
    for check in run.checks:
        for told in sentences(check.sentence):
            row, time, first, last = (told.values.get(key) for key in ("row", "time", "first", "last"))
            if told.key.startswith("check.") and (end := told.key.rpartition(".")[2].upper()) in {"PASS", "COARSE", "FAIL"}:
                assert check.verdict == end, told.key
            if isinstance(row, int) and check.row is not None:
                found += 1
                assert row == check.row, told.key
                assert time is None or time == pytest.approx(t[row - 1]), told.key
            if told.key.startswith("check.PERIOD") and isinstance(last, float):
                column = run.motion.column(check.column)
                assert (first, last) == pytest.approx((column[0], column[check.row - 1])), told.key
    assert found or len(t) < 2 or not any(check.row for check in run.checks)
