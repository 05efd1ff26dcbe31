"""Output on the screen, in the language of the command.

Enters: sentences, and faults.  Leaves: lines on standard output or standard error.
Used by the other commands and `options.py`.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from contextvars import ContextVar
from typing import TYPE_CHECKING

import click

from coursework.variant.catalogue import own_file
from coursework.words.errors import CourseworkError, Fault, InputError
from coursework.words.scripts import wide_letters
from coursework.words.sentence import Sentence
from coursework.words.sentences import ENGLISH, load_phrases, say

if TYPE_CHECKING:
    from coursework.variant.record.variant import Variant

_TIED = "\ue00e"
_UNIT = r"(?:%|(?:m|mm|rad|м|мм|рад)(?:/[sс]²?)?|[sсNНJ]|Дж)(?!\w)"
_BESIDE_NUMBER = re.compile(rf"(?<=\S) (?=[-−]?\d|[=<−—] )|(?<=[=<]) |(?<=\d) (?={_UNIT})")  # gaps at which no line is broken
_SPOKEN: ContextVar[str] = ContextVar("language", default=ENGLISH)


def speak(language: str) -> None:
    """Set the language of all further output.  Raises `InputError` if it has no words file."""
    _SPOKEN.set(ENGLISH)  # the language in which an unknown one is refused
    load_phrases(language)
    _SPOKEN.set(language)


def speaks_english() -> bool:
    """Return whether the output is in English; only then are codes and verdicts of checks, which are English, printed."""
    return _SPOKEN.get() == ENGLISH


def in_language(text: str) -> str:
    """Return a sentence in the language of the command, any other text unchanged."""
    return load_phrases(_SPOKEN.get()).written(text)


def title_of(variant: Variant) -> str:
    """Return the title of a variant in the language of the command, else as its author wrote it."""
    texts = variant.texts.get(_SPOKEN.get())
    return (texts and texts.title) or variant.title


def tell(*texts: str, err: bool = False) -> None:
    """Print texts, a line each; of a sentence before a person, several, broken between words."""
    for text in texts:
        line = in_language(text)
        if isinstance(text, Sentence) and not err and "\n" not in line and is_terminal():
            indent = line[: len(line) - len(line.lstrip(" "))]
            tell_wrapped(line, hanging=indent and f"{indent}  ")
        else:
            click.echo(line, err=err)


def refuse_motor(variant: Variant) -> None:
    """Raise `InputError` for motion under forces, as studies of velocity laws do not apply to it."""
    if variant.motor is not None:
        raise InputError(say("fault.C077", name=variant.name))


def tell_own_file(variant: str) -> None:
    """Say so if a file in the current folder is used in place of a variant of the catalogue."""
    if (own := own_file(variant)) is not None:
        tell(say("screen.own_file", file=own, name=variant.lower()), err=True)


def is_terminal() -> bool:
    """Return whether standard output is a terminal, read by a person, and not a file or a program."""
    return sys.stdout is not None and sys.stdout.isatty()


def before_a_person(text: str, names: Iterable[str]) -> str:
    """Return a text with names as on the pages (φ₁, ω₁) if standard output is a terminal; a program gets them as in files."""
    if not is_terminal() or "utf" not in (sys.stdout.encoding or "").lower():
        return text
    from coursework.report.text.symbols import with_symbols

    return with_symbols(text, names)


def tell_wrapped(*texts: str, hanging: str = "") -> None:
    """Print paragraphs broken between words to the width of the terminal; all lines but their first begin with `hanging`.

    Text without gaps between words, such as Chinese, is left for the terminal to break.
    """
    import shutil  # imported here, as output to a program does not need it
    import textwrap

    for line in map(in_language, texts):
        if not wide_letters(line):
            width = shutil.get_terminal_size().columns - 1  # some terminals break a line that fills theirs
            kept = _BESIDE_NUMBER.sub(_TIED, line)
            lines = textwrap.wrap(kept, width, subsequent_indent=hanging, break_long_words=False, break_on_hyphens=False)
            line = "\n".join(lines).replace(_TIED, " ")
        click.echo(line)


def tell_unprinted(letters: str) -> None:
    """Say which letters no font here has, as a PDF shows boxes for them; print nothing if `letters` is empty."""
    if letters:
        tell(say("screen.unprinted", letters=letters), err=True)


def tell_faults(error: CourseworkError | Fault) -> None:
    """Print the faults of an error, one per line, or the one fault for which the process is ended from outside."""
    click.echo(error.told(in_language), err=True)
