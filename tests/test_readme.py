"""README.md says what is true: its commands run as written, its Python runs, its files exist."""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from coursework.cli import main

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
COMMANDS = [line.split("#")[0].strip() for line in re.search(r"```sh\n(.*?)```", TEXT, re.S)[1].splitlines()]


@pytest.mark.parametrize("command", COMMANDS)
def test_command(command, tmp_path, monkeypatch):
    import shlex

    monkeypatch.chdir(tmp_path)
    words = shlex.split(command)
    assert words[0] == "coursework"
    result = CliRunner().invoke(main, words[1:])
    assert result.exit_code == 0, result.output
    assert result.output.strip()


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
        assert re.search(rf"^coursework {name}\b", TEXT, re.M), name


def test_bootstrap_commands_are_those_of_the_gate():
    assert "python3 -m coursework.bootstrap run 31" in TEXT
    assert "python3 -m coursework.bootstrap test" in TEXT
    assert "python3 -m coursework.bootstrap test" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
