"""Faults of spreadsheets and calculators: the row above, degrees beside radians, sine for cosine; named, and worth the same."""

import re

import numpy as np
import pytest

from coursework.grading.marking.reasons.table import table_reasons
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.cells import _cut_off
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.reading.reader import parse_variant
from coursework.words.sentences import load_phrases
from tests.grading.marking.machines import DEGREE, SLIDER_CRANK, Machine
from tests.grading.marking.table.desks import Desk, close, codes, of_each, variants
from tests.sample import diagonal


def of_rows_above(machine):
    """Velocities with the time and the positions of the row above, in print and in the steps; the first row has its own."""
    q, rows, before = machine.start, [], None
    for k in range(machine.rows):
        own = machine.velocities(k * machine.h, q)
        before, used = own, own if before is None else before
        rows.append(np.concatenate([q, used]))
        q = q + machine.h * used[: machine.m]
    return np.array(rows)


def with_sines_exchanged(machine):
    laws = {name: re.sub("sin|cos", lambda f: {"sin": "cos", "cos": "sin"}[f[0]], law) for name, law in machine.laws.items()}
    return Machine(machine.variant, drive=laws).table()


# π is in a speed given in turns a minute and in a law of time.
BY_PI = re.sub(rb'w0 *= *"[^"]*"', b'w0 = "40 rpm"', SLIDER_CRANK).replace(b"sin(3*t)", b"sin(pi*t)")


def with_rounded_pi(variant, **speeds):
    return Machine(variant, data={"pi": 3.14} | speeds).table()


def of_degrees(machine, table):
    """A table with its angles printed in degrees."""
    return table / np.where(
        [c.unit == "rad" for c in machine.variant.coordinates] + [False] * len(table[0, machine.m :]), DEGREE, 1
    )


def moved_by_radians(machine):
    """Each step adds rad/s to degrees."""
    part = np.where([c.unit == "rad" for c in machine.variant.coordinates], DEGREE, 1.0)
    return of_degrees(machine, machine.table(lambda t, q: part * machine.h * machine.velocities(t, q)[: machine.m]))


def radians_everywhere(machine):
    """The same, and sines that take radians are given degrees."""
    return moved_by_radians(Machine(machine.variant, degrees=("radians",)))


@pytest.mark.parametrize(
    ("made", "code", "worth"),
    [(of_rows_above, "rows_above", 24), (with_sines_exchanged, "cosine_drive", 30), (radians_everywhere, "radian_mode", 36)],
)
@of_each
def test_what_is_mixed_up_is_named_and_worth_the_same_everywhere(made, code, worth, numbers):
    points = []
    for desk in (variants()[number] for number in numbers):
        if code == "cosine_drive" and not any("sin" in law for law in desk.machine.laws.values()):
            continue
        found, table = desk.marked(made(desk.machine), digits=5)
        assert code in codes(table)
        points.append(found)
    close(points)
    assert np.mean(points) == pytest.approx(worth, abs=1.2)


@pytest.mark.long
@pytest.mark.parametrize("digits", [3, 4, 6])
def test_pi_taken_as_three_places_is_named_and_costs_as_little_as_rounding_does(digits):
    desk = Desk(parse_variant(BY_PI, "own.toml", {}))
    found, table = desk.marked(with_rounded_pi(desk.variant, w0=40 * 3.14 / 30), digits=digits)
    assert codes(table) == ("pi_rounded",)
    assert found == 58.8
    right, table = desk.marked(desk.machine.table(), digits=digits)
    assert (right, codes(table)) == (60.0, ())


@pytest.mark.long
def test_steps_that_add_radians_to_degrees_leave_the_velocities_right():
    """As half a step does, where the velocities are not the same at any time."""
    for desk in variants():
        if desk.variant.known_rates:
            continue
        found, table = desk.marked(moved_by_radians(desk.machine), digits=5)
        assert codes(table) == ("degree_steps",)
        half, _ = desk.marked(desk.machine.table(lambda t, q, m=desk.machine: 0.5 * m.h * m.velocities(t, q)[: m.m]))
        assert found == pytest.approx(half, abs=0.5)


def headed(desk, table, unit):
    """The points and marks of a table with its angles under heads with a unit, or without one."""
    own = type(desk)(desk.variant)
    names = [f"{name}, {unit}" if unit and desk.variant.unit_of(name) == "rad" else name for name in desk.key.names]
    lines = [";".join(["t", *names])]
    lines += [";".join([f"{k * desk.machine.h:.4f}", *(f"{x:.5f}" for x in row)]) for k, row in enumerate(table)]
    files = (submitted_file("table.csv", "\n".join(lines).encode()),)
    grade = own.marker.grade(read_submission(Submission("a", None, files), own.expected))
    return grade.part("table")[0], grade.table


def test_starts_in_degrees_cost_the_same_under_every_head():
    """The task's starts typed in degrees, and all else in radians: the numbers are the same, whatever the head calls them."""
    for desk in variants()[1::2]:
        table = radians_everywhere(desk.machine)
        points = [headed(desk, table, unit)[0] for unit in ("", "deg", "rad")]
        assert points == [points[0]] * 3 and points[0] == 36.0


@pytest.mark.long
def test_steps_in_degrees_added_to_radians_are_told_and_leave_the_velocities_right():
    for desk in variants():
        machine, m = desk.machine, desk.machine.m
        table = machine.table()
        angles = [place for place, one in enumerate(desk.variant.coordinates) if one.unit == "rad"]
        table[:, angles] = table[0, angles] + (table[:, angles] - table[0, angles]) / DEGREE
        found, marks = desk.marked(table)
        assert codes(marks)[:1] == ("steps_in_degrees",), (desk.variant.name, codes(marks))
        assert (marks.cells.marks[:, m:] == "key").all() and found == 60 * Rubric().steps_floor


@pytest.mark.long
@pytest.mark.parametrize("factor", [10.0, 0.1])
def test_a_decimal_point_that_slipped_in_all_coordinates_is_told_as_that(factor):
    for desk in variants():
        table = desk.machine.table()
        table[:, : desk.machine.m] *= factor
        found, marks = desk.marked(table, digits=6)
        assert codes(marks)[:1] == ("point_slipped",), (desk.variant.name, codes(marks))
        m, columns = desk.machine.m, table.shape[1]
        assert 24 <= found <= 60 * (0.4 * m + columns - m) / columns + 0.1  # right velocities are right


@pytest.mark.parametrize("factor", [10.0, 0.1])
def test_a_decimal_point_that_slipped_in_all_columns_is_told_as_that_and_not_as_turns(factor):
    for desk in variants()[:3]:
        rows = np.column_stack([np.arange(desk.machine.rows) * desk.machine.h, factor * desk.machine.table()])
        text = "\n".join([";".join(["t", *desk.key.names]), *(";".join(f"{value:.6f}" for value in row) for row in rows)])
        files = (submitted_file("table.csv", text.encode()),)
        grade = desk.marker.grade(read_submission(Submission("a", None, files), desk.expected))
        assert codes(grade.table) == ("each_point_slipped",), (desk.variant.name, codes(grade.table))
        assert grade.part("table")[0] == pytest.approx(24, abs=1) and "turns" not in [note.code for note in grade.notes]


def test_velocities_that_are_all_zero_are_told_as_that():
    for desk in variants():
        table = desk.machine.table()
        table[:, desk.machine.m :] = 0.0
        found, marks = desk.marked(table)
        assert codes(marks) == ("no_velocities",) and found == pytest.approx(30, abs=1.5), (
            desk.variant.name,
            codes(marks),
            found,
        )


def test_columns_exchanged_are_not_taken_for_degrees():
    """Of two angles one may begin 60 times as large as the other."""
    desk = variants()[2]
    assert desk.variant.unit_of(desk.key.names[0]) == desk.variant.unit_of(desk.key.names[2]) == "rad"
    variant = desk.variant.with_data(start={desk.key.names[0]: 1.4, desk.key.names[2]: 1.4 / 60})
    own = type(desk)(variant)
    order = [2, 1, 0, *range(3, len(own.key.names))]
    _, table = own.marked(Machine(variant).table()[:, order])
    assert codes(table) == ("swapped_columns",) and not table.table.notes


def test_what_follows_from_ones_own_wrong_equation_is_told_so():
    """A slip in a sum of two equations of the task explains the only wrong column, though the cells by themselves earn more."""
    desk = variants()[2]
    line = "c*w3*sin(phi3) - r2*w2*cos(phi2) + r1*w1*cos(phi1)"
    machine = Machine(desk.variant, lines={"2": f"{line} - u"})
    _, table = desk.marked(machine.table(), equations={"2": f"{line} = u"})
    told = " ".join(str(reason.text) for reason in table_reasons(desk.key, table, Rubric(), 50.0, 60.0))
    assert table.earned.rule == "cells" and not codes(table)
    assert "your own equations, of which line 2 is not right" in told and "No usual cause" not in told


def test_a_table_with_times_of_its_own_is_told_the_step_of_these_times():
    """Twice the step, and every second row of the task: the digits alone would as well be those of a tenth of it."""
    desk = variants()[0]
    twice = desk.machine.table(step=2 * desk.machine.h, rows=(desk.machine.rows + 1) // 2)
    _, table = desk.marked(twice, times=2 * desk.machine.h * np.arange(len(twice)))
    assert (table.misconception.code, table.misconception.names) == ("other_step", (f"{2 * desk.machine.h:.4g}",))


@pytest.mark.parametrize(("language", "said"), [("ru", "получаются при 5,09 м/с."), ("zh", "取 5.09 m/s 时")])
def test_a_value_is_told_with_the_unit_and_the_mark_of_the_language(language, said):
    desk = variants()[0]
    value = 5.09
    _, table = desk.marked(Machine(desk.variant, data={"V1": value}).table())
    phrases = load_phrases(language)
    assert said in " ".join(phrases.written(reason.text) for reason in table_reasons(desk.key, table, Rubric(), 24.0, 60.0))


def by_the_rate_of_another(machine):
    """The last two angles are moved with the velocities of each other."""
    order = [*range(machine.m)]
    last = [place for place, c in enumerate(machine.variant.coordinates) if c.unit == "rad"][-2:]
    order[last[0]], order[last[1]] = last[1], last[0]
    return machine.table(lambda t, q: machine.h * machine.velocities(t, q)[order])


def of_two_rows(machine):
    """The scheme of Adams and Bashforth, whose first step is Euler's."""
    slopes = []

    def increment(t, q):
        slopes.append(machine.velocities(t, q)[: machine.m])
        return machine.h * (slopes[-1] + 0.5 * (slopes[-1] - slopes[max(len(slopes) - 2, 0)]))

    return machine.table(increment)


def of_angles_above(machine):
    """The time of the row, the angles of the row above."""
    rows = []

    def velocities(t, q):
        rows.append(q)
        return machine.velocities(t, rows[max(len(rows) - 2, 0)])

    return machine.table(printed=velocities)


def heun_at_one_time(machine):
    """Both stages of Heun's step at the time of the row."""

    def increment(t, q):
        first = machine.h * machine.velocities(t, q)[: machine.m]
        return (first + machine.h * machine.velocities(t, q + first)[: machine.m]) / 2

    return machine.table(increment)


def ralston(machine):
    def increment(t, q):
        first = machine.h * machine.velocities(t, q)[: machine.m]
        second = machine.h * machine.velocities(t + 2 * machine.h / 3, q + 2 * first / 3)[: machine.m]
        return (first + 3 * second) / 4

    return machine.table(increment)


MIXED = {
    "ralston": ralston,
    "first_angles": lambda m: m.table(printed=lambda t, q: m.velocities(t, m.start)),
    "angles_above": of_angles_above,
    "time_in_rows": lambda m: m.table(printed=lambda t, q: m.velocities(round(t / m.h), q)),
    "time_still": lambda m: m.table(printed=lambda t, q: m.velocities(1.0, q)),
    "other_rates": by_the_rate_of_another,
    "two_rows": of_two_rows,
    "heun": heun_at_one_time,
    "datum_p": lambda m: Machine(m.variant, data={"p": 2 * np.pi * m.variant.values["p"]}).table(),
}


@pytest.mark.long
@pytest.mark.parametrize(("code", "number"), diagonal(2, MIXED, (0, 2)))
def test_faults_of_time_angles_and_rates_are_named_and_keep_what_is_worth_of_one(code, number):
    """Rows of such a table follow no motion near the task's: unnamed it had nothing."""
    desk = variants()[number]
    found, table = desk.marked(MIXED[code](desk.machine), digits=5)
    assert code in codes(table)
    assert found > 23


def test_start_values_with_digits_cut_off_are_those_of_the_task():
    """2.876 rad of the task are 2.87 rad where two decimals are kept and none is rounded; 2.86 rad are another start."""
    for printed, right in ((2.87, True), (2.86, False), (2.88, False)):
        begins = _cut_off(np.array([[2.876, -0.28]]), np.array([[printed, -0.28]]), np.full((1, 2), 0.01))
        assert begins.tolist() == [[right, True]]


@pytest.mark.long
@pytest.mark.parametrize(("by", "code"), [(1, "omega_late"), (-1, "omega_early")])
@of_each
def test_velocities_in_the_next_row_are_told_as_that_alone(by, code, numbers):
    """Every angle stands in its place, so no row is shifted, and none follows from the velocity printed above it."""
    for desk in (variants()[number] for number in numbers):
        table, m = desk.machine.table(), desk.machine.m
        table[max(by, 0) : len(table) + min(by, 0), m:] = table[max(-by, 0) : len(table) - max(by, 0), m:].copy()
        points, marked = desk.marked(table)
        assert codes(marked) == (code,)
        causes = [one for one in table_reasons(desk.key, marked, Rubric(), points, 60.0) if one.kind == "cause"]
        assert len(causes) == 1
