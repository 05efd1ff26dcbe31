"""`coursework new`: what it writes runs as it is, and nothing that exists is touched."""

import re
import tomllib
from pathlib import Path

import pytest

import coursework
from coursework.variant.catalogue import names
from coursework.words.data_folders import folder as data_folder
from tests.commands.test_cli import QUICK, call
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("folder")


def test_the_template_runs_as_it_is(folder):
    result = call("new", "mine.toml")
    told = "mine.toml is written. Fill it in with any text editor, then: coursework run mine\n"
    assert (result.exit_code, result.stdout) == (0, told)
    ran = call("run", "mine")
    assert ran.exit_code == 0, ran.output
    assert sorted(path.name for path in (folder / "coursework-mine").iterdir()) == [
        "report.html", "report.pdf", "run.json", "table.csv",
    ]  # fmt: skip
    page = (folder / "coursework-mine" / "report.html").read_text(encoding="utf-8")
    assert 'id="graph-check"' in page or "Graph-analytical check" in page
    checked = call("check", "mine")
    assert "W = 3·3 − 2·3 − 1 = 2, as many as the 2 freedoms driven." in checked.stdout


def test_the_template_passes_every_check_and_follows_its_exact_motion():
    call("new", "mine")
    run = coursework.solve("mine")
    assert [check.code for check in run.checks if check.verdict not in {"PASS", "SKIP"}] == []
    ranges = run.exact.rows.max(axis=0) - run.exact.rows.min(axis=0)
    assert (abs(run.motion.rows - run.exact.rows) <= 0.05 * ranges).all()


def test_a_name_in_the_template_is_the_new_one():
    call("new", "Кривошип-7")
    text = Path("Кривошип-7.toml").read_text(encoding="utf-8")
    assert "NAME" not in text
    assert coursework.load("Кривошип-7").title == "Кривошип-7"


@pytest.mark.parametrize("name", sampled(names()))
def test_a_copy_is_the_same_variant_with_its_tables(name, folder):
    assert call("new", "mine", "--from", name).exit_code == 0
    copy, original = coursework.load("mine"), coursework.load(name)
    assert copy.name == "mine"
    for part in ("title", "given", "drive", "coordinates", "functions", "time", "points", "ask"):
        assert getattr(copy, part) == getattr(original, part), part
    assert "#:schema" not in (folder / "mine.toml").read_text(encoding="utf-8")


def test_a_copy_of_a_tabulated_variant_runs_where_it_is(folder):
    result = call("new", "mine", "--from", "variable-crank-table")
    assert result.stdout.startswith("mine.toml and variable-crank-table.csv are written.")
    assert call("run", "mine", *QUICK).exit_code == 0
    # A second copy finds the table of the first, which is the same.
    assert call("new", "other", "--from", "mine").exit_code == 0
    (folder / "variable-crank-table.csv").write_text("my own nodes", encoding="utf-8")
    again = call("new", "third", "--from", "variable-crank-table")
    assert again.exit_code == 2
    assert "variable-crank-table.csv exists already and is left as it is." in again.stderr
    assert not (folder / "third.toml").exists()


@pytest.mark.long
@pytest.mark.parametrize("more", [(), ("--groups", "crank,RRR")])
def test_the_page_of_an_unedited_file_has_no_text_of_the_template(more, folder):
    assert call("new", "mine", *more).exit_code == 0
    result = call("run", "mine", "--quantities", "table", "--format", "html", "--out", "out")
    assert result.exit_code in (0, 1), result.output
    page = Path("out/report.html").read_text(encoding="utf-8")
    assert "Task sheet" not in page and "book, page" not in page and "mine: mine" not in page


def test_what_exists_is_left_alone():
    Path("mine.toml").write_text("my work", encoding="utf-8")
    for more in ([], ["--from", "31"]):
        again = call("new", "mine", *more)
        assert again.exit_code == 2
        assert "mine.toml exists already and is left as it is." in again.stderr
    assert Path("mine.toml").read_text(encoding="utf-8") == "my work"


def test_a_faulty_file_is_not_copied():
    Path("faulty.toml").write_bytes((data_folder("variants") / "31.toml").read_bytes().replace(b"r1*w1", b"r9*w1"))
    result = call("new", "mine", "--from", "faulty")
    assert result.exit_code == 2
    assert "r9" in result.stderr
    assert not Path("mine.toml").exists()


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_the_template_speaks_the_language_asked(language):
    english = (data_folder("reports") / "new-variant.toml").read_text(encoding="utf-8").replace("NAME", "mine")
    assert call("new", "mine", "--language", language).exit_code == 0
    text = Path("mine.toml").read_text(encoding="utf-8")
    data, original = tomllib.loads(text), tomllib.loads(english)
    for ours, theirs in zip(data.pop("constraint"), original.pop("constraint"), strict=True):
        assert ours.pop("because") != theirs.pop("because")
        assert ours == theirs
    assert data == original
    # A remark that names nothing but letters is the same in every language.
    remarks = [line.partition("# ")[2] for line in english.splitlines() if "# " in line]
    assert [remark for remark in remarks if re.search("[a-z]{3}", remark) and f"# {remark}\n" in f"{text}\n"] == []
    ran = call("run", "mine", *QUICK)
    assert ran.exit_code == 0, ran.output


def test_the_language_of_the_environment_is_that_of_the_template(monkeypatch):
    monkeypatch.setenv("COURSEWORK_LANGUAGE", "uk")
    call("new", "mine")
    assert "# найбільша швидкість M\n" in Path("mine.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(("language", "told"), [
    ("en", "own.toml is written. Next: coursework run own"), ("ru", "own.toml записан. Дальше: coursework run own"),
    ("uk", "own.toml записано. Далі: coursework run own"), ("zh", "已写出 own.toml。下一步：coursework run own"),
])  # fmt: skip
def test_who_has_set_the_data_is_told_what_comes_next(language, told):
    assert call("new", "own", "--from", "31", "--set", "r1=0.91m", "--language", language).stdout.strip() == told
