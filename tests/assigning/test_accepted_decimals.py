"""The decimals that a sheet accepts hold for the whole class: one number, from the template, whatever was drawn.

Tables are made without the tool: the equations of 31 and V102 solved by NumPy, marched by Euler, rounded as a student does.
"""

import csv
import json
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.assigning.handout import Handout
from coursework.assigning.variants import Assignment, load_ranges
from coursework.grading.batch.work import Setup, Task, VariantSource
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes.whole import fewer_decimals
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.grading.marking.table.points import table_points
from coursework.grading.reading.submission import Submission
from tests.command import call
from tests.grading.batch.in_this_process import in_this_process
from tests.sample import first


def of_31(t, q, r1, r2, r3, V1, p, alpha):
    s, c = np.sin(q), np.cos(q)
    rows = [
        [0, 0, 2 * r3 * c[2] + r3 * s[2], 0],
        [0, 0, 2 * r3 * s[2] - r3 * c[2], r3 / 2],
        [r1 * s[0], r2 * s[1], r3 * c[2], -r3 / 2],
        [r1 * c[0], r2 * c[1], -r3 * s[2], 0],
    ]
    return np.linalg.solve(rows, [V1 * math.sin(p * t + alpha), 0, 0, 0])


def of_v102(t, q, r1, r2, a, c, V1, p, alpha):
    sine, cosine, drive = np.sin(q), np.cos(q), V1 * math.sin(p * t + alpha)
    rows = [
        [0, 0, a * sine[2] + c * cosine[2], 0],
        [0, 0, -a * cosine[2] + c * sine[2], -1],
        [r1 * sine[0], r2 * sine[1], a * sine[2], 0],
        [-r1 * cosine[0], -r2 * cosine[1], -a * cosine[2], 0],
    ]
    return np.linalg.solve(rows, [-drive, 0, -drive, 0])


def euler(velocities, variant):
    """Return t and the rows of Euler's table, and the one-step gap by its definition."""
    data = variant.values
    q, h = np.array([c.start for c in variant.coordinates]), variant.time.step
    rows, gap = [], 0.0
    for k in range(variant.time.steps + 1):
        rate = velocities(k * h, q, **data)
        rows.append([*q, *rate])
        if k < variant.time.steps:
            gap = max(gap, *(abs(h / 2 * (velocities(k * h + h, q + h * rate[:3], **data) - rate)[:3])))
        q = q + h * rate[:3]
    return np.array(rows), gap


TEMPLATES = {"31": of_31, "v102": of_v102}
NAMES = {"31": ["phi1", "phi2", "phi3", "w1", "w2", "w3", "w4"], "v102": ["phi1", "phi2", "phi3", "w1", "w2", "w3", "u"]}
RUBRIC = "[parts]\ntable = 60\nequations = 0\n"


@pytest.fixture(scope="module", params=first(2, [["31", 5], ["v102", 5], ["31", 12], ["v102", 12]]), ids=str)
def marked(request, tmp_path_factory):
    """Return a class that handed in right tables with the accepted decimals: template, roster, grades by id."""
    (name, count), folder = request.param, tmp_path_factory.mktemp("class")
    roster = folder / "roster.csv"
    roster.write_text("id,name,email\n" + "".join(f"s{k:02},S,\n" for k in range(count)), encoding="utf-8")
    made = call("assign", roster, "--template", name, "--seed", "2026", "--out", folder / "out")
    assert made.exit_code == 0, made.output
    with (folder / "out" / "roster.csv").open(encoding="utf-8-sig", newline="") as file:
        lines = list(csv.DictReader(file))
    for line in lines:
        rows, _ = euler(TEMPLATES[name], coursework.load(folder / "out" / line["variant"]))
        decimals = int(line["accepted_decimals"])
        variant = coursework.load(folder / "out" / line["variant"])
        text = ["t," + ",".join(NAMES[name])]
        text += [f"{k * variant.time.step:.3f}," + ",".join(f"{cell:.{decimals}f}" for cell in row) for k, row in enumerate(rows)]
        (folder / "in" / line["id"]).mkdir(parents=True)
        (folder / "in" / line["id"] / "table.csv").write_text("\n".join(text), encoding="utf-8")
    (folder / "rubric.toml").write_text(RUBRIC, encoding="utf-8")
    return name, folder, lines


def grades(folder, roster, out):
    with in_this_process():
        result = call("grade", folder / "in", "--roster", roster, "--out", out, "--rubric", folder / "rubric.toml", "--no-pages")
    assert result.exit_code == 0, result.output
    return json.loads((out / "grades.json").read_text(encoding="utf-8"))["submissions"]


def test_the_roster_has_one_number_and_it_is_the_templates(marked):
    name, _, lines = marked
    _, gap = euler(TEMPLATES[name], coursework.load(name))
    assert {line["accepted_decimals"] for line in lines} == {str(math.ceil(-math.log10(0.6 * gap)))}
    assert list(lines[0])[4:6] == ["least_decimals", "accepted_decimals"]


def test_right_tables_with_the_accepted_decimals_earn_the_full_table(marked):
    _, folder, lines = marked
    found = grades(folder, folder / "out" / "roster.csv", folder / "marks")
    assert [one["score"] for one in found] == [100.0] * len(lines)
    for one, line in zip(found, lines, strict=True):
        fewer = int(line["accepted_decimals"]) < int(line["least_decimals"])
        assert ("fewer_decimals" in {note["code"] for note in one["notes"]}) == fewer
        assert "too_coarse" not in {note["code"] for note in one["notes"]}


@pytest.mark.long
def test_without_the_column_each_variant_has_its_own_number(marked, tmp_path):
    name, folder, lines = marked
    roster = folder / "out" / "bare.csv"
    roster.write_text("id,variant\n" + "".join(f"{line['id']},{line['variant']}\n" for line in lines), encoding="utf-8")
    found = grades(folder, roster, tmp_path / "marks")
    for one, line in zip(found, lines, strict=True):
        _, gap = euler(TEMPLATES[name], coursework.load(folder / "out" / line["variant"]))
        is_coarse = 10.0 ** -int(line["accepted_decimals"]) > 0.6 * gap
        assert ("too_coarse" in {note["code"] for note in one["notes"]}) == is_coarse
        assert (one["status"] == "needs-review") == is_coarse
        assert one["score"] == (None if is_coarse else 100.0)
    assert name != "31" or {one["score"] for one in found} == {None, 100.0}


@pytest.mark.long
@pytest.mark.parametrize(("part", "shown"), [(1.19, True), (1.21, False)])
def test_a_cell_of_that_many_decimals_is_shown_up_to_twice_the_usual_part_of_the_gap(part, shown):
    """One decimal: data are chosen whose gap makes 0.1 just more, or just less, than 1.2 gaps."""
    base = coursework.load("31")
    low, high = 0.02, 0.2
    for _ in range(60):
        step = (low + high) / 2
        low, high = (low, step) if key_of(_stepped(base, step)).gap > 0.1 / part else (step, high)
    variant = _stepped(base, (low + high) / 2)
    key = key_of(variant, 1)
    assert key.gap == pytest.approx(0.1 / part, rel=1e-6)
    student = StudentTable(np.round(key.table, 1), np.full(key.table.shape, 0.1))
    cells = mark_cells(key, student)
    assert cells.missing[:, :3].all() != shown
    assert cells.too_coarse[:, :3].all() != shown
    assert (table_points(key, cells).share == 1.0) == shown
    assert bool(fewer_decimals(key, cells))
    finer = StudentTable(np.round(key.table, 1), np.full(key.table.shape, 0.0999))
    assert mark_cells(key, finer).missing[:, :3].all() != (1.2 * key.gap >= 0.0999)
    assert mark_cells(key_of(variant), student).too_coarse[:, :3].all()  # alone it asks for two decimals


def _stepped(variant, step):
    return variant.with_data(given={"V1": 1.2}, step=step, end=4 * step)


def test_another_number_is_marked_anew():
    source = VariantSource("31", b"")
    keys = [Task(Submission("a", None, ()), source, (), decimals).key(Setup()) for decimals in (None, 1, 2)]
    assert len(set(keys)) == 3


@pytest.mark.parametrize(
    ("text", "is_right"), [("", True), ("0", True), ("15", True), ("16", False), ("-1", False), ("2.0", False)]
)
def test_a_number_in_the_roster_that_cannot_be_is_told(tmp_path, text, is_right):
    (tmp_path / "in").mkdir()
    (tmp_path / "roster.csv").write_text(f"id,variant,accepted_decimals\na,31,{text}\n", encoding="utf-8")
    with in_this_process():
        result = call("grade", tmp_path / "in", "--roster", tmp_path / "roster.csv", "--out", tmp_path / "out")
    assert result.exit_code == (0 if is_right else 2), result.output
    assert is_right or ("roster.csv:2" in result.output and f'found "{text}"' in result.output)


def test_a_template_that_stops_at_once_has_the_decimals_of_a_draw_that_does_not(tmp_path):
    """At tan(phi3) = -2 the first block is singular; the last decimal is at most 0.6 of the gap of the middle draw."""
    text = coursework.load("31").path.read_text(encoding="utf-8").replace("2.87 rad", "2.034443935795703 rad")
    (tmp_path / "dead.toml").write_text(text, encoding="utf-8")
    template = coursework.load(tmp_path / "dead.toml")
    made = Assignment(template, load_ranges("31", template), 1)
    assert made.accepted_decimals == math.ceil(-math.log10(0.6 * made.acceptance.centre.numbers["one_step_gap"]))


@pytest.mark.parametrize(("gap", "step", "accepted"), [
    (0.0084, 0.02, 2), (0.0083, 0.02, 3), (0.0168, 2.0, 2), (0.0166, 2.0, 3), (0.9, 0.02, 1),
])  # fmt: skip
def test_the_decimals_of_the_class_are_enough_up_to_a_gap(gap: float, step: float, accepted: int) -> None:
    """Two decimals are enough where 0.01 is at most 1.2 gaps of one second; a sheet that asks for one accepts one."""
    drawn = SimpleNamespace(accepted=SimpleNamespace(numbers={"one_step_gap": gap}))
    one: Any = SimpleNamespace(individual=drawn, variant=SimpleNamespace(time=SimpleNamespace(step=step)), of_class=2)
    one.least_decimals = Handout.least_decimals.fget(one)
    assert Handout.accepted_decimals.fget(one) == accepted
