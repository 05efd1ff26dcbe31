"""Whose work is whose, by e-mail before number before name, and what belongs to two belongs to nobody."""

from types import SimpleNamespace

import pytest

from coursework.grading.collecting.matching import match
from coursework.grading.platforms.roster import Student
from coursework.grading.platforms.worksheet import WorksheetRow

ROSTER = [
    Student("ann", "Ann Lee", "ann@x.org", ""), Student("bob", "Bob Ray", "", ""), Student("cid", "Cid Poe", "same@x.org", ""),
    Student("dan", "Same Name", "same@x.org", ""), Student("eve", "Same Name", "", ""), Student("007", "", "", ""),
]  # fmt: skip


def handed_in(number="", name=None, shared=None, own="p", folder=""):
    return SimpleNamespace(id=own, number=number, name=name, shared=shared, folder=folder)


def whose(found, platform, rows=None):
    sheet = None if rows is None else SimpleNamespace(rows=rows)
    matched = match(ROSTER, [found], platform, sheet)
    assert (len(matched.file_lists), len(matched.not_on_roster)) in {(1, 0), (0, 1)}
    return next(iter(matched.file_lists), None)


@pytest.mark.parametrize(("row", "student"), [
    (("Other", "ANN@x.org", "bob", True), "ann"), (("Ann Lee", "no@x.org", "BOB", True), "bob"),
    (("ann lee", "", "", True), "ann"),
    (("Ann Lee", "", "zz", False), None), (("Same Name", "", "", True), None), (("Bob Ray", "same@x.org", "", True), "bob"),
    (("", "", "", True), None), (("", "", "007", False), "007"),
])  # fmt: skip
def test_a_row_of_the_worksheet_is_of_whom_its_mail_its_number_or_its_name_tells(row, student):
    rows = [WorksheetRow(1, "41", *row), WorksheetRow(2, "", "Bob Ray", "", "", True)]
    assert whose(handed_in("41", "Ann Lee"), "moodle", rows) == student
    assert whose(handed_in("42", "Ann Lee"), "moodle", rows) is None  # the worksheet has no such row
    found = match(ROSTER, [], "moodle", SimpleNamespace(rows=rows))
    assert {name: one.record for name, one in found.rows.items()} == {"bob": 2} | (
        {student: 1} if student not in {None, "bob"} else {}
    )


@pytest.mark.parametrize(("found", "platform", "student"), [
    (handed_in(own="ANN"), "folder", "ann"), (handed_in(own="zz", shared="bob"), "folder", "bob"),
    (handed_in(own="ann", shared="zz"), "folder", None),
    (handed_in(name="Ann Lee"), "folder", None), (handed_in(name="Ann Lee"), "moodle", "ann"),
    (handed_in(name="Same Name"), "moodle", None),
    (handed_in(), "moodle", None), (handed_in("bob"), "moodle", None), (handed_in("bob"), "canvas", "bob"),
    (handed_in("bob"), "folder", None),
    (handed_in(name="LeeAnn"), "canvas", "ann"), (handed_in(name="annlee"), "canvas", "ann"),
    (handed_in(name="samename"), "canvas", None),
    (handed_in(name="Ann Lee"), "canvas", None), (handed_in(name=None), "canvas", None),
    (handed_in("007", own="007", folder="x_007_assignsubmission_file"), "moodle", None),  # Moodle's number is nobody's id
    (handed_in("41", own="41", folder="bob"), "moodle", "bob"),
])  # fmt: skip
def test_without_a_worksheet_each_platform_knows_a_student_in_its_own_way(found, platform, student):
    assert whose(found, platform) == student


def test_all_that_one_hands_in_is_together():
    files = [handed_in(own="ann"), handed_in(own="zz"), handed_in(own="Ann")]
    found = match(ROSTER, files, "folder")
    assert found.file_lists == {"ann": (files[0], files[2])} and found.not_on_roster == (files[1],) and found.rows == {}
