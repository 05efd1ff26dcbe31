"""README.md says what is true: its commands run as written, its Python runs, its files exist."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from click.testing import CliRunner

from coursework.cli import main

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
COMMANDS = [line.split("#")[0].strip() for line in re.search(r"```sh\n(.*?)```", TEXT, re.S)[1].splitlines()]


def test_commands_run_as_written_one_after_the_other(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for command in COMMANDS:
        words = shlex.split(command)
        assert words[0] == "coursework"
        result = CliRunner().invoke(main, words[1:])
        assert result.exit_code == 0, (command, result.output)
        assert result.output.strip(), command


def test_lines_for_the_shell_are_what_the_shell_can_run():
    """Each line asks the tool for a script of completions, which names the tool."""
    lines = re.findall(r"_COURSEWORK_COMPLETE=(\w+)_source coursework", TEXT)
    assert lines == ["bash", "zsh", "fish"]
    for shell in lines:
        environment = {**os.environ, "_COURSEWORK_COMPLETE": f"{shell}_source"}
        code = "from coursework.cli import main; main(prog_name='coursework')"
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
        assert re.search(rf"^coursework {name}\b", TEXT, re.M), name


def test_bootstrap_commands_are_those_of_the_gate():
    assert "python3 -m coursework.bootstrap run 31" in TEXT
    assert "python3 -m coursework.bootstrap test" in TEXT
    assert "python3 -m coursework.bootstrap test" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
