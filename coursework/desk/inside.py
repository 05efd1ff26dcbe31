"""Files of one folder and none outside it: only names valid on every system, no links that lead out, a limited size.

Enters: a folder and a name.  Leaves: a path, bytes.  Used by `folder.py`, `config.py`, `zips.py`, `typed.py` and `new.py`.
"""

from __future__ import annotations

import os
import re
import stat
import unicodedata
from collections.abc import Iterator, Mapping
from pathlib import Path

from coursework.grading.platforms.names import file_stem
from coursework.system.files.links import led_to
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MOST_NAMES = 500  # tables of a folder that are listed if a text names an unknown one
_WORD = re.compile(r"[\w-]{1,60}")
_FLAGS = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_NONBLOCK", "O_CLOEXEC", "O_BINARY"))


def is_name(name: str) -> bool:
    """Return whether a file may have this name: one word of letters, digits, - and _, and no name of a device on any system."""
    plain = unicodedata.normalize("NFKC", name)
    plain = plain if plain[:1].isalnum() else f"x{plain}"
    return _WORD.fullmatch(name) is not None and (not plain.isascii() or file_stem(plain) == plain)


def refused_name(name: str) -> Sentence:
    """Return the sentence on a name that no file may have."""
    return say("fault.C084", name=name[:60])


def read_inside(folder: Path, name: str, most: int) -> bytes | None:
    """Return at most `most` + 1 bytes of a file of the folder, or None if there is no regular file of this name.

    The extra byte shows that the file is too large.  Raises `OSError` if it cannot be read.
    """
    path = _inside(folder, name)
    if path is None:
        return None
    try:
        handle = os.open(path, _FLAGS)
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        return None
    with os.fdopen(handle, "rb") as file:
        return file.read(most + 1)


def _inside(folder: Path, name: str) -> Path | None:
    """Return where a file of the folder lies, None for a name that leads out of it."""
    if "/" in name or "\\" in name or "\0" in name or name.startswith("."):
        return None
    path = led_to(folder / name)
    return path if path.parent == led_to(folder) else None


class TablesOf(Mapping[str, bytes]):
    """The tables that a text may name, by file name: those sent with it, then those of `folders`, read only when needed."""

    def __init__(self, sent: Mapping[str, bytes], folders: tuple[Path, ...], most: int) -> None:
        self._sent, self._folders, self._most = sent, folders, most

    def __getitem__(self, name: str) -> bytes:
        if name in self._sent:
            return self._sent[name]
        for folder in self._folders:
            if (content := read_inside(folder, name, self._most)) is not None:
                return content
        raise KeyError(name)

    def __iter__(self) -> Iterator[str]:
        yield from self._sent
        for folder in self._folders[:1]:
            for name in sorted(path.name for path in folder.glob("*.csv"))[:MOST_NAMES]:
                if name not in self._sent and (path := _inside(folder, name)) is not None and path.is_file():
                    yield name

    def __len__(self) -> int:
        return sum(1 for _ in self)
