"""What a line of an equation becomes before it is read strictly: products, arguments, powers, indices, decimal commas."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.formulas.repair import is_name, is_product, sides_of

NAMES = Spellings(
    frozenset({"a", "m", "l1", "l2", "phi1", "phi3", "w3", "t", "pi", "ab"}), {"omega3": "w3", "φ3": "phi3"}, {}, frozenset({"a"})
)
WITH_X = Spellings(frozenset({"a", "x"}), {}, {})


@pytest.mark.parametrize(("text", "sides"), [
    # what it equals, and what stands around it
    ("a = m", "a|m"), ("a", "a|0?"), ("a = m = l1", "a|m|l1"), ("a = m.", "a|m"), ("$a = m$", "a|m"), ("`a` = m ,;: ", "a|m"),
    ("E5: = a", "E5|a"), ("E5 := a", "E5|a"), ("a == m", "a|m"), ("y[2] = a", "y[2] | a"), ("sin[phi1] = a", "sin(phi1)|a"),
    ("[a + m]*{l1} = 0", "(a + m) * (l1)|0"), ("a \\, m = 0", "a,m|0"),
    # decimal commas, but not between the arguments of atan2
    ("0,5a = 1,25", "0.5 * a|1.25"), ("1,2,3 = 0", "1,2,3|0"), ("atan2(1,2) = 0", "atan2(1,2)|0"),
    # products without a sign
    ("2l1 = 0", "2 * l1|0"), ("a(m) = 0", "a * (m)|0"), ("(a)(m) = 0", "(a) * (m)|0"), ("a m = 0", "a * m|0"),
    ("am = 0", "a * m|0"),
    ("ab = 0", "ab|0"), ("a2 = 0", "a2|0"), ("al12 = 0", "al12|0"), ("al1 = 0", "a * l1|0"),
    ("l1sinphi1 = 0", "l1 * sin(phi1)|0"),
    ("abm = 0", "ab * m|0"), ("2sin(phi1) = 0", "2 * sin(phi1)|0"), ("a x m = 0", "a * m|0"), ("a х m = 0", "a * m|0"),
    ("a*m/l1 - -2 = +a", "a * m / l1 - -2|+a"), ("-a = (-m)", "-a|(-m)"), ("a^2 = a^(2)", "a^2|a^(2)"),
    # a colon divides on the right side only, where it is no mark behind a name
    ("a = m : l1", "a|m / l1"), ("m:l1 = a", "m:l1|a"),
    # arguments and powers of functions
    ("sin phi1 = 0", "sin(phi1)|0"), ("sin 2 phi1 = 0", "sin(2 * phi1)|0"), ("sin 2 = cos(phi1)", "sin(2)|cos(phi1)"),
    ("sin^2 phi1 = 0", "(sin(phi1))^2|0"), ("sin^2(phi1) = 0", "(sin(phi1))^2|0"),
    ("sin^2((a)+m)+l1 = 0", "(sin((a) + m))^2 + l1|0"),
    ("sin^2(cos^3(a)) = 0", "(sin((cos(a))^3))^2|0"), ("sin^a = 0", "sin^a|0"), ("SEN phi1 = 0", "sin(phi1)|0"),
    ("tg a = 0", "tg(a)|0"),
    ("sin phi1 cos phi3 = 0", "sin(phi1) * cos(phi3)|0"), ("sin = 0", "sin|0"), ("(a)sin phi1 = 0", "(a) * sin(phi1)|0"),
    # names in other spellings, indices that stand apart
    ("omega3 = φ3", "w3|phi3"), ("l 1 = 0", "l1|0"), ("l 9 = 0", "l * 9|0"), ("phi 3 + l 2 = 0", "phi3 + l2|0"),
    ("a 2 = 0", "a * 2|0"),
    ("ф1 = щ3", "phi1|w3"), ("zz = 0", "zz|0"),
])  # fmt: skip
def test_a_line_as_the_strict_reader_wants_it(text: str, sides: str) -> None:
    found = sides_of(text, NAMES)
    assert ("|".join(found.texts), found.is_whole) == (sides.removesuffix("?"), not sides.endswith("?"))


@pytest.mark.parametrize(("text", "closely"), [
    ("a/l1(m + 2) = 0", "a / (l1 * (m + 2))|0"), ("a/l1 m*t = 0", "a / (l1 * m) * t|0"), ("a/l1 + m = 0", "a / (l1) + m|0"),
    ("a/(l1 m) = 0", "a / ((l1 * m))|0"), ("(a/l1 m) = 0", "(a / (l1 * m))|0"),
    ("a/2sin phi1 - m = 0", "a / (2 * sin(phi1)) - m|0"),
    ("a/m/l1 t = 0", "a / (m) / (l1 * t)|0"), ("a/(m/l1 t) 2 = 0", "a / ((m / (l1 * t)) * 2)|0"),
])  # fmt: skip
def test_closely_a_product_without_a_sign_stays_below_its_stroke(text: str, closely: str) -> None:
    assert "|".join(sides_of(text, NAMES, closely=True).texts) == closely


def test_between_blanks_x_is_a_name_where_the_task_has_it() -> None:
    assert sides_of("a x a = 0", WITH_X).texts == ("a * x * a", "0")


@pytest.mark.parametrize(("length", "is_split"), [(60, True), (61, False)])
def test_a_word_of_more_than_sixty_letters_is_not_taken_apart(length: int, is_split: bool) -> None:
    (side, _) = sides_of("m" * length, NAMES).texts
    assert (side == " * ".join("m" * length)) is is_split


@pytest.mark.parametrize(("word", "is_one"), [
    ("a", True), ("sin", True), ("amm", True), ("zz", False), ("Am", False), ("Sin", True), ("L1", False), ("az", False),
    ("mama", True),
])  # fmt: skip
def test_a_word_is_a_name_or_is_glued_from_names(word: str, is_one: bool) -> None:
    assert is_name(word, NAMES) is is_one


@pytest.mark.parametrize(("word", "side"), [("aab", "aab"), ("abb", "abb"), ("aac", "a * a * c"), ("aabc", "aabc")])
def test_a_word_that_can_be_taken_apart_in_two_ways_is_left_whole(word: str, side: str) -> None:
    assert sides_of(word, Spellings(frozenset({"a", "b", "c", "ab"}), {}, {})).texts[0] == side


# A task with an angle b beside a length L and a rate wb; V is short for its only speed.
TURNING = Spellings(
    frozenset({"L", "w", "wb", "b", "p", "t", "phi", "alpha", "vr", "r", "speed", "nmxy", "nmxyz"}),
    {"v": "speed", "r": "r"}, {"phi": "w", "q": "w3"},
    angles=frozenset({"b", "phi", "alpha"}),
)  # fmt: skip


@pytest.mark.parametrize(("text", "side"), [
    # no angle is a factor; names as the task has them go before other spellings, and a word in capitals is a name of its own
    ("Lwb", "L * wb"), ("Lwp", "L * w * p"), ("vrcosphi", "vr * cos(phi)"), ("vp", "speed * p"), ("VR", "VR"),
    ("Vsinphi", "speed * sin(phi)"),
    # an angle that is added belongs to the argument, pt as well, and nothing else does
    ("sin pt", "sin(p * t)"), ("sin p w", "sin(p) * w"), ("sin phi t", "sin(phi) * t"), ("sin phi + p*t", "sin(phi + p * t)"),
    ("sin phi + alpha", "sin(phi + alpha)"), ("sin phi - 2alpha + w", "sin(phi - 2 * alpha) + w"),
    ("sin phi + alpha - b + w", "sin(phi + alpha - b) + w"), ("sin phi + alpha*w", "sin(phi) + alpha * w"),
    ("sin phi + alpha cos phi", "sin(phi) + alpha * cos(phi)"), ("sin phi + w", "sin(phi) + w"), ("sin^", "sin^"),
    # an index apart joins its name, unless what stands before it is a name already, or it is longer than an index
    ("sp eed", "sp * eed"), ("nm xy", "nmxy"), ("nm xyz", "nm * xyz"), ("r w", "r * w"), ("w b", "w * b"),
])  # fmt: skip
def test_words_and_arguments_of_a_task_with_angles(text: str, side: str) -> None:
    assert sides_of(text, TURNING).texts[0] == side


@pytest.mark.parametrize(("word", "is_one"), [
    ("r3w3", True), ("rw3", True), ("rphi", False), ("rw", False), ("rsinphi", True), ("w3", False), ("sin", False),
])  # fmt: skip
def test_a_product_has_a_function_or_a_speed_with_a_number(word: str, is_one: bool) -> None:
    names = Spellings(frozenset({"r", "r3", "w", "w3", "phi"}), {}, {"phi": "w", "phi3": "w3"})
    assert is_product(word, names) is is_one


def test_a_word_with_a_capital_is_a_chain_of_names_that_are_written_so() -> None:
    assert is_name("Am", Spellings(frozenset({"A", "m"}), {}, {})) and not is_name(
        "Am", Spellings(frozenset({"a", "m"}), {"a": "a"}, {})
    )
