"""Files are understood by what is in them: the kinds of the task, the lines of equations, answers, what stands in for a table."""

from __future__ import annotations

import pytest

from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import StudentWork
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.formula.tree import spelled
from tests.grading.reading.table.dialects import DIALECTS, archive, written
from tests.grading.scenes import expected, times

GRID = expected().grid
COLUMNS = {column.name: (column.unit, column.values) for column in GRID.columns}


def table(dialect: str = "excel_ru", digits: int = 4, rows: int = 25) -> bytes:
    return DIALECTS[dialect](GRID.names, written(times(GRID), COLUMNS, "fixed", digits, "rad")[:rows], "rad")


def read(*files: tuple[str, bytes], answers: tuple[str, ...] = ()) -> StudentWork:
    handed = Submission("one", None, tuple(submitted_file(name, content) for name, content in files))
    return read_submission(handed, expected("31", answers))


def codes(contents: StudentWork) -> list[str]:
    return [note.code for note in contents.notes]


EQUATIONS = """# the guide
VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0
2) 2r3·ω3·sin φ3 − r3ω3cos φ3 + 0,5r3w4
Прошу зарахувати
-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0   # D
r3*w3*sin(phi3) - r2*w2*cos(phi2) - ph1*w1*cos(phi1) = 0
"""


def test_a_table_and_equations_and_answers() -> None:
    text = "wAB = -0,35 рад/с\nvC=3/4 m/s\nwBC =\nother = 1\nw_cd = much"
    names = ("wAB", "vC", "wBC", "wCD")
    contents = read(("a.dat", table()), ("b", EQUATIONS.encode()), ("c.txt", text.encode("cp1251")), answers=names)
    assert [entry.kind for entry in contents.files] == ["table", "equations", "equations"]
    assert contents.table is not None and contents.trouble is None
    assert contents.equations is not None
    assert [(line.line, bool(line.repaired), line.tree is None) for line in contents.equations] == [
        (2, False, False), (3, True, False), (5, False, False), (6, False, True), (4, False, True),
    ]  # fmt: skip
    assert spelled(contents.equations[1].difference.args[0]) == "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4"
    fault = contents.equations[3].fault
    assert fault is not None and (fault.line, fault.column) == (6, 37)
    assert fault.message == 'symbol "ph1" is not declared. Did you mean "phi1"?'
    assert [(answer.name, answer.value, answer.state) for answer in contents.answers] == [
        ("wAB", -0.35, "read"), ("vC", 0.75, "read"), ("wBC", None, "blank"), ("wCD", None, "unreadable"),
    ]  # fmt: skip
    assert "repaired" not in codes(contents)  # what was added to be read is told of lines that count


LINES = ("VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0", "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0")


@pytest.mark.parametrize("dialect", ["excel_ru", "own_program", "excel_en", "tab_separated", "mathcad_prn"])
@pytest.mark.parametrize("place", ["above", "below", "typed into cells"])
def test_equations_beside_a_table_in_one_text_are_read_with_it(dialect: str, place: str) -> None:
    rows = table(dialect)
    content = rows.decode("cp1251" if dialect == "excel_ru" else "utf-8")
    sign = {"excel_ru": ";", "excel_en": ",", "tab_separated": "\t"}.get(dialect, " ")
    lines = "\n".join(LINES)
    if place == "typed into cells":
        lines = "\n".join(f'"{line}"{7 * sign}' for line in LINES)
    text = f"{lines}\n\n{content}" if place != "below" else f"{content}\n\n{lines}\nдалі"
    contents = read(("work.txt", text.encode("cp1251" if dialect == "excel_ru" else "utf-8")))
    assert contents.table is not None and contents.trouble is None
    assert contents.table.column("w4").values == read(("t.csv", rows)).table.column("w4").values  # type: ignore[union-attr]
    assert contents.equations is not None
    assert [line.tree is None for line in contents.equations] == [False, False]
    first = text.splitlines().index(lines.splitlines()[0]) + 1
    assert [line.line for line in contents.equations] == [first, first + 1]
    assert [entry.kind for entry in contents.files] == ["table"]


def test_a_line_beside_a_table_that_cannot_be_read_is_told_where_others_can() -> None:
    broken = "r3*w3*sin(ph3) = VMy"
    contents = read(("work.csv", f"{LINES[0]}\n{broken}\n".encode() + table("csv_utf8").removeprefix(b"\xef\xbb\xbf")))
    assert contents.equations is not None
    assert [line.tree is None for line in contents.equations] == [False, True]


def test_titles_above_a_table_are_no_equations_and_a_file_of_equations_goes_first() -> None:
    titles = b"Variant=31, h = 0.02 s\nw1 = 13.08\nr1 = 0.953; VMy = V1 sin(p t)\nT=0,48 c\n"
    rows = table("csv_utf8").removeprefix(b"\xef\xbb\xbf")
    assert read(("t.csv", titles + rows)).equations is None
    both = read(("t.csv", LINES[0].encode() + b"\n" + rows), ("e.txt", LINES[1].encode()))
    assert both.equations is not None
    assert [line.file for line in both.equations] == ["e.txt"]
    assert both.table is not None


@pytest.mark.long
@pytest.mark.parametrize(("filling", "number"), [("a=b", 280), ("a=" + "b" * 998, 60)])
def test_of_many_lines_beside_a_table_only_the_first_are_tried_and_the_others_are_told(filling: str, number: int) -> None:
    """280 lines are tried for the 28 equations that may be handed in, or 60 000 characters."""
    rows, line = table("csv_utf8").removeprefix(b"\xef\xbb\xbf"), LINES[0].encode() + b"\n"
    before = f"{filling}\n".encode()
    last, late = (read(("t.csv", rows + before * count + line)) for count in (number - 1, number))
    assert last.table is not None and late.table is not None
    assert last.equations is not None and [one.text for one in last.equations] == [LINES[0]]
    assert "ignored_file" not in codes(last)
    assert late.equations is None
    assert [entry.text for entry in late.notes if entry.code == "ignored_file"] == [
        "Lines that may be equations were not read, since there are enough before them: 1."
    ]


def test_answers_beside_a_table_are_read() -> None:
    rows = table("csv_utf8").removeprefix(b"\xef\xbb\xbf")
    contents = read(("t.csv", b"wAB = -0.35 rad/s\n" + rows), answers=("wAB",))
    assert [answer.value for answer in contents.answers] == [-0.35]
    assert contents.equations is None


@pytest.mark.parametrize(
    "line",
    [
        "VMy = r3*w3*(2*cos(phi3) + sin(phi3))", "V_My − 2r₃ω₃cosφ₃ − r₃ω₃sinφ₃ = 0", "VMy - 2[r3 w3 cos(phi3)] - r3*w3*sin phi3",
        "(11) VMy-2*r3*w3*cosφ3-r3*w3*sin(ф3)=0;", "V_Cy = VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0",
        "Рівняння 1: VMy - 2·r3·ωз3*cos(phi3) = 0".replace("ωз3", "ω3"), "V_{My} - 2 r_3 \\omega_3 \\cos\\varphi_3 = 0",
        "r3·φ̇3·sin²φ3 + r3*w3*cos^2(phi3) = tg(phi3)", "VМy - r3*w3*соs(phi3) = 0",
    ],
)  # fmt: skip
def test_forms_that_people_write_are_read(line: str) -> None:
    contents = read(("equations.txt", line.encode()))
    assert contents.equations is not None
    (read_line,) = contents.equations
    assert read_line.fault is None
    assert read_line.tree is not None


@pytest.mark.parametrize(
    ("line", "column"),
    [
        ("__import__('os').system('rm -rf /') = 0", 1), ("().__class__.__bases__[0] = 0", 2), ("lambda: 0 = w1", 7),
        ("[w for w in w1] = 0", 2), ("phi1.real = 0", 5), ("r1[0] = 0", 3), ("9**9**9 = w1", 4), ("w1**w2 = 0", 5),
        ("w1**(1000) = 0", 5), ("exp(exp(exp(99))) = w1", 5), ("(" * 10_000 + "w1" + ")" * 10_000 + " = 0", 2000),
        ("+".join(["w1"] * 3000) + " = 0", 2000), ("w1 = w2 = w3 = 0", 9), ("eval(w1) = 0", 1), ("1_000*w1 = 0", 2),
        ("nan*w1 = 0", 1), ("٣*w1 = 0", 1), ("1e400*w1 = 0", 1), ("sin^9(sin^9(w1)) = 0", 1),
    ],
)  # fmt: skip
def test_hostile_lines_are_unreadable_with_their_column_and_the_rest_is_read(line: str, column: int) -> None:
    contents = read(("equations.txt", f"{line}\nr3*w3 = VMy".encode()))
    assert contents.equations is not None
    hostile, good = contents.equations
    assert hostile.tree is None
    assert hostile.fault is not None
    assert hostile.fault.column == column, hostile.fault
    assert len(hostile.text) <= 2000
    assert good.tree is not None


def test_data_of_a_program_beside_a_table_are_no_equations() -> None:
    told = '{"sentence": "All 4 equations hold at t = 0.", "left": "w1 = 0"}'
    contents = read(("table.csv", table("csv_utf8")), ("run.json", told.encode()))
    assert contents.table is not None and contents.equations is None
    assert [entry.kind for entry in contents.files] == ["table", "ignored"]
    assert codes(contents) == ["ignored_file"]
    alone = read(("run.json", told.encode()))
    assert alone.trouble is not None and alone.trouble.code == "no_table"
    broken = read(("table.csv", table("csv_utf8")), ("lines.txt", b"[w1] - w2 = 0"))
    assert broken.equations is not None  # brackets alone make no JSON


def test_only_so_many_equations_are_read() -> None:
    contents = read(("equations.txt", b"w1 = 0\n" * 100))
    assert contents.equations is not None
    assert len(contents.equations) == 2 * 4 + 20
    assert [entry.text[-3:] for entry in contents.notes if entry.code == "ignored_file"] == ["72."]


def test_kinds_by_content() -> None:
    files = (
        ("notes.pdf", b"%PDF-1.4 scan"), ("report.docx", archive({"word/document.xml": "<x/>"})),
        ("table", table("xlsx_numbers")), ("readme.txt2", b"see the table"), ("empty.eq", b""),
    )  # fmt: skip
    contents = read(*files)
    assert [entry.kind for entry in contents.files] == ["attachment", "attachment", "table", "ignored", "attachment"]
    assert contents.trouble is None
    assert codes(contents)[:4] == ["attachment", "attachment", "ignored_file", "empty_part"]


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("table.csv", b"", "empty"), ("table.csv", b" \r\n\r\n", "empty"), ("table.csv", b"%PDF-1.5", "other_kind"),
        ("table.xlsx", b"\xff\xd8\xff\xe0JFIF", "other_kind"), ("table.txt", b"{\\rtf1 x}", "other_kind"),
        ("table.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(500), "old_excel"),
        ("table.csv", archive({"word/document.xml": "<x/>"}), "other_kind"),
        ("table.numbers", archive({"Index/Document.iwa": b"x"}), "other_kind"),
        ("table.xmcd", b'<?xml version="1.0"?><worksheet xmlns="http://schemas.mathsoft.com/worksheet30">', "other_kind"),
        ("scan.pdf", b"%PDF-1.5", "other_kind"), ("table.csv", "Таблиця на аркуші".encode(), "no_table"),
        ("a.url", b"[InternetShortcut]\r\nURL=https://docs.example/\r\n", "link"), ("a.txt", b"https://docs.example/1", "link"),
        ("a.gsheet", b'{"url":"https://docs.example/1","doc_id":"1"}', "link"), ("a.lnk", b"L\0\0\0\1\x14\2\0\0", "link"),
        ("a.webloc", b'<?xml version="1.0"?><plist><dict><key>URL</key><string>x</string></dict></plist>', "link"),
    ],
)  # fmt: skip
def test_what_stands_in_for_a_table_is_unreadable_with_advice(name: str, content: bytes, code: str) -> None:
    contents = read((name, content))
    assert contents.table is None
    assert contents.trouble is not None
    assert (contents.trouble.state, contents.trouble.code) == ("unreadable", code)
    if code == "other_kind":
        kind = {"table.xlsx": "JPEG", "table.txt": "RTF", "table.numbers": "Apple Numbers", "table.xmcd": "Mathcad"}
        assert kind.get(name, "Word" if content[:2] == b"PK" else "PDF") in contents.trouble.text
        assert contents.trouble.text.endswith("Save the table as xlsx or CSV.")


def test_a_pdf_beside_equations_is_an_attachment_and_the_table_is_missing() -> None:
    contents = read(("scan.pdf", b"%PDF-1.5"), ("e.txt", EQUATIONS.encode()))
    assert contents.trouble is not None
    assert contents.trouble.state == "missing"
    assert read().trouble is not None
    assert read().trouble.state == "missing"  # type: ignore[union-attr]


def test_of_two_tables_the_fuller_one_counts_and_equal_ones_need_a_person() -> None:
    fuller = read(("a.csv", table("excel_ru", 4, 20)), ("b.csv", table("excel_en", 3)))
    assert fuller.table is not None
    assert fuller.table.reading.file == "b.csv"
    assert "two_tables" in codes(fuller)
    doubtful = read(("a.csv", table("excel_en", 4)), ("b.csv", table("excel_en", 3)))
    assert doubtful.trouble is not None
    assert (doubtful.trouble.state, doubtful.trouble.code) == ("needs-review", "two_tables")
    same = read(("table.csv", table()), ("table (1).csv", table()))
    assert same.table is not None


def test_positions_in_one_table_and_velocities_in_another_are_one_table() -> None:
    """A page is too narrow for eight columns: each half has the time; halves of other rows, or that differ, stay two tables."""
    rows = [line.split(b",") for line in table("excel_en").splitlines()]
    halves = [[b",".join([row[0], *row[part]]) for row in rows] for part in (slice(1, 4), slice(4, 8), slice(3, 8))]
    whole = read(("t.csv", table("excel_en")))
    for second in halves[1:]:
        two = read(("a.csv", b"\n".join(halves[0])), ("b.csv", b"\n".join(second)))
        assert two.table is not None and whole.table is not None
        assert {column.name: column.values for column in two.table.columns} == {c.name: c.values for c in whole.table.columns}
        assert "two_tables" not in codes(two)
    for other in (halves[1][:8], [line.replace(b"2.", b"3.") for line in halves[2]]):
        apart = read(("a.csv", b"\n".join(halves[0])), ("b.csv", b"\n".join(other)))
        assert apart.table is None or "two_tables" in codes(apart)


def test_a_zip_is_opened_once_in_memory() -> None:
    inner = archive({"deep.csv": table()})
    files = {"work/table.csv": table(), "__MACOSX/work/._table.csv": b"x", "work/equations.txt": EQUATIONS, "more.zip": inner}
    contents = read(("all.zip", archive(files)))
    assert [entry.name for entry in contents.files] == [
        "all.zip/more.zip",
        "all.zip/work/equations.txt",
        "all.zip/work/table.csv",
    ]
    assert contents.table is not None
    assert contents.equations is not None
    nested = read(("all.zip", archive({"more.zip": inner})))
    assert nested.trouble is not None
    assert nested.trouble.code == "nested_zip"


def test_text_typed_into_moodle() -> None:
    lines = [line.split(";") for line in table("csv_utf8").decode("utf-8-sig").split("\r\n") if line]
    rows = "".join("<tr>" + "".join(f"<td><p>{cell}</p></td>" for cell in row) + "</tr>\n" for row in lines)
    contents = read(("onlinetext.html", f"<div><table>{rows}</table></div>".encode()))
    assert contents.table is not None
    page = "<p>VMy - 2*r3*w3*cos(phi3) = 0<br />r3*w3 &minus; VMy&nbsp;= 0</p><script>w1 = 0</script><p>w1 &lt; 2</p>"
    typed = read(("onlinetext.html", page.encode()))
    assert typed.equations is not None
    assert [line.fault for line in typed.equations] == [None, None]
