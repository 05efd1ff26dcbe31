"""Where one line has several equations: as a reader parts it, without cutting an equation in two."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.systems.parts import parts_of, rows_of


@pytest.mark.parametrize(("line", "parts"), [
    ("w1 = 2; w2 = 3", "w1 = 2|w2 = 3"), ("w1 = 0,5*w2, w3 = 2", "w1 = 0,5*w2|w3 = 2"), ("w1 = 2 and w2 = 3", "w1 = 2|w2 = 3"),
    ("w1 = atan2(1, w2), w3 = 2", "w1 = atan2(1, w2)|w3 = 2"), (r"w1 = 2\,w3 = 0", r"w1 = 2\,w3 = 0"),
    ("a = 1 (and b)", "a = 1 (and b)"),
    ("r1*w1 = 0 r2*w2 = 0", "r1*w1 = 0|r2*w2 = 0"), ("a = 0 / b = 0", "a = 0|b = 0"), ("a = 0 (2)", "a = 0 (2)"),
    ("a = b,", "a = b,"),
    ("a = b => c = d", "a = b|c = d"), ("a = b\tc = d", "a = b|c = d"), ("a = b   c = d", "a = b|c = d"),
    ("a = b  c = d", "a = b  c = d"),
    ("(a = b) e (c*(d + e) = f)", "(a = b)|(c*(d + e) = f)"), ("v = a (b/2) sin (c) = 0", "v = a (b/2) sin (c) = 0"),
    ("v = (a) R (b + c) - d = 0", "v = (a) R (b + c) - d = 0"),
    ("a = b. Then c = d", "a = b|Then c = d"), ("V_Cy = V_Dx = 0", "V_Cy = 0|V_Dx = 0"), ("V_Cy = V_Dx = 1", "V_Cy = V_Dx = 1"),
    # what relates no two sides stays with its neighbour
    ("a = b, c", "a = b, c"), ("c, a = b", "c, a = b"), ("c, d, a = b, e, f = g", "c, d, a = b, e|f = g"),
    # prose around formulas
    ("so $a = b$ and $c = d$ where $c$ is known", "a = b|c = d"), ("so $a$ is $b$ and $c$", "so $a$ is $b$ and $c$"),
    # lists, and calls that solve them for unknowns
    ("{a = b, c = d}", "a = b|c = d"), ("((a = b, c = d))", "a = b|c = d"), ("eqs = [a = b; c = d]; x = y", "a = b|c = d|x = y"),
    ("solve([w1 + sin(x) = 2, w2*cos(y) - 3], [w1, w2])", "w1 + sin(x) = 2|w2*cos(y) - 3 = 0"),
    ("[a - b, c - d]", "[a - b, c - d]"),
    # matrices, by rows
    ("[a, b; c, d]*[x; y] = [e; f]", "(a)*(x) + (b)*(y) = e|(c)*(x) + (d)*(y) = f"),
    ("[x; y] = [a, b; c, d]^(-1)*[e; f]", "(a)*(x) + (b)*(y) = e|(c)*(x) + (d)*(y) = f"),
    ("[1 -2; 3 4]·[x, y]^T = [5; 6]", "(1)*(x) + (-2)*(y) = 5|(3)*(x) + (4)*(y) = 6"),
    ("[[1, 2], [3, 4]]*[x, y] = [5, 6]", "(1)*(x) + (2)*(y) = 5|(3)*(x) + (4)*(y) = 6"),
    ("[1, 2; 3, 4]*[x; y] = [5; 6; 7]", "[1, 2; 3, 4]*[x; y] = [5; 6; 7]"),
    ("[1, 2; 3, 4]*[x; y] = [5]", "[1, 2; 3, 4]*[x; y] = [5]"),
    ("[1, 2; 3, 4]*[x; y; z] = [5; 6]", "[1, 2; 3, 4]*[x; y; z] = [5; 6]"),
])  # fmt: skip
def test_the_equations_of_a_line(line: str, parts: str) -> None:
    assert "|".join(parts_of(line)) == parts


@pytest.mark.parametrize(("content", "rows"), [
    ("a, b; c, d", "a b|c d"), ("[a, b], [c, d]", "a b|c d"), ("[[a, b], [c, d]]", "a b|c d"), ("[[[a, b], [c, d]]]", "a b|c d"),
    ("a, b\nc, d", "a b|c d"), ("a, b, ...\n c; d, e,f", "a b c|d e f"), ("a, b;\n", "a b"), ("[a, b], [c, d],\n", "a b|c d"),
])  # fmt: skip
def test_the_rows_of_a_matrix(content: str, rows: str) -> None:
    assert "|".join(map(" ".join, rows_of(content))) == rows
