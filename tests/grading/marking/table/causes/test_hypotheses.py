"""What each hypothesis expects is what a program of its own makes with that slip: cell by cell, and as a whole table."""

import math

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes import hypotheses
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.ways import StudentTable
from tests.grading.marking import students
from tests.grading.marking.students import ROWS, START, H, slopes, table, velocities
from tests.grading.marking.table.test_cells import printed

DEGREE = math.pi / 180


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


def implicit(new):
    """Steps with this part of the velocities of their end, the rest of those of their begin."""

    def increment(t, q):
        found = np.zeros(3)
        for _ in range(400):
            found = H * ((1 - new) * slopes(t, q) + new * slopes(t + H, q + found))
        return found

    return table(increment)


def rows_above():
    """Velocities of time and angles of the row above, printed and stepped with; the first row has its own."""
    q, rows, before = np.array(START), [], None
    for k in range(ROWS):
        own = velocities(k * H, q)
        before, used = own, own if before is None else before
        rows.append(np.concatenate([q, used]))
        q = q + H * used[:3]
    return np.array(rows)


def early():
    """Velocities of the row below; angles step with those printed in the row above."""
    right = table()
    return np.vstack([np.hstack([right[:-1, :3], right[1:, 3:]]), np.full(7, np.nan)])


def small(times):
    """Each step of the task in so many."""

    def increment(t, q):
        moved = q
        for k in range(times):
            moved = moved + H / times * slopes(t + k * H / times, moved)
        return moved - q

    return table(increment)


def new_angles():
    """w4, and w1 and w2 from it, by the angle phi3 of the next row already."""

    def own(t, q):
        w3 = velocities(t, q)[2]
        moved = q + np.array([0, 0, H * w3])
        w4 = 2 * w3 * (math.cos(moved[2]) - 2 * math.sin(moved[2]))
        return np.array([*_solved(moved, w3, w4), w3, w4])

    return table(printed=own)


def _solved(q, w3, w4):
    """w1 and w2 from w3 and w4 at some angles."""
    d, (phi1, phi2, phi3) = students.DATA, q
    matrix = np.array([[d["r1"] * np.sin(phi1), d["r2"] * np.sin(phi2)], [d["r1"] * np.cos(phi1), d["r2"] * np.cos(phi2)]])
    right = [0.5 * d["r3"] * w4 - d["r3"] * w3 * np.cos(phi3), d["r3"] * w3 * np.sin(phi3)]
    return np.linalg.solve(matrix, right)


def signed(place):
    found = table()
    found[:, place] *= -1
    return found


def above(place):
    found = table()
    found[1:, place] = found[:-1, place].copy()
    found[0, place] = np.nan
    return found


MADE = {
    **{code: students.MISCONCEPTIONS[code] for code in (
        "heun", "midpoint", "rk4", "step_ahead", "step_behind", "row_before", "in_place", "time_ahead", "time_behind",
    )},
    "trapezoid": lambda: implicit(0.5), "backward": lambda: implicit(1.0), "rows_above": rows_above,
    **{f"rounded_omega_{k}": lambda k=k: table(lambda t, q: H * np.round(slopes(t, q), k)) for k in (1, 2, 3)},
    "degree_steps": lambda: table(lambda t, q: H * DEGREE * slopes(t, q)), "new_phi": new_angles,
    **{f"sign_w{k}": lambda k=k: signed(2 + k) for k in (1, 2, 3, 4)},
    **{f"row_above_w{k}": lambda k=k: above(2 + k) for k in (1, 2, 3, 4)},
    "omega_late": students.late, "omega_early": early,
}  # fmt: skip
SILENT = {"omega_late", "omega_early", "new_phi", *(f"row_above_w{k}" for k in (1, 2, 3, 4))}  # make no table of their own


def families(under):
    yield from hypotheses._schemes(under)
    yield from hypotheses._shifted_rows(under)
    yield from hypotheses._steps(under)
    yield from hypotheses._velocities(under, ())


def asked(claim, values):
    """Return of how many cells a claim speaks, and in which part of them a table has what it says."""
    with np.errstate(invalid="ignore"):
        off = np.abs(values - claim.expected) / claim.tolerance
    spoken = np.isfinite(off)
    return int(spoken.sum()), float(np.mean(off[spoken] <= 1.0))


@pytest.mark.long
@pytest.mark.parametrize("code", MADE)
def test_a_slip_is_expected_as_it_is_made(key, code):
    values = MADE[code]()
    claims = [one for one in families(TableUnderTest(key, printed(values, 6))) if one.code == code]
    claim = claims[0]  # of a scheme the one with the times of its stages
    count, share = asked(claim, np.round(values, 6))
    if code not in {"time_ahead", "time_behind"}:  # of them nothing is said of the steps
        assert count >= 23 * (1 if code.startswith(("sign", "row_above")) else 3)
    assert share >= (0.9 if code == "backward" else 0.98)  # of some rows repetition finds no end
    right = asked(claim, np.round(table(), 6))[1]
    assert right < 0.75
    assert (claim.table is None) is (code in SILENT)
    if claim.table is not None:
        made = claim.table()
        assert np.nanmax(np.abs(made - values) / np.maximum(1, np.abs(values))) < 1e-6


def test_whole_tables_made_with_the_velocities_of_the_row_before(key):
    assert hypotheses._of_rows_above(key) == pytest.approx(rows_above(), abs=1e-9)
    assert hypotheses._from_rows_before(key) == pytest.approx(students.MISCONCEPTIONS["row_before"](), abs=1e-9)


@pytest.mark.parametrize("part", [0.1, 0.5, 2.0, 10.0, 1.5, 0.75])
def test_a_step_of_another_length_is_read_off_the_table(key, part):
    """1.5 and 0.75 are no usual ones: they are read off, to two digits, 0.03 s and 0.015 s."""
    values = table(lambda t, q: part * H * slopes(t, q))
    claims = [one for one in hypotheses._steps(TableUnderTest(key, printed(values, 6))) if one.code == "other_step"]
    mine = [one for one in claims if one.part == pytest.approx(part)]
    assert mine[0].names == (f"{part * H:.4g}",) and asked(mine[0], np.round(values, 6))[1] >= 0.98
    assert np.abs(mine[0].table() - values).max() < 1e-5
    assert {one.part for one in claims} == {0.1, 0.5, 2.0, 10.0, part}


def test_as_many_small_steps_as_one_may_have_been_made_for_it(key):
    for times in (2, 10):
        values = small(times)
        claims = hypotheses._steps(TableUnderTest(key, printed(values, 6)))
        mine = [one for one in claims if one.code == "other_step" and one.part == 1 / times]
        shares = [asked(one, np.round(values, 6))[1] for one in mine]
        assert max(shares) >= 0.98 and np.abs(mine[shares.index(max(shares))].table() - values).max() < 1e-9


def test_times_of_another_step_are_those_of_velocities_too(key):
    """Row n has the time n/2 of the task's: both, the steps and the velocities, are half."""
    q, rows = np.array(START), []
    for k in range(ROWS):
        rows.append(np.concatenate([q, velocities(k * H / 2, q)]))
        q = q + H / 2 * rows[-1][3:6]
    values = np.array(rows)
    mine = [one for one in hypotheses._steps(TableUnderTest(key, printed(values, 6))) if one.part == 0.5]
    both = [one for one in mine if np.isfinite(one.expected[:, 3:]).any()]
    assert [asked(one, np.round(values, 6))[1] >= 0.98 for one in both] == [True]
    assert np.abs(both[0].table() - values).max() < 1e-9


@pytest.mark.parametrize(("decimals", "offered"), [(1, set()), (2, {1}), (3, {1, 2}), (4, {1, 2, 3})])
def test_velocities_printed_with_so_many_decimals_were_not_rounded_to_them(key, decimals, offered):
    claims = hypotheses._steps(TableUnderTest(key, printed(table(), decimals)))
    assert {int(one.code[-1]) for one in claims if one.code.startswith("rounded")} == offered


H2 = H / 2
MADE_OF = {  # which velocities a step is made of: rows from that of the step on, and with how much of each
    "trapezoid": {0: H2, 1: H2}, "backward": {1: H}, "row_before": {-1: H}, "omega_late": {1: H}, "omega_early": {-1: H},
    "rounded_omega_1": {}, "degree_steps": {0: H * DEGREE},
}  # fmt: skip


@pytest.mark.parametrize("code", MADE_OF)
def test_digits_leave_a_step_open_as_those_of_what_it_is_made_of(key, code):
    """Half a digit of both coordinates and of the velocities as they enter, and 2e-4 of the step; cells have their own digits."""
    values = table()
    units = 10.0 ** -np.random.default_rng(5).uniform(2.5, 4.5, values.shape)
    (claim,) = (one for one in families(TableUnderTest(key, StudentTable(values, units))) if one.code == code)
    assert np.isnan(claim.expected[0, :3]).all()
    for row in range(2, ROWS - 2):
        size = np.maximum(np.abs(values[row - 1, 3:6]), 0.05 * key.usual_ranges[3:6])
        entering = sum((part * units[row - 1 + by, 3:6] for by, part in MADE_OF[code].items()), np.zeros(3))
        open_by = 0.505 * (units[row, :3] + units[row - 1, :3] + entering) + 2e-4 * H * size
        assert claim.tolerance[row, :3] == pytest.approx(open_by)
