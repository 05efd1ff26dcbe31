"""The catalogue: which variants there are, and where one lies.

Enters: a name or a path.  Leaves: paths, titles.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from coursework.data import folder
from coursework.errors import InputError, closest


@dataclass(frozen=True, slots=True)
class Entry:
    """One line of the catalogue."""

    name: str
    title: str
    teaches: str
    source: str


def _natural(name: str) -> list[tuple[bool, int | str]]:
    return [(not part.isdigit(), int(part) if part.isdigit() else part) for part in re.split(r"(\d+)", name) if part]


def names() -> list[str]:
    """Return the names of the catalogue's variants, numbers in their order."""
    return sorted((path.stem for path in folder("variants").glob("*.toml")), key=_natural)


def entries() -> list[Entry]:
    """Return the catalogue."""
    listed = []
    for name in names():
        data = tomllib.loads((folder("variants") / f"{name}.toml").read_text(encoding="utf-8"))
        listed.append(Entry(name, str(data.get("title", "")), str(data.get("teaches", "")), str(data.get("source", ""))))
    return listed


def find(path_or_name: str | Path) -> Path:
    """Return the file of a path, or of a name in the catalogue.  Raises `InputError` with the closest name."""
    text = str(path_or_name)
    if re.fullmatch(r"[\w-]+", text):
        inside = folder("variants") / f"{text.lower()}.toml"
        if inside.is_file():
            return inside
        if not Path(text).exists():
            hint = closest(text.lower(), names())
            raise InputError(
                f'there is no variant "{text}" in the catalogue and no such file.{hint} "coursework variants" lists them.'
            )
    return Path(path_or_name)
