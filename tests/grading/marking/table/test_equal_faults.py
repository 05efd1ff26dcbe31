"""Equal faults cost equal, whatever the data, the row, the notation and the equations handed in; each is named."""

from itertools import combinations

import numpy as np
import pytest

import coursework
from coursework.grading.marking.table.first_wrong import first_wrong
from coursework.grading.marking.table.starts import march
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import ALL, NEAR, Desk, close, codes, of_each, sign_faults, variants, with_a_steady_drive


@pytest.mark.long
@of_each
def test_a_mistyped_start_costs_the_same_in_every_coordinate_and_variant(numbers):
    points = []
    for desk in (variants()[number] for number in numbers):
        for place, name in enumerate(desk.key.coordinates):
            if desk.key.velocities[place] in desk.variant.known_rates and desk.key.velocities[place] == "w1":
                continue  # a driven crank turned further: as below, its rate does not feel the start
            for off in (0.1, -0.1) if len(numbers) == ALL else (0.1 * (-1) ** place,):
                start = desk.machine.start.copy()
                start[place] += off
                found, table = desk.marked(desk.machine.table(start=start))
                points.append(found)
                assert f"start_{name}" in codes(table)
                assert (table.earned.rule, table.earned.worth) == ("start", 0.95)
    close(points)
    assert max(points) <= 57.0


@pytest.mark.long
def test_a_mistyped_start_costs_the_same_in_a_chain_of_groups():
    """Its starts are computed, so none is exactly as it is printed; on the last one no velocity depends."""
    desk = Desk(coursework.load("whitworth"))
    begun = desk.key.table[0, : desk.machine.m]
    for place in range(1, len(begun)):
        table = march(desk.key, begun + 0.05 * (np.arange(len(begun)) == place), desk.key.velocities_at)
        found, marked = desk.marked(table)
        assert (found, marked.earned.rule) == (57, "start"), place
        assert repr(first_wrong(desk.key, marked.cells).sentence.values["expected"]) != "-0.0"  # phi4 begins at 0


@pytest.mark.long
def test_a_start_value_typed_wrong_and_not_used_is_one_cell():
    for desk in variants():
        table = desk.machine.table()
        table[0, 1] += 0.1
        found, marked = desk.marked(table)
        assert found == pytest.approx(60 - 60 / marked.points.cells, abs=0.01)


@pytest.mark.long
@of_each
def test_one_slip_costs_the_same_in_every_row(numbers):
    points = []
    for desk in [*(variants()[number] for number in numbers), with_a_steady_drive()]:
        m = desk.machine.m
        for row in (0, 1, 7, desk.machine.rows - 2):
            for place in range(m if row == 0 else 0, len(desk.key.names)):
                if desk.key.names[place] not in desk.variant.known_rates and ((row + place) % 2 == 0 or len(numbers) == ALL):
                    found, table = desk.marked(desk.machine.table(slip=(row, place, 0.15)))
                    points.append(found)
                    assert int(table.cells.wrong.sum()) == 1
    close(points)
    assert min(points) > 58


@pytest.mark.long
@pytest.mark.parametrize("where", [("drive",), ("geometry",), ("drive", "geometry"), ("radians",)], ids=str)
@of_each
def test_degrees_for_radians_cost_the_same_wherever_they_are(where, numbers):
    codes_of = {("drive",): "degree_drive", ("geometry",): "degree_geometry", ("radians",): "radian_mode"}
    code = codes_of.get(where, "degree_mode")
    for desk in (variants()[number] for number in numbers):
        machine = Machine(desk.variant, degrees=where)
        # Each row follows from what is printed of the row before: so wild a motion would show the last bit of the processor.
        found, table = desk.marked(machine.table(printed=lambda t, q, of=machine: of.velocities(t, q).round(4)))
        # Degrees in place of radians make so wild a motion that not every cell can show what it came from.
        assert found == pytest.approx(24, abs=1.2 if where == ("radians",) else 0.3)
        assert code in codes(table)


@pytest.mark.long
@of_each
def test_half_the_step_is_named_and_worth_the_same_however_the_rows_were_chosen(numbers):
    for desk in (variants()[number] for number in numbers):
        machine, h = desk.machine, desk.machine.h / 2
        fine = machine.table(step=h, rows=2 * machine.rows - 1)
        times = np.arange(len(fine)) * h
        ways = [
            (fine, {"times": times}), (fine[::2], {}),
            (fine[::2], {"with_time": False}), (fine[: machine.rows], {"with_time": False}),
        ]  # fmt: skip
        marked = [desk.marked(table, **how) for table, how in ways]
        assert all("other_step" in codes(table) for _, table in marked)
        close([found for found, _ in marked])
        # With times that end in the middle of the task, half of its rows are not there.
        found, table = desk.marked(fine[: machine.rows], times=times[: machine.rows])
        assert "other_step" in codes(table) and found == pytest.approx(marked[0][0] / 2, abs=NEAR)
        coarse = machine.table(step=2 * machine.h, rows=(machine.rows + 1) // 2)
        assert codes(desk.marked(coarse, times=np.arange(len(coarse)) * 2 * machine.h)[1]) == ("other_step",)


@pytest.mark.long
@pytest.mark.parametrize("number", [0, *(pytest.param(number, marks=pytest.mark.long) for number in range(1, 6))])
def test_steps_of_another_rule_are_worth_the_same_with_any_decimals(number):
    desk = variants()[number]
    machine, m, h = desk.machine, desk.machine.m, desk.machine.h

    def rate(t, q):
        return machine.velocities(t, q)[:m]

    tables = [
        machine.table(lambda t, q: h / 2 * (rate(t, q) + rate(t + h, q + h * rate(t, q)))),
        machine.table(step=h / 2, rows=2 * machine.rows - 1)[::2],
        machine.table(lambda t, q: h * rate(t + h, q)), machine.table(lambda t, q: h * rate(t - h, q)),
    ]  # fmt: skip
    close([desk.marked(table, digits=digits)[0] for table in tables for digits in (desk.key.least_decimals, 5)])


@pytest.mark.long
@pytest.mark.parametrize(("number", "names"), [(0, ("r1", "r3", "V1", "p", "alpha")), (4, ("r", "l", "w0"))])
def test_a_datum_of_any_other_value_is_named_and_worth_the_same(number, names):
    """It was worth nothing where every column feels it, and no cause was named."""
    desk = variants()[number]
    for datum in (datum for datum in desk.variant.given if datum.name in names):
        marked = [desk.marked(Machine(desk.variant, data={datum.name: part * datum.value}).table()) for part in (0.8, 1.13)]
        assert all(f"datum_{datum.name}" in codes(table) for _, table in marked)
        assert [float(table.misconception.names[0]) for _, table in marked] == pytest.approx(
            [part * float(datum.text) for part in (0.8, 1.13)], rel=1e-3
        )
        assert min(found for found, _ in marked) >= 56.5
        close([found for found, _ in marked])


@pytest.mark.parametrize(("number", "names"), [(0, ("r1", "p")), (4, ("l", "w0"))])
def test_one_number_copied_wrongly_costs_what_a_start_copied_wrongly_does(number, names):
    """A length cost 16.7 points of 60, a datum of the drive 36, more than another method, and a start 3."""
    desk = variants()[number]
    start = desk.machine.start.copy()
    start[-1] += 0.1
    tables = [desk.machine.table(start=start)]
    tables += [Machine(desk.variant, data={name: 1.1 * desk.variant.values[name]}).table() for name in names]
    close([desk.marked(table)[0] for table in tables], near=0.3)
    turned = Machine(desk.variant, data={names[-1]: -desk.variant.values[names[-1]]}).table()
    assert desk.marked(turned)[0] <= 30.3  # the other sign is a slip in a formula


@pytest.mark.long
@of_each
def test_exchanged_columns_are_named_both(numbers):
    for desk in (variants()[number] for number in numbers):
        names, m = desk.key.names, desk.machine.m
        like = [
            (first, second)
            for first, second in combinations(range(len(names)), 2)
            if (first < m) == (second < m) and desk.variant.unit_of(names[first]) == desk.variant.unit_of(names[second])
        ]
        # The last is an angle where the last velocity should stand; without `--long` every third of the others is asked.
        for first, second in [*like[:: 1 if len(numbers) == ALL else 3], (m - 1, len(names) - 1)]:
            order = list(range(len(names)))
            order[first], order[second] = second, first
            points, table = desk.marked(desk.machine.table()[:, order])
            assert (points, table.misconception.code) == (57, "swapped_columns")
            assert table.misconception.names == (names[first], names[second])


@pytest.mark.parametrize("place", [1, 2])
def test_exchanged_angles_are_named_with_one_of_them_a_turn_further(place):
    desk = variants()[0]
    table = desk.machine.table()[:, [0, 2, 1, *range(3, len(desk.key.names))]]
    table[:, place] += 2 * np.pi
    points, marked = desk.marked(table)
    assert (points, marked.misconception.code, marked.misconception.names) == (57, "swapped_columns", ("phi2", "phi3"))


@pytest.mark.long
@of_each
def test_a_row_too_many_or_too_few_costs_a_row(numbers):
    points = []
    for desk in [*(variants()[number] for number in numbers), with_a_steady_drive()]:
        machine = desk.machine
        right, long = machine.table(), machine.table(rows=machine.rows + 1)
        before = right[0].copy()
        before[: machine.m] -= machine.h * before[machine.m : 2 * machine.m]
        tables = [
            long[1:], np.vstack([right[:1], right])[: machine.rows], np.vstack([before, right])[: machine.rows],
            np.vstack([right[:9], right[8:]])[: machine.rows], np.vstack([long[:8], long[9:]]),
        ]  # fmt: skip
        for place, table in enumerate(tables):
            for with_time in (True, False) if len(numbers) == ALL else (place % 2 == 0,):
                found, marked = desk.marked(table, with_time=with_time)
                points.append(found)
                assert marked.misconception.code == "rows_shifted"
        points.append(desk.marked(np.vstack([right[:1], right]), with_time=False)[0])
    close(points)
    assert min(points) > 57


@pytest.mark.long
def test_an_angle_that_is_another_datum_is_told_without_whole_turns():
    """The velocities are those of 6.303 rad as well, but nobody typed that."""
    for name in ("31", "v102"):
        desk = Desk(coursework.load(name))
        found, marked = desk.marked(Machine(desk.variant, data={"alpha": 0.02}).table())
        assert (marked.misconception.code, marked.misconception.names) == ("datum_alpha", ("0.02", "rad"))
        assert found == pytest.approx(57, abs=0.3)


@pytest.mark.long
@of_each
def test_rows_elsewhere_are_told_as_that_and_cost_the_same(numbers):
    """Neither is another drive: rows from 4 on beside the first times cost those left out; any other order is a misconception."""
    for desk in [*(variants()[number] for number in numbers), with_a_steady_drive()]:
        right = desk.machine.table()
        late, marked = desk.marked(right[3:], with_time=False)
        assert (marked.misconception.code, late > 52) == ("rows_shifted", True)
        for order in (np.arange(len(right))[::-1], np.random.default_rng(3).permutation(len(right))):
            found, marked = desk.marked(right[order], with_time=False)
            assert (marked.misconception.code, found) == ("rows_order", pytest.approx(24, abs=0.3))
        mended = right[::-1].copy()
        mended[:6] = right[:6]
        mended[6, :2] = right[6, :2]
        assert desk.marked(mended, with_time=False)[0] >= found


def test_a_chain_of_groups_under_a_steady_drive_is_marked_like_the_others():
    """Its sines stand in no written equation, and behind a row that stands twice the next ones follow each other again."""
    desk = Desk(coursework.load("example-4"))
    begun = desk.key.table[0, : desk.machine.m]
    lines = {
        "x": "-r1*w1*sin(theta1) - u2*cos(theta3) + s2*w3*sin(theta3)",
        "y": "r1*w1*cos(theta1) - u2*sin(theta3) - s2*w3*cos(theta3)",
    }
    found, table = desk.marked(Machine(desk.variant, lines, degrees=("geometry",)).table(start=begun))
    assert found == pytest.approx(24, abs=0.3)
    assert codes(table)[0] == "degree_mode"
    long = Machine(desk.variant, lines).table(start=begun, rows=desk.machine.rows + 1)
    for shifted in (long[1:], np.vstack([long[:19], long[18:]])[: desk.machine.rows]):
        found, table = desk.marked(shifted)
        assert found > 57
        assert codes(table)[0] == "rows_shifted"


@pytest.mark.long
@of_each
def test_a_sign_in_an_equation_is_worth_the_same_with_any_equations_handed_in(numbers):
    points = []
    for desk in (variants()[number] for number in numbers):
        right = desk.machine.table()
        for constraint in desk.variant.constraints:
            for text in list(sign_faults(constraint))[: 2 if len(numbers) == ALL else 1]:
                table = Machine(desk.variant, lines={constraint.name: text}).table()
                if np.allclose(table, right):
                    continue  # the sign of nothing
                if not np.isfinite(table).all() or np.abs(table).max() > 1e3:
                    continue
                three = [desk.marked(table, equations=given) for given in ("right", None, {constraint.name: f"{text} = 0"})]
                assert len({found for found, _ in three}) == 1
                assert all(f"equation_{constraint.name}" in codes(marked) for _, marked in three)
                if three[0][1].earned.rule == "cells":
                    assert three[0][0] > 30  # the slip spoils few columns: those cells are what it costs
                elif three[0][1].earned.cause.startswith("sign_"):
                    assert (
                        three[0][0] == 57
                    )  # of a velocity of which nothing else is made: as if only its print had the other sign
                else:
                    points.append(three[0][0])
    assert len(points) > (3 if len(numbers) == ALL else 1) * len(numbers)
    close(points)


@pytest.mark.long
def test_a_drive_with_the_other_sign_is_named():
    points = []
    for desk in variants():
        found, table = desk.marked(Machine(desk.variant, drive_sign=-1.0).table())
        points.append(found)
        assert "sign_drive" in codes(table)
    close(points)


def test_right_tables_of_any_digits_are_right_and_nothing_is_named():
    for desk in variants():
        for digits in (2, 3, 4, 5, 6):
            if digits >= desk.key.least_decimals:
                found, table = desk.marked(desk.machine.table(), digits=digits)
                assert (found, codes(table)) == (60, ())
