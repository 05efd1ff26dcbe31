"""Tables as the world's programs write them: 25 dialects, four styles of numbers, any digits, radians or degrees.

Written from what the programs do, not from what the reader understands; every function returns bytes.
"""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Callable, Sequence
from xml.sax.saxutils import escape

Rows = list[list[float]]
Texts = list[list[str]]


def fixed(value: float, digits: int) -> str:
    return f"{value:.{digits}f}"


def dropped(value: float, digits: int) -> str:
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in {"-0", ""} else text


def significant(value: float, digits: int) -> str:
    if not value:
        return "0"
    power = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
    return f"{value:.{max(digits - 1 - power, 0)}f}"


def scientific(value: float, digits: int) -> str:
    return f"{value:.{digits - 1}e}"


STYLES: dict[str, Callable[[float, int], str]] = {
    "fixed": fixed, "dropped": dropped, "significant": significant, "scientific": scientific,
}  # fmt: skip


def _join(rows: Texts, sign: str, end: str = "\r\n") -> str:
    return "".join(sign.join(row) + end for row in rows)


def _comma(rows: Texts) -> Texts:
    return [[text.replace(".", ",") for text in row] for row in rows]


def _spelled(names: Sequence[str], angle: str, speed: str) -> list[str]:
    """Return heads for names such as phi1 and w4; other names stay."""
    heads = []
    for name in names:
        if name.startswith("phi"):
            heads.append(angle.replace("@", name[3:]))
        elif name.startswith("w"):
            heads.append(speed.replace("@", name[1:]))
        else:
            heads.append(name)
    return heads


def _lost(heads: Sequence[str]) -> list[str]:
    return [head.replace("φ", "?").replace("ω", "?") for head in heads]


def excel_ru(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t, с", *_lost(_spelled(names, "φ@", "ω@"))]
    return _join([heads, *_comma(rows)], ";").encode("cp1251")


def excel_ua(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    angle = "град" if unit == "deg" else "рад"
    heads = ["час t, с", *_lost(_spelled(names, f"кут φ@, {angle}", "ω@, 1/с"))]
    return _join([heads, *_comma(rows)], ";").encode("cp1251")


def excel_de(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["Zeit", *_spelled(names, "Winkel @", "omega@")]
    return _join([["Übung 3"], heads, *_comma(rows)], ";").encode("cp1252")


def excel_cn(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["时间", *_spelled(names, f"角φ@({'度' if unit == 'deg' else '弧度'})", "角速度@")]
    return _join([heads, *rows], ",").encode("gb18030")


def excel_en(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t (s)", *_spelled(names, "phi@", "omega@")]
    return _join([heads, *rows], ",").encode("utf-8")


def csv_utf8(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t, с", *_spelled(names, "φ@, град" if unit == "deg" else "φ@, рад", "ω@, 1/с")]
    return _join([heads, *_comma(rows)], ";").encode("utf-8-sig")


def unicode_text(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t", *_spelled(names, "φ@", "ω@")]
    return b"\xff\xfe" + _join([heads, *_comma(rows)], "\t").encode("utf-16-le")


def sep_line(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t", *_spelled(names, "phi@", "w@")]
    return ("sep=;\r\n" + _join([heads, *rows], ";")).encode()


def mathcad_prn(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return "".join("".join(f" {text:>13}" for text in row) + "\r\n" for row in rows).encode()


def mathcad_csv(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return _join(rows, ",").encode()


def own_program(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t", *names]
    return "".join("".join(f"{text:>12} " for text in row).rstrip() + "\n" for row in [heads, *rows]).encode()


def tab_separated(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return _join([["время", *_spelled(names, "угол φ@", "ω@z")], *rows], "\t", "\n").encode()


def old_mac(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return _join([["t", *_spelled(names, "fi@", "w@")], *_comma(rows)], ";", "\r").encode()


def typed_minus(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    cells = [[text.replace("-", "−").replace(".", ",") for text in row] for row in rows]
    return _join([["t", *_spelled(names, "ф@", "ω@")], *cells], ";").encode()


def full_width(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    wide = str.maketrans("0123456789.-", "０１２３４５６７８９．－")
    cells = [[text.translate(wide) for text in row] for row in rows]
    return _join([["时间", *_spelled(names, "角φ@", "角速度@")], *cells], ",").encode("gb18030")


def cyrillic_power(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    cells = [[text.replace("e", "Е").replace(".", ",") for text in row] for row in rows]
    return _join([["t", *_spelled(names, "φ@", "ω@")], *cells], ";").encode("utf-8")


def turned(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t", *_spelled(names, "φ@", "ω@")]
    lines = [[head, *column] for head, column in zip(heads, zip(*rows, strict=True), strict=True)]
    return _join(_comma(lines), ";").encode("utf-8-sig")


def with_titles(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["№", "t", *_spelled(names, "φ@", "ω@")]
    units = ["", "с", *_spelled(names, "град" if unit == "deg" else "рад", "1/с")]
    units = [text if text in {"", "с", "град", "рад", "1/с"} else "" for text in units]
    top = [["Курсова робота, варіант 31", *[""] * len(names)], ["Іваненко І. І.", "МБ-21", ""], [""], heads, units]
    body = [[str(place), *row, ""] for place, row in enumerate(_comma(rows), start=1)]
    return _join([*top, *body, [""], [""]], ";").encode("cp1251", errors="replace")


def quoted(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    cells = [[f'"{text}"' for text in row] for row in [["t, c", *_spelled(names, "phi@", "w@")], *_comma(rows)]]
    return _join(cells, ",").encode()


def backwards(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return _join([["t", *_spelled(names, "phi_@", "w_@")], *rows[::-1]], ",").encode()


def maple_list(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return ("[" + ",\n".join(f"[{', '.join(row)}]" for row in rows) + "]\n").encode()


def blanks_and_commas(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    return "".join("  " + "   ".join(row) + "\r\n" for row in _comma(rows)).encode()


_TYPES = (
    '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="xml" '
    'ContentType="application/xml"/></Types>'
)
_BOOK = (
    '<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" '
    'xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets>{}</sheets></workbook>'
)
_RELATIONS = '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">{}</Relationships>'
_SHEET = '<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>{}</sheetData></worksheet>'


def workbook(sheets: dict[str, list[list[str]]], *, shared: Sequence[str] = (), styles: str = "") -> bytes:
    """Return an xlsx; cells are given as the inside of `<c …>`: `n:1.5`, `s:0` (shared), `t:text`, `f:A1+1` (no value) …"""
    parts = {"[Content_Types].xml": _TYPES}
    listed = "".join(f'<sheet name="{escape(name)}" sheetId="{k}" r:id="rId{k}"/>' for k, name in enumerate(sheets, start=1))
    parts["xl/workbook.xml"] = _BOOK.format(listed)
    relations = "".join(f'<Relationship Id="rId{k}" Target="worksheets/sheet{k}.xml"/>' for k in range(1, len(sheets) + 1))
    parts["xl/_rels/workbook.xml.rels"] = _RELATIONS.format(relations)
    for k, rows in enumerate(sheets.values(), start=1):
        lines = []
        for number, row in enumerate(rows, start=1):
            cells = "".join(_xlsx_cell(cell, f"{_letters(at)}{number}") for at, cell in enumerate(row))
            lines.append(f'<row r="{number}">{cells}</row>')
        parts[f"xl/worksheets/sheet{k}.xml"] = _SHEET.format("".join(lines))
    if shared:
        parts["xl/sharedStrings.xml"] = "<sst>" + "".join(f"<si><t>{escape(text)}</t></si>" for text in shared) + "</sst>"
    if styles:
        parts["xl/styles.xml"] = styles
    return archive(parts)


def _letters(at: int) -> str:
    return chr(65 + at) if at < 26 else chr(64 + at // 26) + chr(65 + at % 26)


def _xlsx_cell(cell: str, place: str) -> str:
    kind, _, text = cell.partition(":")
    inside = escape(text)
    return {
        "n": f'<c r="{place}"><v>{inside}</v></c>',
        "s": f'<c r="{place}" t="s"><v>{inside}</v></c>',
        "t": f'<c r="{place}" t="inlineStr"><is><t>{inside}</t></is></c>',
        "f": f'<c r="{place}"><f>{inside}</f></c>',
        "e": f'<c r="{place}" t="e"><v>{inside}</v></c>',
        "d": f'<c r="{place}" s="1"><v>{inside}</v></c>',
    }[kind]


def archive(parts: dict[str, str | bytes], level: int | None = None) -> bytes:
    """Return parts zipped, as thoroughly as `level` says."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as file:
        for name, part in parts.items():
            file.writestr(zipfile.ZipInfo(name), part, zipfile.ZIP_DEFLATED, level)
    return content.getvalue()


def xlsx_numbers(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    shared = ["t, с", *_spelled(names, "φ@", "ω@")]
    cells = [[f"s:{k}" for k in range(len(shared))], *([f"n:{float(text)!r}" for text in row] for row in rows)]
    return workbook({"Лист1": cells}, shared=shared)


def xlsx_texts(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = ["t", *_spelled(names, "φ@", "ω@")]
    return workbook({"Аркуш1": [[f"t:{text}" for text in row] for row in [heads, *_comma(rows)]]})


def ods_numbers(names: Sequence[str], rows: Texts, unit: str) -> bytes:
    heads = "".join(
        f'<table:table-cell office:value-type="string"><text:p>{escape(head)}</text:p></table:table-cell>'
        for head in ["t", *_spelled(names, "φ@", "ω@")]
    )
    body = ""
    for row in rows:
        cells = "".join(
            f'<table:table-cell office:value-type="float" office:value="{float(text)!r}"><text:p>{text}</text:p>'
            "</table:table-cell>"
            for text in row
        )
        rest = '<table:table-cell table:number-columns-repeated="16000"/>'
        body += f"<table:table-row>{cells}{rest}</table:table-row>"
    blank = '<table:table-row table:number-rows-repeated="1048000"><table:table-cell/></table:table-row>'
    return document(f'<table:table table:name="Tabelle1"><table:table-row>{heads}</table:table-row>{body}{blank}</table:table>')


def document(tables: str) -> bytes:
    """Return an ods with these tables."""
    spaces = "".join(
        f' xmlns:{short}="urn:oasis:names:tc:opendocument:xmlns:{short}:1.0"' for short in ("office", "table", "text")
    )
    body = f"<office:document-content{spaces}><office:body><office:spreadsheet>{tables}</office:spreadsheet></office:body>"
    mimetype = "application/vnd.oasis.opendocument.spreadsheet"
    return archive({"mimetype": mimetype, "content.xml": f"<?xml version='1.0'?>{body}</office:document-content>"})


DIALECTS: dict[str, Callable[[Sequence[str], Texts, str], bytes]] = {
    function.__name__: function
    for function in (
        excel_ru, excel_ua, excel_de, excel_cn, excel_en, csv_utf8, unicode_text, sep_line, mathcad_prn, mathcad_csv,
        own_program, tab_separated, old_mac, typed_minus, full_width, cyrillic_power, turned, with_titles, quoted, backwards,
        maple_list, blanks_and_commas, xlsx_numbers, xlsx_texts, ods_numbers,
    )
}  # fmt: skip


def written(times: Sequence[float], columns: dict[str, tuple[str, Sequence[float]]], style: str, digits: int, unit: str) -> Texts:
    """Return the printed rows of a table whose columns are (SI unit, values); angles and only they go into degrees."""
    print_one = STYLES[style]
    texts = []
    for place, time in enumerate(times):
        row = [dropped(time, 6)]
        for si, values in columns.values():
            value = math.degrees(values[place]) if unit == "deg" and si == "rad" else values[place]
            row.append(print_one(value, digits))
        texts.append(row)
    return texts
