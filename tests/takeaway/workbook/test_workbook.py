"""`--format xlsx` and `run.to_excel`: cached numbers are the table, formulas give it again, also with other data."""

import csv
import io
import json
import zipfile

import numpy as np
import openpyxl
import pytest

import coursework
from coursework.takeaway.workbook.book import workbook_of
from coursework.variant.catalogue import names
from tests.command import call
from tests.equations.reduction.textbook.test_long_formulas import two_by_two
from tests.grading.reading.documents.test_right_work import graded
from tests.hard.scenes import scene, solve
from tests.mechanisms.library import mechanism
from tests.sample import sampled
from tests.solved import solved
from tests.takeaway.taken import taken
from tests.takeaway.workbook.evaluated import Evaluated, cached, opened, shown

SHEETS = ["Data", "Euler", "Exact", "Checks", "Graphs", "Read me"]
FILES = names()


def book(name, language="en"):
    return taken(name, "xlsx", language)["report.xlsx"]


def table(run):
    """The rows of Euler's table, time first."""
    return ["t", *(motion := run.scene.scheme_rows or run.motion).names], np.column_stack([motion.t, motion.rows])


def off(found, rows):
    return np.max(np.abs(found - rows) / np.maximum(1.0, np.abs(rows)), initial=0.0)


@pytest.mark.parametrize("name", sampled(FILES))
def test_cached_cells_and_formulas_are_eulers_table(name):
    heads, rows = table(solved(name))
    content = book(name)
    computed = opened(content)
    assert [computed.book["Euler"].cell(1, 1 + place).value for place in range(len(heads))] == heads
    assert computed.book.sheetnames == SHEETS
    assert off(cached(content, "Euler", *rows.shape), rows) < 1e-12
    assert off(computed.rows("Euler", *rows.shape), rows) < 1e-9
    assert all(cell.data_type == "f" for row in computed.book["Euler"].iter_rows(2, len(rows) + 1, 1, len(heads)) for cell in row)


def test_handed_in_it_is_the_table_of_the_task():
    grade = graded({"report.xlsx": book("31")})
    assert (grade.plain()["table"]["score"], [entry.code for entry in grade.work.notes]) == (60.0, ["ignored_file"])


def test_cells_show_seven_digits_and_hold_all():
    sheets = shown(book("31"))
    euler, checks = sheets["Euler"], sheets["Checks"]
    assert (euler["B3"].number_format, euler["H3"].number_format, euler["A3"].number_format) == (
        "0.000000",
        "0.00000",
        "0.0########",
    )
    assert repr(euler["B3"].value) == repr(float(solved("31").motion.rows[1, 0]))
    zero = next(row for row in range(3, 20) if checks.cell(row, 1).value == "largest")
    assert {checks.cell(zero + 3, column).number_format for column in (2, 3)} == {"0.00E+00;-0.00E+00;0"}
    assert min(euler.column_dimensions[letter].width for letter in "ABH") >= 12


@pytest.mark.parametrize("name", ["31", "jansen"])
def test_every_formula_of_every_sheet_gives_its_cached_number(name):
    content = book(name)
    computed, seen = opened(content), shown(content)
    count = 0
    for sheet in SHEETS[:4]:
        for row in computed.book[sheet].iter_rows():
            for cell in row:
                if cell.data_type == "f":
                    count += 1
                    found = computed.value(sheet, cell.row, cell.column)
                    assert found == pytest.approx(seen[sheet][cell.coordinate].value, rel=1e-9, abs=1e-9), (
                        sheet,
                        cell.coordinate,
                    )
    assert count > 500


def test_what_must_be_zero_stands_below_its_heads():
    """The head in the first column, times below it, as many as the table has rows; beside them the closure and the equations."""
    sheet = shown(book("31"))["Checks"]
    columns = [[cell.value for cell in column] for column in sheet.iter_cols()]
    (top,) = (place for place, text in enumerate(columns[0]) if str(text).startswith("What must be zero"))
    assert columns[0][top + 1 : top + 3] == ["t", "largest"] and columns[1][top] is None
    assert columns[0][top + 3 :] == pytest.approx([0.02 * row for row in range(25)])
    for column in columns[1:]:
        if column[top + 1] is not None:
            assert column[top + 2] == pytest.approx(max(map(abs, column[top + 3 :])))


@pytest.mark.parametrize(
    ("name", "change"), [("example-2-motor", {"step": 0.009, "r1": 0.39, "k": 40.0}), ("falling-arm", {"r1": 0.45, "phi2": 0.3})]
)
def test_rows_that_forces_move_are_formulas_over_named_masses(name, change):
    run = coursework.solve(name, end=0.06, quantities=["table"])
    heads, rows = table(run)
    content = workbook_of(run, "en")
    computed = Evaluated(content)
    assert off(cached(content, "Euler", *rows.shape), rows) < 1e-12 and off(computed.rows("Euler", *rows.shape), rows) < 1e-9
    sheet = computed.book["Euler"]
    given = {name: value for name, value in change.items() if name != "step"}
    other = coursework.solve(
        coursework.load(name).with_data(given=given, step=change.get("step")), end=0.06, quantities=["table"]
    )
    changed = Evaluated(content)
    for datum, value in change.items():
        changed.set({"step": "step", "phi2": "_phi2_0"}.get(datum, f"_{datum}"), value)
    others = table(other)[1][: len(rows)]
    assert off(changed.rows("Euler", *others.shape), others) < 1e-9
    assert all(cell.data_type == "f" for row in sheet.iter_rows(2, len(rows) + 1, 1, len(heads)) for cell in row)
    shown = {cell.value for cell in sheet[1] if not sheet.column_dimensions[cell.column_letter].hidden}
    assert {f"d{rate}" for rate in run.variant.motor.rates} | {*heads} <= shown and len(shown) <= len(heads) + 4
    guessed = [cell.value[:-1] for cell in sheet[1] if cell.value.endswith("′")]
    assert guessed == [head for head in heads if head in guessed]  # in the order of the file, in every process
    named = {mass.body for mass in solved(name).variant.forces.masses}
    assert {f"_m_{body}" for body in named} <= {*computed.book.defined_names}


CHANGES = {
    "31": {"step": 0.015, "_r1": 0.9, "_phi2_0": 3.3},
    "jansen": {"step": 0.008, "_k": 0.0615, "_phi1_0": 0.2},
    "robot-arm": {"_T": 0.25, "_r1": 0.51},
    "example-6": {"_theta1_0": 0.1},
    "prp": {"_psi_0": 1.1},
    "engine-start": {"_t1": 0.35, "_phi1_0": 4.6},
}


@pytest.mark.parametrize("name", CHANGES)
def test_changed_cells_give_the_run_with_these_data(name):
    computed, variant = Evaluated(book(name)), coursework.load(name)
    for cell, value in CHANGES[name].items():
        computed.set(cell, value)
    given = {cell.removeprefix("_").removesuffix("_0"): value for cell, value in CHANGES[name].items() if cell != "step"}
    step = CHANGES[name].get("step")
    run = coursework.solve(variant.with_data(given=given, step=step), scheme="euler", quantities=["table"])
    _, rows = table(run)
    rows = rows[: len(table(solved(name))[1])]
    assert off(computed.rows("Euler", *rows.shape), rows) < 1e-9


@pytest.mark.parametrize(
    ("name", "kinds"), [("jansen", {"RRR"}), ("engine-start", {"RRP"}), ("example-6", {"RPR", "RPP"}), ("prp", {"PRP"})]
)
def test_starts_that_follow_from_lengths_are_formulas_of_them(name, kinds):
    """A formula that does not give the start of the run is not taken: a number stands there then, which no datum moves."""
    computed, run = Evaluated(book(name)), solved(name)
    start = dict(zip(run.motion.coordinate_names, run.scene.start, strict=True))
    groups = [group for group in run.variant.groups if group.kind in kinds]
    assert {group.kind for group in groups} == kinds
    for coordinate in (coordinate for group in groups for coordinate in group.coordinates):
        sheet, _, cell = computed.names[f"_{coordinate}_0"].replace("$", "").partition("!")
        place = computed.book[sheet][cell]
        assert place.data_type == "f"
        assert computed.value(sheet, place.row, place.column) == pytest.approx(start[coordinate], abs=1e-9)


@pytest.mark.parametrize(("name", "scheme", "asked"), [
    ("robot-arm", "rk4", "table"), ("v104", "heun", "table"), ("variable-crank-table", "midpoint", "table"),
    ("31", "heun", "w2"), ("v102", "ralston", "w1"),  # all coordinates, not all velocities: no equation can be checked
])  # fmt: skip
def test_other_schemes_have_their_slopes_in_further_columns(name, scheme, asked):
    run = solved(name, scheme=scheme, quantities=[asked])
    _, rows = table(run)
    computed = Evaluated(workbook_of(run, "en"))
    assert off(computed.rows("Euler", *rows.shape), rows) < 1e-9
    assert any(run.scheme_title in str(row[0].value) for row in computed.book["Read me"].iter_rows(3, 10))


THREE = scene(
    'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "1 m", rate = "u" }\ny = { start = "0 m", rate = "w" }\n'
    'z = { start = "0.2 m", rate = "s" }',
    given='r = "0.1 m"', drive='v = "2"', end=0.2,
    equations=["u*cos(phi) + w*2 - s = r*v", "u + w*sin(phi) + s*3 = r*v*x/r", "u - 2*w + s*cos(x/r) = 0"],
)  # fmt: skip


@pytest.mark.parametrize(("text", "scheme"), [(THREE, "euler"), (THREE, "heun"), (two_by_two(5), "euler")])
def test_a_block_without_a_formula_is_solved_over_hidden_columns(text, scheme, monkeypatch):
    monkeypatch.setattr("coursework.equations.reduction.textbook.solution.MOST_LETTERS", 300)
    run = solve(text, scheme=scheme)
    assert () in run.solutions
    content = workbook_of(run, "en")
    computed = Evaluated(content)
    rows = np.column_stack([run.motion.t, run.motion.rows])
    assert off(computed.rows("Euler", *rows.shape), rows) < 1e-9
    assert off(cached(content, "Euler", *rows.shape), rows) < 1e-12
    sheet = computed.book["Euler"]
    texts = [cell.value for cell in sheet[2] if cell.value is not None]
    assert any("MINVERSE" in getattr(text, "text", "") for text in texts)
    assert any(one.hidden for one in sheet.column_dimensions.values())


def test_a_motion_that_stops_has_the_rows_before_its_dead_point():
    run = solved("31", quantities=["table"])
    stopped = coursework.solve(run.variant.with_data(given={"alpha": 0.02}), quantities=["table"])
    content = workbook_of(stopped, "en")
    _, rows = table(stopped)
    assert stopped.stop is not None and 1 < len(rows) < 10
    assert off(Evaluated(content).rows("Euler", *rows.shape), rows) < 1e-9


def test_names_differ_by_more_than_case_and_text_is_no_formula():
    text = scene(
        'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }',
        given='L = { value = "0.1 m", means = "=1+1" }\nl = { value = "0.2 m", means = "@sum" }', drive='v = "2"',
        end=0.2, equations=["u = v*(L*sin(phi) + l)"],
    )  # fmt: skip
    computed = Evaluated(workbook_of(solve(text), "en"))
    assert {"_L", "__l", "_phi_0", "_x_0", "step"} == set(computed.names)
    data = computed.book["Data"]
    assert [data.cell(row, 2).data_type for row in (4, 5)] == ["s", "s"]
    assert [data.cell(row, 2).value for row in (4, 5)] == ["=1+1", "@sum"]


def test_exact_has_the_true_motion_and_its_difference():
    content, run = book("jansen"), solved("jansen")
    exact = shown(content)["Exact"]
    assert [exact.cell(2, 1 + place).value for place in range(1, 4)] == pytest.approx(run.motion.rows[0, :3], rel=1e-15)
    names, first = run.motion.names, 3 + len(run.columns()[0])
    assert [exact.cell(1, first + place).value for place in range(len(names))] == [f"Δ{name}" for name in names]


@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_sheets_keep_their_names_in_every_language(language):
    content = book("31", language)
    read = openpyxl.load_workbook(io.BytesIO(content))
    assert read.sheetnames == SHEETS
    head = [cell.value for cell in read["Data"][3]][:6]
    assert (head[0] == "symbol") is (language == "en") and None not in head
    assert "Exact" in read["Read me"]["A3"].value  # the sheet that does not follow the data
    assert read["Checks"].print_title_rows == "$12:$12" and read["Checks"]["A12"].value == "t"  # on each page of the residuals
    with zipfile.ZipFile(io.BytesIO(content)) as packed:
        assert all(one.date_time[0] == 1980 for one in packed.infolist())
        assert len([name for name in packed.namelist() if "charts/chart" in name]) == 2


@pytest.mark.usefixtures("folder")
def test_it_is_written_on_request_only_and_listed(folder):
    for out in ("one", "two"):
        assert call("run", "31", "--quantities", "table", "--format", "csv,xlsx", "--out", out).exit_code == 0
    first, second = (json.loads((folder / out / "run.json").read_text(encoding="utf-8"))["files"] for out in ("one", "two"))
    assert first == second and {*first} == {"table.csv", "report.xlsx"}
    with (folder / "one/table.csv").open(encoding="utf-8") as file:
        rows = np.array([row for place, row in enumerate(csv.reader(file)) if place], dtype=float)
    assert off(cached((folder / "one/report.xlsx").read_bytes(), "Euler", *rows.shape), rows) < 1e-12
    assert "report.xlsx" not in coursework_files(folder)


def coursework_files(folder):
    assert call("run", "31", "--quantities", "table", "--out", "plain", "--no-live").exit_code == 0
    return {path.name for path in (folder / "plain").iterdir()}


@pytest.mark.usefixtures("folder")
def test_what_has_no_workbook_is_told_and_the_rest_written(folder, monkeypatch):
    told = call("run", "example-2-motor", "--scheme", "rk4", "--quantities", "table", "--format", "csv,xlsx", "--out", "motor")
    assert told.exit_code == 2 and "W044" in told.stderr and (folder / "motor/table.csv").is_file()
    told = call("run", "example-1", "--scheme", "euler", "--project", "--format", "csv,xlsx", "--out", "projected")
    assert told.exit_code == 2 and "W045" in told.stderr
    monkeypatch.setattr("coursework.system.extras.find_spec", lambda name: None)
    told = call("run", "31", "--quantities", "table", "--format", "csv,xlsx", "--out", "missing")
    assert told.exit_code == 2 and "-m pip install" in told.stderr and "[workbook]" in told.stderr


def test_a_tabulated_law_stands_beside_the_data_below_its_heads():
    data = openpyxl.load_workbook(io.BytesIO(book("variable-crank-table")))["Data"]
    heads, first, second = ([cell.value for cell in row][8:19] for row in data.iter_rows(1, 3))
    assert heads == ["r", *(f"{of}·u^{power}" for of in ("r", "r′") for power in range(5))]
    ((place, length), (following, longer)) = coursework.load("variable-crank-table").functions[0].table[:2]
    assert (first[:2], second[:2]) == ([pytest.approx(place), length], [pytest.approx(following), pytest.approx(longer)])


@pytest.mark.parametrize(("unit", "shown_unit"), [("60 rpm", "rad/s"), ("6.28 rad/s", "rad/s"), ("6.28 1/s", "1/s")])
def test_a_speed_of_turning_is_in_rad_and_the_sheet_beside_an_exact_table_is_eulers(unit, shown_unit):
    run = coursework.solve(coursework.parse_variant(mechanism("crank", w0=unit)), scheme="exact", quantities=["table"])
    made = openpyxl.load_workbook(io.BytesIO(workbook_of(run, "en")))
    assert [row[3].value for row in made["Data"].iter_rows() if row[4].value == unit] == [shown_unit]
    (euler,) = [row[0].value for row in made["Read me"].iter_rows() if str(row[0].value).startswith("Euler")]
    assert "exact" not in euler and "the step times its velocity there" in euler


def test_the_determinant_of_a_pair_has_the_sign_of_the_page():
    """The page of variant 31 shows Δ = r1·r2·sin(φ1 − φ2) and divides by it."""
    sheet = shown(book("31"))["Euler"]
    heads = {cell.value: cell.column for cell in sheet[1]}
    phi1, phi2, found = (sheet.cell(2, heads[name]).value for name in ("phi1", "phi2", "D3"))
    assert found == pytest.approx(0.953 * 0.847 * np.sin(phi1 - phi2), rel=1e-12)
