"""Every variant of the catalogue marched in a browser's JavaScript: the rows of Python, to round-off."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.report.live.functions import live_functions
from coursework.report.live.page import live_numbers
from coursework.report.live.script import script_of
from coursework.scene.scene_run import SceneRun
from coursework.variant.catalogue import names
from tests.sample import sampled
from tests.solved import loaded, solved

pytestmark = pytest.mark.browser
# What forces move is marched by other arithmetic, which `test_forces.py` asks.
DRIVEN = [name for name in names() if loaded(name).motor is None]
# What the page itself does with the runtime, here handed to the test.
ASKED = """
const positions = (found) => Array.from({length: found.n}, (_, i) => [...found.q.subarray(i * m, i * m + m)]);
window.marched = (name, h, d, dead) => { const found = table(); drain(march(found, name, h, data.start, d, dead));
  const rows = positions(found).map((at, i) => [...at, ...found.u.subarray(i * width, i * width + data.velocities.length)]);
  return {rows, lost: found.lost, evaluations: found.evaluations}; };
window.followed = (d, known) => { const truth = table(); drain(follow(truth, data.step, 16, data.start, d, known));
  return {rows: positions(truth), dead: truth.dead}; };
window.lawOf = law;
"""


@pytest.fixture(scope="module")
def engine(browser: Any) -> Any:
    page = browser.new_page()
    yield page
    page.close()


def started(page: Any, run: SceneRun) -> dict[str, Any]:
    """Put the arithmetic of a run into an empty page and return its numbers."""
    functions = live_functions(run.scene, [])
    numbers = live_numbers(run, functions)
    page.set_content(f'<script type="application/json" id="coursework">{json.dumps(numbers)}</script>')
    page.evaluate(script_of(functions.text, ("numbers", "marching")).removesuffix("})();") + ASKED + "})()")
    return numbers


def scaled(found: Any, right: np.ndarray) -> float:
    """Return the largest difference, measured by the largest number of its column (1 where that is smaller)."""
    return float(np.max(np.abs(np.array(found) - right) / np.maximum(1.0, np.abs(right).max(axis=0))))


@pytest.mark.parametrize("name", sampled(DRIVEN))
def test_the_rows_of_a_variant_are_those_of_python(engine: Any, name: str) -> None:
    run = solved(name, scheme="euler")
    numbers = started(engine, run)
    found = engine.evaluate("([h, d, stop]) => marched('euler', h, d, stop)", [run.step, numbers["numbers"], numbers["stop"]])
    assert scaled(found["rows"], run.motion.rows) < 1e-12
    assert found["evaluations"] == run.motion.evaluations
    assert not found["lost"]


@pytest.mark.parametrize("scheme", ["midpoint", "heun", "ralston", "rk4"])
@pytest.mark.parametrize("name", ["31", "robot-arm", "variable-crank-table", "walschaerts"])
def test_every_scheme_steps_as_in_python(engine: Any, name: str, scheme: str) -> None:
    run = solved(name, scheme=scheme)
    numbers = started(engine, run)
    found = engine.evaluate("([name, h, d]) => marched(name, h, d, null)", [scheme, run.step, numbers["numbers"]])
    assert scaled(found["rows"], run.motion.rows) < 1e-12
    assert found["evaluations"] == run.motion.evaluations


@pytest.mark.parametrize("name", sampled(DRIVEN))
def test_the_true_motion_is_that_of_the_closed_positions(engine: Any, name: str) -> None:
    run = solved(name)
    numbers = started(engine, run)
    found = engine.evaluate("([d, stop]) => followed(d, stop)", [numbers["numbers"], numbers["stop"]])
    rows, right = np.array(found["rows"]), run.exact.coordinates
    assert found["dead"] == numbers["stop"]
    # A table is no smoother than its nodes; elsewhere Runge-Kutta steps a sixteenth of the step are far better than any table.
    assert scaled(rows, right) < (1e-6 if run.scene.equations.tables else 2e-8)


def test_a_dead_point_is_found_where_the_search_in_python_finds_it(engine: Any) -> None:
    stopped = coursework.solve(coursework.load("31").with_data(given={"alpha": 0.02}))
    numbers = started(engine, stopped)
    found = engine.evaluate("(d) => followed(d, null)", numbers["numbers"])
    assert found["dead"] == pytest.approx(stopped.stop.time, abs=1e-5)
    rows = engine.evaluate("([h, d, stop]) => marched('euler', h, d, stop)", [0.02, numbers["numbers"], found["dead"]])["rows"]
    assert len(rows) == len(stopped.motion.t)


def test_data_are_arguments(engine: Any) -> None:
    """The page of one set of data gives the table of another."""
    numbers = started(engine, coursework.solve("v108", scheme="euler"))
    longer, turned = 0.6 - 0.586, 5.03  # of the crank: the cylinder stands further off by as much
    data = {
        "p": 11.0,
        "r1": 0.6,
        "xO": 1.65234142179306 + longer * np.cos(turned),
        "yO": -1.70179650956438 + longer * np.sin(turned),
    }
    other = coursework.solve(coursework.load("v108").with_data(given=data), scheme="euler", step=0.02, end=0.48)
    moved = [data.get(name, value) for name, value in numbers["given"].items()]
    found = engine.evaluate("([h, d]) => marched('euler', h, d, null)", [0.02, moved])
    assert scaled(found["rows"], other.motion.rows) < 1e-12


@pytest.mark.parametrize("method", ["five-point", "spline"])
def test_a_tabulated_law_is_that_of_python_by_either_method(engine: Any, method: str) -> None:
    variant = coursework.load("variable-crank-table")
    laws = tuple(replace(law, method=method) for law in variant.functions)
    run = coursework.solve(replace(variant, functions=laws), scheme="euler")
    law = run.scene.equations.tables[laws[0].name]
    started(engine, run)
    times = np.linspace(law.first, law.last, 77)
    for order in range(3):
        found = engine.evaluate("([name, order, times]) => times.map(lawOf(name, order))", [laws[0].name, order, times.tolist()])
        right = law.function(order)(times)
        assert np.max(np.abs(np.array(found) - right)) < 1e-12 * np.max(np.abs(right)), order
        outside = engine.evaluate(
            "([name, order, t]) => Number.isNaN(lawOf(name, order)(t))", [laws[0].name, order, law.last + law.step]
        )
        assert outside
