"""Mechanisms that tests look at: files beside this one, in the terms of the field, each of which runs as it is.

In: a name of this folder or of the catalogue, and what shall be another. Out: the text of a variant. Used by tests of all rooms.
"""

from __future__ import annotations

import re
from pathlib import Path

from coursework.words.data_folders import folder

FOLDERS = Path(__file__).parent, folder("variants")


def mechanism(name: str, *changes: tuple[str, str], **values: str | None) -> str:
    """Return the text of a mechanism with `changed` parts.

    >>> '"2 rad/s"' in mechanism("four-bar", ('start = "0 deg"', 'start = "1 rad"'), n="2 rad/s", period=None)
    True
    """
    (file,) = [path for place in FOLDERS if (path := place / f"{name}.toml").exists()]
    return changed(file.read_text(encoding="utf-8"), *changes, **values)


def changed(text: str, *changes: tuple[str, str], **values: str | None) -> str:
    """Return a text whose keys have other values or, where None, no line any more; then other parts wherever they stand.

    A key that does not stand there exactly once, or a part that does not stand there, is a fault of the test: AssertionError.
    """
    for key, value in values.items():
        quoted = value if value is None or value.startswith(("{", "[")) else f'"{value}"'
        line = "" if quoted is None else f"{key} = {quoted}\n"
        text, count = re.subn(rf"^{key} *= .*\n", lambda _, line=line: line, text, flags=re.M)
        assert count == 1, f"{count} lines of the text give {key}"
    for old, new in changes:
        assert old in text, f"nowhere in the text: {old}"
        text = text.replace(old, new)
    return text
