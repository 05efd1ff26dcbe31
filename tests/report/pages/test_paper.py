"""The page on paper: how many pages, how full they are, and where they may break."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import pymupdf
import pytest

from coursework import parse_variant, solve
from coursework.report.pages import pdf, render_pdf
from coursework.report.text.parts import Checks, Claims, Column, Display, Equations, Judged, Paragraph, Part, Runs, Section, Table
from coursework.report.text.text_runs import runs
from coursework.report.text.words import load_words
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, paper_of, solved
from tests.sample import first

MM = 72 / 25.4
HEAD, FOOT = 18 * MM, 15 * MM  # above and below stand the running line and the number of the page
PAGES, APPENDIX = 5, {"en": 2, "zh": 2, "ru": 3, "uk": 3}  # of variant 31
LEAST_FULL = 1 / 3
WORD = re.compile(r"[^\W\d_\U0001D400-\U0001D7FF]{3,}")
BEFORE, AFTER = 4, 3  # rows of a table at the end and at the beginning of a page


@cache
def paper(name: str, language: str = "en") -> bytes:
    return paper_of(model_of(solved(name), language))


def filled(made: bytes) -> list[float]:
    """Return for each page which share of its height the lowest mark lies at."""
    shares = []
    with pymupdf.open(stream=made, filetype="pdf") as document:
        for sheet in document:
            low = sheet.rect.height - FOOT
            marks = [box[3] for _, box in sheet.get_bboxlog() if HEAD < box[3] < low + 1]
            shares.append((max(marks, default=HEAD) - HEAD) / (low - HEAD))
    return shares


@pytest.mark.parametrize("language", first(1, ["ru", "uk", "en", "zh"]))  # the first has the longest words
def test_variant_31_takes_five_pages_and_its_appendix_no_page_of_few_lines(language: str) -> None:
    made = paper("31", language)
    with pymupdf.open(stream=made, filetype="pdf") as document:
        contents = [(title, page) for _, title, page in document.get_toc()]
        begins = contents[-3][1]  # three appendices are the end of the list
        assert begins - 1 <= PAGES, contents
        assert len(document) - (begins - 1) <= APPENDIX[language], contents
        turned = [sheet.number + 1 for sheet in document if sheet.rect.width > sheet.rect.height]
        assert turned == [PAGES]
        rows = [load_words(language)(f"structure.{key}") for key in ("links", "pairs", "mobility", "groups")]
        together = [[row for row in rows if sheet.search_for(row)] for sheet in document.pages(0, 2)]
        assert [found for found in together if rows[2] in found] == [rows]  # a short table of facts is not parted
    assert min(filled(made)[:-1]) >= LEAST_FULL
    assert crossed(made) == []


def crossed(made: bytes) -> list[tuple[str, str]]:
    """Return the words of a document that lie on each other; signs of formulas, one above the other, are left out."""
    found = []
    with pymupdf.open(stream=made, filetype="pdf") as document:
        for sheet in document:
            words = sorted(word for word in sheet.get_text("words") if WORD.fullmatch(word[4]))
            for place, (_, top, right, bottom, text, *_) in enumerate(words):
                beside = (other for other in words[place + 1 :] if other[0] < right - 1)
                found += [
                    (text, other[4]) for other in beside if min(bottom, other[3]) - max(top, other[1]) > 0.6 * (bottom - top)
                ]
    return found


def test_words_that_lie_on_each_other_are_seen() -> None:
    with pymupdf.open() as document:
        sheet = document.new_page()
        sheet.insert_text((100, 100), "largest error")
        for right, below in ((0, 14), (90, 0), (10, 0)):
            made = document.tobytes()
            assert crossed(made) == []
            sheet.insert_text((100 + right, 100 + below), "last")
        assert crossed(document.tobytes()) == [("largest", "last")]


def test_long_names_part_between_their_words_in_heads_and_cells() -> None:
    longer = (
        ("phi1", "angleOfTheCrank"),
        ("phi2", "angleOfTheConnectingRod"),
        ("phi3", "angleOfTheRockerBehind"),
        ("w3", "rateOfTheRockerBehind"),
        ('"n"', '"speedOfTheCrankOfThisFourBar"'),
        ("n = ", "speedOfTheCrankOfThisFourBar = "),
        ("pi/n", "pi/speedOfTheCrankOfThisFourBar"),
    )
    run = solve(parse_variant(mechanism("four-bar", *longer)), quantities=["table", "analogs"])
    assert crossed(paper_of(model_of(run))) == []


@pytest.mark.long
@pytest.mark.parametrize("name", first(3, ("v107", "jansen", "stopped", "example-3", "example-1", "homework")))
def test_no_page_but_the_last_is_less_than_a_third_full(real: ModuleType, name: str) -> None:
    made = paper_of(model_of(real.stopped())) if name == "stopped" else paper(name)
    shares = filled(made)
    assert len(shares) > 4
    assert min(shares[:-1]) >= (2 / 3 if name == "jansen" else LEAST_FULL), shares  # its tables of every fifth row may part


@pytest.mark.parametrize("name", ["example-2", "cardan"])
def test_no_line_ends_within_an_equality_or_a_quantity(name: str) -> None:
    with pymupdf.open(stream=paper(name), filetype="pdf") as document:
        lines = [line for sheet in document for line in lines_of(sheet)]
    assert sum(" = 0." in line for line in lines) > 3
    assert not [line for line in lines if re.match(r"= [−\d]|/s\b|N[.,;]", line)]


@pytest.mark.parametrize("text", ["2π); here", "½\ue000h\ue001²·|d\u2009ω₃/d\ue000t\ue001|, at most", "2·ω₁·ω₂ too"])
def test_no_line_ends_within_what_is_written_as_one(text: str) -> None:
    """Each paragraph is a letter longer than that before it, so that the end of a line comes by every place."""
    shown = Section("shown", "Shown", [Paragraph(runs(f"{'n ' * 35}{'i' * k} {text} last")) for k in range(70)])
    made = render_pdf(replace(model_of(solved("31", quantities=["table"])), sections=(shown,)))
    with pymupdf.open(stream=made, filetype="pdf") as document:
        lines = "".join(sheet.get_text() for sheet in document).split("Shown", 1)[1].split("\n")
    ends = {line for line in lines if line.endswith("last") and not line.startswith("n")}
    assert len(ends) > 3
    begun = {line[0] for line in ends if not line.startswith("i")}
    assert begun <= {word[0] for word in f"{text} last".split(" ")}


def lines_of(sheet: Any) -> Iterator[str]:
    """Yield the lines of a page; one that stands beside another is no beginning: it goes on behind a fraction."""
    found = [line for block in sheet.get_text("dict")["blocks"] for line in block.get("lines", ())]
    for line in found:
        left, top, _, bottom = line["bbox"]
        text = "".join(span["text"] for span in line["spans"]).replace("\u00a0", " ")
        beside = (other["bbox"] for other in found if other is not line)
        goes_on = any(right <= left + 1 and over < (top + bottom) / 2 < under for _, over, right, under in beside)
        yield f" {text}" if goes_on else text


def test_a_page_that_is_hardly_begun_is_seen() -> None:
    model = model_of(solved("31", quantities=["table"]))
    shares = [filled(render_pdf(replace(model, sections=(_lines(count),))))[0] for count in (10, 14, 40)]
    assert shares[0] < LEAST_FULL < shares[1] < shares[2] <= 1


def _runs(text: str) -> Runs:
    return [{"t": text}]


def _lines(count: int) -> Section:
    return Section("lines", "Lines", [Paragraph(_runs(f"line {number}")) for number in range(count)])


def _table(rows: int, *, whole: bool) -> Table:
    cells: list[list[Any]] = [[f"row{number}", f"{number}.5"] for number in range(rows)]
    columns = [Column(_runs("row")), Column(_runs("x"), "m")]
    return Table(
        columns, cells, _runs("the caption"), rules=list(range(4, rows, 5)), note=_runs("the note"), whole=whole, label="T"
    )


def _claims(rows: int) -> Claims:
    return Claims(
        "the caption", ["verdict", "check", "value", "limit"], [("✓", "holds", _runs(f"row{n}"), "1", "2") for n in range(rows)]
    )


def _checks(rows: int) -> Checks:
    items = [
        Judged("✓", "holds", "CODE", _runs(f"row{n}"), _runs("words " * 40), "1", "2", "", ["a"], [["b"]]) for n in range(rows)
    ]
    return Checks("the caption", ["verdict", "check", "value", "limit"], items)


def pages_of(parts: Sequence[Part]) -> list[list[str]]:
    """Return the texts of the pages of reports, each with more lines before a section of these parts than the last."""
    model = model_of(solved("31", quantities=["table"]))
    shown = Section("shown", "The heading", list(parts))
    made = pdf.paper_of([replace(model, sections=(_lines(count), shown)).plain() for count in range(18, 54)]).content
    found: list[list[str]] = []
    with pymupdf.open(stream=made, filetype="pdf") as document:
        for sheet in document:
            text = sheet.get_text()
            found += [[]] if "line 0\n" in text else []
            found[-1].append(text)
    return found


def _rows(text: str) -> int:
    return len(re.findall(r"\brow\d+", text))


@pytest.mark.long
@pytest.mark.parametrize(
    ("part", "before", "after"),
    [
        (_table(12, whole=False), BEFORE, AFTER), (_table(7, whole=False), 7, 7), (_table(9, whole=True), 9, 9),
        (_claims(12), BEFORE, AFTER), (_checks(9), 2, 2),
    ],
)  # fmt: skip
def test_a_break_leaves_enough_rows_on_both_sides(part: Part, before: int, after: int) -> None:
    parted = set()
    for pages in pages_of([part]):
        rows = [_rows(page) for page in pages]
        shown = [count for count in rows if count]
        assert shown[0] >= before, rows
        assert shown[-1] >= after, rows
        begin = next(page for page, count in zip(pages, rows, strict=True) if count)
        for words in ("The heading", "the caption", "the note"):
            assert (words in begin) == any(words in page for page in pages), words
        parted.add(tuple(shown))
    if before < sum(shown):
        # It breaks as soon as it may; a line above is higher than a row.
        assert min(shown[0] for shown in parted) <= before + 1
        assert min(shown[-1] for shown in parted if len(shown) > 1) == after


@pytest.mark.long
@pytest.mark.parametrize("flow", [True, False])
def test_words_that_lead_to_formulas_stay_with_them(flow: bool) -> None:
    items = [Display(f"x_{n} = frac(y, z)", f"x{n}", name="" if flow else "7") for n in range(24 if flow else 4)]
    moved = set()
    for pages in pages_of([Paragraph(_runs("It follows:")), Equations(items, flow=flow)]):
        at = next(number for number, page in enumerate(pages) if "It follows" in page)
        assert "The heading" in pages[at]
        assert "𝑥" in pages[at].split("It follows:")[1]
        moved.add(at)
    assert moved == {0, 1}


@pytest.mark.long
@pytest.mark.parametrize("part", [_claims(12), _table(12, whole=False), _checks(5)])
def test_words_that_lead_to_a_table_stay_with_its_first_rows(part: Part) -> None:
    for pages in pages_of([Paragraph(_runs("It follows:"), style="note"), part]):
        begin = next(page for page in pages if "It follows" in page)
        assert "The heading" in begin
        assert _rows(begin) >= 2


def test_the_note_that_ends_a_section_has_the_words_before_it_beside_it() -> None:
    moved = set()
    for pages in pages_of([Paragraph(_runs("words " * 90)), Paragraph(_runs("the programs"), style="note")]):
        at = next(number for number, page in enumerate(pages) if "the programs" in page)
        assert "words" in pages[at]
        moved.add(at)
    assert moved == {0, 1}


def test_poppler_has_nothing_to_say_of_the_page(tmp_path: Path) -> None:
    """Its tools read what a page says of itself; where they are installed they are asked themselves."""
    made = paper("31")
    with pymupdf.open(stream=made, filetype="pdf") as document:
        marked = document.xref_get_key(document.pdf_catalog(), "MarkInfo")
        assert marked[1].replace(" ", "") == "<</Markedtrue>>"
        assert not document.is_repaired
        assert len(document) == len(filled(made))
    if (pdfinfo := shutil.which("pdfinfo")) is None:
        return
    target = tmp_path / "report.pdf"
    target.write_bytes(made)
    told = subprocess.run([pdfinfo, str(target)], capture_output=True, text=True, check=True)
    assert told.stderr == ""
    assert re.search(r"Tagged:\s+yes", told.stdout)
