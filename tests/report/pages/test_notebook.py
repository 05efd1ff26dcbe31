"""What a notebook shows of a run: drawing, plots, checks; one line of text; nothing fetched, nothing obeyed."""

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

import coursework
from coursework.words.data_folders import folder

VOID = {"meta", "br", "hr", "img", "input", "link"}


class Reader(HTMLParser):
    """Keeps the open elements; an end that closes another element is a fault, and so is what fetches or obeys."""

    def __init__(self):
        super().__init__()
        self.open = []

    def handle_starttag(self, tag, attrs):
        self.handle_startendtag(tag, attrs)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        assert tag not in {"script", "link", "img", "iframe", "object"}
        for name, value in attrs:
            assert not name.startswith("on") and name != "src", name
            assert not name.endswith("href") or value.startswith("#"), value

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def shown(run):
    page = run._repr_html_()
    reader = Reader()
    reader.feed(page)
    assert reader.open == []
    assert not re.search(r"@import|url\((?!#)", page)
    return page


def test_drawing_plots_and_checks():
    run = coursework.solve("31")
    page = shown(run)
    assert page.count("<svg") == 1 + 7 + 2, "the drawing, a panel a column, the two lines of the key"
    assert "Row 4, t = 0.06 s, scale 1:10" in re.sub(r"<[^>]+>", "", page)
    assert "<i>t</i> = 0.06" in page
    for check in run.checks:
        assert f'<span class="code">{check.code}</span>' in page
    assert "exact" in page
    assert re.search(r"\.checks [^{}]*:nth-child[^{}]*\{[^}]*white-space: normal", page), "sentences wrap"
    width = float(re.search(r'<svg[^>]* width="([\d.]+)mm"', page)[1])
    height = float(re.search(r'<svg[^>]* height="([\d.]+)mm"', page)[1])
    assert width > height, "a screen does not turn a wide sheet onto its side"
    assert "accuracy" not in run.scene.ledger.calls, "what a notebook does not show is not computed for it"


def test_words_stand_on_the_left_where_jupyter_puts_cells_on_the_right_and_terms_beside_theirs():
    page = coursework.notebook_html(coursework.solve("31", quantities=["table", "checks"]))
    assert ".checks > * > tr > :nth-child(-n + 2) { text-align: left; }" in page and "dl > div { display: flex;" in page
    shown = coursework.solve("31", quantities=["table", "checks"]).checks._repr_html_()
    assert '<td style="text-align:left">' in shown


def test_looks_stay_inside():
    style = re.search(r"<style>(.*?)</style>", shown(coursework.solve("31", quantities=["table"])), re.S)[1]
    rules = [line for line in style.strip().splitlines() if line]
    assert all(line.startswith(".coursework-run") for line in rules)


def test_a_run_without_drawing_and_one_of_a_column():
    page = shown(coursework.solve("example-1", quantities=["table", "checks"]))
    assert "The mechanism in row" not in page
    assert page.count("<svg") >= 1
    assert shown(coursework.solve("31", quantities=["phi3"])).count("<svg") == 3


def test_a_motion_that_stops_says_why(tmp_path):
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8").replace('"4.35 rad"', '"0.02 rad"')
    (tmp_path / "dead.toml").write_text(text, encoding="utf-8")
    page = shown(coursework.solve(tmp_path / "dead.toml"))
    assert "0.11688925" in page
    assert "<svg" in page


def test_hostile_text_is_text(tmp_path):
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8")
    text = text.replace("Rolling wheel", "<script>alert(1)</script><img src=x onerror=alert(2)>{{7*7}}")
    text = text.replace("C keeps its height", "</div><script>")
    (tmp_path / "bad.toml").write_text(text, encoding="utf-8")
    page = shown(coursework.solve(tmp_path / "bad.toml")).replace("\u200b", "")  # where a long word may be broken
    assert "<script" not in page and "<img" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page
    assert "{{7*7}}" in page


@pytest.mark.parametrize("name", ["31", "example-3", "engine-start"])
def test_a_run_in_one_line(name):
    run = coursework.solve(name)
    text = repr(run)
    assert text.startswith(f"<Run of {name}: ") and text.endswith(">")
    assert "\n" not in text and len(text) < 200
    assert f"h = {run.step:g} s, 0 to {run.end:g} s" in text
    assert "motion" not in run.scene.ledger.calls, "a line asks whether the motion stops, and for no row"


def test_a_name_with_a_line_break_stays_in_one_line(tmp_path):
    path = tmp_path / "two\nlines.toml"
    path.write_bytes(Path(folder("variants") / "31.toml").read_bytes())
    assert "\n" not in repr(coursework.solve(path))
