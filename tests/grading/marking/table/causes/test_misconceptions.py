"""Misconceptions named with ground only, from tables that students' own formulas made."""

import re
from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes import misconceptions
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.closer import closer
from coursework.grading.marking.table.causes.hypotheses import claims
from coursework.grading.marking.table.causes.indistinct import indistinct
from coursework.grading.marking.table.causes.misconceptions import _Weighed, looked_for
from coursework.grading.marking.table.causes.other_data import may_be
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.explained import Explained, euler_cells
from tests.grading.marking import students
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.test_cells import printed
from tests.grading.marking.told import found_in
from tests.sample import diagonal, first


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


@pytest.mark.parametrize(("code", "decimals"), diagonal(3, students.MISCONCEPTIONS, (3, 4, 6)))
def test_each_is_named_or_tied(key, code, decimals):
    cells = mark_cells(key, printed(students.MISCONCEPTIONS[code](), decimals))
    assert looked_for(key, cells, 172)
    found = found_in(key, cells).named
    assert found is not None
    assert code in (found.code, *found.ties)
    assert found.share >= 0.93
    assert found.share > found.euler_share + 0.02


def test_whole_turns_that_were_taken_off_are_none_for_a_calculator_in_degrees(key):
    made = printed(Machine(key.variant, degrees=("drive", "geometry")).table(), 4)
    turns = np.zeros(made.values.shape)
    turns[5:22, :3] = 1  # as where a row between was put right
    for handed_in in (made, replace(made, values=made.values - 2 * np.pi * turns, turns=turns)):
        told = [one for one in claims(TableUnderTest(key, handed_in), {}, {}) if one.code == "degree_mode"]
        assert any((np.abs(handed_in.values - one.expected) <= one.tolerance)[:, 3:].all() for one in told)


def test_a_declared_confusion_is_named(key):
    table = students.table(printed=lambda t, q: students.velocities(t, q, alpha=0.02))
    cells = mark_cells(key, printed(np.where(np.abs(table) < 1e3, table, np.nan), 4))
    found = found_in(key, cells, {"alpha": 0.02}).named
    assert found is not None
    assert found.code == "confusion_alpha"


@pytest.mark.long
@pytest.mark.parametrize("seed", first(1, (7, 8, 9)))
def test_nothing_is_named_without_ground(key, seed):
    rng = np.random.default_rng(seed)
    for _ in range(7):
        table = students.table()
        rows, columns = rng.integers(1, 25, 12), rng.integers(0, 7, 12)
        table[rows, columns] *= rng.uniform(0.5, 0.9, 12)
        cells = mark_cells(key, printed(table, 4))
        assert looked_for(key, cells, 172)
        assert found_in(key, cells).named is None


def test_a_few_slips_are_no_misconception(key):
    cells = mark_cells(key, printed(students.slip(10, 1, 1.05), 4))
    assert not looked_for(key, cells, 172)


def test_another_variant_of_the_class(key):
    other = students.table(printed=lambda t, q: students.velocities(t, q, V1=4.1), start=(1.6, 3.37, 2.8))
    cells = mark_cells(key, printed(other, 4))
    found = found_in(key, cells, {}, {"12": other}).named
    assert found is not None
    assert "variant_12" in (found.code, *found.ties)


def test_the_other_assembly_of_written_equations(key):
    """M and y_C fix B and D, so the dyad r1, r2 between them is mirrored in the line that joins its ends."""
    chord = students.DATA["r1"] * np.exp(1j * students.START[0]) + students.DATA["r2"] * np.exp(1j * students.START[1])
    phi1, phi2 = (2 * np.angle(chord) - angle for angle in students.START[:2])
    cells = mark_cells(key, printed(students.table(start=(phi1, phi2, students.START[2])), 4))
    found = found_in(key, cells).named
    assert found is not None
    assert "branch" in (found.code, *found.ties)


def test_the_other_assembly_of_a_chain(tmp_path):
    text = coursework.load("example-1").path.read_text(encoding="utf-8")
    assert "mode" in text
    other = tmp_path / "other.toml"
    other.write_text(re.sub(r'mode( *)= "\+1"', r'mode\1= "-1"', text), encoding="utf-8")
    _, rows = coursework.solve(other, "euler", quantities=["table"]).columns()
    found = key_of(coursework.load("example-1"))
    rows[:, 2] += 2 * np.pi  # as the reader takes whole turns off
    cells = mark_cells(found, printed(rows, 5))
    assert cells.wrong[0].any()
    named = found_in(found, cells).named
    assert named is not None
    assert "branch" in (named.code, *named.ties)


@pytest.mark.long
@pytest.mark.parametrize("decimals", [2, 3, 4, 6])
def test_what_the_digits_cannot_tell_is_what_passes_as_right_when_a_student_makes_it(key, decimals):
    hidden = indistinct(key, np.full(7, 10.0**-decimals))
    made = {code: make() for code, make in students.MISCONCEPTIONS.items() if code != "swapped_columns"}
    for rounded in (1, 2, 3):
        if rounded < decimals:
            made[f"rounded_omega_{rounded}"] = students.table(
                lambda t, q, to=rounded: students.H * np.round(students.slopes(t, q), to)
            )
    for code, table in made.items():
        cells = mark_cells(key, printed(table, decimals))
        if cells.computed_to is not None:
            continue  # told, and taken for work that was computed coarser than it is printed
        explained, spoken = euler_cells(cells)
        share = explained.sum() / spoken.sum()
        if abs(share - 0.98) > 0.005:  # nearer to the limit it matters whether the rows are the task's or the student's
            assert (code in hidden) == (share >= 0.98), code


def test_a_hypothesis_that_the_digits_cannot_tell_is_not_named(key):
    cells = mark_cells(key, printed(students.MISCONCEPTIONS["sign_w1"](), 4))
    found = found_in(key, cells).named
    assert found is not None
    assert found.code == "sign_w1"
    assert found.ties == ()  # nor a length with the other sign, which no file may have
    assert found_in(key, cells, hidden=(found.code, "datum_r1", "equation_16")).named is None  # a slip in two


@pytest.mark.parametrize("name", ["31", "v107", "example-1", "homework", "watt"])
def test_a_value_that_a_file_may_not_have_is_no_cause(name):
    """Held against the reader of files: a datum with the other sign, or 0, is no cause where a length would not be positive."""
    key, refused = key_of(coursework.load(name)), 0
    for datum in key.variant.given:
        for value in (f"-{datum.text}".replace("--", ""), "0"):
            try:
                key.variant.with_data({datum.name: f"{value} {datum.unit}".strip()})
                expected = True
            except coursework.InputError as error:
                expected = not {"V308", "V087"} & {fault.code for fault in error.faults}
            assert may_be(key, f"datum_{datum.name}", (value, datum.unit or datum.si)) is expected, (datum.name, value)
            refused += not expected
        assert may_be(key, f"datum_{datum.name}", (datum.text.lstrip("-"), datum.unit or datum.si))
    assert refused
    assert may_be(key, f"datum_{datum.name}", ()) and may_be(key, "sign_w1", ("-1", "m"))


def test_causes_of_most_cells_data_read_off_and_rounded_velocities_are_held_against_the_whole_table():
    """Rounded velocities are worth most: a cause that comes to explain more must not keep them from being looked at."""
    counts = {"sign_w1": 9, "rounded_omega_2": 2, "heun": 8, "datum_r": 4, "rk4": 7, "midpoint": 6, "datum_l": 3, "datum_e": 1}
    held = {code: (count, SimpleNamespace(is_read_off=code[:5] == "datum"), None) for code, count in counts.items()}
    assert [code for code, *_ in closer(held)] == ["sign_w1", "heun", "rk4", "datum_r", "datum_l", "rounded_omega_2"]


@pytest.mark.parametrize(("holds", "how", "gains"), [
    ([True, True, False], {}, False), ([True, True, True], {}, True),
    ([True, True, False], {"is_whole": True}, True), ([True, True, False], {"student": "put back"}, True),
])  # fmt: skip
def test_a_claim_that_explains_no_cell_beyond_the_key_and_eulers_rules_is_no_cause(holds, how, gains):
    """At two decimals a step ten times too long was worth 38 points, the wrong equation that explained the table 30."""
    table = SimpleNamespace(
        explained=np.array([False, True, False]), gates=SimpleNamespace(by_key=np.array([True, False, False]))
    )
    claim = SimpleNamespace(**{"student": None, "is_whole": False} | how)
    assert _Weighed._gains(table, claim, np.array(holds)) is gains


@pytest.mark.parametrize(("put", "rows"), [((1, 0), [1, 2]), ((1, 1), [1, 2]), ((3, 0), [3, 4]), ((3, 1), []), ((4, 1), [4])])
def test_a_velocity_put_right_beside_an_angle_that_nothing_explains_excuses_no_row(put, rows):
    """The angle of row 4 is a misprint: what its velocity was made from is not told, as that is right by chance."""
    explained, given = np.ones((5, 2), dtype=bool), np.zeros((5, 2), dtype=bool)
    explained[3, 0], given[put] = False, True
    table = SimpleNamespace(key=SimpleNamespace(coordinates=("p",), m=1), spoken=np.ones((5, 2), dtype=bool), _rows=np.arange(5))
    assert np.flatnonzero(Explained._beside_put(table, given, explained)).tolist() == rows


@pytest.mark.parametrize(("start", "row", "elsewhere"), [
    ((1.63, 3.37, 2.87), None, False), ((1.73, 3.37, 2.87), None, True), ((1.73, 3.37, 2.87), 0.0, True),
    ((1.63, 3.37, 2.87), 9.0, True),
])  # fmt: skip
def test_a_table_begins_elsewhere_by_its_first_row_or_by_those_below(key, monkeypatch, start, row, elsewhere):
    """The first row was put right in the third; in the fourth nothing follows from it."""
    table, seen = students.table(start=start), []
    if row is not None:
        table[0] = key.table[0] + row
    weighed = misconceptions._Weighed
    monkeypatch.setattr(
        misconceptions, "_Weighed", lambda *args, **more: seen.append(more["elsewhere"]) or weighed(*args, **more)
    )
    misconceptions.explanations(key, mark_cells(key, printed(table, 4)), [])
    assert seen == [elsewhere]


@pytest.mark.parametrize("count", [3, 4, 5])
def test_what_was_made_from_cells_put_right_counts_whether_few_or_most_of_their_column_are(count):
    """It counted up to half of the column: with the next cell put right, all that stands beside the others was lost."""
    by_key, shown = np.zeros((8, 2), dtype=bool), np.ones((8, 2), dtype=bool)
    by_key[:count, 0] = True
    explained = shown.copy()
    explained[: count + 1, 1] = False
    table = SimpleNamespace(key=SimpleNamespace(coordinates=("p",), m=1), _rows=np.arange(8), spoken=shown, by_key=by_key)
    table._beside_put = partial(Explained._beside_put, table)
    assert (Explained._as_before(table, explained & ~by_key, explained) == ~explained).all()
