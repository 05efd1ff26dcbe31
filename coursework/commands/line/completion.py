"""Completions that the shell offers for the tab key.

Enters: the part of a word typed so far.  Leaves: its completions.  Called by the name that `options.py` gives.
"""

from __future__ import annotations

from pathlib import Path

from click import Context, Parameter
from click.shell_completion import CompletionItem

from coursework.motion.schemes import SCHEMES
from coursework.variant.catalogue import entries
from coursework.variant.record.vocabulary import EXACT
from coursework.words.sentences import languages as known_languages
from coursework.words.sentences import say


def variants(_context: Context, _parameter: Parameter, typed: str) -> list[CompletionItem]:
    """Return the catalogue's names with their titles, and the variant files and folders that begin as typed."""
    listed = [CompletionItem(entry.name, help=entry.title) for entry in entries()]
    listed += [CompletionItem(name) for name in _files(typed)]
    return [item for item in listed if item.value.startswith(typed)]


def schemes(_context: Context, _parameter: Parameter, typed: str) -> list[CompletionItem]:
    """Return the schemes with their titles."""
    titles = {**{name: scheme.title for name, scheme in SCHEMES.items()}, EXACT: say("exact.title")}
    return [CompletionItem(name, help=title) for name, title in titles.items() if name.startswith(typed)]


def languages(_context: Context, _parameter: Parameter, typed: str) -> list[CompletionItem]:
    """Return the languages that have a words file."""
    return [CompletionItem(code) for code in known_languages() if code.startswith(typed)]


def _files(typed: str) -> list[str]:
    """Return the paths of .toml files and of folders (with a slash) in the folder typed so far."""
    place = typed[: typed.rfind("/") + 1]
    try:
        found = sorted(Path(place or ".").iterdir())
    except OSError:
        return []
    seen = [path for path in found if not path.name.startswith(".")]
    return [f"{place}{path.name}{'/' if path.is_dir() else ''}" for path in seen if path.is_dir() or path.suffix == ".toml"]
