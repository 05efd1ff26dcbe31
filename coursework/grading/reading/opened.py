"""A file as handed in -> the files inside it, if it is an archive; and what is said of kinds of files that are not read.

Enters: `SubmittedFile`, the name of a kind.  Leaves: `SubmittedFile`s, `Refused`.
Used by `read_submission.py`.
"""

from __future__ import annotations

from dataclasses import replace

from coursework.grading.reading.documents.read_document import is_document
from coursework.grading.reading.files.archive import Archive, legible_name
from coursework.grading.reading.files.kinds import ARCHIVES, OLD_EXCEL, OLD_WORD, PICTURES, is_ignored, kind_of_parts
from coursework.grading.reading.limits import FILE_BYTES, FILES, Refused, other_kind, unreadable
from coursework.grading.reading.submission import SubmittedFile, submitted_file
from coursework.grading.reading.table.tables_of_file import is_spreadsheet


def opened(file: SubmittedFile) -> list[SubmittedFile]:
    """Return the file itself, or the files inside it if it is a plain zip (opened only one level deep, in memory)."""
    if not file.content.startswith(b"PK") or file.trouble:
        return [file]
    try:
        archive = Archive(file.content)
        if is_spreadsheet(archive) or is_document(archive) or kind_of_parts(list(archive.parts)):
            return [file]
        inside: list[SubmittedFile] = []
        for part in archive.parts.values():
            name = legible_name(part)
            if not is_ignored(name) and len(inside) <= FILES:
                inside.append(submitted_file(f"{file.name}/{name}", archive.read(part.filename, FILE_BYTES)))
        return sorted(inside, key=lambda entry: entry.name)
    except Refused as refused:
        return [replace(file, trouble=refused.trouble.text)]


def refused_kind(kind: str, key: str = "other_kind") -> Refused:
    """Return the refusal of a file of this kind, which tells the student how to save it instead."""
    if kind in {OLD_EXCEL, OLD_WORD}:
        return unreadable("old_excel" if kind == OLD_EXCEL else "old_word")
    return other_kind("picture" if kind in PICTURES else "archive" if kind in ARCHIVES else key, kind=kind)
