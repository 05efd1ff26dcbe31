"""Formulas meant to keep the tool busy: refused with one sentence that says where, or done with bounded work."""

import random
import time

import numpy as np
import pytest

import coursework
from coursework import InputError
from coursework.variant.reading.reader import parse_variant

HEAD = '[drive]\nU = "1"\n[unknowns]\n{unknowns}[coordinates]\nf = {{ start = "0.3", rate = "w0" }}\n'
TIME = '[time]\nstep = "0.01 s"\nend = "0.1 s"\n'
SIZE = 40


def lines(coefficients):
    """Return 40 velocity equations, each with a list of (formula, unknown)."""
    text = HEAD.format(unknowns="".join(f'w{place} = "1"\n' for place in range(1, SIZE))) + TIME
    for row in coefficients:
        text += f'[[constraint]]\nequation = "{" + ".join(f"{formula}*w{place}" for formula, place in row)} = U"\n'
    return parse_variant(text, "forty.toml")


@pytest.mark.parametrize("each", [6, SIZE])
def test_forty_unknowns(each):
    dice = random.Random(each)
    rows = [[(f"cos({k + 1}*f + {j})", j) for j in dice.sample(range(SIZE), each)] + [("90", k)] for k in range(SIZE)]
    begin = time.process_time()
    run = coursework.solve(lines(rows), quantities=["table"])
    assert time.process_time() - begin < 20
    names, table = run.columns()
    matrix = np.zeros((SIZE, SIZE))
    for k, row in enumerate(rows):
        for formula, j in row:
            matrix[k, j] += 90 if formula == "90" else np.cos((k + 1) * 0.3 + j)
    wanted = np.linalg.solve(matrix, np.ones(SIZE))
    assert [table[0][names.index(f"w{place}")] for place in range(SIZE)] == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize(
    ("coefficient", "code"),
    [
        ("2^100000", "V124"),
        ("f^100000", "V124"),
        ("9" * 30, "V130"),
        ("((9^8)^8)^8", "V133"),
        ("sin(" * 400 + "f" + ")" * 400, "V"),
    ],
)
def test_one_sentence_with_the_place(coefficient, code):
    text = HEAD.format(unknowns="") + TIME + f'[[constraint]]\nequation = "{coefficient}*w0 = U"\n'
    with pytest.raises(InputError, match=rf"^{code}\d* .*constraint 1"):
        _ = coursework.solve(parse_variant(text, "x.toml"), quantities=["table"]).motion


def test_powers_of_powers_of_sums():
    text = HEAD.format(unknowns="") + TIME + '[[constraint]]\nequation = "(((1 + f + f^2)^8)^8 + 1)*w0 = U"\n'
    begin = time.process_time()
    run = coursework.solve(parse_variant(text, "x.toml"), quantities=["table"])
    assert len(run.equations) == 1
    assert time.process_time() - begin < 20
