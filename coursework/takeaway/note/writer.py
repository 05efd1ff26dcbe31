"""`--format docx`, `odt`, `tex`: the report as a document that a student can edit.

Enters: `Results`.  Leaves: the bytes of files.  Raises `NotToBeHad` without pypandoc.  Used by the list of formats, by name.
"""

from __future__ import annotations

import json
import tempfile
import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from coursework.report.output.results import Results
from coursework.report.text.parts import Equations
from coursework.report.text.words import load_words
from coursework.system.extras import require
from coursework.takeaway.figures.drawings import FOLDER, Picture, as_pdf, as_png, pictures_of
from coursework.takeaway.note import tree
from coursework.takeaway.note.blocks import Blocks, pictures
from coursework.takeaway.note.dialects import DIALECTS
from coursework.takeaway.note.formulas import latex_of
from coursework.takeaway.note.pandoc import called
from coursework.takeaway.note.sections import Headings, headings, section_blocks, title_blocks
from coursework.takeaway.note.styles import HOUSES, House
from coursework.words.data_folders import REPORTS, folder

MODULE, EXTRA = "pypandoc", "note"
LANGUAGES = {"en": "en-GB", "ru": "ru-RU", "uk": "uk-UA", "zh": "zh-CN"}
MANY = 7  # columns: in LaTeX a table with more is set smaller
DEPARTMENT = "reference"  # stem of the file with a department's styles, in its folder of templates


def write_docx(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield the note for Word."""
    from coursework.takeaway.note.word import contents_of, finished

    return _office_note(results, "docx", "openxml", contents_of, finished)


def write_odt(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield the note for OpenDocument."""
    from coursework.takeaway.note.open_document import contents_of, finished

    return _office_note(results, "odt", "opendocument", contents_of, finished)


def _office_note(
    results: Results, suffix: str, own_xml: str, contents_of: Callable[[str, Headings, float], str],
    finished: Callable[[bytes, House | None, Mapping[bytes, Picture]], bytes],
) -> Iterator[tuple[str, bytes]]:  # fmt: skip
    note = _Note(results, suffix)
    contents = contents_of(note.words("title.contents"), headings(results.model), note.house.width)
    before = [*title_blocks(results.model, note.blocks), tree.raw_block(own_xml, contents)]
    blocks = [*before, *section_blocks(results, note.blocks)]
    with tempfile.TemporaryDirectory() as place:
        drawings = note.save_png(Path(place))
        made = note.converted(blocks, Path(place), note.department)
    yield f"{results.stem}.{suffix}", finished(made, None if note.department else note.house, drawings)


def write_tex(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield the note for LaTeX, and its drawings."""
    note = _Note(results, "tex")
    title, author = tree.text(results.model.heading), tree.text(results.model.author)
    blocks = [*title_blocks(results.model, note.blocks)[2:], *section_blocks(results, note.blocks)]
    meta = {
        "title": {"t": "MetaInlines", "c": title}, "author": {"t": "MetaInlines", "c": author},
        "subtitle": {"t": "MetaInlines", "c": tree.text(results.model.kind)},
    }  # fmt: skip
    latex = tomllib.loads(Path(__file__).with_name("latex.toml").read_text(encoding="utf-8"))
    own = latex.get(results.language, latex["others"])
    left, right, top, bottom = note.house.margins
    variables = {
        "documentclass": own["class"], "papersize": "a4",
        "geometry": f"left={left}mm,right={right}mm,top={top}mm,bottom={bottom}mm", "colorlinks": "true",
        "header-includes": (latex["shared"] + own["preamble"]).replace("\n", ""), "linkcolor": "black",
    }  # fmt: skip
    options = ["--standalone", "--toc", "--toc-depth=2", *(f"--variable={name}={value}" for name, value in variables.items())]
    with tempfile.TemporaryDirectory() as place:
        made = note.converted(_sized_tables(blocks), Path(place), None, *options, **meta)
    yield f"{results.stem}.tex", made
    for one in note.pictures.values():
        yield f"{FOLDER}/{one.name}.pdf", as_pdf(one, results.language)


def _sized_tables(blocks: list[tree.Node]) -> list[tree.Node]:
    """Return blocks with tables in small letters, wide ones in smaller letters."""
    found: list[tree.Node] = []
    for block in blocks:
        if block["t"] != "Table":
            found.append(block)
            continue
        size = "scriptsize" if len(block["c"][2]) > MANY else "small"
        found += [tree.raw_block("latex", f"\\begingroup\\{size}"), block, tree.raw_block("latex", "\\endgroup")]
    return found


class _Note:
    """What the three formats share: pictures, formulas, and the `Blocks` that make the tree."""

    def __init__(self, results: Results, suffix: str) -> None:
        require(MODULE, suffix, EXTRA)
        self.results, self.dialect, self.words = results, DIALECTS[suffix](), load_words(results.language)
        parts = [part for section in results.model.sections for part in section.parts]
        self.pictures = pictures(parts, pictures_of(results.model))
        shown = [item for part in parts if isinstance(part, Equations) for item in part.items]
        latex = latex_of((one.math for one in shown), self.words("decimal"), aligned=suffix == "tex")
        self.house = HOUSES.get(results.language, House())
        named = {one.name for one in shown if one.name}
        self.blocks = Blocks(self.dialect, latex, self._place, self.house.width, named)

    @property
    def department(self) -> Path | None:
        """Return the file with the department's own styles, None if it has none."""
        own = folder(REPORTS) / f"{DEPARTMENT}.{self.dialect.suffix}"
        return own if own.is_file() else None

    def _place(self, svg: str) -> str:
        return f"{FOLDER}/{self.pictures[svg].name}.{'pdf' if self.dialect.suffix == 'tex' else 'png'}"

    def save_png(self, place: Path) -> dict[bytes, Picture]:
        """Save the pictures in a folder; return each by the bytes of its PNG."""
        (place / FOLDER).mkdir()
        found = {}
        listed = list(self.pictures.values())
        for one, png in zip(listed, as_png(listed, self.results.language), strict=True):
            (place / FOLDER / f"{one.name}.png").write_bytes(png)
            found[png] = one
        return found

    def converted(self, blocks: list[tree.Node], place: Path, own: Path | None, *options: str, **meta: Any) -> bytes:
        """Return the document that pandoc makes of blocks, with the pictures in a folder."""
        language = LANGUAGES.get(self.results.language, self.results.language)
        document = tree.document(blocks, lang={"t": "MetaString", "c": language}, **meta)
        options = ("-f", "json", "-t", self.dialect.writer, "-o", "-", f"--resource-path={place}", *options)
        return called([*options, *([f"--reference-doc={own}"] if own else [])], json.dumps(document).encode())
