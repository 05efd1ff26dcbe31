"""Hostile text in every field of a file and of the command line: refused, or shown as the text it is; in HTML, SVG and PDF."""

from __future__ import annotations

import json
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework.report.pages import build_model, render_html, render_pdf
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError

EVIL = (
    "</title></svg></style><script>window.hit=1</script><img src=x onerror='window.hit=1'>]]>--> {{7*7}} {% raw %} %s {0} {t} "
    '#eval("1+1") #read("/etc/passwd") $x_$ \\frac{ "quoted" &amp; \u202eabc\u202c ../../x'
)
FIELDS = {  # a field: the text of variant 31 that holds it, and where the hostile text goes
    "title": ('"Rolling wheel, right-angled link, crank and rod"', "{evil}"),
    "source": ('"B. B. Ponomarev, coursework guide, Irkutsk 1995, variant 31"', "{evil}"),
    "teaches": ('teaches = "A chain', "teaches = {evil} # "),
    "remarks": ('remarks = ["""', 'remarks = [{evil}, """'),
    "means": ('r1    = "0.953 m"', 'r1 = {{ value = "0.953 m", means = {evil} }}'),
    "value": ('"0.847 m"', "{evil}"),
    "drive": ('VMx = "0"', "VMx = {evil}"),
    "start": ('"1.63 rad"', "{evil}"),
    "rate": ('rate = "w2" }', "rate = {evil} }}"),
    "unit": ('w4 = "1/s"', "w4 = {evil}"),
    "datum": ('alpha = "4.35 rad"', 'alpha = "4.35 rad"\n{evil} = "1 m"'),
    "period": ('"2*pi/p"', "{evil}"),
    "name": ('name     = "11"', "name = {evil}"),
    "because": ('because  = "C keeps its height: V_Cy = 0 along M-B-C"', "because = {evil}"),
    "equation": ('"r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0"', "{evil}"),
    "point": ('D = "(0, 0)"', 'D = "(0, 0)"\n{evil} = "(1, 1)"'),
    "place": ('A = "D + r1 @ phi1"', "A = {evil}"),
    "link": ("4 = { wheel", "{evil} = {{ wheel"),
    "body": ('points = ["D", "A"]', 'points = ["D", {evil}]'),
    "hinge": ('hinges = ["D"]', "hinges = [{evil}]"),
    "rail": ('through = "P"', "through = {evil}"),
    "driven": ('driven = "M"', "driven = {evil}"),
    "ask": ('"table", "plots"', '"table", {evil}'),
    "language": ("[text.ru]", "[text.{evil}]"),
}
SHOWN = frozenset({"title", "source", "remarks", "means", "name", "because"})
NAME = "<img src=x onerror=hit()>{{7*7}}"  # a constraint may be called anything that is short
TRANSLATED = """
[text.en]
title = {evil}
source = {evil}
remarks = [{evil}]
[text.en.because]
11 = {evil}
[text.en.means]
r1 = {evil}
"""
V31 = (Path(__file__).parents[3] / "variants" / "31.toml").read_text(encoding="utf-8")


def put(field: str, text: str = V31) -> str:
    """Return the file with hostile text in a field."""
    old, new = FIELDS[field]
    assert old in text, field
    return text.replace(old, new.format(evil=json.dumps(NAME if field == "name" else EVIL)), 1)


def is_harmless(page: str) -> bool:
    """Return whether a page has no element of the hostile text."""
    return not any(bad in page for bad in ("<script>window", "<img", "\u202e", "root:"))


@pytest.mark.parametrize("field", FIELDS)
def test_a_field_is_refused_in_a_sentence_or_shown(field: str, reading: ModuleType) -> None:
    try:
        run = coursework.solve(parse_variant(put(field)))
    except InputError as refused:
        assert field not in SHOWN, refused
        assert all(fault.message for fault in refused.faults)
        return
    page = render_html(build_model(run))
    assert is_harmless(page)
    packed = reading.html_text(page).replace(" ", "").replace("·", "*")  # a product of a remark is set as one
    if field in SHOWN:
        assert "{{7*7}}" in packed, field


@pytest.mark.browser
def test_a_page_full_of_it_runs_nothing_and_prints(opened: Any, tmp_path: Path) -> None:
    text = V31
    for field in sorted(SHOWN):
        text = put(field, text)
    text += TRANSLATED.format(evil=json.dumps(EVIL))
    said = dict.fromkeys(("student", "group", "teacher", "institution", "date"), EVIL)
    run = coursework.solve(parse_variant(text), **said)
    model = build_model(run, live=True)
    assert render_pdf(model).startswith(b"%PDF")
    (tmp_path / "report.html").write_text(render_html(model), encoding="utf-8")
    shown = opened(tmp_path, viewport={"width": 390, "height": 844})
    page = shown.page
    assert page.evaluate("window.hit") is None
    assert page.locator("script:not([type])").count() == 2
    assert page.locator("img").count() == 0
    assert len(shown.fetched) == 1
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert page.locator("#play").count() == 1 and page.is_visible("#live")
