"""Pandoc is asked once and answers in bytes; what it refuses, or that it cannot be started, is told in one line."""

import pytest

from coursework.takeaway.note import pandoc
from coursework.words.errors import OutputError


def test_what_pandoc_says_is_handed_on():
    assert pandoc.called(["-f", "markdown", "-t", "plain"], b"some *words*\n") == b"some words\n"


def test_what_pandoc_refuses_is_told_in_one_line():
    with pytest.raises(OutputError, match="Unknown input format nothing") as refused:
        pandoc.called(["-f", "nothing"], b"")
    assert "\n" not in str(refused.value) and pandoc.ITS_OWN not in str(refused.value)


def test_a_program_that_cannot_be_started_is_told(monkeypatch):
    monkeypatch.setattr(pandoc, "_program", lambda: "/nowhere/pandoc")
    with pytest.raises(OutputError, match="nowhere"):
        pandoc.called([], b"")
