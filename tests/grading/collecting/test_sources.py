"""Folders and downloads: whose file is whose, and what is never opened."""

from __future__ import annotations

import io
import os
import unicodedata
import zipfile
from pathlib import Path

import pytest

from coursework.grading.collecting.file_lists import FileList
from coursework.grading.collecting.sources import Source, _walk, collect_files, collect_one, files_below
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.submission import Note, Submission
from coursework.words.errors import InputError


def write(folder: Path, *names: str, content: bytes = b"x") -> None:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def read(path: Path) -> tuple[str, dict[str, Submission], dict[str, FileList]]:
    with Source(path) as source:
        return source.platform, {p.id: source.collect(p) for p in source.file_lists}, {p.id: p for p in source.file_lists}


def names(submission: Submission) -> list[str]:
    return [file.name for file in submission.files]


def test_a_folder_of_folders(tmp_path: Path) -> None:
    write(
        tmp_path,
        "ivanov/table.csv",
        "ivanov/more/equations.txt",
        "ivanov/.hidden",
        "ivanov/~$t.xlsx",
        "petrov/Thumbs.db",
        "rubric.toml",
    )
    write(tmp_path, "ivanov/__MACOSX/x.csv", "ivanov/desktop.ini")
    (tmp_path / "empty").mkdir()
    platform, found, _ = read(tmp_path)
    assert platform == "folder"
    assert {student: names(submission) for student, submission in found.items()} == {
        "empty": [], "ivanov": ["more/equations.txt", "table.csv"], "petrov": [],
    }  # fmt: skip


def test_a_student_s_folder_may_be_named_like_a_file(tmp_path: Path) -> None:
    """Inside it, and in the folder of one submission, a folder of that name is none of the files."""
    write(tmp_path, "x.numbers/table.csv", "y.xlsx/table.csv/a.txt", "z.docx/more/equations.txt")
    _, found, _ = read(tmp_path)
    assert {student: names(submission) for student, submission in found.items()} == {
        "x.numbers": ["table.csv"], "y.xlsx": [], "z.docx": ["more/equations.txt"],
    }  # fmt: skip
    assert "table.csv" in found["y.xlsx"].notes[0].text
    assert names(collect_one(tmp_path)) == ["z.docx/more/equations.txt"]


def test_a_flat_folder(tmp_path: Path) -> None:
    write(tmp_path, "ivanov_table.csv", "ivanov_equations_2.txt", "petrov.csv", "petrov (1).csv", "Ідзик.xlsx")
    platform, found, _ = read(tmp_path)
    assert platform == "flat"
    assert {student: names(submission) for student, submission in found.items()} == {
        "ivanov": ["ivanov_equations_2.txt", "ivanov_table.csv"], "petrov": ["petrov (1).csv", "petrov.csv"],
        "Ідзик": ["Ідзик.xlsx"],
    }  # fmt: skip


MOODLE = [
    "Іван Франко_7000_assignsubmission_file/table.csv", "Іван Франко_7000_assignsubmission_onlinetext/onlinetext.html",
    "Participant_7001_assignsubmission_file_/x.csv", "Team one_12_assignsubmission_file/deep/x.csv",
    "Ann Lee_7002_assignsubmission_file_my_table.csv", "Ann Lee_7002_assignsubmission_file_~$my_table.xlsx", "readme.txt",
    "Ann Lee_7002_assignsubmission_file_.hidden.csv",
]  # fmt: skip


@pytest.mark.parametrize("as_zip", [False, True])
def test_moodle_in_all_its_forms(tmp_path: Path, as_zip: bool) -> None:
    path = tmp_path / "in"
    if as_zip:
        path = tmp_path / "download.zip"
        with zipfile.ZipFile(path, "w") as file:
            for name in MOODLE:
                file.writestr(name, b"x")
    else:
        write(path, *MOODLE)
    platform, found, file_lists = read(path)
    assert platform == "moodle"
    assert {student: (file_lists[student].name, file_lists[student].number, names(found[student])) for student in found} == {
        "7000": ("Іван Франко", "7000", ["onlinetext.html", "table.csv"]),
        "7001": (None, "7001", ["x.csv"]),
        "12": ("Team one", "12", ["deep/x.csv"]),
        "7002": ("Ann Lee", "7002", ["my_table.csv"]),
    }
    assert file_lists["7002"].folder == "Ann Lee_7002_assignsubmission_file"


def test_canvas(tmp_path: Path) -> None:
    write(
        tmp_path,
        "leeann_101_2001_table.csv",
        "leeann_101_2001_eq-1.txt",
        "ivanovivan_LATE_102_2002_my_table.csv",
        "ivanovivan_LATE_102_2002_~$my_table.xlsx",
    )
    platform, found, file_lists = read(tmp_path)
    assert platform == "canvas"
    assert {student: (file_lists[student].name, names(found[student])) for student in found} == {
        "101": ("leeann", ["eq-1.txt", "table.csv"]), "102": ("ivanovivan", ["my_table.csv"]),
    }  # fmt: skip
    write(tmp_path, "leeann_101_2009_table.csv")
    _, again, _ = read(tmp_path)
    assert again["101"].review is not None
    assert "2001 and 2009" in again["101"].review


def test_ids_that_a_system_takes_for_one_need_a_person(tmp_path: Path) -> None:
    path = tmp_path / "class.zip"
    with zipfile.ZipFile(path, "w") as file:
        for name in (
            "Anna/t.csv",
            "anna/t.csv",
            "ivan/t.csv",
            "ivan (1)/t.csv",
            "zoe/t.csv",
            f"{unicodedata.normalize('NFD', 'Zoë')}/t.csv",
        ):
            file.writestr(name, b"x")
        file.writestr("../../evil/t.csv", b"x")
    _, found, _ = read(path)
    assert {student: submission.review is not None for student, submission in found.items()} == {
        "Anna": True, "anna": True, "ivan": True, "ivan (1)": True, "zoe": False, "Zoë": False,
    }  # fmt: skip


def test_a_zip_from_an_old_russian_program(tmp_path: Path) -> None:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as file:
        file.writestr("xxxxxx/tabl.csv", b"x")
        file.writestr("yy/tabl.csv", b"x")
    raw = content.getvalue().replace(b"xxxxxx", "Иванов".encode("cp866"))
    path = tmp_path / "class.zip"
    path.write_bytes(raw)
    _, found, _ = read(path)
    assert set(found) == {"Иванов", "yy"}


def test_names_falsely_marked_as_utf_8_are_those_of_an_old_russian_program(tmp_path: Path) -> None:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as file:
        for name in ("жжж", "Пётр", "xx", "ююю"):
            file.writestr(f"{name}/tabl.csv", name)
    raw = content.getvalue()
    for name, other in (("жжж/", "Иванов/"), ("ююю/", "Сидоро/")):
        raw = raw.replace(name.encode(), other.encode("cp866"))
    path = tmp_path / "class.zip"
    path.write_bytes(raw)
    assert set(read(path)[1]) == {"Иванов", "Пётр", "xx", "Сидоро"}


def test_a_part_without_a_name_is_left_out() -> None:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as file:
        file.writestr("table.csv", b"t,w1")
        file.writestr("named.csv", b"x")
    damaged = content.getvalue().replace(b"named.csv", b"\0amed.csv")
    archive = Archive(damaged)
    assert {name: archive.read(name, 10) for name in archive.parts} == {"table.csv": b"t,w1"}


def test_a_folder_around_the_whole_zip_is_taken_off(tmp_path: Path) -> None:
    path = tmp_path / "class.zip"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("Group 21/ivanov/table.csv", b"x")
        file.writestr("Group 21/petrov/table.csv", b"x")
        file.writestr("__MACOSX/Group 21/ivanov/._table.csv", b"x")
    assert set(read(path)[1]) == {"ivanov", "petrov"}
    with zipfile.ZipFile(path, "a") as file:  # a zip that names its folders has those in which nothing was handed in, too
        for folder in ("Group 21/", "Group 21/ivanov/", "Group 21/ivanov/more/", "Group 21/sidorov/", "__MACOSX/"):
            file.mkdir(folder)
    assert {student: names(each) for student, each in read(path)[1].items()} == {
        "ivanov": ["table.csv"], "petrov": ["table.csv"], "sidorov": [],
    }  # fmt: skip


@pytest.mark.skipif(os.name != "posix", reason="elsewhere links need rights that students do not have")
def test_a_link_among_files_of_everybody_is_told_its_student(tmp_path: Path) -> None:
    write(tmp_path, "ivanov_table.csv")
    (tmp_path / "petrov_table.csv").symlink_to(tmp_path / "ivanov_table.csv")
    platform, found, _ = read(tmp_path)
    assert platform == "flat" and [len(each.files) for each in found.values()] == [1, 0]
    assert [note.code for note in [*found.values()][1].notes] == ["ignored_file"]


def test_only_regular_files_are_opened(tmp_path: Path) -> None:
    secret = tmp_path / "secret.csv"
    secret.write_bytes(b"key")
    folder = tmp_path / "in" / "one"
    write(folder, "good.txt", "table.csv/inner.txt")
    os.link(secret, folder / "hard.csv")
    aside = ["hard.csv", "table.csv"]
    if os.name == "posix":  # elsewhere links need rights that students do not have, and there are no pipes in folders
        (folder / "link.csv").symlink_to(secret)
        (folder / "away").symlink_to(tmp_path)
        os.mkfifo(folder / "pipe.csv")
        aside += ["away", "link.csv", "pipe.csv"]
    _, found, _ = read(tmp_path / "in")
    assert names(found["one"]) == ["good.txt"]
    assert sorted(str(note.text).partition(" ")[0].removeprefix("one/") for note in found["one"].notes) == sorted(aside)
    assert {note.code for note in found["one"].notes} == {"ignored_file"}
    assert names(collect_one(folder)) == ["good.txt"]


def test_a_folder_that_cannot_be_opened_is_told_by_its_name(tmp_path: Path) -> None:
    """The one that is given by its own name, one inside by its place; both are gone before they are opened."""
    assert [name for name, _ in files_below(tmp_path / "gone")] == [""]
    ((_, alone),) = files_below(tmp_path / "gone")
    ((_, inside),) = _walk(tmp_path / "gone", "ivanov/work/", 2)
    assert isinstance(alone, Note) and isinstance(inside, Note)
    assert (str(alone.text).partition(" ")[0], str(inside.text).partition(" ")[0]) == ("gone", "ivanov/work/")


def test_sizes_are_bounded_before_anything_is_read(tmp_path: Path) -> None:
    folder = tmp_path / "in" / "one"
    write(folder, "edge.csv", content=b"1" * 4 * 2**20)
    write(folder, "over.csv", content=b"1" * (4 * 2**20 + 1))
    with (folder / "huge.csv").open("wb") as file:
        file.truncate(2**31)
    submission = read(tmp_path / "in")[1]["one"]
    assert {file.name: (file.size, len(file.content), file.trouble is None) for file in submission.files} == {
        "edge.csv": (4 * 2**20, 4 * 2**20, True), "over.csv": (4 * 2**20 + 1, 4096, False), "huge.csv": (2**31, 4096, False),
    }  # fmt: skip


def test_a_submission_has_at_most_fifty_files_and_twenty_megabytes(tmp_path: Path) -> None:
    write(tmp_path / "in" / "many", *(f"{k:02}.csv" for k in range(60)))
    write(tmp_path / "in" / "large", *(f"{k}.csv" for k in range(6)), content=b"1" * 4 * 2**20)
    found = read(tmp_path / "in")[1]
    assert len(found["many"].files) == 50
    assert [note.code for note in found["many"].notes] == ["ignored_file"]
    assert [file.trouble is None for file in found["large"].files] == [True] * 5 + [False]


def test_a_source_that_is_none_is_refused(tmp_path: Path) -> None:
    (tmp_path / "x.zip").write_bytes(b"no zip")
    for path in (tmp_path / "x.zip", tmp_path / "nowhere"):
        with pytest.raises(InputError, match=str(path.name)):
            Source(path)
    for collected, code in ((lambda: collect_one(path), "G004"), (lambda: collect_files([path]), "G005")):
        with pytest.raises(InputError, match=f"{code} .*nowhere"):
            collected()


@pytest.mark.parametrize(("deep", "is_read"), [(5, True), (6, False)])
def test_folders_are_opened_five_deep(tmp_path: Path, deep: int, is_read: bool) -> None:
    write(tmp_path, "/".join([*"abcdef"[:deep], "t.csv"]))
    found = collect_one(tmp_path)
    assert (names(found), len(found.notes)) == (["a/b/c/d/e/t.csv"] if is_read else [], 0 if is_read else 1)


@pytest.mark.parametrize(("students", "beside", "told"), [
    ("Ada Byron_1001_assignsubmission_file", "Late Student/table.csv", "differently: Late Student. Rename"),  # sent by mail
    ("ada", "late.csv", "no student’s folder: late.csv"),
])  # fmt: skip
def test_what_belongs_to_nobody_is_told(tmp_path: Path, students: str, beside: str, told: str) -> None:
    write(tmp_path, f"{students}/table.csv")
    with Source(tmp_path) as source:
        assert source.remarks == []
    write(tmp_path, beside)
    with Source(tmp_path) as source:
        (remark,) = source.remarks
    assert told in str(remark)
    write(tmp_path, *(f"{place}-{beside}" for place in range(12)))
    with Source(tmp_path) as source:
        assert str(source.remarks[0]).count("-") == 8 and "…" in str(source.remarks[0])
