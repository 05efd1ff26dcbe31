"""Templates compiled once an installation: when kept code is used, when not, and that pages are the same bytes either way."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from coursework.words import generated_code as module
from coursework.words.custom_templates import templates_of
from coursework.words.data_folders import folder
from coursework.words.templates import filled


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder in which Python keeps what it has compiled."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(sys, "pycache_prefix", str(tmp_path / "kept"))
    return tmp_path / "kept"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    file = tmp_path / "sums.txt"
    file.write_text("1+1", encoding="utf-8")
    return file


def answer(file: Path, of: str = "") -> tuple[int, bool]:
    """Return what the code of the file finds, and whether it was generated for that."""
    generated = []

    def made(text: str) -> str:
        generated.append(text)
        return f"found = {text}"

    scope: dict[str, int] = {}
    code = module.generated_code(file, made, of)
    assert code.co_filename == str(file)
    exec(code, scope)
    return scope["found"], bool(generated)


def files(place: Path, of: str = "") -> list[str]:
    return sorted(path.name for path in place.rglob("*") if path.is_file() and of in path.name)


def test_code_is_generated_once_and_anew_when_anything_of_it_has_changed(kept: Path, file: Path) -> None:
    assert [answer(file), answer(file)] == [(2, True), (2, False)]
    assert [answer(file, "another version"), answer(file, "another version")] == [(2, True), (2, False)]
    assert answer(file) == (2, True)
    time = file.stat().st_mtime_ns
    file.write_text("2+2", encoding="utf-8")
    os.utime(file, ns=(time, time + 1_000_000))  # as long as it was, and of the same second
    assert [answer(file), answer(file)] == [(4, True), (4, False)]
    assert len(files(kept, file.name)) == 1


def test_two_files_of_one_name_have_code_of_their_own(kept: Path, file: Path) -> None:
    other = file.parent / "desk" / file.name
    other.parent.mkdir()
    other.write_text("3+3", encoding="utf-8")
    assert [answer(file), answer(other), answer(file), answer(other)] == [(2, True), (6, True), (2, False), (6, False)]


def test_code_is_kept_only_where_and_when_python_keeps_that_of_the_module(
    kept: Path, file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer(file)
    where = [path.parent for path in file.parent.rglob(f"*{file.name}?*")]
    assert where == [kept.joinpath(*Path(module.__file__).parent.parts[1:])]
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert [answer(file, "not to be written"), answer(file, "not to be written")] == [(2, True)] * 2
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(sys, "pycache_prefix", str(file / "no folder"))
    assert [answer(file), answer(file)] == [(2, True)] * 2


def test_a_value_is_made_once_of_a_piece_of_the_package_and_anew_with_other_code(
    kept: Path, file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    code = file.with_name("makes.py")
    code.touch()
    texts: list[str] = []
    scope: dict[str, Any] = {"texts": texts}
    exec(compile("def made(text):\n    texts.append(text)\n    return {'сума \"': [text, None, 2.5]}", str(code), "exec"), scope)
    expected = {'сума "': ["1+1", None, 2.5]}
    assert [module.made_once(file, scope["made"]) for _ in range(2)] == [expected] * 2
    assert (len(texts), files(kept, file.name)) == (2, [])  # a piece of an instructor's own
    monkeypatch.setattr(module, "folder_of_package", lambda _: file.parent)
    assert [module.made_once(file, scope["made"]) for _ in range(3)] == [expected] * 3
    assert len(texts) == 3
    os.utime(code, (1, 1))
    assert [module.made_once(file, scope["made"]) for _ in range(3)] == [expected] * 3
    assert len(texts) == 4


def test_own_pieces_are_neither_kept_nor_read_from_what_is_kept(kept: Path, tmp_path: Path) -> None:
    own = tmp_path / "own"
    own.mkdir()
    (own / "strip.html.j2").write_text("mine", encoding="utf-8")
    with templates_of(own):
        assert filled("strip.html.j2") == "mine"
    assert files(kept, "strip") == []


RUN = """
import sys
import jinja2
from coursework.commands.cli import main
generated = []
compiled = jinja2.Environment.compile
def seen(self, source, name=None, *rest, **options):
    generated.append(name)
    return compiled(self, source, name, *rest, **options)
jinja2.Environment.compile = seen
try:
    main(["run", "31", "--format", "html", "--out", sys.argv[1]])
except SystemExit as end:
    assert not end.code
print(len(generated), file=sys.stderr)
"""


@pytest.mark.long
def test_a_page_is_the_same_with_and_without_kept_code(tmp_path: Path) -> None:
    free = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    (tmp_path / "a file").touch()
    before = files(folder("reports"))
    found = []
    for number, place in enumerate(("kept", "kept", "a file/in the way")):
        told = {"PYTHONPYCACHEPREFIX": str(tmp_path / place)}
        done = subprocess.run(
            [sys.executable, "-c", RUN, str(tmp_path / str(number))],
            env=free | told,
            capture_output=True,
            text=True,
            cwd=tmp_path,
        )
        assert done.returncode == 0, done.stderr
        found.append((int(done.stderr.split()[-1]) > 0, (tmp_path / str(number) / "report.html").read_bytes()))
    assert [generated for generated, _ in found] == [True, False, True]
    assert len({page for _, page in found}) == 1
    assert files(folder("reports")) == before
