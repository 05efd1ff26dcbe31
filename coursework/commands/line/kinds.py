"""The table of kinds of groups in the help of `coursework new`: the keys of each, in their order, with their meanings.

Enters: a language.  Leaves: text.  Used by `options.py`.
"""

from __future__ import annotations

import shutil
import textwrap

from coursework.commands.line.screen import in_language, speak
from coursework.mechanism.groups import GROUPS
from coursework.variant.record.roles import roles, title
from coursework.words.scripts import wide_letters
from coursework.words.sentences import say

_KIND, _KEY = 8, 13  # widths of the columns for the name of a kind and for a key


def kinds_table(language: str) -> str:
    """Return the table.  Raises `InputError` for a language without a words file."""
    speak(language)
    lines = [in_language(say("new.table"))]
    for kind in GROUPS:
        letters = kind.shape.named()
        lines += ["", f"  {kind.name:<{_KIND}}{in_language(title(kind.shape, letters))}"]
        for key, meant in roles(kind.shape, letters).items():
            lines += _wrapped(" " * (_KIND + 2) + f"{key:<{_KEY}}", in_language(meant))
    return "\n".join(lines)


def _wrapped(head: str, text: str) -> list[str]:
    if wide_letters(text):
        return [head + text]  # the terminal itself breaks text without gaps between words
    width = max(shutil.get_terminal_size().columns, 72)
    return textwrap.wrap(text, width, initial_indent=head, subsequent_indent=" " * len(head), break_on_hyphens=False)
