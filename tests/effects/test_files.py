"""The files of a run with forces: heads, blanks, what run.json and the plan say; a file without forces has nothing of it."""

import csv
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import coursework
from coursework.commands.cli import main
from coursework.effects.draft import with_forces
from coursework.report.text.parts import Panels, Table
from coursework.report.text.words import load_words
from tests.commands.test_cli import call
from tests.effects.test_ways import PARALLEL
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, solved

HEAD_31 = (
    "t,R01x,R01y,R12x,R12y,R23x,R23y,R34x,R34y,T04,N04,FMx,FMy,S1.ax,S1.ay,e1,S2.ax,S2.ay,e2,S3.ax,S3.ay,e3,S4.ax,S4.ay,e4,F_path"
)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def read(name):
    return [*csv.reader(Path("out", name).read_text(encoding="utf-8").splitlines())]


def test_forces_and_energy_as_the_contract_says(folder):
    assert call("run", "31-forces", "--format", "csv", "--out", "out").exit_code == 0
    head, *rows = read("forces.csv")
    assert ",".join(head) == HEAD_31
    assert len(rows) == 25
    head, *rows = read("energy.csv")
    assert head == ["t", "T", "potential", "P_drive", "P_loads", "P_friction", "P_dampers"]
    assert {row[4] for row in rows} == {"0.0"}
    said = json.loads(Path("out/run.json").read_text(encoding="utf-8"))
    assert said["forces"]["largest"] == {"name": "N04", "row": 21, "value": pytest.approx(1472.54, abs=0.01)}
    assert max(said["forces"]["agreement"].values()) < 1e-13
    told = {check["code"]: check["sentence"] for check in said["checks"]}
    assert told["FORCE-ACCURACY"].startswith("Row 20 asks for FMy = -1254 N where the mechanism needs -2564 N")
    exact = coursework.solve("31-forces", scheme="exact")
    contact = next(str(check.sentence) for check in exact.checks if check.code == "CONTACT")
    assert contact.startswith("In 11 of 25 rows the rail would have to pull") and "from -266 to 2846 N" in contact


@pytest.mark.parametrize(("changes", "told"), [
    ([(', centre = "C + 0.05 @ (psi + 0.3)"', ""), ('gravity = "9.81 m/s^2"', "")], "In row 1 nothing presses the wheel"),
    ([("R*psi", "psi*R")], "The contact presses in every row"),
])  # fmt: skip
def test_a_wheel_that_nothing_presses_is_told_and_its_files_are_written(folder, changes, told):
    """Without weight N is 0 in every row, so |T|/N is no number; such a run was refused as a fault of the tool."""
    Path("wheel.toml").write_text(mechanism("wheel-on-a-rail", *changes), encoding="utf-8")
    done = call("run", "wheel", "--quantities", "table,checks,forces", "--format", "csv", "--out", "out")
    assert done.exit_code == 0, done.output
    (contact,) = [
        one for one in json.loads(Path("out/run.json").read_text(encoding="utf-8"))["checks"] if one["code"] == "CONTACT"
    ]
    assert contact["sentence"].startswith(told) and (contact["value"] is None) == told.startswith("In row")


def test_what_is_not_unique_is_empty(folder):
    Path("p.toml").write_text(PARALLEL, encoding="utf-8")
    assert call("run", "p", "--quantities", "forces", "--format", "csv", "--out", "out").exit_code == 0
    head, *rows = read("forces.csv")
    assert rows[3][head.index("R01x")] == ""
    assert float(rows[3][head.index("M")])
    said = json.loads(Path("out/run.json").read_text(encoding="utf-8"))
    assert "R01x" in said["forces"]["not_unique"] and "M" not in said["forces"]["not_unique"]


def test_the_plan_says_which_effects_are_on(folder):
    told = call("run", "example-1-forces", "--plan").stdout
    effects = told[told.index("Effects of forces:") :]
    assert "inertia              on: named in [masses]; a row: forces 3, couples 3" in effects
    assert "loads                on: named in [forces]; a row: forces 1, couples 1" in effects
    assert "springs              off: not named in [forces]" in effects
    assert "9 equations of 3 links with 9 unknown forces" in effects
    assert "Effects" not in call("run", "example-1", "--plan").stdout
    friction = '[friction]\nC = { coefficient = "0.1" }\n\n[ask]'
    Path("moved.toml").write_text(mechanism("example-2-motor", ("[ask]", friction)), encoding="utf-8")
    moved = call("run", "moved", "--plan").stdout
    assert "friction             on: named in [friction]; the row is solved again in each of at most 2000 rounds" in moved
    assert "motor                on: named in [motor]; free accelerations of a slope: 1" in moved


def test_a_file_without_forces_imports_nothing_of_them(tmp_path):
    code = f"import sys\nfrom {main.callback.__module__} import main\n"
    code += "try:\n    main(['run', '31', '--format', 'csv', '--out', 'out'])\nexcept SystemExit:\n    pass\n"
    code += "print('|'.join(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, check=True)
    modules = done.stdout.splitlines()[-1].split("|")
    assert [name for name in modules if "effects" in name or name.endswith((".forces", ".mass_units"))] == []


def test_forces_of_a_file_that_names_none_are_refused():
    with pytest.raises(coursework.InputError, match="names no masses") as told:
        coursework.solve("31", quantities=["forces", "energy"])
    assert len(told.value.faults) == 1


@pytest.mark.parametrize("arguments", [(), ("--groups", "crank,RPR,RRP"), ("--from", "31"), ("--from", "v107")])
def test_new_with_forces_runs_as_it_is(folder, arguments):
    assert call("new", "mine", "--with", "forces", *arguments).exit_code == 0
    run = coursework.solve("mine")
    assert "forces" in run.asked
    assert {check.verdict for check in run.results.force_checks} <= {"PASS", "SKIP", "COARSE"}


@pytest.mark.parametrize("law", ["variable-crank", "variable-crank-table"])
def test_new_with_forces_writes_no_file_that_a_run_refuses(law, folder):
    refused = call("new", "mine", "--with", "forces", "--from", law)
    assert refused.exit_code == 2
    told = "mine.toml would be refused, so it is not written: point A does not stand still in the axes of link 1:"
    assert told in refused.stderr and "Leave --with forces out." in refused.stderr
    assert not list(folder.iterdir())


def test_new_with_something_else_is_refused(folder):
    assert call("new", "mine", "--with", "masses").exit_code == 2
    assert call("new", "mine", "--with", "forces", "--from", "31-forces").exit_code == 2
    assert not Path("mine.toml").exists()


def test_a_motion_of_no_rows_has_tables_of_no_rows_and_no_error():
    text = mechanism("31-forces", ('start = "2.87 rad"', 'start = "2.0344439357957027 rad"'))
    results = coursework.solve(coursework.parse_variant(text), quantities=["forces", "energy"]).results
    assert len(results.forces.table) == 0
    assert not [check.code for check in results.force_checks if check.verdict == "ERROR"]


@pytest.mark.parametrize(("start", "rows"), [("2.0344439357957027 rad", 0), ("2.03 rad", 1)])
def test_a_motion_of_no_row_or_one_is_written_in_every_way(folder, start, rows):
    """Plans of velocities, levers of forces and the workbook ended in an error of the tool."""
    Path("own.toml").write_text(mechanism("31-forces", ('start = "2.87 rad"', f'start = "{start}"')), encoding="utf-8")
    asked = "table,plots,checks,forces,energy,accelerations,points,plans,hodographs,trajectories,graph_check,flowchart"
    told = call("run", "own", "--scheme", "rk4", "--quantities", asked, "--format", "html,csv,xlsx", "--out", "out")
    assert told.exit_code == 1 and "Stopped (dead point)" in told.stdout
    for name in ("table", "forces", "polygons"):
        assert (len(read(f"{name}.csv")) - 1 > 0) == (rows > 0)
    assert "<h2" in Path("out/report.html").read_text(encoding="utf-8") and Path("out/report.xlsx").stat().st_size > 5000


def test_units_of_forces_are_said_in_the_language_of_the_page():
    said = [load_words("ru").unit(unit) for unit in ("N*m", "kg·m²", "J", "N*s/m")]
    assert said == ["Н·м", "кг·м²", "Дж", "Н·с/м"]
    assert load_words("zh").unit("N*m") == "N·m"


@pytest.mark.parametrize(
    ("asked", "then"),
    [
        ('["table", "energy"]', '["table", "energy", "forces"]'), ("[]", '["forces", "energy"]'),
        ('["table",]', '["table", "forces", "energy"]'),
    ],
)  # fmt: skip
def test_a_copy_with_forces_asks_for_each_once(asked, then):
    text = re.sub(r"quantities = .*", f"quantities = {asked}", mechanism("example-1"))
    made = with_forces(coursework.parse_variant(text), text, str)
    assert f"quantities = {then}" in made
    assert coursework.parse_variant(made).forces is not None


def test_the_page_says_energies_in_words_what_the_lines_of_a_graph_are_and_has_no_time_on_a_polar_curve():
    sections = {section.name: section.parts for section in model_of(solved("31-forces"), "ru").sections}
    (table,) = (part for part in sections["energy"] if isinstance(part, Table))
    assert [column.head[0]["t"] for column in table.columns[2:]] == ["кинетическая", "потенциальная", "движущие силы"]
    assert "нагрузки, трение и демпферы" in str(sections["energy"][-1])
    drive, *polar = (part for part in sections["forces"] if isinstance(part, Panels))
    assert len(drive.legend) == 2 and all("data-time" in panel.svg for panel in drive.items)
    assert polar and not any("data-time" in panel.svg for one in polar for panel in one.items)
    for panel in polar[0].items:  # the motion bends between the rows, which are dots over it
        smooth, rows, dots = re.findall(r'<path [^>]*d="([^"]*)"', panel.svg)[-3:]
        assert "c" in smooth and "c" not in rows and dots.count("h0") == 25
