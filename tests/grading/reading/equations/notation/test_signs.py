"""Signs, indices and axes as people write them become those of a keyboard."""

import pytest

from coursework.grading.reading.equations.notation.signs import plain_signs, relates_two_sides


@pytest.mark.parametrize(("text", "plain"), [
    ("w1 plus w2 minus w3", "w1 + w2 - w3"), ("w1 плюс w2 мінус w3", "w1 + w2 - w3"), ("a surplus b", "a surplus b"),
    # the axis of a projection is an index, an exponent is none, and z means nothing in the plane
    ("V_M^y", "V_M_y"), ("V^y", "V_y"), ("V^{(x)}_M", "V_Mx"), ("V_M^z", "V_M"), ("ω^{z}_3", "ω_3"), ("r^2", "r^2"),
    ("V_x^M", "V_Mx"),
    ("(V_M)_x", "V_Mx"), ("|AB|", "AB"), ("|ab|", "|ab|"),
    ("φ_{3}", "φ_3"), ("φ_(3)", "φ_3"), ("r_{a+b}", "r_{a+b}"), ("r_{ }", "r_{ }"), ("V_{M_{y_{1}}}", "V_My1"), ("r_ 1", "r_1"),
    ('r_"ab"', "r_ab"), ("V_{M, y}", "V_My"),
    ("φ_3\u0307", "φ\u0307_3"), ("sin²φ", "sin^2 φ"), ("r¹⁰", "r^10 "), ("a.*b", "a*b"), ("a .^2", "a ^2"),
])  # fmt: skip
def test_what_is_typed_for_what_is_written(text: str, plain: str) -> None:
    assert plain_signs(text) == plain


@pytest.mark.parametrize(("text", "plain"), [
    ("a == b", "a = b"), ("a := b", "a = b"), ("a is equal to b", "a  =  b"), ("a*b = zero", "a*b = 0"),
    ("a*b = ноль", "a*b = 0"),
    ("a*b ~ 0", "a*b = 0"), ("w = a*b ~ 0", "w = a*b = 0"), ("a ~ b", ""), ("a <- b", "a= b"), ("a <-b", ""), ("a => b", ""),
    ("a <= b", "a <= b"),
])  # fmt: skip
def test_signs_and_words_of_equality(text: str, plain: str) -> None:
    """An empty text stands for one that relates no two sides."""
    assert relates_two_sides(text) is bool(plain)
    assert not plain or plain_signs(text) == plain
