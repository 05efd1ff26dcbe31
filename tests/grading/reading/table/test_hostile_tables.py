"""Tables that mislead: the state, the code and the bounds of each."""

from __future__ import annotations

import math

import pytest

from coursework.grading.reading.numbers import stored
from coursework.grading.reading.student_work import Table, Trouble
from coursework.grading.reading.table.digits import last_places
from tests.grading.reading.table.dialects import workbook, written
from tests.grading.reading.table.misread import COLUMNS, GRID, HEAD, ROWS, cells, codes, column, csv, read, read_table, refused
from tests.grading.scenes import times


def test_commas_for_everything_are_never_guessed() -> None:
    pairs = "\n".join(",".join(text.replace(".", ",") for text in row) for row in ROWS).encode()
    for content in (pairs, ",".join(HEAD).encode() + b"\n" + pairs):
        trouble = refused(content)
        assert (trouble.state, trouble.code) == ("unreadable", "comma_twice")


def test_a_thousand_or_a_decimal_is_decided_by_the_whole_file() -> None:
    texts = [[text.replace(".", ",") for text in row] for row in written(times(GRID), COLUMNS, "fixed", 3, "rad")]
    assert column(read(csv(texts, "\t")), "w3")[0] == 5.552
    whole = [[str(k), *(f"{1 + k + j},{500 + k}" for j in range(7))] for k in range(25)]
    by_number = "\n".join("\t".join(row) for row in [["№", *HEAD[1:]], *whole])
    trouble = refused(by_number.encode())
    assert (trouble.state, trouble.code) == ("needs-review", "thousands")
    one = [row if k else ["0,5", *row[1:]] for k, row in enumerate(whole)]
    decided = "\n".join("\t".join(row) for row in [["№", *HEAD[1:]], *one])
    assert column(read(decided.encode()), "w1")[:2] == (4.5, 5.501)


def test_both_marks_in_one_file() -> None:
    mixed = read(csv(cells(r2c2="1,5985")))
    assert column(mixed, "phi1")[1] == 1.5985
    ambiguous = read(csv(cells(r2c2="1,5985", r3c8="-11,033")))
    assert math.isnan(column(ambiguous, "w4")[2])
    half = [[text.replace(".", ",") if k % 2 else text for k, text in enumerate(row)] for row in cells(r1c1="0.00")]
    assert refused(csv(half)).state == "needs-review"


def test_a_date_in_the_time_is_restored_and_elsewhere_missing() -> None:
    table = read(csv(cells(r6c1="01.май", r7c1="02. Mai", r11c3="03.янв")))
    assert all(table.rows_present)
    phi2 = table.column("phi2")
    assert phi2 is not None
    assert phi2.flags[10] == "date"
    assert math.isnan(phi2.values[10])
    assert codes(table) == ["date_cell"] and table.notes[0].text.endswith("have no number: 1.")  # two times were restored
    only_time = read(csv(cells(r6c1="2026-05-01")))
    assert only_time.notes[0].text.endswith("restored from the times around them: 1.")
    styles = '<styleSheet><numFmts><numFmt numFmtId="164" formatCode="dd\\.mmm"/></numFmts><cellXfs><xf numFmtId="0"/>'
    sheet = [[f"t:{text}" for text in HEAD], *([f"n:{text}" for text in row] for row in ROWS)]
    sheet[6][0], sheet[11][2] = "d:45778", "d:45778"
    dated = read(workbook({"1": sheet}, styles=styles + '<xf numFmtId="164"/></cellXfs></styleSheet>'), "t.xlsx")
    assert all(dated.rows_present)
    assert dated.column("phi2").flags[10] == "date"  # type: ignore[union-attr]


@pytest.mark.parametrize(
    "text", ["#ДЕЛ/0!", "#ЗНАЧ!", "#ИМЯ?", "#DIV/0!", "####", "NaN", "inf", "-inf", "1e999", "1e-999", "#REF!", "Err:502"]
)
def test_an_error_is_a_missing_cell(text: str) -> None:
    table = read(csv(cells(r11c7=text)))
    w3 = table.column("w3")
    assert w3 is not None
    assert w3.flags[10] == "error"
    assert math.isnan(w3.values[10])
    assert codes(table) == ["error_cell"]
    assert sum(map(math.isfinite, w3.values)) == 24


def test_rows_that_are_counted_without_a_head_are_read_by_the_heads_of_the_others() -> None:
    for sign in (" ", ","):
        counted = [f"{k}{sign}{sign.join(row)}" for k, row in enumerate(ROWS)]
        table = read("\n".join([sign.join(HEAD), *counted]).encode())
        assert [table.column(name).at for name in ("phi1", "w4")] == [3, 9]  # type: ignore[union-attr]
        assert table.rows_present == (True,) * 25


@pytest.mark.parametrize("angle", ["θ{}", "theta_{} [rad]", "φ{}"])
@pytest.mark.parametrize("rate", ["dphi{}/dt", "dφ{}/dt, рад/с", "φ\u0307{}", "phi{}_dot", "d theta{}/dt"])
def test_angles_by_another_letter_and_velocities_as_derivatives(angle: str, rate: str) -> None:
    heads = ["t", *(angle.format(k) for k in (1, 2, 3)), *(rate.format(k) for k in (1, 2, 3)), "w4"]
    table = read("\n".join(";".join(row) for row in [heads, *ROWS]).encode())
    assert [(column.name, column.by) for column in table.columns] == [(name, "header") for name in GRID.names]


def test_rows_shuffled_repeated_and_contradicting() -> None:
    shuffled = [ROWS[(7 * k) % 25] for k in range(25)]
    table = read(csv(shuffled))
    assert column(table, "w3") == column(read(csv(ROWS)), "w3")
    assert (table.reading.order, codes(table)) == ("sorted", ["rows_sorted"])
    twice = read(csv([*ROWS, ROWS[4]]))
    assert column(twice, "w3") == column(table, "w3")
    unsure = read(csv([*ROWS, [ROWS[4][0], *ROWS[5][1:]]]))
    assert column(unsure, "w3") == column(table, "w3")
    assert unsure.unsure is not None and "row 5" in unsure.unsure
    assert unsure.in_order is not None


def test_rows_of_the_grid_within_three_tenths_of_a_step() -> None:
    inside = read(csv(cells(r3c1="0.0459")))
    assert all(inside.rows_present)
    outside = read(csv(cells(r3c1="0.0461")))
    assert [k for k, present in enumerate(outside.rows_present, start=1) if not present] == [3]
    assert codes(outside) == ["rows_missing", "rows_extra"]


@pytest.mark.parametrize(("step", "first", "off", "rows", "is_own"), [
    (2, 0, 0, 6, True), (1, 0, 0, 6, False), (1.04, 0, 0, 6, False), (1.06, 0, 0, 6, True), (0.96, 0, 0, 6, False),
    (0.94, 0, 0, 6, True), (2, 0, 0, 3, True), (2, 0, 0, 2, False), (2, 0, 0.28, 6, True), (2, 0, 0.32, 6, False),
    (1.5, 0.28, 0, 6, True), (1.5, 0.32, 0, 6, False),
])  # fmt: skip
def test_a_step_of_ones_own_on_both_sides_of_its_limits(step: float, first: float, off: float, rows: int, is_own: bool) -> None:
    """In steps of the grid; where the first row stands, and how far one row is off, in parts of the own step; φ₁ a turn on."""
    own = [step * GRID.step * (first * (row == 0) + row + off * (row == 2)) for row in range(rows)]
    printed = [[f"{time:.6f}", f"{float(row[1]) + math.tau:.4f}", *row[2:]] for time, row in zip(own, ROWS, strict=False)]
    found = read(csv(printed)).own
    assert (found is not None) == is_own
    if found is not None:
        assert found.step == pytest.approx((own[-1] - own[0]) / (rows - 1))
        assert found.columns["phi1"][0] == pytest.approx([float(row[1]) for row in ROWS[:rows]], abs=1e-4)


def test_columns_repeated_exchanged_missing_and_unknown() -> None:
    same = [[*row, row[2]] for row in ROWS]
    table = read("\n".join(";".join(row) for row in [[*HEAD, "φ2"], *same]).encode())
    assert codes(table) == ["duplicate_column"]
    trouble = refused("\n".join(";".join(row) for row in [[*HEAD, "φ1"], *same]).encode())
    assert (trouble.state, trouble.code) == ("needs-review", "two_columns")
    exchanged = [[row[0], row[2], row[1], *row[3:]] for row in ROWS]
    heads = ["t", "φ2", "φ1", *HEAD[3:]]
    assert column(read("\n".join(";".join(row) for row in [heads, *exchanged]).encode()), "phi1") == column(
        read(csv(ROWS)), "phi1"
    )
    six = "\n".join(";".join(row[:-1]) for row in ROWS).encode()
    assert refused(six).code == "count_columns"
    named = read("\n".join(";".join(row[:-1]) for row in [HEAD, *ROWS]).encode())
    assert named.column("w4") is None
    other = read("\n".join(";".join(row) for row in [[*HEAD[:-1], "V_M"], *ROWS]).encode())
    assert other.column("w4") is None


def test_position_counts_only_where_the_heads_agree() -> None:
    lost = ["t", "?1", "?2", "?3", "?1", "?2", "?3", "?4"]
    table = read("\n".join(";".join(row) for row in [lost, *ROWS]).encode())
    assert {name: entry["by"] for name, entry in table.reading.columns.items()} == {
        "t": "header", "phi1": "position", "phi2": "position", "phi3": "position", "w1": "position", "w2": "position",
        "w3": "position", "w4": "header",
    }  # fmt: skip
    assert codes(table) == ["greek_lost"]
    wrong = ["t", "?1", "?3", "?2", "?2", "?1", "?3", "?4"]
    read_wrong = read("\n".join(";".join(row) for row in [wrong, *ROWS]).encode())
    assert column(read_wrong, "phi3") == column(read(csv(ROWS)), "phi2")  # what the heads say, not where they stand
    half = "\n".join(";".join(row[:4]) for row in [lost[:4], *ROWS]).encode()
    assert refused(half).code == "count_columns"


def test_ten_times_too_much_is_a_slip_and_no_unit() -> None:
    tenfold = read(csv([[*row[:4], *(f"{float(text) * 10:.4f}" for text in row[4:])] for row in ROWS]))
    assert [tenfold.column(name).unit for name in ("phi1", "w1", "w4")] == ["rad", "1/s", "1/s"]  # type: ignore[union-attr]
    assert codes(tenfold) == []


def test_units_from_the_header_and_from_the_numbers() -> None:
    rpm = [[*row[:4], *(f"{float(text) * 30 / math.pi:.4f}" for text in row[4:])] for row in ROWS]
    table = read(csv(rpm))
    assert [table.column(name).unit for name in ("phi1", "w1", "w4")] == ["rad", "rpm", "rpm"]  # type: ignore[union-attr]
    assert codes(table) == ["rpm"]
    assert abs(column(table, "w4")[0] - GRID.columns[6].values[0]) < 1e-4
    turned = [[row[0], f"{math.degrees(float(row[1])) - 720:.3f}", *row[2:]] for row in ROWS]
    degrees = read(csv(turned))
    assert codes(degrees) == ["degrees", "turns"]
    assert abs(column(degrees, "phi1")[5] - GRID.columns[0].values[5]) < 1e-4
    nothing = read(csv([[row[0], row[1], "0.0000", *row[3:]] for row in ROWS]))  # 3.37 rad away: no whole turn
    assert column(nothing, "phi2")[0] == 0 and codes(nothing) == []
    said = "\n".join(";".join(row) for row in [["t", "phi1, deg", *HEAD[2:]], *ROWS]).encode()
    assert read(said).column("phi1").unit == "rad"  # type: ignore[union-attr]  # the numbers are radians, whatever is above
    milliseconds = [[f"{1000 * float(row[0]):g}", *row[1:]] for row in ROWS]
    assert all(read(csv(milliseconds)).rows_present)


def test_without_a_time_rows_count_in_order_or_by_their_numbers() -> None:
    bare = "\n".join(";".join(row[1:]) for row in [HEAD, *ROWS]).encode()
    assert column(read(bare), "w3") == column(read(csv(ROWS)), "w3")
    numbered = [["№", *HEAD[1:]], *([str(k), *row[1:]] for k, row in enumerate(ROWS, start=1))]
    numbered[1:] = numbered[:0:-1]
    assert column(read("\n".join(";".join(row) for row in numbered).encode()), "w3") == column(read(csv(ROWS)), "w3")


def test_formulas_without_values() -> None:
    heads = [f"t:{text}" for text in HEAD]
    empty = workbook({"1": [heads, *([f"n:{row[0]}", *["f:A1+1"] * 7] for row in ROWS)]})
    trouble = refused(empty, "t.xlsx")
    assert (trouble.state, trouble.code) == ("unreadable", "formulas")
    few = [[f"n:{text}" for text in row] for row in ROWS]
    few[10][7] = "f:B3*2"
    table = read(workbook({"1": [heads, *few]}), "t.xlsx")
    assert table.column("w4").flags[10] == "formula"  # type: ignore[union-attr]
    assert "of w4 hold formulas" in table.unsure  # type: ignore[union-attr]
    few = [["f:A1+0.02" if place == 0 and k else text for place, text in enumerate(row)] for k, row in enumerate(few)]
    assert "of t and w4 hold formulas" in read(workbook({"1": [heads, *few]}), "t.xlsx").unsure  # type: ignore[union-attr]
    error = [[f"n:{text}" for text in row] for row in ROWS]
    error[10][7] = "e:#DIV/0!"
    assert read(workbook({"1": [heads, *error]}), "t.xlsx").column("w4").flags[10] == "error"  # type: ignore[union-attr]


def test_the_first_sheet_with_a_table_wins_and_is_named() -> None:
    good = [[f"t:{text}" for text in HEAD], *([f"n:{text}" for text in row] for row in ROWS)]
    table = read(workbook({"Титул": [["t:Курсова"]], "Таблиця": good, "Графік": good}), "t.xlsx")
    assert table.reading.sheet == "Таблиця"
    assert "Таблиця" in table.notes[0].text
    assert refused(workbook({str(k): [["t:x"]] for k in range(12)} | {"13": good}), "t.xlsx").code == "no_sheet_table"


DATA = [
    ["t:symbol", "t:value", "t:again"],
    *([f"t:{name}", f"n:{value}", f"n:{value}"] for name, value in zip(HEAD, ROWS[0], strict=True)),
]


def test_a_sheet_of_data_before_the_table_is_not_the_table_even_where_that_was_never_computed() -> None:
    good = [[f"t:{text}" for text in HEAD], *([f"n:{text}" for text in row] for row in ROWS)]
    found = read(workbook({"Data": DATA, "Table": good, "Exact": good}), "t.xlsx")
    assert (found.reading.sheet, found.reading.transposed, sum(found.rows_present)) == ("Table", False, len(ROWS))
    empty = [good[0], *([f"n:{row[0]}", *["f:A1+1"] * 7] for row in ROWS)]
    assert refused(workbook({"Data": DATA, "Table": empty, "Exact": good}), "t.xlsx").code == "formulas"


def test_a_table_under_heads_of_other_things_gives_way_and_no_head_at_all_does_not() -> None:
    good = [[f"t:{text}" for text in HEAD], *([f"n:{text}" for text in row] for row in ROWS)]
    points = [[f"t:{text}" for text in ("t", "xA", "yA", "xB", "yB", "vB", "aB", "xC")], *good[1:]]
    short = good[:12]
    assert read(workbook({"Points": points, "Short": short}), "t.xlsx").reading.sheet == "Short"
    assert read(workbook({"Bare": good[1:], "Short": short}), "t.xlsx").reading.sheet == "Bare"


def test_digits_of_stored_numbers_are_no_printed_ones() -> None:
    column = last_places(
        [stored(text) for text in ("-4.0", "-5.000000000000001", "-5.726309395472406", *("0.123456789012345",) * 30)]
    )
    assert set(column[1]) == {1e-9}


def test_gaps_between_blanks_are_told_by_where_the_numbers_stand() -> None:
    aligned = ["".join(f"{text:>12}" for text in row) for row in [HEAD, *cells(r11c6="", r12c2="")]]
    table = read("\n".join(aligned).encode())
    assert [name for name in GRID.names if math.isnan(column(table, name)[10])] == ["w2"]
    assert [name for name in GRID.names if math.isnan(column(table, name)[11])] == ["phi1"]
    assert column(table, "w4") == column(read(csv(ROWS)), "w4")
    loose = read("\n".join(" ".join(text for text in row if text) for row in [HEAD, *cells(r11c6="", r12c2="")]).encode())
    assert [k for k, present in enumerate(loose.rows_present, start=1) if not present] == [11, 12]


def test_long_lines_blank_rows_and_nul_bytes() -> None:
    assert refused(b"t;phi1\n" + b"1" * 20_001 + b";2\n").code == "long_line"
    assert isinstance(read_table(csv(ROWS) + b"\n" + b"x" * 20_000, "t.csv", GRID), Table)
    assert column(read(csv(ROWS) + b"\n" + b";;;;;;;\n" * 400_000), "w3")[24] == float(ROWS[24][6])
    for blank, goes_on in ((200, True), (201, False)):
        parted = csv(ROWS[:10]) + b"\n" * (blank + 1) + csv(ROWS[10:]).partition(b"\n")[2]
        assert math.isfinite(column(read(parted), "w3")[24]) == goes_on
    table = read(csv(ROWS).replace(b"\n", b"\0\n"))
    assert codes(table) == ["encoding"]
    assert column(table, "w3")[24] == float(ROWS[24][6])
    quoted = csv(ROWS).replace(b"phi1", b'"phi1')
    assert isinstance(read_table(quoted, "t.csv", GRID), (Table, Trouble))


def test_at_most_six_hundred_rows_are_read() -> None:
    many = [[f"{k * 0.0005:.4f}", *ROWS[0][1:]] for k in range(2000)]
    assert read(csv(many)).reading.rows <= 600


def test_numbers_by_our_own_pattern() -> None:
    for text in ("1_000", "٣٫٥", "0x10", "1e5e5", "--1", "1.2.3", "infinity1", "1" * 60):
        table = read(csv(cells(r2c7=text)))
        assert math.isnan(column(table, "w3")[1]), text


def test_formulas_of_a_spreadsheet_program_stay_text() -> None:
    table = read(csv(cells(r2c7='=HYPERLINK("http://x")', r3c7="@SUM(A1)", r4c7="+cmd|'/c calc'!A0")))
    assert [table.column("w3").flags[k] for k in (1, 2, 3)] == ["text"] * 3  # type: ignore[union-attr]


def test_a_wrong_table_that_grows_beyond_all_bounds_is_not_taken_for_degrees() -> None:
    """Angles in radians that begin as the task's and run away: their median is 57 times the key's, their beginning is not."""
    rows = cells()
    for k, row in enumerate(rows):
        row[1] = f"{float(row[1]) * (30 + 2.2 * k if k else 1):.3f}"
    found = read(csv(rows)).column("phi1")
    assert found is not None
    assert (found.unit, found.turns) == ("rad", ())
    for row in rows:
        row[1] = f"{float(row[1]) * 57.29578:.3f}"
    assert read(csv(rows)).column("phi1").unit == "deg"  # type: ignore[union-attr]
