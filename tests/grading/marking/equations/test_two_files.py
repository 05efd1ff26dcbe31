"""Equations in two files: halves and copies are one work, whole systems of which one is wrong are a question to a person."""

import pytest

import coursework
from coursework.grading.marking.equations.meant_together import contradicting
from tests.grading.marking.table.desks import Desk
from tests.grading.reading.equations.notation.notations import NOTATIONS, PLAIN

RIGHT = PLAIN["v102"]
WRONG = RIGHT.replace("+ r1*w1*sin", "- r1*w1*sin")
DESK = Desk(coursework.load("v102"))


@pytest.mark.parametrize(("first", "second", "status"), [
    (RIGHT, WRONG, "needs-review"), (WRONG, RIGHT, "needs-review"), (RIGHT, NOTATIONS["latex"](WRONG), "needs-review"),
    (RIGHT, NOTATIONS["latex"](RIGHT), "graded"), (RIGHT[: RIGHT.index("\n")], RIGHT[RIGHT.index("\n") :], "graded"),
    (WRONG, WRONG, "graded"), (RIGHT, WRONG.splitlines()[2], "graded"),  # both files are wrong; one is not all there
])  # fmt: skip
def test_which_of_two_whole_files_counts_is_a_question(first, second, status):
    grade = DESK.handed(DESK.machine.table(), equations=None, more={"a.txt": first, "b.txt": second})
    assert grade.status == status
    if status == "needs-review":
        assert "The equations in a.txt and b.txt contradict each other" in grade.reason
        assert grade.plain()["proposed"] == 92


def test_a_file_with_fewer_lines_than_equations_are_needed_is_no_other_system():
    verdicts = [("a", "right"), ("a", "right"), ("b", "wrong"), ("b", "right")]
    assert (contradicting(verdicts, 2), contradicting(verdicts, 3)) == (("a", "b"), ())
