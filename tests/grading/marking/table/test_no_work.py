"""Tables without work earn next to nothing, whatever of them follows from each other; slips cost what they cost."""

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.marking.blank import empty_table
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.grading.marking.table.points import following, stands_still, table_points
from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.table.desks import Desk
from tests.mechanisms.library import mechanism
from tests.sample import first

MOST = 5 / 60
COUNTS = ("rows", "rows_needed", "wrong_cells", "missing_cells", "carried_cells")
NAMES = ("31", "v102", "v108", "example-1", "watt", "jansen")


@cache
def marker(name):
    return Marker(key_of(coursework.load(name)), Rubric())


def cells_of(name, table, decimals=4):
    key = marker(name).key
    return mark_cells(key, StudentTable(np.round(table, decimals), np.full(table.shape, 10.0**-decimals)))


def share(name, table):
    return table_points(marker(name).key, cells_of(name, table)).share


def without_work(key, chance):
    """Give tables that nobody computed: copied, still, shuffled, invented, another's."""
    table, m = key.table, len(key.coordinates)
    copied = np.tile(table[0], (len(table), 1))
    yield "row 1 copied", copied
    still = copied.copy()
    still[:, m:] = 0.0
    yield "row 1 without velocities", still
    yield "zeros", np.zeros_like(table)
    yield "constants", np.tile(chance.uniform(-3, 3, table.shape[1]), (len(table), 1))
    yield "shuffled", table[chance.permutation(len(table))]
    kept = table.copy()
    kept[1:] = kept[1:][chance.permutation(len(table) - 1)]
    yield "shuffled but for row 1", kept
    columns = table.copy()
    for place in range(table.shape[1]):
        columns[:, place] = columns[chance.permutation(len(table)), place]
    yield "columns shuffled", columns
    noise = chance.uniform(table.min(axis=0), table.max(axis=0), table.shape)
    yield "noise", noise
    noise = noise.copy()
    noise[0] = table[0]
    yield "noise below a right row 1", noise
    followed = copied.copy()
    followed[:, m:] = key.velocities_at(key.t, followed[:, :m])
    yield "right velocities of angles that stand still", followed
    creeping = still.copy()
    creeping[:, :m] += 1e-4 * np.arange(len(table))[:, None]
    creeping[:, m : 2 * m] = 1e-4 / key.step
    yield "a creep with its own velocity", creeping


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("seed", first(1, (7, 8, 9)))
def test_tables_without_work_earn_at_most_five_of_sixty(name, seed):
    key, chance = marker(name).key, np.random.default_rng(seed)
    tried = 0
    for _ in range(2):
        for label, table in without_work(key, chance):
            assert share(name, table) <= MOST, label
            tried += 1
    assert tried >= 65 / 3


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES)
def test_right_tables_and_one_slip_are_worth_what_they_were(name):
    key, m = marker(name).key, len(marker(name).key.coordinates)
    assert share(name, key.table) == 1.0
    chance = np.random.default_rng(3)
    for _ in range(10):
        row, place = int(chance.integers(2, len(key.table) - 1)), int(chance.integers(key.table.shape[1]))
        table = key.table.copy()
        table[row, place] += 10 * key.gap / (1.0 if place < m else key.step)
        assert share(name, table) >= 0.94, (row, place)


@pytest.mark.long
def test_no_single_row_decides_whether_a_table_is_work():
    """Rows leave the motion one by one, each with the right velocities of its own angles; all points went at one of them."""
    key, chance = marker("31").key, np.random.default_rng(5)
    table, m, before = key.table.copy(), len(key.coordinates), 1.0
    for row in chance.permutation(np.arange(1, len(table))):
        table[row, :m] += chance.normal(size=m) * 0.05
        table[row, m:] = key.velocities_at(key.t[[row]], table[[row], :m])[0]
        after = share("31", table)
        assert before - after <= 15 / 60, row
        before = after
    assert before <= MOST


def test_the_floor_of_own_equations_is_not_paid_to_a_table_that_stands_still():
    key = marker("31").key
    still = np.tile(key.table[0], (len(key.table), 1))
    assert stands_still(key, cells_of("31", still))
    moving = still.copy()
    moving[5, 0] += 1e-3
    assert not stands_still(key, cells_of("31", moving))


def test_a_table_of_the_key_s_own_digits_is_noted_as_a_copy_and_one_of_a_program_is_not():
    from coursework.grading.marking.student_table import is_the_key

    key = marker("31").key
    copied = StudentTable(np.round(key.table, 14), np.full(key.table.shape, 1e-14))
    assert is_the_key(key, copied)
    own = key.table.copy()
    own[3, 2] += 5e-13
    assert not is_the_key(key, StudentTable(own, np.full(own.shape, 1e-14)))
    assert not is_the_key(key, StudentTable(np.round(key.table, 4), np.full(key.table.shape, 1e-4)))


@pytest.mark.long
@pytest.mark.parametrize("name", ["31", "v102"])
def test_the_table_of_other_data_earns_at_most_five_of_sixty(name):
    variant, chance = coursework.load(name), np.random.default_rng(2)
    lengths = [given for given in variant.given if given.si == "m"]
    for _ in range(12):
        given = {one.name: one.value * (1 + chance.uniform(-0.1, 0.1)) for one in lengths}
        table = key_of(variant.with_data(given=given)).table
        if table.shape == marker(name).key.table.shape:
            assert share(name, table) <= MOST


# A table of zeros fulfils every rule of a step, and where the velocities have no value there it says nothing else.
DRAWN_BAR = mechanism("drawn-bar").encode()


def test_nothing_is_named_of_a_table_that_stands_still():
    desk = Desk(parse_variant(DRAWN_BAR, "own.toml", {}))
    right = desk.machine.table()
    for table in (np.zeros_like(right), np.tile(right[:1], (len(right), 1))):
        assert desk.marked(table)[1].misconception is None


@pytest.mark.parametrize(("broken", "apart"), [([0], []), ([8], []), ([4], []), ([0, 1], [1]), ([4, 5], [5]), ([7, 8], [8, 9])])
def test_one_broken_step_is_no_other_motion_and_two_are(broken: list[int], apart: list[int]) -> None:
    """Of ten rows of one coordinate, at both ends too; row 1 always belongs, what lies between two broken steps does not."""
    near = np.ones((9, 1), dtype=bool)
    near[broken] = False
    follows, motion = following(np.arange(10.0)[:, None], near, np.ones(9, dtype=bool))
    assert np.flatnonzero(~follows).tolist() == apart and motion == 1.0


def test_of_a_table_that_is_not_there_nothing_is_counted():
    empty = empty_table(60.0)
    assert (empty["state"], empty["score"], empty["max"]) == ("missing", None, 60.0)
    assert {empty[name] for name in COUNTS} == {0}
