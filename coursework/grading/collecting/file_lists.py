"""Names in a folder or zip -> one file list for each student.

Enters: names of folders and files.  Leaves: `FileList`s; nothing is opened.
Used by `sources.py`.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import replace
from itertools import count
from pathlib import PurePosixPath

from coursework.grading.platforms.downloads import Owner, canvas_owner, moodle_owner
from coursework.grading.platforms.names import legible, same_key
from coursework.grading.reading.files.kinds import is_ignored
from coursework.grading.reading.submission import Note, note
from coursework.system.frozen import frozen
from coursework.system.grouped import grouped
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_COPY = re.compile(r"(.+?) ?\([0-9]{1,2}\)")  # browsers and systems add such a number to the second of two equal names
_AGAIN = re.compile(r"(.+?)-([0-9]{1,3})(\.[^.]+)?")  # so Canvas names a file whose name was handed in before


@frozen
class FileList:
    """The files of one student, not yet read: the name of each and the place where it is found.

    `id` is a platform's number, else verbatim (NFC); `name` as the platform gives it, `number` the platform's own; `folder` is
    the name under which Moodle wants feedback returned; `review` is why a person must look at it.  File lists with equal ids get
    different ones, and `shared` is then the id they had in common, "" for all others; `late`: the platform says that it is late.
    """

    id: str
    name: str | None
    files: tuple[tuple[str, str], ...]
    number: str = ""
    folder: str = ""
    notes: tuple[Note, ...] = ()
    review: Sentence | None = None
    shared: str = ""
    late: bool = False


@frozen
class Names:
    """Top folders, files as (name, place), and notes by the first part of the name that they are about."""

    folders: set[str]
    files: list[tuple[str, str]]
    notes: dict[str, list[Note]]

    @property
    def tops(self) -> set[str]:
        """Return the first parts of all names in the paths."""
        return {name.partition("/")[0] for name in (*self.folders, *(name for name, _ in self.files))}


def unwrapped(names: Names) -> Names:
    """Return names without the single top folder that some systems put around everything in a zip."""
    tops = names.tops
    deep = any("/" in name.partition("/")[2] for name, _ in names.files)
    if len(tops) != 1 or not deep or moodle_owner(next(iter(tops))):
        return names
    top = f"{next(iter(tops))}/"
    folders = {name.removeprefix(top) for name in names.folders if name.startswith(top)}
    return Names(folders, [(name.removeprefix(top), place) for name, place in names.files if name.startswith(top)], names.notes)


def sorted_out(names: Names) -> tuple[str, tuple[FileList, ...]]:
    """Return the platform from which the download comes, and its file lists."""
    if any(moodle_owner(top) for top in names.tops):
        return "moodle", _with_doubts(_by_owner(names, moodle_owner))
    if names.folders or any("/" in name for name, _ in names.files):
        return "folder", _with_doubts(_by_folder(names))
    if names.files and all(canvas_owner(name) for name, _ in names.files):
        return "canvas", _with_doubts(_by_owner(names, canvas_owner))
    return "flat", _with_doubts(_flat(names))


def of_nobody(platform: str, names: Names) -> list[str]:
    """Return what belongs to no student: names that the platform does not give, or files beside the students' folders."""
    if platform == "moodle":
        return sorted(top for top in names.tops if not moodle_owner(top))
    return sorted(name for name, _ in names.files if "/" not in name) if platform == "folder" else []


def _by_owner(names: Names, owner_of: Callable[[str], Owner | None]) -> list[FileList]:
    """Return one file list for each owner that a platform's names give; other names belong to nobody."""
    owned = {top: owner for top in sorted(names.tops | names.notes.keys()) if (owner := owner_of(top))}
    owners = grouped((owner.key, owner) for owner in owned.values())
    notes = grouped((owner.key, one) for top, owner in owned.items() for one in names.notes.get(top, ()))
    parts = ((name.partition("/"), place) for name, place in names.files)
    of_files = ((owned[top], rest or owned[top].file or top, place) for (top, _, rest), place in parts if top in owned)
    files = grouped((owner.key, (name, place)) for owner, name, place in of_files if not is_ignored(owner.file))
    file_lists = []
    for key, found in owners.items():
        first = found[0]
        again = Counter(owner.file for owner in found if owner.attachment)
        twice = sorted(owner.attachment for owner in found if again[owner.file] > 1)
        review = say("reading.review.resubmitted", names=tuple(twice)) if twice else None
        student, handed_in = first.number or key, sorted(files.get(key, []))
        newer = _handed_in_again(again)
        older = (note("ignored_file", name=name, why=say("reading.why.older", name=newer[name])) for name in sorted(newer))
        file_lists.append(FileList(
            student, first.name, tuple(file for file in handed_in if file[0] not in newer), first.number, first.folder,
            (*notes.get(key, ()), *older), review, late=any(owner.late for owner in found),
        ))  # fmt: skip
    return file_lists


def _handed_in_again(names: Collection[str]) -> dict[str, str]:
    """Return for each name in Canvas under which a later file was handed in, too, that of the last: table.csv, table-2.csv.

    Names of which none is without a number may be a student's own: of two parts of one work.
    """
    numbered = (again for name in names if (again := _AGAIN.fullmatch(name)))
    by_original = grouped((f"{again[1]}{again[3] or ''}", (int(again[2]), again[0])) for again in numbered)
    found: dict[str, str] = {}
    for original in by_original.keys() & set(names):
        *older, newest = [original, *(name for _, name in sorted(by_original[original]))]
        found |= dict.fromkeys(older, newest)
    return found


def _by_folder(names: Names) -> list[FileList]:
    files: dict[str, list[tuple[str, str]]] = {folder.partition("/")[0]: [] for folder in names.folders}
    for name, place in names.files:
        top, between, rest = name.partition("/")
        if between:
            files.setdefault(top, []).append((rest, place))
    return [FileList(top, None, tuple(sorted(found)), notes=tuple(names.notes.get(top, ()))) for top, found in files.items()]


def _flat(names: Names) -> list[FileList]:
    files = grouped((_flat_id(name), (name, place)) for name, place in names.files)
    notes = grouped((_flat_id(name), one) for name, found in names.notes.items() for one in found)
    return [FileList(student, None, tuple(sorted(files.get(student, []))), notes=tuple(notes.get(student, ())))
            for student in {**files, **notes}]  # fmt: skip


def _flat_id(name: str) -> str:
    if "_" in name.lstrip("_"):
        return name.partition("_")[0] or name
    return _original(PurePosixPath(name).stem)


def _with_doubts(file_lists: Iterable[FileList]) -> tuple[FileList, ...]:
    """Return the file lists by id; ids that some systems cannot tell apart, and copies beside an original, need a person."""
    ordered = sorted(_with_ids(file_lists), key=lambda file_list: file_list.id)
    same, alike = (grouped((key(one.id), one.id) for one in ordered) for key in (same_key, _original))
    checked = []
    for file_list in ordered:
        twins = [file_list.shared] * 2 if file_list.shared else same[same_key(file_list.id)]
        copies = alike[_original(file_list.id)]
        if len(twins) > 1:
            file_list = replace(file_list, review=say("reading.review.same_id", names=tuple(twins)))
        elif len(copies) > 1 and _original(file_list.id) in copies:
            file_list = replace(file_list, review=say("reading.review.resubmitted", names=tuple(copies)))
        checked.append(file_list)
    return tuple(checked)


def _with_ids(file_lists: Iterable[FileList]) -> Iterator[FileList]:
    """Yield the file lists with ids and names that can be written; lists whose ids look alike get different ids."""
    same = grouped((unicodedata.normalize("NFC", legible(one.id)), one) for one in file_lists)
    taken = {*same}
    for student, listed in same.items():
        listed.sort(key=lambda one: one.id.encode("utf-8", "surrogatepass"))
        for file_list in listed:
            own = student if file_list is listed[0] else next(one for n in count(2) if (one := f"{student}~{n}") not in taken)
            taken.add(own)
            yield replace(
                file_list,
                id=own,
                name=None if file_list.name is None else legible(file_list.name),
                folder=legible(file_list.folder),
                files=tuple((legible(name), where) for name, where in file_list.files),
                shared=student if len(listed) > 1 else "",
            )


def _original(student: str) -> str:
    """Return a name without the number that is added to a copy."""
    copy = _COPY.fullmatch(student)
    return copy[1] if copy else student
