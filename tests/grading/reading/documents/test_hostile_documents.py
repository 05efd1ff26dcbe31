"""Documents that are broken or mean harm: each is refused in bounds of time, memory and inflated bytes, and opens no more."""

from __future__ import annotations

import io
import json
import sys
import threading
import time
import tracemalloc
import zipfile
import zlib
from collections.abc import Callable, Iterator

import pytest

from coursework.grading.reading.documents import document
from coursework.grading.reading.documents.pdf import pdf
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import StudentWork
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.reading.documents.papers import MAKERS, typst_pdf
from tests.grading.reading.table.dialects import archive
from tests.grading.reading.table.misread import HEAD, ROWS, csv
from tests.grading.scenes import expected

ODT = b"application/vnd.oasis.opendocument.text"
SPACES = b"<!--" + b" " * (48 * 2**20) + b"-->"
LAUGHS = b'<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>'
FLAT = b'<?xml version="1.0"?><office:document office:mimetype="%s">' % ODT
GOOD = submitted_file("table.csv", csv(ROWS))


def read(content: bytes, name: str = "work") -> StudentWork:
    return read_submission(Submission("x", None, (submitted_file(name, content),)), expected("31", ("wAB",)))


def word(body: bytes, before: bytes = b"") -> bytes:
    start = b'<w:document xmlns:w="w" xmlns:m="m"><w:body>'
    return archive({"word/document.xml": before + start + body + b"</w:body></w:document>"}, level=1)


def writer(body: bytes, before: bytes = b"", **parts: bytes) -> bytes:
    content = before + b"<office:document-content><office:body><office:text>" + body
    content += b"</office:text></office:body></office:document-content>"
    return archive(
        {"mimetype": ODT, "content.xml": content, **{f"{name}/content.xml": part for name, part in parts.items()}}, level=1
    )


def one_page(stream: bytes, extra: bytes = b"", pages: int = 1) -> bytes:
    """Return a PDF whose pages all show one stream."""
    kids = b" ".join(b"%d 0 R" % (10 + k) for k in range(pages))
    objects = [
        b"1 0 obj <</Type/Catalog/Pages 2 0 R>> endobj",
        b"2 0 obj <</Type/Pages/Count %d/Kids[%s]>> endobj" % (pages, kids),
        b"3 0 obj <</Length %d%s>> stream\n%s\nendstream endobj" % (len(stream), extra, stream),
        b"4 0 obj <</Type/Font/Subtype/Type1/BaseFont/Helvetica>> endobj",
        b"5 0 obj <</Font<</F 4 0 R>>>> endobj",
        *(b"%d 0 obj <</Type/Page/Parent 2 0 R/MediaBox[0 0 500 500]/Contents 3 0 R/Resources 5 0 R>> endobj" % (10 + k)
          for k in range(pages)),
    ]  # fmt: skip
    return b"%PDF-1.4\n" + b"\n".join(objects) + b"\ntrailer <</Root 1 0 R>>\n%%EOF"


FLATE = b"/Filter/FlateDecode"
TEXT = b"BT /F 10 Tf 50 400 Td (The quick brown fox jumps over the lazy dog) Tj ET\n"
DEEP = 100_000
HOSTILE: dict[str, tuple[Callable[[], bytes], str]] = {  # made where they are read: some take long
    "docx bomb": (lambda: word(SPACES), "too_large_open"),
    "docx laughs": (lambda: word(b"<w:p>&b;</w:p>", LAUGHS), "doctype"),
    "docx deep": (lambda: word(b"<w:tbl><w:tr><w:tc>" * DEEP), "damaged"),
    "docx cut": (lambda: word(b"<w:p>")[:-40], "damaged"),
    "docx torn": (lambda: word(b"<w:tbl><w:tr></w:tbl>"), "damaged"),
    "docx no xml": (lambda: archive({"word/document.xml": b"\x00\x01\x02"}), "damaged"),
    "docx parts": (lambda: archive({"word/document.xml": b"<x/>", **{f"word/{k}": b"" for k in range(1000)}}), "too_large_open"),
    "odt bomb": (lambda: writer(SPACES), "too_large_open"),
    "odt laughs": (lambda: writer(b"<text:p>&b;</text:p>", LAUGHS), "doctype"),
    "odt formula laughs": (
        lambda: writer(b'<text:p><draw:object xlink:href="./A"/></text:p>', A=LAUGHS + b"<math><mi>&b;</mi></math>"), "doctype",
    ),
    "odt formula bomb": (
        lambda: writer(b'<text:p><draw:object xlink:href="./A"/></text:p>', A=b"<math>" + SPACES + b"</math>"), "too_large_open",
    ),
    "odt deep": (lambda: writer(b"<text:p><text:span>" * DEEP), "damaged"),
    "flat deep": (lambda: FLAT + b"<text:p>" * DEEP, "damaged"),
    "flat laughs": (lambda: FLAT.replace(b"<office:doc", LAUGHS + b"<office:doc") + b"&b;</office:document>", "doctype"),
    "json deep": (lambda: b'{"a":' * DEEP, "json_deep"),
    "json lists": (lambda: b"[" * DEEP + b"]" * DEEP, "json_deep"),
    "json seven levels": (lambda: b'{"a":{"b":{"c":{"d":{"e":{"f":[1,2]}}}}}}', "json_deep"),
    "json cut": (lambda: b'{"t": [0, 0.02], "phi1": [1', "json_damaged"),
    "json open text": (lambda: b'{"a": "' + b'\\"' * 2_000_000, "json_damaged"),
    "notebook deep": (lambda: b'{"nbformat": 4, "cells": ' + b"[" * DEEP, "json_deep"),
    "notebook cut": (lambda: b'{"nbformat": 4, "cells": [{"cell_type": "markdown", "source": "x', "json_damaged"),
    "rtf braces": (lambda: b"{\\rtf1 " + b"{" * DEEP, "too_large_open"),
    "rtf words": (lambda: b"{\\rtf1 " + b"\\b" * 2_000_000, "too_large_open"),
    "rtf cut": (lambda: b"{\\rtf1 \\bin999999999", "other_kind"),
    "pdf cut": (lambda: typst_pdf("none")(HEAD, ROWS, ())[:3000], "other_kind"),
    "pdf wrong bytes": (lambda: b"%PDF-1.7\n" + bytes(range(256)) * 100, "other_kind"),
    "pdf bomb": (lambda: one_page(zlib.compress(b" " * (64 * 2**20)), FLATE), "too_large_open"),
    "pdf pages": (lambda: one_page(TEXT, pages=31), "pdf_long"),
    "pdf scan": (lambda: one_page(b"q 500 0 0 500 0 0 cm Q"), "other_kind"),
    "pdf round": (
        lambda: b"%PDF-1.4\n1 0 obj <</Type/Catalog/Pages 1 0 R/Kids[1 0 R]>> endobj\ntrailer <</Root 1 0 R>>", "other_kind",
    ),
}  # fmt: skip


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """The parts that are inflated."""
    names: list[str] = []
    usual = Archive.chunks
    monkeypatch.setattr(Archive, "chunks", lambda self, name: names.append(name) or usual(self, name))
    yield names


@pytest.mark.parametrize("case", HOSTILE)
def test_a_hostile_document_is_refused_in_bounds(case: str) -> None:
    made, code = HOSTILE[case]
    content = made()
    began = time.process_time()
    if "bomb" in case:
        tracemalloc.start()
    work = read(content)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert work.trouble is not None
    assert (work.trouble.state, work.trouble.code) == ("unreadable", code)
    assert peak < 64 * 2**20
    assert time.process_time() - began < 10  # a second at most
    beside = read_submission(Submission("x", None, (GOOD, submitted_file("work", content))), expected())
    assert beside.table is not None and beside.trouble is None


def test_only_the_text_and_its_formulas_are_opened(opened: list[str]) -> None:
    _, made = MAKERS["word by pandoc"]
    parts = _parts(made(HEAD, ROWS, ("r_3 \\omega_3 = 0",)))
    outside = b'<Relationship Id="r9" TargetMode="External" Target="file:///etc/passwd"/></Relationships>'
    rels = parts["word/_rels/document.xml.rels"].replace(b"</Relationships>", outside)
    more = {"word/vbaProject.bin": b"macro", "word/embeddings/oleObject1.bin": b"ole", "word/media/a.png": b"x"}
    work = read(archive(parts | more | {"word/_rels/document.xml.rels": rels}))
    assert work.table is not None and set(opened) == {"word/document.xml"}
    opened.clear()
    hrefs = (b"../../etc/passwd", b"/etc", b"file:///etc", b"http://x.invalid", b".", b"", b"./Missing", b"./A/../../content.xml")
    body = b"".join(b'<text:p><draw:object xlink:href="%s"/></text:p>' % href for href in hrefs)
    read(
        writer(body + b'<text:p><draw:object xlink:href="./A"/><draw:image xlink:href="Pictures/a.png"/></text:p>', A=b"<math/>")
    )
    assert set(opened) == {"mimetype", "content.xml", "A/content.xml"}


def test_repeated_and_spanned_cells_are_bounded() -> None:
    row = (
        b"<w:tr>" + b'<w:tc><w:tcPr><w:gridSpan w:val="9999"/></w:tcPr><w:p><w:r><w:t>1</w:t></w:r></w:p></w:tc>' * 3 + b"</w:tr>"
    )
    wide = read(word(b"<w:tbl>" + row * 5000 + b"</w:tbl>"))
    assert wide.table is None
    many = b'table:number-columns-repeated="99999999" table:number-columns-spanned="99999999"'
    cell = b"<table:table-cell " + many + b"><text:p>1</text:p></table:table-cell>"
    row = b'<table:table-row table:number-rows-repeated="99999999">' + cell + b"</table:table-row>"
    assert read(writer(b"<table:table>" + row * 1000 + b"</table:table>")).table is None
    names = [{f"k{number}": 1, "b": 2} for number in range(9000)]
    assert read(json.dumps(names).encode()).table is None
    assert read(b"[" + b"[1,2]," * 200_000 + b"[1,2]]").table is None


@pytest.mark.long
@pytest.mark.parametrize(
    "text",
    [
        "$$a" * 10**6, "`" * 20_000 + "!\n" + "$a$ = 1", "|" * 20_000 + "\n-|-\n", ("| - " * 5000 + "x\n|-|-|\n") * 3,
        " " * 19_000 + "-|\n" * 2, "$" + "x" * 10**6, "**  " * 10**5 + "$a$=", "\\begin{a}" * 10**5 + "$a$",
        "- " * 10**5 + "$x=1$", "$$" + "\\\\" * 1900 + "=$$",
    ],
)  # fmt: skip
def test_markdown_costs_what_its_size_is(text: str) -> None:
    began = time.process_time()
    read(text.encode())
    assert time.process_time() - began < 10


def test_numbers_and_names_of_json() -> None:
    rows = [dict(zip(HEAD, row, strict=True)) for row in ROWS]
    text = json.dumps([{name: float(value) for name, value in row.items()} for row in rows])
    for spoilt in ("NaN", "Infinity", "-Infinity", "1e999", "9" * 100_000, '"#DIV/0!"', "null", "true", "[1]", "{}"):
        work = read(text.replace("1.5985", spoilt, 1).encode())
        if work.table is not None:
            column = work.table.column("phi1")
            assert column is not None and column.flags[1] != "" and column.flags[2] == ""
        else:
            assert spoilt in "[1]{}"
    twice = read(text.replace('"phi1": 1.63', '"phi1": 1.63, "phi1": 1.63').encode())
    assert twice.table is not None
    two = read(text.replace('"phi1":', '"phi1": 7.5, "phi1":').encode())
    assert two.trouble is not None and (two.trouble.state, two.trouble.code) == ("needs-review", "two_columns")
    six = read(json.dumps({"a": {"b": {"c": {"d": json.loads(text)}}}}).encode())
    assert six.table is not None


def test_a_pdf_of_too_many_letters_or_levels(monkeypatch: pytest.MonkeyPatch) -> None:
    def code(content: bytes) -> str:
        trouble = read(content).trouble
        return trouble.code if trouble else ""

    assert code(one_page(b"[" * DEEP)) == "other_kind"
    letters = sum(not letter.isspace() for letter in "The quick brown fox jumps over the lazy dog")
    monkeypatch.setattr(pdf, "LETTERS", letters)
    assert code(one_page(TEXT)) == "other_kind"
    monkeypatch.setattr(pdf, "LETTERS", letters * 30 - 1)
    assert code(one_page(TEXT, pages=29)) == "other_kind"
    assert code(one_page(TEXT, pages=30)) == "too_large_open"


KEPT = [([1, 2, 2, 3], [2, 2, 3]), ([2, 2, 2, 2], [2, 2, 2]), ([2, 6], [2, 6]), ([2, 7], [2])]
TYPED = [
    ([" ab", " ", "cd", "efgh"], ["ab", "cd", "efgh"]),
    (["a", "b", "c", "d"], ["a", "b", "c"]),
    (["abcde", "fghi"], ["abcde"]),
]


def test_a_document_keeps_what_it_may(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables of two columns at least, so many of them and of cells, lines and letters; what is beyond is left out."""
    for name, limit in {"MOST_TABLES": 3, "MOST_CELLS": 8, "MOST_LINES": 3, "MOST_CHARACTERS": 8}.items():
        monkeypatch.setattr(document, name, limit)
    place = document.place_of("line", line=1)
    for widths, kept in KEPT:
        found = document.Document("x")
        for width in widths:
            found.add_table([[Cell("a")] * width], place)
        assert [len(table.rows[0]) for table in found.tables] == kept
    for texts, lines in TYPED:
        found = document.Document("x")
        for text in texts:
            found.add_line(text, place)
        assert [line.text for line in found.lines] == lines


def test_without_the_extra_a_person_is_asked_and_told_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    content = typst_pdf("none")(HEAD, ROWS, ())
    monkeypatch.setattr(pdf, "is_readable", lambda: False)
    work = read(content)
    assert work.trouble is not None and (work.trouble.state, work.trouble.code) == ("needs-review", "no_pdf_reader")
    assert "coursework --versions" in work.trouble.text
    beside = read_submission(Submission("x", None, (submitted_file("r.pdf", content), GOOD)), expected())
    assert beside.table is not None and beside.unopened is not None


def test_a_pdf_that_takes_too_long_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pdf, "SECONDS", 0.05)
    work = read(one_page(b"1 0 0 1 0 0 cm\n" * 200_000 + TEXT))
    assert work.trouble is not None and work.trouble.code == "pdf_slow"
    monkeypatch.setattr(pdf, "SECONDS", 60.0)
    assert read(typst_pdf("none")(HEAD, ROWS, ())).table is not None


def test_a_pdf_is_read_while_a_debugger_or_coverage_looks_on() -> None:
    read_under_trace: list[bool] = []

    def look_on() -> None:
        sys.settrace(lambda *_: None)
        read_under_trace.append(read(typst_pdf("none")(HEAD, ROWS, ())).table is not None)
        sys.settrace(None)

    reader = threading.Thread(target=look_on, daemon=True)  # it went round and round behind the reading
    reader.start()
    reader.join(30)
    assert read_under_trace == [True]


def _parts(content: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        return {name: file.read(name) for name in file.namelist()}


@pytest.mark.parametrize(("before", "is_read"), [(299, True), (300, False)])
def test_of_the_formulas_in_parts_of_their_own_three_hundred_are_opened(before: int, is_read: bool) -> None:
    sheets = b'<text:p><draw:object xlink:href="./Sheet"/></text:p>' * before  # also others than formulas count
    formula = b"<math><msub><mi>w</mi><mn>4</mn></msub><mo>=</mo><mn>2</mn><msub><mi>w</mi><mn>3</mn></msub></math>"
    work = read(writer(sheets + b'<text:p><draw:object xlink:href="./A"/></text:p>', A=formula))
    assert (work.equations is not None) is is_read


@pytest.mark.parametrize(("room", "is_read"), [(0, True), (-1, False)])
def test_a_pdf_is_opened_up_to_the_last_byte_that_its_streams_may_have(
    room: int, is_read: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A page that is inflated once: as many bytes as are allowed, and one more."""
    monkeypatch.setattr(pdf, "INFLATED_BYTES", len(TEXT) + room)
    work = read(one_page(zlib.compress(TEXT), FLATE))
    assert work.trouble is not None and (work.trouble.code != "too_large_open") is is_read
