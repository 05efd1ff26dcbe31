"""Reads a file or a share address of another program as a variant file.

Enters: what was typed after `--from`.  Leaves: TOML, None if it is no such file or address.  Raises `InputError`.
Used by `commands/new.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from coursework.takeaway.foreign import linkage, pmks, pmks_plus, pylinkage
from coursework.takeaway.foreign.scheme import MOST_BYTES, Scheme
from coursework.takeaway.foreign.text import text_of
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

READERS: dict[str, Callable[[bytes], Scheme]] = {
    ".csv": pmks.read, ".pmks.txt": pmks.read, ".pmks": pmks_plus.read, ".json": pylinkage.read, ".linkage2": linkage.read,
}  # fmt: skip
ADDRESS = ("http://", "https://")


def foreign_text(given: str, stem: str, said: Callable[[str], str]) -> str | None:
    """Return the variant file, None if `given` is no file or address of another program; `said` translates a sentence."""
    if given.lower().startswith(ADDRESS):
        typed = given[:MOST_BYTES].encode()  # read, never fetched
        return text_of(pmks.read(typed) if "mech=" in given else pmks_plus.read(typed), stem, said)
    reader = next((reader for ending, reader in READERS.items() if given.lower().endswith(ending)), None)
    path = Path(given)
    if reader is None or not path.is_file():
        return None
    with path.open("rb") as file:
        content = file.read(MOST_BYTES + 1)
    try:
        if len(content) > MOST_BYTES:
            raise InputError(say("fault.C096", most=MOST_BYTES // 1000))
        return text_of(reader(content), stem, said)
    except InputError as error:
        raise InputError([Fault(fault.message, given) for fault in error.faults]) from None
