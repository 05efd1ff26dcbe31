"""Why a file cannot be used, in the language of the command, and what a slip of two letters meant."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest

from coursework.words.custom_templates import templates_of
from coursework.words.errors import InputError
from coursework.words.reasons import reason_of
from coursework.words.sentences import closest, load_phrases
from tests.command import call


@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
@pytest.mark.usefixtures("folder")
def test_the_reason_of_the_system_is_told_in_the_language_of_the_command(language: str) -> None:
    Path("ada").mkdir()
    Path("file").touch()
    for options in (("--worksheet", "none.csv", "--out", "m"), ("--worksheet", "ada", "--out", "m"), ("--out", "file")):
        told = str(call("grade", "ada", "--variant", "31", "--language", language, *options).output)
        assert ("there is" in told or "this is a folder" in told) is (language == "en"), told


def test_an_unusual_reason_is_told_as_the_system_tells_it() -> None:
    assert reason_of(OSError(5, "Input/output error")) == "Input/output error"
    assert str(reason_of(socket.gaierror(-2, "Name or service not known"))) == "no network of this machine has this address"


@pytest.mark.parametrize(("text", "line"), [('a = "b"\nx = [', 2), ('a = "b"\nx y\nz = 3\n', 2), ('a = "b"\n\n\nx = "\ud800', 4)])
def test_a_words_file_is_refused_at_its_line(tmp_path: Path, text: str, line: int) -> None:
    (tmp_path / "words.de.toml").write_bytes(text.encode("utf-8", "surrogatepass"))
    with templates_of(tmp_path), pytest.raises(InputError, match=f"L003 .*its line {line} is not TOML in UTF-8"):
        load_phrases("de")


def test_a_rule_of_forms_that_is_none_is_told(tmp_path: Path) -> None:
    """Both ways to a form ask for it: a sentence with forms, and a noun in a gap."""
    (tmp_path / "words.de.toml").write_text(
        'plural = "one-two"\n[x]\na.one = "a"\nb = "{n:g;Zeile|Zeilen|Zeilen}"\n', encoding="utf-8"
    )
    with templates_of(tmp_path):
        phrases = load_phrases("de")
        for said in (lambda: phrases.said("x.a", number=2), lambda: phrases.said("x.b", n=2)):
            with pytest.raises(
                InputError, match=r'L004 words\.de\.toml, plural: "one-two" is no rule .* one-other, one-few-many'
            ):
                said()


def test_two_letters_in_the_other_order_are_the_closest_name() -> None:
    assert closest("--setp", ["--set", "--step"]) == ' Did you mean "--step"?'
    assert closest("ws", ["s", "q", "wt"]) == closest("w", ["s"]) == ""  # no slip of a letter: s is another quantity
    assert closest("w3", ["w30", "v3"]) == closest("W30", ["w30"]) == ' Did you mean "w30"?'
    assert closest("--ste", ["--set", "--step"]) == ' Did you mean "--set"?'
