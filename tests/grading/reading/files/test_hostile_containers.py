"""Workbooks and archives that are broken or mean harm: the code and the bounds of each; bombs are made here, not stored."""

from __future__ import annotations

import io
import tracemalloc
import zipfile

from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import Trouble
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.reading.table.dialects import archive, document, workbook
from tests.grading.reading.table.misread import GRID, ROWS, column, read, read_table, refused
from tests.grading.scenes import expected


def deflated(parts: dict[str, bytes]) -> bytes:
    return archive(dict(parts), level=1)


def test_bombs_are_too_large_when_opened_and_cost_no_memory() -> None:
    sheet = workbook({"1": [["n:1"]]})
    with zipfile.ZipFile(io.BytesIO(sheet)) as file:
        parts: dict[str, bytes] = {name: file.read(name) for name in file.namelist()}
    comment = b"<worksheet><sheetData><!--" + b" " * (96 * 2**20) + b"--></sheetData></worksheet>"
    text = b"<sst><si><t>" + b"x" * (96 * 2**20) + b"</t></si></sst>"
    use = b'<worksheet><sheetData><row><c t="s"><v>0</v></c><c t="s"><v>5</v></c></row></sheetData></worksheet>'
    bombs = [
        deflated(parts | {"xl/worksheets/sheet1.xml": comment}),
        deflated(parts | {"xl/worksheets/sheet1.xml": use, "xl/sharedStrings.xml": text}),
        deflated(parts | {f"xl/part{k}": b"" for k in range(250)}),
        archive({"content.xml": comment}, level=1),
    ]
    for bomb in bombs:
        assert len(bomb) < 600_000
        tracemalloc.start()
        assert refused(bomb, "t.xlsx").code == "too_large_open"
        assert tracemalloc.get_traced_memory()[1] < 64 * 2**20
        tracemalloc.stop()
    plain = archive({"a.csv": bytes(96 * 2**20)}, level=1)
    for content in (plain, archive({"more.zip": archive({"more.zip": plain})})):
        found = read_submission(Submission("x", None, (submitted_file("t.zip", content),)), expected())
        assert found.trouble is not None
        assert found.trouble.state == "unreadable"


def test_rows_and_columns_far_away_are_left_out() -> None:
    good = "".join(
        f'<row r="{k}">' + "".join(f'<c r="{chr(65 + j)}{k}"><v>{text}</v></c>' for j, text in enumerate(row)) + "</row>"
        for k, row in enumerate(ROWS, start=1)
    )
    far = '<row r="30"><c r="XFD30"><v>1</v></c></row><row r="1048576"><c r="XFD1048576"><v>1</v></c></row>'
    with zipfile.ZipFile(io.BytesIO(workbook({"1": [["n:1"]]}))) as file:
        parts: dict[str, str | bytes] = {name: file.read(name) for name in file.namelist()}
    body = f"<worksheet><sheetData>{good}{far}</sheetData></worksheet>"
    assert column(read(archive(parts | {"xl/worksheets/sheet1.xml": body}), "t.xlsx"), "w3")[0] == 5.5518
    million = "".join(f'<row r="{k}"><c r="A{k}"><v>{k}</v></c></row>' for k in range(26, 100_000))
    body = f"<worksheet><sheetData>{good}{million}</sheetData></worksheet>"
    assert read(archive(parts | {"xl/worksheets/sheet1.xml": body}), "t.xlsx").reading.rows <= 600
    wide = document(
        '<table:table table:name="1"><table:table-row table:number-rows-repeated="99999999">'
        '<table:table-cell office:value-type="float" office:value="1" table:number-columns-repeated="99999999"/>'
        "</table:table-row></table:table>"
    )
    assert isinstance(read_table(wide, "t.ods", GRID), Trouble)


def test_entities_and_damage() -> None:
    with zipfile.ZipFile(io.BytesIO(workbook({"1": [["n:1"]]}))) as file:
        parts: dict[str, str | bytes] = {name: file.read(name) for name in file.namelist()}
    laughs = '<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]><worksheet><sheetData>&b;</sheetData></worksheet>'
    assert refused(archive(parts | {"xl/worksheets/sheet1.xml": laughs}), "t.xlsx").code == "doctype"
    assert refused(archive({"content.xml": laughs}), "t.ods").code == "doctype"
    assert refused(archive(parts | {"xl/worksheets/sheet1.xml": "<worksheet><sheetData>"}), "t.xlsx").code == "damaged"
    assert refused(archive(parts | {"xl/worksheets/sheet1.xml": "<a>" * 5000}), "t.xlsx").code == "damaged"
    assert refused(workbook({"1": [["n:1"]]})[:-30], "t.xlsx").code == "damaged"
    assert refused(b"PK\x03\x04" + bytes(100), "t.xlsx").code == "damaged"
    nowhere = '<?xml version="1.0" encoding="x-nowhere"?><worksheet/>'
    assert refused(archive(parts | {"xl/worksheets/sheet1.xml": nowhere}), "t.xlsx").code == "damaged"
    no_sheet = {name: content for name, content in parts.items() if "sheet1" not in name}
    assert refused(archive(no_sheet), "t.xlsx").code == "no_sheet_table"
    with zipfile.ZipFile(slow := io.BytesIO(), "w", zipfile.ZIP_BZIP2) as file:  # some hundred bytes may hold gigabytes
        for name, content in parts.items():
            file.writestr(name, content)
    assert refused(slow.getvalue(), "t.xlsx").code == "damaged"
    locked = bytearray(workbook({"1": [["n:1"]]}))
    for start in (b"PK\x03\x04", b"PK\x01\x02"):
        place = locked.find(start)
        while place >= 0:
            locked[place + (6 if start[2] == 3 else 8)] |= 1
            place = locked.find(start, place + 1)
    assert refused(bytes(locked), "t.xlsx").code == "password"
    secret = archive({"content.xml": b"\x01\x02", "META-INF/manifest.xml": "<m><manifest:encryption-data/></m>"})
    assert refused(secret, "t.ods").code == "password"
