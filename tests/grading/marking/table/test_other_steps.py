"""Steps by another scheme or of another length, from right velocities, cost the same in every template.

One by one their cells would earn 34 to 46 of 60 points: more, the more coordinates are driven or turn steadily.
"""

import numpy as np
import pytest

import coursework
from coursework.grading.marking.rubric import Rubric, read_rubric
from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.machines import SLIDER_CRANK
from tests.grading.marking.table.desks import Desk, close

MOST = 60


def steps(machine):
    """Tables made by other rules than Euler's step, their velocities right at their own angles and times."""
    m, h = machine.m, machine.h

    def at(t, q):
        return machine.velocities(t, q)[:m]

    def rk4(t, q):
        one = at(t, q)
        two = at(t + h / 2, q + h / 2 * one)
        three = at(t + h / 2, q + h / 2 * two)
        return h / 6 * (one + 2 * two + 2 * three + at(t + h, q + h * three))

    yield "heun", machine.table(lambda t, q: h / 2 * (at(t, q) + at(t + h, q + h * at(t, q))))
    yield "midpoint", machine.table(lambda t, q: h * at(t + h / 2, q + h / 2 * at(t, q)))
    yield "rk4", machine.table(rk4)
    yield "half the step, every second row", machine.table(step=h / 2, rows=2 * machine.rows - 1)[::2]
    yield "twice the step", machine.table(lambda t, q: 2 * h * at(t, q))


@pytest.mark.parametrize(
    "name", ["31", "v102", "slider-crank", *(pytest.param(n, marks=pytest.mark.long) for n in ("v107", "v112"))]
)
def test_steps_by_another_rule_cost_the_same_in_every_template(name):
    desk = Desk(parse_variant(SLIDER_CRANK, "own.toml", {}) if name == "slider-crank" else coursework.load(name))
    points = {code: desk.marked(table)[0] for code, table in steps(desk.machine)}
    close([*points.values(), MOST * Rubric().steps_floor], near=0.5)


def test_a_table_with_all_rows_of_a_smaller_step_costs_what_every_second_row_does():
    desk = Desk(coursework.load("v102"))
    machine, h = desk.machine, desk.machine.h
    whole = machine.table(step=h / 2, rows=2 * machine.rows - 1)
    every, _ = desk.marked(whole[::2])
    both, _ = desk.marked(whole, times=np.arange(len(whole)) * h / 2, digits=6)
    close([every, both], near=0.5)


def test_the_rubric_says_what_such_steps_are_worth():
    desk = Desk(coursework.load("31"))
    desk.marker.rubric = Rubric(steps_floor=0.9)
    table = next(table for code, table in steps(desk.machine) if code == "heun")
    assert desk.marked(table)[0] == pytest.approx(MOST * 0.9, abs=0.5)
    desk.marker.rubric = read_rubric("[table]\nmisconception_floor = 0\n")  # the cells that are right count one by one
    assert desk.marked(table)[0] == pytest.approx(MOST * 0.58, abs=0.5)
