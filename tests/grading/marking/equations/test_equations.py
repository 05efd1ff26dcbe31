"""Equations: every equivalent form is right, every single slip is found and named, dependent ones are told."""

import pytest

import coursework
from coursework.grading.marking.equations.edits import applied, edits, unlikeliness
from coursework.grading.marking.equations.equations import ROUNDED, Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.student_work import EquationLine
from coursework.variant.catalogue import names
from coursework.variant.formula.reader import parse, parse_equation
from coursework.variant.formula.tree import Formula, spelled
from tests.grading.reading.test_read_submission import read
from tests.sample import first
from tests.solved import loaded

RIGHT = [
    "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0",
    "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0",
    "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0",
    "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0",
]
EQUIVALENT = [
    "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))",
    "0 = r3*w3*(2*cos(phi3) + sin(phi3)) - VMy",
    "V1*sin(p*t + alpha) = 2*r3*w3*cos(phi3) + r3*w3*cos(phi3 - pi/2)",
    "w4 = 2*w3*(cos(phi3) - 2*sin(phi3))",
    "1000*r3*w4 = 2000*r3*w3*cos(phi3) - 4000*r3*w3*sin(phi3)",
    "r1*w1*sin(phi1) + r2*w2*sin(phi2) + 2*r3*w3*sin(phi3) = 0",
    "w1 = -r3*w3*sin(phi3)*(2*cos(phi2) + sin(phi2))/(r1*sin(phi1 - phi2))",
    "VMy - 0.914*w3*cos(phi3) - 0.457*w3*sin(phi3) = VMx",
]


def line(text, number=1):
    left, _, right = text.partition("=")
    return EquationLine("equations.txt", number, text, Formula("-", (parse(left), parse(right))))


@pytest.fixture(scope="module")
def judge():
    return Judge(key_of(coursework.load("31")))


def test_the_author_s_equations_are_right_and_complete(judge):
    marks = judge.mark([line(text, number) for number, text in enumerate(RIGHT, start=1)])
    assert [mark.verdict for mark in marks.marks] == ["right"] * 4
    assert (marks.independent, marks.needed, marks.share) == (4, 4, 1.0)


@pytest.mark.parametrize("text", EQUIVALENT)
def test_equivalent_forms_are_right(judge, text):
    assert judge.mark([line(text)]).marks[0].verdict == "right"


def test_rounded_data_and_what_is_just_too_far(judge):
    for factor, verdict in ((1 + 0.9 * ROUNDED, "rounded"), (1 + 6 * ROUNDED, "wrong")):
        text = f"VMy - {2 * 0.457 * factor:.9f}*w3*cos(phi3) - 0.457*w3*sin(phi3) = 0"
        assert judge.mark([line(text)]).marks[0].verdict == verdict


def test_an_equation_that_holds_on_the_closure_only(judge):
    marks = judge.mark([line("r1*sin(phi1) + r2*sin(phi2) + r3*sin(phi3 + pi/2) = 0.317265 + 0*w1")])
    assert marks.marks[0].verdict in {"closure", "wrong"}
    point = coursework.load("31")
    values = {c.name: c.start for c in point.coordinates}
    from math import pi, sin

    height = 0.953 * sin(values["phi1"]) + 0.847 * sin(values["phi2"]) + 0.457 * sin(values["phi3"] + pi / 2)
    kept = f"r1*sin(phi1) + r2*sin(phi2) + r3*sin(phi3 + pi/2) = {height:.15f}"
    assert judge.mark([line(kept)]).marks[0].verdict == "closure"


def test_dependent_and_too_few(judge):
    marks = judge.mark([line(RIGHT[0], 1), line(EQUIVALENT[0], 2), line(RIGHT[1], 3)])
    assert (marks.independent, marks.needed) == (2, 4)
    assert marks.share == 0.5


def test_guessing_every_sign_does_not_pay(judge):
    guesses = [f"VMy {a} 2*r3*w3*cos(phi3) {b} r3*w3*sin(phi3) = 0" for a in "+-" for b in "+-"]
    marks = judge.mark([line(text, number) for number, text in enumerate([*RIGHT, *guesses], start=1)])
    assert marks.independent == 4
    assert marks.share == pytest.approx(4 / 7)


@pytest.mark.parametrize("text", ["w3*w3 = 1", "w1*w2 = w2*w1 + w3^2 - w3*w3 + 1", "1/w3 = 2"])
def test_what_is_not_linear_in_the_velocities_is_wrong(judge, text):
    assert judge.mark([line(text)]).marks[0].verdict == "wrong"


def test_a_line_that_could_not_be_read_earns_and_costs_nothing(judge):
    unread = EquationLine("equations.txt", 5, "w3 == lambda: 0")
    marks = judge.mark([*(line(text, number) for number, text in enumerate(RIGHT, start=1)), unread])
    assert marks.marks[-1].verdict == "unreadable"
    assert marks.share == 1.0


SLIPS = [
    ("sign", "r3*w3*sin(phi3) - r2*w2*cos(phi2) + r1*w1*cos(phi1) = 0"),
    ("function", "VMy - 2*r3*w3*sin(phi3) - r3*w3*sin(phi3) = 0"),
    ("name", "VMx - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"),
    ("name", "w4 = 2*w3*(cos(phi3) - 2*sin(phi1))"),
    ("factor", "VMy - r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"),
    ("factor", "VMy - 2*w3*cos(phi3) - r3*w3*sin(phi3) = 0"),
    ("factor", "VMy - 2*r3*w3 - r3*w3*sin(phi3) = 0"),
]


@pytest.mark.parametrize(("kind", "text"), SLIPS)
def test_slips_are_named_where_they_stand(judge, kind, text):
    mark = judge.mark([line(text)]).marks[0]
    assert mark.verdict == "wrong"
    assert mark.hint is not None
    assert mark.hint.kind == kind
    assert judge.mark([line(mark.hint.text)]).marks[0].verdict == "right"


@pytest.mark.parametrize("label", ["(16) ", "16) ", "[16] ", "(1)", ""])
@pytest.mark.parametrize(("was", "is_now", "kind"), [("+ r2", "- r2", "sign"), ("cos(phi3)", "sin(phi3)", "function")])
def test_the_slip_of_a_line_behind_a_label_and_a_minus_is_found(judge, label, was, is_now, kind):
    """The label was taken for a number, from which no single slip leads to a right line."""
    text = label + "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0".replace(was, is_now)
    (mark,) = judge.mark(read(("equations.txt", text.encode())).equations).marks
    assert (mark.verdict, mark.hint.kind) == ("wrong", kind)
    assert text[mark.hint.column - 1 :].startswith(is_now[:3].strip())


@pytest.mark.parametrize(
    ("text", "column", "mended"),
    [
        ("r3*w3*sin(phi3) = -r2*w2*cos(phi2) + r1*w1*cos(phi1)", 19, "r3*w3*sin(phi3) = r2*w2*cos(phi2) + r1*w1*cos(phi1)"),
        ("w4 = -2*w3*(cos(phi3) - 2*sin(phi3))", 6, "w4 = 2*w3*(cos(phi3) - 2*sin(phi3))"),
    ],
)
def test_a_minus_that_stands_there_is_taken_away_and_none_is_added(judge, text, column, mended):
    hint = judge.mark([EquationLine("equations.txt", 1, text, Formula("-", parse_equation(text)))]).marks[0].hint
    assert hint is not None
    assert (hint.column, hint.text) == (column, mended)


WRITTEN = [name for name in names() if any(not c.is_closure for c in loaded(name).constraints)]


@pytest.mark.parametrize("most", first(1, (2, 6)))
@pytest.mark.parametrize("name", WRITTEN)
def test_every_single_edit_of_the_catalogue_is_found(name, most):
    variant = coursework.load(name)
    judge = Judge(key_of(variant))
    written = [c for c in variant.constraints if not c.is_closure]
    marks = judge.mark([EquationLine("e", c.line, "", Formula("-", (c.left, c.right))) for c in written])
    assert {mark.verdict for mark in marks.marks} == {"right"}
    tried = 0
    for constraint in written:
        tree = Formula("-", (constraint.left, constraint.right))
        slips = [edit for edit in edits(tree, judge.kinds) if edit.path and edit.kind != "factor"]
        for edit in slips[:: max(1, len(slips) // most)]:
            changed = applied(tree, edit)
            mark = judge.mark([EquationLine("e", 1, "", changed)]).marks[0]
            assert mark.verdict != "wrong" or mark.hint is not None, spelled(changed)
            tried += mark.verdict == "wrong"
    assert tried >= len(written)


def test_a_wrong_line_written_twice_is_one_fault(judge):
    wrong = RIGHT[3].replace("- r1", "+ r1")
    again = f"2*({wrong.removesuffix(' = 0')}) = 0"
    once = judge.mark([line(text, place) for place, text in enumerate((*RIGHT[:3], wrong), 1)])
    twice = judge.mark([line(text, place) for place, text in enumerate((*RIGHT[:3], wrong, again), 1)])
    other = judge.mark([line(text, place) for place, text in enumerate((*RIGHT[:3], wrong, RIGHT[3].replace("- r2", "+ r2")), 1)])
    assert (once.share, twice.share, other.share) == (0.75, 0.75, 0.6)
    assert (len(twice.wrong), twice.different) == (2, 1)


def test_a_ratio_of_velocities_is_the_equation_that_it_stands_for(judge):
    """Right in every form, wrong where it is wrong; a velocity divided by itself says nothing."""
    ratios = [
        "w4/w3 = 2*(cos(phi3) - 2*sin(phi3))",
        "2*tan(phi3) - 1 + 0.5*w4/(w3*cos(phi3)) = 0",
        "w3/VMy = 1/(r3*(2*cos(phi3) + sin(phi3)))",
    ]
    ratios += ["(r3*w3*sin(phi3) - r1*w1*cos(phi1))/w2 = r2*cos(phi2)", "VMy/w3 - r3*sin(phi3) = w3*2*r3*cos(phi3)/w3"]
    assert [judge.mark([line(text)]).independent for text in ratios] == [1] * 5
    assert judge.mark([line("w4/w3 = 2*(cos(phi3) + 2*sin(phi3))")]).marks[0].verdict == "wrong"
    assert judge.mark([line("w3/w3 = 1")]).independent == 0


def test_what_repeats_is_told_of_the_line_that_repeats_and_of_no_other_of_its_number(judge):
    """Lines of two files have the same numbers."""
    twice = [line(text, number) for number, text in enumerate(RIGHT, start=1)] + [line(RIGHT[0], 3)]
    assert [bool(mark.lack) for mark in judge.mark(twice).marks] == [False] * 4 + [True]


def test_what_is_no_velocity_equation_costs_nothing_beside_them(judge):
    """A period, a drive, a position with a slip; without them the same, with an equation that is wrong a quarter less.

    Only the drive is told, with that of the task.
    """
    right = [line(text, number) for number, text in enumerate(RIGHT, start=1)]
    beside = [
        line("2*pi/p = 0.5", 5),
        line("VMx = V1*sin(p*t + alpha)", 6),
        line("r1*cos(phi1) + r2*cos(phi2) = r3*cos(phi3)", 7),
    ]
    found = judge.mark(right + beside)
    assert (found.share, found.different) == (1.0, 0)
    assert [mark.line.line for mark in found.marks] == [1, 2, 3, 4, 6]
    assert judge.mark([*right[:3], *beside]).share == 0.75
    assert judge.mark([*right, line("w1 = 3*w2", 5)]).share == 0.8


def test_a_number_too_many_is_likelier_than_another_length_and_that_than_one_left_out():
    """With r1 = 0.5 m and r3 = r2/2 all of these make the line right."""
    tree = Formula("-", (parse("2*r2*w2"), parse("0")))
    found = sorted(
        edits(tree, {"r1": "m", "r2": "m", "r3": "m", "w2": "1/s"}),
        key=lambda edit: unlikeliness(tree, edit, is_new_sign=False),
    )
    texts = [spelled(applied(tree, edit)) for edit in found]
    ranks = [texts.index(text) for text in ("r2*w2 - 0", "2*r3*w2 - 0", "2*r2*w2/2 - 0", "r1*2*r2*w2 - 0")]
    assert ranks == sorted(ranks)


def test_a_hint_writes_a_minus_as_people_do(judge):
    wrong = RIGHT[2].replace("+ r3", "- r3")
    assert judge.mark([line(wrong)]).marks[0].hint.text == RIGHT[2]


def test_the_sign_before_a_product_is_that_of_the_whole_term(judge):
    """Not that of its first factor, whose name alone says little."""
    hint = judge.mark([line(f"-{RIGHT[3]}")]).marks[0].hint
    assert (hint.kind, hint.column, hint.term, hint.text) == ("sign", 1, "r3*w3*sin(phi3)", RIGHT[3])
