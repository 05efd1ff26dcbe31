"""HTML and PDF: the same numbers, the same bytes every time, nothing fetched, nothing executed."""

from __future__ import annotations

import hashlib
import importlib.util
import re
import subprocess
import sys
from dataclasses import replace
from types import ModuleType
from typing import Any

import pymupdf
import pytest

import coursework
from coursework.report.formulas import svg, typesetting
from coursework.report.pages import build_model, render_html, render_pdf
from coursework.report.pages.packed import packed
from coursework.words.data_folders import folder
from coursework.words.errors import OutputError
from tests.report.made import model_of, page_of, paper_of

LONG = "W" * 300


def test_numbers_of_pdf_and_html_are_the_same(real: ModuleType, reading: ModuleType) -> None:
    model = model_of(real.full())
    page, paper = reading.html_text(page_of(model)), reading.pdf_text(paper_of(model))
    on_page, on_paper = reading.numbers(page), reading.numbers(paper)
    assert sum(on_page.values()) > 200
    # Tables that run over a page repeat their head, and no number stands there.
    assert on_page == on_paper
    for section in model.plain()["sections"]:
        assert reading.normal(section["title"]) in page
        assert reading.normal(section["title"]) in paper


def test_hostile_text_is_shown_and_never_obeyed(real: ModuleType, reading: ModuleType) -> None:
    model = model_of(real.hostile())
    page = page_of(model)
    assert "<script" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page.replace("\u200b", "")
    assert "\u202e" not in page
    assert "\x07" not in page
    paper = reading.pdf_text(paper_of(model))
    for shown in (reading.html_text(page), paper):
        packed = shown.replace(" ", "")
        for text in ("<script>alert(1)</script>", '#eval("1+1")', "$x_$", '#read("/etc/passwd")', "{{7*7}}", "{student}", "*b*"):
            assert packed.count(text.replace(" ", "")) >= 8, text
        assert "root:" not in packed


def test_a_word_of_300_letters_stays_on_the_page(real: ModuleType) -> None:
    run = real.full()
    given = tuple(replace(one, means=LONG) for one in run.variant.given)
    constraints = tuple(replace(one, because=LONG) for one in run.variant.constraints)
    variant = replace(run.variant, title=LONG, source=LONG, given=given, constraints=constraints, remarks=(LONG,))
    made = coursework.solve(variant, student=LONG, group=LONG)
    with pymupdf.open(stream=render_pdf(build_model(made)), filetype="pdf") as document:
        for sheet in document:
            # Full stops and commas may hang into the margin.
            right = sheet.rect.width - 20 / 25.4 * 72
            assert all(word[2] <= right + 3 for word in sheet.get_text("words")), sheet.number


def test_names_in_other_scripts_do_not_stop_the_page(real: ModuleType) -> None:
    assert render_pdf(build_model(replace(real.full(), student="李小龙 مرحبا Ґалаґан 😀"))).startswith(b"%PDF")


@pytest.mark.parametrize("kind", ["full", "stopped"])
def test_the_pdf_is_pdf_ua_without_a_warning(real: ModuleType, kind: str) -> None:
    import typst

    model = build_model(real.full() if kind == "full" else real.stopped())
    place = folder("reports")
    made, warnings = typst.compile_with_warnings(
        typesetting.sources("report.typ", [model.plain()]), root=str(place),
        font_paths=typesetting._fonts(place / "fonts", False), format="pdf", timestamp=0, pdf_standards=["ua-1"],
    )  # fmt: skip
    assert warnings == []
    said = b"/Suspects false>>"  # so it holds unsaid, and poppler has nothing to complain of
    assert packed(made.replace(said, b">>".ljust(len(said)))) == render_pdf(model)
    with pymupdf.open(stream=made, filetype="pdf") as document:
        assert "<pdfuaid:part>1</pdfuaid:part>" in document.get_xml_metadata()
        assert document.metadata["title"] == model.heading
        assert [entry[1] for entry in document.get_toc()] == [
            f"{section.number} {section.title}".strip() for section in model.sections
        ]


def test_the_bar_of_the_drawing_measures_100_mm_on_paper(real: ModuleType) -> None:
    with pymupdf.open(stream=paper_of(model_of(real.full())), filetype="pdf") as document:
        assert [round(length, 2) for length in bars(document)] == [100.0]


def bars(document: Any) -> list[float]:
    """Return the lengths in mm of the lines in the colour of the bar."""
    colour = tuple(value / 255 for value in (1, 1, 1))
    found = [path for sheet in document for path in sheet.get_drawings() if path["color"]]
    return [
        max(path["rect"].width, path["rect"].height) / 72 * 25.4
        for path in found
        if all(abs(a - b) < 1e-3 for a, b in zip(path["color"], colour, strict=True))
    ]


def test_the_page_fetches_nothing(real: ModuleType) -> None:
    page = page_of(model_of(real.full()))
    assert "default-src 'none'" in page
    for pattern in (r"<link", r"<script", r"@import", r"url\((?!#)", r'\ssrc="', r'href="(?!#)'):
        assert not re.search(pattern, page), pattern
    ids = re.findall(r'\sid="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    referred = set(re.findall(r'href="#([^"]+)"', page)) | set(re.findall(r"url\(#([^)]+)\)", page))
    assert referred <= set(ids)


def test_without_typst_the_page_still_has_its_equations(real: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    monkeypatch.setattr(svg, "_cache", {})
    model = build_model(real.full())
    page = render_html(model)
    assert ">ω₃ = V_My / (r₃ (2 cos φ₃ + sin φ₃))</div>" in page
    with pytest.raises(OutputError, match=r"pip install typst.*or write the report as HTML and print it"):
        render_pdf(model)


def test_equations_are_set_once_a_process(real: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    model = build_model(real.full())
    render_html(model)
    monkeypatch.setattr(svg, "typeset", lambda *_: pytest.fail("set again"))
    render_html(model)


def test_what_typst_refuses_is_told(real: ModuleType) -> None:
    from coursework.report.text.parts import Display, Equations, Section

    model = model_of(real.full())
    broken = Section("broken", "Broken", [Equations([Display("frac(", "text")])])
    with pytest.raises(OutputError, match=r"could not be set.*Typst says"):
        render_pdf(replace(model, sections=(broken,)))


def test_nothing_heavy_is_loaded_with_the_package() -> None:
    code = "import coursework.report, sys; print([m for m in ('matplotlib', 'typst', 'jinja2', 'pandas') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_reports_travel_with_the_package() -> None:
    assert importlib.util.find_spec("coursework") is not None
    names = {path.name for path in folder("reports").iterdir()}
    assert {"report.html.j2", "report.css", "report.typ", "equation.typ", "words.en.toml"} <= names


def test_pdf_and_html_of_one_run_are_small(real: ModuleType) -> None:
    model = model_of(real.full())
    assert len(page_of(model)) < 800_000
    assert len(paper_of(model)) < 600_000
    assert hashlib.sha256(paper_of(model)).digest() == hashlib.sha256(render_pdf(model)).digest()


def test_a_page_is_light(real: ModuleType) -> None:
    """Beside the part that moves 172 of 311 kB are enough on a screen, on paper half of 478."""
    model = build_model(real.full())
    assert len(render_html(model).encode()) < 172_000
    assert len(render_pdf(model)) < 239_000
