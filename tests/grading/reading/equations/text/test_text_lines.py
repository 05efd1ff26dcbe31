"""Which lines of a text are one equation, which line is several, and what a comment says of a name."""

from __future__ import annotations

import time

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for
from coursework.grading.reading.equations.text.text_lines import text_lines
from tests.grading.scenes import expected


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        # a sign at the end, an open parenthesis, a sign at the beginning
        ("w3 = r1*w1 +\nr2*w2", ["w3 = r1*w1 + r2*w2"]), ("w3 = r1*(w1 +\n2)", ["w3 = r1*(w1 + 2)"]),
        ("w3 = sin(phi1\n)*r1", ["w3 = sin(phi1 )*r1"]),
        ("w3 = r1*w1\n+ r2*w2", ["w3 = r1*w1 + r2*w2"]), ("w3 = r1*w1\nr2*w2", ["w3 = r1*w1", "r2*w2"]),
        ("w3 =\nw4 = r1", ["w3 =", "w4 = r1"]), ("w3 =\nr1*w1", ["w3 = r1*w1"]), ("w3 = 0\n+ r2*w2", ["w3 = 0", "+ r2*w2"]),
        ("w3 = r1*w1/(r2\n- r3*cos(phi3))", ["w3 = r1*w1/(r2 - r3*cos(phi3))"]),
        ("w3 = r1*w1\n+ (r2)*w2", ["w3 = r1*w1 + (r2)*w2"]), ("w3 = r1*w1\n+ w2/(r3\n*r2)", ["w3 = r1*w1 + w2/(r3 *r2)"]),
        # another side of the same equation is indented, another equation is not
        ("w3 = r1*w1\n   = r2*w2", ["w3 = r1*w1 = r2*w2"]), ("w3 = r1*w1 = 0\n   = r2*w2", ["w3 = r1*w1 = 0", "= r2*w2"]),
        ("r1*w1*sin(phi1)\n+ r2*w2 = 0", ["r1*w1*sin(phi1) + r2*w2 = 0"]), ("the sum\n+ r2*w2 = 0", ["the sum", "+ r2*w2 = 0"]),
        ("the sum\n  + r2*w2 = 0", ["the sum", "+ r2*w2 = 0"]),
    ],
)  # fmt: skip
def test_lines_that_are_one_equation(text: str, lines: list[str]) -> None:
    assert [" ".join(line.split()) for _, line in text_lines(text, names_for(expected()))] == lines


FIRST, SECOND = "w3 = 2*w1", "w4 = 3*w2"


@pytest.mark.parametrize(
    ("line", "parted"),
    [
        (f"{FIRST} // {SECOND}", f"{FIRST}; {SECOND}"), (f"{FIRST} // as seen", FIRST),
        (f"{FIRST} / {SECOND}", f"{FIRST}; {SECOND}"),
        ("w3 = r1*w1 / r2", "w3 = r1*w1 / r2"), ("w3 = r1*w1 / r2 = w4", "w3 = r1*w1 / r2 = w4"),
        ("w3 = 0 / w4 = 2*w1", "w3 = 0; w4 = 2*w1"),
        ("k = 2 / r1 = 3", "k = 2 / r1 = 3"),
    ],
)  # fmt: skip
def test_a_line_of_two_equations(line: str, parted: str) -> None:
    found = "; ".join(line for _, line in text_lines(line, names_for(expected())))
    assert "; ".join(" ".join(part.split()) for part in found.split(";")) == parted


@pytest.mark.parametrize(
    ("line", "bare"),
    [
        ("~~w3 = w1~~ w3 = 2*w1", "w3 = 2*w1"), ("w3~~=~~2*w1~~-~~w2", "w3~~=~~2*w1~~-~~w2"),
        ("w3 ~~ = ~~ 2*w1", "w3 ~~ = ~~ 2*w1"),
        ("w3 = 2*w1 ?? see (3)", "w3 = 2*w1"), ("w3 = 2*w1 ?? + w2", "w3 = 2*w1 ?? + w2"),
        ("w3 = 2*w1 ← by (3)", "w3 = 2*w1"), ("w3 = 2*w1 ← - w2", "w3 = 2*w1 ← - w2"),
    ],
)  # fmt: skip
def test_no_term_of_an_equation_is_struck_or_asked_away(line: str, bare: str) -> None:
    assert [one for _, one in text_lines(line, names_for(expected()))] == [bare]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("k = 2*r1  # big_r = r2", ["big_r = r2", "k = 2*r1"]), ("k = 2*r1  # so r = r2 + 1", ["k = 2*r1"]),
        ("# A = r1, B = r2", ["A = r1", "B = r2"]),
        ("def calc_w3(t):\n    return r1*sin(phi1)", ["w3 = r1*sin(phi1)"]),
        ("def w3_w4(t):\n    return r1*sin(phi1)", ["w3_w4 = r1*sin(phi1)"]),
    ],
)  # fmt: skip
def test_what_comments_and_functions_say(line: str, said: list[str]) -> None:
    assert [one for _, one in text_lines(line, names_for(expected()))] == said


def test_a_sum_of_many_lines_is_not_read_again_with_each_of_its_terms() -> None:
    """The time grows with the number of lines, not with its square, which made 64 kB take half a minute."""

    def spent(count: int) -> float:
        names, text = names_for(expected()), "".join(f"+ r1*w1*sin(phi1)/{count + row}\n" for row in range(count))
        began = time.process_time()
        assert len([*text_lines(text, names)]) == 1
        return time.process_time() - began

    spent(5)
    assert min(spent(64) for _ in range(2)) < 8 * min(spent(16) for _ in range(2))  # 4; reading all anew takes 14
