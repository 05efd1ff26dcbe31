"""Names in a Canvas download, as its ContentZipper writes them: several files of one student, names handed in again, no names."""

from __future__ import annotations

from pathlib import Path

from tests.grading.collecting.test_sources import names, read, write


def test_canvas_numbers_each_file_of_a_submission(tmp_path: Path) -> None:
    """The third part is the number of the attachment; all that a download holds of one student is the last attempt."""
    write(tmp_path, "leeann_101_555_table.csv", "leeann_101_556_equations.txt", "leeann_101_text.html", "wuli_LATE_102_link.html")
    platform, found, file_lists = read(tmp_path)
    assert platform == "canvas"
    assert {student: names(submission) for student, submission in found.items()} == {
        "101": ["equations.txt", "table.csv", "text.html"], "102": ["link.html"],
    }  # fmt: skip
    assert [submission.review for submission in found.values()] == [None, None]
    assert [file_lists[student].late for student in ("101", "102")] == [False, True]


def test_canvas_numbers_a_name_that_was_handed_in_before(tmp_path: Path) -> None:
    """The file with the highest number is the last; without one that has no number the numbers are the student's."""
    write(tmp_path, *(f"leeann_101_{k}_table{again}.csv" for k, again in ((7, "-10"), (5, ""), (6, "-2"))))
    write(tmp_path, "leeann_101_8_equations-1.txt", "leeann_101_9_equations-2.txt", "leeann_101_10_table.txt")
    _, found, _ = read(tmp_path)
    assert names(found["101"]) == ["equations-1.txt", "equations-2.txt", "table-10.csv", "table.txt"]
    assert found["101"].review is None
    assert [note.text for note in found["101"].notes] == [
        f"{name} was ignored: table-10.csv was handed in later under the same name." for name in ("table-2.csv", "table.csv")
    ]


def test_canvas_without_names(tmp_path: Path) -> None:
    """An id of letters stands for name and number while marking is anonymous; all digits, it is nobody's number either."""
    write(tmp_path, "anon_aB3xY_777_table.csv", "anon_aB3xY_778_equations.txt", "LATE_anon_Qz9Kk_801_table.csv")
    write(tmp_path, "anon_12345_901_table.csv", "LATE_anon_Qz9Kk_text.html")
    platform, found, file_lists = read(tmp_path)
    assert platform == "canvas"
    assert {student: (names(found[student]), one.name, one.number, one.late) for student, one in file_lists.items()} == {
        "anon_12345": (["table.csv"], None, "", False), "anon_Qz9Kk": (["table.csv", "text.html"], None, "", True),
        "anon_aB3xY": (["equations.txt", "table.csv"], None, "", False),
    }  # fmt: skip
