"""The exact motion as a scheme: who has it by default, who must ask, who cannot; Euler beside it as the lesson."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.motion.integration.extended_precision import has_extended
from coursework.report.pages import build_model
from coursework.results.checks.evidence import worst
from coursework.scene import motion_results
from coursework.variant.catalogue import entries
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.vocabulary import EXACT
from tests.command import call
from tests.hard.scenes import scene
from tests.report.real import text_of
from tests.solved import solved

pytestmark = pytest.mark.usefixtures("folder")
ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "tests" / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
OPEN = PAGE[: PAGE.index("# --- geometry")]


def rows_of(path):
    with path.open(encoding="utf-8") as lines:
        head, *rows = csv.reader(lines)
    return head, np.array(rows, dtype=float)


# ---- who gets it


def test_files_whose_motion_is_a_chain_of_groups_have_it_by_default():
    schemes = {entry.name: solved(entry.name, quantities=["table"]).scheme for entry in entries()}
    exact = {name for name, scheme in schemes.items() if scheme == "exact"}
    chains = {entry.name for entry in entries() if coursework.load(entry.name).groups} - {"example-2-motor"}
    assert exact >= chains | {"example-1", "example-3", "example-6", "homework", "prp"}
    assert {scheme for name, scheme in schemes.items() if name not in exact} == {"euler"}
    assert schemes["31"] == "euler"


def test_a_file_may_ask_for_a_scheme_and_the_command_line_for_another():
    text = PAGE.replace("[time]\n", '[time]\nscheme = "heun"\n')
    assert "heun" in text
    assert coursework.solve(parse_variant(text)).scheme == "heun"
    assert coursework.solve(parse_variant(text), "rk4").scheme == "rk4"
    assert coursework.solve(parse_variant(text.replace("heun", "exact"))).scheme == EXACT
    assert coursework.solve("example-3", "euler", quantities=["table"]).motion.scheme == "euler"
    with pytest.raises(coursework.InputError, match=r'faulty:\d+.*no scheme "huen"\. Did you mean "heun"\?'):
        parse_variant(text.replace("heun", "huen"), "faulty")


@pytest.mark.parametrize(
    ("name", "scheme"),
    [("31", "euler"), ("31", EXACT), ("example-1", EXACT), ("example-2-motor", "rk4"), ("example-2-motor", EXACT)],
)
def test_every_scheme_keeps_to_the_most_numbers_of_a_table(monkeypatch, name, scheme):
    """With times from the command line, after the file was read."""
    variant = coursework.load(name)
    monkeypatch.setattr("coursework.variant.judging.bounds.MAX_NUMBERS", 100)
    with pytest.raises(coursework.InputError, match="a table has at most 100 numbers"):
        _ = coursework.solve(variant, scheme, step=variant.time.step / 2, quantities=["table"]).motion


def test_without_closed_positions_it_is_refused():
    Path("open.toml").write_text(OPEN, encoding="utf-8")
    done = call("run", "open.toml", "--scheme", "exact", "--format", "csv")
    assert done.exit_code == 2
    assert "add [closure] (or a chain of [[group]]), or take --scheme rk4" in done.stderr
    assert "open.toml:1 " in done.stderr  # what is missing has no line of its own
    Path("asked.toml").write_text(OPEN.replace("[time]\n", '[time]\nscheme = "exact"\n'), encoding="utf-8")
    done = call("run", "asked.toml", "--format", "csv")
    line = next(i for i, text in enumerate(Path("asked.toml").read_text(encoding="utf-8").splitlines(), 1) if "exact" in text)
    assert done.exit_code == 2
    assert f"asked.toml:{line}" in done.stderr
    assert call("run", "asked.toml", "--scheme", "rk4", "--format", "csv").exit_code == 0


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--project"], "no error to correct"),
        (["--gain", "5"], "no error to correct"),
        (["--step", "auto", "--error", "0.01"], "no error that a step"),
        (["--precision", "single"], "no error that a step"),
    ],
)
def test_what_makes_no_sense_of_an_exact_motion_is_refused(options, said):
    done = call("run", "31", "--scheme", "exact", "--format", "csv", *options)
    assert done.exit_code == 2
    assert said in done.stderr
    assert "--scheme rk4" in done.stderr


def test_a_step_for_a_wish_and_single_precision_speak_of_a_scheme_where_the_file_has_none():
    done = call("run", "example-1", "--step", "auto", "--error", "0.1", "--format", "csv")
    assert "explicit Euler needs" in done.stdout
    assert json.loads(Path("coursework-example-1/run.json").read_text(encoding="utf-8"))["scheme"] == "euler"
    assert "single, t += h" in call("run", "example-1", "--precision", "single", "--step", "0.1").stdout


# ---- what it is


@pytest.mark.parametrize("name", ["31", "v107", "example-3", "example-6", "homework"])
def test_everything_comes_from_the_exact_motion(name):
    run = coursework.solve(name, "exact", quantities=["table", "plots", "accelerations", "points", "checks"])
    assert np.array_equal(run.motion.rows, run.exact.rows)
    assert np.array_equal(run.results.accelerations, run.scene.exact_accelerations)
    table, exact = run.table, coursework.exact(name, quantities=["table", "accelerations", "points"])
    assert list(table.columns) == list(exact.columns)
    assert np.array_equal(table.to_numpy(), exact.to_numpy())
    verdicts = {check.code: check.verdict for check in run.checks}
    assert verdicts["ACCURACY"] == "PASS"
    assert not {"FAIL", "ERROR"} & set(verdicts.values())
    assert run.motion.scaled.shape == run.motion.determinants.shape


def test_some_columns_alone_are_those_of_the_whole_table():
    whole, part = (coursework.solve("31", "exact", quantities=[asked]) for asked in ("table", "phi3"))
    assert part.motion.names == ("phi3", "w3")
    assert np.max(np.abs(part.motion.rows - whole.motion.rows[:, [2, 5]])) < 1e-13


def test_it_ends_at_a_dead_point_as_every_scheme_does():
    run = coursework.solve(parse_variant(PAGE.replace('"4.35 rad"', '"0.02 rad"')), "exact")
    assert run.stop.kind == "dead point"
    assert len(run.motion.t) == 6
    assert run.status() == 1


def test_the_plan_of_an_exact_run_says_what_is_computed():
    plan = coursework.solve("31", "exact", quantities=["table"]).plan
    assert "exact" in plan.order
    assert "exact" not in coursework.solve("31", "euler", quantities=["table"]).plan.order


def test_the_slider_of_the_homework_stays_on_its_guide():
    """The deck's homework: E slides along the horizontal guide through A, to round-off in every row; with Euler it leaves it."""
    table = coursework.solve("homework", quantities=["table", "points"]).table
    assert np.max(np.abs(table["E.y"])) < 1e-12
    assert np.ptp(table["E.x"]) > 0.4
    assert np.max(np.abs(coursework.solve("homework", "euler", quantities=["table", "points"]).table["E.y"])) > 0.05


# ---- Euler beside it


def test_the_lesson_is_told_on_screen_in_the_record_and_in_a_table():
    done = call("run", "example-3", "--format", "csv")
    assert done.exit_code == 0
    assert "exact motion, h = 0.01745 s, 37 rows" in done.stdout
    assert "Euler at this step would be off by 57.9 % of the scale of theta5 in row 37." in done.stdout
    out = Path("coursework-example-3")
    record = json.loads((out / "run.json").read_text(encoding="utf-8"))
    assert record["scheme"] == "exact"
    assert (record["lesson"]["scheme"], record["lesson"]["column"], record["lesson"]["row"]) == ("euler", "theta5", 37)
    head, euler = rows_of(out / "table-euler.csv")
    wanted = coursework.solve("example-3", "euler", quantities=["table"]).motion
    assert head == ["t", *wanted.names]
    assert np.array_equal(euler[:, 1:], wanted.rows)
    assert "table-euler.csv" in record["files"]
    exact = rows_of(out / "table.csv")[1]
    gap = np.abs(euler - exact[:, : euler.shape[1]])[:, 1 + wanted.names.index("theta5")]
    assert int(np.argmax(gap)) == 36


def test_the_share_of_the_lesson_is_that_of_the_accuracy_check_of_the_scheme():
    lesson = coursework.solve("example-6", quantities=["table"]).distance_to_exact
    run = coursework.solve("example-6", "euler", quantities=["checks"])
    found = next(check for check in run.checks if check.code == "ACCURACY")
    assert (lesson.share, lesson.column, lesson.row) == (found.value, found.column, found.row)
    assert worst(run.results.evidence.errors)[0] + 1 == lesson.row


def test_a_table_of_a_scheme_has_no_lesson():
    assert call("run", "31", "--format", "csv", "--quantities", "table").exit_code == 0
    assert not Path("coursework-31/table-euler.csv").exists()
    assert json.loads(Path("coursework-31/run.json").read_text(encoding="utf-8"))["lesson"] is None


def test_both_motions_are_in_the_plots_and_the_page_says_so():
    run = coursework.solve("example-1", quantities=["table", "plots"])
    sections = {section["name"]: section for section in build_model(run).plain()["sections"]}
    told = {name: text_of(section) for name, section in sections.items()}
    assert "explicit Euler" in told["graphs"]
    assert "exact motion" in told["graphs"]
    assert "Euler at this step" in told["method"]
    assert "closed form of the groups" in told["method"]
    assert "q_{i+1}" not in told["method"]
    panels = sections["graphs"]["parts"][0]["items"]
    assert all('class="dots"' in panel["svg"] for panel in panels)
    assert [panel["svg"].count("<path") for panel in panels] == _paths(coursework.solve("example-1", "euler"))


def _paths(run):
    """Return how many lines each panel of a run has."""
    graphs = next(section for section in build_model(run).plain()["sections"] if section["name"] == "graphs")
    return [panel["svg"].count("<path") for panel in graphs["parts"][0]["items"]]


def test_the_cost_of_accuracy_beside_an_exact_table_is_that_of_euler():
    study = coursework.solve("example-1", quantities=["table", "accuracy"]).accuracy
    assert study.own[0] == "explicit Euler"
    assert study.own[2] > 0.01


@pytest.mark.parametrize(("name", "most", "is_had"), [("31", 25, True), ("31", 24, False), ("three", 2001, False)])
def test_few_rows_are_marched_in_extended_numbers_where_no_block_needs_a_matrix(name, most, is_had, monkeypatch):
    """25 rows; u + v + w = 6 n and two more for (1, 2, 3) n hang together all three, which numpy solves in doubles alone."""
    assert motion_results.MOST_EXTENDED == 2001
    monkeypatch.setattr(motion_results, "MOST_EXTENDED", most)
    together = scene(
        "\n".join(f'{name} = {{ start = "0 rad", rate = "{rate}" }}' for name, rate in zip("pabc", "nuvw", strict=True)),
        given='k = "2 rad/s"', drive='n = "k"', equations=["u + v + w = 6*n", "u - v + 2*w = 5*n", "2*u + v - w = n"],
    )  # fmt: skip
    run = coursework.solve(name if name == "31" else coursework.parse_variant(together))
    assert run.motion.velocities[0].tolist() == pytest.approx([2, 2, 4, 6]) if name == "three" else len(run.motion.t) == 25
    assert (run.results.extended_precision is not None) == (is_had and has_extended())
