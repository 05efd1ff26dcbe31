"""A fault is worth the same whatever data were drawn for it, in whatever row a slip stands beside it, whatever is misprinted."""

import re

import numpy as np
import pytest

import coursework
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.misconceptions import _Weighed
from coursework.grading.marking.table.causes.printed_otherwise import other_columns
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.explained import Explained
from coursework.grading.marking.table.ways import StudentTable
from coursework.variant.formula.tree import spelled
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import Desk, close, codes, sign_faults, variants


def desk_of(given=None, start=None):
    return Desk(coursework.load("31").with_data(given=given or {}, start=start or {}))


@pytest.mark.parametrize(("wrong", "rule"), [(1, "start"), (2, "start"), (3, "cells")])
@pytest.mark.parametrize("number", [0, 2])
def test_a_slip_in_the_first_row_of_another_start_costs_what_it_costs_in_any_row(number, wrong, rule):
    """One wrong velocity took 31 of 60 points there, and a third of a point in row 9."""
    desk = variants()[number]
    start = desk.machine.start + 0.1 * (np.arange(desk.machine.m) == 1)
    points = []
    for row in (0, 8):
        table = desk.machine.table(start=start)
        table[row, desk.machine.m : desk.machine.m + wrong] += 0.3
        found, marked = desk.marked(table)
        points.append(found)
        assert marked.earned.rule == ("start" if row else rule), row
    assert points[0] == points[1] or wrong > 2


@pytest.mark.parametrize("alpha", [4.08, 4.65])
def test_a_frequency_with_the_other_sign_is_no_phase_a_little_off(alpha):
    """With -p the phase is pi - alpha, which is 4.775 for 4.65: a datum with digits wrong earned 57 instead of 30."""
    desk = desk_of({"alpha": alpha})
    found, table = desk.marked(Machine(desk.variant, data={"p": -desk.variant.values["p"]}).table())
    assert (found, codes(table)) == (30, ("datum_p",))


def test_sine_for_cosine_of_a_datum_near_45_degrees_is_no_other_angle():
    desk = Desk(coursework.load("v101").with_data(given={"beta": 0.8029}))
    text = f"{spelled(desk.variant.constraints[0].left)} - ({spelled(desk.variant.constraints[0].right)})"
    sines = {"sin(beta)": "cos(beta)", "cos(beta)": "sin(beta)"}
    wrong = re.sub("|".join(map(re.escape, sines)), lambda found: sines[found[0]], text, count=1)
    found, table = desk.marked(Machine(desk.variant, lines={desk.variant.constraints[0].name: wrong}).table())
    assert (wrong != text, found, "equation_1" in codes(table)) == (True, 30, True)


@pytest.mark.parametrize("start", [1.63, 1.57, 1.572, 1.573])
def test_a_sign_in_an_equation_is_no_other_axis_where_the_angle_begins_upright(start):
    """Turned round at a quarter turn it begins where the task begins: 57 points in one variant, 30 in others."""
    desk = desk_of(start={"phi1": start})
    (wrong,) = (text for text in sign_faults(desk.variant.constraints[2]) if "- r1*w1*sin(phi1)" in text)
    found, table = desk.marked(Machine(desk.variant, lines={"16": wrong}).table())
    assert (found, "equation_16" in codes(table)) == (30, True)


@pytest.mark.parametrize(("start", "claims"), [(1.5723, 1), (1.5724, 2)])
def test_so_near_to_a_quarter_turn_an_angle_begins_upright(start, claims):
    """0.003 rad and a unit of the last place, half of it on either side: then only the angle may be counted the other way."""
    desk = desk_of(start={"phi1": start})
    table = desk.key.table.copy()
    table[:, 0] = np.pi - table[:, 0]
    told = other_columns(TableUnderTest(desk.key, StudentTable(np.round(table, 4), np.full(table.shape, 1e-4))))
    assert [one.code for one in told] == claims * ["origin_phi1"]


def test_an_angle_counted_from_the_other_side_keeps_its_worth():
    desk = desk_of()
    table = desk.machine.table()
    table[:, 0] = np.pi - table[:, 0]
    table[:, desk.key.names.index("w1")] *= -1
    found, marked = desk.marked(table)
    assert (found, codes(marked)) == (57, ("origin_phi1", "equation_16"))


@pytest.mark.parametrize("seed", [2, 21])
def test_a_datum_a_little_off_excuses_nothing_in_a_table_from_another_start(seed):
    """It explained a few misprints by chance; what stands beside right cells was excused as made before they were put right."""
    desk, chance = Desk(coursework.draw("31", "31", "fair16", "a")), np.random.default_rng(seed)
    table = desk.machine.table(start=desk.machine.start + np.array([-0.1, 0.5, 0]))
    for _ in range(40):
        table[chance.integers(25), chance.integers(7)] += chance.choice([-1, 1]) * 10 ** chance.uniform(-2, 1)
    found, marked = desk.marked(table, digits=3)
    assert (marked.earned.rule, marked.earned.worth) == ("start", 0.6)
    close([found, 29.1], 0.5)


@pytest.mark.parametrize(("alone", "excuses"), [(5, False), (6, True)])
def test_a_cause_that_explains_few_cells_alone_excuses_no_others(alone, excuses):
    desk = variants()[0]
    table = desk.key.table.copy()
    table[::2, -1] += 0.7
    cells = mark_cells(desk.key, StudentTable(np.round(table, 4), np.full(table.shape, 1e-4)))
    holds = np.zeros_like(cells.wrong)
    holds[tuple(np.argwhere(cells.wrong)[:alone].T)] = True
    assert (_Weighed(Explained(desk.key, cells), (), elsewhere=False)._excuses(holds) > 0) == excuses


def test_cells_put_right_beside_a_copied_column_take_nothing_from_the_datum_that_made_the_others():
    """The value read off went to the task's with each of them, and with it up to 7 points."""
    desk, chance = desk_of(), np.random.default_rng(71)
    table = Machine(desk.variant, data={"alpha": 1.05 * desk.variant.values["alpha"]}).table()
    table[:, 2] = desk.key.table[:, 2]
    table[chance.integers(1, 25, 20), chance.integers(7, size=20)] = np.nan
    points = []
    for cells in ([], [(0, 3), (0, 4)], [(0, 5), (0, 6), (2, 5), (3, 5)]):
        for cell in cells:
            table[cell] = desk.key.table[cell]
        points.append(desk.marked(table, digits=2)[0])
    assert points == sorted(points)
