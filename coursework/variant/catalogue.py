"""The catalogue: which variants there are, where one lies, and the variant of a name or a path.

Enters: a name or a path.  Leaves: paths, titles, a `Variant`.
Used by `api.py`, `cli.py`, `commands/`, `grading/` and `grading/batch/`.
"""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING

from coursework.system.frozen import frozen
from coursework.words.data_folders import folder
from coursework.words.errors import InputError
from coursework.words.sentences import ENGLISH, closest, say

if TYPE_CHECKING:
    from coursework.variant.reading.reader import Judge
    from coursework.variant.record.variant import Variant


@frozen
class Entry:
    """One line of the catalogue."""

    name: str
    title: str
    teaches: str
    source: str


def _natural(name: str) -> list[tuple[bool, int | str]]:
    return [(not part.isdigit(), int(part) if part.isdigit() else part) for part in re.split(r"(\d+)", name) if part]


def names() -> list[str]:
    """Return the names of the catalogue's variants, numbers in their order.

    >>> import coursework
    >>> coursework.names()[:3]
    ['31', '31-forces', 'andrews']
    """
    return sorted((path.stem for path in folder("variants").glob("*.toml")), key=_natural)


def entries(language: str = ENGLISH) -> list[Entry]:
    """Return the catalogue, in a language as far as the files speak it."""
    listed = []
    for name in names():
        data = tomllib.loads((folder("variants") / f"{name}.toml").read_text(encoding="utf-8"))
        said = {**data, **data.get("text", {}).get(language, {})}
        listed.append(Entry(name, *(str(said.get(key, "")) for key in ("title", "teaches", "source"))))
    return listed


def find(path_or_name: str | Path | int) -> Path:
    """Return the file of a name in the catalogue, of a path, or of a path without its ending .toml.

    A file of the current folder stands before a variant of the catalogue with its name.
    Raises `InputError` for a name that is none of these, with the closest one.
    """
    text = str(path_or_name)
    is_name = re.fullmatch(r"[\w-]{1,60}", text) is not None
    if is_name and text.lower() in names():
        return own_file(text) or folder("variants") / f"{text.lower()}.toml"
    path = Path(text)
    ended = path.with_name(f"{path.name}.toml") if path.name and path.suffix != ".toml" else path
    if _is_file(ended) or _is_file(path):
        return ended if _is_file(ended) else path
    # An editor on Windows adds ".txt" behind the name, and the file manager does not show it.
    if path.name and _is_file(doubled := ended.with_name(f"{ended.name}.txt")):
        raise InputError(say("fault.C013", ended=ended, doubled=doubled, name=ended.name))
    if is_name and not path.is_dir():
        hint = closest(text.lower(), [*names(), *(file.stem for file in sorted(Path().glob("*.toml")))])
        raise InputError(say("fault.C014", text=text, ended=ended, hint=hint))
    return path


def own_file(path_or_name: str | Path) -> Path | None:
    """Return the file of the current folder that is taken in place of a variant of the catalogue, None where there is none."""
    text = str(path_or_name)
    if text.lower() not in names():
        return None
    path = Path(f"{text}.toml")
    is_other = _is_file(path) and not path.samefile(folder("variants") / f"{text.lower()}.toml")
    return path if is_other else None


def variant_from(given: object, judge: Judge | None = None) -> Variant:
    """Return a variant as it is, or that of a name, a path or a number.  Raises `TypeError` for anything else."""
    from coursework.variant.record.variant import Variant

    if isinstance(given, Variant):
        return given
    if isinstance(given, bool) or not isinstance(given, (str, Path, int)):
        raise TypeError(say("fault.D024", found=type(given).__name__))
    return load(given, judge)


def load(path_or_name: str | Path | int, judge: Judge | None = None) -> Variant:
    """Return the variant of a file or of the catalogue.  Raises `InputError` with every fault, each with its line.

    `judge` adds what a floor above knows to be wrong with a file that has faults.

    >>> import coursework
    >>> variant = coursework.load("31")
    >>> [c.name for c in variant.coordinates], variant.time.step  # s
    (['phi1', 'phi2', 'phi3'], 0.02)
    """
    from coursework.variant.reading.reader import read_variant

    return read_variant(find(path_or_name), judge)


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name longer than the system knows
        return False
