"""Feedback pages -> the zip that Moodle gives back to students: its own folder names, one page in each.

Enters: folder names of the download and pages.  Leaves: bytes, the same for the same pages.
Used by whoever grades a class.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import PurePosixPath

from coursework.grading.platforms.names import file_stem
from coursework.system.zipped import zipped


def feedback_zip(pages: Iterable[tuple[str, str, bytes]]) -> bytes:
    """Return a zip of (folder of the download, id, page), the page named `feedback-ID.html`; sorted, without a clock."""
    tops = ((PurePosixPath(folder.replace("\\", "/")).name, student, page) for folder, student, page in sorted(pages))
    return zipped(((f"{top}/feedback-{file_stem(student)}.html", page) for top, student, page in tops), 0o644)
