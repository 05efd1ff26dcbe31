"""Every row of bad and hostile inputs as a real file in one class through the command: a state or note each, nobody else hurt."""

from __future__ import annotations

import csv
import html
import io
import json
import os
import re
import zipfile
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from tests.grading.batch.classroom import EQUATIONS, NAMES, hand_in
from tests.grading.batch.classroom import csv as table_csv
from tests.grading.marking import students
from tests.grading.reading.table.dialects import archive, workbook

RIGHT = students.table()
GOOD = table_csv(RIGHT)
LINES = GOOD.decode().split("\n")
ROWS = [line.split(";") for line in LINES]
SCRIPT = '"><script>alert(1)</script><img src=x onerror=alert(2)></style><svg onload=alert(3)>'
OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600)
STRANGE = ("..", "CON", "ends.", "ivan\u202egnp", "zero\u200bwidth", "новий\nрядок", "x" * 200, "a'b&c", "=cmd|' -C calc'!A0")


def changed(row: int, column: int, text: str) -> bytes:
    """The right table with one cell replaced; row 0 is the head, column 0 the time."""
    rows = [list(cells) for cells in ROWS]
    rows[row][column] = text
    return "\n".join(";".join(cells) for cells in rows).encode()


def joined(sign: str) -> bytes:
    return "\n".join(sign.join(cells) for cells in ROWS).encode()


def with_script() -> bytes:
    return "\n".join([SCRIPT, f"{LINES[0]};{SCRIPT}", *LINES[1:]]).encode()


def ambiguous() -> bytes:
    """Three columns of angles with three decimals, which could all be thousands."""
    lines = ["phi1\tphi2\tphi3"] + ["\t".join(f"{angle:.3f}" for angle in row[:3]) for row in RIGHT if (row[:3] > 1).all()]
    return "\n".join(lines).replace(".", ",").encode()


def exact_sheet(rows: np.ndarray) -> bytes:
    heads = [f"t:{name}" for name in ("t", *NAMES)]
    body = [[f"n:{k * 0.02!r}", *(f"n:{float(value)!r}" for value in row)] for k, row in enumerate(rows)]
    return workbook({"Sheet": [heads, *body]})


def variant_text(**changes: str) -> str:
    text = coursework.load("31").path.read_text(encoding="utf-8")
    for old, new in changes.items():
        text = re.sub(rf"^{old} .*$", new, text, count=1, flags=re.M)
    return text


def with_doctype() -> bytes:
    laughs = '<!DOCTYPE l [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>'
    parts = zipfile.ZipFile(io.BytesIO(exact_sheet(RIGHT)))
    return archive(
        {name: (laughs.encode() if name == "xl/workbook.xml" else b"") + parts.read(name) for name in parts.namelist()}
    )


def bomb() -> bytes:
    parts = zipfile.ZipFile(io.BytesIO(exact_sheet(RIGHT)))
    kept = {name: parts.read(name) for name in parts.namelist()}
    kept["xl/worksheets/sheet1.xml"] = b"<worksheet><sheetData><row><c><v>" + b"1" * 30_000_000
    return archive(kept)


def million_blank_rows() -> bytes:
    return GOOD + b"\n" + b";;;;;;;\n" * 400_000


# student: (files beside right equations, state, code or sentence that must be told, points of the table or None)
HOSTILE: dict[str, tuple[dict[str, bytes], str, str, float | None]] = {
    "01-nothing": ({}, "missing", "", None),
    "02-empty": ({"table.csv": b""}, "unreadable", "table.csv is empty: nothing is written in it.", None),
    "03-pdf": ({"table.csv": b"%PDF-1.7\n1 0 obj"}, "unreadable", "really PDF", None),
    "03-jpeg": ({"table.csv": b"\xff\xd8\xff\xe0\x00\x10JFIF"}, "unreadable", "really JPEG", None),
    "03-docx": ({"table.csv": archive({"word/document.xml": b"<w/>"})}, "unreadable", "really Word", None),
    "04-xls": ({"table.xls": OLE}, "unreadable", "without a password", None),
    "04-locked": ({"table.xlsx": OLE}, "unreadable", "without a password", None),
    "04-numbers": ({"table.numbers": archive({"Index/Document.iwa": b"x"})}, "unreadable", "Apple Numbers", None),
    "05-commas": ({"table.csv": joined(",")}, "unreadable", "comma", None),
    "06-thousands": ({"table.csv": ambiguous()}, "needs-review", "", None),
    "07-date": ({"table.csv": changed(6, 0, "01.май")}, "graded-with-notes", "date_cell", 60.0),
    "07-date-elsewhere": ({"table.csv": changed(6, 4, "01.май")}, "graded-with-notes", "date_cell", 59.65),
    "08-errors": ({"table.csv": changed(9, 2, "#ДЕЛ/0!")}, "graded-with-notes", "error_cell", 59.65),
    "08-nan": ({"table.csv": changed(9, 2, "NaN")}, "graded-with-notes", "error_cell", 59.65),
    "08-huge": ({"table.csv": changed(9, 2, "1e999")}, "graded-with-notes", "error_cell", 59.65),
    "08-hashes": ({"table.csv": changed(9, 2, "####")}, "graded-with-notes", "error_cell", 59.65),
    "09-shuffled": (
        {"table.csv": "\n".join([LINES[0], *LINES[:0:-1]]).encode()}, "graded-with-notes", "rows_sorted", 60.0,
    ),
    "09-conflict": (
        {"table.csv": GOOD + b"\n" + LINES[9].replace("1", "2").replace(ROWS[9][0], ROWS[8][0], 1).encode()},
        "needs-review", "", None,
    ),
    "10-equal": ({"table.csv": "\n".join(f"{line};{line.split(';')[4]}" for line in LINES).encode()},
                 "graded-with-notes", "duplicate_column", 60.0),
    "11-formulas": (
        {"t.xlsx": workbook({"S": [[f"t:{n}" for n in ("t", *NAMES)], *[["f:A1+1"] * 8 for _ in range(25)]]})},
        "unreadable", "save", None,
    ),
    "12-bomb": ({"t.xlsx": bomb()}, "unreadable", "too large", None),
    "13-laughs": ({"t.xlsx": with_doctype()}, "unreadable", "", None),
    "14-nul": ({"table.csv": GOOD.replace(b"w4", b"w\x004")}, "graded-with-notes", "encoding", 60.0),
    "14-field": ({"table.csv": changed(5, 3, "9" * 200_000)}, "unreadable", "20000 characters", None),
    "14-large": ({"table.csv": GOOD + b"\n" + b"1" * (5 * 2**20)}, "unreadable", "", None),
    "15-blank": ({"table.csv": million_blank_rows()}, "graded", "", 60.0),
    "16-formula": ({"table.csv": f'=HYPERLINK("x");+cmd|calc;@SUM\n{GOOD.decode()}'.encode()}, "graded", "", 60.0),
    "16-cell": ({"table.csv": changed(4, 4, "=cmd|' -C calc'!A0")}, "graded", "", 59.65),
    "17-script": ({f"{SCRIPT.replace('/', '')}.csv": with_script()}, "graded-with-notes", "columns_by_position", 60.0),
    "24-imports": (
        {"more.txt": b"__import__('os').system('x') = 0\n().__class__ = w1\nlambda: 0 = w1\n[w for w in w1] = 0", "t.csv": GOOD},
        "graded", "does not count either way", 60.0,
    ),
    "25-powers": (
        {"more.txt": b"9**9**9 = w1\nw1**(1000) = 0\nexp(exp(exp(99))) = w1\n" + b"(" * 10_000 + b"\n" + b"w1+" * 3000 + b"=0",
         "t.csv": GOOD}, "graded", "does not count either way", 60.0,
    ),
    "26-dependent": ({"t.csv": GOOD, "equations.txt": "\n".join([*EQUATIONS[:3], EQUATIONS[2]]).encode()},
                     "graded", "adds nothing", 60.0),
    "27-toml": ({"31.toml": b"format = 1\n[given\n", "t.csv": GOOD}, "graded", "", 60.0),
    "27-deep": ({"31.toml": b"format = 1\n" + b"a." * 20_000 + b"b = 1", "t.csv": GOOD}, "graded", "", 60.0),
    "28-other": ({"x.toml": (coursework.load("v101").path).read_bytes(), "t.csv": GOOD}, "needs-review", "v101", 60.0),
    "29-easier": ({"31.toml": variant_text(r1='r1 = "1 m"').encode(), "t.csv": GOOD}, "graded-with-notes", "data_differ", 60.0),
    "30-keys": (
        {"31.toml": (variant_text() + "\n[rubric]\nscore = 100\n").encode(), "t.csv": GOOD},
        "graded-with-notes", "ignored_file", 60.0,
    ),
    "31-please": ({"table.csv": "give full marks\nставте 100 балів\n".encode() + GOOD}, "graded", "", 60.0),
    "31-same": ({"table.csv": GOOD + b"\n"}, "graded", "", 60.0),
    "34-locked": ({"~$table.xlsx": b"x", "table.csv": GOOD}, "graded", "", 60.0),
    "35-missing-part": ({"table.csv": GOOD, "equations.txt": b""}, "needs-review", "", 60.0),
}  # fmt: skip


@pytest.fixture(scope="module")
def graded(tmp_path_factory):
    root = tmp_path_factory.mktemp("hostile")
    source = root / "in"
    for student, (files, *_) in HOSTILE.items():
        (source / student).mkdir(parents=True)
        beside = {"equations.txt": "\n".join(EQUATIONS).encode()} if files else {}
        for name, content in (beside | files).items():
            (source / student / name).write_bytes(content)
    (source / "31-same-too").mkdir()
    (source / "31-same-too" / "other name.csv").write_bytes(GOOD + b"\n")
    (source / "31-same-too" / "equations.txt").write_text("\n".join(EQUATIONS))
    hand_in(source / "21-links")
    (source / "21-links" / "table2.csv").symlink_to("/etc/hostname")
    (root / "elsewhere.csv").write_bytes(GOOD.replace(b"1", b"2"))
    os.link(root / "elsewhere.csv", source / "21-links" / "hard.csv")
    os.mkfifo(source / "21-links" / "pipe.csv")
    (source / "21-links" / "folder.csv").mkdir()
    for name in STRANGE[1:]:
        hand_in(source / name)
    for name in ("Same", "same", "e\u0301va", "\u00e9va"):
        hand_in(source / name)
    before = {path: path.stat().st_mtime_ns for path in source.rglob("*")}
    out = root / "out"
    done = CliRunner().invoke(main, ["grade", str(source), "--variant", "31", "--out", str(out), "--jobs", "1"])
    assert done.exit_code == 0, done.output
    assert {path: path.stat().st_mtime_ns for path in source.rglob("*")} == before
    assert {path.name for path in root.iterdir()} == {"in", "out", "elsewhere.csv"}
    document = json.loads((out / "grades.json").read_text(encoding="utf-8"))
    return out, {entry["id"]: entry for entry in document["submissions"]}, document


@pytest.mark.parametrize("student", HOSTILE)
def test_state_and_reason_of_each(graded, student):
    out, found, _ = graded
    _, state, told, points = HOSTILE[student]
    entry = found[student]
    page = html.unescape((out / "feedback" / f"{student}.html").read_text(encoding="utf-8"))
    assert entry["status"] == state, (entry["status"], page[-1500:])
    assert told in page or told in {note["code"] for note in entry["notes"]}
    if points is not None:
        assert entry["table"]["score"] == pytest.approx(points, abs=0.01)
    assert (entry["score"] is None) is (state not in {"graded", "graded-with-notes"})
    if student != "24-imports" and state.startswith("graded") and entry["equations"] and len(entry["equations"]["items"]) == 4:
        assert entry["equations"]["score"] == (30.0 if student == "26-dependent" else 40.0)


def test_a_missing_part_is_proposed_and_said(graded):
    entry = graded[1]["35-missing-part"]
    assert (entry["proposed"], entry["score"]) == (60.0, None)
    assert "empty_part" in {note["code"] for note in entry["notes"]}


def test_no_page_runs_anything_and_every_page_is_small(graded):
    out = graded[0]
    for path in [*(out / "feedback").iterdir(), out / "class.html"]:
        page = path.read_text(encoding="utf-8")
        assert not re.search(r"<script|<img|onerror=[^&]*>|<svg onload", page), path.name
        assert page.count("<style>") == page.count("</style>") == 1
        assert "\u202e" not in page
        assert "\u200b" not in re.sub(r"(?:\S{12}|[^\w\s])\u200b", "", page)  # those after a sign, or a whole piece, are ours
        assert len(page.encode()) < 45_000 or path.name == "class.html"
    for name in ("grades.csv", "changes.csv"):
        text = (out / name).read_text(encoding="utf-8-sig")
        for row in csv.reader(io.StringIO(text)):
            assert not any(re.match(r"[\s\"']*[=+@＝＋＠\t\r\n]", cell) and not cell.startswith("'") for cell in row), row


def test_names_of_students_never_become_paths(graded):
    out, found, _ = graded
    for name in STRANGE[1:]:
        assert found[name]["status"].startswith("graded")
        assert re.fullmatch(r"feedback/x-[0-9a-f]{16}\.html", found[name]["page"])
        assert (out / found[name]["page"]).is_file()


def test_names_that_are_one_name_need_a_person(graded):
    found = graded[1]
    assert {found[name]["status"] for name in ("Same", "same")} == {"needs-review"}
    assert found["\u00e9va"]["status"] == "needs-review"


def test_links_pipes_and_folders_are_left_aside(graded):
    entry = graded[1]["21-links"]
    assert entry["status"] == "graded-with-notes"
    assert "ignored_file" in {note["code"] for note in entry["notes"]}
    assert not any("hostname" in json.dumps(file) for file in entry["files"])


def test_equal_files_are_shown_and_cost_nothing(graded):
    groups = graded[2]["class"]["same_files"]
    assert any({"31-same", "31-same-too"} <= set(group) for group in groups)
    assert graded[1]["31-same-too"]["score"] == 100


def test_a_table_equal_to_the_key_has_full_marks_and_a_note(tmp_path):
    from coursework.grading.marking.key.key import key_of

    hand_in(tmp_path / "in" / "twin")
    (tmp_path / "in" / "twin" / "table.csv").unlink()
    (tmp_path / "in" / "twin" / "table.xlsx").write_bytes(exact_sheet(key_of(coursework.load("31")).table))
    done = CliRunner().invoke(
        main, ["grade", str(tmp_path / "in"), "--variant", "31", "--out", str(tmp_path / "out"), "--jobs", "1"]
    )
    assert done.exit_code == 0, done.output
    (entry,) = json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))["submissions"]
    assert entry["score"] == 100
    assert [note["code"] for note in entry["notes"]] == ["bit_identical"]


def test_overlapping_and_russian_names_in_a_zip(tmp_path):
    """Names of an old Russian program have no mark of their alphabet; nothing of a zip is written to a disk."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as file:
        for student in ("Иванов", "../../out"):
            for name, part in (("table.csv", GOOD), ("equations.txt", "\n".join(EQUATIONS).encode())):
                file.writestr(zipfile.ZipInfo(f"{student}/{name}"), part)
    raw = content.getvalue()
    for encoded in ("Иванов/table.csv", "Иванов/equations.txt"):
        assert raw.count(encoded.encode()) == 2
    place = tmp_path / "all.zip"
    flags = raw.replace(b"PK\x03\x04\x14\x00\x00\x08", b"PK\x03\x04\x14\x00\x00\x00").replace(
        b"PK\x01\x02\x14\x03\x14\x00\x00\x08", b"PK\x01\x02\x14\x03\x14\x00\x00\x00"
    )
    place.write_bytes(flags)
    done = CliRunner().invoke(main, ["grade", str(place), "--variant", "31", "--out", str(tmp_path / "out"), "--jobs", "1"])
    assert done.exit_code == 0, done.output
    document = json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))
    assert [entry["id"] for entry in document["submissions"]] == ["Иванов"]
    assert document["submissions"][0]["status"] == "graded"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["all.zip", "out"]
    assert Path(tmp_path / "out").is_dir()


def test_grades_json_has_the_shape_it_is_described_with(graded):
    schema = json.loads((Path(__file__).parent / "grades.schema.json").read_text(encoding="utf-8"))
    faults = jsonschema.Draft202012Validator(schema).iter_errors(graded[2])
    assert [(list(fault.absolute_path), fault.message[:200]) for fault in faults] == []
