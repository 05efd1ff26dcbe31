"""Names of files that no system misreads, and text that no spreadsheet takes for a formula."""

from __future__ import annotations

import pytest

from coursework.grading.platforms.escapes import shown, text_cell
from coursework.grading.platforms.names import file_stem


@pytest.mark.parametrize(
    ("student", "is_itself"),
    [
        ("ivanov", True), ("a.b@c-d_1", True), ("x" * 64, True), ("x" * 65, False), ("../../x", False), ("/etc/passwd", False),
        ("a/b", False), (".", False), ("..", False), ("ivanov.", False), ("CON", False), ("con.txt", False), ("COM1", False),
        ("lpt9.csv", False), ("COMA", True), ("a\nb", False), ("a\u202eb", False), ("a\u200bb", False), ("", False),
        ("Іван", False),
        ("x" * 300, False), ("\ud800", False),
        ("-x", False), ("_x", False),
    ],
)  # fmt: skip
def test_names_of_files_made_from_ids(student: str, is_itself: bool) -> None:
    stem = file_stem(student)
    assert (stem == student) is is_itself
    if not is_itself:
        assert stem.startswith("x-")
        assert len(stem) == 18


FORMULAS = [
    "=1+1", "+cmd|'/c calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "\0=1", "＝1", "＋1", "－1", "＠1", "  =1", '"=1',
    "' =1",
]  # fmt: skip


@pytest.mark.parametrize("text", FORMULAS)
def test_no_text_becomes_a_formula(text: str) -> None:
    assert text_cell(text) == "'" + text


def test_harmless_text_stays_and_hidden_letters_show() -> None:
    assert text_cell("Іван О'Ніл =") == "Іван О'Ніл ="
    assert shown("a\u202eb\u200bc\x07\n") == "a⟨U+202E⟩b⟨U+200B⟩c⟨U+0007⟩\n"
