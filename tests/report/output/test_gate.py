"""Nothing absurd is written: a number that is none is a fault with quantity, rows, line and reason."""

import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.report.output import gate
from coursework.report.output.gate import pass_gate
from coursework.results.checks import check
from coursework.scene.scene_run import SceneRun
from coursework.words.data_folders import folder as data_folder
from coursework.words.errors import InputError
from coursework.words.sentences import load_phrases
from tests.command import call
from tests.hard.scenes import V31_IMPOSSIBLE, solve
from tests.mechanisms.library import mechanism
from tests.solved import solved

pytestmark = pytest.mark.usefixtures("folder")
PAGE = (Path(__file__).parents[2] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
POINTS = ["--quantities", "table,points", "--format", "csv"]


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
        "in rows 1 to 25: asin(4.63). An arc sine or arc cosine is defined only from -1 to 1",
    ),
    "root": ("r1*sqrt(-phi1) @ phi1", "no real value in rows 1 to 25: sqrt(-1.63). There is no square root of a negative number"),
    "log": ("r1*log(-phi1) @ phi1", "A logarithm is defined only for numbers above zero; see phi1."),
    "division": ("(r1/(p*t*phi1), r1)", "no real value in row 1: 0.953/0. Nothing can be divided by zero; see p, t, phi1."),
    "too large": (
        "r1*exp(1000*phi1) @ phi1",
        "in rows 1 to 25: exp(1.63e+03). It grows beyond any number; see phi1.",
    ),
}


def test_a_load_without_a_value_is_told_once_with_its_formula_and_not_as_rows_of_the_energy(folder):
    text = mechanism("example-1-forces", ("(F0, 0)", "(F0*sqrt(1 - t/0.3), 0)"))
    Path("load.toml").write_text(text, encoding="utf-8")
    line = text[: text.index("F1 = {")].count("\n") + 1
    result = call("run", "load.toml", "--format", "csv")
    assert result.exit_code == 2 and result.stderr.count("\n") == 1
    assert result.stderr.startswith(f"V604 load.toml:{line}  forces.F1.force, ")
    assert "in rows 19 to 37: sqrt(-0.0472). There is no square root of a negative number" in result.stderr


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


def with_checks(run, **changed):
    spoilt = _Spoilt(run, *run.columns())
    spoilt.checks = (*run.checks[:-1], replace(run.checks[-1], **changed))
    return spoilt


def test_a_point_that_only_the_geometry_reads_is_named_with_its_line(folder):
    text = (data_folder("variants") / "v107.toml").read_text(encoding="utf-8")
    spoilt = text.replace('A = "B - r2 @ phi2"', 'A = "B - r2 @ (phi2 + 1e-30*sqrt(0.1 - t))"')
    line = spoilt[: spoilt.index("sqrt(0.1 - t)")].count("\n") + 1
    Path("late.toml").write_text(spoilt, encoding="utf-8")
    result = call("run", "late.toml", "--quantities", "table,checks", "--format", "csv")
    assert result.exit_code == 2
    assert result.stderr.startswith(f"V019 late.toml:{line}  points.A, column 24: there is no value at t = 0.1125 s:")


@pytest.mark.parametrize("number", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", ["value", "limit", "first", "last", "step", "rows"])
def test_every_number_of_a_check_is_seen(place, number):
    run = coursework.solve("31", quantities=["table", "checks"])
    inside, outside = (
        {place: (("a line", 1.0, "m"), ("another", size, "m")) if place == "rows" else size} for size in (1e300, number)
    )
    pass_gate(with_checks(run, **inside), pages=False)
    with pytest.raises(InputError, match=rf"checks\.{run.checks[-1].code}: its value is not a finite number"):
        pass_gate(with_checks(run, **outside), pages=False)


@pytest.mark.parametrize("where", ["time", "row", "coordinates", "branches"])
def test_the_numbers_of_a_stop_are_seen(where):
    run = solve(V31_IMPOSSIBLE)
    pass_gate(run, pages=False)
    spoilt = _Spoilt(run, *run.columns())
    changed = {"coordinates": {"phi1": np.nan}, "branches": ({"w1": np.inf},)}.get(where, np.nan)
    spoilt.stop = replace(run.stop, **{where: changed})
    with pytest.raises(InputError, match="stop: the numbers of its end are not all finite"):
        pass_gate(spoilt, pages=False)


SINE = 'VMy = "V1*sin(p*t + alpha)"'
RATES = {
    "a formula": ('VMy = "V1*(sin(p*t + alpha) + sqrt(p*t))"', "row 1: sqrt(0)"),
    "a piece": (
        'VMy = { pieces = [["0 s", "V1*sin(p*t + alpha)"], ["0.1 s", "V1*(sin(p*t + alpha) + sqrt(p*t - 1.308))"]] }',
        "row 6: sqrt(0)",
    ),
}


@pytest.mark.parametrize("case", RATES)
def test_an_acceleration_without_a_value_is_told_with_the_law_that_has_no_rate(case, folder):
    """sqrt(p*t) has a value at t = 0, and its time derivative has none: the velocities stand, the accelerations do not."""
    law, node = RATES[case]
    text = PAGE.replace(SINE, law)
    Path("root.toml").write_text(text, encoding="utf-8")
    line = text[: text.index("VMy = ")].count("\n") + 1
    assert call("run", "root.toml", "--quantities", "table", "--format", "csv", "--out", "plain").exit_code in {0, 1}
    result = call("run", "root.toml", "--quantities", "table,accelerations", "--format", "csv")
    assert result.exit_code == 2
    told = result.stderr.splitlines()
    assert [line.split(": ")[0].rpartition(" ")[2] for line in told] == ["dw1", "dw2", "dw3", "dw4"]
    assert told[0].startswith(
        f"V605 root.toml:{line}  drive.VMy, dw1: no finite value in {node} does not change at a finite rate"
    )
    assert told[0].endswith("A square root rises without bound from zero; see p, t.")
    assert sorted(path.name for path in folder.iterdir()) == ["plain", "root.toml"]


def test_a_law_by_pieces_is_looked_at_piece_by_piece(folder):
    """The first piece would have no value where the second holds, and is not asked for one."""
    pieces = '{ pieces = [["0 s", "sqrt(0.3 - p*t/13.08)"], ["0.2 s", "acos(p*t - 3)"]] }'
    text = PAGE.replace("[points]", f'[functions]\nk = {pieces}\n\n[points]\nF = "r1 @ k"', 1)
    Path("k.toml").write_text(text, encoding="utf-8")
    line = text[: text.index("k = ")].count("\n") + 1
    result = call("run", "k.toml", *POINTS)
    assert result.exit_code == 2
    assert result.stderr.startswith(f"V604 k.toml:{line}  ")
    assert "acos(" in result.stderr
    assert "sqrt" not in result.stderr


def test_a_law_by_a_table_is_known_to_the_formulas_behind_it(folder):
    """k falls along a table of phi1; the root of it is charged to the point, with the number of the table."""
    rows = [(round(0.5 * place - 1, 2), 1.4 - 0.5 * place) for place in range(13)]
    Path("k.csv").write_text("".join(f"{at},{value:.3f}\n" for at, value in rows), encoding="utf-8")
    laws = '[functions]\nk = { table = "k.csv", of = "phi1", method = "spline" }\n\n[points]\nF = "r1*sqrt(k) @ phi1"'
    text = PAGE.replace("[points]", laws, 1)
    Path("k.toml").write_text(text, encoding="utf-8")
    line = text[: text.index("F = ")].count("\n") + 1
    result = call("run", "k.toml", *POINTS)
    phi1 = coursework.solve("k.toml", quantities=["table"]).motion.column("phi1")
    k = 0.4 - phi1  # 1.4 at phi1 = -1, and one less a radian
    first = float(k[k < 0][0])
    assert result.exit_code == 2
    assert result.stderr.startswith(f"V604 k.toml:{line}  points.F: no real value in ")
    assert f"sqrt({first:.3g}). There is no square root of a negative number; see k." in result.stderr


@pytest.mark.parametrize("strict", [[], ["--strict"]])
def test_a_check_that_breaks_is_our_fault_and_the_others_still_judge(strict, folder, monkeypatch):
    def broken(evidence):
        raise RuntimeError("a judge fell ill")

    usual = {one.code: one.verdict for one in coursework.solve("31").checks}
    ill = tuple(replace(one, judge=broken) if one.code == "DRIFT" else one for one in check.CHECKS)
    monkeypatch.setattr(check, "CHECKS", ill)
    result = call("run", "31", "--out", "o", "--format", "html", *strict)
    assert result.exit_code == 3
    assert result.stdout.splitlines()[0].endswith("The tool could not judge DRIFT.")
    written = json.loads(Path("o/run.json").read_text(encoding="utf-8"))
    found = {one["code"]: one["verdict"] for one in written["checks"]}
    assert found == usual | {"DRIFT": "ERROR"}
    sentence = next(one["sentence"] for one in written["checks"] if one["code"] == "DRIFT")
    assert "RuntimeError" in sentence
    assert "a judge fell ill" in Path("o/report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["31", "example-6", "stephenson", "v107"])
def test_what_is_finite_passes(name):
    pass_gate(solved(name), pages=True)
    pass_gate(coursework.solve(name, step=coursework.load(name).time.step * 3, quantities=["table", "checks"]), pages=False)


@pytest.mark.parametrize("name", ["example-4", "example-6", "oscillating-cylinder", "whitworth"])
def test_a_block_without_a_column_of_its_own_keeps_no_check_from_being_written(name: str) -> None:
    """The block turns with its lever: the drawing gives its angular velocity, the table has none to compare."""
    run = solved(name, quantities=("table", "graph_check"))
    assert run.graph_check is not None
    assert any(math.isnan(row[2]) for row in run.graph_check.rows), "or this tests nothing"
    pass_gate(run, pages=True)


def test_a_measured_value_that_is_none_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    run = coursework.solve("31", quantities=["table", "graph_check"])
    first, *others = run.graph_check.rows
    spoilt = SimpleNamespace(rows=[(first[0], np.nan, *first[2:]), *others])
    monkeypatch.setattr(SceneRun, "graph_check", spoilt)
    with pytest.raises(InputError, match="measured"):
        pass_gate(run, pages=True)


@pytest.mark.parametrize(
    ("spoilt", "told"),
    [
        ([0], "row 1"), ([2], "row 3"), ([2, 3], "rows 3 to 4"), ([2, 3, 4], "rows 3 to 5"),
        ([2, 4], "2 rows between 3 and 5"), ([0, 3, 24], "3 rows between 1 and 25"), ([5, 6, 9, 20], "4 rows between 6 and 21"),
    ],
)  # fmt: skip
def test_rows_are_told_from_the_first_to_the_last(spoilt, told):
    assert load_phrases().written(gate._rows(spoilt)) == told


def test_every_quantity_of_a_block_is_told_once_and_a_point_with_both_its_components():
    lines = {"B": 3, "C": 4, "phi1": 7}
    variant = SimpleNamespace(points=(("B", None), ("C", None)), file="31.toml", line_of=lambda section, what: lines[what])
    block = gate.Block(("B.x", "B.y", "phi1", "C.x", "C.y", "phi2"), np.zeros((2, 6)), "")
    spoilt = np.array([[True, True, True, False, True, False]] * 2)
    run = SimpleNamespace(variant=variant)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(gate, "_reason", lambda run, point: None)
        told = [(one.place, one.line) for one in gate._faults(run, block, spoilt)]
    assert told == [("points.B", 3), ("coordinates.phi1", 7), ("points.C", 4)]
