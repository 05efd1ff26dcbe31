"""What the geometry confirms is found once for a template, and never from data that make a wrong equation look right."""

import re
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.equations.reduction.structure import structures
from coursework.motion.geometry.judging import agreement
from tests.mechanisms.library import mechanism

PAGE = (Path(__file__).parents[3] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
RIGHT = "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3)"


def confirmed(text):
    closure = coursework.solve(coursework.parse_variant(text, "v.toml"), quantities=["table"]).scene.closure
    return closure.agreed


def with_datum(value, left, text=PAGE):
    """Return the file with one datum more, r9, and another left side of equation 11."""
    return text.replace("[given]", f'[given]\nr9 = "{value} m"', 1).replace(RIGHT, left)


@pytest.fixture
def looked_at(monkeypatch):
    """Return a list of the data that the positions were looked at with."""
    structures.cache_clear()
    seen = []
    judge = agreement._judged

    def counted(equations, *found):
        seen.append(equations.variant.values)
        return judge(equations, *found)

    monkeypatch.setattr(agreement, "_judged", counted)
    return seen


def test_variants_that_differ_in_their_data_are_looked_at_once(looked_at):
    for length in (0.953, 0.96, 0.94):
        assert confirmed(PAGE.replace("0.953 m", f"{length} m")) == ("11", "12", "16", "18")
    (data,) = looked_at
    assert all(data[name] != value for name, value in coursework.parse_variant(PAGE).values.items())


def length_of(name):
    return re.search(rf'^{name} *= *"([\d.]+) m"', PAGE, re.MULTILINE)[1]


def test_an_equation_that_is_right_for_one_set_of_data_only(looked_at):
    """A length in the place of another one of the same size: right by chance, and wrong for the next student."""
    wrong = RIGHT.replace("r3*w3*sin", "r9*w3*sin")
    same = length_of("r3")
    assert confirmed(with_datum(same, wrong)) == ("11", "12", "16", "18")
    for other in ("0.5", "0.0"):
        with pytest.raises(coursework.InputError, match=r"V302 v\.toml:\d+  equation 11 contradicts"):
            confirmed(with_datum(other, wrong))
    assert confirmed(with_datum(same, wrong)) == ("11", "12", "16", "18")


def test_a_factor_that_is_zero_hides_a_term_in_its_own_files_only(looked_at):
    wrong = f"{RIGHT} + r9*w3*sin(phi1)"
    assert confirmed(with_datum("0", wrong)) == ("11", "12", "16", "18")
    with pytest.raises(coursework.InputError, match="V302"):
        confirmed(with_datum("0.2", wrong))


def test_roots_are_looked_at_for_each_set_of_data(looked_at):
    """sqrt((r3 - r9)^2) is r3 - r9 as long as that is positive."""
    root = f"{RIGHT} + (sqrt((r3 - r9)^2) - (r3 - r9))*w3*sin(phi1)"
    short, long = float(length_of("r3")) / 2, 2 * float(length_of("r3"))
    assert confirmed(with_datum(short, root)) == ("11", "12", "16", "18")
    with pytest.raises(coursework.InputError, match="V302"):
        confirmed(with_datum(long, root))
    assert [data["r9"] for data in looked_at] == [short, 1.01 * short, long]  # moved a little, where the difference is zero


@pytest.mark.parametrize(
    ("times", "told"),
    [
        ((2,), None),
        ((2, 3), r"V303 v.toml:(\d+)  one of these equations .*: k2 \(:\1\); k3 \(:\d+\)"),
        ((2, 3, 4), "V301 .* in more than one place"),
        ((2, 2, 3), "V302 .* equation k3 contradicts"),  # one alone stands against two
    ],
)
def test_equations_that_contradict_each_other_alone_are_named_where_one_is_to_blame(times, told):
    """Each says q = k w3 of a velocity that the geometry does not know: any one of them is right."""
    written = "".join(
        f'[[constraint]]\nname = "k{k}{"" if place == times.index(k) else "again"}"\nequation = "q - {k}*w3 = 0"\n\n'
        for place, k in enumerate(times)
    )
    text = PAGE.replace('w4 = "1/s"', 'w4 = "1/s"\nq = "1/s"').replace("[points]", f"{written}[points]", 1)
    assert text.count("q - ") == len(times) and 'q = "1/s"' in text
    if told is None:
        confirmed(text)
        return
    with pytest.raises(coursework.InputError, match=told):
        confirmed(text)


def test_positions_that_the_drive_cannot_keep_contradict_each_other():
    """With the same combination of two coordinates in both, nothing is left for the drive to move."""
    held = '["R*psi2 - l*phi3", "(R0 - R)*phi1 + R*psi2 - l*phi3"]'
    text = mechanism("epicyclic", ('["(R0 - R)*phi1 + R*psi2", "S.y"]', held), rails=None)
    with pytest.raises(
        coursework.InputError, match=r"V320 .*no. 1 of \[closure\] and no. 2 of .* contradict each other: no velocities satisfy"
    ):
        confirmed(text)


WAITING = mechanism("robot-arm")
CRANK = """
[given]
r = "0.1 m"
l = "0.35 m"
[drive]
w = { pieces = [["0 s", "0"], ["0.2 s", "5"]] }
[coordinates]
a = { start = "0 rad", rate = "w" }
b = { start = "0 rad", rate = "v" }
x = { start = "0.45 m", rate = "u" }
[time]
step = "0.02 s"
end = "1.4 s"
[[constraint]]
equation = "u = -r*w*sin(a) - l*v*sin(b)"
[[constraint]]
equation = "r*w*cos(a) + l*v*cos(b) = 0"
[closure]
holds = ["r*cos(a) + l*cos(b) - x", "r*sin(a) + l*sin(b)"]
"""


ARM = """
[given]
l = "0.4 m"
[drive]
w = { pieces = [["0 s", "1"], ["1 s", "0"]] }
v = { pieces = [["0 s", "0"], ["1 s", "1"]] }
[coordinates]
a = { start = "0.5 rad", rate = "w" }
b = { start = "0 rad", rate = "v" }
x = { start = "0.75103302 m", rate = "u" }
[time]
step = "0.05 s"
end = "2 s"
[[constraint]]
equation = "u = -l*w*sin(a) - l*v*sin(b)"
[closure]
holds = ["l*cos(a) + l*cos(b) - x"]
"""


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (ARM, "- l*v*sin(b)", "+ l*v*sin(b)"),
        (ARM, " - l*v*sin(b)", ""),
        (WAITING, "VMy - r2*w2", "-VMy - r2*w2"),
        (WAITING, "VMy - r2*w2", "0*VMy - r2*w2"),
        (CRANK, "-r*w*sin(a)", "r*w*sin(a)"),
        (CRANK, '"r*w*cos(a)', '"-r*w*cos(a)'),
    ],
)
def test_the_sign_of_a_drive_that_waits_is_judged_as_well(text, right, wrong):
    """The second joint waits at zero; the hand goes to the right first; the crank stands at zero for a while."""
    assert len(confirmed(text)) == text.count("equation = ")
    assert right in text
    with pytest.raises(coursework.InputError, match="V302"):
        confirmed(text.replace(right, wrong))


TWO_ARMS = """
[given]
l1 = "0.5 m"
l2 = "0.4 m"
[drive]
w1 = { pieces = [["0 s", "0"], ["0.6 s", "0.3*sin(t - 0.6)"]] }
w2 = "0.4"
[coordinates]
p1 = { start = "0.7 rad", rate = "w1" }
p2 = { start = "0.2 rad", rate = "w2" }
x = { start = "0.7744477211 m", rate = "u" }
y = { start = "0.4015765759 m", rate = "v" }
[time]
step = "0.05 s"
end = "2 s"
[[constraint]]
equation = "u = -l1*w1*sin(p1) - l2*w2*sin(p2)"
[[constraint]]
equation = "v = l1*w1*cos(p1) + l2*w2*cos(p2) + 0.02*cos(t)"
[closure]
holds = ["l1*cos(p1) + l2*cos(p2) - x", "l1*sin(p1) + l2*sin(p2) - y + 0.02*sin(t)"]
"""


@pytest.mark.parametrize(("right", "wrong"), [("u = -l1*w1", "u = l1*w1"), ("v = l1*w1", "v = 0*l1*w1")])
def test_one_of_two_drives_that_waits_is_judged_also_where_positions_depend_on_time(right, wrong):
    assert len(confirmed(TWO_ARMS)) == 2
    with pytest.raises(coursework.InputError, match="V302"):
        confirmed(TWO_ARMS.replace(right, wrong))


def test_a_drive_without_a_value_later_on_leaves_the_equations_judged_at_the_start():
    assert len(confirmed(TWO_ARMS.replace('"0.4"', '"0.4/(1 - t)^2"'))) == 2


# Of the windshield wiper with its crank along the line from O: rad, by two triangles.
CLOSED = (0.0, 0.6406099593716998, 1.4389218848213268, 0.03749007509521021, 1.4338576119563597)
CRANK, COSINE, LAST = "-r1*w1*sin(phi1) - r2", "r1*w1*cos(phi1)", "+ r5*w5*sin(phi5)"


def wiper(loop="(B - D - r3 @ phi3)", *changes, **changed):
    """Return the wiper with position equations for one of its two loops; the other is closed by its written equations alone."""
    starts = {f"phi{place}": f'{{ start = "{at} rad", rate = "w{place}" }}' for place, at in enumerate(CLOSED, start=1)}
    return mechanism("windshield-wiper", *changes, holds=f'["{loop}.x", "{loop}.y"]', **starts, **changed)


def test_a_loop_that_only_equations_close_is_judged_where_it_closes():
    """The second loop has no position equation: away from the start its links are not where its equations take them."""
    assert confirmed(wiper()) == ("1", "2")  # nothing is contradicted, nor told to bend
    # What is right only while the second loop closes, and the sign in it that nothing holds.
    assert confirmed(wiper("(B - D - r3 @ phi3)", (LAST, "+ w5*(yD - yG + r3*sin(phi3) + r4*sin(phi4))"))) == ("1", "2")
    with pytest.raises(coursework.InputError, match=r"V303 .*: 3 .*; 4 "):
        confirmed(wiper("(B - D - r3 @ phi3)", (LAST, LAST.replace("+", "-"))))


@pytest.mark.parametrize("loop", ["(B - D - r3 @ phi3)", "(E - G - r5 @ phi5)"])
@pytest.mark.parametrize(
    "slip", [(CRANK, CRANK[1:]), (COSINE, f"-{COSINE}"), (COSINE, "r1*w1")]
)  # hidden at the start, not, more so
def test_one_slip_in_a_loop_that_only_equations_close_is_named(loop, slip):
    with pytest.raises(coursework.InputError, match=r"V302 .*equation [12] contradicts"):
        confirmed(wiper(loop, slip))


@pytest.mark.parametrize(("drive", "angle"), [("n1", "n1*t"), ("n1*sin(n1*t)", "(1 - cos(n1*t))")])  # one starts from rest
def test_a_sign_hidden_at_the_start_is_seen_where_equations_depend_on_time(drive, angle):
    timed = CRANK.replace("phi1", angle)
    assert confirmed(wiper("(B - D - r3 @ phi3)", (CRANK, timed), w1=drive)) == ("1", "2")
    with pytest.raises(coursework.InputError, match=r"V302 .*equation 1 contradicts"):
        confirmed(wiper("(B - D - r3 @ phi3)", (CRANK, timed[1:]), w1=drive))


@pytest.mark.parametrize(("rows", "clash"), [
    ([[1, 0, 1], [0, 1, 1], [1, 1, 2]], False), ([[1, 0, 1], [0, 1, 1], [1, 1, 3]], True),
    ([[1, 1, 1], [1, 1, 2], [2, 2, 0]], False),
    ([[1, 0, 1], [1, 0, 2]], True), ([[1, 0, 1]], False), ([[0, 0, 1]], True), ([[1, 1], [1, 1.042]], True),
    ([[1, 1], [1, 1.039]], False),
])  # fmt: skip
def test_a_clash_fixes_each_velocity_that_occurs_and_has_no_solution(rows, clash):
    """The singular values of (1, 1), (1, 1 + x) have the product x and nearly the ratio x/4, of which a hundredth is allowed."""
    assert agreement._clashing(np.array(rows, dtype=float)).tolist() is clash
    assert agreement._clashing(np.array([rows, rows]) * [[[1e-4]], [[1e4]]]).tolist() == [clash, clash]


@pytest.mark.parametrize("moves", ["n1", "n1*sin(n1*(t - 0.3))"])
def test_a_sign_is_seen_also_of_a_drive_that_rests_at_first(moves):
    """For 0.3 s, a third of the run; the crank's angle of then is written as a formula of time."""
    drive = f'{{ pieces = [["0 s", "0"], ["0.3 s", "{moves}"]] }}'
    timed = CRANK.replace("phi1", "n1*(t - 0.3)" if moves == "n1" else "(1 - cos(n1*(t - 0.3)))")
    assert confirmed(wiper("(B - D - r3 @ phi3)", (CRANK, timed), w1=drive)) == ("1", "2")
    with pytest.raises(coursework.InputError, match=r"V302 .*equation 1 contradicts"):
        confirmed(wiper("(B - D - r3 @ phi3)", (CRANK, timed[1:]), w1=drive))
