"""A folder or zip of submissions -> one file list for each student, and the files of a list when they are needed.

Enters: SOURCE.  Leaves: `FileList`s (names only) and, one at a time, `Submission`s (bytes), so that memory does not grow.
Raises `InputError` if SOURCE itself cannot be used.  Used by the code that grades a class or one submission.
"""

from __future__ import annotations

import os
import stat
import zipfile
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime
from functools import partial
from io import BytesIO
from pathlib import Path, PurePosixPath
from typing import IO

from coursework.grading.collecting.file_lists import FileList, Names, of_nobody, sorted_out, unwrapped
from coursework.grading.platforms.names import legible
from coursework.grading.reading.files.archive import legible_name
from coursework.grading.reading.files.kinds import is_ignored, is_named_as_table
from coursework.grading.reading.limits import FILE_BYTES, FILES, INFLATED_BYTES
from coursework.grading.reading.submission import Note, Submission, SubmittedFile, note, submitted_file
from coursework.system.files.zipped import DAMAGED
from coursework.words.errors import Fault, InputError
from coursework.words.reasons import reason_of
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_MOST_PARTS = 200_000
_ENTRY, _UTF8 = b"PK\x01\x02", 0x08  # an entry in a zip's directory, and the bit of its ninth byte that says: name in UTF-8
HEAD = 4096  # bytes kept of a file that is too large: enough to tell its kind
_NO_TIME = (1980, 1, 1, 0, 0, 0)
_DEPTH = 6
_SHOWN = 8  # names told of files that belong to nobody
_FLAGS = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC", "O_BINARY"))


class Source:
    """An opened folder or zip; `platform` is "folder", "flat", "moodle" or "canvas"."""

    def __init__(self, path: Path) -> None:
        """Find the file lists.  Raises `InputError` if there is no such folder or zip."""
        self.path = path
        self._zip = _open_zip(path) if path.is_file() else None
        self._parts: dict[str, zipfile.ZipInfo] = {}
        self.remarks: list[Sentence] = []  # about files that belong to nobody
        if self._zip is None and not path.is_dir():
            raise InputError([Fault(say("fault.G001"), str(path))])
        names = self._names_in_zip() if self._zip else self._names_in_folder()
        self.platform, self.file_lists = sorted_out(names)
        if left := of_nobody(self.platform, names):
            shown = [legible(name)[:80] for name in left[:_SHOWN]]
            self.remarks.append(say(f"screen.of_nobody.{self.platform}", names=(*shown, *["…"][: len(left) - len(shown)])))

    def __enter__(self) -> Source:
        """Return the source itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the zip."""
        if self._zip:
            self._zip.close()

    def collect(self, file_list: FileList) -> Submission:
        """Return the submission of a file list, with each file read once; at most 50 files and 20 MB."""
        files, notes = _gathered((name, partial(self._read, place, name)) for name, place in file_list.files)
        return Submission(file_list.id, file_list.name, files, file_list.notes + notes, file_list.review)

    def newest(self, file_list: FileList) -> datetime | None:
        """Return when the newest file was changed, None if unknown; a zip gives no time zone, and 1980 if it has no time."""
        times = [self._time(place) for _, place in file_list.files]
        return max((time for time in times if time), default=None)

    def _time(self, place: str) -> datetime | None:
        try:
            if self._zip is None:
                return datetime.fromtimestamp((self.path / place).lstat().st_mtime, UTC)
            written = self._parts[place].date_time
            return datetime(*written) if written > _NO_TIME else None
        except (OSError, OverflowError, ValueError):
            return None

    def _read(self, place: str, name: str, left: int) -> SubmittedFile | Note:
        if self._zip is None:
            return read_regular(self.path / place, name, left)
        part = self._parts[place]
        try:
            with self._zip.open(part) as file:
                return _bounded(file, name, part.file_size, left)
        except DAMAGED:
            return submitted_file(name, b"", say("reading.trouble.damaged"))

    def _names_in_zip(self) -> Names:
        assert self._zip is not None
        folders: set[str] = set()
        names: list[tuple[str, str]] = []
        for part in self._zip.infolist():
            name = legible_name(part).replace("\\", "/").strip("/")
            if ".." in PurePosixPath(name).parts:
                self.remarks.append(say("screen.entry_outside", name=legible(name)[:80]))
                continue
            if not name or is_ignored(name):
                continue
            if part.is_dir():
                folders.add(name)
            else:
                self._parts[part.filename] = part
                names.append((name, part.filename))
        return unwrapped(Names(folders, names, {}))

    def _names_in_folder(self) -> Names:
        folders = {
            entry.name
            for entry in self.path.iterdir()
            if entry.is_dir() and not entry.is_symlink() and not is_ignored(entry.name)
        }
        names: list[tuple[str, str]] = []
        notes: dict[str, list[Note]] = {}
        for name, found in _walk(self.path, "", _DEPTH, of_students=True):
            if isinstance(found, Note):
                notes.setdefault(name.partition("/")[0], []).append(found)
            else:
                names.append((name, name))
        return Names(folders, names, notes)


def _open_zip(path: Path) -> zipfile.ZipFile:
    try:
        opened = _zip_of(path)
    except (zipfile.BadZipFile, OSError, ValueError) as error:
        raise InputError([Fault(say("fault.G002"), str(path))]) from error
    if len(opened.infolist()) > _MOST_PARTS:
        raise InputError([Fault(say("fault.G003", most=_MOST_PARTS), str(path))])
    return opened


def _zip_of(path: Path) -> zipfile.ZipFile:
    """Open a zip; a name that is falsely marked as UTF-8 would make the zip unreadable, so that mark is removed."""
    try:
        return zipfile.ZipFile(path)
    except UnicodeDecodeError:
        content = bytearray(path.read_bytes())
    place = content.find(_ENTRY)
    while place >= 0:
        length = int.from_bytes(content[place + 28 : place + 30], "little")
        if content[place + 9] & _UTF8:
            try:
                content[place + 46 : place + 46 + length].decode("utf-8")
            except UnicodeDecodeError:
                content[place + 9] &= ~_UTF8
        place = content.find(_ENTRY, place + 46 + length)
    return zipfile.ZipFile(BytesIO(content))


def collect_one(place: Path) -> Submission:
    """Return the one submission whose files are in a folder (or are one file), as autograders provide it."""
    if not place.exists():
        raise InputError([Fault(say("fault.G004"), str(place))])
    return _alone(files_below(place) if place.is_dir() else [(place.name, place)])


def collect_files(paths: Iterable[Path]) -> Submission:
    """Return a submission of some files, without those a program leaves beside them.  Raises `InputError` if one is not there."""
    named = list(paths)
    listed = [path for path in named if not is_ignored(path.name)] or named
    if missing := [path for path in listed if not path.is_file()]:
        raise InputError([Fault(say("fault.G005"), str(missing[0]))])
    return _alone((path.name, path) for path in listed)


def _alone(found: Iterable[tuple[str, Path | Note]]) -> Submission:
    """Return the submission of an unnamed student."""
    entries = list(found)
    notes = [entry for _, entry in entries if isinstance(entry, Note)]
    paths = [(legible(name), path) for name, path in entries if isinstance(path, Path)]
    files, more = _gathered((name, partial(read_regular, path, name)) for name, path in paths)
    return Submission("submission", None, files, (*notes, *more))


def _gathered(
    entries: Iterable[tuple[str, Callable[[int], SubmittedFile | Note]]],
) -> tuple[tuple[SubmittedFile, ...], tuple[Note, ...]]:
    """Return files and notes, at most 50 files and 20 MB; an entry is a name and a reader, called with the bytes left."""
    files: list[SubmittedFile] = []
    notes: list[Note] = []
    left = INFLATED_BYTES
    for name, read in entries:
        if len(files) >= FILES:
            notes.append(note("ignored_file", name=name, why=say("reading.why.too_many", limit=FILES)))
            break
        found = read(left)
        if isinstance(found, Note):
            notes.append(found)
        else:
            files.append(found)
            left -= len(found.content)
    return tuple(files), tuple(notes)


def files_below(folder: Path) -> Iterator[tuple[str, Path | Note]]:
    """Yield the contents of a folder in the order of names: paths of possible files, notes on what is left aside."""
    yield from _walk(folder, "", _DEPTH)


def _walk(folder: Path, before: str, depth: int, *, of_students: bool = False) -> Iterator[tuple[str, Path | Note]]:
    """Yield the contents of a folder; a folder named as a table is none, unless the folders in it are `of_students`."""
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError as error:
        yield before, note("ignored_file", name=legible(before or folder.name), why=reason_of(error))
        return
    for entry in entries:
        name = before + entry.name  # as on the disk, where it may be no valid text
        if is_ignored(entry.name):
            continue
        if entry.is_symlink():
            yield name, note("ignored_file", name=legible(name), why=say("reading.why.link"))
        elif entry.is_dir(follow_symlinks=False):
            if depth > 1 and (of_students or not is_named_as_table(entry.name)):
                yield from _walk(folder / entry.name, f"{name}/", depth - 1)
            else:
                yield name, note("ignored_file", name=legible(name), why=say("reading.why.folder"))
        else:
            yield name, folder / entry.name


def read_regular(path: Path, name: str, left: int) -> SubmittedFile | Note:
    """Return a file's bytes, at most 4 MB and `left`; a note if it is not a regular file with a single name."""
    try:
        with os.fdopen(os.open(path, _FLAGS), "rb") as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode):
                return note("ignored_file", name=name, why=say("reading.why.not_regular"))
            if status.st_nlink > 1:
                return note("ignored_file", name=name, why=say("reading.why.hard_link"))
            return _bounded(file, name, status.st_size, left)
    except OSError as error:
        return submitted_file(name, b"", say("reading.trouble.locked", why=reason_of(error)))


def _bounded(file: IO[bytes], name: str, size: int, left: int) -> SubmittedFile:
    """Return a file of `size` bytes, or its beginning if it is larger than allowed."""
    most = min(FILE_BYTES, left)
    # A file may grow while it is read; one byte more than allowed shows that.
    content = file.read(HEAD if size > FILE_BYTES else most + 1)
    if size > FILE_BYTES or len(content) > most:
        why = say("reading.trouble.too_large", limit=FILE_BYTES // 2**20)
        return submitted_file(name, content[:HEAD], why, max(size, len(content)))
    return submitted_file(name, content)
