"""Ids of students, and the names of files made from them.

Enters: an id, exactly as a platform gave it.  Leaves: a name that every system reads the same; keys to compare ids by.
Used by all code that writes a file or matches a student.
"""

from __future__ import annotations

import hashlib
import re
import unicodedata

_SAFE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._@-]{0,63}")
_DEVICES = {"con", "prn", "aux", "nul", *(f"{port}{number}" for port in ("com", "lpt") for number in range(10))}


def file_stem(student: str) -> str:
    """Return the name of a student's files in OUT: the id if every system accepts it, else `x-` and 16 hex digits.

    >>> file_stem("ivanov"), file_stem("../../x"), file_stem("CON")
    ('ivanov', 'x-9cdf6a50100a862e', 'x-a3dbc4b644a9a2c5')
    """
    is_device = student.partition(".")[0].casefold() in _DEVICES
    if _SAFE.fullmatch(student) and not student.endswith(".") and not is_device:
        return student
    return "x-" + hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:16]


def legible(name: str) -> str:
    r"""Return a name from a disk in a form that can be written anywhere: bytes that are not UTF-8 appear as \xff.

    >>> legible("caf\udce9.csv")
    'caf\\xe9.csv'
    """
    return "".join(_byte(letter) if "\ud800" <= letter <= "\udfff" else letter for letter in name)


def _byte(half: str) -> str:
    return f"\\x{ord(half) - 0xDC00:02x}" if "\udc80" <= half <= "\udcff" else f"\\u{ord(half):04x}"


def same_key(student: str) -> str:
    """Return a key that is equal for ids which some file system or platform takes for the same: NFC, case folded."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", student).casefold())


def name_key(name: str) -> str:
    """Return a full name in the form in which names are compared: NFKC, case folded, single blanks."""
    return " ".join(unicodedata.normalize("NFKC", name).casefold().split())
