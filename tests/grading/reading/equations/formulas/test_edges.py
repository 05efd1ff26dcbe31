"""Words, marks and letters at the edges of a right equation: read, or asked about, and never marked down; a slip is found."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.edges import without_edges
from tests.grading.reading.equations.test_of_a_shaper import BLOCK, RODS, marked

LAST = "v = -L*w3*sin(phi3) - b*w4*sin(phi4)"
WORDS = [
    "et  {}", "d'où {}", "damit gilt  {}", "auf s: {}", "&  {}", ":. {}", "… {}", "{} usw.", "{}  [rotation]", "{}  [0,5 Punkte]",
    "{}   in m/s", "{} q e d", "{} see fig. 3", "{} ★★", "{} = ...", "- speed: **{}**", "_{}_", "<{}>", "II | x | {}", "({})",
    "both wheels have one and the same speed in that point, so {}",
]  # fmt: skip
LETTERS = ["s {}", "b {}", "{} (s)", "{} t", "{} - (B)"]


@pytest.mark.parametrize("form", WORDS)
def test_a_word_or_mark_at_an_edge_is_left_out(form: str) -> None:
    found = marked(BLOCK + RODS.replace(LAST, form.format(LAST)))
    assert (found.independent, found.different) == (4, 0)


@pytest.mark.parametrize("form", LETTERS)
def test_a_letter_that_may_be_a_factor_is_asked_about(form: str) -> None:
    found = marked(BLOCK + RODS.replace(LAST, form.format(LAST)))
    assert (found.independent, found.different) == (3, 0)
    assert found.unread is not None and found.unread.hint is not None and found.unread.hint.fault is not None
    assert found.unread.hint.fault.code in {"G069", "G071"}


@pytest.mark.parametrize("form", ["minus {}", "twice {}", "{} halved", "-{}", "{} *2", "2 {}"])
def test_what_changes_an_equation_is_no_edge_of_it(form: str) -> None:
    assert marked(BLOCK + RODS.replace(LAST, form.format(LAST))).independent == 3


@pytest.mark.parametrize(
    "form",
    [
        "{} x 2", "{} × 2", "{} over 2", "{} (-1)", "{} (·2)", "{} {{2}}", "{} ½", "{} ²", "{} k", "{} cosphi", "{} ⁻¹",
        "{} moins", "{} (—)", "{} (x) r", "{} rcosφ", "√ {}", "－ {}", "∂ {}", "k {} where k = 2", "½ {}", "wrong: **{}**",
        "{} other sign", "{} π", "{} cos φ1", "即r {}",
    ],
)  # fmt: skip
def test_what_reckons_at_an_edge_is_no_remark(form: str) -> None:
    assert ("u = w*r", False) not in [*without_edges(form.format("u = w*r"), {"u", "w", "r", "φ"}.__contains__)]


@pytest.mark.parametrize(
    "form", ["{} see fig. 3", "{} using a Maschine", "{} (№ 3)", "since {}", "{} for t = 0", "{} → ∎", "{} ✓", "basin {}"]
)
def test_a_word_with_a_function_or_a_greek_name_in_it_is_a_word(form: str) -> None:
    assert ("u = w*r", False) in [*without_edges(form.format("u = w*r"), {"u", "w", "r"}.__contains__)]


@pytest.mark.parametrize("form", [*WORDS[:3], WORDS[7], WORDS[10]])
def test_a_slip_beside_a_word_at_an_edge_never_passes(form: str) -> None:
    found = marked(BLOCK + RODS.replace(LAST, form.format(LAST.replace("sin(phi4)", "cos(phi4)"))))
    assert found.independent == 3 and (found.unread or found.wrong)


def test_a_chain_of_which_one_side_is_lost_is_asked_about() -> None:
    (question,) = marked("next u/sin(phi3 - phi1) = s*w3/cos(phi1 - phi3) = r*w1\n" + RODS).questions
    assert question.hint is not None and question.hint.fault is not None and question.hint.fault.code == "G073"


def test_the_side_of_a_chain_that_is_no_formula_is_told_with_its_place() -> None:
    """Not that a line has two signs of equality: chains are read."""
    (question,) = marked(f"u = r*w1*sin(phi3 - phi1) = VB sin(beta+??)\n{RODS}").questions
    assert question.hint is not None and question.hint.fault is not None
    assert (question.hint.fault.code, question.hint.fault.column) == ("G074", 29)
    assert "VB * sin(beta + ??)" in str(question.hint.fault)


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("1- v = -L*w3*sin(phi3) - b*w4*sin φ4", "G071"),  # 1 - v is no velocity
        ("+ L*w3*sin(φ3) = b*w4*sin(φ4)", "G071"),  # goes on from a line that was not joined
        ("# v = -L*w3*sin(phi3) - b*w4*sin(phi4)", "G072"),
    ],
)
def test_what_may_have_been_misread_or_passed_over_is_asked_where_equations_are_missing(line: str, code: str) -> None:
    found = marked(f"{BLOCK}{RODS.partition(LAST)[0]}{line}\n")
    assert found.different == 0 and found.share < 1
    assert code in {mark.hint.fault.code for mark in found.questions if mark.hint and mark.hint.fault}
    whole = marked(f"{BLOCK}{RODS}{line}\n")
    assert whole.share == 1 and whole.unread is None


@pytest.mark.parametrize("text", ["w3 = s", "v = w3*b + 1"])
def test_a_line_in_the_names_of_the_task_is_wrong_as_it_stands(text: str) -> None:
    assert marked(f"{BLOCK}{text}\n").different == 1


SAID = {
    "a sine in Greece": "s·ω3 = ω1·r·συν(φ1 - φ3)\nu = ω1·r·ημ(φ3 - φ1)\n" + RODS,
    "rates without a blank before them": "sφ3' = rw1 cos(φ1 - φ3)\nu = r w1 sin(φ3 - φ1)\nbφ4' cosφ4 = -Lφ3' cosφ3\n"
    "v = -Lφ3' sinφ3 - bφ4' sinφ4",
    "an index after a comma": "v_A,x = -r*w1*sin(phi1)\nv_A,y = r*w1*cos(phi1)\ns*w3 = v_A,y*cos(phi3) - v_A,x*sin(phi3)\n"
    "u = v_A,x*cos(phi3) + v_A,y*sin(phi3)\n" + RODS,
    "another word for and": "s*w3 = r*w1*cos(phi1 - phi3) en u = r*w1*sin(phi3 - phi1)\n" + RODS,
    "what stays, in a list": f"φ1' = w1 = const, φ3' = w3\n{BLOCK}{RODS}",
    "vectors in round brackets": "v_A = w1 r (-sin phi1, cos phi1)\nv_A = u (cos phi3, sin phi3) + w3 s (-sin phi3, cos phi3)\n"
    "v_B = w3 L (-sin phi3, cos phi3)\n(v, 0) = v_B + w4 b (-sin phi4, cos phi4)",
    "a name said in parentheses": f"{BLOCK}w4 = -L*w3*cos(phi3)/(b*c) (with c = cos(phi4))\n{LAST}",
    "a definition with its value": f"D = 2*L - L = 0.5 m\n{BLOCK}{RODS.replace('L', 'D')}",
    "emphasis before a table": f"*Block:*\n\n| 1 | r cos(phi1 - phi3) w1 = s w3 |\n| 2 | u = r*w1*sin(phi3 - phi1) |\n\n{RODS}",
    "the same in parentheses": f"D = 2*s - s (= s)\nr cos(phi1 - phi3) w1 = D w3\nu = r*w1*sin(phi3 - phi1)\n{RODS}",
}


@pytest.mark.parametrize("name", SAID)
def test_seldom_signs_around_names_are_read(name: str) -> None:
    found = marked(SAID[name])
    assert (found.independent, found.different) == (4, 0)


def test_points_before_another_equation_end_a_line() -> None:
    assert marked(f"{BLOCK}{RODS.replace(chr(10), ' = ...' + chr(10), 1)}").independent == 4


@pytest.mark.parametrize("line", [LAST + " (x)", "F3 = v + L*w3*sin(phi3) + b*w4*sin(phi4) = 0 vale"])
def test_a_number_and_brackets_at_both_edges_and_a_name_of_ones_own_hide_no_equation(line: str) -> None:
    found = marked(f"{BLOCK}{RODS.partition(LAST)[0]}(4) {line}\nF3 = v + L*w3*sin(phi3)\n")
    assert found.different == 0 and (found.share == 1 or found.unread is not None)


def test_a_number_takes_no_part_of_a_name_that_was_cut_off() -> None:
    assert marked("即r cos(phi1 - phi3) 2*w1 = s w3\n" + RODS).independent == 2
