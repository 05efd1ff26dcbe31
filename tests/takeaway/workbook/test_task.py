"""`assign --format xlsx`: data and an empty table for everybody, the formulas left to the student."""

import openpyxl
import pytest

from coursework.variant.catalogue import load
from tests.assigning.test_assign import assigned
from tests.command import call

ROSTER = "id,name,email\nada,Ada,\n"


def book(folder, *more, template="31"):
    out = assigned(folder, ROSTER, "--format", "xlsx", *more, template=template)
    variant = load(out / "ada.toml")
    return variant, openpyxl.load_workbook(out / "workbooks/ada.xlsx")


def test_everybody_gets_own_data_and_an_empty_table(tmp_path):
    variant, read = book(tmp_path)
    assert read.sheetnames == ["Data", "Euler"]
    values = {read["Data"].cell(row, 6).value: read["Data"].cell(row, 3).value for row in range(4, read["Data"].max_row + 1)}
    assert {name: values[f"_{name}"] for name in variant.values} == pytest.approx(variant.values, rel=1e-15)
    assert values["_phi1_0"] == variant.coordinates[0].start
    assert [[cell.value for cell in row] for row in read["Euler"].iter_rows()] == [["t", *variant.columns]]


def test_help_fills_the_first_row(tmp_path):
    variant, read = book(tmp_path, "--help-level", "1")
    rows = list(read["Euler"].iter_rows())
    assert len(rows) == 2 and [cell.value for cell in rows[0]][: 1 + len(variant.columns)] == ["t", *variant.columns]
    assert rows[1][1].value == "=_phi1_0" and "SIN" in rows[1][6].value


@pytest.mark.parametrize("level", ["0", "1"])
def test_starts_that_the_geometry_gives_are_left_to_the_student_without_help(tmp_path, level):
    _, read = book(tmp_path, "--help-level", level, template="homework")
    data = read["Data"]
    found = {data.cell(row, 6).value: data.cell(row, 3).value for row in range(4, data.max_row + 1)}
    assert ("ATAN2" in str(found["_theta2_0"])) is (level == "1")
    if level == "0":
        assert found["_theta2_0"] is None
        # 10 degrees of the crank, as the file has it: whoever changes the speed changes the step with it
        assert found["step"].replace(" ", "") == "=2*PI()/(36*_w0)"
        assert not [cell for row in data.iter_rows() for cell in row if "ATAN2" in str(cell.value) or "SQRT" in str(cell.value)]


def test_a_missing_package_is_told_before_the_first_file(tmp_path, monkeypatch):
    monkeypatch.setattr("coursework.system.extras.find_spec", lambda name: None)
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    options = ("--template", "31", "--seed", "1", "--format", "xlsx", "--out", tmp_path / "out")
    told = call("assign", tmp_path / "roster.csv", *options)
    assert told.exit_code == 2 and "[workbook]" in told.stderr and not (tmp_path / "out/ada.toml").exists()
