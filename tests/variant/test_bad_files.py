"""A fault of a file and the sentence a student reads about it: `bad/NAME.toml` beside `bad/NAME.expected.txt`.

After a sentence has been changed on purpose, and read again:  python tests/variant/test_bad_files.py  writes the expected texts.
"""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from tests.sample import later

BAD = Path(__file__).parent / "bad"
FILES = sorted(path.stem for path in BAD.glob("*.toml"))
# Words of programmers that must not reach a student.
JARGON = re.compile(
    r"input should|valid (string|dict|integer)|instance of|NoneType|Traceback|Error\b|\bstr\b|\bint\b|float\(|codec|\(s\)|<class"
)


def message(name):
    """Return what is said about a bad file when its first table is asked for."""
    with pytest.raises(coursework.CourseworkError) as caught:
        coursework.solve(f"{name}.toml", quantities=["table"] if not name.startswith("system-quantit") else None).columns()
    return str(caught.value)


@pytest.mark.parametrize("name", FILES)
def test_message(name, monkeypatch):
    monkeypatch.chdir(BAD)
    assert message(name) == (BAD / f"{name}.expected.txt").read_text(encoding="utf-8").rstrip("\n")


# What is said of each file is asked above; here, that the command says it, and more where it looks for the slip at once.
MORE = {
    "geometry-disagreement": (
        " Derive it again, or correct the geometry; if one slip explains it, coursework check names the term.",
        " One slip would explain it: the sign of l*w2*cos(phi2) differs.",
    )
}


@pytest.mark.parametrize("name", [later(name) if place % 6 else name for place, name in enumerate(FILES)])
def test_command_ends_with_two(name, monkeypatch):
    monkeypatch.chdir(BAD)
    result = CliRunner().invoke(main, ["run", f"{name}.toml", "--format", "csv", "--out", "nowhere"])
    assert result.exit_code == 2
    expected = (BAD / f"{name}.expected.txt").read_text(encoding="utf-8").rstrip("\n")
    assert result.stderr.rstrip("\n") == expected.replace(*MORE.get(name, ("", "")))
    assert result.stdout == ""
    assert not (BAD / "nowhere").exists()


@pytest.mark.parametrize("name", FILES)
def test_says_where_what_and_what_to_do(name):
    text = (BAD / f"{name}.expected.txt").read_text(encoding="utf-8").rstrip("\n")
    lines = text.split("\n")
    assert not JARGON.search(text)
    for line in lines:
        where = re.match(rf"[VC]\d\d\d {name}\.toml:(\d+)(?::(\d+))?  \S", line)
        assert where, line
        assert line.endswith((".", "?")), line
        source = (BAD / f"{name}.toml").read_text(encoding="utf-8").split("\n")
        if where[2]:
            assert int(where[2]) <= len(source[int(where[1]) - 1]) + 1
    places = [int(found[1]) for line in lines if (found := re.match(r"\w+ [\w-]+\.toml:(\d+)", line))]
    assert places == sorted(places)


def test_every_file_says_what_is_wrong_with_it():
    for name in FILES:
        assert (BAD / f"{name}.toml").read_text(encoding="utf-8").startswith("# "), name


def test_nothing_is_left_over():
    assert {path.name.removesuffix(".expected.txt") for path in BAD.glob("*.expected.txt")} == set(FILES)


if __name__ == "__main__":
    import os

    os.chdir(BAD)
    for each in FILES:
        Path(f"{each}.expected.txt").write_text(message(each) + "\n", encoding="utf-8")
