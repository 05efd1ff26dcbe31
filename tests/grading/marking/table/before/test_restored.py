"""The search itself: of all tables that take each row from one of a pool, the one with the fewest slips is found."""

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.grading.marking.table.before import restored as search
from coursework.grading.marking.table.before.restored import _Search
from coursework.grading.marking.table.ways import StudentTable
from tests.grading.marking.table.before.test_guesses import SIMPLE, STRAIGHT, flags, ways_of
from tests.grading.marking.table.desks import Desk
from tests.sample import first

UNIT = 1e-4


def counted(values, printed, wrong, sure):
    """The cells that a table leaves wrong, those that it breaks, and its own slips, counted on the whole table."""
    ways = ways_of(SIMPLE, values)
    held, slips = ways.holds(printed), (values != printed) & ~ways.holds(values)
    return int(((wrong | sure) & ~held).sum() + slips.sum())


@pytest.mark.parametrize("seed", first(1, range(3)))
def test_the_cheapest_of_all_tables_joined_from_a_pool_is_found(monkeypatch, seed):
    """Two rows may gain only together, and what is best in one row may not be so beside the best of the next: all are tried."""
    chance = np.random.default_rng(seed)
    monkeypatch.setattr(search, "own_ways", lambda key, table, coarse: ways_of(key, table.values))
    printed = STRAIGHT.copy()
    printed[tuple(chance.integers((5, 3), size=(6, 2)).T)] += 0.3
    units = np.full(printed.shape, UNIT)
    tables = [printed, 1.1 * STRAIGHT, np.where(chance.random(printed.shape) < 0.5, printed, STRAIGHT)]
    own = ways_of(SIMPLE, printed)
    wrong, sure = ~own.holds(printed), own.holds(printed) & (chance.random(printed.shape) < 0.5)
    student = StudentTable(printed, units)
    looked = _Search(SIMPLE, student, wrong, wrong, sure, own)
    pool = [looked.was(student), *(looked.was(StudentTable(one, units)) for one in tables[1:])]
    found, cost = looked.cheapest(pool)
    joined = [np.array([tables[one][row] for row, one in enumerate(chosen)]) for chosen in product(range(3), repeat=5)]
    least = min(counted(one, printed, wrong, sure) for one in joined)
    assert cost == 4 * least == 4 * counted(found.table.values, printed, wrong, sure)


def test_of_equally_many_cells_the_print_stays_but_in_the_end_a_velocity_is_explained_first(monkeypatch):
    """One velocity that another coordinate explains, at the cost of that slip: nothing is gained but what the gates look at."""
    monkeypatch.setattr(search, "own_ways", lambda key, table, coarse: ways_of(key, table.values))
    printed, other = STRAIGHT.copy(), STRAIGHT.copy()
    printed[4, 2], other[4, 1] = 9.0, 4.5
    own = ways_of(SIMPLE, printed)
    student, was = (StudentTable(one, np.full(one.shape, UNIT)) for one in (printed, other))
    looked = _Search(SIMPLE, student, flags((4, 2)), flags((4, 1)), flags(), own)
    pool = [looked.was(student), looked.was(was)]
    assert looked.cheapest(pool)[0].table is student
    assert looked.cheapest(pool, velocities_first=True)[0].table.values[4, 1] == 4.5


def test_a_table_with_the_same_numbers_is_looked_at_once(monkeypatch):
    """Equal digits and equal last places: the same record; other last places: another one."""
    monkeypatch.setattr(search, "own_ways", lambda key, table, coarse: ways_of(key, table.values))
    units = np.full(STRAIGHT.shape, UNIT)
    student, same, coarser = (
        StudentTable(STRAIGHT, units),
        StudentTable(STRAIGHT.copy(), units),
        StudentTable(STRAIGHT, 10 * units),
    )
    looked = _Search(SIMPLE, student, flags(), flags(), flags(), ways_of(SIMPLE, STRAIGHT))
    assert looked.was(same) is looked.was(student) is not looked.was(coarser)
    assert not looked.was(coarser).other.any() and not looked.was(coarser).slips.any()


def test_guesses_are_weighed_only_where_they_differ():
    """Most guesses change a row or two of a table; the digits of the row below count, as steps are judged by them."""
    units = np.full(STRAIGHT.shape, UNIT)
    finer = units.copy()
    finer[3] /= 10
    student, own = StudentTable(STRAIGHT, units), ways_of(SIMPLE, STRAIGHT)
    none = np.zeros(STRAIGHT.shape, dtype=bool)
    guesses = [STRAIGHT + 0.1 * (np.arange(5) == row)[:, None] for row in (1, 1, 4)]
    pool = [SimpleNamespace(table=StudentTable(one, units)) for one in (STRAIGHT, *guesses)]
    pool.append(SimpleNamespace(table=StudentTable(STRAIGHT, finer)))
    differing = _Search(SIMPLE, student, none, none, none, own)._differing(pool)
    assert [one.tolist() for one in differing] == [[0], [0, 1], [0, 4], [0, 4], [0, 3]]


@pytest.mark.parametrize("name", ["31", "v110"])
def test_row_one_of_a_table_from_two_other_starts_may_be_put_right_cell_by_cell(name):
    """With its own velocity gone the starts no longer followed from row 2, and a cell more was wrong: 0.35 points."""
    desk = Desk(coursework.load(name))
    m, right = desk.machine.m, desk.machine.table()
    table = desk.machine.table(start=desk.machine.start + np.array([0.1, *[0.0] * (m - 2), -0.1]))
    points = []
    for place in [0, m - 1, *range(m, right.shape[1])]:
        table[0, place] = right[0, place]
        points.append(desk.marked(table)[0])
    assert points[1:] == sorted(points[1:])
