"""Whole files or none: written beside their place, then put there in one move.

Enters: bytes and a path.  Leaves: the file.  Raises `OutputError`; nothing half-written is left.
"""

from __future__ import annotations

import errno
import os
import secrets
from collections.abc import Callable
from pathlib import Path

from coursework.errors import OutputError
from coursework.report.html import render_html
from coursework.report.model import ReportModel, build_model
from coursework.report.pdf import render_pdf
from coursework.report.source import Run

_ADVICE = {
    errno.ENOSPC: "the disk is full. Free some space, or choose another folder with --out.",
    errno.EDQUOT: "your share of the disk is used up. Free some space, or choose another folder with --out.",
    errno.EACCES: "the folder or file is not writable. Close it in other programs, or choose another folder with --out.",
    errno.EPERM: "the folder or file is not writable. Close it in other programs, or choose another folder with --out.",
    errno.EROFS: "the disk is read-only. Choose another folder with --out.",
    errno.ENOTDIR: "a part of the path is a file, not a folder. Choose another folder with --out.",
    errno.EEXIST: "a part of the path is a file, not a folder. Choose another folder with --out.",
    errno.EISDIR: "there is a folder of this name. Remove it, or choose another folder with --out.",
    errno.ENAMETOOLONG: "the name is too long. Choose a shorter one.",
}


def write_bytes(path: Path | str, content: bytes) -> None:
    """Write a whole file; folders on the way are made.  Raises `OutputError`, leaving what was there before."""
    target = Path(path)
    part = target.with_name(f".coursework-{os.getpid()}-{secrets.token_hex(4)}.part")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            with part.open("xb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            part.replace(target)
        except BaseException:
            part.unlink(missing_ok=True)
            raise
    except OSError as error:
        advice = _ADVICE.get(error.errno or 0, f"{error.strerror or error}. Choose another folder with --out.")
        raise OutputError(f"{target}: could not be written: {advice}") from error


def write_report(run: Run, *paths: Path | str, language: str = "en") -> None:
    """Write the report of a run to each path; the suffix, .html or .pdf, decides the kind.

    The model (and its figures) is built once.  All kinds are rendered before the first file is touched.
    Raises `OutputError` for another suffix, a missing typst, or a file that cannot be written.
    """
    targets = [Path(path) for path in paths]
    renderers = [_renderer(target) for target in targets]
    model = build_model(run, language)
    contents = [render(model) for render in renderers]
    for target, content in zip(targets, contents, strict=True):
        write_bytes(target, content)


def _renderer(target: Path) -> Callable[[ReportModel], bytes]:
    kinds: dict[str, Callable[[ReportModel], bytes]] = {
        ".html": lambda model: render_html(model).encode("utf-8"),
        ".pdf": render_pdf,
    }
    if target.suffix.lower() not in kinds:
        raise OutputError(f"{target}: a report ends in .html or .pdf (found {target.suffix or 'no suffix'}).")
    return kinds[target.suffix.lower()]
