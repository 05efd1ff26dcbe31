"""What is said on the screen, in the language of the command.

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
from coursework.words.sentences import ENGLISH, load_phrases, say

if TYPE_CHECKING:
    from coursework.variant.record.variant import Variant

_TIED = "\ue00e"
_BEFORE_NUMBER = re.compile(r"(?<=\S) (?=[-−]?\d)")
_SPOKEN: ContextVar[str] = ContextVar("language", default=ENGLISH)


def speak(language: str) -> None:
    """Say what follows in a language.  Raises `InputError` where it has no words file."""
    _SPOKEN.set(ENGLISH)  # in which an unknown language is refused
    load_phrases(language)
    _SPOKEN.set(language)


def speaks_english() -> bool:
    """Return whether the command speaks English: codes and verdicts are words of it, and stand before no sentence of another."""
    return _SPOKEN.get() == ENGLISH


def in_language(text: str) -> str:
    """Return a sentence in the language of the command; any other text as it is."""
    return load_phrases(_SPOKEN.get()).written(text)


def title_of(variant: Variant) -> str:
    """Return what a variant is called in the language of the command, or as its author wrote it."""
    texts = variant.texts.get(_SPOKEN.get())
    return (texts and texts.title) or variant.title


def tell(text: str, *, err: bool = False) -> None:
    """Print a line."""
    click.echo(in_language(text), err=err)


def refuse_motor(variant: Variant) -> None:
    """Raise `InputError` for motion under forces, whose rates no study of velocity laws follows."""
    if variant.motor is not None:
        raise InputError(say("fault.C077", name=variant.name))


def tell_own_file(variant: str) -> None:
    """Say where a file of the current folder is taken in place of a variant of the catalogue."""
    if (own := own_file(variant)) is not None:
        tell(say("screen.own_file", file=own, name=variant.lower()), err=True)


def is_terminal() -> bool:
    """Return whether standard output is a terminal, before which a person sits, and neither a file nor a program."""
    return sys.stdout is not None and sys.stdout.isatty()


def before_a_person(text: str, names: Iterable[str]) -> str:
    """Return a text with names as the pages set them, φ₁ and ω₁, before a person; a program reads them as a file writes them."""
    if not is_terminal() or "utf" not in (sys.stdout.encoding or "").lower():
        return text
    from coursework.report.text.symbols import with_symbols

    return with_symbols(text, names)


def tell_wrapped(text: str, *, hanging: str = "") -> None:
    """Print a paragraph for a terminal: lines as wide as it is, broken between words, all but the first with `hanging` before.

    What is written without gaps between words, as Chinese is, the terminal itself breaks.
    """
    import shutil  # a program that reads the lines does without
    import textwrap

    line = in_language(text)
    if not wide_letters(line):
        width = shutil.get_terminal_size().columns - 1  # some terminals break a line that fills theirs
        kept = _BEFORE_NUMBER.sub(_TIED, line)  # a number stays with the word before it
        lines = textwrap.wrap(kept, width, subsequent_indent=hanging, break_long_words=False, break_on_hyphens=False)
        line = "\n".join(lines).replace(_TIED, " ")
    click.echo(line)


def tell_unprinted(letters: str) -> None:
    """Say which letters no face here has, so that a PDF shows boxes in their place; nothing where there are none."""
    if letters:
        tell(say("screen.unprinted", letters=letters), err=True)


def tell_faults(error: CourseworkError | Fault) -> None:
    """Print every fault of an error, a line each, or the one for which the process is ended from outside."""
    click.echo(error.told(in_language), err=True)
