"""Pages of what nobody expects: names without end or from right to left, one link, twenty of them, a hundred rows.

`screen.js` judges; tables of seventeen digits and of forty columns are judged in `test_look.py` and here as feedback.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pymupdf
import pytest

import coursework
from coursework.report.pages import build_model, render_html, render_pdf
from coursework.variant.reading.reader import parse_variant
from tests.command import call
from tests.report.pages.all_kinds import LONG
from tests.report.pages.test_look import PAPER, WIDTHS, sized

pytestmark = pytest.mark.browser

WORD = "Donaudampfschifffahrtselektrizitätenhauptbetriebswerkbauunterbeamtengesellschaft"
ARABIC = "محمد بن عبد الله بن عبد المطلب"
HEAD = """
format = 1
title = "{count} links"
[given]
r1 = "0.4 m"
r2 = "1.0 m"
r3 = "0.7 m"
r4 = "1.2 m"
w0 = "10 rad/s"
[drive]
w1 = "w0"
[time]
step = "2*pi/(36*w0)"
end = "2*pi/w0"
period = "2*pi/w0"
[ask]
quantities = ["table", "plots", "checks", "graph_check", "accelerations"]
[coordinates]
theta1 = {{ start = "0 deg", rate = "w1" }}
"""
# What stands on a sheet that lies has 257 mm between its margins.
OUTSIDE = """[...document.querySelectorAll("main *")].filter((one) => !one.closest("#live") &&
  one.getBoundingClientRect().right > 1 + (one.closest(".wide, #graph_check:has(> .wide)") ? 971 : innerWidth))
  .map((one) => one.outerHTML.slice(0, 80))"""


def star(dyads: int) -> str:
    """Return a file: a crank whose pin drives so many dyads, each with a pivot of its own."""
    pairs = [(k, 2 * k + 2, 2 * k + 3) for k in range(dyads)]
    lines = [HEAD.format(count=1 + 2 * dyads)]
    lines += [f'theta{k} = {{ rate = "w{k}", unit = "rad" }}' for _, *both in pairs for k in both]
    lines += ["[points]", 'A = "(0, 0)"']
    lines += [f'D{k} = "(r4*cos({k}*2*pi/9), r4*sin({k}*2*pi/9))"' for k, *_ in pairs]
    lines.append('[[group]]\nkind = "crank"\nfrom = ["A"]\nmeets = "B"\nlengths = ["r1"]\ncoordinates = ["theta1"]')
    lines += [
        f'[[group]]\nkind = "RRR"\nfrom = ["B", "D{k}"]\nmeets = "C{k}"\nlengths = ["r2", "r3"]\n'
        f'coordinates = ["theta{coupler}", "theta{rocker}"]\nmode = "+1"'
        for k, coupler, rocker in pairs
    ]
    lines += ["[links]", '1 = { points = ["A", "B"], rate = "w1" }']
    for k, coupler, rocker in pairs:
        lines.append(f'{coupler} = {{ points = ["B", "C{k}"], rate = "w{coupler}" }}')
        lines.append(f'{rocker} = {{ points = ["D{k}", "C{k}"], rate = "w{rocker}" }}')
    return "\n".join([*lines, "[frame]", f"hinges = {['A', *(f'D{k}' for k, *_ in pairs)]}".replace("'", '"'), ""])


def named() -> coursework.Run:
    text = (Path(__file__).parents[3] / "variants" / "31.toml").read_text(encoding="utf-8")
    text = text.replace("Rolling wheel, right-angled link, crank and rod", f"{LONG} {WORD}").replace('"DA"', f'"{LONG}"')
    return coursework.solve(parse_variant(text), student=ARABIC, group=ARABIC, teacher=LONG, institution=LONG + WORD)


RUNS = {
    "names": named,
    "one": lambda: coursework.solve(parse_variant(star(0))),
    "twenty": lambda: coursework.solve(parse_variant(star(9))),
    "rows": lambda: coursework.solve("31", step=0.0048),
}


@pytest.mark.parametrize("kind", ["names", "one", *(pytest.param(kind, marks=pytest.mark.long) for kind in ("twenty", "rows"))])
def test_nothing_leaves_its_place(kind: str, tmp_path: Path, browser: Any) -> None:
    model = build_model(RUNS[kind](), live=True)
    (tmp_path / "page.html").write_text(render_html(model), encoding="utf-8")
    assert seen(tmp_path / "page.html", browser) == []
    with pymupdf.open(stream=render_pdf(model), filetype="pdf") as document:
        assert all(sheet.rect.contains(pymupdf.Rect(block[:4])) for sheet in document for block in sheet.get_text("blocks"))


def seen(path: Path, browser: Any) -> list[str]:
    """Return what is complained of on three screens and on paper."""
    context = browser.new_context()
    context.add_init_script(path=Path(__file__).parent / "screen.js")
    page = context.new_page()
    page.goto(path.as_uri())
    found = list(page.evaluate("judge.access()"))
    for width in WIDTHS:
        sized(page, width)
        found += page.evaluate("judge.layout()")
    page.emulate_media(media="print")
    sized(page, PAPER)
    found += page.evaluate(OUTSIDE)
    context.close()
    return found


def test_a_crank_alone_is_not_called_wrong(tmp_path: Path) -> None:
    """It has no equation that could hold, no determinant and nothing that is solved for."""
    run = RUNS["one"]()
    told = {one.code: one.verdict for one in run.checks}
    assert {told[code] for code in ("INITIAL", "RESIDUAL", "CONDITION", "PERIOD-ASSEMBLY", "PEAK")} == {"SKIP"}
    assert "ERROR" not in told.values() and told["ACCURACY"] == "PASS"
    assert {one.code: str(one.sentence) for one in run.checks}["PEAK"] == "There is nothing to solve for."


@pytest.mark.long
def test_feedback_of_forty_columns(tmp_path: Path, browser: Any) -> None:
    (tmp_path / "star.toml").write_text(star(9), encoding="utf-8")
    call("run", tmp_path / "star.toml", "--format", "csv", "--out", tmp_path / "key")
    for name in (LONG, ARABIC):
        (tmp_path / "handed" / name).mkdir(parents=True)
        table = (tmp_path / "key" / "table.csv").read_text(encoding="utf-8")
        (tmp_path / "handed" / name / "table.csv").write_text(table, encoding="utf-8")
    call("grade", tmp_path / "handed", "--variant", tmp_path / "star.toml", "--out", tmp_path / "marks", "--jobs", "0")
    pages = [tmp_path / "marks" / "class.html", *(tmp_path / "marks" / "feedback").iterdir()]
    assert len(pages) == 3
    assert [fault for page in pages for fault in seen(page, browser)] == []
