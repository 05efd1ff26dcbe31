"""Equations in the rows of a table, with numbers and reasons beside them, and systems that are solved where they are written."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.lines import read_lines
from tests.grading.reading.documents.test_right_work import graded
from tests.grading.reading.equations.notation.notations import PLAIN
from tests.grading.reading.equations.notation.test_notations import marked
from tests.grading.scenes import expected

REASONS = ("C keeps its height", "точка C движется горизонтально", "the wheel rolls", "D неподвижна")
EQUATIONS = [*zip((11, 12, 16, 18), PLAIN["31"].splitlines(), REASONS, strict=True)]


def rows(form: str, head: str = "", between: str = "\n") -> str:
    return head + between.join(form.format(n=number, e=equation, r=reason) for number, equation, reason in EQUATIONS)


ROWS = {
    "bars": rows("| {n} | {e} | {r} |", "| № | Уравнение | Основание |\n|---|---|---|\n"), "tight": rows("|{n}|{e}|"),
    "code": rows("| {n} | `{e}` |"), "tabs": rows("{n}\t{e}\t{r}", "No\tequation\twhy\n"), "semicolons": rows("{n};{e};{r}"),
    "commas": rows("{n},{e},{r}", "n,equation,because\n"), "in quotes": rows('"{n}","{e}","{r}"'),
    "dash": rows("{e} - {r}"), "two dashes": rows("{e} -- {r}"), "long dash": rows("{e} — {r}"),
}  # fmt: skip


@pytest.mark.parametrize("form", ROWS)
def test_a_set_in_the_rows_of_a_table_is_right_and_a_turned_sign_in_it_wrong(form):
    found = marked(ROWS[form], "31")
    assert found.share == 1.0 and not found.wrong and not found.unread
    slipped = ROWS[form].replace("-0.5*r3*w4", "0.5*r3*w4")
    assert slipped != ROWS[form] and len(marked(slipped, "31").wrong) == 1


def test_what_is_taken_away_is_no_reason_and_decimals_are_no_numbers_of_rows():
    assert marked("VMy - 2*r3*w3*cos(phi3) = 0 - r3*w3*sin(phi3)*(-1)", "31").share == 0.25
    decimals = "0,5*r3*w4 = r3*w3*cos(phi3) - 2*r3*w3*sin(phi3)\n1,0*VMy = 2*r3*w3*cos(phi3) + r3*w3*sin(phi3)"
    assert marked(decimals, "31").share == 0.5


FILES = {
    "equations.html": rows("<tr><td>{n}</td><td>{e}</td><td>{r}</td></tr>", "<html><body><table>", "") + "</table></body></html>",
    "equations.csv": ROWS["commas"], "equations.md": ROWS["bars"],
    "equations.tex": rows("({n}) & ${e}$ & {r} \\\\ \\hline", "\\begin{document}\n\\begin{tabular}{|c|l|l|}\\hline\n")
    .replace("*", " ").replace("VMy", "V_{My}").replace("r3", "r_3").replace("r2", "r_2").replace("r1", "r_1")
    .replace("cos(phi3)", r"\cos\varphi_3").replace("sin(phi3)", r"\sin\varphi_3") + "\n\\end{tabular}\n\\end{document}",
}  # fmt: skip


@pytest.mark.parametrize("name", FILES)
def test_the_tables_of_a_file_have_the_equations(name):
    grade = graded({name: FILES[name].encode()})
    assert grade.part("equations")[0] == 40.0, [mark.line.text for mark in grade.equations.marks] if grade.equations else None


BEFORE = "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))\nw4 = 2*w3*(cos(phi3) - 2*sin(phi3))\n"
MATRIX = "[[r1*sin(phi1), r2*sin(phi2)], [r1*cos(phi1), r2*cos(phi2)]]"
SIDES = "[0.5*r3*w4 - r3*w3*cos(phi3), r3*w3*sin(phi3)]"
BY_LINES = MATRIX[1:-1].replace("], [", "\n     ")  # a row of a matrix in MATLAB ends with its line
SOLVED = {
    "lists": f"w1, w2 = np.linalg.solve({MATRIX}, {SIDES})", "arrays": f"w1, w2 = solve(np.array({MATRIX}), np.array({SIDES}))",
    "over lines": f"w1, w2 = np.linalg.solve({MATRIX},\n    {SIDES})\nprint(w1)",
    "divided": f"[w1, w2] = {MATRIX[1:-1].replace('], [', '; ')}\\[{SIDES[1:-1].replace(', ', '; ')}];",
    "a matrix by its name": f"K = {BY_LINES};\nx = K\\[{SIDES[1:-1].replace(', ', '; ')}];\nw1 = x(1); w2 = x(2);",
    "inverted": f"K = {BY_LINES}\nw = inv(K)*[{SIDES[1:-1]}]';\nw1 = w(1); w2 = w(2);",
    "a name and a list": f"M = {MATRIX}\nw1, w2 = np.linalg.solve(M, {SIDES})",
    "functions": f"K(f) = {BY_LINES}\nb(t) = {SIDES}\nw = K(f) \\ b(t)\nw1 = w[1]; w2 = w[2]",
    "entries": f"x = {MATRIX[1:-1].replace('], [', '; ')}\\[{SIDES[1:-1].replace(', ', '; ')}];\nw1 = x(1); w2 = x(2);",
}  # fmt: skip


VELOCITIES = """VCy = VMy - BM*w3*cos(phi3) - r3*w3*sin(phi3); VCy = 0
VPx = BM*w3*sin(phi3) - r3*w3*cos(phi3) + CP*w4; VPx = 0
VDx = -CP*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1); VDx = 0
VDy = r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1); VDy = 0"""
LENGTHS = "BM = 2*r3, CP = r3/2"


@pytest.mark.parametrize("text", [
    f"{LENGTHS}\n{VELOCITIES}", f"{VELOCITIES}\n{LENGTHS}", f"{VELOCITIES}\n{LENGTHS}".replace("; ", "\n"),
    f"{VELOCITIES}\n{LENGTHS}\nVCy = VPx = VDx = VDy = 0".replace("; VCy = 0", "").replace("; VPx = 0", "")
    .replace("; VDx = 0", "").replace("; VDy = 0", ""),
])  # fmt: skip
def test_velocities_with_names_that_vanish_are_equations_wherever_their_lengths_are_said(text):
    assert marked(text, "31").share == 1.0
    assert marked(text.replace("- r3*w3*sin", "+ r3*w3*sin"), "31").independent == 3


@pytest.mark.parametrize("form", SOLVED)
def test_a_system_solved_where_it_is_written_is_its_equations(form):
    assert marked(BEFORE + SOLVED[form], "31").share == 1.0
    slipped = SOLVED[form].replace("0.5*r3*w4 -", "0.5*r3*w4 +")
    assert len(marked(BEFORE + slipped, "31").wrong) == 1


def test_a_call_that_has_an_equation_in_it_is_not_left_out_in_silence():
    text = BEFORE + "w1, w2 = crossed(r1*sin(phi1), r2*sin(phi2), r3*w4/2)"
    lines = read_lines(text, "f.txt", expected("31")).equations
    assert [line.line for line in lines if line.tree is None] == [3]


FROM_ZERO = """double VMy = V1 * sin(p * t + alpha);
w[2] = VMy / (r3 * (2 * cos(phi[2]) + sin(phi[2])));
w[3] = 2 * w[2] * (cos(phi[2]) - 2 * sin(phi[2]));
double det = r1 * r2 * sin(phi[0] - phi[1]);
w[0] = ((r3*w[3]/2 - r3*w[2]*cos(phi[2])) * r2*cos(phi[1]) - r3*w[2]*sin(phi[2]) * r2*sin(phi[1])) / det;
w[1] = (r3*w[2]*sin(phi[2]) * r1*sin(phi[0]) - (r3*w[3]/2 - r3*w[2]*cos(phi[2])) * r1*cos(phi[0])) / det;
"""


def test_a_vector_of_all_velocities_counts_from_zero_where_its_angles_do():
    assert marked(FROM_ZERO, "31").share == 1.0
    assert len(marked(FROM_ZERO.replace("- 2 * sin(phi[2])", "+ 2 * sin(phi[2])"), "31").wrong) == 1
