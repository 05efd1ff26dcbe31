"""What a plan names is what the run then computes; what is known when a budget ends is written."""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from coursework.commands.cli import main
from coursework.scene.motion_results import MotionResults
from coursework.system.processes import budget
from tests.hard.drives import Law, four_bar

STEADY = Law("steady", "n", {"n": "3 rad/s"}, lambda t: 3 * t)
FAST = Law("pulse", "n*exp(-((t - tm)/T)^2)", {"n": "1e4 rad/s", "tm": "0.50437 s", "T": "1e-4 s"}, lambda t: t)


@pytest.fixture
def files(tmp_path, monkeypatch):
    """Return a folder with a four-bar of ours whose crank turns, one with a pulse, and one that stops."""
    monkeypatch.chdir(tmp_path)
    Path("steady.toml").write_text(four_bar(STEADY, step=0.05), encoding="utf-8")
    Path("pulse.toml").write_text(four_bar(FAST, step=0.05, scheme="rk4"), encoding="utf-8")
    Path("stops.toml").write_text(four_bar(STEADY, step=0.05, scheme="euler").replace('"1.2 m"', '"1.6 m"'), encoding="utf-8")
    return tmp_path


def planned(*words: str) -> set[str]:
    """Return the names under the first heading of a plan."""
    lines = CliRunner().invoke(main, ["run", *words, "--plan"]).output.splitlines()[1:]
    return {line.split()[0] for line in lines[: next(i for i, line in enumerate(lines) if not line.startswith("  "))]}


def computed(*words: str) -> set[str]:
    """Return the names of the profile of a run."""
    told = CliRunner().invoke(main, ["run", *words, "--profile"]).output
    return set(re.findall(r"^(\w+) +\d+ +[\d.]+$", told.partition("quantity ")[2], re.MULTILINE))


@pytest.mark.parametrize("formats", ["csv", "csv,html"])
@pytest.mark.parametrize("variant", ["31", "steady.toml", "pulse.toml", "stops.toml"])
def test_the_plan_names_what_the_profile_shows(variant, formats, files):
    words = [variant, "--format", formats, "--out", "o"]
    assert planned(*words) == computed(*words)


def test_what_is_known_when_the_budget_ends_is_written(files, monkeypatch):
    def forever(results):
        while True:
            pass

    monkeypatch.setattr(budget, "PACE", 0.01)
    monkeypatch.setattr(MotionResults.__dict__["checks"], "compute", forever)
    words = ["run", "steady.toml", "--budget", "1.5", "--format", "csv,html", "--out", "o"]
    ended = CliRunner().invoke(main, [*words, "--quantities", "table,checks"])
    assert ended.exit_code == 2
    assert "What was known by then is written to o: table.csv" in ended.output
    assert "E001" in ended.output
    assert len(Path("o/table.csv").read_text(encoding="utf-8").splitlines()) == 22
    assert not Path("o/report.html").exists()


def test_single_precision_of_a_motion_that_stops_still_leaves_the_table(files):
    told = CliRunner().invoke(main, ["run", "stops.toml", "--precision", "single", "--format", "csv", "--out", "o"])
    assert told.exit_code == 1
    assert "so there is no error to show" in told.output
    assert Path("o/table.csv").exists()
