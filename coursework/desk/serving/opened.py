"""What a desk opens with: the file of a name, a variant of the catalogue under that name, or an empty text.

Enters: a name and a folder.  Leaves: name, text, version.  Raises `InputError`.  Used by `server.py`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from coursework.desk.inside import is_name, refused_name
from coursework.desk.serving.folder import SUFFIX, Folder, etag_of
from coursework.variant.catalogue import names
from coursework.words.data_folders import folder as package_folder
from coursework.words.errors import InputError


def opened(name: str, folder: Path | None) -> dict[str, Any]:
    """Return `name`, `text` and `etag`, None for what is not in the folder yet."""
    stem = name.removesuffix(SUFFIX)
    if not name or folder is None:
        return {"name": "", "text": "", "etag": None}
    if not is_name(stem):
        raise InputError(refused_name(name))
    own = Folder(folder).read(stem)
    if own is not None:
        return {"name": stem, "text": own.decode("utf-8-sig", "replace"), "etag": etag_of(own)}
    known = stem.lower() in names()
    text = (package_folder("variants") / f"{stem.lower()}{SUFFIX}").read_text(encoding="utf-8") if known else ""
    return {"name": stem, "text": text, "etag": None}
