"""Rows made in many short steps, of which only the last was handed in: the number of steps is read off the table itself."""

from functools import partial

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.step_lengths import steps_a_row
from coursework.grading.marking.table.cells import mark_cells
from tests.grading.marking import students
from tests.grading.marking.machines import Machine
from tests.grading.marking.students import H, velocities
from tests.grading.marking.table.test_cells import printed
from tests.grading.marking.told import found_in


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


def in_steps(times, t, q):
    """Angles a row on, in so many Euler steps."""
    moved = np.array(q)
    for place in range(times):
        moved = moved + H / times * velocities(t + place * H / times, moved)[:3]
    return moved - q


def read(key, table, decimals=4):
    return steps_a_row(TableUnderTest(key, printed(table, decimals)))


STEPS = {
    3: "0.006667", 4: "0.005", 5: "0.004", 8: "0.0025", 12: "0.001667", 20: "0.001", 25: "0.0008", 50: "0.0004", 100: "0.0002",
}  # fmt: skip


@pytest.mark.parametrize(("times", "step"), STEPS.items())
def test_a_finer_step_is_named_with_its_length(key, times, step):
    cells = mark_cells(key, printed(students.table(partial(in_steps, times)), 4))
    found = found_in(key, cells).named
    assert found is not None and (found.code, found.names) == ("other_step", (step,))
    assert found.share > 0.99


@pytest.mark.parametrize(("times", "decimals", "told"), [
    (20, 6, 20), (20, 3, 20), (20, 2, 0), (2, 2, 2), (150, 6, 150), (150, 3, 0), (190, 7, 190), (210, 7, 0), (1, 4, 0),
])  # fmt: skip
def test_as_far_as_the_digits_tell_it(key, times, decimals, told):
    """With too few digits many numbers of steps fit, and more than 200 steps are the exact motion."""
    assert read(key, students.table(partial(in_steps, times)), decimals) == told


OTHERS = {
    "heun": students.table(students.heun), "midpoint": students.table(students.midpoint), "rk4": students.table(students.rk4),
    "2h": students.table(lambda t, q: 2 * H * velocities(t, q)[:3]), "sign": students.signed(0),
    "start": students.table(partial(in_steps, 5), start=(1.73, 3.37, 2.87)),
    "noise": students.table() + np.random.default_rng(1).normal(0, 0.02, (25, 7)), "empty": np.full((25, 7), np.nan),
}  # fmt: skip


@pytest.mark.parametrize("name", OTHERS)
@pytest.mark.parametrize("decimals", [2, 3, 4, 6])
def test_no_other_fault_is_taken_for_short_steps(key, name, decimals):
    assert read(key, OTHERS[name], decimals) == 0


def test_a_mean_of_euler_s_table_and_the_motion_is_named_nothing(key):
    """Half the error in every row, but by no step: what is read off is tried, and does not hold."""
    table = students.table()
    table[:, :3] = (table[:, :3] + key.exact[:, :3]) / 2
    table[:, 3:] = [velocities(H * row, q) for row, q in enumerate(table[:, :3])]
    found = found_in(key, mark_cells(key, printed(table, 6))).named
    assert found is None or found.code != "other_step"


def test_a_slip_in_one_row_of_five_hides_no_step(key):
    table = students.table(partial(in_steps, 20))
    table[4::5, 0] += 0.2
    assert read(key, table) == 20


@pytest.mark.parametrize(("wrong", "told"), [(2, 20), (3, 0)])
def test_four_of_five_cells_must_agree(key, wrong, told):
    """Of ten cells in which Euler's error is large, eight are just enough."""
    table, error = students.table(partial(in_steps, 20)), np.abs(key.table[:, 0] - key.exact[:, 0])
    large = np.flatnonzero(error >= 0.2 * error.max())[-10:]
    table[:, :3] = [[angle, np.nan, np.nan] if row in large else [np.nan] * 3 for row, angle in enumerate(table[:, 0])]
    table[large[:wrong], 0] += 0.2
    assert read(key, table) == told


@pytest.mark.parametrize("name", ["v107", "v101"])
def test_other_mechanisms(name):
    machine = Machine((key := key_of(coursework.load(name))).variant)
    q, rows = machine.start, []
    for row in range(machine.rows):
        rows.append(np.concatenate([q, machine.velocities(row * machine.h, q)]))
        for place in range(5):
            q = q + machine.h / 5 * machine.velocities((row + place / 5) * machine.h, q)[: machine.m]
    assert read(key, np.array(rows)) == 5
    found = found_in(key, mark_cells(key, printed(np.array(rows), 4))).named
    assert found is not None and found.code == "other_step"
