"""Tables made with a slip in an equation: which slip, and the velocities that follow; against a program that solves them anew."""

from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes import own_equations as module
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.own_equations import _independent, _solved, _task_lines, _used, equation_claims
from coursework.variant.formula.reader import parse
from tests.grading.marking import students
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import Desk, codes
from tests.grading.marking.table.test_cells import printed

LINES = {  # of variant 31, left - right
    "11": "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3)", "12": "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4",
    "16": "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1)",
    "18": "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1)",
}  # fmt: skip


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


def trees(**changed):
    return [parse({**LINES, **changed}[name]) for name in LINES]


def test_equations_give_the_velocities_of_the_task(key):
    q = key.table[:, :3]
    right = np.array([students.velocities(t, row) for t, row in zip(key.t, q, strict=True)])
    assert _solved(key, [line.tree for line in _task_lines(key)], key.t, q) == pytest.approx(right)
    assert _solved(key, [*trees()[:2], parse("2*(VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3))"), *trees()[2:]], key.t, q) == (
        pytest.approx(right)
    )  # what says the same again is passed over
    assert np.isnan(_solved(key, trees()[:3], key.t, q)).all()  # three for four


def test_a_row_where_equations_are_singular_or_have_no_value_has_no_velocities(key):
    q = key.table[:, :3].copy()
    q[1, 2] = -np.arctan(2.0) + np.pi  # 2 cos + sin = 0: the dead point
    q[2, 0] = np.nan
    q[3, :2] = 0.5, 0.5  # both rods in one line
    found = _solved(key, trees(), key.t, q)
    assert np.isnan(found[1:4]).all() and np.isfinite(found[0]).all() and np.isfinite(found[4:]).all()


def test_which_lines_are_independent():
    """As most of five of the points see them: the third line is the sum of the first two but for one point."""
    lines = np.tile(np.array([[1.0, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 3]]), (9, 1, 1))
    assert _independent(lines) == [0, 2, 4]
    lines[0, 1] = 5, 5, 0
    lines[4, 3] = 7, 7, 7
    assert _independent(lines) == [0, 2, 4]
    lines[[2, 4, 6], 1] = 0, 0, 8
    assert _independent(lines) == [0, 1, 2]
    assert _independent(lines[:0]) == []


@pytest.mark.parametrize(("name", "text"), [
    ("11", "VMy - 2*r3*w3*cos(phi3) + r3*w3*sin(phi3)"),
    ("16", "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r2*w1*sin(phi1)"),
    ("18", "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*sin(phi1)"), ("12", "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + r3*w4"),
])  # fmt: skip
def test_a_slip_in_one_equation_is_found_and_its_velocities_follow(key, name, text):
    """A sign, a name, a function, a factor: three lines hold as they stand, one with its slip."""
    machine = Machine(coursework.load("31"), lines={name: text})
    values = machine.table()
    under = TableUnderTest(key, printed(values, 6))
    used = _used(under, _task_lines(key))
    assert [one.slip for one in used] == [name if line == name else "" for line in LINES]
    assert min(one.holds for one in used) > 0.9
    (claim,) = equation_claims(under, None)
    assert (claim.code, claim.names) == (f"equation_{name}", (name,))
    off = np.abs(np.round(values, 6) - claim.expected)[:, 3:] / claim.tolerance[:, 3:]
    assert np.mean(off <= 1.0) > 0.97


def test_a_right_table_has_no_slip_and_lines_that_are_wrong_are_told_of(key):
    """The lines handed in with a wrong sign in 18: a table that solves them follows from them, one of the task does not."""
    wrong = "r3*w3*sin(phi3) + r2*w2*cos(phi2) - r1*w1*cos(phi1)"
    assert [*equation_claims(TableUnderTest(key, printed(students.table(), 6)), None)] == []

    def mark(name, text, verdict="right", hint="sign"):
        line = SimpleNamespace(line=name, difference=parse(text))
        return SimpleNamespace(line=line, verdict=verdict, hint=hint)

    def claims(values, *marks):
        handed = SimpleNamespace(marks=marks, wrong=[one for one in marks if one.verdict == "wrong"])
        found = equation_claims(TableUnderTest(key, printed(values, 6)), handed)
        return [(one.code, one.names) for one in found if one.code == "own_equations"]

    own = [*(mark(name, text) for name, text in LINES.items() if name != "18"), mark("18", wrong, "wrong")]
    made = Machine(coursework.load("31"), lines={"18": wrong}).table()
    assert claims(made, *own) == [("own_equations", ("18",))]
    assert claims(made, *own[:3], mark("18", wrong, "wrong", None)) == []  # nobody knows what is wrong with it
    assert claims(made, *own[:3], mark("18", wrong, "unreadable")) == []
    assert claims(made, *(mark(name, text) for name, text in LINES.items())) == [("own_equations", ("18",))]


def test_what_stands_in_the_equations_too_is_named_before_what_does_not():
    """A slider's speed of the other sign, as a habit and as a slip in the equation that gives it, makes the same table."""
    desk = Desk(coursework.load("v102"))
    table = desk.machine.table()
    table[:, desk.key.names.index("u")] *= -1
    for equations, code in (("right", "sign_u"), ({"2": "VMy - a*w3*cos(phi3) + c*w3*sin(phi3) + u = 0"}, "equation_2")):
        found = codes(desk.marked(table, equations)[1])
        assert found[0] == code and {*found} == {"sign_u", "equation_2"}


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "regular"), [(1.02e-9, True), (-1.02e-9, True), (0.98e-9, False), (-0.98e-9, False)])
def test_own_equations_of_any_size_are_solved_where_they_are_regular(size, part, regular, monkeypatch):
    """A velocity of 3 and one of 2, the second times a small part, in the second of three rows."""
    names = {"a": np.full(3, size), "b": size * np.array([1.0, part, 1.0])}
    monkeypatch.setattr(module, "_names", lambda *_: names)
    key = SimpleNamespace(variant=SimpleNamespace(sought=("u", "v"), known_rates=()), velocities=["v", "u"])
    found = module._solved(key, [parse("a*u - 3*a"), parse("b*v - 2*b")], np.zeros(3), np.zeros((3, 1)))
    assert found == pytest.approx(np.array([[2, 3], [2, 3] if regular else [np.nan, np.nan], [2, 3]]), nan_ok=True)
