"""How a note looks: a house style for each language, unless a department has its own.

Enters: a language.  Leaves: `House`, and its styles as Word and OpenDocument write them.
Used by `word.py`, `open_document.py` and `writer.py`.
ГОСТ 7.32-2017 for ru and ДСТУ 3008:2015 for uk: Times New Roman 14, line spacing 1.5, margins 30, 15, 20 and 20 mm, first lines
indented by 12.5 mm; headings of sections bold with that indent, headings without a number centred in capitals; captions of
figures below and centred, of tables above and left; page numbers below and centred (ru), above and right (uk).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from coursework.system.frozen import frozen
from coursework.words.templates import filled_part

PAGE = (210.0, 297.0)  # mm
FIRST = "First Paragraph"  # of a section, and after a formula
OPEN_NAMES = {  # names of pandoc's styles in an OpenDocument text, if they differ there
    "Normal": "Standard", "Body Text": "Text_20_body", "Image Caption": "FigureCaption", "Table Caption": "TableCaption",
    "TOC Heading": "Contents_20_Heading", "TOC 1": "Contents_20_1", "Table Text": "Table_20_Contents",
    "Source Code": "Preformatted_20_Text", FIRST: "First_20_paragraph",
}  # fmt: skip
REACH = 5.0  # mm into the right margin, for a drawing true to scale that is hardly wider than the text
MANY = 9  # columns of a table; a table with more has small letters


@frozen
class House:
    """Faces, size (pt), line spacing, margins (mm: left, right, top, bottom), indent of a paragraph (mm)."""

    face: str = "Times New Roman"
    eastern: str = "Times New Roman"
    size: float = 12.0
    line: float = 1.15
    margins: tuple[float, float, float, float] = (20.0, 20.0, 20.0, 20.0)
    indent: float = 0.0
    by_standard: bool = False  # headings and captions by the standards of reports
    page_number: str = "footer center"

    @property
    def width(self) -> float:
        """Return the width of the text (mm)."""
        return PAGE[0] - self.margins[0] - self.margins[1]


STANDARD = House(size=14.0, line=1.5, margins=(30.0, 15.0, 20.0, 20.0), indent=12.5, by_standard=True)
HOUSES = {
    "ru": STANDARD,
    "uk": replace(STANDARD, page_number="header right"),
    "zh": House(eastern="SimSun", size=12.0, line=1.25, indent=8.5),
}


@frozen
class Style:
    """A paragraph style; None for size, line or indent means that of the text; lengths in mm, spaces in pt."""

    name: str
    size: float | None = None
    bold: bool = False
    italic: bool = False
    capitals: bool = False
    align: str = "both"
    before: float = 0.0
    after: float = 0.0
    line: float | None = None
    first: float | None = None
    level: int = 0  # of a heading, from 1
    keep: bool = False
    tabs: bool = False  # one tab in the middle of the line, one at its end
    grey: bool = False
    new_page: bool = False
    right: float = 0.0
    typed: bool = False  # in a monospaced face

    @property
    def is_text(self) -> bool:
        """Return whether the style has the line spacing and the indent of the text."""
        return self.line is None and self.first is None


def styles_of(house: House) -> tuple[Style, ...]:
    """Return the styles of a note, with the names that pandoc gives them."""
    plain, size = not house.by_standard, house.size
    small = size - 2
    caption = small if plain else size
    heading, middle = ("left", "left") if plain else ("both", "center")
    return (
        Style("Normal", after=4 if plain else 0),
        Style("Body Text", after=4 if plain else 0),
        Style(FIRST, before=4, after=4 if plain else 0),
        Style("Lead", before=4, after=4 if plain else 0, keep=True),
        Style("Compact", after=0),
        Style("Title", size + 4 if plain else size, bold=True, align="center", before=6, after=12, first=0),
        Style("Subtitle", size, align="center", before=120 if house.by_standard else 12, after=6, first=0),
        Style("Author", size, align="left", after=2, first=0),
        Style("Heading 1", size + 2 if plain else size, bold=True, align=heading, before=18, after=10, level=1, keep=True),
        Style("Heading 2", size + 1 if plain else size, bold=True, align=heading, before=12, after=8, level=2, keep=True),
        Style(
            "Heading Structural", size + 2 if plain else size, bold=True, capitals=not plain, align=middle, before=18, after=10,
            first=0, level=1, keep=True,
        ),
        Style("TOC Heading", size + 2 if plain else size, bold=True, capitals=not plain, align="left" if plain else "center",
              after=10, first=0, keep=True, new_page=True),
        Style("TOC 1", align="left", first=0, line=1.15),
        Style("Image Caption", caption, align="center", after=10, first=0, line=1.0),
        Style("Table Caption", caption, align="left", before=8, after=4, first=0, line=1.0, keep=True),
        Style("Table Title", bold=True, align="left", before=10, after=4, first=0, line=1.0, keep=True),
        Style("Figure", align="center", before=8, after=4, first=0, line=1.0, keep=True),
        Style("Wide Figure", align="center", before=8, after=4, first=0, line=1.0, keep=True, right=-REACH),
        Style("Equation", 11.0, align="left", before=4, after=4, first=0, line=1.0, tabs=True),
        Style("Equation Small", 8.0, align="left", before=4, after=4, first=0, line=1.0),
        Style("Source Code", 8.0, align="left", first=0, line=1.0, typed=True),
        Style("Table Text", 9.0, align="left", first=0, line=1.0),
        Style("Table Text Small", 7.0, align="left", first=0, line=1.0),
        Style("Remark", small, align="both", before=4, after=4, line=1.0),
        Style("To Write", italic=True, grey=True),
    )  # fmt: skip


def xml_of(name: str, part: str, /, **content: Any) -> str:
    """Return a part of `reports/<name>.xml.j2` as one line."""
    made = filled_part(f"{name}.xml.j2", part, **content)
    return re.sub(r"\s*\n\s*", " ", re.sub(r"\s*\n\s*(?=<|$)", "", made))


def twips(mm: float) -> int:
    """Return a length (mm) in twips, as Word measures it."""
    return round(mm * (1440 / 25.4))


def word_styles(house: House | None) -> dict[str, str]:
    """Return the XML of every style by its id in Word's `styles.xml`; with None, body text stays as the department has it."""
    known: dict[str, Any] = {"house": house or House(), "lent": house is None, "twips": twips, "round": round}
    return {one.name.replace(" ", ""): xml_of("word", "style", one=one, **known) for one in styles_of(house or House())}


def open_document_styles(house: House | None) -> dict[str, str]:
    """Return the XML of every style by its name in OpenDocument's `styles.xml`; None means the same as for Word."""
    known: dict[str, Any] = {"house": house or House(), "lent": house is None}
    named = {OPEN_NAMES.get(one.name, one.name.replace(" ", "_20_")): one for one in styles_of(house or House())}
    return {name: xml_of("opendocument", "style", one=one, name=name, **known) for name, one in named.items()}


def restyled(styles: str, made: Mapping[str, str], pattern: str, end: str, house: House | None) -> str:
    """Return a file's styles with those `made`; to the styles of a department (no house) only missing ones are added.

    `pattern` finds a style by its name, new styles stand before `end`.
    """
    for name, style in made.items():
        own = re.compile(pattern.format(re.escape(name)), re.S)
        if not own.search(styles):
            styles = styles.replace(end, f"{style}{end}", 1)
        elif house is not None:
            styles = own.sub(lambda _, style=style: style, styles, count=1)  # type: ignore[misc]
    return styles
