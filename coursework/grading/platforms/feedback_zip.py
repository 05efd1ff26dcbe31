"""Feedback pages -> the zip that Moodle gives back to students: its own folder names, one page in each.

Enters: folder names of the download and pages.  Leaves: bytes, the same for the same pages.
Used by whoever grades a class.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterable
from pathlib import PurePosixPath

from coursework.grading.platforms.names import file_stem

_EPOCH = (1980, 1, 1, 0, 0, 0)


def feedback_zip(pages: Iterable[tuple[str, str, bytes]]) -> bytes:
    """Return a zip of (folder of the download, id, page), the page named `feedback-ID.html`; sorted, without a clock."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as file:
        for folder, student, page in sorted(pages):
            top = PurePosixPath(folder.replace("\\", "/")).name
            part = zipfile.ZipInfo(f"{top}/feedback-{file_stem(student)}.html", _EPOCH)
            part.compress_type = zipfile.ZIP_DEFLATED
            part.external_attr = 0o644 << 16
            part.create_system = 3
            file.writestr(part, page)
    return content.getvalue()
