"""What is told of a fault besides its points: what explains as much, what a start costs, the number that the task has."""

import numpy as np
import pytest

import coursework
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.reasons.table import table_reasons
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.other_data import _values_read_off
from coursework.grading.marking.table.ways import StudentTable
from coursework.variant.formula.tree import spelled
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import Desk, close, codes, variants
from tests.grading.scenes import variant_of


def test_what_explains_as_much_is_told_in_sentences_of_its_own():
    desk = variants()[0]
    _, table = desk.marked(Machine(desk.variant, data={"V1": -desk.variant.values["V1"]}).table())
    told = [reason.text for reason in table_reasons(desk.key, table, Rubric(), 30.0, 60.0) if "as well be" in reason.text]
    assert told == [
        "It could as well be: w3 has the other sign.",
        "It could as well be: the datum V1 has a value other than the task’s.",
        "It could as well be: one slip in equation 11.",
    ]


def test_a_start_that_shuts_the_whole_table_is_not_said_to_cost_a_cell():
    desk = variants()[0]
    mistyped = desk.machine.table()
    mistyped[0, 0] = 1.0
    for table, costs in ((np.zeros((25, 7)), False), (mistyped, True)):
        _, marked = desk.marked(table)
        told = " ".join(reason.text for reason in table_reasons(desk.key, marked, Rubric(), 0.0, 60.0))
        assert ("Each of them costs one cell." in told) is costs


def test_a_start_value_is_told_as_the_task_has_it_whatever_turns_were_taken_off():
    variant = coursework.load("v102").with_data(start={"phi2": 3.32, "phi3": 0.08})
    desk = Desk(variant)
    _, table = desk.marked(desk.machine.table()[:, [0, 2, 1, 3, 4, 5, 6]])
    assert "phi2 should begin with the start value 3.32 rad of the task; 0.08 rad stands there" in table.first.sentence


@pytest.mark.parametrize(
    ("name", "part"), [("p", 1.0005), ("alpha", 1.0004), ("V1", 1.0015), ("r1", 1.0015), ("p", 2.5), ("r1", 0.4), ("r3", 0.4)]
)
def test_a_slip_in_a_datum_costs_the_same_small_or_large(name, part):
    """One place of four off, or far off: half the points were lost, for a wrong sign that explains a part."""
    desk = variants()[0]
    points, marked = desk.marked(np.round(Machine(desk.variant, data={name: part * desk.variant.values[name]}).table(), 4))
    assert points >= 57.0
    assert marked.earned.cause == f"datum_{name}"


@pytest.mark.parametrize("number", [0, 2])
def test_a_datum_with_the_other_sign_costs_what_a_wrong_sign_costs_and_is_named_with_it(number):
    """Half of the table, as for a sign in an equation or of the whole drive: it was a wrong method's 0.4 for some data."""
    desk, sentences = variants()[number], {}
    for name in ("V1", "alpha", "p"):
        points, marked = desk.marked(Machine(desk.variant, data={name: -desk.variant.values[name]}).table())
        assert (points, marked.earned.worth) == (30, 0.5), name
        sentences[name] = " ".join(one.text for one in table_reasons(desk.key, marked, Rubric(), points, 60.0))
    assert "the drive has the other sign" in sentences.pop("V1")  # it is the same table
    for name, told in sentences.items():
        given = next(one for one in desk.variant.given if one.name == name)
        assert (
            f"the datum {name} was taken with the other sign: the velocities follow with {-given.value:.4g} {given.unit}" in told
        )


@pytest.mark.parametrize(("part", "told"), [(1.000008, False), (1.000012, True)])
def test_a_value_is_another_from_a_hundred_thousandth_on(part, told):
    desk = variants()[0]
    value = desk.variant.values["r1"]
    table = Machine(desk.variant, data={"r1": part * value}).table()
    printed = TableUnderTest(desk.key, StudentTable(table, np.full(table.shape, 1e-9)))
    found = {datum.name: read for datum, read in _values_read_off(printed)}
    assert [*found] == told * ["r1"]  # where no velocity says anything, none is left at a value where the search began
    assert not told or found["r1"] == pytest.approx(part * value, rel=1e-7)


@pytest.mark.long
@pytest.mark.parametrize("digits", [3, 5])
def test_a_datum_left_out_and_a_time_that_stands_still_are_named_with_any_digits(digits):
    """A phase without its value earned 0 with three digits and 24 with five: no value that velocities tell lies at nought."""
    at_nought = "the velocities follow with 0 rad."
    for number, name, code, told in (
        (0, "alpha", "datum_alpha", at_nought),
        (2, "alpha", "datum_alpha", at_nought),
        (0, "p", "time_still", "in the drive, time was left out, or the same time was used in every row."),
    ):
        desk = variants()[number]
        points, table = desk.marked(Machine(desk.variant, data={name: 0.0}).table(), digits=digits)
        said = " ".join(str(reason.text) for reason in table_reasons(desk.key, table, Rubric(), points, 60.0))
        assert table.misconception.code == code and f"datum_{name}" in codes(table) and told in said
        assert points == pytest.approx(24, abs=1.2)


@pytest.mark.long
def test_steps_taken_away_are_worth_what_a_wrong_sign_is_and_no_step_is_told_to_go_backwards():
    for desk in variants()[::2]:
        machine = desk.machine
        back = machine.table(lambda t, q, machine=machine: -machine.h * machine.velocities(t, q)[: machine.m])
        points, table = desk.marked(back, digits=5)
        assert points == 30 and "other_step" not in codes(table)


def test_a_slip_in_each_of_several_equations_is_no_one_thing_beside_columns_exchanged():
    """Each equation with the names of two velocities exchanged explains as much, and was told as one slip in the first."""
    desk = Desk(variant_of("cylinders"))
    table = desk.machine.table()
    places = desk.heads("om2", "om3")
    table[:, places] = table[:, places[::-1]]
    _, marked = desk.marked(table, digits=5)
    assert codes(marked) == ("swapped_columns",)


@pytest.mark.long
@pytest.mark.parametrize(("name", "term", "without", "frozen"), [
    ("18", "r3*w3*sin(phi3)", "0", "r3*w3*sin(START)"), ("1", "u1*cos(th1)", "0", "u1*cos(START)"),
    ("3", "rho1*om1*cos(th1)", "0", "START*om1*cos(th1)"),
])  # fmt: skip
def test_a_term_left_out_or_a_cell_that_a_formula_keeps_to_is_worth_what_a_sign_is(name, term, without, frozen):
    """An equation without a term, or with $A$2 in a spreadsheet, earned 10 to 19 of 60 where a turned sign earned 30."""
    variant = coursework.load("31") if name == "18" else variant_of("cylinders")
    desk, constraint = Desk(variant), {one.name: one for one in variant.constraints}[name]
    line = f"{spelled(constraint.left)} - ({spelled(constraint.right)})"
    place = {"18": 2, "1": 0, "3": 3}[name]
    points = []
    for other in (f"-{term}", without, frozen.replace("START", repr(float(desk.machine.start[place])))):
        found, table = desk.marked(Machine(variant, lines={name: line.replace(term, other, 1)}).table(), digits=5)
        assert f"equation_{name}" in codes(table)
        points.append(found)
    close(points)


@pytest.mark.long
def test_a_start_in_degrees_among_radians_is_a_wrong_start_in_radians():
    """Of one angle the number of degrees was put into radians: its column was read as degrees, and no cause was named."""
    for desk in variants():
        angles = [place for place, one in enumerate(desk.variant.coordinates) if one.unit == "rad"]
        for place in angles:
            start = desk.machine.start.copy()
            start[place] = round(np.degrees(start[place]))
            points, table = desk.marked(desk.machine.table(start=start))
            assert {column.unit for column in table.table.columns[: len(angles)]} == {"rad"}
            assert (points, codes(table)) == (57.0, (f"start_{desk.key.names[place]}",))


@pytest.mark.long
def test_a_neighbours_table_is_that_and_what_else_counts_is_no_second_cause():
    """Some cells would follow from another datum too, and earned points; what explains the table best earns none (4.3)."""
    desks = variants()[2:4]
    for mine, theirs in (desks, desks[::-1]):
        desk = Desk(mine.variant)
        desk.marker = Marker(desk.key, Rubric(), {"other": theirs.machine.table()})
        points, table = desk.marked(theirs.machine.table())
        assert (codes(table), table.earned.rule) == (("variant_other",), "cells")
        told = [reason.text for reason in table_reasons(desk.key, table, Rubric(), points, 60.0) if reason.kind == "cause"]
        assert told[0].endswith("the table belongs to another variant of the class.")
        assert len(told) == 1


@pytest.mark.long
def test_centimetres_or_kilometres_for_metres_are_another_datum_as_any_value_is():
    """No usual cause was found, and with the angles of a steady crank 20 points were left, with another value 24."""
    for desk, name, factor in zip(variants(), ("r2", "r1", "a", "r1", "r", "a"), 3 * (100.0, 0.001), strict=True):
        (found, table), (other, _) = (
            desk.marked(Machine(desk.variant, data={name: part * desk.variant.values[name]}).table()) for part in (factor, 1.09)
        )
        assert f"datum_{name}" in codes(table)
        close([found, other], near=1.2)


def test_all_starts_that_are_not_the_tasks_are_told_where_they_explain_a_part():
    """Angles counted from the start: all of them begin at nought, and only the first was told."""
    desk = variants()[0]
    table, m = desk.machine.table(), desk.machine.m
    table[:, :m] -= table[0, :m].copy()
    points, marked = desk.marked(table)
    assert (marked.earned.rule, codes(marked)) == ("start", ())
    told = [reason.text for reason in table_reasons(desk.key, marked, Rubric(), points, 60.0) if reason.kind == "cause"]
    (part, starts) = told[0].split(": ")
    assert part == "Part of the table follows from one thing" and len(told) == 1
    assert starts == "the table was made from start values of phi1, phi2 and phi3 other than the task’s."


@pytest.mark.parametrize("factor", [10, 0.1])
def test_a_column_ten_times_too_large_is_told_as_that_and_costs_the_same_in_every_column(factor):
    """A velocity so large was told as a wrong datum, an angle as nothing; the steps show that it is only printed so."""
    desk = variants()[0]
    for place, name in enumerate(desk.key.names):
        table = desk.machine.table()
        table[:, place] *= factor
        points, marked = desk.marked(table, digits=5)
        assert (points, codes(marked)[0]) == (57, f"column_slipped_{name}")
    carried = Machine(desk.variant, data={"r1": 0.1 * desk.variant.values["r1"]}).table()
    assert codes(desk.marked(carried)[1])[0] == "datum_r1"


def test_a_column_one_row_early_is_told_as_that():
    desk = variants()[2]
    table = desk.machine.table()
    table[:-1, desk.machine.m] = table[1:, desk.machine.m].copy()
    _, marked = desk.marked(table)
    assert codes(marked)[0] == f"row_below_{desk.key.velocities[0]}"
