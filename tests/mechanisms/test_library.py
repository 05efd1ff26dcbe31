"""Each mechanism of this folder runs as it is and some test looks at it; what a test would change must stand there."""

from pathlib import Path

import pytest

import coursework
from coursework.variant import catalogue
from tests.mechanisms.library import FOLDERS, changed, mechanism

FILES = sorted(FOLDERS[0].glob("*.toml"))


@pytest.mark.long
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_each_runs_as_it_is(file: Path) -> None:
    assert len(coursework.solve(file, quantities=["table"]).table) > 2


def test_each_is_looked_at_and_none_has_a_name_of_the_catalogue() -> None:
    tests = "".join(path.read_text(encoding="utf-8") for path in FOLDERS[0].parent.rglob("*.py"))
    assert [file.stem for file in FILES if f'"{file.stem}"' not in tests or file.stem in catalogue.names()] == []


def test_what_is_to_be_another_must_stand_there() -> None:
    text = 'a = "1 m"\nb  = "2 m"\nb2 = "a + b"\n'
    assert changed(text, ("1 m", "3 m"), b="4 m") == 'a = "3 m"\nb = "4 m"\nb2 = "a + b"\n'
    assert changed(text, a=None, b='{ table = "b.csv", of = "t" }') == 'b = { table = "b.csv", of = "t" }\nb2 = "a + b"\n'
    for changes, values in (((("5 m", "6 m"),), {}), ((), {"c": "1 m"}), ((("1 m", "3 m"),), {"a": "2 m"})):
        with pytest.raises(AssertionError, match=r"(in|of) the text"):
            changed(text, *changes, **values)
    with pytest.raises(AssertionError, match="2 lines of the text give a"):
        changed(text + text, a="2 m")


def test_a_name_of_the_catalogue_is_a_mechanism_too() -> None:
    assert mechanism("example-1", ("Four-bar linkage", "Another")) != mechanism("example-1")
    with pytest.raises(ValueError, match="unpack"):
        mechanism("nowhere")
