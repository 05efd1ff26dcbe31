"""A variant is found by its name in the catalogue, by its path, and by its name in the current folder."""

from pathlib import Path

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.variant.catalogue import find, own_file
from coursework.words.data_folders import folder as data_folder


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sub").mkdir()
    return tmp_path


def test_a_file_of_the_current_folder_is_found_without_its_ending():
    for name in ("mine.toml", "sub/other.toml", "two words.toml", "крив.toml"):
        Path(name).write_text("", encoding="utf-8")
        assert find(name) == Path(name)
        assert find(name.removesuffix(".toml")) == Path(name)


def test_a_folder_of_the_same_name_does_not_hide_the_file():
    Path("mine").mkdir()
    Path("mine.toml").write_text("", encoding="utf-8")
    assert find("mine") == Path("mine.toml")


def test_a_file_of_the_current_folder_stands_before_the_catalogue_and_is_told():
    Path("31.toml").write_text("", encoding="utf-8")
    assert find("31") == Path("31.toml")
    assert own_file("31") == Path("31.toml")
    assert find("V102") == data_folder("variants") / "v102.toml"
    assert own_file("v102") is None
    assert find("31.toml") == Path("31.toml")


def test_a_folder_of_a_name_of_the_catalogue_is_no_file():
    Path("31.toml").mkdir()
    Path("31").mkdir()
    assert find("31") == data_folder("variants") / "31.toml"
    assert own_file("31") is None


def test_in_the_catalogue_itself_nothing_stands_before_it(monkeypatch):
    monkeypatch.chdir(data_folder("variants"))
    assert find("31") == data_folder("variants") / "31.toml"
    assert own_file("31") is None


def test_the_own_file_is_told_in_one_line():
    text = (data_folder("variants") / "prp.toml").read_text(encoding="utf-8")
    Path("prp.toml").write_text(
        text.replace('title  = "', 'title  = "My own ', 1).replace('title = "', 'title = "My own ', 1), encoding="utf-8"
    )
    for command in (["run", "prp", "--format", "csv"], ["check", "prp"], ["run", "prp", "31", "--format", "csv", "--out", "all"]):
        told = CliRunner().invoke(main, command)
        assert told.exit_code == 0
        assert told.stderr.splitlines()[0] == "prp.toml of this folder is taken, not the catalogue’s variant prp."
    assert CliRunner().invoke(main, ["check", "example-1"]).stderr == ""


@pytest.mark.parametrize("typed", ["mine", "mine.toml", "sub/mine", "sub/mine.toml"])
def test_an_ending_that_windows_hides_is_told(typed):
    Path("mine.toml.txt").write_text("", encoding="utf-8")
    Path("sub/mine.toml.txt").write_text("", encoding="utf-8")
    with pytest.raises(coursework.InputError) as caught:
        find(typed)
    folder = Path(typed).parent
    told = f'C013 there is no file "{folder / "mine.toml"}", but there is "{folder / "mine.toml.txt"}": the editor has added .txt'
    assert str(caught.value).startswith(told)
    assert str(caught.value).endswith('Rename it to "mine.toml" (in Explorer: View, Show, File name extensions).')


def test_a_file_saved_as_text_is_told():
    Path("mine.txt").write_text("", encoding="utf-8")
    with pytest.raises(
        coursework.InputError, match=r'C013 there is no file "mine\.toml", but there is "mine\.txt": .* Rename it'
    ):
        find("mine")
    assert find("mine.txt") == Path("mine.txt")


def test_the_right_file_beside_the_doubled_ending_is_taken():
    Path("mine.toml.txt").write_text("", encoding="utf-8")
    Path("mine.toml").write_text("", encoding="utf-8")
    assert find("mine") == Path("mine.toml")
    assert find("mine.toml.txt") == Path("mine.toml.txt")


def test_a_slip_of_the_pen_finds_the_nearest_file():
    Path("linkage.toml").write_text("", encoding="utf-8")
    with pytest.raises(coursework.InputError, match=r'no file "linkaeg\.toml" in this folder\. Did you mean "linkage"\?'):
        find("linkaeg")


@pytest.mark.parametrize("typed", ["x" * 5000, "a\0b", "", "/", "..", "."])
def test_what_is_no_name_of_a_file_is_a_sentence(typed):
    with pytest.raises(coursework.InputError):
        coursework.load(typed)
