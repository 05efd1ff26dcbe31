"""What stands around an equation in its line: a label, words before it, a remark, a reason or a unit behind it."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.labels import _is_aside, bare_equations, without_labels, without_words

NAMES = {"w1", "w3", "r1", "x", "C", "v", "length", "s", "в"}.__contains__


@pytest.mark.parametrize(
    ("line", "bare"),
    [
        ("(16) w1 = 2", "w1 = 2"), ("w1 = 2 (16)", "w1 = 2"), ("(16) w1 = 2 (3)", "w1 = 2"), ("w1 + 2 (16)", "w1 + 2 (16)"),
        ("(16)", "(16)"),
        ("w1 = (16)", "w1 = (16)"), ("2*w1 = 0", "2*w1 = 0"),
    ],
)  # fmt: skip
def test_a_label_is_taken_off_where_an_equation_is_left(line: str, bare: str) -> None:
    assert without_labels(line) == bare


@pytest.mark.parametrize(
    ("line", "bare"),
    [
        # words, the number of a link, a remark in parentheses
        ("so w3 = 2", "w3 = 2"), ("for link 3 w3 = 2", "w3 = 2"), ("for links 3: w3 = 2", "w3 = 2"), ("so (7) w3 = 2", "w3 = 2"),
        ("so (as seen) w3 = 2", "w3 = 2"), ("It moves. Link velocity w3 = 2", "w3 = 2"), ("number 3 w3 = 2", "3 w3 = 2"),
        # axes and points among words; alone they are names
        ("along x w3 = 2", "w3 = 2"), ("x w3 = 2", "x w3 = 2"), ("at point C we get w3 = 2", "w3 = 2"), ("C w3 = 2", "C w3 = 2"),
        ("at C 2*w3 = 4", "2*w3 = 4"), ("at C w3 = 4", "C w3 = 4"), ("at D w3 = 4", "w3 = 4"), ("D w3 = 4", "D w3 = 4"),
        ("at C y w3 = 2", "C y w3 = 2"), ("so (x) w3 = 2", "w3 = 2"), ("y w3 = 2", "w3 = 2"),
        # a name of the task is prose only before prose, and if it is long or a preposition
        ("length of it w3 = 2", "w3 = 2"), ("length w3 = 2", "length w3 = 2"), ("w1 of it w3 = 2", "w1 of it w3 = 2"),
        ("в итоге w3 = 2", "w3 = 2"), ("v итоге w3 = 2", "v итоге w3 = 2"),
        # capitals: a name of two or three letters, a word of more
        ("so BC w3 = 2", "BC w3 = 2"), ("so ABC w3 = 2", "ABC w3 = 2"), ("so HENCE w3 = 2", "w3 = 2"),
        # what a sign binds is a term, and so is a function
        ("so * w3 = 2", "so * w3 = 2"), ("k - w3 = 2", "k - w3 = 2"), ("so get - w3 = 2", "- w3 = 2"),
        ("kcos w3 = 2", "kcos w3 = 2"),
        ("lambda w3 = 2", "lambda w3 = 2"), ("k = 2", "k = 2"), ("so. .5*w3 = 2", ".5*w3 = 2"), ("so, : w3 = 2", "w3 = 2"),
        ("alone", "alone"),
    ],
)  # fmt: skip
def test_words_before_an_equation_are_taken_off(line: str, bare: str) -> None:
    assert without_words(line, NAMES) == bare


@pytest.mark.parametrize(
    ("line", "bare"),
    [
        ("(1) link 3: w3 = 2", "w3 = 2"), ("so ⇒ w3 = 2", "w3 = 2"), ("as seen) w3 = 2", "w3 = 2"), ("因此, w3 = 2", "w3 = 2"),
        ("3\tw3 = 2", "w3 = 2"), ("3  w3 = 2", "3  w3 = 2"),
        # what follows "= 0" says why, unless it goes on as an equation
        ("w3 = 0, since C rests", "w3 = 0"), ("w3 = 0 since r1 = 2", "w3 = 0 since r1 = 2"),
        ("w3 = 0.5, since C rests", "w3 = 0.5"),
        # remarks, reasons, units
        ("w3 = w1 (by geometry)", "w3 = w1"), ("w3 = w1 (r1)", "w3 = w1 (r1)"), ("w3 (by geometry)", "w3 (by geometry)"),
        ("w3 : w1 = x : r1", "w3 : w1 = x : r1"), ("P : w1 = x : r1", "w1 = x : r1"),
        # which change nothing: half of it, less a term, and a factor in brackets do
        ("w3 = r1*w1的值", "w3 = r1*w1"), ("w3 = r1*w1 的一半", "w3 = r1*w1 的一半"), ("w3 = w1, as seen", "w3 = w1"),
        ("w3 = w1, minus r1", "w3 = w1, minus r1"), ("w3 = w1 and - r1", "w3 = w1 and - r1"), ("w3 = w1 ⇒ seen", "w3 = w1"),
        ("w3 = w1 ⇒ - r1", "w3 = w1 ⇒ - r1"), ("w3 = 0 (+ r1)", "w3 = 0 (+ r1)"), ("w3 = (w1) olur.", "w3 = (w1)"),
        ("w3 = (w1) halved.", "w3 = (w1) halved."), ("w3 = w1 ... from here", "w3 = w1"),
        ("w3 = w1 ... length", "w3 = w1 ... length"),
        ("w3 = w1 [eq. of x]", "w3 = w1"), ("w3 = w1 [sinus r1 - 2]", "w3 = w1 [sinus r1 - 2]"),
        ("w3 = w1 - C keeps its height", "w3 = w1"), ("w3 = w1 - keeps it", "w3 = w1"),
        ("w3 = w1 - r1 length", "w3 = w1 - r1 length"),
        ("w3 = w1 - C height", "w3 = w1 - C height"), ("w3 = w1 - it is so", "w3 = w1 - it is so"),
        ("w3 = w1 - height C", "w3 = w1"),
        ("w3 = 0 (r1)", "w3 = 0"), ("w3 = w1, length s", "w3 = w1, length s"),
        # why a minus stands there, if one does; part of a turn, an axis, a length; a word of which half or minus is a part
        ("w3 = -w1, minus because C falls", "w3 = -w1"), ("w3 = w1, minus because C falls", "w3 = w1, minus because C falls"),
        ("w3 = -w1 (负号表示方向相反)", "w3 = -w1"), ("w3 = w1 (负号表示方向相反)", "w3 = w1 (负号表示方向相反)"),
        ("w3 = -w1 (знак минус, так как вниз)", "w3 = -w1"), ("w3 = -w1 (минус r1)", "w3 = -w1 (минус r1)"),
        ("w3 = w1 (for half a turn)", "w3 = w1"), ("w3 = w1 (half)", "w3 = w1 (half)"), ("w3 = w1 (BM is half of BC)", "w3 = w1"),
        ("w3 = w1 (projection on the negative y axis)", "w3 = w1"), ("w3 = w1 (the negative)", "w3 = w1 (the negative)"),
        ("w3 = w1 (半径)", "w3 = w1"), ("w3 = w1 (opposite sign)", "w3 = w1 (opposite sign)"),
        ("w3 = w1 (at all times)", "w3 = w1"), ("w3 = w1 (times two)", "w3 = w1 (times two)"),
        ("w3 = w1 (加速度)", "w3 = w1"), ("w3 = w1 (加半)", "w3 = w1 (加半)"),
        ("w3 = w1 (durch den Punkt)", "w3 = w1"), ("w3 = w1 (durch zwei)", "w3 = w1 (durch zwei)"),
        ("w3 = w1 (r1 height)", "w3 = w1 (r1 height)"), ("w3 = w1 (r1 has this height)", "w3 = w1"),
        ("w3 = w1 (r1 has this height - r1)", "w3 = w1 (r1 has this height - r1)"),
        ("w3 = w1 (r1 has r1 height)", "w3 = w1 (r1 has r1 height)"),
        ("w3 = w1, because it is so", "w3 = w1"), ("w3 = w1, w3", "w3 = w1, w3"), ("w3 = w1 for all t", "w3 = w1"),
        ("w3 = w1, 1/s", "w3 = w1"), ("w3 = w1 [rad/s]", "w3 = w1"), ("w3 = w1 [foo]", "w3 = w1 [foo]"),
        ("w3 = w1 s", "w3 = w1 s"),
        ("w3 = w1 holds", "w3 = w1"), ("w3 = w1 | *2", "w3 = w1"), ("w3 [rad/s]", "w3 [rad/s]"),
    ],
)  # fmt: skip
def test_what_stands_around_an_equation_is_taken_off_first(line: str, bare: str) -> None:
    assert next(bare_equations(line, NAMES)) == bare


def test_the_whole_line_is_tried_last_and_a_point_in_parentheses_may_be_one() -> None:
    assert [*bare_equations("so w3 = 2", NAMES)][-1] == "so w3 = 2"
    assert "w3 = v" in [*bare_equations("w3 = v (C)", NAMES)]
    assert [*bare_equations("3  w3 = 2", NAMES)][:3] == ["3  w3 = 2", "w3 = 2", "3  w3 = 2"]


@pytest.mark.parametrize(("text", "holds"), [
    ("x axis", False), ("the x axis", True), ("r1 is the crank", True), ("length the", False), ("r1 w3 and the others", False),
    ("r1*w3 the crank", False), ("", False),
])  # fmt: skip
def test_a_remark_in_parentheses_begins_with_a_word_or_has_several_behind_a_name(text: str, holds: bool) -> None:
    """One word alone behind a name may be a factor."""
    assert _is_aside(text, NAMES) is holds
