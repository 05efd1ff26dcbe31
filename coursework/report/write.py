"""The report of a run, written as whole files or not at all.

Enters: a `Run` and paths.  Leaves: files.  Raises `OutputError`; nothing half-written is left (`coursework.files`).
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from coursework.errors import OutputError
from coursework.files import write_bytes
from coursework.report.html import render_html
from coursework.report.model import ReportModel, build_model
from coursework.report.pdf import render_pdf
from coursework.run import Run


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
