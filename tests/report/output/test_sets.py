"""The files of a run are one set: complete with its record, or told as unfinished; nothing hidden stays behind."""

import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pymupdf
import pytest

import coursework
from coursework.report.output.record import stamp_of
from coursework.system.files import file_set
from coursework.system.files.file_set import files_of, publish, working_folder
from coursework.words.errors import OutputError
from tests.command import call

pytestmark = pytest.mark.usefixtures("folder")
CSV = ["--quantities", "table,checks", "--format", "csv"]
# The same command as a process that ends the way power fails: at the n-th move of a file, without any cleaning up.
KILLED = """
import os, pathlib, sys
move, moves = pathlib.Path.replace, []
def replace(self, target):
    moves.append(target)
    if len(moves) == {at}:
        os._exit(9)
    return move(self, target)
pathlib.Path.replace = replace
from coursework.commands.cli import main
main({arguments!r})
"""


def killed(at: int, *arguments: str) -> None:
    code = KILLED.format(at=at, arguments=list(arguments))
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=False).returncode == 9


def record_of(place: Path) -> dict:
    return json.loads((place / "run.json").read_text(encoding="utf-8"))


def digests(place: Path, names) -> dict:
    return {name: hashlib.sha256((place / name).read_bytes()).hexdigest() for name in names}


def test_the_record_names_every_file_and_the_pages_bear_its_stamp():
    assert call("run", "31", "--quantities", "table,checks", "--out", "o").exit_code == 0
    record = record_of(Path("o"))
    assert list(record["files"]) == ["report.html", "report.pdf", "table.csv"]
    assert record["files"] == digests(Path("o"), record["files"])
    assert re.fullmatch("[0-9a-f]{16}", record["stamp"])
    footer = f"coursework {coursework.__version__} · {record['stamp']}"
    assert f"<footer>{footer}</footer>" in Path("o/report.html").read_text(encoding="utf-8")
    with pymupdf.open("o/report.pdf") as pages:
        assert all(footer in page.get_text() for page in pages)


def test_the_stamp_follows_variant_options_and_version_alone(folder, monkeypatch):
    def stamp(**options):
        return stamp_of(coursework.solve(options.pop("variant", "31"), **options))

    plain = stamp()
    copy = folder / "31.toml"
    copy.write_bytes(coursework.load("31").path.read_bytes())
    assert stamp(variant=copy) == plain
    forces = coursework.load("31-forces").path.read_text(encoding="utf-8")
    other = forces.replace('mass = "6 kg"', 'mass = "7 kg"', 1)
    assert other != forces
    others = [
        *(stamp(variant=coursework.parse_variant(text)) for text in (forces, other)),
        stamp(variant="v108"), stamp(scheme="heun"), stamp(step=0.01), stamp(end=0.4), stamp(quantities=["table"]),
        stamp(student="A"), stamp(group="A"), stamp(date="A"), stamp(project=1), stamp(gain=1.0), stamp(quantities=["phi3"]),
        stamp_of(coursework.solve("31"), "uk"),
    ]  # fmt: skip
    monkeypatch.setattr("coursework.scene.scene_run.VERSION", "9.9.9")
    assert len({plain, stamp(), *others}) == len(others) + 2


def test_the_stamp_is_the_same_in_every_process():
    code = (
        "import coursework; from coursework.report.output.record import stamp_of; print(stamp_of(coursework.solve('example-6')))"
    )
    seed = {**os.environ, "PYTHONHASHSEED": "1" if os.environ.get("PYTHONHASHSEED") != "1" else "2"}
    said = subprocess.run([sys.executable, "-c", code], env=seed, capture_output=True, text=True, check=True).stdout
    assert said.strip() == stamp_of(coursework.solve("example-6"))


@pytest.mark.parametrize("at", [1, 2])
def test_a_killed_run_leaves_no_record_and_the_next_one_clears_up(at, folder):
    assert call("run", "31", *CSV, "--out", "o").exit_code == 0
    before = Path("o/table.csv").read_bytes()
    killed(at, "run", "v108", "--quantities", "table,checks", "--format", "csv", "--out", "o")
    assert not Path("o/run.json").exists()
    assert (Path("o/table.csv").read_bytes() == before) is (at == 1)
    assert any(path.name.startswith(".") for path in Path("o").iterdir())
    again = call("run", "31", *CSV, "--out", "o")
    assert "o held an unfinished set: an earlier run was ended before it had written its run.json." in again.stdout
    assert sorted(path.name for path in Path("o").iterdir()) == ["run.json", "table.csv"]
    assert record_of(Path("o"))["files"] == digests(Path("o"), ["table.csv"])
    assert "unfinished" not in call("run", "31", *CSV, "--out", "o").stdout


def test_a_run_that_still_works_keeps_its_hidden_folder(folder):
    with working_folder(folder) as first:
        (first / "half").write_text("x", encoding="utf-8")
        with working_folder(folder) as second:
            assert first.is_dir()
            assert first != second
        assert (first / "half").read_text(encoding="utf-8") == "x"
    assert list(folder.iterdir()) == []


def test_scratch_lies_in_the_hidden_folder_and_goes_with_it(folder):
    before = tempfile.gettempdir()
    with working_folder(folder / "o") as hidden:
        scratch = Path(tempfile.mkdtemp())
        assert scratch.parent == hidden.absolute()
    assert tempfile.gettempdir() == before
    assert list(folder.iterdir()) == []


def test_a_process_leaves_no_scratch_in_the_folder_for_temporary_files(folder):
    scratch = folder / "scratch"
    scratch.mkdir()
    environment = {**os.environ, "TMPDIR": str(scratch), "TEMP": str(scratch), "TMP": str(scratch)}
    command = [sys.executable, "-m", "coursework", "run", "31", "--quantities", "table", "--format", "pdf", "--out", "o"]
    subprocess.run(command, env=environment, check=True, capture_output=True)
    assert list(scratch.iterdir()) == []
    assert sorted(path.name for path in Path("o").iterdir()) == ["report.pdf", "run.json"]


def test_pages_are_whole_also_after_their_fonts_were_cleared_away(folder):
    for place in ("a", "b"):
        assert call("run", "31", "--quantities", "table", "--format", "pdf", "--out", place).exit_code == 0
    assert Path("a/report.pdf").read_bytes() == Path("b/report.pdf").read_bytes()


def test_without_locks_a_folder_that_may_be_in_use_stays(folder, monkeypatch):
    with working_folder(folder) as hidden:
        (hidden / "x").touch()

        def unknown(_file):
            raise OSError("this disk knows no locks")

        monkeypatch.setattr(file_set, "take_lock", unknown)
        with working_folder(folder):
            assert (hidden / "x").exists()


def test_a_folder_in_the_place_of_a_file_is_told_before_the_old_set_is_touched(folder):
    assert call("run", "31", *CSV, "--out", "o").exit_code == 0
    before = Path("o/run.json").read_bytes()
    Path("o/report.html").mkdir()
    result = call("run", "31", "--quantities", "table", "--out", "o")
    assert result.exit_code == 2
    assert f"W010 {Path('o', 'report.html')}  could not be written: there is a folder of this name." in result.stderr
    assert Path("o/run.json").read_bytes() == before


def test_a_set_without_a_readable_record_has_no_files(folder):
    for text in ("", "[]", "{}", '{"files": 1}', "[" * 100_000):
        Path("run.json").write_text(text, encoding="utf-8")
        assert files_of(folder, "run.json") is None
    Path("run.json").write_text('{"files": {"a": "b"}}', encoding="utf-8")
    assert files_of(folder, "run.json") == {"a": "b"}


def test_a_name_no_file_can_have(folder):
    with working_folder(folder) as hidden, pytest.raises(OutputError, match="could not be written"):
        publish(hidden, folder / "a\0b", [], "run.json")
