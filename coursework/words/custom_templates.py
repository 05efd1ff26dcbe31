"""An instructor's own pieces of `reports/`, which replace those of the package with the same names.

Enters: a folder of own pieces, or their content from another process.  Leaves: contexts in which they are used; their hash.
Used by `commands/`, `grading/batch/`, `output/`, `templates.py` and `report/`.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from coursework.words.data_folders import REPORTS, folder_of_package, standing_in

PACKAGE = "package"  # the folder name with which own templates extend or import those of the package


@contextmanager
def templates_of(own: Path | None) -> Iterator[None]:
    """Use the files of a folder in place of those of `reports/` with the same names; all others stay as they are.

    Templates include each other by name, and Typst reads from one folder only, so both are copied into one temporary folder.  The
    pieces of the package are also in "package/" there, so that own ones can extend them.  Own pieces are the instructor's and are
    trusted; the given folder is only read.
    """
    if own is None:
        yield
        return
    import shutil
    import tempfile

    with tempfile.TemporaryDirectory(prefix="coursework-templates-") as place:
        together = Path(place) / REPORTS
        shutil.copytree(folder_of_package(REPORTS), together)
        shutil.copytree(folder_of_package(REPORTS), together / PACKAGE, ignore=shutil.ignore_patterns("fonts"))
        for path in templates_in(own):
            target = together / path.relative_to(own)
            target.parent.mkdir(exist_ok=True)
            shutil.copyfile(path, target)
        standing_in.append(together)
        try:
            yield
        finally:
            standing_in.remove(together)


def templates_in(own: Path) -> list[Path]:
    """Return the files of a folder of own pieces and of its subfolders that `reports/` has too."""
    parts = [own, *(own / part.name for part in sorted(folder_of_package(REPORTS).iterdir()) if part.is_dir())]
    return sorted(path for part in parts if part.is_dir() for path in part.iterdir() if path.is_file())


def templates_in_use() -> dict[str, bytes]:
    """Return the own pieces in use, by name; another process or machine needs them to write the same pages."""
    if not standing_in:
        return {}
    together, package = standing_in[-1], folder_of_package(REPORTS)
    found = {path.relative_to(together).as_posix(): path.read_bytes() for path in templates_in(together)}
    return {
        name: content
        for name, content in found.items()
        if not (package / name).is_file() or (package / name).read_bytes() != content
    }


def line_in_templates(error: BaseException) -> tuple[str, int] | None:
    """Return the own piece in use, and its line, in which an error arose or through which it passed; None for other errors."""
    found, own, trace = None, templates_in_use(), error.__traceback__
    while trace is not None:
        path = Path(trace.tb_frame.f_code.co_filename)
        name = path.relative_to(standing_in[-1]).as_posix() if own and path.is_relative_to(standing_in[-1]) else ""
        found = (name, trace.tb_lineno) if name in own else found
        trace = trace.tb_next
    return found


@contextmanager
def templates_standing_in(pieces: Mapping[str, bytes]) -> Iterator[None]:
    """Use the pieces that `templates_in_use` returned in another process."""
    if not pieces:
        yield
        return
    import tempfile

    with tempfile.TemporaryDirectory(prefix="coursework-pieces-") as place:
        for name, content in pieces.items():
            target = Path(place) / name
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(content)
        with templates_of(Path(place)):
            yield


def stamp_of_templates() -> str:
    """Return a hash of the own pieces in use, "" without any; pages made with different pieces are different."""
    digest = hashlib.sha256()
    pieces = templates_in_use()
    for name, content in sorted(pieces.items()):
        digest.update(name.encode() + b"\0" + content)
    return digest.hexdigest() if pieces else ""
