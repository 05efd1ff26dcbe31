"""Where the files that are no code lie: the variants and the looks of a page, and an instructor's own pieces before these.

Enters: the name of a folder; a folder of own pieces.  Leaves: a path.  Any floor may ask.
Used by `catalogue.py`, `page_text.py`, `sentences.py`, `assigning/`, `commands/` and `grading/batch/`.
"""

from __future__ import annotations

import hashlib
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

REPORTS = "reports"
PACKAGE = "package"  # in the names that own templates extend or import
_standing_in: list[Path] = []


def folder(name: str) -> Path:
    """Return the folder `name` ("variants", "reports"): inside the installed package, else beside it in a checkout.

    Raises `FileNotFoundError` where neither exists (a broken installation).
    """
    return _standing_in[-1] if name == REPORTS and _standing_in else _of_package(name)


def _of_package(name: str) -> Path:
    package = Path(__file__).resolve().parent
    for place in (package / name, package.parent / name):
        if place.is_dir():
            return place
    raise FileNotFoundError(f'the folder "{name}" is missing beside {package}. Install the package again.')


@contextmanager
def own_pieces(own: Path | None) -> Iterator[None]:
    """Let the files of a folder stand before those of `reports/` of the same name; what it does not have stays as it is.

    Templates include each other by name, and Typst reads from one folder only, so both are laid together for as long as this
    lasts.  The pieces of the package stand in "package/" beside them, to be extended.  Own pieces are the instructor's, and
    trusted; the folder itself is only read.
    """
    if own is None:
        yield
        return
    with tempfile.TemporaryDirectory(prefix="coursework-templates-") as place:
        together = Path(place) / REPORTS
        shutil.copytree(_of_package(REPORTS), together)
        shutil.copytree(_of_package(REPORTS), together / PACKAGE)
        for path in pieces_in(own):
            target = together / path.relative_to(own)
            target.parent.mkdir(exist_ok=True)
            shutil.copyfile(path, target)
        _standing_in.append(together)
        try:
            yield
        finally:
            _standing_in.remove(together)


def pieces_in(own: Path) -> list[Path]:
    """Return the files of a folder of own pieces, and of the folders in it that `reports/` has too."""
    parts = [own, *(own / part.name for part in sorted(_of_package(REPORTS).iterdir()) if part.is_dir())]
    return sorted(path for part in parts if part.is_dir() for path in part.iterdir() if path.is_file())


def pieces_in_use() -> dict[str, bytes]:
    """Return the own pieces that stand in now, by name: what another process or machine needs to write the same pages."""
    if not _standing_in:
        return {}
    together, package = _standing_in[-1], _of_package(REPORTS)
    found = {path.relative_to(together).as_posix(): path.read_bytes() for path in pieces_in(together)}
    return {
        name: content
        for name, content in found.items()
        if not (package / name).is_file() or (package / name).read_bytes() != content
    }


@contextmanager
def pieces_standing_in(pieces: Mapping[str, bytes]) -> Iterator[None]:
    """Let pieces that `pieces_in_use` gave in another process stand in here."""
    if not pieces:
        yield
        return
    with tempfile.TemporaryDirectory(prefix="coursework-pieces-") as place:
        for name, content in pieces.items():
            target = Path(place) / name
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(content)
        with own_pieces(Path(place)):
            yield


def stamp_of_pieces() -> str:
    """Return a hash of the own pieces in use, "" without any: what is written with others is another page."""
    digest = hashlib.sha256()
    pieces = pieces_in_use()
    for name, content in sorted(pieces.items()):
        digest.update(name.encode() + b"\0" + content)
    return digest.hexdigest() if pieces else ""
