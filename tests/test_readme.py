"""README.md says what is true: its commands run as written, its Python runs, its files exist."""

import csv
import os
import re
import shlex
import subprocess
import sys
import textwrap
import tomllib
import zipfile
from functools import partial
from pathlib import Path

from click.testing import CliRunner

import coursework
from coursework import mechanism
from coursework.assigning import ranges
from coursework.commands.cli import main
from coursework.results.accuracy import round_off
from coursework.results.accuracy.timing import seconds
from coursework.variant.reading import schema
from coursework.variant.reading.models import json_schema
from coursework.words import errors
from tests.grading.batch import classroom
from tests.grading.marking import students

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def commands_of(section):
    """Return the commands of the first block of a section, as written."""
    block = re.search(r"```sh\n(.*?)```", TEXT.partition(f"## {section}\n")[2], re.S)[1]
    return [line.split("#")[0].strip() for line in block.splitlines()]


COMMANDS = [*commands_of("For a student"), *commands_of("As a library")]


def test_commands_run_as_written_one_after_the_other(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    # Each trial of the study is timed once: no word of README hangs on how exactly.
    monkeypatch.setattr("coursework.results.accuracy.study.seconds", partial(seconds, repeats=1, shortest=0.0))
    # The finest steps of the curve of single precision are looked at in tests/results/accuracy.
    monkeypatch.setattr("coursework.results.accuracy.round_off.SUBSTEPS", round_off.SUBSTEPS[:5])
    for command in COMMANDS:
        words = shlex.split(command)
        assert words[0] == "coursework"
        result = CliRunner().invoke(main, words[1:])
        assert result.exit_code == 0, (command, result.output)
        assert result.output.strip(), command


def test_instructors_commands_run_from_a_download_of_moodle_to_grades(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    moodle_download(tmp_path)
    commands = commands_of("For an instructor")
    assert len(commands) == 3
    for command in commands:
        result = CliRunner().invoke(main, shlex.split(command)[1:])
        assert result.exit_code == 0, (command, result.output)
    sheet = (tmp_path / "marks" / "worksheet.csv").read_text(encoding="utf-8-sig").splitlines()
    assert sheet[1].startswith("Participant 1001,Ada Lovelace,ada@example.org,Submitted,100.00,100.00,")
    assert sheet[2].startswith("Participant 1002,Bert Brecht,bert@example.org,Submitted,80.00,100.00,")
    with zipfile.ZipFile(tmp_path / "marks" / "feedback.zip") as feedback:
        assert sorted(name.partition("/")[0] for name in feedback.namelist()) == [
            "Ada Lovelace_1001_assignsubmission_file", "Bert Brecht_1002_assignsubmission_file",
        ]  # fmt: skip
    assert (tmp_path / "marks" / "class.html").stat().st_size > 1000


def test_individual_variants_go_from_a_roster_to_grades(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "class.csv").write_text("id,name,email\nada,Ada Lovelace,ada@example.org\n", encoding="utf-8")
    commands = commands_of("Everyone a variant of their own")
    assert len(commands) == 3
    for command in commands:
        result = CliRunner().invoke(main, shlex.split(command)[1:])
        assert result.exit_code == 0, (command, result.output)
    (grade,) = csv.DictReader((tmp_path / "class" / "marks" / "grades.csv").read_text(encoding="utf-8-sig").splitlines())
    assert (grade["id"], grade["table"]) == ("ada", "60.00")


def test_the_example_of_a_ranges_file_can_be_drawn_from():
    example = textwrap.dedent(re.search(r"( {4}\[given\].*?)\nA draw", ranges.__doc__, re.S)[1])
    assert coursework.draw("31", tomllib.loads(example), 1, "ada").values["p"] in {12.5, 13.08}


def test_every_key_of_the_format_is_explained_beside_a_file_that_has_it():
    told = [line.rsplit(maxsplit=1)[1] for line in schema.__doc__.splitlines() if re.match(r" {4}\S", line)]
    assert len(told) >= 11
    assert all((ROOT / name).is_file() for name in told)
    sections = set(json_schema()["properties"]) - {"format", "title", "source", "$schema"}
    assert {name for name in sections if name not in schema.__doc__} == set()


def test_what_readme_says_elsewhere_is_there():
    """Words of the field, sources and changes stand in the rooms they speak of."""
    assert all(word in mechanism.__doc__ for word in ("Driven point", "Mobility", "Dead point", "Analog"))
    assert all(source in coursework.groups.__doc__ for source in ("Ponomarev", "Pasika", "[deck]", "[library]"))
    assert coursework.__version__ in coursework.__doc__.partition("Changes.")[2]
    letters = {
        code[0]
        for code in tomllib.loads((ROOT / "reports/words.en.toml").read_text(encoding="utf-8"))["fault"]
        if code[1:].isdigit()
    }
    assert letters == set(re.findall(r"\b([A-Z]) (?=a |ranges|the |data|grading|writing|limits|words)", errors.__doc__))


def test_it_stays_short():
    assert len(TEXT.splitlines()) <= 250
    first = TEXT.partition("## For a student")[0]
    assert len(first.splitlines()) <= 25
    assert re.search(r"!\[.*\]\(reports/moving.gif\)", first)


def test_own_templates_stand_before_those_of_the_package(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    section = TEXT.partition("`--templates DIR`")[2]
    (tmp_path / "looks").mkdir()
    (tmp_path / "looks" / "report.html.j2").write_text(re.search(r"```jinja\n(.*?)```", section, re.S)[1], encoding="utf-8")
    command = re.search(r"```sh\n(.*?)```", section, re.S)[1].strip()
    result = CliRunner().invoke(main, shlex.split(command)[1:])
    assert result.exit_code == 0, result.output
    for name in ("31", "v101"):
        page = (tmp_path / "coursework-runs" / name / "report.html").read_text(encoding="utf-8")
        assert page.index("Department of Mechanics, spring term") < page.index("<h1>")
        assert "Prof. B" in page
    assert (tmp_path / "coursework-runs" / "combined.pdf").read_bytes().startswith(b"%PDF")


def moodle_download(folder):
    """Two submissions and the worksheet as Moodle gives them, and the files that the commands of README name."""
    with zipfile.ZipFile(folder / "submissions.zip", "w") as download:
        for number, name, table in ((1001, "Ada Lovelace", students.table()), (1002, "Bert Brecht", students.slip(5, 0, 1.2))):
            top = f"{name}_{number}_assignsubmission_file"
            download.writestr(f"{top}/table.csv", classroom.csv(table))
            download.writestr(f"{top}/equations.txt", "\n".join(classroom.EQUATIONS))
    (folder / "worksheet.csv").write_text(
        "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (submission),"
        "Last modified (grade),Feedback comments\n"
        "Participant 1001,Ada Lovelace,ada@example.org,Submitted,,100.00,Yes,-,-,\n"
        "Participant 1002,Bert Brecht,bert@example.org,Submitted,,100.00,Yes,-,-,\n",
        encoding="utf-8-sig",
    )
    (folder / "rubric.toml").write_text("", encoding="utf-8")
    (folder / "decided.csv").write_text(
        "id,check,points,reason\nBert Brecht_1002_assignsubmission_file,total,80,explained in person\n", encoding="utf-8"
    )
    (folder / "table.csv").write_bytes(classroom.csv(students.table()))
    (folder / "equations.txt").write_text("\n".join(classroom.EQUATIONS), encoding="utf-8")


def test_lines_for_the_shell_are_what_the_shell_can_run():
    """Each line asks the tool for a script of completions, which names the tool."""
    lines = re.findall(r"_COURSEWORK_COMPLETE=(\w+)_source coursework", TEXT)
    assert lines == ["bash", "zsh", "fish"]
    for shell in lines:
        environment = {**os.environ, "_COURSEWORK_COMPLETE": f"{shell}_source"}
        code = "from coursework.commands.cli import main; main(prog_name='coursework')"
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
        assert "coursework" in done.stdout


def test_python_block(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    block = re.search(r"```python\n(.*?)```", TEXT, re.S)[1]
    exec(compile(block, "README.md", "exec"), {})
    assert (tmp_path / "report.html").stat().st_size > 10_000
    assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF")


def test_files_named_exist():
    for name in re.findall(r"`((?:variants|coursework|tests|reports)/[\w./-]+)`", TEXT):
        assert (ROOT / name).exists(), name
    for name in re.findall(r"\]\(([\w./-]+)\)", TEXT):
        assert (ROOT / name).exists(), name


def test_every_command_of_the_tool_is_there():
    for name in main.commands:
        assert re.search(rf"(?:^|`)coursework {name}\b", TEXT, re.M), name


def test_bootstrap_commands_are_those_of_the_gate():
    assert "python3 -m coursework.bootstrap run 31" in TEXT
    assert "python3 -m coursework.bootstrap test" in TEXT
    assert "python3 -m coursework.bootstrap test" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
