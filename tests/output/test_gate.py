"""Nothing absurd is written: a number that is none is a fault with quantity, rows, line and reason."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.cli import main
from coursework.errors import InputError
from coursework.output.gate import pass_gate

PAGE = (Path(__file__).parents[1] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
POINTS = ["--quantities", "table,points", "--format", "csv"]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def call(*arguments):
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


def leg(formula: str) -> int:
    """Write leg.toml, in which the point F is given by a formula; return its line."""
    text = PAGE.replace("[points]", f'[points]\nF = "{formula}"', 1)
    Path("leg.toml").write_text(text, encoding="utf-8")
    return text[: text.index('F = "')].count("\n") + 1


CASES = {
    "triangle": (
        "r1 @ acos(1.55*(r1^2 + r2^2 - r3^2)/(2*r1*r2))",
        "no real value in rows 1 to 25: acos(1.36). The triangle r1, r2, r3 cannot close.",
    ),
    "arc": (
        "r1 @ asin(3 + phi1)",
        "in rows 1 to 25: asin(4.63). An arc sine or arc cosine exists from -1 to 1 only",
    ),
    "root": ("r1*sqrt(-phi1) @ phi1", "no real value in rows 1 to 25: sqrt(-1.63). There is no square root of a negative number"),
    "log": ("r1*log(-phi1) @ phi1", "There is a logarithm of numbers above zero only; see phi1."),
    "division": ("(r1/(p*t*phi1), r1)", "no real value in row 1: 0.953/0. Nothing can be divided by zero; see p, t, phi1."),
    "too large": (
        "r1*exp(1000*phi1) @ phi1",
        "in rows 1 to 25: exp(1.63e+03). It grows beyond any number; see phi1.",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_a_point_without_a_place_is_told_with_its_formula(case, folder):
    formula, sentence = CASES[case]
    line = leg(formula)
    result = call("run", "leg.toml", *POINTS)
    assert result.exit_code == 2, result.output
    assert result.stderr.startswith(f"V604 leg.toml:{line}  points.F: ")
    assert sentence in result.stderr
    assert "Warning" not in result.stderr
    assert [path.name for path in folder.iterdir()] == ["leg.toml"]


def test_a_page_written_from_python_is_refused_too(folder):
    leg(CASES["triangle"][0])
    with pytest.raises(InputError, match=r"acos\(1\.36\)"):
        coursework.write_report(coursework.solve("leg.toml", quantities=["table", "points"]), folder / "a.html")
    assert not (folder / "a.html").exists()


def test_no_warning_reaches_the_user(folder):
    leg(CASES["root"][0])
    command = [sys.executable, "-W", "always", "-m", "coursework", "run", "leg.toml", *POINTS]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("number", [np.nan, np.inf, -np.inf])
def test_every_number_of_the_table_is_seen(number):
    run = coursework.solve("31", quantities=["table", "points", "accelerations"])
    names, rows = run.columns()
    for index in range(len(names)):
        spoilt = rows.copy()
        spoilt[3, index] = number
        with pytest.raises(InputError, match=r"no finite value in row 4; nothing is written\."):
            pass_gate(_Spoilt(run, names, spoilt), pages=False)


class _Spoilt:
    """A run whose columns are others."""

    def __init__(self, run, names, rows):
        self._run, self._columns = run, (names, rows)

    def columns(self):
        return self._columns

    def __getattr__(self, name):
        return getattr(self._run, name)


def test_checks_are_seen(monkeypatch):
    run = coursework.solve("31", quantities=["table", "checks"])
    checks = (*run.checks[:-1], replace(run.checks[-1], value=float("nan")))
    spoilt = _Spoilt(run, *run.columns())
    spoilt.checks = checks
    with pytest.raises(InputError, match=rf"checks\.{checks[-1].code}: its value is no finite number"):
        pass_gate(spoilt, pages=False)


@pytest.mark.parametrize("name", ["31", "example-6", "stephenson", "v107"])
def test_what_is_finite_passes(name):
    pass_gate(coursework.solve(name), pages=True)
    pass_gate(coursework.solve(name, step=coursework.load(name).time.step * 3, quantities=["table", "checks"]), pages=False)
