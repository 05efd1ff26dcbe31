"""What a misprinted cell was, told by what was made from it: with w = 2 p, u = 4 p or 2 w, later w = sin p, u = cos p."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table.before import guesses as told_by
from coursework.grading.marking.table.before import restored as search
from coursework.grading.marking.table.before.guesses import _begun, _open_by, agreed, guesses, makers_of_several
from coursework.grading.marking.table.ways import HALF, OwnWays, StudentTable, Way
from tests.grading.marking.table.before.test_made import KEY, NAN

STRAIGHT = np.array([[p, 2 * p, 4 * p] for p in (1, 1.2, 1.44, 1.728, 2.0736)])
ROUND = np.array([[p, math.sin(p), math.cos(p)] for p in (8.0, 8.1, 8.2, 8.3)])
SIMPLE = SimpleNamespace(**{**vars(KEY), "t": np.arange(5.0)})
TURNING = SimpleNamespace(**{**vars(KEY), "velocities_at": lambda t, q: np.hstack([np.sin(q), np.cos(q)]),
    "block_at": lambda index, t, q, w: {1: np.sqrt(1 - w[:, :1] ** 2)}[index]})  # fmt: skip


def seen(key, cells, tolerance=0.01):
    """Return a key with a table, a student's with some other `cells`, and its ways."""
    table = STRAIGHT if key is SIMPLE else ROUND
    key = SimpleNamespace(**{**vars(key), "table": table, "ranges": np.ptp(table, axis=0), "usual_ranges": np.ptp(table, axis=0)})
    values = table.copy()
    for place, value in cells.items():
        values[place] = value
    return key, StudentTable(values, np.full(values.shape, 1e-4)), ways_of(key, values, tolerance)


def ways_of(key, values, tolerance=0.01):
    """Return what each cell follows from, worked out by hand."""
    p, w, _ = values.T
    none, rates = np.full(len(p), NAN), key.velocities_at(key.t, p[:, None])
    later = key.block_at(1, key.t, p[:, None], np.column_stack([w, w]))[:, 0]

    def way(name, *columns):
        expected = np.column_stack(columns)
        return Way(name, expected, np.where(np.isnan(expected), NAN, tolerance))

    steps = [np.append(NAN, (p + 0.1 * rate)[:-1]) for rate in (w, rates[:, 0])]
    return OwnWays(
        way("angles", none, *rates.T), way("earlier", none, none, later),
        *(way(name, step, none, none) for name, step in zip(("step", "true"), steps, strict=True)), None, 0.0,
    )  # fmt: skip


def flags(*places, rows=5):
    found = np.zeros((rows, 3), dtype=bool)
    for place in places:
        found[place] = True
    return found


def told(tables):
    """Return what each table tells, by place."""
    return [{(int(r), int(c)): float(one[r, c]) for r, c in np.argwhere(np.isfinite(one))} for one, _ in tables]


@pytest.mark.parametrize(("w", "u", "found"), [
    (2.4, 4.8, 1.2), (2.4008, 4.799, 1.19975), (2.42, 4.822, (2 * (1.21 - 0.003842) + 1.2055 + 0.0013411) / 3),
    (2.38, 4.778, (2 * (1.19 + 0.003838) + 1.1945 - 0.0013389) / 3),
])  # fmt: skip
def test_a_misprinted_angle_is_what_its_velocities_say_where_all_agree(w, u, found):
    """7 is printed; by w it is w/2 to 0.00384, by u it is u/4 to 0.00134, the more exact, by the row above 1.2 to 0.01.

    Tolerances are 0.01 for what 7 makes, 14 and 28; for smaller ones less by 2e-4 of the difference: (0.01 - 2e-4 (14 - w))/2.
    What the most exact cell says is taken, but from the middle third of where they agree.
    """
    key, was, own = seen(SIMPLE, {(1, 0): 7.0, (1, 1): w, (1, 2): u})
    ((_, units),) = tables = agreed(key, was, own, flags((1, 1), (1, 2)), flags((1, 0)))
    assert told(tables) == [{(1, 0): pytest.approx(found, abs=1e-8)}]
    low, high = max(w / 2 - 0.00384, u / 4 - 0.00134), min(w / 2 + 0.00384, u / 4 + 0.00134)
    assert HALF * units[1, 0] == pytest.approx(min(found - low, high - found), abs=2e-5)  # it may have been any of these


@pytest.mark.parametrize(("w", "is_told"), [(2.4 + 0.0099, True), (2.4 + 0.0107, False)])
def test_what_only_one_cell_says_is_not_believed(w, is_told):
    """By u 1.2 to 0.00134; by w farther off than 0.00384 + 0.00134 it says something else; the row above says 1.3."""
    key, was, own = seen(SIMPLE, {(0, 0): 1.1, (1, 0): 7.0, (1, 1): w, (1, 2): 4.8})
    assert bool(agreed(key, was, own, flags((1, 1), (1, 2)), flags((1, 0)))) is is_told
    assert agreed(key, was, own, flags((1, 2)), flags((1, 0))) == []
    assert agreed(key, was, own, flags(), flags((1, 0))) == [] == agreed(key, was, own, flags((1, 1), (1, 2)), flags())


def test_a_velocity_is_what_the_later_one_and_the_next_step_say():
    """Of w = 24 for 2.4 in row 2: u = 4.8 and the step to 1.44 say 2.4, as the angle does; so of its row it was."""
    key, was, own = seen(SIMPLE, {(1, 1): 24.0})
    (one,) = told(agreed(key, was, own, flags((1, 2), (2, 0)), flags((1, 1))))
    assert one == {(1, 1): pytest.approx(2.4, abs=1e-6)}
    missing = replace(was, values=was.values.copy())
    missing.values[2, 0] = NAN
    assert told(agreed(key, missing, own, flags((2, 0)), flags((1, 1)))) == []


@pytest.mark.parametrize("printed", [80.0, -8.1, 1.8, 9.5])
def test_an_angle_is_found_from_anywhere_in_the_turn_of_the_task(printed):
    """sin and cos tell 8.1 but for whole turns; sin alone 3 pi - 8.1 too, where the cosine is another."""
    key, was, own = seen(TURNING, {(1, 0): printed})
    (one, *_) = told(agreed(key, was, own, flags((1, 1), (1, 2), rows=4), flags((1, 0), rows=4)))
    assert one == {(1, 0): pytest.approx(8.1, abs=1e-6)}


def test_rows_from_which_several_wrong_cells_are_made():
    assert makers_of_several(flags((0, 1), (1, 0), (2, 1), (3, 0), (4, 1), (4, 2)), 1).tolist() == [
        True,
        False,
        True,
        False,
        True,
    ]
    assert makers_of_several(flags((0, 1), (1, 1)), 1).tolist() == [False] * 5


def values_of(key, was, own, wrong, other, untold):
    return [{(int(r), int(c)): float(one.values[r, c]) for r, c in np.argwhere(one.values != was.values)}
            for one in guesses(key, was, own, wrong, other, untold)]  # fmt: skip


def test_guesses_are_the_next_row_what_cells_agree_on_and_what_the_rows_above_make():
    """7 for 1.2 in row 2: back from 1.44 with 2.4 it was 1.2, its velocities say too; by row 1 it was 1.2."""
    key, was, own = seen(SIMPLE, {(1, 0): 7.0})
    wrong, other = flags((1, 1), (1, 2)), flags((1, 0))
    about = {(1, 0): pytest.approx(1.2)}
    assert values_of(key, was, own, wrong, other, flags((1, 0))) == [about] * 5  # of all columns, and of the one coordinate
    assert values_of(key, was, own, wrong, other, flags()) == [about] * 3
    assert values_of(key, was, own, flags((1, 1)), other, flags((1, 0))) == [about] * 2


def test_with_what_follows_from_a_velocity_and_without(monkeypatch):
    monkeypatch.setattr(told_by, "own_ways", lambda key, table, coarse: ways_of(key, table.values))
    key, was, own = seen(SIMPLE, {(1, 1): 24.0, (1, 2): 48.5})
    found = values_of(key, replace(was, values=np.where(was.values == 48.5, 4.8, was.values)), own, flags((1, 2), (2, 0)),
        flags((1, 1), (1, 2)), flags())  # fmt: skip
    assert {(1, 1): pytest.approx(2.4, abs=1e-6)} in found


def test_where_most_rows_are_wrong_only_cells_that_are_the_tasks_may_be_others():
    """Velocities of rows 1 to 3 are wrong: of 5 rows 3 make several wrong cells.  Then the task's own 1.2 was put right."""
    doubled = {(row, column): 2 * float(STRAIGHT[row, column]) for row in (0, 1, 2) for column in (1, 2)}
    key, was, own = seen(SIMPLE, doubled)
    wrong, other = flags(*doubled), flags(*((row, 0) for row in range(5)))
    few = key, was, own, flags((0, 1), (0, 2), (1, 1), (1, 2)), other, flags()
    assert any((0, 0) in one for one in values_of(*few))
    found = values_of(key, was, own, wrong, other, flags())
    assert found == []  # more than half of the column is the task's: nothing says that it was another
    for row in (2, 3, 4):
        was.values[row, 0] += 0.5
    key, was, own = seen(SIMPLE, {**doubled, **{(row, 0): float(STRAIGHT[row, 0]) + 0.5 for row in (2, 3, 4)}})
    found = values_of(key, was, own, wrong, other, flags())
    assert {(1, 0): pytest.approx(2.4)} in found and not any((0, 0) in one or (2, 0) in one for one in found[1:])


def by_hand(monkeypatch, start, cells, *, put=()):
    """Return what is found of a table that began at `start` where the task begins at 1, with some other `cells` or the task's.

    A cell is wrong that follows from nothing and is not the task's, right any other.
    """
    monkeypatch.setattr(search, "own_ways", lambda key, table, coarse: ways_of(key, table.values))
    key, was, _ = seen(SIMPLE, {})
    values = start * STRAIGHT
    for place, value in cells.items():
        values[place] = value
    for place in put:
        values[place] = STRAIGHT[place]
    own = ways_of(key, values)
    is_right = own.holds(values) | (np.abs(values - STRAIGHT) < 1e-3)
    is_right[0, 0] = True
    found = search.restored(key, replace(was, values=values), ~is_right, is_right, own)
    made = np.any([way.holds(values) for way in found.ways], axis=0)
    wrong, fitted = ({(int(r), int(c)) for r, c in np.argwhere(one)} for one in (~is_right & ~made, found.fitted))
    changes = {} if found.before is None else {
        (int(r), int(c)): float(found.before.values[r, c]) for r, c in np.argwhere(np.abs(found.before.values - values) > 1e-9)
    }  # fmt: skip
    return wrong, fitted, changes


def test_a_table_without_slips_is_as_it_stands(monkeypatch):
    assert by_hand(monkeypatch, 1.1, {}) == (set(), set(), {})


def test_a_misprint_costs_its_own_cell_only(monkeypatch):
    """7 for 1.32 in row 2: its velocity 2.64 and the step to 1.584 follow from 1.32, which the row above makes."""
    assert by_hand(monkeypatch, 1.1, {(1, 0): 7.0}) == ({(1, 0)}, set(), {(1, 0): pytest.approx(1.32, abs=1e-3)})


def test_a_cell_put_right_costs_nothing(monkeypatch):
    """1.2 for 1.32, the task's: what was made from 1.32 is right as before."""
    wrong, fitted, changes = by_hand(monkeypatch, 1.1, {}, put=[(1, 0)])
    assert (wrong, fitted, changes) == (set(), set(), {(1, 0): pytest.approx(1.32, abs=1e-3)})


def test_a_velocity_that_is_a_misprint_is_told_by_what_follows(monkeypatch):
    """24 for 2.64 in row 2: u = 5.28 follows from the angle, the step to 1.584 from it in the second way; 26.4 is the slip."""
    wrong, _, _ = by_hand(monkeypatch, 1.1, {(1, 1): 24.0})
    assert wrong == {(1, 1)}


def test_a_step_that_was_wrong_when_it_was_made_is_one_slip(monkeypatch):
    """Row 3 was 2.0 for 1.584 and was put right to 1.44; its velocities 4 and 8 and the step to 2.4 say what it was.

    That 2.0 follows from nothing: of the three cells that tell it one is the slip that it was.
    """
    later = {(row, column): value * 1.2 ** (row - 2) for row in (2, 3, 4) for column, value in ((0, 2.0), (1, 4.0), (2, 8.0))}
    wrong, fitted, changes = by_hand(monkeypatch, 1.1, later, put=[(2, 0)])
    assert wrong == set() and changes == {(2, 0): pytest.approx(2.0, abs=1e-3)}
    assert len(fitted) == 1 and fitted <= {(2, 1), (2, 2), (3, 0)}
    wrong, fitted, changes = by_hand(monkeypatch, 1.1, later)
    assert (wrong, fitted, changes) == ({(2, 0)}, set(), {})


def test_a_cell_is_begun_to_be_looked_for_near_its_neighbours_as_the_next_row_has_it_and_an_angle_all_around():
    printed = np.array([[1.0, 3, 5], [80.0, 9, 5], [1.5, 4, 5], [NAN, 7, 5]])
    key = SimpleNamespace(**{**vars(KEY), "table": np.array([[0.0] * 3, [1.2, 2.4, 0], [0.0] * 3, [2.0, 6.0, 0]])})
    row, place, by = np.array([1, 1, 3, 3, 2]), np.array([0, 1, 0, 1, 0]), np.array([0, 4, 4, 3, 4])
    begun, again = _begun(key, printed, row, place, by)
    middle = [1.2, 3.0, NAN, 6.0, NAN]  # of 1, 1.2, 1.5; of 3, 2.4, 4; none; of 4, 6, 7; none: there what is printed is meant
    middle[2], middle[4] = NAN, 1.5
    below = [1.5, 3.0, NAN, 6.0, 1.5]
    assert begun[:10] == pytest.approx([*middle, *below], nan_ok=True)
    assert begun[10:] == pytest.approx([1.2 + k * math.pi / 4 for k in range(1, 8)])
    assert again.tolist() == [0, 1, 2, 3, 4] * 2 + [0] * 7


def test_larger_velocities_are_left_the_more_open_and_smaller_ones_less():
    """Tolerance 0.01; least sizes 0.05 of the ranges 20 and 40: 1 and 2.  What is expected: 4 and -8, then 0.5 and 0."""
    key = SimpleNamespace(coordinates=("p",), m=1, usual_ranges=np.array([9.0, 20.0, 40.0]))
    way = Way("own", np.array([[1.0, 4.0, -8.0], [1.0, 0.5, 0.0]]), np.full((2, 3), 0.01))
    found = _open_by(key, way, np.array([[5.0, -6.0, 3.0], [NAN, 0.1, -5.0]]))
    assert found == pytest.approx(np.array([[0.01, 0.015, 0.01 - 2e-4 * 5], [0.01, 0.01, 0.025]]))
