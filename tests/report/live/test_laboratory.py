"""The laboratory in a real browser: its table, errors and work, its dead points, every datum from end to end."""

from __future__ import annotations

import csv
import math
import re
import unicodedata
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.motion.schemes import SCHEMES
from coursework.scene.motion_results import given_constants
from tests.mechanisms.library import mechanism
from tests.sample import first
from tests.solved import solved
from tests.variant.record.test_with_data import LEVER

pytestmark = pytest.mark.browser
PHASE = 0.1168893  # s: where variant 31 with alpha = 0.02 stops, from the closed form of its driven point


def rows_of(path: Path) -> list[dict[str, float]]:
    with path.open(encoding="utf-8", newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def test_where_links_do_not_close_there_is_no_error(written: Any, opened: Any) -> None:
    page = opened(written("example-1"))
    page.set("#lab-datum-name", "r2", "change")
    page.set("#lab-datum", page.page.get_attribute("#lab-datum", "max"))
    assert page.page.inner_text("#lab-lost") == "With this value the links do not close."
    assert (page.value("#lab-error"), page.page.inner_text("#lab-error")) == ("", "–")
    assert page.page.inner_text("#live-away") == ""  # no table has ended where there is none


def test_a_pin_stays_in_its_slot_for_other_data(written: Any, opened: Any) -> None:
    variant = coursework.parse_variant(mechanism("four-bar-by-squared-lengths", *LEVER))
    page = opened(written(variant))
    page.set("#lab-datum-name", "r2", "change")
    page.set("#lab-datum", 0.41)
    read = "all => all.map(at => +at.dataset.value)"
    _, xb, yb, xc, yc, th = page.page.eval_on_selector_all("#lab-table tbody tr:first-child td", read)[:6]
    d = variant.values["d"]
    assert [math.hypot(xc - xb, yc - yb), math.hypot(xc - d, yc), th] == pytest.approx([0.41, 0.3, math.atan2(yc + d, xc - d)])


@pytest.mark.parametrize(
    ("name", "table"),
    first(
        4,
        [("31", "table.csv"), ("robot-arm", "table.csv"), ("variable-crank-table", "table-euler.csv"),
         ("peaucellier", "table-euler.csv"), ("v107", "table.csv"), ("example-3", "table-euler.csv")],
    ),
)  # fmt: skip
def test_the_laboratory_gives_the_table_of_the_run(written: Any, opened: Any, name: str, table: str) -> None:
    folder = written(name)
    page = opened(folder).page
    read = "all => all.map(row => Object.fromEntries([...row.cells].map(at => [at.dataset.column, at.dataset.value])))"
    found = page.eval_on_selector_all("#lab-table tbody tr", read)
    right = rows_of(folder / table)
    assert [int(row) for row in page.eval_on_selector_all("#lab-table tr[data-row]", "all => all.map(r => r.dataset.row)")] == [
        *range(1, len(right) + 1)
    ]
    largest = {name: max(1.0, *(abs(row[name]) for row in right)) for name in right[0]}
    motion = solved(name).motion
    motion = solved(name).motion
    constant = given_constants(solved(name).variant, motion.names, motion.rows)  # said in words, no column
    assert [*found[0]] == ["t", *(one for one in motion.names if one not in constant)]
    for there, here in zip(right, found, strict=True):
        for column, value in here.items():
            assert abs(float(value) - there[column]) <= 1e-12 * largest[column], column


@pytest.mark.parametrize(("name", "told"), [("peaucellier", "in φ3, row"), ("engine-start", "in φ1, row 41")])
def test_of_errors_alike_the_laboratory_names_the_first(written: Any, opened: Any, name: str, told: str) -> None:
    """Of links that lean alike, and of rows that stand still, the one that is larger in its last digits says nothing."""
    page = opened(written(name)).page
    assert unicodedata.normalize("NFKC", page.inner_text("#lab-where")).strip().startswith(told)


def test_an_error_of_round_off_is_none(written: Any, opened: Any) -> None:
    """Both rates of cardan's circles are constant: Euler is exact, and so is its table by half the step."""
    page = opened(written("cardan"))
    page.set("#lab-step", 1)
    page.page.wait_for_selector("#lab-error:not([data-value=''])")
    assert 0 <= float(page.value("#lab-error")) < 1e-10
    assert (page.page.inner_text("#lab-error"), page.page.inner_text("#lab-where")) == ("0°", "round-off alone")
    assert page.page.inner_text("#lab-ratio") == ""


def test_a_better_scheme_and_a_smaller_step_cost_what_they_cost(written: Any, opened: Any) -> None:
    page = opened(written("31"))
    first = float(page.value("#lab-error"))
    assert first == pytest.approx(0.1520, abs=5e-5)
    assert page.value("#lab-evaluations") == "24"
    page.set("#lab-step", 1)
    half = float(page.value("#lab-error"))
    assert page.value("#lab-evaluations") == "48"
    assert 1.7 < first / half < 2.3
    assert page.page.inner_text("#lab-ratio") == f"{half / first:.2g} times the error for 2 times the work."
    page.set("#lab-step", 0)
    page.set("#lab-scheme", "rk4", "change")
    assert float(page.value("#lab-error")) == pytest.approx(1.07e-5, rel=0.01)
    assert page.value("#lab-evaluations") == "96"
    assert page.page.inner_text("#lab-ratio") == "14000 times less error for 4 times the work."
    # Between rows the way of such a scheme is no chord, which is 5 mm off where its rows are 0.01 mm off.
    page.set("#scrub", 18.5)
    off = re.fullmatch(r". is ([\d.]+) mm from where it should be.", page.page.inner_text("#live-away"))
    assert off is not None and float(off[1]) < 0.05
    # With the smallest step the true motion is still far better than the table that is measured by it.
    page.set("#lab-step", 3)
    eighth = float(page.value("#lab-error"))
    page.set("#lab-step", 4)
    assert eighth / float(page.value("#lab-error")) == pytest.approx(16, rel=0.1)
    page.page.click("#lab-reset")
    assert float(page.value("#lab-error")) == first


def test_a_table_that_no_scheme_alone_has_made_is_not_called_that_of_the_page(written: Any, opened: Any) -> None:
    told = "These are the file’s values. Move a slider."
    assert opened(written("31")).page.inner_text("#lab-ratio") == told
    projected = opened(written("31", project=1))
    assert projected.page.inner_text("#lab-ratio") == ""
    projected.set("#lab-datum", projected.page.get_attribute("#lab-datum", "min"))  # other data are another mechanism's
    assert projected.page.inner_text("#lab-ratio") == ""
    assert opened(written("example-3")).page.inner_text("#lab-ratio") == ""


def marks_of(page: Any, which: str) -> list[str]:
    return page.page.eval_on_selector_all(f"#lab-diagram [data-scheme]{which}", "all => all.map(one => one.dataset.scheme)")


COVERED = """() => {
    const box = (one) => [one.getBoundingClientRect(), one.dataset.names ?? "mark"];
    const field = document.querySelector("#lab-diagram"), names = [...field.querySelectorAll("[data-names]")].map(box);
    const all = [...names, ...[...field.querySelectorAll("[data-scheme]")].map(box)];
    const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 4 && b.top < a.bottom - 4;
    const edge = field.getBoundingClientRect().right;
    return names.filter(([a]) => a.right > edge || all.some(([b]) => b !== a && meet(a, b))).map(([, name]) => name);
}"""


MARK = 5  # half of the height of a mark, in units of the diagram
ABOVE = """() => {
    const height = (name) => document.querySelector(`#lab-diagram ${name}`).getBBox(), title = height(".live-title");
    return height(".live-axes").y - (title.y + title.height);
}"""


@pytest.mark.parametrize("name", first(1, ("31", "example-3")))
def test_every_scheme_has_its_mark_before_anything_is_moved(written: Any, opened: Any, name: str) -> None:
    page = opened(written(name))
    page.page.wait_for_selector(f"#lab-diagram [data-scheme] >> nth={len(SCHEMES) - 1}")
    assert sorted(marks_of(page, "")) == sorted(SCHEMES)
    assert marks_of(page, "[data-tried]") == ["euler"]
    assert page.page.locator("#lab-diagram [data-names]").count() >= 2
    assert page.page.evaluate(COVERED) == []
    assert page.page.evaluate(ABOVE) > MARK, "a mark at the top of the diagram leaves the name of the axis free"
    page.set("#lab-scheme", "rk4", "change")
    page.page.wait_for_selector("#lab-diagram [data-scheme=rk4][data-tried]")
    assert sorted(marks_of(page, "")) == sorted(SCHEMES)  # the try has taken the place of the mark


def test_data_of_another_mechanism_are_compared_with_nothing(written: Any, opened: Any) -> None:
    """Moved at once, before a scheme has been measured: no mark is made with the data of the page for those of the reader."""
    page = opened(written("31"))
    page.set("#lab-datum", "0.96")
    page.page.wait_for_selector("#lab-diagram [data-scheme][data-tried]")
    page.page.wait_for_timeout(500)
    assert set(marks_of(page, "[data-tried]")) == {"euler"}
    page.page.click("#lab-reset")
    page.page.wait_for_selector(f"#lab-diagram [data-scheme] >> nth={len(SCHEMES) - 1}")


def test_each_try_leaves_a_mark_with_the_time_it_took(written: Any, opened: Any) -> None:
    page = opened(written("31"))
    for halvings in (0, 1, 2):
        page.set("#lab-step", halvings)
        page.page.wait_for_selector("#lab-time:not([data-value=''])")
    page.set("#lab-scheme", "heun", "change")
    page.page.wait_for_selector("#lab-time:not([data-value=''])")
    assert 0 < float(page.value("#lab-time")) < 1
    assert page.page.evaluate(COVERED) == []
    assert marks_of(page, "[data-tried]") == ["euler", "euler", "euler", "heun"]
    assert page.said == []


def test_a_dead_point_appears_when_it_is_dragged_into(written: Any, opened: Any) -> None:
    page = opened(written("31"))
    assert page.value("#lab-dead") == ""
    page.set("#lab-datum-name", "alpha", "change")
    page.set("#lab-datum", 0.02)
    assert float(page.value("#lab-dead")) == pytest.approx(PHASE, abs=1e-4)
    assert page.page.inner_text("#lab-dead") == "The motion stops at t = 0.11689 s."
    assert page.page.locator("#lab-table tbody tr").count() == 6
    assert float(page.page.get_attribute("#scrub", "max")) == 5
    page.set("#lab-datum", 4.35)
    assert page.value("#lab-dead") == ""
    assert page.page.locator("#lab-table tbody tr").count() == 25


def test_a_run_that_stops_shows_its_own_dead_point(written: Any, opened: Any) -> None:
    stopped = coursework.load("31").with_data(given={"alpha": 0.02})
    page = opened(written(stopped))
    assert float(page.value("#lab-dead")) == coursework.solve(stopped).stop.time
    # What was set is in no file.
    assert page.page.inner_text("#lab-ratio") == "These are the page’s values. Move a slider."
    assert page.page.inner_text("#lab-reset") == "Back to the page’s values"
    page.set("#lab-datum", page.page.get_attribute("#lab-datum", "min"))
    assert re.search(r"\(page 0.953\): .* of the page’s table 7.30°", page.page.inner_text("#lab-ratio"))
    page.page.click("#lab-reset")
    page.page.focus("#live")
    page.page.keyboard.press("End")
    assert page.row == 6


def test_the_start_follows_a_length_until_the_links_do_not_close(written: Any, opened: Any) -> None:
    page = opened(written("example-1"))
    page.set("#lab-datum-name", "r3", "change")
    longer = coursework.load("example-1")
    value = 1.1 * longer.values["r3"]
    page.set("#lab-datum", value)
    right = coursework.solve(longer.with_data(given={"r3": value}), scheme="euler").motion
    read = "all => all.map(row => [...row.cells].slice(1).map(at => Number(at.dataset.value)))"
    found = page.page.eval_on_selector_all("#lab-table tbody tr", read)
    assert len(found) == len(right.t)
    columns = [place for place, name in enumerate(right.names) if name != "w1"]  # which the crank keeps
    assert abs(np.array(found) - right.rows[:, columns]).max() < 1e-9
    page.set("#lab-datum-name", "r1", "change")
    page.set("#lab-datum", 9 * longer.values["r1"])
    assert page.said == []


@pytest.mark.parametrize("name", first(2, ("variable-crank-table", "v110", "jansen")))
def test_every_datum_goes_from_end_to_end_and_nothing_is_drawn_nowhere(written: Any, opened: Any, name: str) -> None:
    page = opened(written(name))
    for switch in ("traces", "velocities", "centres"):
        page.page.click(f"#live-{switch}")
    drag = """async () => {
      const move = (at, value, event) => { at.value = value; at.dispatchEvent(new Event(event, {bubbles: true})); };
      const painted = () => new Promise((told) => requestAnimationFrame(() => setTimeout(told)));
      const [list, at] = ["#lab-datum-name", "#lab-datum"].map((hook) => document.querySelector(hook)), shown = [];
      for (const {value: datum} of list.options) {
        move(list, datum, "change");
        for (const part of [0, 0.97, 1]) {
          move(at, Number(at.min) + part * (at.max - at.min), "input");
          await painted();
          // What links do not close is not shown, nor what was shown before.
          const closed = document.querySelector("#lab-error").textContent !== "–";
          shown.push(closed || document.querySelector(".live-body path").getAttribute("d") === "" || datum);
        }
      }
      return shown; }"""
    shown = page.page.evaluate(drag)
    assert set(shown) == {True}
    assert page.said == []
