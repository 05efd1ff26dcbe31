"""Finishes a Word document made by pandoc: styles, sections, page numbers, SVG beside PNG, reproducible bytes.

Enters: a docx as pandoc wrote it.  Leaves: a docx.  Used by `writer.py`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from coursework.system.files.zipped import unpacked, zipped
from coursework.takeaway.figures.drawings import Picture
from coursework.takeaway.note.dialects import ENDED_FIELD, TURNED, UPRIGHT, begun_field, word_field
from coursework.takeaway.note.sections import STRUCTURAL
from coursework.takeaway.note.styles import MANY, PAGE, House, restyled, twips, word_styles, xml_of

DOCUMENT, STYLES, RELATIONS = "word/document.xml", "word/styles.xml", "word/_rels/document.xml.rels"
TYPES = "[Content_Types].xml"
_SECTION = re.compile(r"<w:sectPr\b(?:[^>]*/>|.*?</w:sectPr>)", re.S)
_TABLE = re.compile(r"<w:tbl>.*?</w:tbl>", re.S)
_STYLE = r'<w:style\b[^>]*w:styleId="{}".*?</w:style>'
_EMBEDDED = re.compile(r'<a:blip r:embed="(\w+)"\s*/>|<a:blip r:embed="(\w+)"\s*></a:blip>')
_TARGET = re.compile(r"<Relationship\b[^>]*>")
_SVG = "http://schemas.microsoft.com/office/drawing/2016/SVG/main"
_SVG_USE = "{96DAC541-7B7A-43D3-8B79-37D633B846F1}"  # id of the extension in which Word looks for an SVG
_PART = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_WORD = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"


def contents_of(title: str, listed: Sequence[tuple[str, str]], width: float) -> str:
    """Return the contents as a field that Word can update, with entries that are shown until then."""
    fields = {"begun": begun_field, "field": word_field, "ended": ENDED_FIELD}
    return xml_of("word", "contents", title=title, listed=listed, width=width, twips=twips, **fields)


def finished(content: bytes, house: House | None, drawings: Mapping[bytes, Picture]) -> bytes:
    """Return the finished document; `house` None keeps a department's styles; `drawings` maps each PNG to its drawing."""
    files = unpacked(content)
    document = files[DOCUMENT].decode()
    files[STYLES] = _with_styles(files[STYLES].decode(), house).encode()
    if house is not None:
        document = _with_page(files, document, house)
        for name in STRUCTURAL:
            document = re.sub(rf'(<w:bookmarkStart [^>]*w:name="{name}"\s*/>\s*<w:p>\s*<w:pPr>\s*<w:pStyle w:val=")Heading1"',
                              r'\1HeadingStructural"', document, count=1)  # fmt: skip
    document = _TABLE.sub(_lettered, document)
    own = _SECTION.findall(document)[-1]
    document = document.replace(UPRIGHT, own).replace(TURNED, _turned(own))
    files[DOCUMENT] = _with_drawings(files, document, drawings).encode()
    return zipped(files.items())


def _lettered(found: re.Match[str]) -> str:
    """Return a table in letters small enough for its columns."""
    columns = found[0].partition("</w:tr>")[0].count("<w:tc>")
    return found[0].replace('w:val="Compact"', f'w:val="TableText{"Small" if columns > MANY else ""}"')


def _with_styles(styles: str, house: House | None) -> str:
    """Return the styles of the house, of its tables too."""
    styles = restyled(styles, word_styles(house), _STYLE, "</w:styles>", house)
    if house is None:
        return styles
    return re.sub(_STYLE.format("Table"), lambda _: xml_of("word", "table_style"), styles, count=1, flags=re.S)


def _with_page(files: dict[str, bytes], document: str, house: House) -> str:
    """Return the document with A4 pages of the house, with the page number where the standard wants it."""
    place, align = house.page_number.split()
    tag = {"footer": "ftr", "header": "hdr"}[place]
    number = xml_of("word", "page_number", tag=tag, align=align, field=word_field, namespace=_WORD)
    files[f"word/{place}9.xml"] = number.encode()
    _related(files, "rIdPage", place, f"{place}9.xml")
    kind = f"application/vnd.openxmlformats-officedocument.wordprocessingml.{place}+xml"
    _typed(files, f'<Override PartName="/word/{place}9.xml" ContentType="{kind}"/>')
    section = xml_of("word", "section", place=place, page=PAGE, margins=house.margins, twips=twips)
    last = list(_SECTION.finditer(document))[-1]
    return document[: last.start()] + section + document[last.end() :]


def _turned(section: str) -> str:
    """Return the same section in landscape."""
    size = re.search(r"<w:pgSz\b[^>]*>", section)
    wide, high = (
        (found[1] if size and (found := re.search(rf'w:{side}="(\d+)"', size[0])) else str(twips(mm)))
        for side, mm in zip("wh", PAGE, strict=True)
    )
    turned = f'<w:pgSz w:w="{high}" w:h="{wide}" w:orient="landscape"/>'
    section = section.replace("<w:titlePg/>", "").replace("<w:titlePg />", "")
    return section.replace(size[0], turned) if size else section.replace("</w:sectPr>", f"{turned}</w:sectPr>")


def _with_drawings(files: dict[str, bytes], document: str, drawings: Mapping[bytes, Picture]) -> str:
    """Return the document with an SVG beside the PNG of each drawing, for versions of Word that draw it."""
    targets = {}
    for found in _TARGET.findall(files[RELATIONS].decode()):
        identifier, target = re.search(r'Id="([^"]+)"', found), re.search(r'Target="([^"]+)"', found)
        if identifier and target:
            targets[identifier[1]] = f"word/{target[1]}"
    beside: dict[str, str] = {}

    def with_svg(found: re.Match[str]) -> str:
        identifier = found[1] or found[2]
        drawing = drawings.get(files.get(targets.get(identifier, ""), b""))
        if drawing is None:
            return found[0]
        if identifier not in beside:
            beside[identifier] = f"rIdSvg{len(beside) + 1}"
            name = f"media/drawing{len(beside)}.svg"
            files[f"word/{name}"] = drawing.file.encode()
            _related(files, beside[identifier], "image", name)
        used = f'<asvg:svgBlip xmlns:asvg="{_SVG}" r:embed="{beside[identifier]}"/>'
        return f'<a:blip r:embed="{identifier}"><a:extLst><a:ext uri="{_SVG_USE}">{used}</a:ext></a:extLst></a:blip>'

    document = _EMBEDDED.sub(with_svg, document).replace("<wp:inline>", '<wp:inline distT="0" distB="0" distL="0" distR="0">')
    if beside:
        _typed(files, '<Default Extension="svg" ContentType="image/svg+xml"/>')
    return document


def _related(files: dict[str, bytes], identifier: str, kind: str, target: str) -> None:
    relation = f'<Relationship Id="{identifier}" Type="{_PART}/{kind}" Target="{target}"/>'
    files[RELATIONS] = files[RELATIONS].replace(b"</Relationships>", f"{relation}</Relationships>".encode())


def _typed(files: dict[str, bytes], entry: str) -> None:
    known = files[TYPES].decode()
    if entry.split()[1] not in known:
        files[TYPES] = known.replace("</Types>", f"{entry}</Types>").encode()
