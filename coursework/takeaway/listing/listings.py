"""A program -> its listing in a language.

Enters: a `Program`, a language, the words of the comments.  Leaves: text.  Used by `commands/listing.py` and `appendix.py`.
A language is an entry of `languages.toml` and a function of its name.
"""

from __future__ import annotations

from collections.abc import Callable

from coursework.report.text.words import Words
from coursework.takeaway.listing.compiled import c, pascal
from coursework.takeaway.listing.dense import dense
from coursework.takeaway.listing.interpreted import javascript, octave, python
from coursework.takeaway.listing.program import Program
from coursework.takeaway.listing.syntax import syntax_of
from coursework.takeaway.listing.writer import Writer

_LANGUAGES: dict[str, Callable[[Writer], list[str]]] = {
    "python": python, "octave": octave, "c": c, "pascal": pascal, "javascript": javascript,
}  # fmt: skip


def listing(program: Program, language: str, words: Words) -> str:
    """Return the listing of a program."""
    syntax = syntax_of(language)
    lines = [line.rstrip() for line in _LANGUAGES[language](Writer(program, syntax, words))]
    return "\n".join(dense(lines, syntax)) + "\n"
