"""The same fault costs the same with few digits as with many: where two decimals do not show it in a cell, the table does."""

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.marking.reasons.table import table_reasons
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.cut_off import with_the_rest
from coursework.grading.marking.table.earning import ROUNDED
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import Desk, close, codes
from tests.grading.marking.table.test_cells import printed
from tests.grading.marking.table.test_twelve_variants import desk_of
from tests.grading.whole_class.tables import from_rows_before, slopes
from tests.sample import first

DECIMALS = (2, 3, 5)  # of variant 31's class two are accepted
DOZEN = first(1, range(12))


@cache
def of(number):
    return Desk(coursework.draw("31", "31", "twelve", f"student{number}"), accepted=DECIMALS[0])


def faults(machine):
    h, m = machine.h, machine.m
    yield (
        "heun",
        machine.table(lambda t, q: h / 2 * (slopes(machine, t, q) + slopes(machine, t + h, q + h * slopes(machine, t, q)))),
    )
    yield "other_step", machine.table(step=h / 2, rows=2 * machine.rows - 1)[::2]
    yield "other_step", machine.table(lambda t, q: 0.4 * h * slopes(machine, t, q))
    yield "row_before", from_rows_before(machine)
    yield "step_behind", machine.table(lambda t, q: h * slopes(machine, t - h, q))
    yield "degree_drive", Machine(machine.variant, degrees=("drive",)).table()
    yield "sign_drive", Machine(machine.variant, drive_sign=-1.0).table()
    yield "datum_r2", Machine(machine.variant, data={"r2": 1.13 * machine.variant.values["r2"]}).table()
    yield "datum_V1", Machine(machine.variant, data={"V1": 0.5 * machine.variant.values["V1"]}).table()
    yield "equation_16", Machine(machine.variant, lines={"16": turned(machine, "16", " + r2")}).table()
    yield "equation_18", Machine(machine.variant, lines={"18": turned(machine, "18", " - r1")}).table()
    yield "swapped_columns", machine.table()[:, [2, 1, 0, *range(m, machine.table().shape[1])]]


def turned(machine, name, term):
    """The equation left - right as a text, the sign of a term turned."""
    text = {
        "16": "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1)",
        "18": "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1)",
    }[name]
    assert term in text
    return text.replace(term, (" - " if term[1] == "+" else " + ") + term[3:])


@pytest.mark.long
@pytest.mark.parametrize("fewer", first(1, DECIMALS[:2]))
@pytest.mark.parametrize("number", DOZEN)
def test_a_fault_is_named_and_costs_the_same_with_any_decimals(number, fewer):
    desk = of(number)
    for code, table in faults(desk.machine):
        if np.isfinite(table).all() and np.abs(table).max() < 300:
            marked = [desk.marked(table, digits=digits) for digits in (fewer, DECIMALS[-1])]
            close([points for points, _ in marked], near=2.1)
            assert all(code in codes(found) for _, found in marked), (code, [codes(found) for _, found in marked])


@pytest.mark.long
@pytest.mark.parametrize("number", DOZEN)
def test_rounding_on_the_way_costs_little_with_any_decimals(number):
    desk, h = of(number), of(number).machine.h
    machine = desk.machine
    coarse = machine.table(lambda t, q: h * np.round(slopes(machine, t, q), 1))
    points = [desk.marked(coarse, digits=digits)[0] for digits in DECIMALS]
    close(points)
    assert min(points) >= ROUNDED * 60 - 0.7


def test_work_rounded_at_each_step_is_worth_the_same_with_the_zeros_that_it_was_printed_with():
    for desk in (of(0), of(1)):
        machine = desk.machine
        rounded = machine.table(
            lambda t, q, machine=machine: np.round(q + machine.h * np.round(slopes(machine, t, q), 2), 2) - q,
            printed=lambda t, q, machine=machine: np.round(machine.velocities(t, q), 2),
        )
        few, many = desk.marked(rounded, digits=2)[0], desk.marked(rounded, digits=5)[0]
        assert few == many == 60


def test_zeros_of_one_column_only_are_digits():
    """Angles rounded at each step while velocities are printed in full: nobody worked with two decimals there."""
    desk = of(0)
    machine = desk.machine
    rounded = machine.table(lambda t, q: np.round(q + machine.h * slopes(machine, t, q), 2) - q)
    assert desk.marked(rounded, digits=5)[0] < 40


@pytest.mark.parametrize(("spoiled", "told"), [(10, True), (14, False)])
def test_a_table_is_a_causes_as_a_whole_where_nearly_all_of_it_is(spoiled, told):
    """Of 172 cells 93 % are 159.96: 162 are enough, 158 are not."""
    desk = of(2)
    machine, half = desk.machine, desk.machine.h / 2
    table = machine.table(step=half, rows=2 * machine.rows - 1)[::2]
    rows = np.linspace(2, machine.rows - 2, spoiled).round().astype(int)
    table[rows, machine.m + 3] += 0.4  # w4, of which nothing else is made
    _, found = desk.marked(table, digits=2)
    assert ("other_step" in codes(found)) is told


@pytest.mark.parametrize("last", first(1, (31, 33)))
def test_cells_put_right_are_none_against_what_made_the_table_as_a_whole(last):
    """Seven cells of ten are enough for that: of the 100 velocities, the angles being too coarse, 71 that no misprint is in."""
    desk, chance = Desk(coursework.load("v107")), np.random.default_rng(5)
    table = Machine(desk.variant, drive_sign=-1.0).table()
    places = chance.permutation(np.argwhere(np.ones((25, 4)))) + np.array([0, desk.machine.m])
    table[tuple(places[:29].T)] += 0.4
    before = desk.marked(table, digits=2)[0]
    chosen = tuple(places[29:last].T)
    table[chosen] = desk.key.table[chosen]
    assert desk.marked(table, digits=2)[0] >= before > 15


def test_numbers_of_which_half_are_too_large_were_not_cut_off():
    """A longer r2 makes w2 smaller in every row: that looked like digits cut off, and 57 points became 59.65."""
    desk = of(2)
    table = Machine(desk.variant, data={"r2": 1.13 * desk.variant.values["r2"]}).table()
    cells = mark_cells(desk.key, printed(table, 2))
    assert cells.wrong.sum() > 3 and with_the_rest(desk.key, cells) is None


def test_no_wrong_table_earns_more_than_the_right_one_with_the_same_digits():
    """Two decimals of v102 do not show the angles; with the sign of one velocity turned they were counted."""
    desk = Desk(coursework.load("v102"))
    turned = desk.machine.table()
    turned[:, desk.key.names.index("u")] *= -1
    right, wrong, fine = (desk.marked(t, digits=d)[0] for t, d in ((desk.machine.table(), 2), (turned, 2), (turned, 5)))
    assert wrong < right < fine < 60


@pytest.mark.parametrize(("step", "named"), [(0.0203, False), (0.021, True)])
def test_a_step_is_another_from_its_second_digit_on(step, named):
    desk = of(0)
    assert desk.machine.h == 0.02
    table = desk.machine.table(lambda t, q: step * slopes(desk.machine, t, q))
    _, found = desk.marked(table, digits=5)
    assert ("other_step" in codes(found)) is named
    told = [reason.text for reason in table_reasons(desk.key, found, Rubric(), 30.0, 60.0)]
    assert any("they follow with 0.021 s" in text for text in told) is named


def test_rows_of_a_shorter_step_stand_where_they_say():
    """Of rows every 0.01 s two are equally near to a row of the task at 0.025 s; neither is it."""
    desk = desk_of("v102", 0)
    fine = desk.machine.table(step=0.01, rows=61)
    points, found = desk.marked(fine, times=np.arange(61) * 0.01)
    assert codes(found) == ("other_step",)
    assert points == pytest.approx(desk.marked(desk.machine.table(step=0.0125, rows=49)[::2])[0], abs=1.0)


def test_a_start_value_in_the_wrong_column_is_told_to_cost_a_cell():
    desk = of(0)
    table = desk.machine.table()
    table[0, :2] = table[0, 1::-1].copy()
    points, found = desk.marked(table, digits=4)
    told = " ".join(reason.text for reason in table_reasons(desk.key, found, Rubric(), points, 60.0))
    assert "Each of them costs one cell." in told


@pytest.mark.long
@pytest.mark.parametrize("number", DOZEN)
def test_a_slip_that_is_carried_on_costs_its_cell_with_few_digits(number):
    """A slow coordinate stands in some rows below, and what other causes make comes near by chance."""
    desk = of(number)
    for place in range(len(desk.key.names)):
        points, found = desk.marked(desk.machine.table(slip=(7, place, 0.1)), digits=2)
        assert points > 59
        assert not codes(found)


@pytest.mark.long
def test_a_start_that_nobody_printed_is_no_cause_of_some_cells():
    """One sign turned, and few of the cells are what another start makes as well."""
    desk = desk_of("v102", 5)
    text = "VMy - a*w3*cos(phi3) - r2*w2*cos(phi2) + r1*w1*cos(phi1)"
    table = Machine(desk.variant, lines={"4": text}).table()
    for digits in (desk.key.least_decimals, 5):
        assert desk.marked(table, digits=digits)[1].earned.rule != "start"


@pytest.mark.parametrize("row", [2, 8])
def test_a_small_slip_that_two_decimals_hide_is_no_other_datum(row):
    """Cells that follow Euler's rules were called those of another r3, which left more of them open: 36 points."""
    desk = of(0)
    table = desk.machine.table(slip=(row, desk.key.names.index("w3"), 0.03))
    marked = [desk.marked(table, digits=digits) for digits in (2, 4)]
    close([points for points, _ in marked])
    assert all(found.earned.rule == "cells" for _, found in marked)


@pytest.mark.parametrize(("name", "accepted", "state", "points"), [
    ("31", None, "graded-with-notes", 60.0), ("v102", None, "needs-review", 34.88), ("v102", 2, "graded-with-notes", 60.0),
    ("v102", 3, "graded-with-notes", 34.88),
])  # fmt: skip
def test_two_decimals_that_nobody_forbade_are_a_question_where_a_variant_alone_needs_three(name, accepted, state, points):
    """The same right table was worth 60 points in variant 31 and 34.88 in v102; another rule than Euler's is no question."""
    desk = Desk(coursework.load(name), accepted)
    grade = desk.handed(desk.machine.table(), digits=2)
    assert (grade.status, grade.part("table")[0]) == (state, points)
    heun = next(table for code, table in faults(desk.machine) if code == "heun") if name == "31" else desk.machine.table() + 0.1
    assert desk.handed(heun, digits=2).status == "graded-with-notes"
