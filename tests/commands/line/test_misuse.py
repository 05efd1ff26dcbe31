"""What is said of a kind of misuse of the command line that has no sentence of its own."""

import click

from coursework.commands.line.misuse import fault_of
from coursework.words.errors import Fault
from tests.command import call


def test_a_rare_kind_is_told_in_the_words_of_click():
    assert str(Fault(fault_of(click.ClickException("Something rare.")))) == "C058 Something rare."


def test_the_bare_command_shows_its_help(monkeypatch):
    monkeypatch.setattr("sys.argv", ["coursework"])
    result = call()
    assert result.exit_code == 2
    assert result.stderr == call("--help").stdout
