"""Downloads from the desk, one file or several in a zip; and the check of a student's own table.

Enters: a `Desk`.  Leaves: an `Answer` with a file, or the findings of `precheck`.  Used by `bench.py`.
"""

from __future__ import annotations

import base64
import binascii
import mimetypes
from typing import Any

from coursework.desk.answering.typed import Desk
from coursework.desk.job import FORBIDDEN, OK, Answer, told
from coursework.grading.precheck import precheck
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.report.output.formats import chosen
from coursework.report.output.results import Results
from coursework.report.text.symbols import with_symbols
from coursework.system.files.zipped import zipped

NO_DATA = 422


def take(desk: Desk) -> Answer:
    """Return the file of a format, several files as one zip.  Raises `InputError` for an unknown format."""
    (wanted,) = chosen([str(desk.body["format"])], "run")
    offered = desk.setup.policy.formats
    if offered and wanted.suffix not in offered:
        return told(FORBIDDEN, desk.language, "desk.not_offered")
    results = Results(desk.run, desk.language)
    results.compute(pages=wanted.paged)
    files = list(wanted.write(results))
    if len(files) == 1:
        name, content = files[0]
        suffix = name.rpartition(".")[2]
        kind = mimetypes.guess_type(name)[0] or "application/octet-stream"
        return Answer(OK, kind, content, f"{desk.name}.{suffix}")
    return Answer(OK, "application/zip", zipped(files), f"{desk.name}-{wanted.suffix}.zip")


def table(desk: Desk) -> dict[str, Any] | Answer:
    """Return the findings of `precheck` on one file: read, partly read or unreadable, and why."""
    try:
        content = base64.b64decode(str(desk.body["data"]), validate=True)
    except (binascii.Error, ValueError):
        return told(NO_DATA, desk.language, "desk.other_kind", name="data")
    submission = Submission("desk", None, (submitted_file(str(desk.body["name"])[:200], content),))
    found = precheck(submission, desk.variant, with_symbols)
    state = "read" if found.fine else "partly" if found.has_table else "unreadable"
    sentences = [desk.words.written(sentence) for sentence in (*found.sentences, *found.notes)]
    return {"state": state, "sentences": [with_symbols(sentence, desk.variant.columns) for sentence in sentences]}
