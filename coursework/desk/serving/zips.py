"""All files of a folder as one zip, and such a zip unpacked on another computer.

Enters: a `Folder`, bytes of a zip.  Leaves: bytes; names of files that were written and skipped.  Used by `files.py`.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator
from contextlib import suppress
from operator import itemgetter
from typing import Any

from coursework.desk.inside import is_name, read_inside, refused_name
from coursework.desk.serving.bodies import MOST_BYTES, Refused
from coursework.desk.serving.folder import MOST_FILES, SUFFIX, Folder, Stale, tables_named
from coursework.system.files.whole_files import write_bytes
from coursework.system.files.zipped import DAMAGED, zipped
from coursework.words.sentences import Phrases, say

MOST_ENTRIES = 2 * MOST_FILES  # each variant of a folder, and a table for each
NO_ZIP = 422


def packed(folder: Folder) -> bytes:
    """Return a zip with every variant of a folder and the tables that they name."""
    return zipped(_work(folder))


def _work(folder: Folder) -> Iterator[tuple[str, bytes]]:
    tables: set[str] = set()
    for each in folder.listed():
        if not each["deleted"] and (text := folder.read(each["name"])) is not None:
            tables |= {*tables_named(text)}
            yield each["name"] + SUFFIX, text
    for name in sorted(tables):
        table = None
        with suppress(OSError):  # what cannot be read costs nothing else
            table = read_inside(folder.path, name, MOST_BYTES)
        if table is not None and len(table) <= MOST_BYTES:  # never a part of one
            yield name, table


def unpacked(folder: Folder, content: bytes, words: Phrases) -> dict[str, Any]:
    """Write the files of a zip without replacing any; return "written" and "skipped" (name, sentence).  Raises `Refused`."""
    found: dict[str, Any] = {"written": [], "skipped": []}
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            inside = [
                (entry.filename.rpartition("/")[2], entry) for entry in archive.infolist()[:MOST_ENTRIES] if not entry.is_dir()
            ]
            for name, entry in sorted(inside, key=itemgetter(0)):
                with archive.open(entry) as file:
                    why = _taken_back(folder, name, file.read(MOST_BYTES + 1))
                if why is None:
                    found["written"].append(name)
                else:
                    found["skipped"].append({"name": name[:100], "sentence": words.written(why)})
    except DAMAGED:
        raise Refused(NO_ZIP, say("desk.no_zip")) from None
    return found


def _taken_back(folder: Folder, name: str, content: bytes) -> str | None:
    """Write one file; return why it was not written, or None if it was written or is there with the same content."""
    stem, _, suffix = name.rpartition(".")
    if suffix not in {"toml", "csv"}:
        return say("desk.zip_other", name=name[:100])
    if not is_name(stem):
        return refused_name(stem)
    if len(content) > MOST_BYTES:
        return say("desk.too_large", most=MOST_BYTES)
    there = read_inside(folder.path, name, MOST_BYTES)
    if there is not None:
        return None if there == content else say("desk.zip_there", name=name)
    if suffix == "csv":
        write_bytes(folder.path / name, content)
        return None
    try:
        folder.write(stem, content, None)
    except Stale:
        return say("desk.zip_there", name=name)
    return None
