"""A words file -> its sentences, in a fifth of the standard reader's time, as every command has to wait for it.

Enters: a text.  Leaves: nested dicts.  Used by `sentences.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

_LINE = (
    r"""(?:([\w-]+|"[^"\\\n]*")((?:\.[\w-]+)*) = (?:"([^"\\\x00-\x08\n-\x1f\x7f]*)"|("(?:\\.|[^"\\\n])*"|'[^'\n]*'))"""
    r"""|\[([\w.-]+)\])?[ \t]*(?:#[^\x00-\x08\n-\x1f\x7f]*)?\n"""
)


def read_words(text: str) -> dict[str, Any]:
    """Return the contents of a words file, as `tomllib` does, which also reads files that are not plain.

    A plain file has only tables and keys with texts of one line.  Raises `ValueError` as `tomllib` does.
    """
    import tomllib  # imported here, as only commands that print something need it

    words = _plain_words(text, tomllib.loads)
    return tomllib.loads(text) if words is None else words


def line_of(error: ValueError, path: Path) -> int:
    """Return the line at which a file is not TOML, or not UTF-8."""
    if isinstance(error, UnicodeDecodeError):
        return error.object.count(b"\n", 0, error.start) + 1
    at = re.search(r"at line (\d+)", str(error))
    return int(at[1]) if at else path.read_bytes().rstrip().count(b"\n") + 1


def _plain_words(text: str, read: Callable[[str], dict[str, Any]]) -> dict[str, Any] | None:
    """Return the sentences if every line is plain and no key repeats, else None; `read` reads texts with escapes."""
    words: dict[str, Any] = {}
    table = words
    dotted: set[int] = set()  # tables created by dotted keys; no section may add to them
    opened: set[int] = set()
    at = 0
    for line in re.finditer(_LINE, text, re.ASCII):
        if line.start() != at:
            return None
        at = line.end()
        key, inner, plain, other, section = line.groups()
        if key is not None:
            owner, key = table, key.strip('"')
            for part in inner.split(".")[1:]:
                owner, key = owner.setdefault(key, {}), part
                if not isinstance(owner, dict) or id(owner) in opened:
                    return None
                dotted.add(id(owner))
            if key in owner:
                return None
            owner[key] = read(f"v = {other}")["v"] if plain is None else plain
        elif section is not None:
            table = words
            for part in section.split("."):
                table = table.setdefault(part, {})
                if not part or not isinstance(table, dict) or id(table) in dotted:
                    return None
            if id(table) in opened:
                return None
            opened.add(id(table))
    return words if at == len(text) else None
