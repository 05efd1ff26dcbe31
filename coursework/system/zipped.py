"""Files -> a zip, the same bytes for the same files, whenever and wherever it is made; and back.

Enters: names and contents.  Leaves: bytes.
Used by `word.py`, `open_document.py`, `downloads.py`, `zips.py` and `desk/answering/takeaway.py`.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterable

_EPOCH = (1980, 1, 1, 0, 0, 0)
_UNIX = 3
_STORED = "mimetype"  # of OpenDocument, which stands first and as it is


def zipped(files: Iterable[tuple[str, bytes]], mode: int = 0o600) -> bytes:
    """Return files as a zip without an hour; `mode` is who may read them once they are taken out."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        for name, content in files:
            part = zipfile.ZipInfo(name, _EPOCH)
            part.create_system, part.external_attr = _UNIX, mode << 16
            archive.writestr(part, content, zipfile.ZIP_STORED if name == _STORED else zipfile.ZIP_DEFLATED)
    return made.getvalue()


def unpacked(content: bytes) -> dict[str, bytes]:
    """Return the files of a zip of our own, or of a program that is trusted, by name."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}
