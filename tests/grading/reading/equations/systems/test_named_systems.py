"""A system that a program solves by names is its two rows, however it is filled, solved, and its entries are named."""

from __future__ import annotations

import itertools

import pytest

from coursework.grading.reading.equations.systems.matrices import in_rows

ROWS = ["(a)*(w1) + (b)*(w2) = e", "(c)*(w1) + (d)*(w2) = f"]
FILLED = {
    "numpy": "A = np.array([[a, b], [c, d]])\nk = np.array([e, f])",
    "numpy over lines": "A = np.array([\n    [a, b],\n    [c, d],\n])\nk = np.array([\n    e,\n    f,\n])",
    "matlab": "A = [a, b; c, d];\nk = [e; f];",
    "julia": "A = [a b; c d]\nk = [e, f]",
    "cells from 1": "A(1,1) = a; A(1,2) = b;\nA(2,1) = c; A(2,2) = d;\nk(1) = e; k(2) = f;",
    "cells from 0": "A[0][0] = a\nA[0][1] = b\nA[1][0] = c\nA[1][1] = d\nk[0] = e\nk[1] = f",
    "rows from 0": "A[0] = [a, b]\nA[1] = [c, d]\nk[0] = e\nk[1] = f",
    "rows from 1": "A(1,:) = [a, b];\nA(2,:) = [c, d];\nk(1) = e;\nk(2) = f;",
    "rows from 1 in brackets": "A[1,:] = [a, b]\nA[2,:] = [c, d]\nk[1] = e\nk[2] = f",
    "a row and cells": "A[0] = [a, b]\nA[1][0] = c\nA[1][1] = d\nk = [e; f]",
    "c": "double A[2][2] = {{a, b}, {c, d}};\ndouble k[2] = {e, f};",
    "maple": "A := Matrix([[a, b], [c, d]]);\nk := Vector([e, f]);",
    "right side first": "k = [e; f];\nA = [a, b; c, d];",
    "again": "A = [p, q; r, s];\nk = [g; h];\nA = [a, b; c, d];\nk = [e; f];",
}
SOLVED = (
    "np.linalg.solve(A, k)", "solve(A, k)", "linsolve(A, k);", "LinearAlgebra:-LinearSolve(A, k);", "lusolve(A, k)", "A\\k;",
    "A \\ k", "inv(A)*k;", "np.linalg.inv(A) @ k", "inv(A).k", "A.inv()*k", "A.inverse() @ k", "A.LUsolve(k)", "A.solve(k)",
    "A^-1*k", "A^(-1)*k", "A^{-1} · k",
)  # fmt: skip
NAMED = (
    "w1, w2 = {}", "[w1, w2] = {}", "x = {}\nw1 = x[0]\nw2 = x[1]", "x = {}\nw1 = x(1);\nw2 = x(2);",
    "x = {}\nw1 = x[1,1]; w2 = x[2,1];", "x = {}\nw2 = x[1]\nw1 = x[0]", "double x = {}\nw1 = x[0], w2 = x[1];",
)  # fmt: skip


def rows_of(text: str, *sought: str) -> list[str]:
    """Return what is left of a text, without signs between statements."""
    return [one for line in in_rows(text, sought).split(";") if (one := line.strip(" ;$\n"))]


@pytest.mark.parametrize("filled", FILLED)
def test_in_every_way_it_is_filled(filled: str) -> None:
    rest = ["A = [p, q", "r, s]", "k = [g", "h]"] if filled == "again" else []
    assert rows_of(f"{FILLED[filled]}\nw1, w2 = np.linalg.solve(A, k)") == rest + ROWS


@pytest.mark.parametrize("solved", SOLVED)
def test_in_every_way_it_is_solved(solved: str) -> None:
    told = {named: rows_of(f"{FILLED['matlab']}\n{named.format(solved)}") for named in NAMED}
    assert told == dict.fromkeys(NAMED, ROWS)
    assert rows_of(f"{FILLED['matlab']}\nx = {solved}", "w1", "w2") == ROWS


def test_of_maxima_and_mathematica() -> None:
    told = "A: matrix([a, b], [c, d])$\nk: matrix([e], [f])$\nx: invert(A) . k;\nw1: x[1,1];\nw2: x[2,1];"
    assert rows_of(told) == rows_of("A = {{a, b}, {c, d}}; k = {e, f};\n{w1, w2} = LinearSolve[A, k]") == ROWS


@pytest.mark.parametrize("product", ["A*x = k", "A @ x = k", "A·x = k;", "A x = k", "A.dot(x) == k", "A*x = k$"])
def test_as_a_product(product: str) -> None:
    assert rows_of(f"A = [a, b; c, d]; x = [w1; w2]; k = [e; f];\n{product}")[:2] == ROWS
    assert rows_of(f"{FILLED['numpy']}\n{product}", "w1", "w2")[:2] == ROWS


@pytest.mark.parametrize("call", ["solve(A, k, x);", "gauss(2, A, k, x);", "call lu_solve(A, k, x, n)", "GaussSolve(A, k, x)"])
def test_by_a_procedure_that_writes_into_its_last_vector(call: str) -> None:
    assert rows_of(f"{FILLED['c']}\n{call}\nw1 = x[0]; w2 = x[1];") == ROWS


def test_in_a_function_whose_call_has_the_names() -> None:
    inside = "\n".join("    " + line for line in FILLED["numpy"].splitlines())
    other = "def other(t):\n    return t\n"
    solve = f"def rates(t, y):\n{inside}\n    return np.linalg.solve(A, k)"
    for before, behind in itertools.product((other, ""), repeat=2):
        text = f"{before}{solve}\n{behind}w1, w2 = rates(0, y)\n"
        assert ROWS[0] in in_rows(text) and ROWS[1] in in_rows(text)
    assert ROWS[0] in in_rows(f"{solve}  # w1, w2\n") and in_rows(f"{solve}\n") == f"{solve}\n"


@pytest.mark.parametrize("text", [
    "A = [a, b; c, d];\nx = A\\k;\nw1 = x(1); w2 = x(2);",  # no right side
    "k = [e; f];\nx = A\\k;\nw1 = x(1); w2 = x(2);",  # no matrix
    "A = [a, b; c, d]; k = [e; f];\nx = A\\k;",  # no names
    "A = [a, b; c]; k = [e; f];\nw1, w2 = A\\k;", "A = [a, b; c, d]; k = [e; f; g];\nw1, w2 = A\\k;",
    "A = [a, b; c, d]; k = [e; f];\nw1, w2, w3 = A\\k;",
])  # fmt: skip
def test_what_is_no_system_stays(text: str) -> None:
    assert in_rows(text) == text
