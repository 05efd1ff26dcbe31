"""Files -> a zip with the same bytes for the same files, whenever and wherever it is made; and back.

Enters: names and contents.  Leaves: bytes.
Used by `word.py`, `open_document.py`, `downloads.py`, `zips.py`, `sources.py`, `archive.py`, `read_submission.py` and
`desk/answering/takeaway.py`.
"""

from __future__ import annotations

import io
import zipfile
import zlib
from collections.abc import Iterable
from contextlib import suppress

# Every error of a zip that is damaged, or packed in a way that is not known here.
DAMAGED: tuple[type[Exception], ...] = (
    zipfile.BadZipFile, RuntimeError, OSError, NotImplementedError, EOFError, ValueError, zlib.error,
)  # fmt: skip
with suppress(ImportError):  # some builds of Python are without it
    from lzma import LZMAError

    DAMAGED += (LZMAError,)

_EPOCH = (1980, 1, 1, 0, 0, 0)
_UNIX = 3
_STORED = "mimetype"  # OpenDocument requires this file to be stored uncompressed


def zipped(files: Iterable[tuple[str, bytes]], mode: int = 0o600) -> bytes:
    """Return the files as a zip without time stamps; `mode` holds the permission bits of the unpacked files."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        for name, content in files:
            part = zipfile.ZipInfo(name, _EPOCH)
            part.create_system, part.external_attr = _UNIX, mode << 16
            archive.writestr(part, content, zipfile.ZIP_STORED if name == _STORED else zipfile.ZIP_DEFLATED)
    return made.getvalue()


def unpacked(content: bytes) -> dict[str, bytes]:
    """Return the files (name -> content) of a zip made by this tool or by a trusted program."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}
