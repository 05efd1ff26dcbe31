"""Files that belong together: written in a hidden folder, then moved into place one by one, the record last.

Enters: the folder of the results.  Leaves: the whole set, or the files that were there before.  If the writer was killed, the
set has no record, and the next writer removes the leftovers.  Used by the command line, whose temporary files all lie here.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from itertools import takewhile
from pathlib import Path
from typing import IO

from coursework.system.files.whole_files import refused, take_lock
from coursework.words.errors import Fault, OutputError
from coursework.words.sentences import say

HIDDEN = ".coursework-"
LOCK = ".lock"
MATPLOTLIB = "MPLCONFIGDIR"  # the variable in which matplotlib looks first for its folder

_open: set[Path] = set()  # hidden folders that this process has made and not yet removed


@contextmanager
def working_folder(target: Path) -> Iterator[Path]:
    """Yield a hidden folder inside `target` for unfinished files; it is removed afterwards, whatever happens.

    `target` is made if it does not exist, and removed again if it stays empty.  Hidden folders that killed runs left in it are
    removed.  Temporary files of libraries go into the hidden folder too.  Raises `OutputError`.
    """
    with refused(target):
        made = _make(target)
    try:
        if target not in made:
            clear_leftovers(target)
        with refused(target):
            lock, hidden = _new_hidden(target)
        _open.add(hidden.absolute())
        try:
            with scratch_in(hidden.absolute()):
                yield hidden
        finally:
            discard(hidden)
            _open.discard(hidden.absolute())
            lock.close()
            _remove(hidden.with_name(hidden.name + LOCK))
    finally:
        for folder in made:
            with suppress(OSError):
                folder.rmdir()  # fails, as it should, if the folder is not empty


@contextmanager
def scratch_in(folder: Path) -> Iterator[None]:
    """Put temporary files into `folder`; matplotlib's settings too, if their usual folder is not writable.

    Otherwise matplotlib would make a folder elsewhere and print a warning.
    """
    before = tempfile.tempdir, os.environ.get(MATPLOTLIB)
    tempfile.tempdir = str(folder)
    if before[1] is None and not all(map(_is_writable, _homes())):
        os.environ[MATPLOTLIB] = str(folder)
    try:
        yield
    finally:
        tempfile.tempdir = before[0]
        if before[1] is None:
            os.environ.pop(MATPLOTLIB, None)


def _homes() -> Iterator[Path]:
    """Yield the folders in which matplotlib keeps its settings and its list of fonts."""
    home = Path(os.path.expanduser("~"))  # noqa: PTH111  `Path.home` raises if there is no home
    if not sys.platform.startswith(("linux", "freebsd")):
        yield home / ".matplotlib"
        return
    for variable, usual in (("XDG_CONFIG_HOME", ".config"), ("XDG_CACHE_HOME", ".cache")):
        yield Path(os.environ.get(variable) or home / usual) / "matplotlib"


def _is_writable(folder: Path) -> bool:
    """Return whether `folder` is writable, or could be made; it is not made."""
    nearest = next((place for place in (folder, *folder.parents) if place.exists()), folder)
    return nearest.is_dir() and os.access(nearest, os.W_OK | os.X_OK)


def publish(hidden: Path, target: Path, names: Iterable[str], record: str) -> None:
    """Move the files of a set from `hidden` to `target`; while they are being moved, `target` has no record.

    Raises `OutputError` with the name of the file that could not be put in place.
    """
    names = (*names, record)
    for name in names:
        if (target / name).is_dir():
            raise OutputError([Fault(say("fault.W010"), str(target / name))])
    with refused(target / record):
        target.mkdir(parents=True, exist_ok=True)
        (target / record).unlink(missing_ok=True)
    for name in names:
        with refused(target / name):
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            (hidden / name).replace(target / name)


def files_of(target: Path, record: str) -> Mapping[str, str] | None:
    """Return the files of a finished set (name -> SHA-256), None if there is no readable record."""
    try:
        found = json.loads((target / record).read_text(encoding="utf-8"))["files"]
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    return found if isinstance(found, dict) else None


def clear_leftovers(target: Path) -> None:
    """Remove the hidden folders that killed runs left in `target`; the folder of a run still at work stays."""
    for path in target.glob(f"{HIDDEN}*"):
        hidden = path.with_name(path.name.removesuffix(LOCK))
        lock = hidden.with_name(hidden.name + LOCK)
        if _is_abandoned(lock):
            discard(hidden)
            _remove(lock)


def discard_all() -> None:
    """Remove every hidden folder of this process, before it ends without the usual cleanup."""
    for hidden in tuple(_open):
        discard(hidden)
        _remove(hidden.with_name(hidden.name + LOCK))


def discard(hidden: Path) -> None:
    """Remove a hidden folder and its contents, as far as the system allows."""
    try:
        hidden.rmdir()  # usually empty: all its files have been moved into place
    except OSError:
        shutil.rmtree(hidden, ignore_errors=True)


def _make(target: Path) -> list[Path]:
    """Make a folder and its missing parents; return the folders made, innermost first."""
    new = [*takewhile(lambda folder: not folder.exists(), (target, *target.parents))]
    target.mkdir(parents=True, exist_ok=True)
    return new


def _new_hidden(target: Path) -> tuple[IO[bytes], Path]:
    """Make a hidden folder; return its open lock file, locked until it is closed or the process ends, and the folder."""
    hidden = target / f"{HIDDEN}{os.urandom(6).hex()}"
    path = hidden.with_name(hidden.name + LOCK)
    file = path.open("xb")
    try:
        with suppress(OSError):  # the file system may not support locks
            take_lock(file)
        hidden.mkdir()
    except BaseException:
        file.close()
        _remove(path)
        raise
    return file, hidden


def _is_abandoned(lock: Path) -> bool:
    """Return whether no process holds the lock; a missing lock file is held by nobody."""
    try:
        with lock.open("r+b") as file:
            take_lock(file)
    except FileNotFoundError:
        return True
    except OSError:
        return False
    return True


def _remove(path: Path) -> None:
    with suppress(OSError):
        path.unlink(missing_ok=True)
