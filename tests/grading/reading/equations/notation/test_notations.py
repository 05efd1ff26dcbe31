"""Right equations in the notations students use are read, whatever stands round them."""

from functools import cache

import pytest

import coursework
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.equations.notation.signs import plain_signs
from tests.grading.scenes import expected, variant_of

PLAIN = """VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0
2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0
-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0
r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0"""
LABELS = [
    "({n}) {e}", "{n}) {e}", "[{n}] {e}", "{n}. {e}", "({n}): {e}", "Eq. {n}: {e}", "№ {n} {e}", "{e}   ({n})", "({n}a) {e}",
    "Уравнение {n}: {e}", "formula ({n}) {e}", "V_Cy = {e}", "{n}: {e}", "eq({n}): {e}", "• {e}",
]  # fmt: skip
ALIGNED = r"""\begin{align}
V_{My} - 2 r_3 \omega_3 \cos\varphi_3 - r_3 \omega_3 \sin\varphi_3 &= 0 \label{eq:11} \\
2 r_3 \omega_3 \sin\varphi_3 - r_3 \omega_3 \cos\varphi_3
  + \frac{1}{2} r_3 \omega_4 &= 0 \tag{12} \\
-\tfrac12 r_3\,\omega_4 + r_3 \cdot \omega_3 \cos(\varphi_3) + r_2 \omega_2 \sin\left(\varphi_2\right)
  + r_1 \omega_1 \sin\varphi_1 &= 0 \\[4pt]
r_3 \omega_3 \sin \varphi_3 - r_2 \omega_2 \cos \varphi_2 - r_1 \omega_1 \cos \varphi_1 &= 0
\end{align}"""
DOTS = r"""$V_{My} - 2 r_3 \dot\varphi_3 \cos\varphi_3 - r_3 \dot{\varphi}_3 \sin\varphi_3 = 0$
$$2 r_3 \dot{\varphi_3} \sin\varphi_3 - r_3 \dot\varphi_3 \cos\varphi_3 + \dfrac{r_3}{2} \omega_4 = 0$$
\(\frac{-r_3\omega_4}2+r_3\frac{d\varphi_3}{dt}\cos\varphi_3+r_2\dot\varphi_2\sin\varphi_2+r_1{\dot\varphi_1}\sin\varphi_1=0\)
\[ r_3 \dot\varphi_3 \sin\varphi_3 - r_2 \dot\varphi_2 \cos\varphi_2 - r_1 \dot\varphi_1 \cos\varphi_1 = 0 \]"""


def other(*pairs):
    text = PLAIN
    for old, new in pairs:
        text = text.replace(old, new)
    return text


NOTATIONS = {
    "plain": PLAIN,
    "align": ALIGNED,
    "dots": DOTS,
    "half": other(("0.5*r3", "½ r3")),
    "derivatives": other(("w3", "dphi3/dt"), ("w2", "dφ2/dt"), ("w1", "d(phi1)/dt")),
    "primes": other(("w3", "phi3'"), ("w2", "phi2'"), ("w1", "phi1'")),
    "dotted letters": other(("w3", "φ\u03073"), ("w2", "φ\u03072"), ("w1", "φ\u03071")),
    "numpy": other(("sin(", "np.sin("), ("cos(", "np.cos(")),
    "math": other(("sin(", "math.sin("), ("cos(", "Math.cos(")),
    "end points": other(("r3", "BC"), ("r2", "l_AB"), ("r1", "AD")),
    "short": other(*((f"{name}(phi{k})", f"{name[0]}{k}") for name in ("sin", "cos") for k in (1, 2, 3))),
    "defined": "k = cos(phi3)\nn = sin(phi3)\nq := r3*w3\n" + other(("cos(phi3)", "k"), ("sin(phi3)", "n"), ("r3*w3", "q")),
    "excel": """=VMy/(r3*(2*COS(phi3)+SIN(phi3)))
w4: =2*w3*(COS(phi3)-2*SIN(phi3))
=-r3*w3*SIN(phi3)*(2*COS(phi2)+SIN(phi2))/(r1*SIN(phi1-phi2))
w2 = =r3*w3*SIN(phi3)*(2*COS(phi1)+SIN(phi1))/(r2*SIN(phi2-phi1))*-1""",
    "solved with a helper": """D = r1*r2*sin(phi1 - phi2)
w3 = VMy/(r3*(2*cos(phi3) + sin(phi3))), w4 = 2*w3*(cos(phi3) - 2*sin(phi3))
w1 = -r2*r3*w3*sin(phi3)*(2*cos(phi2) + sin(phi2))/D; w2 = r1*r3*w3*sin(phi3)*(2*cos(phi1) + sin(phi1))/D""",
    "two in a line": PLAIN.replace(" = 0\n", " = 0; ", 1),
}  # fmt: skip


@cache
def judge(name="31"):
    return Judge(key_of(variant_of(name)))


def marked(text, name="31"):
    return judge(name).mark(read_lines(text, "equations.txt", expected(name)).equations)


@pytest.mark.parametrize("notation", NOTATIONS)
def test_a_right_set_is_right_in_every_notation(notation):
    found = marked(NOTATIONS[notation])
    told = [(mark.verdict, mark.line.text, mark.hint and str(mark.hint.text)) for mark in found.marks]
    assert [verdict for verdict, *_ in told] == ["right"] * 4, told
    assert found.share == 1.0


@pytest.mark.parametrize("label", LABELS)
def test_a_label_is_no_term(label):
    text = "\n".join(label.format(n=11 + place, e=line) for place, line in enumerate(PLAIN.split("\n")))
    found = marked(text)
    assert [mark.verdict for mark in found.marks] == ["right"] * 4, [(m.line.text, m.line.repaired) for m in found.marks]


def test_a_number_in_parentheses_that_is_a_factor_stays_one():
    found = marked("(2)*r3*w3*cos(phi3) + r3*w3*sin(phi3) = VMy\n(2) r3*w3*cos(phi3) + r3*w3*sin(phi3) - VMy = 0")
    assert [mark.verdict for mark in found.marks] == ["right", "right"]


def test_a_wrong_line_stays_wrong_in_every_notation():
    for notation, old, new in (
        ("align", "+ \\frac{1}{2}", "- \\frac{1}{2}"), ("end points", "+ l_AB", "- l_AB"), ("half", "½ r3", "½ r2"),
        ("short", "*s2", "*c2"), ("defined", "k = cos", "k = sin"), ("derivatives", "2*r3*dphi3", "r3*dphi3"),
    ):  # fmt: skip
        text = NOTATIONS[notation]
        assert old in text, notation
        assert "wrong" in {mark.verdict for mark in marked(text.replace(old, new, 1)).marks}, notation


def test_a_formula_without_a_name_that_fits_no_velocity_is_a_question_and_not_wrong():
    found = marked("=VMy*r3*COS(phi3)\nw4 = 2*w3*(cos(phi3) - 2*sin(phi3))")
    assert [mark.verdict for mark in found.marks] == ["unreadable", "right"]
    told = str(found.marks[0].hint.text)
    assert "it may give one of w1, w2, w3 and w4" in told and told.endswith("or 0 = VMy*r3*COS(phi3).")


RESIDUALS = """=VMy-2*r3*w3*COS(phi3)-r3*w3*SIN(phi3)
=2*r3*w3*SIN(phi3)-r3*w3*COS(phi3)+0,5*r3*w4
=-0,5*r3*w4+r3*w3*COS(phi3)+r2*w2*SIN(phi2)+r1*w1*SIN(phi1)
=r3*w3*SIN(phi3)-r2*w2*COS(phi2)-r1*w1*COS(phi1)"""


def test_cells_that_can_give_no_velocity_are_residuals_whether_they_are_right_or_not():
    """A residual could be read only if it was right: a slip of sign sent the work to a person, without a mark."""
    assert [(mark.verdict, mark.line.repaired[:4]) for mark in marked(RESIDUALS).marks] == [("right", "0 = ")] * 4
    found = marked(RESIDUALS.replace("SIN(phi3)-r3", "SIN(phi3)+r3"))
    assert [mark.verdict for mark in found.marks] == ["right", "wrong", "right", "right"]
    assert (found.independent, found.different, found.questions) == (3, 1, ())
    slip = found.marks[1]
    assert slip.line.text[slip.hint.column - 1] == "+" and "1000" not in slip.hint.text


def test_a_cell_that_may_give_a_velocity_is_a_residual_if_others_of_the_work_are():
    """In a slider-crank the velocity of the slider has the dimension of a residual of points."""
    right = """=VMx + a*w3*SIN(phi3) + c*w3*COS(phi3)
=VMy - a*w3*COS(phi3) + c*w3*SIN(phi3) - u
=VMx + a*w3*SIN(phi3) + r2*w2*SIN(phi2) + r1*w1*SIN(phi1)
=VMy - a*w3*COS(phi3) - r2*w2*COS(phi2) - r1*w1*COS(phi1)"""
    assert [mark.verdict for mark in marked(right, "v102").marks] == ["right"] * 4
    slips = marked(right.replace(" + c*w3*COS", " - c*w3*COS"), "v102")
    assert [mark.verdict for mark in slips.marks] == ["wrong", "right", "right", "right"]
    alone = marked("=VMx + a*w3*SIN(phi3) - c*w3*COS(phi3)", "v102").marks[0]
    assert alone.verdict == "unreadable" and "it may give one of" in str(alone.hint.text)


def test_a_definition_nobody_uses_is_a_line_that_is_told():
    found = marked("w5 = 2*w3\n" + PLAIN)
    assert [mark.verdict for mark in found.marks] == ["unreadable", *["right"] * 4]


def test_definitions_that_grow_beyond_what_may_be_typed_are_refused():
    lines = ["a = r1 + r2"] + [f"{chr(98 + i)} = {chr(97 + i)} + {chr(97 + i)}" for i in range(12)] + ["w3 = m*VMy"]
    found = marked("\n".join(lines))
    assert {mark.verdict for mark in found.marks} == {"unreadable"}


@pytest.mark.parametrize("name", ["v102", "example-1", "v108"])
def test_lengths_by_their_end_points_in_other_mechanisms(name):
    variant = coursework.load(name)
    from coursework.grading.reading.equations.formulas.meanings import meaning_of

    if name == "example-1":
        assert [meaning_of(pair, expected(name), {}).name for pair in ("AB", "BC", "DC", "lCD")] == ["r1", "r2", "r3", "r3"]
    if name == "v102":
        assert meaning_of("BM", expected(name), {}).name == "a"
    assert meaning_of("XY", expected(name), {}) is None
    assert variant


@pytest.mark.parametrize(("text", "sign"), [
    ("(12) 2·r3·ω3·sin(φ3) − r3·ω3·cos(φ3) − 0,5·r3·ω4 = 0", "− 0,5"),
    ("2*r3*w3*sin(phi3) + r3*w3*cos(phi3) + 0.5*r3*w4 = 0", "+ r3*w3*cos"),
    ("[12] 2 r3 w3 sin φ3 + r3 w3 cos φ3 + ½ r3 w4 = 0", "+ r3 w3 cos"),
    ("12) -2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0", "-2*r3"),
])  # fmt: skip
def test_a_hint_points_at_the_sign_in_the_line_as_handed_in(text, sign):
    mark = marked(text).marks[0]
    assert (mark.verdict, mark.hint.kind) == ("wrong", "sign")
    assert mark.hint.column == text.index(sign) + 1


def test_a_line_nobody_can_read_is_a_question_while_equations_are_missing():
    three = PLAIN.rsplit("\n", 1)[0]
    unread = "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*zeta(phi1) = 0"
    assert marked(f"{three}\n{unread}").unread.line.line == 4
    assert marked(f"{PLAIN}\n{unread}").unread is None
    for prose in ("V1 = 4.5 m/s is given", "name = Ivanov", "h = 0.02"):
        assert marked(f"{three}\n{prose}").unread is None


@pytest.mark.parametrize(
    ("pasted", "typed"),
    [("−‐‑‒–—―﹣", "-"), ("≡≈≅≃≐≑≔≝", "="), ("∗•∙⋅·●∘×✕✖⨯⸱・", "*"), ("⁄∕÷", "/"), ("〖⟦❨", "("), ("〗⟧❩", ")"), ("﹢", "+")],
)
def test_every_sign_that_programs_paste_is_that_of_a_keyboard(pasted: str, typed: str) -> None:
    assert [plain_signs(f"w1{sign}w2") for sign in pasted] == [f"w1{typed}w2"] * len(pasted)


def test_a_letter_with_its_dot_is_a_letter_and_a_dot() -> None:
    assert plain_signs("\u1e8b_M = \u017c_2") == plain_signs("x\u0307_M = z\u0307_2") == "x\u0307_M = z\u0307_2"
