"""Pages of files with forces: rows, reactions and energy in JavaScript are those of Python; a page without forces has none."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.report.live.by_forces import moved_by
from coursework.report.live.page import MOST_BYTES, live_numbers, live_part
from coursework.report.live.script import script_of, shortened
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.scene.scene_run import SceneRun
from tests.effects.massed import of_text
from tests.effects.moved import free_31
from tests.mechanisms.library import mechanism
from tests.solved import solved

ASKED = """
window.marched = (name, h) => { const found = table(), d = Float64Array.from(data.numbers);
  early.step = data.schemes[name].early ? h : 0; drain(march(found, name, h, data.start, d, null)); early.step = 0;
  return Array.from({length: found.n}, (_, i) => [...found.q.subarray(i * m, i * m + m)]); };
"""
REACTIONS = """
window.acting_on = (t, q, d = data.numbers) => { acts.on(t, Float64Array.from(q), Float64Array.from(d));
  return [acts.reactions().slice(0, unknowns.length), acts.energy]; };
"""

OUTSIDE = """
() => { const field = document.querySelector('#live-field').getBoundingClientRect(), scrub = document.querySelector('#scrub');
  const found = [];
  for (let row = 0; row <= scrub.max; row++) {
    scrub.value = row;
    scrub.dispatchEvent(new Event('input'));
    for (const one of document.querySelectorAll('.live-arrows > *')) {
      const box = one.getBoundingClientRect();
      const off = Math.max(field.left - box.left, box.right - field.right, field.top - box.top, box.bottom - field.bottom);
      if (off > 1) found.push([row, one.textContent, off]);
    }
  }
  return found; }
"""

COVERED = """
() => { const [scrub, body] = ['#scrub', '.live-body path'].map((which) => document.querySelector(which)), found = [];
  for (let row = 0; row <= scrub.max; row++) {
    scrub.value = row;
    scrub.dispatchEvent(new Event('input'));
    const parts = [...body.getAttribute('d').matchAll(/M([^M]*)/g)];
    const ways = parts.map(([, way]) => way.split('L').map((at) => at.split(' ').map(Number)));
    const lines = ways.filter((way) => way.length > 1 && way.flat().every(isFinite)); // links; wheels and blocks are closed
    for (const one of document.querySelectorAll('.live-arrows text')) {
      const { x, y, width, height } = one.getBBox();
      const inside = ([px, py]) => px > x && px < x + width && py > y + 0.2 * height && py < y + 0.8 * height;
      const between = (a, b, part) => [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
      const on = (a, b) => Array.from({ length: 101 }, (_, k) => between(a, b, k / 100)).some(inside);
      if (lines.some((way) => way.slice(1).some((to, k) => on(way[k], to)))) found.push([row, one.textContent]);
    }
  }
  return found; }
"""


@pytest.fixture(scope="module")
def engine(browser: Any) -> Any:
    page = browser.new_page()
    yield page
    page.close()


def started(page: Any, run: SceneRun, more: str = "") -> None:
    """Put the arithmetic of a run with forces into an empty page."""
    found = moved_by(run, [])
    numbers = live_numbers(run, found.functions) | found.numbers
    page.set_content(f'<script type="application/json" id="coursework">{json.dumps(numbers)}</script>')
    pieces = ("numbers", *(("free_motion",) if "free" in numbers["forces"] else ()), "marching", "acting")
    page.evaluate(script_of(shortened(found.functions.text), pieces).removesuffix("})();") + REACTIONS + more + "})()")


def moving(name: str, **options: Any) -> SceneRun:
    return coursework.solve(coursework.parse_variant(free_31() if name == "free 31" else mechanism(name)), **options)


@pytest.mark.long
@pytest.mark.browser
@pytest.mark.parametrize("name", ["example-2-motor", "falling-arm", "free 31"])
@pytest.mark.parametrize("scheme", ["euler", "semi-implicit", "rk4"])
def test_rows_that_forces_make_are_those_of_python(engine: Any, name: str, scheme: str) -> None:
    run = moving(name, scheme=scheme, end=0.3)
    started(engine, run, ASKED)  # marched on where the motion itself has ended, as in Python
    found = np.array(engine.evaluate("([name, h]) => marched(name, h)", [scheme, run.step]))
    names = [*(c.name for c in run.variant.coordinates), *run.variant.motor.rates]
    right = np.column_stack([run.motion.column(name) for name in names])
    assert found.shape == right.shape
    assert np.abs(found - right).max() < 1e-10 * np.abs(right).max()


@pytest.mark.browser
@pytest.mark.parametrize(
    "name", ["31-forces", "example-1-forces", "example-4-forces", "andrews-forces", "bar-through-a-sleeve", "free 31"]
)
def test_reactions_and_energy_are_those_of_python(engine: Any, name: str) -> None:
    run = moving(name, scheme="rk4", **({"end": 0.2} if name == "free 31" else {}))
    started(engine, run)
    forces: ForceAnalysis = run.results.forces
    free = run.variant.motor.rates if run.variant.motor else ()
    for row in (0, len(run.motion.t) // 2):
        q = [*run.motion.coordinates[row].tolist(), *(float(run.motion.column(rate)[row]) for rate in free)]
        found, energy = engine.evaluate("([t, q]) => acting_on(t, q)", [float(run.motion.t[row]), q])
        assert np.abs(np.array(found) - forces.reactions.rows[row]).max() < 1e-9 * forces.reactions.largest
        assert energy == pytest.approx(forces.energy.kinetic[row] + forces.energy.potential[row], rel=1e-10)


@pytest.mark.browser
def test_masses_and_loads_given_as_numbers_are_data_of_the_page(engine: Any) -> None:
    """A mass that is moved takes its inertia along, a torque has its size, and reactions follow."""
    run = coursework.solve("example-1-forces", scheme="exact")
    started(engine, run)
    scene = moved_by(run, []).scene
    order = [given.name for given in scene.variant.given]
    assert order[-4:] == ["m_1", "m_2", "m_3", "Q1"]
    heavier = of_text(
        mechanism(
            "example-1-forces", ('mass = "10 kg", inertia = "0.833 kg*m^2"', 'mass = "15 kg", inertia = "1.2495 kg*m^2"'),
            ('torque = "-60 N*m"', 'torque = "-90 N*m"'),
        ), scheme="exact",
    )  # fmt: skip
    moved = {"m_2": 15.0, "Q1": -90.0}
    values = [moved.get(name, value) for name, value in scene.variant.values.items()]
    found, _ = engine.evaluate("([t, q, d]) => acting_on(t, q, d)", [0.0, run.motion.coordinates[0].tolist(), values])
    assert np.abs(np.array(found) - heavier.reactions.rows[0]).max() < 1e-9 * heavier.reactions.largest


@pytest.mark.browser
def test_the_arm_is_seen_to_gain_energy_until_it_is_nonsense(written: Any, opened: Any) -> None:
    page = opened(written("falling-arm"))
    assert float(page.value("#live-energy")) == pytest.approx(17.940, abs=0.001)
    page.page.focus("#live")
    page.page.keyboard.press("End")
    assert float(page.value("#live-energy")) == pytest.approx(21.015, abs=0.001)
    assert "3.07 J more than the true one: " in page.page.inner_text("#live-gained")
    assert "absolute error, rad or rad/s" in page.page.text_content("#lab-diagram")
    page.set("#lab-step", -2)
    page.page.wait_for_function("document.querySelector('#lab-error').dataset.value > 13.5")
    page.page.focus("#live")
    page.page.keyboard.press("End")
    assert float(page.value("#live-energy")) > 40
    page.set("#lab-scheme", "rk4", "change")
    page.page.wait_for_function("document.querySelector('#lab-error').dataset.value < 1")
    assert page.page.inner_text("#live-gained") == ""
    assert page.said == []


@pytest.mark.browser
def test_reactions_are_arrows_and_both_drives_are_told(written: Any, opened: Any) -> None:
    page = opened(written("31-forces"), viewport={"width": 390, "height": 800})
    page.page.click("#live-velocities")
    assert page.page.evaluate(OUTSIDE) == []  # no arrow and no name is cut at the edge of the drawing
    page.page.click("#live-velocities")
    page.set("#scrub", 19)
    assert "FMy = −2564 N; dashed: −1254 N." in page.page.inner_text("#live-drive")
    arrows = "document.querySelectorAll('#live-field > g:last-child path').length"
    assert page.page.evaluate(arrows) > 6
    page.page.click("#live-forces")
    assert page.page.evaluate(arrows) == 0
    assert {"E", "FMx", "FMy"} <= set(page.page.eval_on_selector_all("[data-panel]", "all => all.map(one => one.dataset.panel)"))
    assert page.page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.said == []


@pytest.mark.browser
def test_names_of_reactions_keep_off_the_links(written: Any, opened: Any) -> None:
    page = opened(written("example-2-motor"))
    page.page.click("#live-velocities")  # what is drawn is drawn anew
    assert page.page.locator(".live-arrows text").count() > 0
    assert page.page.evaluate(COVERED) == []


@pytest.mark.parametrize("name", ["31-forces", "example-2-motor", "whitworth-forces", "andrews-forces", "free 31"])
def test_a_page_with_forces_has_its_laboratory_in_sixty_kilobytes(name: str) -> None:
    part = live_part(PageContext(moving(name, end=0.04) if name == "free 31" else solved(name), load_words("en")))
    assert part is not None
    assert (part.laboratory, part.forces) == (True, True)
    assert part.size <= MOST_BYTES


def test_a_page_without_forces_has_nothing_of_them() -> None:
    part = live_part(PageContext(solved("31"), load_words("en")))
    assert part is not None
    assert not part.forces
    assert "acting" not in part.script
    assert "forces" not in json.loads(part.data)
    assert '"force_' not in part.script
