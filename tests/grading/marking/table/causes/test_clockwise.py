"""Turning counted clockwise: accepted or named, told from a wrong sign, a drive with the other sign and right work."""

import re

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.commands.line.options import RUBRIC_KEYS
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.rubric import FLOORS, KEYS, Rubric, read_rubric
from coursework.grading.marking.table.causes.clockwise import _turned
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.ways import StudentTable
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.grading.marking.machines import Machine
from tests.grading.marking.test_more_right_never_less import lines
from tests.mechanisms.library import mechanism
from tests.sample import first

# A crank that drives a slider on a line of 20 degrees, offset; not of the catalogue.
OWN = mechanism("slider-crank-on-a-slope").encode()


# A four-bar linkage whose rocker pin sits on a wheel geared to the crank.
GEARED = b"""
format = 1
title = "Geared five-bar linkage"
source = "own"
[given]
a = "0.09 m"
b = "0.28 m"
c = "0.3 m"
d = "0.11 m"
W = "4.4 1/s"
eps = "3.5 1/s"
[drive]
w1 = "W + eps*sin(W*t)"
[coordinates]
phi1 = { start = "0.6 rad", rate = "w1" }
phi4 = { start = "2.4 rad", rate = "w4" }
phi2 = { start = "1.5393 rad", rate = "w2" }
phi3 = { start = "2.11683 rad", rate = "w3" }
[time]
step = "0.025 s"
end = "0.6 s"
[[constraint]]
name = "1"
because = "gears"
equation = "w4 + 2*w1 = 0"
[[constraint]]
name = "2"
because = "loop, x"
equation = "-a*w1*sin(phi1) - b*w2*sin(phi2) + c*w3*sin(phi3) + d*w4*sin(phi4) = 0"
[[constraint]]
name = "3"
because = "loop, y"
equation = "a*w1*cos(phi1) + b*w2*cos(phi2) - c*w3*cos(phi3) - d*w4*cos(phi4) = 0"
"""


class Desk:
    """Where tables of one variant are handed in; `right` is made by a program of its own."""

    def __init__(self, variant):
        self.variant, self.key, self.machine = variant, key_of(variant), Machine(variant)
        self.right = self.machine.table()
        self.expected = Expected(self.key.grid, variant)
        self.rates = [place for place, name in enumerate(self.key.names) if variant.unit_of(name) == "rad/s"]
        self.angles = [place for place, name in enumerate(self.key.names) if variant.unit_of(name) == "rad"]

    def turned(self, mirrored=""):
        """The table of one who counts turning clockwise; `mirrored` the angles too, from their start or from its negative."""
        found = self.right.copy()
        found[:, self.rates] *= -1
        if mirrored:
            found[:, self.angles] = (mirrored == "start") * 2 * self.right[0, self.angles] - self.right[:, self.angles]
        return found

    def equations(self, turning=()):
        """The right equations, those at the places `turning` with all angular velocities turned."""
        names = "|".join(self.key.names[place] for place in self.rates)
        texts = [f"{spelled(c.left)} = {spelled(c.right)}" for c in self.variant.constraints]
        return [re.sub(rf"\b({names})\b", r"(-\1)", text) if n in turning else text for n, text in enumerate(texts)]

    def graded(self, table=None, equations=None, clockwise="accept", digits=5):
        files = []
        if table is not None:
            lines = [",".join(["t", *self.key.names])]
            for row, values in enumerate(table):
                lines.append(",".join([f"{row * self.machine.h:.4f}", *(f"{value:.{digits}f}" for value in values)]))
            files.append(submitted_file("table.csv", "\n".join(lines).encode()))
        if equations is not None:
            files.append(submitted_file("equations.txt", "\n".join(equations).encode()))
        marker = Marker(self.key, Rubric(clockwise=clockwise))
        return marker.grade(read_submission(Submission("a", None, tuple(files)), self.expected))


@pytest.fixture(scope="module", params=["31", "v102", "own"])
def desk(request):
    return Desk(parse_variant(OWN, "own.toml", {}) if request.param == "own" else coursework.load(request.param))


def codes(grade):
    return [note.code for note in grade.notes]


@pytest.mark.parametrize("mirrored", ["", "start", "negative"])
def test_accepted_it_is_full_work_with_a_note(desk, mirrored):
    grade = desk.graded(desk.turned(mirrored), desk.equations())
    assert (grade.total, grade.table.misconception) == (100, None)
    assert [code for code in codes(grade) if code != "turns"] == ["clockwise"]


def test_numbers_put_right_in_it_stay_however_many_of_their_column_are(desk):
    """Beyond half of a column they were turned back too: with one more put right, 4 points of 60 were lost."""
    table, place = desk.turned("start"), desk.angles[0]
    signs = np.isin(np.arange(table.shape[1]), desk.rates)
    for count in (len(table) // 2 - 2, len(table) // 2 + 2, len(table) - 5):
        table[1 : count + 1, place] = desk.right[1 : count + 1, place]
        student = StudentTable(np.round(table, 5), np.full(table.shape, 1e-5))
        assert alike(desk.key, _turned(desk.key, student, signs, mirrored=True), desk.key.table).all(), count


@pytest.mark.parametrize("mirrored", ["", "start", "negative"])
def test_as_a_misconception_it_is_named(desk, mirrored):
    grade = desk.graded(desk.turned(mirrored), clockwise="misconception")
    assert grade.table.misconception.code == "clockwise"
    assert "clockwise" not in codes(grade)
    assert grade.table.share < 0.9


@pytest.mark.parametrize("mirrored", ["", "start", "negative"])
def test_few_digits_tell_it_as_well(mirrored):
    desk = Desk(coursework.load("31"))
    grade = desk.graded(desk.turned(mirrored), desk.equations(), digits=2)
    assert grade.total == 100
    assert "clockwise" in codes(grade)


def with_points(count):
    """The geared linkage with the velocities of one or two of its points as columns."""
    text = GEARED
    for number, (name, line) in enumerate([("vE", "c*w3*cos(phi3) + d*w4*cos(phi4)"), ("vF", "a*w1*cos(phi1)")][:count], 4):
        text += f'[[constraint]]\nname = "{number}"\nbecause = "point"\nequation = "{line} - {name} = 0"\n'.encode()
    names = ", ".join(f'{name} = {{ unit = "m/s" }}' for name in ("vE", "vF")[:count])
    return Desk(
        parse_variant(text.replace(b"[time]", f"[unknowns]\n{names.replace(', ', chr(10))}\n[time]".encode()), "own.toml", {})
    )


@pytest.mark.long
@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize("mirrored", ["", "start", "negative"])
def test_velocities_of_points_are_accepted_with_either_sign_as_a_whole(count, mirrored):
    desk = with_points(count)
    points = [place for place, name in enumerate(desk.key.names) if desk.variant.unit_of(name) == "m/s"]
    assert len(points) == count
    table = desk.turned(mirrored)
    for _ in range(2):
        grade = desk.graded(table)
        assert (grade.table.share, "clockwise" in codes(grade)) == (1, True)
        table[:, points] *= -1
    if count == 2:  # one of them alone is a wrong sign
        table[:, points[0]] *= -1
        assert desk.graded(table).table.share < 1


@pytest.mark.long
def test_a_slip_in_it_costs_what_it_costs_in_a_right_table(desk):
    slips = desk.right.copy(), desk.turned()
    for table in slips:
        table[6, -1] *= 1.3
    right, turned = (desk.graded(table) for table in slips)
    assert turned.table.share == pytest.approx(right.table.share, abs=1e-9)
    assert right.table.share < 1
    assert "clockwise" in codes(turned)


@pytest.mark.long
@pytest.mark.parametrize("whole", first(1, (False, True)))
def test_some_velocities_with_the_other_sign_are_wrong_signs(desk, whole):
    for turn, place in enumerate(desk.rates):
        table = desk.right.copy()
        table[:, place] *= -1
        rest = desk.turned()
        rest[:, place] *= -1
        for found in (table, rest) if whole else ((table, rest)[turn % 2],):
            grade = desk.graded(found)
            assert "clockwise" not in codes(grade)
            assert grade.table.share < 1


@pytest.mark.long
def test_a_drive_with_the_other_sign_is_no_turning(desk):
    machine = Machine(desk.variant, drive_sign=-1.0)
    for clockwise in ("accept", "misconception"):
        grade = desk.graded(machine.table(), clockwise=clockwise)
        named = grade.table.misconception
        assert "sign_drive" in (named.code, *named.ties)
        assert "clockwise" not in (named.code, *named.ties, *codes(grade))


def test_a_wheel_that_turns_with_the_crank_makes_no_turning_of_a_drive_with_the_other_sign():
    """Half of the velocities are the drive's: turned back they agree, and the links between them do not."""
    two = parse_variant(GEARED, "own.toml", {})
    assert "clockwise" not in codes(Desk(two).graded(Machine(two, drive_sign=-1.0).table()))
    turned = Desk(two).graded(Desk(two).turned("start"))
    assert (turned.table.share, "clockwise" in codes(turned)) == (1, True)


def test_a_right_table_is_untouched(desk):
    for clockwise in ("accept", "misconception"):
        grade = desk.graded(desk.right, desk.equations(), clockwise=clockwise)
        assert (grade.total, codes(grade), grade.table.misconception) == (100, [], None)


@pytest.mark.long
@pytest.mark.parametrize("with_table", [True, False])
def test_equations_turned_throughout_are_accepted(desk, with_table):
    turned = desk.equations(range(9))
    grade = desk.graded(desk.turned() if with_table else None, turned)
    assert grade.equations.share == 1
    assert codes(grade).count("clockwise") == 1
    strict = desk.graded(desk.turned(), turned, clockwise="misconception")
    assert strict.equations.share < 1


def test_equations_turned_beside_a_table_that_is_not_are_wrong(desk):
    grade = desk.graded(desk.right, desk.equations(range(9)))
    assert grade.equations.share < 1
    assert "clockwise" not in codes(grade)


def test_one_equation_turned_among_others_has_wrong_signs():
    desk = Desk(parse_variant(OWN, "own.toml", {}))
    grade = desk.graded(None, desk.equations([0]))
    assert [mark.verdict for mark in grade.equations.marks] == ["wrong", "right"]
    assert "clockwise" not in codes(grade)


def test_the_rubric_says_how_it_is_taken():
    assert read_rubric("").clockwise == "accept"
    assert read_rubric('[conventions]\nclockwise = "misconception"\n').clockwise == "misconception"
    for text in ('[conventions]\nclockwise = "yes"\n', "[conventions]\nclockwise = []\n"):
        with pytest.raises(InputError, match='"accept" or "misconception"'):
            read_rubric(text)
    with pytest.raises(InputError, match='Did you mean "clockwise"'):
        read_rubric('[conventions]\nclockwize = "accept"\n')


def test_the_example_of_a_rubric_is_the_default_and_the_help_names_its_keys():
    shown = CliRunner().invoke(main, ["grade", "--rubric-example"])
    assert (shown.exit_code, read_rubric(shown.output)) == (0, Rubric())
    assert all(re.search(rf"^(# )?\[*{key}\b", shown.output, re.MULTILINE) for key in KEYS)
    assert ", ".join(KEYS) == RUBRIC_KEYS
    assert all(re.search(rf"^{floor} = [\d.]+  # \w+", shown.output, re.MULTILINE) for floor in FLOORS)
    optional = "\n".join(line.removeprefix("# ") for line in shown.output.splitlines())
    assert read_rubric(optional).confusions
    assert read_rubric(optional).answers
    told = " ".join(CliRunner().invoke(main, ["grade", "--help"]).output.split())
    assert all(key in told for key in KEYS)
    assert "no place for comments: attach feedback/ID.html in SpeedGrader" in told


def test_a_line_put_right_among_lines_that_count_clockwise_takes_nothing():
    """Two of the wrong lines hold if angles are counted clockwise; the line put right holds only if they are not."""
    key = key_of(coursework.load("v112"))
    wrong = {"1": "VMy + l*w3*cos(phi3)", "3": "u + R*w4", "2": "VMx + l*w3*sin(phi3) + u",
             "5": "r1*w1*cos(phi1) + r2*w2*cos(phi2) + rho*w4*cos(psi4)"}  # fmt: skip
    judge = Judge(key)
    before, after = (judge.mark(lines(key, some), turning=True) for some in (wrong, {n: wrong[n] for n in ("1", "3", "5")}))
    assert (before.turned, before.independent) == (True, 3)
    assert after.share >= before.share


def test_as_a_misconception_it_costs_no_more_than_a_sign_of_the_drive(desk):
    """However it is written down: a sign of the drive alone would make the same table of a steady crank."""
    found = [desk.graded(desk.turned(mirrored), clockwise="misconception").table.share for mirrored in ("", "start", "negative")]
    assert Rubric().own_equations_floor - 0.03 <= min(found) <= max(found) < 0.6
