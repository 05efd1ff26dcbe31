"""Results -> files: single pages, or all files of a run as one set.

Enters: a `SceneRun` or `Results`, and paths.  Leaves: files.  Raises `OutputError` and then leaves no half-written file.
Used by the command line and by `coursework.write_report`.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path

from coursework.report.output.formats import Format, formats_for
from coursework.report.output.record import as_json
from coursework.report.output.results import Results
from coursework.scene.scene_run import SceneRun
from coursework.system.files.file_set import publish
from coursework.system.files.whole_files import refused, write_bytes, write_through, wrong_ending
from coursework.words.errors import NotToBeHad, OutputError
from coursework.words.sentences import either, say


def write_report(run: SceneRun, *paths: Path | str, language: str = "en") -> None:
    """Write the report of a run to each path; the suffix, .html or .pdf, decides the format.

    The model (and its figures) is built once.  All pages are rendered before the first file is touched.
    Raises `OutputError` for another suffix, a missing typst, or a file that cannot be written.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import coursework
    >>> run = coursework.solve("31", quantities=["table"])
    >>> with TemporaryDirectory() as folder:
    ...     coursework.write_report(run, Path(folder, "report.html"))
    ...     [file.name for file in Path(folder).iterdir()]
    ['report.html']
    """
    if not isinstance(run, SceneRun):
        raise OutputError(say("fault.D027", found=type(run).__name__))
    if not paths:
        raise OutputError(say("fault.W030"))
    targets = [Path(path) for path in paths]
    formats = [_page_format(target) for target in targets]
    results = Results(run, language)
    results.compute(pages=True)
    pages = [next(each.write(results))[1] for each in formats]
    for target, page in zip(targets, pages, strict=True):
        write_bytes(target, page)


def _page_format(target: Path) -> Format:
    known = formats_for("write_report")
    suffix = target.suffix.lower().removeprefix(".")
    if suffix not in known:
        endings = either([f".{each}" for each in known])
        raise wrong_ending(target, endings)
    return known[suffix]


def write_set(results: Results, formats: Sequence[Format], folder: Path, hidden: Path) -> list[str]:
    """Write results to `folder` as one set and return the names of its files, the record last.

    Everything is written to `hidden` (on the same disk, see `working_folder`) before anything in `folder` is touched.
    The record names the stamp of the run and the SHA-256 of each file.  A format that this run cannot have is left out, and
    the reason is added to `results.refused`.
    """
    digests: dict[str, str] = {}
    for each in formats:
        try:
            for name, content in each.write(results):
                if name in digests:
                    continue  # a drawing that two formats write
                with refused(folder / name):
                    (hidden / name).parent.mkdir(parents=True, exist_ok=True)
                    write_through(hidden / name, content)
                digests[name] = hashlib.sha256(content).hexdigest()
        except NotToBeHad as error:
            results.refused.append(error)
    record = {**results.record(), "stamp": results.stamp, "files": digests}
    with refused(folder / results.record_name):
        write_through(hidden / results.record_name, as_json(record))
    publish(hidden, folder, digests, results.record_name)
    return [*digests, results.record_name]
