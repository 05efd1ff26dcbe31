"""A misused command line -> a fault with a code, in the language of the command.

Enters: an exception of click.  Leaves: a line on standard error, below the usage of the command.
Used by `program.py` and `options.py`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence

import click

from coursework.commands.line.screen import in_language, speak
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import ENGLISH, closest, either, say

VARIABLE = "COURSEWORK_LANGUAGE"
_NO_VALUE = "does not take a value"
_TOO_MANY = re.compile(r"Got unexpected extra arguments? \((.*)\)\Z", re.DOTALL)


def tell_misuse(error: click.ClickException, words: Sequence[str]) -> None:
    """Print what is wrong with the command line `words`, which may itself choose the language; without words, the help."""
    if isinstance(error, click.exceptions.NoArgsIsHelpError):
        return error.show()
    try:
        speak(language_of(words))
    except InputError:
        speak(ENGLISH)
    if isinstance(error, click.UsageError) and error.ctx is not None:
        click.echo(error.ctx.get_usage(), err=True)
    click.echo(Fault(fault_of(error)).told(in_language), err=True)


def fault_of(error: click.ClickException) -> Sentence:
    """Return the sentence for a kind of misuse; for a rare kind it contains click's own message."""
    if isinstance(error, click.NoSuchOption) and not error.option_name.startswith("-"):
        word = re.sub(r"^\W+", "", error.option_name)
        return say("fault.C100", name=error.option_name, meant="-" * min(len(word), 2) + word)
    if isinstance(error, click.NoSuchOption) and _is_of_a_command(error):
        return say("fault.C101", name=error.option_name)
    if isinstance(error, click.NoSuchOption):
        hint = closest(error.option_name, [name for name in error.possibilities or () if name != "--help"])
        return say("fault.C051", name=error.option_name, hint=hint)
    if isinstance(error, click.BadOptionUsage):
        return say("fault.C099" if _NO_VALUE in error.message else "fault.C098", name=error.option_name)
    if isinstance(error, click.MissingParameter):
        return say("fault.C052", name=_name(error))
    if name := getattr(error, "command_name", None):
        group = getattr(error, "ctx", None)
        known = group.command.list_commands(group) if group is not None and isinstance(group.command, click.Group) else []
        return say("fault.C053", name=name, hint=closest(name, known), known=tuple(known))
    kind = error.param.type if isinstance(error, click.BadParameter) and error.param else None
    if isinstance(error, click.BadParameter) and isinstance(kind, click.Choice):
        return say("fault.C054", name=_name(error), choices=either([f'"{choice}"' for choice in kind.choices]))
    if isinstance(error, click.BadParameter) and isinstance(kind, (click.IntRange, click.FloatRange)):
        if kind.max is None:
            return say("fault.C059" if kind.min_open else "fault.C055", name=_name(error), least=kind.min)
        return say("fault.C056", name=_name(error), least=kind.min, most=kind.max)
    if isinstance(error, click.BadParameter) and kind in {click.FLOAT, click.INT}:
        return say("fault.C057", name=_name(error))
    if too_many := _TOO_MANY.match(error.format_message()):
        return say("fault.C060", found=too_many[1])
    return say("fault.C058", reason=error.format_message())


def _is_of_a_command(error: click.NoSuchOption) -> bool:
    """Return whether an option that stands before the command is one of some command."""
    group = error.ctx.command if error.ctx is not None else None
    if error.ctx is None or not isinstance(group, click.Group):
        return False
    commands = [group.get_command(error.ctx, name) for name in group.list_commands(error.ctx)]
    return any(error.option_name in option.opts for command in commands if command for option in command.params)


def _name(error: click.BadParameter) -> str:
    """Return the name of an option or argument as the help writes it."""
    if error.param is None or error.ctx is None:
        return str(error.param_hint or "")
    return error.param.get_error_hint(error.ctx).strip("'").removesuffix("...")


def language_of(words: Sequence[str]) -> str:
    """Return the language chosen on a command line, else that of the environment."""
    chosen = values_of(words, "--language")
    return chosen[0] if chosen else os.environ.get(VARIABLE) or ENGLISH


def values_of(words: Sequence[str], option: str) -> list[str]:
    """Return the values of an option in the `words` of a command line, which need not have been parsed.

    >>> values_of(["run", "31", "--language", "ru", "--language=uk"], "--language")
    ['ru', 'uk']
    >>> values_of([], "--language")
    []
    """
    behind = zip(words, [*words, None][1:], strict=True)
    found = (after if word == option else word.partition("=")[2] for word, after in behind if word.partition("=")[0] == option)
    return [value for value in found if value is not None]
