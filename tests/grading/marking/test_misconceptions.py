"""Misconceptions named with ground only, from tables that students' own formulas made."""

import numpy as np
import pytest

import coursework
from coursework.grading.marking.cells import mark_cells
from coursework.grading.marking.misconceptions import find_misconception, looked_for
from coursework.grading.marking.reference import key_of
from tests.grading.marking import students
from tests.grading.marking.test_cells import printed


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


@pytest.mark.parametrize("decimals", [3, 4, 6])
@pytest.mark.parametrize("code", students.MISCONCEPTIONS)
def test_each_is_named_or_tied(key, code, decimals):
    cells = mark_cells(key, printed(students.MISCONCEPTIONS[code](), decimals))
    assert looked_for(cells, 172)
    found = find_misconception(key, cells)
    assert found is not None
    assert code in (found.code, *found.ties)
    assert found.share >= 0.93
    assert found.share > found.euler_share + 0.02


def test_a_declared_confusion_is_named(key):
    table = students.table(printed=lambda t, q: students.velocities(t, q, alpha=0.02))
    cells = mark_cells(key, printed(np.where(np.abs(table) < 1e3, table, np.nan), 4))
    found = find_misconception(key, cells, {"alpha": 0.02})
    assert found is not None
    assert found.code == "confusion_alpha"


def test_nothing_is_named_without_ground(key):
    rng = np.random.default_rng(7)
    for _ in range(20):
        table = students.table()
        rows, columns = rng.integers(1, 25, 12), rng.integers(0, 7, 12)
        table[rows, columns] *= rng.uniform(0.5, 0.9, 12)
        cells = mark_cells(key, printed(table, 4))
        assert looked_for(cells, 172)
        assert find_misconception(key, cells) is None


def test_a_few_slips_are_no_misconception(key):
    cells = mark_cells(key, printed(students.slip(10, 1, 1.05), 4))
    assert not looked_for(cells, 172)


def test_another_variant_of_the_class(key):
    other = students.table(printed=lambda t, q: students.velocities(t, q, V1=4.1), start=(1.6, 3.37, 2.8))
    cells = mark_cells(key, printed(other, 4))
    found = find_misconception(key, cells, {}, {"12": other})
    assert found is not None
    assert "variant_12" in (found.code, *found.ties)
