"""Finishes an OpenDocument text made by pandoc: styles, pages, sequences, SVG beside PNG, reproducible bytes.

Enters: an odt as pandoc wrote it.  Leaves: an odt.  Used by `writer.py`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from html import escape

from coursework.system.files.zipped import unpacked, zipped
from coursework.takeaway.figures.drawings import Picture
from coursework.takeaway.note.dialects import SEQUENCES
from coursework.takeaway.note.sections import STRUCTURAL
from coursework.takeaway.note.styles import PAGE, House, open_document_styles, restyled, xml_of
from coursework.takeaway.note.tree import printed

CONTENT, STYLES, MANIFEST = "content.xml", "styles.xml", "META-INF/manifest.xml"
_STYLE = r'<style:style\b[^>]*style:name="{}"(?:[^>]*/>|.*?</style:style>)'
_IMAGE = re.compile(r'<draw:image\b[^>]*xlink:href="([^"]+)"[^>]*?(?:/>|>\s*</draw:image>)')
_MASTER = re.compile(r"<office:master-styles>.*?</office:master-styles>", re.S)
_BORDERLESS = re.compile(r'(<style:style style:name="Table(?:Header)?RowCell"[^>]*>).*?</style:style>', re.S)
_FORMULA = re.compile(r"Formula-\d+/content\.xml")
_LOW, _END = '<mo accent="true">_</mo>', "</munder>"
_SIGNS = {  # LibreOffice shows "¿" for a low line below a letter, and a dotted circle under a combining dot
    "<munder><munder>": "<munder>",
    f"{_LOW}{_END}{_LOW}{_END}": f"<mo>\u2550</mo>{_END}",
    _LOW: "<mo>\u2015</mo>",
    "\u0307": "\u02d9", "\u0308": "\u00a8", "\u030a": "\u02da",
}  # fmt: skip
_ROW = re.compile(r'<mrow>(<mo stretchy="true" form="prefix">)?|(stretchy="true" form="postfix">[^<]*</mo>)?</mrow>')
_NO_RIGHT = '<mo stretchy="true" form="postfix"></mo>'  # pandoc leaves it out, and then LibreOffice repeats the left bracket
BORDER = 'fo:border="0.5pt solid #000000" fo:padding="1mm"'
HEADER = 8.0  # mm within a margin, for the page number
_HEADING = '<text:h text:style-name="Heading_20_1" text:outline-level="1">'
_SET = _HEADING.replace("Heading_20_1", "Heading_20_Structural")


def contents_of(title: str, listed: Sequence[tuple[str, str]], _width: float) -> str:
    """Return the contents as an index that the program can update, with entries that are shown until then."""
    return xml_of("opendocument", "contents", title=title, listed=listed)


def finished(content: bytes, house: House | None, drawings: Mapping[bytes, Picture]) -> bytes:
    """Return the finished document; `house` None keeps a department's styles; `drawings` maps each PNG to its drawing."""
    files = unpacked(content)
    styles = restyled(files[STYLES].decode(), open_document_styles(house), _STYLE, "</office:styles>", house)
    files[STYLES] = (_with_pages(styles, house) if house is not None else styles).encode()
    text = files[CONTENT].decode()
    if "<text:sequence-decls" not in text:
        declared = "".join(
            f'<text:sequence-decl text:display-outline-level="0" text:name="{name}"/>' for name in SEQUENCES.values()
        )
        text = text.replace("<office:text>", f"<office:text><text:sequence-decls>{declared}</text:sequence-decls>", 1)
    text = _BORDERLESS.sub(lambda found: f"{found[1]}<style:table-cell-properties {BORDER}/></style:style>", text)
    if house is not None:
        for name in STRUCTURAL:
            text = text.replace(
                f'{_HEADING}<text:bookmark-start text:name="{name}"', f'{_SET}<text:bookmark-start text:name="{name}"'
            )
    files[CONTENT] = _with_drawings(files, text, drawings).encode()
    for name in filter(_FORMULA.fullmatch, files):
        formula = _with_right_sides(files[name].decode())
        for sign, shown in _SIGNS.items():
            formula = formula.replace(sign, shown)
        files[name] = formula.encode()
    return zipped(files.items())


def _with_right_sides(formula: str) -> str:
    """Return MathML in which every bracket that is closed only on a later line has an empty bracket on its right."""
    opened = list[bool]()

    def one(found: re.Match[str]) -> str:
        if found[0].startswith("<mrow>"):
            opened.append(found[1] is not None)
            return found[0]
        return f"{_NO_RIGHT}{found[0]}" if opened.pop() and not found[2] else found[0]

    return _ROW.sub(one, formula)


def _with_pages(styles: str, house: House) -> str:
    """Return the styles with A4 pages of the house, upright and landscape, and the paragraph styles that begin them."""
    place, align = house.page_number.split()
    layouts = xml_of("opendocument", "layouts", place=place, page=PAGE, margins=house.margins, header=HEADER)
    begins, masters = xml_of("opendocument", "begins", align=align), xml_of("opendocument", "masters", place=place)
    for name in ("Turned", "Upright"):
        styles = re.sub(_STYLE.format(name), "", styles, flags=re.S)
    styles = styles.replace("</office:styles>", f"{begins}</office:styles>", 1)
    styles = styles.replace("</office:automatic-styles>", f"{layouts}</office:automatic-styles>", 1)
    return _MASTER.sub(lambda _: masters, styles, count=1)


def _with_drawings(files: dict[str, bytes], text: str, drawings: Mapping[bytes, Picture]) -> str:
    """Return the text with each drawing as SVG, and its PNG behind it for programs that do not draw SVG."""
    listed: list[str] = []

    def with_svg(found: re.Match[str]) -> str:
        drawing = drawings.get(files.get(found[1], b""))
        if drawing is None:
            return found[0]
        name = re.sub(r"\.png$", ".svg", found[1])
        if name not in files:
            files[name] = drawing.file.encode()
            listed.append(f'<manifest:file-entry manifest:media-type="image/svg+xml" manifest:full-path="{name}"/>')
        return f"{found[0].replace(found[1], name)}{found[0]}<svg:desc>{escape(printed(drawing.alt))}</svg:desc>"

    text = _IMAGE.sub(with_svg, text)
    known = files[MANIFEST].decode()
    files[MANIFEST] = known.replace("</manifest:manifest>", f"{''.join(listed)}</manifest:manifest>").encode()
    return text
