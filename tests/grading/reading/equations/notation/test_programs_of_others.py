"""Right sets in what more programs write: macros, letters of Mathematica, doubles of Fortran, numbers that count the lines."""

from __future__ import annotations

import re
import tracemalloc

import pytest

from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.formulas.plain_text import plain
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.equations.notation.latex_names import with_own_commands
from tests.grading.reading.equations.notation.latex_work import each
from tests.grading.reading.equations.notation.notations import PLAIN, _calls, _greek, _lines, _named, _tex
from tests.grading.reading.equations.notation.test_notations import marked
from tests.grading.scenes import expected


def _zero(form):
    """Each line as a program that seeks roots has it: what is to vanish, under a name of its own."""
    return each(
        lambda k, line: form.format(k=k, e=re.sub(r"^(.*) = (.*)$", lambda m: m[1] if m[2] == "0" else f"{m[1]} - {m[2]}", line))
    )


def _listed(text):
    return text.replace("\n", ",\n  ")


MACROS = r"""\documentclass{article}
\newcommand{\om}[1]{\omega_{#1}}
\newcommand\ph[1]{\varphi_{#1}}
\def\v#1#2{V_{#1#2}}
\begin{document}
\begin{align}
%s
\end{align}
\end{document}"""
FORMS = {
    "macros": lambda t: MACROS
    % " \\\\\n".join(
        re.sub(r"\\(omega|varphi)_\{(\d)\}", lambda m: f"\\{'om' if m[1] == 'omega' else 'ph'}{{{m[2]}}}", line)
        for line in re.sub(r"V_\{M(.)\}", r"\\v{M}\1", _tex(t)).split("\n")
    ),
    "short letters": lambda t: "\\def\\o{\\omega}\n" + _tex(t).replace("\\omega", "\\o"),
    "letters of Mathematica": lambda t: each(lambda k, line: f"eq{k} = {line};")(
        _calls(re.sub(r"\bw(\d)", r"\\[Omega]\1", t), lambda m: f"{m[1].title()}[{m[2]}]")
        .replace("phi", "\\[CurlyPhi]").replace("=", "==").replace("*", " ")
    ),
    "Solve": lambda t: "sol = Solve[{" + ", ".join(t.replace("=", "==").split("\n")) + "}, {w1, w2}]",
    "equals of Mathcad": lambda t: "Given\n" + _named(t, _greek).replace("=", "⩵") + "\nFind(w1, w2)",
    "functions of Mathcad": lambda t: _zero("f{k}(w) := {e}")(t),
    "Fortran": lambda t: _zero("      F({k}) = {e}")(
        re.sub(r"(?<!\w)2\*", "2.D0*", t).replace("sin", "DSIN").replace("cos", "DCOS").replace("0.5*", "0.5D0*")
    ),
    "C++": lambda t: _zero("double eq{k} = {e};  // = 0")(
        re.sub(r"\b(r|w|phi)(\d)", r"\1[\2]", t).replace("sin", "std::sin").replace("cos", "std::cos")
    ),
    "R": lambda t: _zero("f[{k}] <- {e}")(t),
    "StarMath": lambda t: _calls(
        re.sub(r"\b(w|phi)(\d)", lambda m: f"%{'omega' if m[1] == 'w' else 'phi'}_{m[2]}", t), r"\1 left ( \2 right )"
    ).replace("*", " cdot "),
    "Typst": lambda t: each(lambda k, line: f"$ {line} $")(
        re.sub(r"VM(.)", r"V_(M \1)", re.sub(r"\b(w|phi|r)(\d)", r"\1_\2", t)).replace("w_", "omega_")
        .replace("phi_", "phi.alt_").replace("*", " dot ")
    ),
    "points of France": lambda t: _lines("(E{k}) : {e} ;")(t.replace("*", ".")),
    "no sign behind a shortened word": lambda t: _lines("d.h. {e}")(t.replace("*", " ")),
    "fields": lambda t: re.sub(r"\b(r\d)\b", r"par.\1", t), "rows": lambda t: re.sub(r"\b(w|phi)(\d)", r"\1\2_i", t),
    "Maxima": _lines("(%i{k})\teq{k}: {e}$"), "Modelica": lambda t: re.sub(r"\bw([23])", r"der(phi\1)", t),
    "values of a dictionary": _lines('    "{k}": "{e}",'),
    "an instrument of TI": lambda t: f"solve({' and '.join(t.splitlines())},{{w1,w2}})",
    "a list over lines": lambda t: f"eqs = {{{_listed(t.replace('=', '=='))}}};\nSolve[eqs, {{w1, w2}}]",
    "a list to vanish": lambda t: f"from sympy import *\nsol = solve([{_listed(_zero('{e}')(t))}], [w1, w2])",
    "radians": lambda t: _calls(t, r"\1(rad(\2))"),
    "SymPy printed": lambda t: re.sub(r"\bw([23])", r"Derivative(phi\1(t), t)", t),
    "lambdas": lambda t: "eqs = [\n" + ",\n".join(f"    lambda x: {line}" for line in _zero("{e}")(t).splitlines()) + "]",
    "keys": lambda t: re.sub(r"\b(r\d)\b", r"d['\1']", t),
    "leaders": _lines("{e}..........({k})"), "boxed": _lines("\\boxed{{{e}}}"),
    "names gathered": lambda t: f"def F(x):\n{_zero('    f{k} = {e}')(t)}\n    return [f1, f2, f3, f4]",
    "below a title": lambda t: f"Velocities w1 and w2\n====================\n{t}",
    "a list of Maple": lambda t: _lines("> eq[{k}] := {e};")(re.sub(r"\b(r|w|phi)(\d)", r"\1[\2]", t)),
    **{form: _lines(form) for form in (
        "1.{k} {e}", "3.1.{k} {e}", "{k} {e}", "L{k} {e}", "Q{k}. {e}", "(Ox) {e}", "{e} ✓", "т.е. {e}", "z.B. {e}", "B.{k} {e}",
        "{e}, i.e. for all t", "В проекции на ось Oy имеем {e}",
        "У проєкції на вісь Oy маємо {e}, оскільки шарнір нерухомий", "由于D点固定，有 {e} ，其中各角以弧度计",
        "The velocity of point C must vanish in y, so {e}",
    )},
}  # fmt: skip


def test_a_right_set_is_right_in_what_more_programs_write():
    refused = [
        (form, name)
        for form, made in FORMS.items()
        for name in ("31", "v102")
        if (found := marked(made(PLAIN[name]), name)).share != 1.0 or found.wrong
    ]
    assert refused == []


MATRIX = """A = [2*cos(phi3) + sin(phi3), 0, 0, 0;
     2*sin(phi3) - cos(phi3), 0.5, 0, 0;
     r3*cos(phi3), -0.5*r3, r2*sin(phi2), r1*sin(phi1);
     r3*sin(phi3), 0, -r2*cos(phi2), -r1*cos(phi1)]
k = [VMy/r3; 0; 0; 0]
"""
ROWS, RIGHT = MATRIX[5:].split("]\nk = [")
LISTS = ROWS.replace(";", "],").replace("     ", "     [")
ARRAY = f"import numpy as np\nA = np.array([[{LISTS}]])\nk = np.array([{RIGHT.replace(';', ',')[:-2]}])\n"


@pytest.mark.parametrize(
    "text",
    [
        f"{MATRIX}x = [w3; w4; w2; w1]\nA*x = k", f"{MATRIX}x = A\\k;\nw3 = x(1); w4 = x(2);\nw2 = x(3);\nw1 = x(4);",
        f"{MATRIX}[w3, w4, w2, w1] = linsolve(A, k);", f"{ARRAY}w3, w4, w2, w1 = np.linalg.solve(A, k)",
        f"{ARRAY}x = np.linalg.solve(A, k)\nw3 = x[0]\nw4 = x[1]\nw2 = x[2]\nw1 = x[3]",
    ],
)  # fmt: skip
def test_a_system_that_a_program_solves_is_its_equations(text):
    assert marked(text).share == 1.0
    slip = marked(text.replace("-r1*cos(phi1)", "r1*cos(phi1)"))
    assert ([mark.verdict for mark in slip.marks].count("wrong"), slip.independent) == (1, 3)


def test_a_root_is_one_in_spreadsheets_of_other_countries():
    for root in ("КОРЕНЬ", "WURZEL", "RACINE", "SQRT"):
        assert marked(f"VMy = {root}(5)*r3*w3*sin(phi3 + arctan(2))").independent == 1


def test_what_only_looks_like_a_list_keeps_its_factors():
    """Lengths before velocities count up, too; and a slip in such a line is told where it stands."""
    lines = "r1 w1 sin phi1 + r2 w2 sin phi2 = 0.5 r3 w4 - r3 w3 cos phi3\nr2 w2 cos phi2 - r1 w1 cos phi1 = r3 w3 sin phi3"
    found = marked(lines)
    assert [mark.verdict for mark in found.marks] == ["right", "wrong"]
    assert found.marks[1].hint.kind == "sign"


def test_a_letter_of_another_size_is_ones_own_where_the_text_says_what_it_is():
    """S2 is sin(phi2) where the task has a length s2, and DSIN is a function where it has a length d."""
    plain = "S2 = sin(phi3), C2 = cos(phi3)\n-r1*w1*sin(phi1) - u2*C2 + s2*w3*S2 = 0\nr1*w1*cos(phi1) - u2*S2 - s2*w3*C2 = 0"
    assert marked(plain, "whitworth").independent == 2
    assert marked("F(3) = -R3*W3*DSIN(PHI3) - R4*W4*DSIN(PHI4) - U5", "whitworth").independent == 1


def test_a_value_with_its_unit_is_one_where_a_letter_of_the_unit_is_a_name():
    """In 1/s stands the length s of the task."""
    found = read_lines("u*cos(phi3) - s*w3*sin(phi3) = VMx\nw2 = 2.0308 1/s", "report.md", expected("v107"))
    assert [one.may_be_datum for one in found.equations] == [False, True]


def test_a_product_that_is_checked_at_some_row_is_no_equation():
    found = read_lines("VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0\ncheck: w1*r1 = 1.08\nw4 - 2*w3 = 1.5 м/с", "x", expected())
    assert [one.may_be_datum for one in found.equations] == [False, True, False]


def test_a_slip_in_an_equation_with_a_name_of_its_own_is_told_at_its_sign():
    """The name is used again, solve([eqn1, eqn2]), and means what stands behind it."""
    first = "eqn1 = VMx + a*w3*sin(phi3) - c*w3*cos(phi3) == 0;"
    found = marked(f"{first}\neqn2 = VMy - a*w3*cos(phi3) + c*w3*sin(phi3) == u;\nS = solve([eqn1, eqn2])", "v102")
    assert [mark.verdict for mark in found.marks][:2] == ["wrong", "right"]
    assert found.marks[0].hint.column == first.index("- c") + 1


@pytest.mark.parametrize("form", ["F({k}) = {e};", "f[{k}] := {e};", "const f{k} = {e};", "f[{k}] <- {e}", "double eq{k} = {e};"])
def test_a_slip_in_what_is_to_vanish_is_one_where_the_lines_beside_it_are_right(form):
    """Alone such a line may be anything; F(1) of a program is no phi1."""
    for name, wrong, right in (
        ("31", "- r1*w1*cos(phi1)", "+ r1*w1*cos(phi1)"),
        ("v102", "+ c*w3*cos(phi3)", "- c*w3*cos(phi3)"),
    ):
        found = marked(_zero(form)(PLAIN[name].replace(wrong, right)), name)
        assert sorted(mark.verdict for mark in found.marks) == ["right", "right", "right", "wrong"]
        assert [(mark.hint.kind, (mark.line.source or mark.line.text)[mark.hint.column - 1]) for mark in found.wrong] == [
            ("sign", right[0])
        ]


def test_what_a_text_defines_without_end_is_left_as_it_stands():
    """A name of names would be megabytes; between a command and what it needs no blanks are tried against each other."""
    bomb = r"\def\a{{{" + "w1 = 2*r1 " * 1000 + "}}}" + r"\a " * 10_000
    tracemalloc.start()
    assert with_own_commands(bomb) == r"\a " * 10_000
    assert tracemalloc.get_traced_memory()[1] < 100 * len(bomb)  # all of it would be a hundred million letters
    tracemalloc.stop()
    for text in (r"\newcommand%s", r"\newcommand{\a%s", r"\def\a%s", "A =%s x = A\\b", "F1%sx = w1", "w1 = 1%sm%s"):
        for blank in ("\n", " "):
            found = read_lines(text.replace("%s", blank * 20_000), "x", expected())
            assert len(found.equations) <= text.count("=")


@pytest.mark.parametrize(("text", "variant"), [
    ("S = 0.4 m\nu*cos(phi3) - S*w3*sin(phi3) = VMx", "v107"),  # where s begins, in its other letter
    ("S0 = 0.4\nS = S0\nu*cos(phi3) - S*w3*sin(phi3) = VMx", "v107"),
    ("PHI2 = 3.37 + W2*0.02\nr3*w3*sin(phi3) - r2*w2*cos(PHI2) - r1*w1*cos(phi1) = 0", "31"),
    ("Phi2 = pi + 0.2\nr3*w3*sin(phi3) - r2*w2*cos(Phi2) - r1*w1*cos(phi1) = 0", "31"),
    ("rolling at point P 2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0", "31"),  # p is a datum
    ("качение в точке P 2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0", "31"),
])  # fmt: skip
def test_a_letter_that_only_looks_like_a_name_of_the_task_changes_nothing(text, variant):
    found = marked(text, variant)
    assert (found.marks[-1].verdict, found.independent) == ("right", 1)


def test_a_period_beside_the_equations_is_said_without_a_warning():
    found = marked("T = 2*pi/p\nomega = 2*pi/T\nw4 = 2*w3*(cos(phi3) - 2*sin(phi3))")
    assert (found.marks[-1].verdict, found.independent) == ("right", 1)


def test_nought_with_decimals_is_no_value_of_some_row():
    right, wrong = "w4 - 2*w3*cos(phi3) + 4*w3*sin(phi3) = 0", "r3*w3*sin(phi3) - r2*w2*cos(phi2) + r1*w1*cos(phi1) = 0.00"
    assert [mark.verdict for mark in marked(f"{right}\n{wrong}").marks] == ["right", "wrong"]


def test_half_of_a_length_d1_is_no_double_of_fortran():
    assert plain("0.5d1*w1 + 2.D0*sin(phi1)", Spellings(frozenset({"d1", "w1", "phi1"}), {}, {})) == "0.5d1*w1 + 2.e0*sin(phi1)"


@pytest.mark.parametrize("form", [
    "double w3(double t, double *q) {{ return {f}; }}", "double w3(double t)\n{{\n  return {f};\n}}", "let w3: f64 = {f};",
    "def f_w3(t):\n    return {f}",
])  # fmt: skip
def test_what_a_function_returns_is_the_velocity_that_it_is_called_by(form):
    assert marked(form.format(f="VMy/(r3*(2*cos(phi3) + sin(phi3)))")).independent == 1


def test_what_a_velocity_of_a_point_is_twice_is_an_equation():
    """The velocity of D along two ways: the second one was passed over as a definition, and half of the equations with it."""
    first, last = PLAIN["31"].split("\n")[:2], "V_Bx = {}*r3*w3*cos(phi3) + 0.5*r3*w4\nV_By = -r3*w3*sin(phi3)"
    ways = "\n".join([*first, "V_Bx = r2*w2*sin(phi2) + r1*w1*sin(phi1)", "V_By = -r2*w2*cos(phi2) - r1*w1*cos(phi1)", last])
    assert marked(ways.format("-1")).share == 1.0
    slip = marked(ways.format("+1"))
    assert (slip.independent, len(slip.wrong)) == (3, 1)


def test_sines_by_their_index_and_the_rule_of_a_row_beside_a_datum_k():
    assert marked("VMy - 2*r3*w3*C3 - r3*w3*S3 = 0").independent == 1
    steps = "th1(k+1) = th1(k) + h*om1(k)\nrho1[i+1] = rho1[i] + h*u1[i]\n\\theta_{2,n+1} = \\theta_{2,n} + h\\omega_{2,n}"
    assert read_lines(steps.replace("rho1[i", "rho1[k"), "x", expected("cylinders")).equations == []


LOOP = "i*r1*w1*e^(i*phi1) + i*r2*w2*e^(i*phi2) - i*r3*w3*e^(i*phi3) - i*r4*w4*e^(i*phi4) = 0"


@pytest.mark.parametrize("power", ["e^(i*{})", "np.exp(1j*{})", "e^i{}", "\\mathrm{{e}}^{{\\mathrm{{i}} {}}}", "e^{{j {}}}"])
def test_a_loop_of_complex_numbers_is_its_two_projections(power):
    unit = "1j" if "1j" in power else "j" if "j" in power else "i"
    loop = re.sub(r"e\^\(i\*(\w+)\)", lambda found: power.format(found[1]), LOOP).replace(" i*", f" {unit}*")
    found = marked(f"w4 + k*w1 = 0\n{loop.replace('*', ' ') if 'j ' in power else loop}", "geared")
    assert (found.share, len(found.wrong)) == (1.0, 0)
    assert marked(f"w4 + k*w1 = 0\n{loop.replace(f'+ {unit}*r2', f'- {unit}*r2')}", "geared").independent == 1


def test_a_sum_of_complex_numbers_in_parentheses_is_a_question():
    found = marked("w4 + k*w1 = 0\n(i*r1*w1 + r2*w2)*e^(i*phi1) = i*r4*w4*e^(i*phi4)", "geared")
    assert found.unread is not None and not found.wrong
