"""The file of a draft: every key of a chain, each with a comment in the language asked for.

Enters: a `Draft`, the name of the file, a function that translates a sentence.  Leaves: the text.
Used by `commands/new.py` and the desk.  The template is `reports/new-groups.toml.j2`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from coursework.mechanism.drafts.chain import SWING, TURNED, Draft, GroupDraft
from coursework.variant.record.roles import role, roles, title
from coursework.variant.record.vocabulary import SCHEME_NAMES
from coursework.words.scripts import wide_letters
from coursework.words.sentences import say
from coursework.words.templates import filled

_COMMENT = 46  # the column where comments begin


def text_of(draft: Draft, name: str, said: Callable[[str], str], asked: Sequence[str], first: int = 1) -> str:
    """Return the text of a file that asks for the quantities `asked`; `said` puts a sentence into the language of the comments.

    `first` is the number of its first group.
    """

    def meanings(group: GroupDraft) -> list[tuple[str, str]]:
        return [(key, said(meant)) for key, meant in roles(group.kind.shape, group.letters).items()]

    text = filled(
        "new-groups.toml.j2", draft=draft, name=name, kinds=", ".join(str(group.kind) for group in draft.groups), asked=asked,
        first=first, swing=SWING, turned=TURNED, schemes=SCHEME_NAMES, roles=meanings,
        say=lambda key, **values: said(say(key, **values)),
        title=lambda group: said(title(group.kind.shape, group.letters)),
        role=lambda group, key, place: said(role(group.kind.shape, key, group.letters, place)),
    )  # fmt: skip
    return commented(text)


def commented(text: str) -> str:
    """Return a filled template with the text after each tab turned into a comment, all comments in one column."""
    return "".join(f"{_written(*line.partition(chr(9))[::2])}\n" for line in text.rstrip("\n").split("\n"))


def additions(draft: Draft, number: int, said: Callable[[str], str]) -> dict[str, list[str]]:
    """Return by section the lines to add to a file for the groups of a draft; the first of them is group `number` of the file."""
    found: dict[str, list[str]] = {section: [] for section in ("given", "drive", "coordinates", "points", "group")}
    for block in text_of(draft, "", said, (), number).split("\n\n"):
        head, *lines = block.split("\n")
        section = head.partition("]")[0].strip("[")
        if section in found:  # a group keeps its header and has a blank line before it
            found[section] += ["", head, *lines] if section == "group" else lines
    return found


def _written(code: str, comment: str) -> str:
    if not comment:
        return code
    return f"{code:<{_COMMENT - wide_letters(code)}} # {comment}" if code else f"# {comment}"
