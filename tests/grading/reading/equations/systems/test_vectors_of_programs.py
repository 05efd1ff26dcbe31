"""Right sides of programs: entries of vectors, y[0], dydt(1), and matrices filled cell by cell, in the names of the task."""

from __future__ import annotations

import re

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for
from coursework.grading.reading.equations.systems import vectors
from coursework.grading.reading.equations.systems.vectors import _of_whole_vectors
from tests.grading.reading.equations.notation.test_notations import marked
from tests.grading.scenes import expected

SOLVED = """w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))
w4 = 2*w3*(cos(phi3) - 2*sin(phi3))
w1 = (r3*w3*sin(phi3 - phi2) - (-0.5*r3*w4 + 2*r3*w3*cos(phi3))*0 + K)/(r1*sin(phi2 - phi1))
w2 = (r3*w3*sin(phi3) - r1*w1*cos(phi1))/(r2*cos(phi2))"""
# From lines 16 and 18 of the task, w2 left out of both.
SOLVED = SOLVED.replace("r3*w3*sin(phi3 - phi2) - (-0.5*r3*w4 + 2*r3*w3*cos(phi3))*0 + K", "L")
L = "r3*w3*sin(phi3)*sin(phi2) + (r3*w3*cos(phi3) - 0.5*r3*w4)*cos(phi2)"
SOLVED = SOLVED.replace("L", f"({L})")


def _state(form, first, names=("phi1", "phi2", "phi3"), text=SOLVED):
    return re.sub(r"phi\d", lambda found: form.format(names.index(found[0]) + first), text)


def _rates(text, form, first):
    return re.sub(r"\bw([123])", lambda found: form.format(int(found[1]) - 1 + first), text)


NUMPY = re.sub(r"(sin|cos)\(", r"np.\1(", SOLVED)
TURNED = ("phi3", "phi2", "phi1")
PROGRAMS = {
    "the order of the task": "import numpy as np\ndef f(t, y):\n" + _state("y[{}]", 0, text=NUMPY) + "\n    return dydt",
    "what is returned": "def f(t, y):\n" + _state("y[{}]", 0, TURNED) + "\n    return np.array([w3, w2, w1])",
    "a remark": "% z = [phi3, phi2, phi1]\n" + _state("z({})", 1, TURNED),
    "the time in front": "# z = [t, phi1, phi2, phi3]\n" + _state("z[{}]", 1, text=NUMPY),
    "the start": "double q[3] = {2.87, 3.37, 1.63};\n" + _state("q[{}]", 0, TURNED),
    "taken one by one": "phi3 = y[0]; phi1 = y[2]\nphi2 = y[1]\n" + SOLVED,
    "rates too": "void rhs(double t, double x[], double dxdt[])\n" + _rates(_state("x[{}]", 0), "dxdt[{}]", 0),
    "from one": "function dy = f(t, y)\n" + _rates(_state("y({})", 1), "dy({})", 1) + "\nend",
    "right sides": "procedure F(t: real; y: vec; var f: vec);\n" + _rates(_state("y[{}]", 1), "f[{}]", 1).replace("=", ":="),
    "rows of a matrix": _state("Y[k, {}]", 0) + "\nY[k+1, 0] = Y[k, 0] + h*w1\nY[k+1, 1] = Y[k, 1] + h*w2",
    "a formula that is returned": SOLVED.replace("w2 = ", "return [w1, ") + ", w3]",
    "types of Python": SOLVED.replace(" =", ": float ="),
    "methods of Rust": "let " + re.sub(r"(sin|cos)(\([^()]*\))", r"\2.\1()", SOLVED).replace("\n", "\nlet "),
    "fields of an object": NUMPY.replace("r1", "self.r1").replace("VMy/(", "self.VMy/("),
}
CELLS = """A = np.zeros((4, 4)); b = np.zeros(4)
A[0, 2] = 2*r3*cos(phi3) + r3*sin(phi3)
A[1, 2] = 2*r3*sin(phi3) - r3*cos(phi3)
A[1, 3] = 0.5*r3
A[2, 0] = r1*sin(phi1)
A[2, 1] = r2*sin(phi2)
A[2, 2] = r3*cos(phi3)
A[2, 3] = -0.5*r3
A[3, 0] = -r1*cos(phi1)
A[3, 1] = -r2*cos(phi2)
A[3, 2] = r3*sin(phi3)
b[0] = VMy
x = np.linalg.solve(A, b)
"""
PROGRAMS |= {
    "cells": CELLS, "cells from one": re.sub(r"\[(\d), (\d)\]", lambda m: f"({int(m[1]) + 1},{int(m[2]) + 1})", CELLS)
    .replace("b[0]", "b(1)").replace("np.linalg.solve(A, b)", "A\\b"),
    "rows of lists": re.sub(r"\[(\d), (\d)\]", r"[\1][\2]", CELLS) + "w1, w2, w3, w4 = x",
}  # fmt: skip


@pytest.mark.parametrize("told", PROGRAMS)
def test_entries_of_vectors_are_names_in_the_order_that_a_program_tells(told):
    found = marked(PROGRAMS[told])
    lines = [(mark.verdict, mark.line.text, mark.line.repaired) for mark in found.marks]
    assert (found.share, found.wrong) == (1.0, ()), lines
    slip = marked(PROGRAMS[told].replace("0.5*", "0.7*"))
    assert slip.share < 1.0


def test_what_vanishes_and_numbers_of_lines_are_no_rates():
    """F(1) = … is to be nought, Eq(2) a number: neither is the second velocity of the task."""
    lines = ["VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3)", "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + r3*w4/2"]
    for form in ("F({k}) = {e}", "Eq({k}): {e} = 0", "F[{k}] = {e}"):
        assert marked("\n".join(form.format(k=k, e=e) for k, e in enumerate(lines, 1))).independent == 2, form


def test_what_a_program_does_round_equations_is_none_and_a_decimal_comma_takes_nothing_apart():
    """An unread line beside a wrong equation is a question to a person: what adds, unpacks, starts and calls is none."""
    done = [
        "y0 = np.array([0.7, -6.05])", "y = y + h*rhs(t, y)", "t += h", "phi1, phi2 = phi1 + h*w1, phi2 + h*w2",
        "const auto [phi1, phi2] = q;", "dydt = [w1; x(1); x(2)];", "y0 <- c(phi1 = 0.2, phi2 = 2.2)", "t[k] = k*h",
        "sol = solve_ivp(f, (0, 0.5), y0, max_step=0.01)", "double x[2] = {0.7, 6.05}, dxdt[2];",
    ]  # fmt: skip
    assert [line for line in done if marked(line).marks] == []
    for line in ("0,5r3 w4 = r3 w3 (cos phi3 - 2 sin phi3)", "0,5*r3*w4 = r3*w3*cos(phi3) - 2*r3*w3*sin(phi3)"):
        assert marked(line).independent == 1, line


# The system of v102 for (u, w1, w2, w3), in this order, which is not the task's.
CELLS = [
    ["0", "0", "0", "a*sin(phi3) + c*cos(phi3)"], ["-1", "0", "0", "c*sin(phi3) - a*cos(phi3)"],
    ["0", "r1*sin(phi1)", "r2*sin(phi2)", "a*sin(phi3)"], ["0", "-r1*cos(phi1)", "-r2*cos(phi2)", "-a*cos(phi3)"],
]  # fmt: skip
SIDES, FOUND = ("-VMx", "-VMy", "-VMx", "-VMy"), ("u", "w1", "w2", "w3")


def by_cells(cell, side, end, solver, taken):
    filled = [cell.format(i=i, j=j, x=x) for i, row in enumerate(CELLS, 1) for j, x in enumerate(row, 1)]
    filled += [side.format(i=i, x=x) for i, x in enumerate(SIDES, 1)]
    return end.join([*filled, solver, *(taken.format(n=name, k=k) for k, name in enumerate(FOUND, 1))]) + end


def rows(opens, between, closes):
    return opens + between.join(", ".join(row) for row in CELLS) + closes


SYSTEMS = {
    "Pascal": by_cells("A[{i},{j}] := {x}", "B[{i}] := {x}", ";\n", "Gauss(A, B, X)", "{n} := X[{k}]"),
    "Fortran": "do i = 1, 25\n" + by_cells("A({i},{j}) = {x}", "b({i}) = {x}", "\n", "call gauss(A, b, x)", "{n} = x({k})"),
    "rows of MATLAB": f"A = [{rows('', ';', '')}];\nB = [{'; '.join(SIDES)}];\nX = inv(A)*B;\n".replace(")", "(i))")
    .replace("inv(A(i))", "inv(A)") + "".join(f"{name}(i) = X({k});\n" for k, name in enumerate(FOUND, 1)),
    "JavaScript": f"const A = {rows('[[', '], [', ']]')};\nconst b = [{', '.join(SIDES)}];\nconst x = math.lusolve(A, b);\n"
    + "".join(f"const {name} = x[{k}];\n" for k, name in enumerate(FOUND)),
    "C++": f"double k = w0;\ndouble A[4][4] = {rows('{{', '}, {', '}}')};\ndouble b[4] = {{{', '.join(SIDES)}}};\n"
    + "solve(A, b, x);\n" + "".join(f"double {name} = x[{k}];\n" for k, name in enumerate(FOUND)),
}  # fmt: skip


@pytest.mark.parametrize("program", SYSTEMS)
def test_a_system_is_read_in_the_order_in_which_the_program_takes_its_solution(program):
    """In Pascal, in C, and with an index of the row, the order was the task's, and four right equations were wrong."""
    found = marked(SYSTEMS[program], "v102")
    assert (found.share, len(found.wrong)) == (1.0, 0), [(m.verdict, m.line.text) for m in found.marks]
    slip = marked(SYSTEMS[program].replace("-r2*cos(phi2", "r2*cos(phi2"), "v102")
    assert (slip.independent, len(slip.wrong)) == (3, 1)


def test_where_no_line_could_be_read_each_is_a_question():
    assert marked("A = {1, 2; sin}\nq = [a, b]", "v102").unread is not None


@pytest.mark.parametrize(("said", "told"), [
    ("s, c = np.sin(q), np.cos(q)", "sin(q[0])*cos(q[1])"), ("c, s = cos(p), sin(q);", "sin(q[0])*cos(p[1])"),
    ("s, c = np.sin(q)", "sin(q[0])*c[1]"), ("s = np.sin(q), np.cos(q)", "sin(q[0])*c[1]"), ("s, c = np.tan(q)", "s[0]*c[1]"),
])  # fmt: skip
def test_sines_of_a_whole_vector_are_taken_entry_by_entry(said: str, told: str) -> None:
    assert _of_whole_vectors(f"{said}\nw1 = s[0]*c[1]") == f"{said}\nw1 = {told}"


def test_so_many_vectors_have_their_order_looked_for_that_a_long_text_takes_no_minute(monkeypatch: pytest.MonkeyPatch) -> None:
    """For each the whole text is searched: 1500 in 64 kB took 23 s."""
    looked: list[str] = []
    monkeypatch.setattr(vectors, "_taken", lambda text, vector, spellings: looked.append(vector) or {})
    text = "".join(f"w = v{number}[0] + v{number}[1]\n" for number in range(100, 141))
    names = names_for(expected())
    vectors.with_entries_named(text, names.expected.variant, names.spellings)
    assert looked == [f"v{number}" for number in range(100, 140)]
