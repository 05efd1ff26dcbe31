"""A six-bar linkage is solved one loop after the other, and programs call both systems by the same names."""

import re

import pytest

import coursework
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.expected import Expected

KEY = key_of(coursework.load("watt"))
JUDGE = Judge(KEY)
# Matrix, right side and unknowns of the two loops, written out by hand.
LOOPS = [
    (("r2*sin(phi2)", "-r3*sin(phi3)", "r2*cos(phi2)", "-r3*cos(phi3)"), ("-r1*w1*sin(phi1)", "-r1*w1*cos(phi1)"), ("w2", "w3")),
    (
        ("r6*sin(phi6)", "-r7*sin(phi7)", "r6*cos(phi6)", "-r7*cos(phi7)"),
        ("-r5*w3*sin(phi3 + gamma)", "-r5*w3*cos(phi3 + gamma)"),
        ("w6", "w7"),
    ),
]
FORMS = {
    "Cramer": "D = ({a})*({d}) - ({b})*({c})\nDa = ({e})*({d}) - ({b})*({f})\nDb = ({a})*({f}) - ({e})*({c})\n"
    "{x} = Da/D\n{y} = Db/D",
    "det": "Δ = det([[{a}, {b}], [{c}, {d}]])\nΔ1 = det([[{e}, {b}], [{f}, {d}]])\nΔ2 = det([[{a}, {e}], [{c}, {f}]])\n"
    "{x} = Δ1/Δ\n{y} = Δ2/Δ",
    "Pascal": "a11 := {a};\na12 := {b};\na21 := {c};\na22 := {d};\nb1 := {e};\nb2 := {f};\ndet := a11*a22 - a12*a21;\n"
    "{x} := (b1*a22 - b2*a12)/det;\n{y} := (a11*b2 - a21*b1)/det;",
    "at once": "a11, a12 = {a}, {b}\na21, a22 = {c}, {d}\nb1, b2 = {e}, {f}\ndet = a11*a22 - a12*a21\n"
    "{x} = (b1*a22 - b2*a12)/det\n{y} = (a11*b2 - a21*b1)/det",
    "MATLAB": "A = [ ...\n {a}, {b}; ...\n {c}, {d} ];\nb = [ {e}; {f} ];\nx = A\\b;\n{x} = x(1);\n{y} = x(2);",
    "NumPy": "A = np.array([\n    [{a}, {b}],\n    [{c}, {d}],\n])\nb = np.array([{e}, {f}])\n{x}, {y} = np.linalg.solve(A, b)",
    "SymPy": "M = Matrix([[{a}, {b}], [{c}, {d}]])\nv = Matrix([{e}, {f}])\n{x}, {y} = M.LUsolve(v)",
    "behind": "A*x = B, where\nA = [[{a}, {b}], [{c}, {d}]]\nB = [{e}, {f}]\nx = [{x}, {y}]\n",
    "inverse": "[{x}; {y}] = [{a}, {b}; {c}, {d}]^(-1) * [{e}; {f}]",
    "inverse in LaTeX": r"\[\begin{{bmatrix}}{x}\\{y}\end{{bmatrix}} = "
    r"\begin{{bmatrix}}{a} & {b} \\ {c} & {d}\end{{bmatrix}}^{{-1}}"
    r" \begin{{bmatrix}}{e}\\{f}\end{{bmatrix}}\]",
    "SMath": "mat({a};{b};{c};{d};2;2)*mat({x};{y};2;1)=mat({e};{f};2;1)",
}


def marked(text):
    return JUDGE.mark(read_lines(text, "equations.txt", Expected(KEY.grid, KEY.variant)).equations)


def written(form, second=LOOPS[1]):
    return "\n".join(
        form.format(**dict(zip("abcdefxy", (*of, *right, *sought), strict=True))) for of, right, sought in (LOOPS[0], second)
    )


@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)
def test_systems_solved_in_turn_under_the_same_names_are_right(form):
    found = marked(written(form))
    assert (found.share, found.wrong, found.questions) == (1, (), ())


@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)
def test_a_slip_in_the_second_system_costs_the_second_alone(form):
    matrix, right, sought = LOOPS[1]
    found = marked(written(form, ((matrix[0].replace("sin", "cos"), *matrix[1:]), right, sought)))
    assert 0.5 <= found.share <= 0.75
    assert all(not re.search("w2|w3 =", mark.line.text) for mark in found.wrong)


LINES = [f"{a}*{x} + ({b})*{y} = {e}" for of, right, (x, y) in LOOPS for a, b, e in ((*of[:2], right[0]), (*of[2:], right[1]))]


def test_two_speeds_of_one_point_are_no_definition_made_anew():
    text = "vx = -r1*w1*sin(phi1) - r2*w2*sin(phi2)\nuy = 2*vx\nvx = -r3*w3*sin(phi3)"
    assert marked(text).independent == 1


@pytest.mark.parametrize("sign", ["# ", "// ", "% "])
def test_equations_that_are_all_comments_count_as_far_as_they_are_right(sign):
    text = "\n".join(f"{sign}{line}" for line in ["the two loops", *LINES])
    assert marked(text).share == 1
    slip = text.replace("r6*sin", "r6*cos")
    assert (marked(slip).share, marked(slip).wrong) == (0.75, ())
    beside = marked(f"{LINES[0]}\n{sign}{LINES[1]}")  # what is no comment counts alone
    assert beside.independent == 1


def test_a_comment_of_several_lines_is_text():
    assert marked("/* the two loops\n" + "\n".join(f" * {line}" for line in LINES) + "\n */\nint n = 3;").share == 1


def test_formulas_of_a_sentence_are_read_without_its_words():
    tex = [
        re.sub(r"(phi|w|r)(\d)", r"\1_\2", line).replace("phi", r"\varphi").replace("gamma", r"\gamma").replace("*", " ")
        for line in LINES
    ]
    for opens, closes in ((r"\(", r"\)"), ("$", "$")):
        said = [f"{opens}{line}{closes}" for line in tex]
        text = f"So {said[0]} and {said[1]} hold, where {opens}r_1{closes} is the crank.\nThen {said[2]} and {said[3]} too."
        assert marked(text).share == 1


def test_a_sum_of_complex_numbers_times_i_is_their_sum():
    text = "i*(r1*w1*exp(i*phi1) + r2*w2*exp(i*phi2) - r3*w3*exp(i*phi3)) = 0"
    assert marked(text).independent == 2
    assert marked(text.replace("- r3", "+ r3")).independent == 0


def test_a_minus_sign_before_some_lines_is_no_mark_of_a_list():
    right = "− r1*w1*sin(phi1) − r2*w2*sin(phi2) + r3*w3*sin(phi3) = 0\nr1*w1*cos(phi1) + r2*w2*cos(phi2) − r3*w3*cos(phi3) = 0"
    assert marked(right).independent == 2
    wrong = marked(right.replace("− r2", "+ r2").replace("+ r3", "− r3"))
    assert (wrong.independent, len(wrong.wrong), wrong.questions) == (1, 1, ())
