"""Own templates and one PDF for several variants: what stands in, what falls back, what is refused."""

from __future__ import annotations

from pathlib import Path

import pymupdf
import pytest
from click.testing import CliRunner, Result

from coursework.commands.cli import main
from coursework.words.custom_templates import templates_of
from coursework.words.data_folders import folder
from coursework.words.errors import InputError
from coursework.words.sentences import load_phrases
from tests.grading.batch.classroom import hand_in

PLAIN = folder("reports")


def run(*words: object) -> Result:
    return CliRunner().invoke(main, ["run", *map(str, words)])


@pytest.mark.long
def test_a_piece_stands_in_and_the_others_fall_back(tmp_path: Path) -> None:
    looks = tmp_path / "looks"
    looks.mkdir()
    (looks / "report.css").write_text("body { color: #123456 }")
    typ = (PLAIN / "report.typ").read_text(encoding="utf-8")
    (looks / "report.typ").write_text(typ + "\n#text[the last word is mine]\n", encoding="utf-8")
    before = {path: path.read_bytes() for path in PLAIN.rglob("*") if path.is_file()}
    options = ("--quantities", "table,checks", "--format", "html,pdf")
    assert run("31", "--templates", looks, "--out", tmp_path / "own", *options).exit_code == 0
    page = (tmp_path / "own" / "report.html").read_text(encoding="utf-8")
    assert "#123456" in page
    assert "<h1>" in page  # the template is still the package's
    assert "the last word is mine" in pymupdf.open(tmp_path / "own" / "report.pdf")[-1].get_text()
    assert run("31", "--out", tmp_path / "plain", *options).exit_code == 0
    assert "#123456" not in (tmp_path / "plain" / "report.html").read_text(encoding="utf-8")
    stamps = [next(line for line in (tmp_path / name / "run.json").read_text().splitlines() if "stamp" in line) for name in
              ("own", "plain")]  # fmt: skip
    assert stamps[0] != stamps[1]
    assert {path: path.read_bytes() for path in PLAIN.rglob("*") if path.is_file()} == before
    assert folder("reports") == PLAIN


@pytest.mark.parametrize(
    ("files", "told"),
    [
        (None, "there is no such folder of templates"), ({}, "no file in it has the name of a piece"),
        ({"report.htm.j2": ""}, 'Did you mean "report.html.j2"?'), ({"report.css": "a" * (4 * 2**20 + 1)}, "at most 4 MiB"),
    ],
)  # fmt: skip
def test_what_cannot_be_meant_is_refused_before_anything_is_computed(
    tmp_path: Path, files: dict[str, str] | None, told: str
) -> None:
    looks = tmp_path / "looks"
    for name, text in (files or {}).items():
        looks.mkdir(exist_ok=True)
        (looks / name).write_text(text)
    if files == {}:
        looks.mkdir()
    found = run("31", "--templates", looks, "--out", tmp_path / "out")
    assert found.exit_code == 2
    assert told in found.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("words", [["--language", "ru"], ["--language=ru"]])
def test_a_folder_that_is_missing_is_told_in_the_language_of_the_command(words: list[str]) -> None:
    assert "такой папки шаблонов нет" in run("31", "--templates", "nowhere", *words).stderr


BROKEN = {
    "a tag that is none": ({"parts.html.j2": "a\n{% broken"}, "parts.html.j2:2"),
    "a gap nothing fills": ({"report.html.j2": "\n{{ page.nothing.at }}"}, "report.html.j2:2"),
    "a sum that fails": (
        {"report.html.j2": '{% extends "package/report.html.j2" %}{% block header %}\n{{ 1/0 }}{% endblock %}'},
        "report.html.j2:2",
    ),
    "a part another needs": ({"parts.html.j2": "{% macro other() %}{% endmacro %}"}, "parts.html.j2"),
    "letters of another encoding": ({"report.css": "\n\xe9"}, "report.css:2"),
    "words that are no TOML": ({"words.en.toml": "x = ["}, "words.en.toml"),
    "a bracket for Typst": ({"runs.typ": "\n#let x = ("}, "runs.typ:2"),
}  # fmt: skip


@pytest.mark.parametrize("case", BROKEN)
@pytest.mark.parametrize("kind", ["html", "pdf"])
def test_a_piece_that_does_not_work_is_told_by_its_name_and_line(tmp_path: Path, case: str, kind: str) -> None:
    files, place = BROKEN[case]
    looks = tmp_path / "looks"
    looks.mkdir()
    for name, text in files.items():
        (looks / name).write_text(text, encoding="latin-1")
    done = run("31", "--templates", looks, "--quantities", "table,checks", "--format", kind, "--out", tmp_path / "out")
    if kind == "pdf" and case in {"a gap nothing fills", "a sum that fails", "a part another needs"}:
        assert done.exit_code == 0  # a page for the screen is not needed there
        return
    assert done.exit_code == 2, done.output
    assert place in done.stderr
    assert "fault of the tool" not in done.stderr


def test_own_words_need_only_be_those_that_are_changed(tmp_path: Path) -> None:
    looks = tmp_path / "looks"
    looks.mkdir()
    (looks / "words.en.toml").write_text('[title]\nkind = "Coursework of our department"\n', encoding="utf-8")
    done = run("31", "--templates", looks, "--quantities", "table", "--format", "html", "--out", tmp_path / "out")
    assert done.exit_code == 0, done.output
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Coursework of our department" in page
    assert "Statement" in page


def test_a_language_of_ones_own_may_stand_among_the_pieces(tmp_path: Path) -> None:
    looks = tmp_path / "looks"
    looks.mkdir()
    (looks / "words.de.toml").write_text(
        'plural = "one-other"\n[title]\nkind = "Kinematik eines ebenen Getriebes"\n', encoding="utf-8"
    )
    options = ("--language", "de", "--quantities", "table", "--format", "html", "--out", tmp_path / "out")
    assert run("31", "--templates", looks, *options).exit_code == 0
    assert "Kinematik eines ebenen Getriebes" in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")


def test_a_words_file_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    (tmp_path / "words.de.toml").write_text("x = [", encoding="utf-8")
    with templates_of(tmp_path), pytest.raises(InputError, match=r"L003 words\.de\.toml cannot be read"):
        load_phrases("de")


def test_a_piece_of_four_mib_is_taken(tmp_path: Path) -> None:
    (tmp_path / "report.css").write_text("a" * (4 * 2**20))
    assert run("31", "--templates", tmp_path, "--quantities", "table", "--plan").exit_code == 0


def test_several_variants_are_one_pdf_each_with_pages_of_its_own(tmp_path: Path) -> None:
    options = ("--student", "Ada", "--teacher", "Prof. B", "--institution", "Our university", "--quantities", "table")
    bad = tmp_path / "bad.toml"
    bad.write_text("format = 1\n")
    done = run("31", bad, "example-1", *options, "--combined", "--format", "csv", "--out", tmp_path / "out")
    assert done.exit_code == 2  # the faulty file stops none of the others
    document = pymupdf.open(tmp_path / "out" / "combined.pdf")
    firsts = [page.number for page in document if "Kinematic analysis" in page.get_text()[:60]]
    assert len(firsts) == 2
    counts = [firsts[1], len(document) - firsts[1]]
    for first, count in zip(firsts, counts, strict=True):
        for number in range(count):
            assert f"{number + 1} / {count}" in document[first + number].get_text()
        assert all(word in document[first].get_text() for word in ("Ada", "Prof. B", "Our university"))
    assert document.metadata["title"].count(";") == 1
    assert not (tmp_path / "out" / "31" / "report.pdf").exists()
    assert "combined.pdf" in done.output


@pytest.mark.long
def test_the_same_bytes_from_processes_of_their_own(tmp_path: Path) -> None:
    (tmp_path / "looks").mkdir()
    (tmp_path / "looks" / "report.css").write_text("body { color: #123456 }")
    for jobs in (1, 2):
        options = ("--templates", tmp_path / "looks", "--quantities", "table", "--combined", "--format", "html")
        done = run("31", "example-1", *options, "--jobs", jobs, "--out", tmp_path / str(jobs))
        assert done.exit_code == 0, done.output
    for name in ("combined.pdf", "31/report.html", "example-1/report.html"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "2" / name).read_bytes()
    assert "#123456" in (tmp_path / "2" / "31" / "report.html").read_text(encoding="utf-8")


def test_own_templates_come_and_go_in_one_process(tmp_path: Path) -> None:
    (tmp_path / "report.css").write_text("mine")
    with templates_of(tmp_path):
        inside = folder("reports")
        assert (inside / "report.css").read_text() == "mine"
        assert (inside / "package" / "report.css").read_bytes() == (PLAIN / "report.css").read_bytes()
        with templates_of(None):
            assert folder("reports") == inside
    assert not inside.exists()


@pytest.mark.long
def test_feedback_pages_of_a_class_take_own_pieces_and_a_change_of_them_is_marked_anew(tmp_path: Path) -> None:
    hand_in(tmp_path / "in" / "ada")
    looks = tmp_path / "looks"
    looks.mkdir()
    own = (PLAIN / "feedback.html.j2").read_text(encoding="utf-8").replace("<header>", "<header><p>Kafedra</p>")
    command = ["grade", str(tmp_path / "in"), "--variant", "31", "--out", str(tmp_path / "out"), "--jobs", "1"]
    for pieces, words, fresh in (
        ({"feedback.html.j2": own}, "Kafedra", 1),
        ({"feedback.css": "body{color:#123456}"}, "#123456", 1),
    ):
        for name, text in pieces.items():
            (looks / name).write_text(text, encoding="utf-8")
        done = CliRunner().invoke(main, [*command, "--templates", str(looks)])
        assert done.exit_code == 0, done.output
        assert f"Marked now: {fresh}" in done.output
        assert words in (tmp_path / "out" / "feedback" / "ada.html").read_text(encoding="utf-8")
    assert "#123456" in (tmp_path / "out" / "class.html").read_text(encoding="utf-8")
    assert "Marked now: 0" in CliRunner().invoke(main, [*command, "--templates", str(looks)]).output
