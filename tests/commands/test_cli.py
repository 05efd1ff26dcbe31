"""The command line: exit status, files, bytes, and sentences for everything that can be typed wrongly."""

import json
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

import coursework
from coursework.commands.cli import main
from coursework.commands.line import versions
from coursework.results.checks.check import CHECKS
from coursework.system.extras import installed_from
from coursework.variant.catalogue import entries
from tests.command import call
from tests.mechanisms.library import mechanism

pytestmark = pytest.mark.usefixtures("folder")
PAGE = (Path(__file__).parents[1] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
QUICK = ["--quantities", "table,checks", "--format", "csv"]


def process(*arguments, **environment):
    """Run the command in a process of its own; return the finished process."""
    command = [sys.executable, "-m", "coursework", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, env={**os.environ, **environment}, check=False)


# ---- exit status


def test_zero_where_all_passed(folder):
    done = process("run", "31", *QUICK)
    assert (done.returncode, done.stderr) == (0, b"")
    told = done.stdout.decode().splitlines()
    assert told[0] == (
        "The table is computed right: 5 of 5 checks of the computation; the start is not judged. It is not close to the motion: "
        "largest error 69.8 % of 0.2 rad (phi1, row 20); take --step h/18."
    )
    assert told[1:3] == ["Rolling wheel, right-angled link, crank and rod  (31)", "explicit Euler, h = 0.02 s, 25 rows"]
    assert done.stdout.decode().endswith("Written to coursework-31: table.csv, run.json\n")
    assert sorted(path.name for path in (folder / "coursework-31").iterdir()) == ["run.json", "table.csv"]


def test_one_where_the_motion_stops(folder):
    Path("dead.toml").write_text(PAGE.replace('"4.35 rad"', '"0.02 rad"'), encoding="utf-8")
    result = call("run", "dead.toml", *QUICK)
    assert result.exit_code == 1
    assert "6 rows" in result.stdout
    assert "Stopped (dead point): At t = 0.116889 s" in result.stdout
    record = json.loads(Path("coursework-dead/run.json").read_text(encoding="utf-8"))
    assert record["stop"]["kind"] == "dead point"
    assert record["stop"]["time"] == pytest.approx(0.116889254610302411, abs=1e-8)
    assert record["stop"]["block"] == ["w3"]
    assert record["rows"] == 6
    assert len(Path("coursework-dead/table.csv").read_text(encoding="utf-8").splitlines()) == 7
    checked = call("check", "dead.toml")
    assert checked.exit_code == 1
    assert "is possible for" in checked.stdout.splitlines()[-1]  # with which phases it would go through
    assert call("accuracy", "dead.toml").exit_code == 1


def test_one_where_a_check_fails(folder):
    Path("wrong.toml").write_text(PAGE.replace('"2*pi/p"', '"0.40 s"'), encoding="utf-8")
    result = call("run", "wrong.toml", *QUICK)
    assert result.exit_code == 1
    assert "✗ FAIL   PERIOD-POSITION" in result.stdout
    assert Path("coursework-wrong/table.csv").exists()


def test_a_coarse_step_is_a_failure_only_where_one_asks_for_it():
    assert call("run", "31", "--step", "0.04", *QUICK).exit_code == 0
    strict = call("run", "31", "--step", "0.04", "--strict", *QUICK)
    assert strict.exit_code == 1
    assert "≈ COARSE ACCURACY" in strict.stdout
    assert call("run", "31", "--scheme", "rk4", "--strict", *QUICK).exit_code == 0


@pytest.mark.parametrize("step", ["h/18", " h / 18 ", "2h/36"])
def test_a_step_may_be_a_part_of_the_files_own(step):
    result = call("run", "31", "--step", step, "--strict", *QUICK)
    assert result.exit_code == 0, result.output
    record = json.loads(Path("coursework-31/run.json").read_text(encoding="utf-8"))
    assert record["step"] == 0.02 / 18
    assert record["rows"] == 24 * 18 + 1


def test_three_where_the_tool_cannot_judge(monkeypatch):
    def broken(_evidence):
        raise RuntimeError("by us")

    monkeypatch.setattr("coursework.results.checks.check.CHECKS", (replace(CHECKS[0], judge=broken), *CHECKS[1:]))
    result = call("run", "31", *QUICK)
    assert result.exit_code == 3
    assert "! ERROR  STOP" in result.stdout
    assert "✓ PASS   RESIDUAL" in result.stdout


WRONG = {
    "no variant": (["run", "nosuch"], 'there is no variant "nosuch" in the catalogue and no file "nosuch.toml" in this folder.'),
    "closest variant": (["run", "v10"], 'Did you mean "v110"? "coursework variants" lists them.'),
    "closest variant of check": (["check", "exampel-1"], 'Did you mean "example-1"?'),
    "no file": (["run", "x/y.toml"], "x/y.toml  the file cannot be read: there is no such file."),
    "folder": (["check", "."], "this is a folder. Name the file in it."),
    "scheme": (["run", "31", "--scheme", "eulr"], 'there is no scheme "eulr". Did you mean "euler"? Schemes: euler, midpoint'),
    "step": (
        ["run", "31", "--step", "abc"],
        'a step in seconds, such as 0.02, or a part of the file’s step, such as h/4, was expected, found "abc".',
    ),
    "step zero": (["run", "31", "--step", "0"], "the step must be a finite time greater than 0, found 0 s."),
    "step nan": (["run", "31", "--step", "nan"], "the step must be a finite time greater than 0, found nan s."),
    "step infinite": (["run", "31", "--step", "inf"], "the step must be a finite time greater than 0, found inf s."),
    "too many rows": (["run", "31", "--step", "4.8e-10"], "1e+09 rows are asked for; at most 200000 are computed."),
    "end before step": (["run", "31", "--end", "0.001"], "the end (0.001 s) must be at least one step (0.02 s)."),
    "end nan": (["run", "31", "--end", "nan"], "the end must be a number of seconds, found nan."),
    "error text": (["run", "31", "--error", "abc"], "C057 --error takes a number."),
    "budget zero": (["run", "31", "--budget", "0"], "C059 --budget takes a number greater than 0."),
    "budget nan": (["run", "31", "--budget", "nan"], "C059 --budget takes a number greater than 0."),
    "jobs zero": (["run", "31", "--jobs", "0"], "C055 --jobs takes a number of at least 1."),
    "help level": (["assign", "roster.csv", "--help-level", "5"], "C056 --help-level takes a number from 0 to 1."),
    "no value": (["run", "31", "--step"], "C098 --step needs a value behind it."),
    "no path": (["run", "31", "--templates", "--out", "a"], "C098 --templates needs a value behind it."),
    "a value of a switch": (["run", "31", "--no-live=5"], "C099 --no-live takes no value: write it alone."),
    "in another language": (["run", "31", "--language", "ru", "--out"], "C098 после --out нужно значение."),
    "language with =": (["run", "31", "--language=zh", "--stepp"], "C051 没有选项 --stepp。"),
    "end text": (["run", "31", "--end", "abc"], "C012 the end must be a number of seconds, found 'abc'."),
    "end in metres": (["run", "31", "--end", "0.2 m"], "C012 the end must be a number of seconds, found '0.2 m'."),
    "aliasing": (["run", "31", "--step", "0.3"], "The step 0.3 s is too large for this drive"),
    "format": (["run", "31", "--format", "rtf"], '"rtf" is not a format here. Formats: html, pdf, csv'),
    "format closest": (["run", "31", "--format", "htm"], 'Did you mean "html"?'),
    "quantity": (["run", "31", "--quantities", "tabel"], 'there is no quantity "tabel". Did you mean "table"?'),
    "column": (["run", "31", "--quantities", "phi4"], 'there is no quantity "phi4". Did you mean "phi3"?'),
    "column and whole": (["run", "31", "--quantities", "phi3,points"], '"points" needs every coordinate, not only what phi3'),
    "no crank": (["run", "31", "--quantities", "analogs", "--format", "csv"], "analogs and invariants need one driven crank"),
    "projection": (["run", "31", "--quantities", "phi3", "--project"], "the projection needs every coordinate"),
    "gain": (["run", "31", "--gain", "1000"], "multiplies the position error by -19 every step"),
    "gain nan": (["run", "31", "--gain", "nan"], "Take a gain between 0 and 100 1/s"),
    "gain and projection": (
        ["run", "31", "--gain", "1", "--project"],
        "choose either the projection or Baumgarte’s gain, not both.",
    ),
    "auto without wish": (["run", "31", "--step", "auto"], "--step auto needs the wish: --error 0.001"),
    "wish without auto": (["run", "31", "--error", "0.1"], "--error is a wish for --step auto"),
    "precision": (["run", "31", "--precision", "quad"], 'C054 --precision takes one of "double" or "single".'),
    "no argument": (["run"], "C052 VARIANT is missing."),
    "no option": (["run", "31", "--nope"], "C051 there is no option --nope."),
    "no command": (["rnu"], 'C053 there is no command "rnu". Did you mean "run"?'),
    "new name of the catalogue": (
        ["new", "V102"],
        '"V102" is a variant of the catalogue, and a file of that name would stand for it in this folder.',
    ),
    "copy of nothing": (["new", "mine", "--from", "v10"], 'there is no variant "v10" in the catalogue'),
    "new name": (["new", "a/b"], '"a/b" cannot be the name of a file here: one word of letters, digits, _ and -, at most 60,'),
    "new device": (["new", "con"], '"con" cannot be the name of a file here'),
    "ending": (["run", "31.toml"], 'no file "31.toml" in this folder. Did you mean "31"?'),
    "word before the number": (["run", "вариант31"], 'no file "вариант31.toml" in this folder. Did you mean "31"?'),
}


@pytest.mark.parametrize("case", WRONG)
def test_two_where_the_input_is_wrong(case, folder):
    arguments, sentence = WRONG[case]
    result = call(*arguments)
    assert result.exit_code == 2
    assert sentence in result.stderr
    assert "Traceback" not in result.output
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize(("ends", "twice"), [(("R", "S"), True), (("R", "R"), False)])
def test_a_hinge_with_two_names_is_told_where_the_freedoms_do_not_agree(ends, twice):
    links = "".join(
        f'{place} = {{ points = ["{a}", "{b}"] }}\n' for place, (a, b) in enumerate(("OP", ("P", ends[0]), ("Q", ends[1])), 1)
    )
    Path("own.toml").write_text(
        f'{mechanism("four-bar-by-its-points")}[links]\n{links}[frame]\nhinges = ["O", "Q"]\n', encoding="utf-8"
    )
    told = call("check", "own.toml").stdout
    assert (
        ("R and S are in the same place throughout." in told)
        == twice
        == ("but 1 freedom is driven. The equations determine every velocity, so [links] and [frame] leave out a pair" in told)
    )


def test_what_forces_move_is_not_called_driven_nor_its_motion_refined():
    crank, arm = call("check", "example-2-motor").stdout, call("check", "falling-arm").stdout
    assert "2 equations, drives: 0\nForces move the mechanism; w1 is free.\n" in crank
    assert "Forces move the mechanism; w1, w2 are free." in arm and "refined scheme" not in arm


def test_three_where_the_tool_is_at_fault(monkeypatch):
    def broken(*_args, **_options):
        raise RuntimeError("something of ours")

    monkeypatch.setattr("coursework.commands.check.variant_of", broken)
    result = call("check", "31")
    assert result.exit_code == 3
    assert "Traceback" in result.stderr
    assert "RuntimeError: something of ours" in result.stderr
    assert result.stderr.endswith("This is a fault of the tool, not of your file. Please report it with the lines above.\n")


# ---- the other commands and options


@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_variants_lists_the_catalogue(language):
    result = call("variants", "--language", language)
    assert result.exit_code == 0
    for entry in entries(language):
        assert f"{entry.name} " in result.stdout
        assert entry.title in result.stdout
    assert (entries(language)[0].title == coursework.load("31").title) == (language == "en")


def test_check_shows_blocks_and_whether_the_motion_is_possible():
    result = call("check", "31")
    assert result.exit_code == 0
    for line in (
        "4 unknown velocities (w1, w2, w3, w4), 4 equations",
        "W = 3·4 − 2·5 − 0 = 2",
        "    w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))",
        "The whole motion, 0 to 0.48 s, is possible: no dead point.",
    ):
        assert line in result.stdout


def test_plan_computes_nothing(folder):
    result = call("run", "31", "--plan", "--quantities", "table")
    assert result.exit_code == 0
    assert "  motion               needed by table" in result.stdout
    assert "  accelerations        only for point_accelerations, forces and plans, not asked for" in result.stdout
    assert list(folder.iterdir()) == []
    restricted = call("run", "31", "--plan", "--quantities", "phi3", "--format", "csv")
    assert restricted.stdout.splitlines()[-1] == "In each row: the velocities (w3); left out: (w4) and (w1, w2)."


def test_profile_counts_calls():
    result = call("run", "31", "--profile", *QUICK)
    lines = result.stdout.split("quantity              calls      ms\n")[1].splitlines()
    assert {line.split()[0]: int(line.split()[1]) for line in lines}["motion"] == 1


def test_options_change_the_run():
    result = call(
        "run", "31", "--scheme", "heun", "--step", "0.01 s", "--end", "100 ms", "--quantities", "table", "--format", "csv"
    )
    assert "Heun, h = 0.01 s, 11 rows" in result.stdout
    projected = call("run", "31", "--project", "--quantities", "table", "--format", "csv", "--out", "p")
    assert projected.exit_code == 0
    assert Path("p/table.csv").read_bytes() != Path("coursework-31/table.csv").read_bytes()


@pytest.mark.parametrize("name", ["run", "check", "variants", "new", "accuracy"])
def test_help(name):
    result = call(name, "--help")
    assert result.exit_code == 0
    assert main.commands[name].help.split("\n")[0][:40] in " ".join(result.stdout.split())


def test_version():
    assert call("--version").stdout == f"coursework, version {coursework.__version__}\n"


def test_what_is_installed_of_each_extra_and_how_to_install_what_is_not(monkeypatch):
    real = versions.version
    monkeypatch.setattr(versions, "version", lambda name: real("there-is-no-such-package" if name == "ezdxf" else name))
    first, *lines = call("--versions").stdout.splitlines()
    assert first.startswith(f"coursework {coursework.__version__}, Python 3.")
    told = dict(line.split(maxsplit=1) for line in lines)
    assert told["dxf"] == f"not installed: ezdxf. Type: {sys.executable} -m pip install {installed_from('dxf')}"
    assert told["workbook"] == f"XlsxWriter {real('XlsxWriter')}"
    assert re.fullmatch(r"starlette [\d.]+, uvicorn [\d.]+, watchfiles [\d.]+", told["desk"])
    monkeypatch.setenv("COURSEWORK_LANGUAGE", "ru")
    assert "dxf       не установлено: ezdxf." in call("--versions").stdout


def test_every_command_is_in_the_readme():
    text = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    assert [name for name in main.commands if f"coursework {name}" not in text] == []


@pytest.mark.parametrize("options", [("--step", "auto", "--error", "0.01"), ("--precision", "single")])
def test_one_where_the_motion_stops_before_a_step_can_be_chosen(options, tmp_path):
    file = tmp_path / "stops.toml"
    file.write_text(PAGE.replace('"4.35 rad"', '"0.02 rad"'), encoding="utf-8")
    result = call("run", file, *options)
    assert result.exit_code == 1
    assert result.stdout.startswith("Stopped (dead point), so ")


def test_pages_of_an_earlier_run_are_told_from_those_of_this_one(tmp_path):
    assert "earlier run" not in call("run", "31", "--quantities", "table", "--format", "csv,html", "--out", tmp_path / "o").stdout
    again = call("run", "31", *QUICK, "--out", tmp_path / "o").stdout
    assert again.splitlines()[-1] == "From an earlier run, and not of this one: report.html"
