"""How much the page does for a paint, a frame and a move: counted in a browser, never timed."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.motion.schemes import SCHEMES
from tests.sample import first
from tests.solved import solved

pytestmark = pytest.mark.browser
# Counts what the page calls: trigonometry (velocities and places), elements made, attributes set, layouts asked for.
# `tasks`: the trigonometry of every piece of work that was put off while the error was not known.
COUNTING = """
window.done = {trigonometry: 0, made: 0, set: 0, asked: 0, tasks: []};
for (const name of ["sin", "cos"]) { const own = Math[name]; Math[name] = (x) => { done.trigonometry++; return own(x); }; }
const counted = (home, name, key) => {
  const own = home[name];
  home[name] = function (...all) { done[key]++; return own.apply(this, all); };
};
counted(Document.prototype, "createElement", "made"); counted(Document.prototype, "createElementNS", "made");
counted(Node.prototype, "cloneNode", "made"); counted(Element.prototype, "setAttribute", "set");
counted(Element.prototype, "getBoundingClientRect", "asked");
const later = window.setTimeout;
window.setTimeout = (act, wait, ...rest) => later(() => {
  const before = done.trigonometry, open = document.querySelector("#lab-error").dataset.value === "";
  act();
  if (open) done.tasks.push(done.trigonometry - before);
}, wait, ...rest);
addEventListener("DOMContentLoaded", () => {
  const count = (wanted) => document.querySelectorAll(wanted).length;
  const drawn = document.querySelector(".live-body path").getAttribute("d");
  window.first = {...done, panels: count("#live-panels [data-panel]"), lines: count("#lab-table tbody tr"), drawn};
}, true);
"""
# The page is told that frames come 1/60 s apart, however slowly they come: what a row lights up is not for every frame.
STEADY = """{
  const own = requestAnimationFrame;
  let first, last, count = -1;
  window.requestAnimationFrame = (act) => own((stamp) => {
    first ??= stamp;
    if (stamp !== last) count++;
    last = stamp;
    act(first + (count * 1000) / 60);
  });
}"""
EVALUATION = 7  # sines and cosines of the velocities of variant 31
SLICE = 4256  # evaluations that nothing else has to wait for: a fraction of a frame


def counted(opened: Any, folder: Any) -> Any:
    return opened(folder, COUNTING)


def rest(page: Any) -> None:
    """Wait until the page has measured what is tried and every scheme that it is compared with, and is at rest."""
    page.wait_for_selector("#lab-time:not([data-value=''])")
    page.wait_for_selector(f"#lab-diagram [data-scheme] >> nth={len(SCHEMES) - 1}")


def cost(page: Any, hook: str, value: object, event: str = "input") -> dict[str, int]:
    """Return how often each thing is done at once when a control is moved."""
    act = """([hook, value, event]) => {
      const at = document.querySelector(hook), before = {...done};
      at.value = value;
      at.dispatchEvent(new Event(event, {bubbles: true}));
      return Object.fromEntries(["trigonometry", "made", "asked"].map((key) => [key, done[key] - before[key]])); }"""
    found: dict[str, int] = page.page.evaluate(act, [hook, value, event])
    page.page.wait_for_selector("#lab-time:not([data-value=''])")
    return found


@pytest.mark.parametrize("name", first(1, ("jansen", "31")))
def test_the_mechanism_is_drawn_before_the_laboratory_is_built(written: Any, opened: Any, name: str) -> None:
    page = counted(opened, written(name))
    first, whole = page.page.evaluate("first"), page.page.evaluate("done.trigonometry")
    assert first["drawn"].startswith("M")
    assert (first["panels"], first["lines"]) == (0, 0)
    # One Runge-Kutta step a row and the places of what is drawn, against sixteen steps a row.
    assert 3 * first["trigonometry"] < whole
    # When the page is there, so is all of the laboratory.
    assert page.page.locator("#lab-table tbody tr").count() == len(solved(name).motion.t)
    assert float(page.value("#lab-error")) > 0


@pytest.mark.parametrize("name", first(1, ("jansen", "31")))
def test_a_frame_makes_nothing_and_sets_only_what_moves(written: Any, opened: Any, name: str) -> None:
    page = counted(opened, written(name))
    rest(page.page)
    page.page.select_option("#speed", "0.05")
    page.page.click("#play")
    # In the first eight frames the sentences of the start give way to longer ones, whose pieces are made once.
    frames = """new Promise((told) => {
      let left = 28, from = null;
      const since = (key) => done[key] - from[key];
      const frame = () => {
        if (left === 20) from = {...done};
        left-- ? requestAnimationFrame(frame) : told([since("made"), since("asked"), since("set") / 20]);
      };
      requestAnimationFrame(frame); })"""
    made, asked, written_a_frame = page.page.evaluate(frames)
    assert (made, asked) == (0, 0)
    words = page.page.locator(".live-words > text").count()
    # Both mechanisms, joints, the text of the scrub, two coordinates of names and numbers; a cursor sets nothing.
    assert written_a_frame <= 5 + 2 * words


@pytest.mark.parametrize("name", ["31", pytest.param("jansen", marks=pytest.mark.long)])
def test_a_frame_leaves_the_layers_of_the_page_as_they_are(written: Any, opened: Any, browser: Any, name: str) -> None:
    """Layers made anew go through all that the page has painted, which costs more than all the rest of a frame."""
    page = opened(written(name), STEADY).page
    rest(page)
    page.click("#play")

    def per_frame(act: str) -> tuple[float, float, float]:
        """Return how often a frame makes layers, lays out and computes styles while `act` is done before each."""
        frames = f"""new Promise((told) => {{
          let left = 60; const frame = () => {{ {act}; left-- ? requestAnimationFrame(frame) : told() }};
          requestAnimationFrame(frame); }})"""
        page.wait_for_timeout(300)
        browser.start_tracing(page=page, categories=["blink", "devtools.timeline"])
        page.evaluate(frames)
        names = [event["name"] for event in json.loads(browser.stop_tracing())["traceEvents"] if event["ph"] == "X"]
        done = ("PaintArtifactCompositor::Update", "Layout", "UpdateLayoutTree")
        # The page and this test are each told of every frame.
        return tuple(2 * names.count(each) / names.count("FireAnimationFrame") for each in done)

    layers, layouts, styles = per_frame("")
    assert layers <= 0.3
    assert max(layouts, styles) <= 1.2
    # A box that comes and goes makes the layers anew at every frame: so it is counted.
    there = "document.querySelector('h1').style.willChange = left % 2 ? 'transform' : ''"
    assert per_frame(there)[0] > 0.7


def test_a_move_does_only_what_it_changes(written: Any, opened: Any) -> None:
    page = counted(opened, written("31"))
    rest(page.page)
    datum = cost(page, "#lab-datum", 0.96)
    scheme = cost(page, "#lab-scheme", "heun", "change")
    # A scheme leaves the true motion, 24 rows of 16 steps of 4 slopes, as it is.
    assert datum["trigonometry"] - scheme["trigonometry"] > 24 * 16 * 4 * EVALUATION * 0.9
    # Lines and axes that were there before are not made again.
    cost(page, "#lab-step", 1)
    cost(page, "#lab-step", 0)
    again = cost(page, "#lab-step", 1)
    assert again["made"] <= 10
    assert again["asked"] == 0


# What a move changes, until it is painted and with each paint after it: graphs, and texts of the table.
BY_FRAME = """([hook, value, event]) => new Promise((told) => {
  const at = document.querySelector(hook), found = [[0, []]];
  const take = (changes) => {
    const now = found.at(-1);
    for (const {type, target} of changes) {
      if (type === "characterData") { now[0]++; continue; }
      const graph = target.closest("[data-panel]").dataset.panel;
      if (!now[1].includes(graph)) now[1].push(graph);
    } };
  const seen = new MutationObserver(take);
  for (const body of document.querySelectorAll("#lab-table tbody, #live-panels")) {
    seen.observe(body, {subtree: true, characterData: true, attributeFilter: ["d"]}); }
  at.value = value;
  at.dispatchEvent(new Event(event, {bubbles: true}));
  take(seen.takeRecords());
  let left = 60;
  const frame = () => { found.push([0, []]); left-- ? requestAnimationFrame(frame) : told(found); };
  requestAnimationFrame(frame); })"""
PIECES, SPELLED = 4, 60  # of graphs and table that a paint waits for, and cells of such a piece of a table


def test_a_move_draws_few_pieces_for_each_paint_those_in_sight_first(written: Any, opened: Any) -> None:
    page = opened(written("jansen")).page
    rest(page)
    columns, rows = (page.locator(f"#lab-table {all_}").count() for all_ in ("th", "tbody tr"))
    piece = SPELLED + columns
    for place, scheme in (("h1", "heun"), ("#lab-table", "euler")):
        page.eval_on_selector(place, "at => at.scrollIntoView()")
        page.wait_for_timeout(300)
        on_screen = "at => { const {top, bottom} = at.getBoundingClientRect(); return bottom >= 0 && top <= innerHeight; }"
        in_sight = page.locator("#live-panels [data-panel] svg").evaluate_all(
            f"all => all.filter({on_screen}).map(at => at.closest('[data-panel]').dataset.panel)"
        )
        frames = page.evaluate(BY_FRAME, ["#lab-scheme", scheme, "change"])
        for texts, graphs in frames:
            assert len(graphs) + texts / piece <= PIECES
        drawn = [graph for _, graphs in frames for graph in graphs]
        first = [graph in in_sight for graph in drawn]
        assert first == sorted(first, reverse=True)
        assert len(drawn) == len(set(drawn)) >= 10
        assert (frames[0][0] + frames[1][0] + frames[2][0] > 0) == (place == "#lab-table")
        # In the end every text is that of its value.
        page.wait_for_selector("#lab-time:not([data-value=''])")
        read = "all => all.map((at) => [at.textContent, Number(at.dataset.value)])"
        cells = page.eval_on_selector_all("#lab-table tbody td", read)
        assert len(cells) == rows * columns
        assert all(abs(float(text.replace("−", "-")) - value) <= 1e-3 * max(1.0, abs(value)) for text, value in cells)
    assert page.locator("[aria-busy]").count() == 0


def test_while_a_slider_is_dragged_every_graph_and_the_table_have_their_turn(written: Any, opened: Any) -> None:
    page = opened(written("31"), viewport={"width": 1400, "height": 1500}).page
    rest(page)
    page.eval_on_selector(".live-laboratory", "at => at.scrollIntoView()")
    page.wait_for_timeout(300)
    state = """[...document.querySelectorAll("#live-panels path.live-table")].map((path) => path.getAttribute("d"))
      .concat(document.querySelector("#lab-table tbody tr:nth-child(3)").textContent)"""
    drag = f"""new Promise((told) => {{
      const at = document.querySelector("#lab-datum"), low = Number(at.min), high = Number(at.max);
      let k = 0;
      const frame = () => {{
        at.value = low + (high - low) * (0.5 + 0.004 * ++k);
        at.dispatchEvent(new Event("input", {{bubbles: true}}));
        k < 8 ? requestAnimationFrame(frame) : told({state});
      }};
      requestAnimationFrame(frame); }})"""
    before, during = page.evaluate(state), page.evaluate(drag)
    page.wait_for_selector("#lab-time:not([data-value=''])")
    moved = [then != now for then, now in zip(before, page.evaluate(state), strict=True)]
    assert sum(moved) > 4
    assert [then != now for then, now in zip(before, during, strict=True)] == moved


def test_a_move_lays_out_only_what_it_shows(written: Any, opened: Any, browser: Any) -> None:
    page = opened(written("31")).page
    rest(page)
    page.eval_on_selector(".live-laboratory", "at => at.scrollIntoView()")
    page.wait_for_timeout(300)
    browser.start_tracing(page=page, categories=["devtools.timeline"])
    page.evaluate(BY_FRAME, ["#lab-scheme", "heun", "change"])
    events = json.loads(browser.stop_tracing())["traceEvents"]
    dirty = [event["args"]["beginData"]["dirtyObjects"] for event in events if event["name"] == "Layout" and event["ph"] == "X"]
    # Four graphs, and what is told beside the sliders; later 4 pieces of the table with two objects a cell.
    assert 0 < max(dirty) <= PIECES * (2 * SPELLED + 20)
    assert dirty[0] <= 160


def test_a_long_table_is_computed_in_slices_and_its_numbers_wait_for_the_end(written: Any, opened: Any) -> None:
    step = 0.48 / 511
    page = counted(opened, written("31", step=step))
    page.page.wait_for_selector("#lab-time:not([data-value=''])")
    page.page.evaluate("done.tasks.length = 0")
    drawn = "document.querySelector('.live-body path').getAttribute('d')"
    move = """(value) => { const at = document.querySelector("#lab-datum"), body = document.querySelector(".live-body path");
      const was = body.getAttribute("d"), error = document.querySelector("#lab-error"); at.value = value;
      at.dispatchEvent(new Event("input", {bubbles: true}));
      return [body.getAttribute("d") !== was, error.dataset.value, error.textContent]; }"""
    assert page.page.evaluate(drawn).startswith("M")
    value = 1.01 * coursework.load("31").values["r1"]
    # At once it is drawn; what can be read is open until it is known.
    assert page.page.evaluate(move, value) == [True, "", "…"]
    page.page.wait_for_selector("#lab-error:not([data-value=''])")
    right = coursework.solve(coursework.load("31").with_data(given={"r1": value}), step=step)
    worst = np.abs(right.motion.coordinates - right.exact.coordinates).max()
    assert float(page.value("#lab-error")) == pytest.approx(worst, rel=1e-6)
    # 511 rows of 16 steps of 4 slopes, of which the first 8000 evaluations are made at once.
    tasks = page.page.evaluate("done.tasks")
    assert len(tasks) >= (511 * 64 - 8000) / SLICE
    drawing = 2000 * EVALUATION
    assert max(tasks) <= SLICE * EVALUATION + drawing
