"""Equations that say nothing, or the same again, earn nothing; right ones rewritten at random stay right."""

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import Formula, spelled
from tests.sample import first


@cache
def judge(name="31"):
    return Judge(key_of(coursework.load(name)))


def line(text, number=1):
    left, _, right = text.partition("=")
    return EquationLine("equations.txt", number, text, Formula("-", (parse(left), parse(right))))


def marks(texts, name="31"):
    return judge(name).mark([line(text, number) for number, text in enumerate(texts, start=1)])


def written(name):
    return [f"{spelled(c.left)} = {spelled(c.right)}" for c in coursework.load(name).constraints if not c.is_closure]


WORTHLESS = [
    "1.001*{w} = {w}", "{w} = 1.003*{w}", "1000*{w} = 999*{w}", "{r}*{w} = 0.999*{r}*{w}", "{w} + 1e6 = 1e6",
    "{w} + 100000 - 100000 = 0", "{w}*({q}+1000) - {w}*({q}+999.999) = 0", "0.0001*{w} = 0", "{w} = {w}", "0*{w} = 0",
    "{w}*sin({q})^2 + {w}*cos({q})^2 = {w}", "1e9*{w} - 999999999*{w} = 0",
]  # fmt: skip


@pytest.mark.parametrize("form", WORTHLESS)
@pytest.mark.parametrize("name", ["31", "v102"])
def test_lines_that_cancel_earn_nothing(form, name):
    variant = coursework.load(name)
    length = next(given.name for given in variant.given if given.si == "m")
    angle = variant.coordinates[0].name
    found = marks([form.format(w=w, r=length, q=angle) for w in variant.sought], name)
    assert found.independent == 0
    assert found.share == 0.0


@pytest.mark.parametrize("name", ["31", "v102"])
def test_a_right_line_and_near_copies_of_it_are_one_line(name):
    right = written(name)[0]
    for size in ("0.001", "0.002", "1e-7"):
        texts = [right, *(f"{right} + {size}*{w}" for w in coursework.load(name).sought)]
        found = marks(texts, name)
        assert found.independent == 1, size


def test_a_line_may_carry_another_that_is_true_on_the_motion_only():
    """With c = 0 on the closure, (11) + c·w is true of the motion whatever w is: it is (11), and nothing more."""
    variant = coursework.load("31")
    values = {given.name: given.value for given in variant.given}
    phi = [c.start for c in variant.coordinates]
    height = values["r1"] * np.sin(phi[0]) + values["r2"] * np.sin(phi[1]) + values["r3"] * np.sin(phi[2] + np.pi / 2)
    closure = f"(r1*sin(phi1) + r2*sin(phi2) + r3*sin(phi3 + pi/2) - {float(height)!r})"
    right = written("31")[0].replace(" = 0", "")
    found = marks([f"{right} + {closure}*{w} = 0" for w in variant.sought])
    assert {mark.verdict for mark in found.marks} <= {"right", "closure"}
    assert found.independent == 1
    beside = marks([f"{right} = 0", *(f"{right} + {closure}*{w} = 0" for w in variant.sought)])
    assert {mark.verdict for mark in beside.marks} == {"right", "closure"} and beside.independent == 1
    assert marks([f"{closure}*{w} = 0" for w in variant.sought]).independent == 0


@pytest.mark.parametrize(("texts", "different"), [
    (["A = 0"], 0), (["A = w1", "A = w1"], 2), (["sin(A) = w1", "w1 = 2*w2", "2*w1 = 4*w2"], 2), (["w1 = 2*w2", "w1 = 3*w2"], 2),
])  # fmt: skip
def test_a_point_where_a_velocity_must_stand_is_wrong_and_says_nothing_that_another_line_repeats(texts, different):
    found = marks(texts)
    assert {mark.verdict for mark in found.marks} == {"wrong"}
    assert (found.independent, found.share, found.different) == (0, 0.0, different)


@pytest.mark.long
@pytest.mark.parametrize("seed", first(1, (5, 6, 7)))
def test_random_lines_of_no_worth_earn_nothing(seed):
    chance = np.random.default_rng(seed)
    sought, names = ("w1", "w2", "w3", "w4"), ("phi1", "phi2", "phi3", "r1", "r2", "r3", "t")
    for _ in range(100):
        w, other = chance.choice(sought, 2, replace=False)
        factor = "*".join(chance.choice(names, 2))
        size = float(10 ** chance.uniform(-3, 9))
        near = float(1 + chance.choice([-1, 1]) * 10 ** chance.uniform(-8, -2.8))
        form = chance.choice([
            f"{near!r}*{factor}*{w} = {factor}*{w}",
            f"{factor}*{w} + {size!r}*{other} - {size!r}*{other} = 0",
            f"{w}*({factor} + {size!r}) - {w}*({factor} + {size * near!r}) = 0",
            f"{w} + {other}*{size!r} + {size!r} = {size!r} + {size!r}*{other}",
        ])  # fmt: skip
        assert marks([form]).share == 0.0, form


def test_right_lines_rewritten_at_random_stay_right():
    chance = np.random.default_rng(6)
    right = [text.split(" = ") for name in ("31",) for text in written(name)]
    for _ in range(300):
        place = chance.integers(len(right))
        left, zero = right[place]
        other = right[chance.integers(len(right))][0]
        size = float(10 ** chance.uniform(-3, 4))
        form = chance.choice([
            f"{size!r}*({left}) = {zero}",
            f"-({left})/({size!r}) = 0",
            f"({left}) + {size!r}*({other}) = 0" if other != left else f"{left} = 0",
            f"({left})*(2 + sin(phi1)) = {zero}",
            f"{size!r} + ({left}) = {size!r}",
            f"w1 + ({left}) = w1",
        ])  # fmt: skip
        found = marks([form])
        assert (found.marks[0].verdict, found.independent) == ("right", 1), form


def test_rounded_lines_that_nearly_cancel_at_some_points_are_rounded():
    texts = ["VMy - 0.915*w3*cos(phi3) - 0.457*w3*sin(phi3) = 0", "0.457*w4 = 0.915*w3*cos(phi3) - 1.83*w3*sin(phi3)",
             "0.95*w1*sin(phi1) + 0.85*w2*sin(phi2) + 0.91*w3*sin(phi3) = 0"]  # fmt: skip
    found = marks(texts)
    assert [mark.verdict for mark in found.marks][:2] == ["rounded"] * 2
    assert found.independent >= 2


def test_rounded_lines_of_a_whole_set_count_each():
    texts = [text.replace("r1", "0.953").replace("r2", "0.8472").replace("r3", "0.4572") for text in written("31")]
    found = marks(texts)
    assert {mark.verdict for mark in found.marks} <= {"right", "rounded"}
    assert (found.independent, found.needed) == (4, 4)


def test_a_wrong_drive_beside_all_equations_is_told_and_costs_nothing():
    for name, drive, law in (("31", "VMy = V1*cos(p*t + alpha)", "VMy = V1*sin(p*t + alpha)"), ("v102", "VMy = V1", "VMy = 0")):
        found = marks([drive, *written(name)], name)
        told = next(mark for mark in found.marks if mark.line.line == 1)
        assert (found.share, told.verdict, told.lack.values["law"]) == (1.0, "wrong", law)
        assert all(mark.line.line > 1 for mark in marks(["r1 = 2*r2", *written(name)], name).marks)
