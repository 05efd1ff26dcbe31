"""What the shell offers behind the tab key, asked for as bash and zsh ask."""

import os
import subprocess
import sys

import pytest

from coursework.motion.schemes import SCHEMES
from coursework.variant.catalogue import names


def offered(folder, *words, shell="bash"):
    """Return the completions of the last of the words."""
    environment = {
        **os.environ, "_COURSEWORK_COMPLETE": f"{shell}_complete", "COMP_WORDS": " ".join(words),
        "COMP_CWORD": str(len(words) - 1),
    }  # fmt: skip
    code = "from coursework.commands.cli import main; main(prog_name='coursework')"
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, encoding="utf-8", check=False)
    assert done.stderr == ""
    return done.stdout.strip().splitlines()


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "mine.toml").write_text("", encoding="utf-8")
    (tmp_path / "mine.csv").write_text("", encoding="utf-8")
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "other.toml").write_text("", encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("command", ["run", "check", "accuracy"])
def test_variants(command, folder):
    values = [line.partition(",")[2] for line in offered(folder, "coursework", command, "")]
    assert values == [*names(), "mine.toml", "sub/"]


def test_what_has_been_typed_narrows(folder):
    assert offered(folder, "coursework", "run", "exa") == [f"plain,{name}" for name in names() if name.startswith("exa")]
    assert offered(folder, "coursework", "check", "sub/") == ["plain,sub/other.toml"]
    assert offered(folder, "coursework", "check", "nowhere/") == []
    assert offered(folder, "coursework", "new", "x", "--from", "v10") == [f"plain,v10{number}" for number in (1, 2, 4, 5, 7, 8)]


def test_schemes_and_languages(folder):
    values = [line.partition(",")[2] for line in offered(folder, "coursework", "run", "31", "--scheme", "")]
    assert values == [*SCHEMES, "exact"]
    assert "plain,en" in offered(folder, "coursework", "run", "31", "--language", "")


def test_titles_stand_beside_the_names_where_the_shell_shows_them(folder):
    lines = offered(folder, "coursework", "run", "31", "--scheme", "eul", shell="zsh")
    assert lines == ["plain", "euler", SCHEMES["euler"].title]
