"""Desks where tables of one variant are handed in and marked: two individual variants each of 31 and v102, two own ones."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.rubric import Rubric
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.machines import PULLED_BARS, SLIDER_CRANK, Machine

NEAR = 2.0  # points of 60 between the same fault in two places
# One of each mechanism; `--long` asks all of them here, and a dozen of two mechanisms in test_twelve_variants.py.
ALL = 6
of_each = pytest.mark.parametrize("numbers", [(0, 2, 4, 5), pytest.param(range(ALL), marks=pytest.mark.long)], ids=len)


@cache
def variants():
    found = [coursework.draw("31", "31", "fair", f"student{number}") for number in range(2)]
    chance, template = np.random.default_rng(5), coursework.load("v102")
    for _ in range(2):
        given = {n: round(x * (1 + chance.uniform(-0.06, 0.06)), 3) for n, x in template.values.items() if n in ("r1", "r2", "a")}
        start = {c.name: round(c.start + chance.uniform(-0.05, 0.05), 2) for c in template.coordinates}
        found.append(template.with_data(given=given, start=start))
    found += [parse_variant(text, "own.toml", {}) for text in (SLIDER_CRANK, PULLED_BARS)]
    return [Desk(variant) for variant in found]


@cache
def with_a_steady_drive():
    """The crank of most tasks: at any other time the velocities are the same, so no rule of time differs from Euler's."""
    steady = SLIDER_CRANK.replace(b"w0 + eps*sin(3*t)", b"w0 + 0*eps")
    return Desk(parse_variant(steady, "own.toml", {}))


class Desk:
    """Where tables of one variant are handed in; `accepted` decimals are those of its class."""

    def __init__(self, variant, accepted=None):
        self.machine, self.variant, self.key = Machine(variant), variant, key_of(variant, accepted)
        self.marker = Marker(self.key, Rubric())
        self.expected = Expected(self.key.grid, variant)

    def marked(self, *args, **kwargs):
        """The points of a table, and its marks."""
        grade = self.handed(*args, **kwargs)
        return grade.part("table")[0], grade.table

    def handed(self, table, equations="right", times=None, with_time=True, digits=4, more=None):
        times = np.arange(len(table)) * self.machine.h if times is None else times
        lines = [";".join([*(["t"] if with_time else []), *self.key.names])]
        for t, row in zip(times, table, strict=True):
            lines.append(";".join([*([f"{t:.4f}"] if with_time else []), *(f"{value:.{digits}f}" for value in row)]))
        files = [submitted_file("table.csv", "\n".join(lines).encode())]
        right = {c.name: f"{spelled(c.left)} = {spelled(c.right)}" for c in self.variant.constraints}
        if equations is not None:
            texts = right | (equations if isinstance(equations, dict) else {})
            files.append(submitted_file("equations.txt", "\n".join(texts.values()).encode()))
        files += [submitted_file(name, text.encode()) for name, text in (more or {}).items()]
        return self.marker.grade(read_submission(Submission("a", None, tuple(files)), self.expected))

    def heads(self, *names):
        return [self.key.names.index(name) for name in names]


def codes(table):
    named = table.misconception
    return (named.code, *named.ties) if named else ()


def close(points, near=NEAR):
    assert max(points) - min(points) <= near, sorted(points)


def sign_faults(constraint):
    """Give the equation with the sign of one of its terms turned."""
    text = f"{spelled(constraint.left)} - ({spelled(constraint.right)})"
    for place, sign in enumerate(text):
        if sign in "+-" and text[place - 1] == " " and place > 1:
            yield text[:place] + ("-" if sign == "+" else "+") + text[place + 1 :]
