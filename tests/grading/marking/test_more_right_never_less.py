"""A cell put right, or an equation, never lowers the sum; no right cell is passed over in silence."""

import math
from itertools import combinations

import numpy as np
import pytest

from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.causes.misconceptions import Found, looked_for
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.grading.marking.table.earning import best_rule
from coursework.grading.marking.table.points import ENOUGH_ROWS, FOLLOWING, table_points
from coursework.grading.marking.table.ways import KEY, own_ways
from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import Formula, spelled
from tests.grading.marking import students
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import sign_faults, variants
from tests.grading.marking.told import found_in
from tests.sample import first

PAIRS, MANY = 8, 1000
# Tables of motions that ran into a singular place, where no digits tell anything, are left out.
BLOWN_UP = 300


def earned(desk, table, equations=None):
    cells = mark_cells(desk.key, StudentTable(np.round(table, 4), np.full(table.shape, 1e-4)))
    points = table_points(desk.key, cells)
    found = found_in(desk.key, cells, equations=equations) if looked_for(desk.key, cells, points.cells) else Found()
    return best_rule(desk.key, Rubric(), cells, table_points(desk.key, cells, untold=found.untold), found, {}), cells


def made(desk):
    """Tables as students make them: right, from another start, in degrees, with a slip, with a wrong sign."""
    machine, m, h = desk.machine, desk.machine.m, desk.machine.h
    start = machine.start.copy()
    start[-1] += 0.1
    wrong = next(iter(sign_faults(desk.variant.constraints[0])))
    return [
        machine.table(), machine.table(start=start), Machine(desk.variant, degrees=("drive",)).table(),
        machine.table(slip=(6, m, 0.3)), machine.table(slip=(9, 1, 0.2)), Machine(desk.variant, drive_sign=-1.0).table(),
        machine.table(lambda t, q: h / 2 * machine.velocities(t, q)[:m]),
        Machine(desk.variant, lines={desk.variant.constraints[0].name: wrong}).table(),
    ]  # fmt: skip


def spoiled(chance, desk, table):
    """A table with wrong cells in it: few or many, or in so many rows as the gates ask for, give or take one."""
    worse, m = table.copy(), desk.machine.m
    if chance.random() < 2 / 3:
        count = chance.choice([1, 2, 5, 15, 40])
        cells = zip(chance.integers(len(worse), size=count), chance.integers(worse.shape[1], size=count), strict=True)
    else:
        share, first = ((1 - ENOUGH_ROWS, m), (1 - FOLLOWING, 0))[chance.integers(2)]
        rows = chance.choice(len(worse), size=round(share * len(worse)) + chance.integers(-1, 2), replace=False)
        cells = [(row, chance.integers(first, worse.shape[1])) for row in rows]
    for row, place in cells:
        worse[row, place] += chance.choice([-1, 1]) * 10 ** chance.uniform(-2, 1)
    return worse


def pairs(seed, count):
    """Give tables, and the same with one wrong cell put right: the key's number, or what the table had before it was spoiled."""
    chance, given = np.random.default_rng(seed), 0
    desks = [(desk, [table for table in made(desk) if np.abs(table).max() < BLOWN_UP]) for desk in variants()]
    while given < count:
        desk, tables = desks[chance.integers(len(desks))]
        table = tables[chance.integers(len(tables))]
        worse, right = spoiled(chance, desk, table), (desk.key.table, table)[chance.integers(2)]
        before, cells = earned(desk, worse)
        places = np.argwhere(cells.wrong & (np.round(worse, 4) != np.round(right, 4)))
        if len(places):
            row, place = places[chance.integers(len(places))]
            better = worse.copy()
            better[row, place] = right[row, place]
            given += 1
            yield desk, worse, better, before, (row, place)


@pytest.mark.parametrize("seed", first(1, range(11, 22)))
def test_a_cell_put_right_never_lowers_the_points(seed):
    for desk, _, better, before, place in pairs(seed, PAIRS if seed == 11 else MANY):
        after, _ = earned(desk, better)
        assert after.share >= before.share - 1e-9, (desk.variant.title, place, before, after)


# Pairs that lost once: a variant, one of its tables, what is added to its cells, the one put right, whether to the key's number.
LOST = [
    (1, 1, {(0, 0): 10.595, (1, 0): -0.242}, (0, 4), True), (0, 3, {}, (22, 1), True),
    (1, 4, {(2, 2): -0.014, (14, 1): -1.804, (22, 3): 0.044}, (21, 0), True),
    (4, 3, {(1, 1): 0.997, (4, 1): -1.937, (6, 1): -0.015, (8, 1): -0.817}, (4, 1), True),
    (4, 7, {(1, 1): 0.947, (19, 3): -0.018}, (1, 1), True),
    (0, 1, {(0, 2): 0.072, (1, 2): 7.512, (2, 2): 0.117, (24, 5): -0.064, (24, 6): 0.042}, (2, 2), True),
    (1, 3, {(7, 0): 0.034, (21, 6): -0.432}, (7, 0), False),
    (1, 4, {(10, 0): 0.125, (10, 1): 0.622, (10, 2): 0.779, (10, 3): -0.035, (10, 4): 0.9, (10, 5): -2.086, (10, 6): -0.225},
     (9, 1), True),
    (3, 6, {(0, 1): 0.017, (2, 1): -9.395, (2, 4): 0.013, (5, 1): 7.872, (5, 4): -0.021, (7, 3): 8.848, (8, 0): -0.851,
            (10, 1): 2.468, (12, 3): 3.381, (12, 6): 0.536, (13, 0): -0.061, (14, 6): 0.664, (16, 1): 0.107, (17, 1): 0.181,
            (24, 0): -0.272}, (2, 1), False),
    (3, 7, {(2, 3): -0.115, (3, 6): -0.849, (14, 0): 0.066, (15, 2): -5.982, (22, 4): 7.333}, (14, 0), False),
]  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize(("number", "which", "added", "cell", "to_key"), LOST)
def test_what_lost_once_loses_no_more(number, which, added, cell, to_key):
    desk = variants()[number]
    table = made(desk)[which]
    worse = table.copy()
    for place, off in added.items():
        worse[place] += off
    better = worse.copy()
    better[cell] = (desk.key.table if to_key else table)[cell]
    before, cells = earned(desk, worse)
    assert cells.marks[cell] != KEY
    assert earned(desk, better)[0].share >= before.share - 1e-9


def test_cells_put_right_in_the_table_of_a_wrong_equation_take_nothing_of_what_it_is_worth():
    """So many may be right that Euler's rules explain as many cells as the equation does, looked at from afar."""
    desk = variants()[0]
    table = made(desk)[-1].copy()
    put = {0: (3, 6), 2: (5,), 3: (1,), 4: (3,), 5: (2,), 6: (2, 3, 4, 5), 7: (3,), 11: (3,), 13: (4,), 15: (6,), 17: (6,),
           19: (6,), 20: (2, 3), 21: (2,), 22: (1, 2, 4), 23: (2,), 24: (2,)}  # fmt: skip
    for place in ((row, column) for row, columns in put.items() for column in columns):
        table[place] = desk.key.table[place]
    before = earned(desk, table)[0].share
    table[14, 1] = desk.key.table[14, 1]
    assert earned(desk, table)[0].share >= before >= 0.5


@pytest.mark.parametrize(
    ("number", "row", "place"),
    [(5, 9, 1), *(pytest.param(n, *cell, marks=pytest.mark.long) for n in range(6) for cell in ((9, 0), (9, 1), (12, -1)))],
)
def test_velocities_put_right_beside_a_slip_that_was_put_right_take_nothing(number, row, place):
    """Two of a row's velocities still follow from the slip, the others were mistyped and are put right one by one."""
    desk = variants()[number]
    place %= desk.machine.m
    made_from_it = desk.machine.table(slip=(row, place, 0.2))
    made_from_it[row, place] = desk.key.table[row, place]
    other = np.abs(made_from_it[row] - desk.key.table[row]) > 1e-3
    follow = np.flatnonzero(other[desk.machine.m :]) + desk.machine.m
    for left in combinations(follow, 2):
        table, mistyped = made_from_it.copy(), [column for column in follow if column not in left]
        table[row, mistyped] += 0.37 * np.arange(1, len(mistyped) + 1)
        before, cells = earned(desk, table)
        for column in mistyped:
            table[row, column] = desk.key.table[row, column]
            after, marked = earned(desk, table)
            assert after.share >= before.share - 1e-9 or not cells.wrong[row, column], (left, column)
            before, cells = after, marked


def test_a_start_put_right_in_print_only_is_still_another_start():
    """A table made from another start is worth the same whether row 1 prints that start or the task's."""
    for desk in variants():
        start = desk.machine.start.copy()
        start[-1] += 0.1
        table = desk.machine.table(start=start)
        printed = table.copy()
        printed[0, desk.machine.m - 1] = desk.machine.start[-1]
        other, same = earned(desk, table)[0], earned(desk, printed)[0]
        assert same.share >= other.share
        assert (same.rule, same.cause) in {(other.rule, other.cause), ("cells", "")}


@pytest.mark.parametrize("number", [0, 2, 4])
def test_the_column_of_another_start_copied_from_the_key_is_still_another_start(number):
    """Nothing printed tells the start any more but the velocities of row 1: 42 points were lost by a column put right."""
    desk = variants()[number]
    place = desk.machine.m - 1
    start = desk.machine.start.copy()
    start[place] += 0.1
    table = desk.machine.table(start=start)
    before = earned(desk, table)[0]
    table[:, place] = desk.key.table[:, place]
    after = earned(desk, table)[0]
    assert (before.rule, after.rule, after.cause) == ("start", "start", before.cause)
    assert after.share >= before.share


@pytest.mark.long
def test_a_start_put_right_where_the_next_row_is_spoiled_is_still_another_start():
    for desk in variants():
        start, place = desk.machine.start.copy(), desk.machine.m - 1
        start[place] += 0.1
        table = desk.machine.table(start=start)
        table[1, place] += 0.37
        printed = table.copy()
        printed[0, place] = desk.machine.start[place]
        assert earned(desk, printed)[0].share >= earned(desk, table)[0].share


@pytest.mark.parametrize("number", first(2, (0, 2, 1, 3)))
def test_an_angle_put_right_below_a_misprint_takes_nothing_of_what_both_rows_were_made_from(number):
    """The value behind the misprint is told by the next row no more, but by the velocities of its own."""
    desk = variants()[number]
    made_from_it = desk.machine.table(slip=(6, 0, 0.02))
    for row in range(8, desk.machine.rows - 2, 3):
        table = made_from_it.copy()
        table[row, 0] -= 2.7
        before = earned(desk, table)[0].share
        table[row + 1, 0] = desk.key.table[row + 1, 0]
        assert earned(desk, table)[0].share >= before - 1e-9, row


@pytest.mark.long
@pytest.mark.parametrize("number", [1, *(pytest.param(number, marks=pytest.mark.long) for number in (0, 2, 3, 4, 5))])
def test_coordinates_put_right_where_just_enough_rows_are_right_close_no_gate(number):
    """Another scheme's table with as many wrong rows as there may be: velocities made from what was put right are wrong then.

    Up to 31 points were lost; what the digits do not tell of one cell may go.
    """
    desk = variants()[number]
    m, rows, h = desk.machine.m, desk.machine.rows, desk.machine.h
    table = desk.machine.table(lambda t, q: h * desk.machine.velocities(t + h / 2, q)[:m])
    wrong = np.concatenate([np.arange(1, rows, 2), np.arange(2, rows, 2)])
    for row in range(8, rows - 2, 3):
        worse = table.copy()
        worse[wrong[wrong != row][: rows - math.ceil(ENOUGH_ROWS * rows)], -1] += 0.9
        before = earned(desk, worse)[0].share
        for place in range(m):
            better = worse.copy()
            better[row, place] = desk.key.table[row, place]
            assert earned(desk, better)[0].share >= before - 1 / (rows * table.shape[1] - m), (row, place)


def test_the_tolerance_of_usual_print_is_that_of_its_digits_whatever_is_spoiled():
    chance, desk = np.random.default_rng(4), variants()[0]
    floors = set()
    for count in (0, 0, 3, 8, 15):
        table = desk.machine.table()
        table[chance.integers(len(table), size=count), chance.integers(table.shape[1], size=count)] += 0.4
        floors.add(own_ways(desk.key, StudentTable(np.round(table, 4), np.full(table.shape, 1e-4))).coarse)
    assert len(floors) == 1


@pytest.mark.long
@pytest.mark.parametrize("method", ["heun", "rk4"])
def test_an_angle_put_right_in_the_table_of_another_method_takes_nothing_of_what_was_made_from_it(method):
    desk, table = variants()[0], students.MISCONCEPTIONS[method]()
    before, _ = earned(desk, table)
    for cell in [(5, 2), (10, 1), (17, 2), (21, 0), (21, 2)]:
        better = table.copy()
        better[cell] = desk.key.table[cell]
        assert earned(desk, better)[0].share >= before.share - 1e-9, cell


@pytest.mark.long
def test_a_velocity_put_right_in_a_table_with_times_of_its_own_takes_nothing():
    for desk in variants()[::2]:
        machine, half = desk.machine, desk.machine.h / 2
        made_with_half = machine.table(step=half)
        times = np.arange(len(made_with_half)) * half
        before, _ = desk.marked(made_with_half, times=times)
        for place in range(machine.m, made_with_half.shape[1]):
            better = made_with_half.copy()
            better[12, place] = desk.key.table[6, place]
            assert desk.marked(better, times=times)[0] >= before


def lines(desk, wrong):
    texts = {c.name: f"{spelled(c.left)} - ({spelled(c.right)})" for c in desk.variant.constraints} | wrong
    return [
        EquationLine("e.txt", number, f"{text} = 0", Formula("-", (parse(text), parse("0"))))
        for number, text in enumerate(texts.values(), 1)
    ]


@pytest.mark.parametrize("number", first(4, (0, 2, 4, 5, 1, 3)))
def test_an_equation_put_right_never_lowers_the_sum(number):
    """A table made from two wrong equations, handed in with both, with one and with none of them wrong."""
    desk = variants()[number]
    judge, rubric = Judge(desk.key), Rubric()
    first, *_, last = desk.variant.constraints
    slips = {c.name: next(iter(sign_faults(c))) for c in (first, last)}
    table = Machine(desk.variant, lines=slips).table()
    assert np.isfinite(table).all(), "the two slips make a motion"
    assert np.abs(table).max() < 1e3
    sums = []
    for wrong in (slips, {first.name: slips[first.name]}, {last.name: slips[last.name]}, {}):
        equations = judge.mark(lines(desk, wrong))
        sums.append(rubric.most("equations") * equations.share + rubric.most("table") * earned(desk, table, equations)[0].share)
    both, one, other, none = sums
    assert both <= one + 1e-9
    assert both <= other + 1e-9
    assert max(one, other) <= none + 1e-9


def test_right_cells_that_do_not_count_are_counted_by_their_gate():
    for desk in variants():
        still = np.tile(desk.key.table[0], (len(desk.key.table), 1))
        found, cells = earned(desk, still)
        right = ~cells.wrong & ~cells.missing & cells.counted
        assert sum(found.shut.values()) + round(found.of_cells * cells.counted.sum()) == right.sum()
