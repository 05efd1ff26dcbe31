"""A table whose rows are right and whose times are not: the column t earns and costs nothing, and it is told."""

import numpy as np
import pytest

from tests.grading.marking.table.desks import codes, variants


def slip(t):
    t = t.copy()
    t[6] += 40.0
    return t


OTHER = {
    "doubled": lambda t: 2 * t,
    "tenfold": lambda t: 10 * t,
    "a tenth": lambda t: t / 10,
    "from the first step": lambda t: t + t[1],
    "much later": lambda t: t + 700,
    "numbers from 0": lambda t: np.round(t / t[1]),
    "numbers from 1": lambda t: np.round(t / t[1]) + 1,
    "backwards": lambda t: -t,
    "all the same": lambda t: 0 * t + 5,
    "minutes": lambda t: t / 60,
    "one mistyped": slip,
}


def heun(machine):
    def step(t, q):
        rate = machine.velocities(t, q)[: machine.m]
        return machine.h / 2 * (rate + machine.velocities(t + machine.h, q + machine.h * rate)[: machine.m])

    return machine.table(step)


@pytest.mark.parametrize("how", OTHER)
def test_times_of_another_step_unit_or_beginning_cost_nothing(how):
    for desk in variants()[::2]:
        table = desk.machine.table()
        times = OTHER[how](np.arange(len(table)) * desk.machine.h)
        points, marks = desk.marked(table, times=times)
        assert points == 60.0, (desk.variant.name, points)
        assert codes(marks) == () and not marks.cells.wrong.any()
        told = [note.code for note in marks.table.notes]
        assert ("data_differ" in told) == (not how.startswith("numbers"))  # rows may be numbered; times of another step are told


@pytest.mark.long
@pytest.mark.parametrize("how", ["doubled", "from the first step", "numbers from 1"])
def test_another_fault_costs_and_is_told_as_with_the_right_times(how):
    for desk in variants()[::2]:
        table = heun(desk.machine)
        times = OTHER[how](np.arange(len(table)) * desk.machine.h)
        points, marks = desk.marked(table, times=times)
        usual, plain = desk.marked(table)
        assert points == usual and codes(marks) == codes(plain)


def test_the_first_rows_earn_their_cells_with_times_that_are_all_of_the_task():
    """Half of the rows with doubled times: every time is one of the grid, of another row."""
    for desk in variants()[::2]:
        table, h = desk.machine.table()[: (desk.machine.rows + 1) // 2], desk.machine.h
        usual, _ = desk.marked(table, times=np.arange(len(table)) * h)
        points, marks = desk.marked(table, times=2 * np.arange(len(table)) * h)
        assert points == usual > 25 and not marks.cells.wrong.any()


@pytest.mark.parametrize("how", ["doubled", "from the first step", "much later", "numbers from 1", "minutes"])
def test_shuffled_rows_with_other_times_are_put_in_order_and_that_is_told(how):
    for desk in variants()[::2]:
        order = np.random.default_rng(2).permutation(desk.machine.rows)
        times = OTHER[how](np.arange(desk.machine.rows) * desk.machine.h)[order]
        points, marks = desk.marked(desk.machine.table()[order], times=times)
        assert points == 60.0 and not marks.cells.wrong.any() and codes(marks) == ()
        told = {note.code: note.text for note in marks.table.notes}
        assert "rows_sorted" in told
        if "data_differ" in told:
            assert "row 1 is at" in told["data_differ"] or "row 2 is at" in told["data_differ"]


@pytest.mark.parametrize(("how", "most"), [("numbers from 0", 9), ("minutes", 2)])
def test_times_put_right_one_by_one_in_shuffled_rows_cost_nothing(how, most):
    """Some rows numbered, some timed: one time put right left two rows of 25 in their places, 45 points were lost."""
    desk = variants()[0]
    order = np.random.default_rng(2).permutation(desk.machine.rows)
    right = order * desk.machine.h
    times = OTHER[how](np.arange(desk.machine.rows) * desk.machine.h)[order]
    for count in (1, most):
        times[:count] = right[:count]
        points, marks = desk.marked(desk.machine.table()[order], times=times)
        assert points == 60.0 and not marks.cells.wrong.any(), count


def test_shuffled_rows_with_the_times_of_the_task_have_no_other_order():
    desk = variants()[0]
    order = np.random.default_rng(2).permutation(desk.machine.rows)
    _, marks = desk.marked(desk.machine.table()[order], times=order * desk.machine.h)
    assert marks.table.in_order is None and marks.table.reading.order == "sorted"


def test_rows_left_out_at_the_beginning_stand_where_their_times_say():
    for desk in variants()[::2]:
        table, h = desk.machine.table(), desk.machine.h
        _, marks = desk.marked(table[2:], times=np.arange(2, len(table)) * h)
        assert marks.table.rows_present[:3] == (False, False, True) and not marks.cells.wrong.any()


def test_rows_of_another_step_are_found_by_their_times_and_told_with_their_place_in_the_file():
    """Half of the task with half the step earned as much as all of it, and the first wrong cell stood in another row."""
    desk = variants()[0]
    machine, rows = desk.machine, desk.machine.rows
    fine, times = machine.table(step=machine.h / 2, rows=2 * rows - 1), np.arange(2 * rows - 1) * machine.h / 2
    whole, marks = desk.marked(fine, times=times)
    half, few = desk.marked(fine[:rows], times=times[:rows])
    assert half == pytest.approx(whole / 2, abs=2)
    assert (sum(few.table.rows_present), few.table.rows[:3]) == ((rows + 1) // 2, (1, 3, 5))
    told = f"Row 2 (t = {machine.h:g} s, row 3 of the file): Euler’s step from your own row 1 is "
    assert all(str(one.first.sentence).startswith(told) for one in (marks, few))


@pytest.mark.parametrize("parts", [4, 12])
def test_a_step_with_which_the_drive_cannot_be_followed_earns_its_rows_and_is_told(parts):
    """With twelve steps in one the drive turns more than half a turn from row to row: no motion of the tool has that step."""
    machine = variants()[0].machine
    table = machine.table(step=parts * machine.h, rows=(machine.rows - 1) // parts + 1)
    points, marks = variants()[0].marked(table, times=np.arange(len(table)) * parts * machine.h)
    assert 0 < points < 60 / parts and "other_step" in codes(marks)


@pytest.mark.long
def test_a_table_truly_made_with_another_step_is_told_so():
    for desk in variants()[::2]:
        machine = desk.machine
        table = machine.table(lambda t, q, m=machine: m.h / 2 * m.velocities(t, q)[: m.m])
        _, marks = desk.marked(table, times=np.arange(len(table)) * machine.h / 2)
        assert "other_step" in codes(marks), desk.variant.name


@pytest.mark.long
@pytest.mark.parametrize(("row", "how"), [(10, "tenfold"), (1, "a tenth"), (20, "from the first step"), (8, "doubled")])
def test_a_time_put_right_among_others_takes_nothing_of_the_points(row, how):
    """It may be that of another row as well: a person is asked then, and told the points that the better order earns."""
    for desk in variants()[::2]:
        table, times = desk.machine.table(slip=(9, 0, 0.2)), np.arange(desk.machine.rows) * desk.machine.h
        other = OTHER[how](times)
        before, _ = desk.marked(table, times=other)
        other[row] = times[row]
        assert desk.marked(table, times=other)[0] >= before > 55


@pytest.mark.long
def test_a_time_put_right_in_a_table_of_double_steps_leaves_it_one():
    """The times then are uneven, and the others still tell with which step the table was made."""
    for desk in variants()[::2]:
        table, times = desk.machine.table(step=2 * desk.machine.h), 2 * np.arange(desk.machine.rows) * desk.machine.h
        table, times = table[: desk.machine.rows], times[: len(table)]
        before, marks = desk.marked(table, times=times)
        times[21] = 21 * desk.machine.h
        after, again = desk.marked(table, times=times)
        assert "other_step" in codes(marks) and "other_step" in codes(again)
        assert after >= before > 10
