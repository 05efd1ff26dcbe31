"""Equations in the cells of a workbook, in matrices, in programs that count in degrees: read, or asked about, never lost."""

from __future__ import annotations

from dataclasses import replace

from coursework.grading.reading.equations.formulas.names_in_text import spellings_of
from coursework.variant.formula.tree import named, spelled
from tests.grading.reading.equations.notation.test_more_notations import MATRICES
from tests.grading.reading.table.dialects import DIALECTS, archive, workbook, written
from tests.grading.reading.test_read_submission import COLUMNS, EQUATIONS, GRID, read, table
from tests.grading.scenes import expected, times


def test_equations_typed_into_the_cells_of_a_workbook_are_read() -> None:
    heads, *rows = [["t", *GRID.names], *written(times(GRID), COLUMNS, "fixed", 4, "rad")]
    sheet = [[f"t:{text}" for text in heads], *([f"n:{float(text)!r}" for text in row] for row in rows), ["t:h = 0.02 s"]]
    lines = EQUATIONS.split("\n")[1:3]
    work = read(("w.xlsx", workbook({"Table": sheet, "Уравнения": [[f"t:{line}"] for line in lines]})))
    assert work.table is not None and work.files[0].kinds == ("table", "equations")
    assert work.table.reading.separated == "a table of cells"
    assert work.equations is not None and [line.text for line in work.equations] == [lines[0]]  # the other has no "="
    assert work.equations[0].where == "sheet “Уравнения”, row 1"
    alone = read(("w.xlsx", workbook({"Уравнения": [["t:" + "\n".join(["By hand:", *lines])]]})), ("t.csv", table()))
    assert alone.table is not None and alone.equations is not None


def test_matrices_that_nobody_can_read_are_lines_and_not_a_bad_table() -> None:
    program = (
        "A = np.array([[r1*np.sin(phi1), r2*np.sin(phi2)],\n [r1*np.cos(phi1), r2*np.cos(phi2)]])\nw = np.linalg.solve(A, b)"
    )
    work = read(("t.csv", table()), ("e.txt", program.encode()))
    assert work.equations is not None and all(line.tree is None for line in work.equations)


def test_angles_in_degrees_are_turned_beside_a_table_in_degrees_or_in_radians() -> None:
    """A program may turn its angles for sine and cosine alone; its table says how they were printed, not how they were used."""
    line = b"w3 = VMy/(r3*(2*COS(phi3*PI()/180) + SIN(RADIANS(phi3))))"
    degrees = DIALECTS["excel_ru"](GRID.names, written(times(GRID), COLUMNS, "fixed", 4, "deg"), "deg")
    for content in (degrees, table()):
        work = read(("t.csv", content), ("e.txt", line))
        assert work.equations is not None and work.equations[0].tree is not None  # and so `precheck` tells it
        assert any(spelled(other.tree).count("180") == 0 for other in work.equations[0].others)


def test_a_matrix_between_dollars_is_read_row_by_row() -> None:
    work = read(("t.csv", table()), ("e.md", MATRICES["latex"].replace("\\[", "$$", 1).replace("\\]", "$$").encode()))
    assert work.equations is not None and len(work.equations) == 2 and all(line.tree for line in work.equations)


def test_a_zip_that_names_files_above_itself_is_read_and_nothing_is_written() -> None:
    work = read(("all.zip", archive({"../../evil.csv": table(), "/e.txt": EQUATIONS})))
    assert work.table is not None and work.equations is not None


def test_what_sets_the_source_of_a_page_in_is_no_cell() -> None:
    cells = [["t", *GRID.names], *written(times(GRID), COLUMNS, "fixed", 4, "rad")]
    rows = "".join(
        "\t<tr>\n" + "".join(f"\t\t<td width=58><p>\n\t\t\t{text}</p>\n\t\t</td>\n" for text in row) + "\t</tr>\n"
        for row in cells
    )
    lines = "".join(f"<p>{line.replace('sin', chr(10) + 'sin')}</p>\n" for line in EQUATIONS.split("\n")[1:2])
    work = read(("saved.html", f"<html>\n<body>\n<h1>\nWork</h1>{lines}<table>\n{rows}</table></body></html>".encode()))
    assert work.table is not None and work.table.cells == 7 * 25
    assert work.equations is not None and work.equations[0].tree is not None
    bare = "".join("<tr>" + "".join(f"<td>{text}" for text in row) for row in cells)
    typed = read(("typed.html", f"<html><body>{lines}<table>{bare}</table></body></html>".encode()))
    assert typed.table is not None and typed.table.columns == work.table.columns


def test_the_pin_on_a_guide_of_the_frame_gives_its_speed_a_name_and_one_on_a_moving_guide_does_not() -> None:
    guided = expected("example-2").variant
    assert spellings_of(guided, ()).canonical("V_C") == "u3"
    (crank, slider) = guided.groups
    swinging = replace(slider, guides=(replace(slider.guides[0], angle=named("theta1")),))
    assert spellings_of(replace(guided, groups=(crank, swinging)), ()).canonical("V_C") is None


def test_what_a_program_notes_behind_a_solution_and_prints_of_an_array_is_read() -> None:
    """The unknowns stand in a remark, numbers end in a bare point, words are joined by a hyphen, a definition is not used."""
    system = "A(1,1) = r3*(2*cos(phi3) + sin(phi3));\nb(1) = VMy;\nx = A\\b;   % x = [w3]"
    prose = "From the y-component we get VMy - r3*w3*(2*cos(phi3) + sin(phi3)) = 0.\ns_2 = sin(phi2)"
    rows = [[float(text) for text in row] for row in written(times(GRID), COLUMNS, "fixed", 4, "rad")]
    rows[0][1] = 2.0
    printed = ",\n ".join("[" + ", ".join(f"{cell:.4f}".rstrip("0") for cell in row) + "]" for row in rows)
    for equations in (system, prose):
        work = read(("t.txt", f"[{printed}]".encode()), ("e.m", equations.encode()))
        assert work.table is not None and work.table.cells == 7 * 25
        assert work.equations is not None and [line.tree is not None for line in work.equations] == [True]
