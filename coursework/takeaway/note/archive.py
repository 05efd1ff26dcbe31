"""A document that is a zip, to be rewritten.

Enters: the bytes of a zip.  Leaves: its files.  Used by `word.py` and `open_document.py`.
"""

from __future__ import annotations

import io
import zipfile


def unpacked(content: bytes) -> dict[str, bytes]:
    """Return the files of a zip by name."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}
