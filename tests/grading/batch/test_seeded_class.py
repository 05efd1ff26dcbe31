"""A class with known slips and misconceptions, from files to grades.json: what was put in is found in every dialect."""

import json

import numpy as np
import pytest
from click.testing import CliRunner

from coursework.commands.cli import main
from tests.grading.batch.classroom import EQUATIONS, NAMES
from tests.grading.batch.in_this_process import in_this_process
from tests.grading.marking import students
from tests.grading.marking.seeded import SEED, visible_slip
from tests.sample import first

DIALECTS = ((";", ","), (",", "."), ("\t", "."))


def hand_in(folder, table, digits, separator, mark):
    rows = [separator.join(("t", *NAMES))]
    for k, row in enumerate(table):
        rows.append(separator.join([f"{0.02 * k:.2f}", *(f"{value:.{digits}f}" for value in row)]).replace(".", mark))
    folder.mkdir()
    (folder / "table.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "equations.txt").write_text("\n".join(EQUATIONS), encoding="utf-8")


@pytest.fixture(scope="module", params=first(1, (3, 1)))
def marked(request, tmp_path_factory):
    """Return what was put in and what grades.json says, by id."""
    root = tmp_path_factory.mktemp("seeded")
    (root / "in").mkdir()
    rng = np.random.default_rng(SEED)
    truth = {}
    for number, (code, table) in enumerate(students.MISCONCEPTIONS.items()):
        digits = 3 + number % 3
        if (number // 3 + number) % request.param:  # of each dialect the same number
            continue
        hand_in(root / "in" / code, table(), digits, *DIALECTS[number % 3])
        truth[code] = "", code
        slipped, (row, column) = visible_slip(rng, digits)
        hand_in(root / "in" / f"slip{number}", slipped, digits, *DIALECTS[number % 3])
        truth[f"slip{number}"] = f"row {row + 1} {NAMES[column]}", ""
        hand_in(root / "in" / f"right{number}", students.table(), digits, *DIALECTS[number % 3])
        truth[f"right{number}"] = "", ""
    with in_this_process():
        done = CliRunner().invoke(main, ["grade", str(root / "in"), "--variant", "31", "--out", str(root / "out")])
    assert done.exit_code == 0, done.output
    text = (root / "out" / "grades.json").read_text(encoding="utf-8")
    return truth, {entry["id"]: entry for entry in json.loads(text)["submissions"]}


@pytest.mark.long
def test_slips_are_blamed_in_their_cell_and_in_no_other(marked):
    truth, found = marked
    slips = {name: cell for name, (cell, _) in truth.items() if cell}
    assert {name: found[name]["table"]["first_wrong"] for name in slips} == slips
    assert {found[name]["table"]["wrong_cells"] for name in slips} == {1}


@pytest.mark.long
def test_what_is_right_has_full_points(marked):
    truth, found = marked
    assert {found[name]["score"] for name in truth if name.startswith("right")} == {100.0}


def test_misconceptions_are_named_or_tied_and_nothing_else_is(marked):
    truth, found = marked
    for name, (_, code) in truth.items():
        named = found[name]["misconception"]
        codes = [named["code"], *named["ties"]] if named else []
        assert code in codes if code else not codes, (name, codes)
