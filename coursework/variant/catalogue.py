"""The catalogue: the names of its variants, the file of each, and loading a variant by name or path.

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
    """Return the names of the catalogue's variants, sorted with numbers in numerical order.

    >>> import coursework
    >>> coursework.names()[:3]
    ['31', '31-forces', 'andrews']
    """
    return sorted((path.stem for path in folder("variants").glob("*.toml")), key=_natural)


def entries(language: str = ENGLISH) -> list[Entry]:
    """Return the catalogue, with texts in `language` where the files have them."""
    listed = []
    for name in names():
        data = tomllib.loads((folder("variants") / f"{name}.toml").read_text(encoding="utf-8"))
        said = {**data, **data.get("text", {}).get(language, {})}
        listed.append(Entry(name, *(str(said.get(key, "")) for key in ("title", "teaches", "source"))))
    return listed


def find(path_or_name: str | Path | int) -> Path:
    """Return the file of a variant, given a name in the catalogue, a path, or a path without its ending .toml.

    A file in the current folder takes precedence over a variant of the catalogue with the same name.
    Raises `InputError`, with the closest name, if nothing is found.
    """
    text = str(path_or_name)
    is_name = re.fullmatch(r"[\w-]{1,60}", text) is not None
    if is_name and text.lower() in names():
        return own_file(text) or folder("variants") / f"{text.lower()}.toml"
    path = Path(text)
    ended = path.with_name(f"{path.name}.toml") if path.name and path.suffix != ".toml" else path
    if _is_file(ended) or _is_file(path):
        return ended if _is_file(ended) else path
    # An editor on Windows may append ".txt" to the name, and the file manager hides it.
    hidden = (ended.with_name(f"{stem}.txt") for stem in (ended.name, ended.stem)) if path.name else ()
    if doubled := next(filter(_is_file, hidden), None):
        raise InputError(say("fault.C013", ended=ended, doubled=doubled, name=ended.name))
    if re.fullmatch(r"[\w-]{1,60}(\.toml)?", text) and not path.is_dir():
        if ended.is_symlink():  # it leads nowhere: reading tells why
            return ended
        known = [*names(), *(file.stem for file in sorted(Path().glob("*.toml")))]
        stem = ended.stem.lower()
        number = re.search(r"\d*$", stem)  # variant31 is 31
        hint = closest(number[0] if number and number[0] in known else stem, known)
        raise InputError(say("fault.C014", text=text, ended=ended, hint=hint))
    return path


def own_file(path_or_name: str | Path) -> Path | None:
    """Return the file in the current folder that replaces a catalogue variant of the same name, None if there is none."""
    text = str(path_or_name)
    if text.lower() not in names():
        return None
    path = Path(f"{text}.toml")
    is_other = _is_file(path) and not path.samefile(folder("variants") / f"{text.lower()}.toml")
    return path if is_other else None


def variant_from(given: object, judge: Judge | None = None) -> Variant:
    """Return a variant unchanged, or load one from a name, path or number.  Raises `TypeError` for any other object."""
    from coursework.variant.record.variant import Variant

    if isinstance(given, Variant):
        return given
    if isinstance(given, bool) or not isinstance(given, (str, Path, int)):
        raise TypeError(say("fault.D024", found=type(given).__name__))
    return load(given, judge)


def load(path_or_name: str | Path | int, judge: Judge | None = None) -> Variant:
    """Return the variant of a file or of the catalogue.  Raises `InputError` with every fault, each with its line.

    `judge` adds the faults that only a higher floor can find, if the file has faults at all.

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
    except OSError:  # the name is longer than the system allows
        return False
