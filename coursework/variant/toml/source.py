"""Bytes of a variant file -> plain data and positions; sizes are bounded before anything is read.

Enters: a path or bytes.  Leaves: `Source`.  Used by `reader.py`.
"""

from __future__ import annotations

import copy
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from coursework.system.frozen import frozen
from coursework.variant.formula.alphabet import spell, spell_path
from coursework.variant.toml.positions import KeyPath, Positions, locate
from coursework.words.errors import Fault, InputError
from coursework.words.reasons import reason_of
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MAX_BYTES = 64 * 1024
# A dotted key of 100 000 parts takes the TOML reader half a minute; a variant needs three.
_MAX_KEY_PARTS = 8
_MAX_NESTING = 20
_MOST_BITS = 2048
# Strings and comments; an unclosed string extends to the end of its line or of the file, so each letter is read once.
_NOT_STRUCTURE = re.compile(
    r'''"""(?:\\.|[^\\])*?(?:"""|\\?\Z)|"(?:\\.|[^"\\\n])*(?:"|\\?(?=\n|\Z))'''
    r"""|'''.*?(?:'''|\Z)|'[^'\n]*'?|#[^\n]*""",
    re.DOTALL,
)
# With what the files begin that word processors and browsers save; no TOML begins so.
_DOCUMENTS = {b"PK\x03\x04": "DOCX/ODT/ZIP", b"\xd0\xcf\x11\xe0": "DOC", b"{\\rtf": "RTF", b"%PDF": "PDF", b"<": "HTML"}
_BRACKET = re.compile(r"[\[\]{}]")
_MANY_PARTS = re.compile(rf"(?<![\w-])[\w-]++(?:[ \t]*+\.[ \t]*+[\w-]++){{{_MAX_KEY_PARTS}}}")


@frozen
class Source:
    """One variant file as data; `file` is its name in messages, `folder` the folder of files beside it, or these by name.

    A fault of a value in `made`, which was set for this run, names no line: the file does not have that value.
    """

    file: str
    folder: Path | Mapping[str, bytes]
    data: dict[str, Any]
    positions: Positions
    made: frozenset[KeyPath] = frozenset()

    def changed(self, changes: Mapping[KeyPath, Any]) -> Source:
        """Return the file with other values; names in `changes` are in the tool's spelling."""
        data = copy.deepcopy(self.data)
        for path, value in changes.items():
            inner: Any = data
            for part in path[:-1]:
                inner = inner[_spelt_as(part, inner)]
            key = _spelt_as(path[-1], inner)
            if path[0] == "given" and isinstance(inner[key], dict):  # the meaning of the datum stays
                inner, key = inner[key], "value"
            inner[key] = value
        return replace(self, data=data, made=self.made.union(changes))

    def fault(self, path: KeyPath, message: Sentence, column: int = 0, *, at_key: bool = False) -> Fault:
        """Return a fault at a value, or at its key; `column` counts inside the value's text (1 = its first character)."""
        if spell_path(path) in self.made:
            name = path[-1] if path[0] == "time" else path[1]
            return Fault(message, place=say("place.datum", variant=Path(self.file).stem, name=str(name)))
        line, start = self.positions.find(path, key=at_key)
        place = ".".join(str(part + 1) if isinstance(part, int) else part for part in path)
        if len(path) > 1 and path[0] == "constraint" and isinstance(path[1], int):
            place = say("place.constraint", name=self._name_of(path[1]))
            if inner := ", ".join(str(key) for key in path[2:] if key not in {"equation", "closure"}):
                place = say("place.inside", place=place, inner=inner)
        where = start + column if column else start
        # A missing key has no line; then the first line of the file is given.
        place = say("place.column", place=place, column=column) if column else place
        return Fault(message, self.file, line or 1, where if line else 0, place)

    def path_of(self, path: KeyPath) -> KeyPath:
        """Return a path in the tool's spelling as the file spells it; a single `guide` is the first of `guides`."""
        found: KeyPath = ()
        data: Any = self.data
        for part in path:
            if isinstance(part, int) and found[-1:] == ("guide",):
                continue
            if isinstance(data, dict):
                key = "guide" if part == "guides" and part not in data else _spelt_as(part, data)
                found, data = (*found, key), data.get(key)
            elif isinstance(data, list):
                found, data = (*found, part), data[part] if isinstance(part, int) and part < len(data) else None
            else:
                found = (*found, part)
        return found

    def _name_of(self, index: int) -> str:
        entry = self.data["constraint"][index] if isinstance(self.data["constraint"], list) else {}
        name = entry.get("name") if isinstance(entry, dict) else None
        if isinstance(name, int) and name.bit_length() > _MOST_BITS:
            name = ""
        return str(name) if isinstance(name, (str, int)) and name not in {"", True, False} else str(index + 1)


def _spelt_as(part: str | int, keys: Any) -> str | int:
    """Return a key as the file spells it, unchanged if the file does not have it."""
    return next((key for key in keys if spell(key) == part), part) if isinstance(part, str) else part


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a variant file; raises `InputError` if it is missing, too large or not a file."""
    try:
        if path.exists() and not path.is_file():
            raise InputError([Fault(say("fault.V001") if path.is_dir() else say("fault.V002"), str(path))])
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
        if len(content) > MAX_BYTES:
            raise InputError([_too_large(path.stat().st_size, str(path), content)])
        return content
    except InputError:
        raise
    except (OSError, ValueError) as error:
        reason = reason_of(error)
        missing = isinstance(error, FileNotFoundError)
        raise InputError([Fault(say("fault.V003") if missing else say("fault.V004", reason=reason), str(path))]) from error


def _too_large(size: int, file: str, content: bytes) -> Fault:
    """Return the fault of a file that begins with `content`, at the first line beyond the limit."""
    return Fault(say("fault.V006", size=size, max_bytes=MAX_BYTES), file, content[:MAX_BYTES].count(b"\n") + 1)


def read_source(content: bytes, file: str, folder: Path | Mapping[str, bytes]) -> Source:
    """Read TOML.  Raises `InputError` with line and column if the text is not TOML."""
    if len(content) > MAX_BYTES:
        raise InputError([_too_large(len(content), file, content)])
    if form := next((form for begin, form in _DOCUMENTS.items() if content.startswith(begin)), ""):
        raise InputError([Fault(say("fault.V021", format=form), file)])
    try:
        text = content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        column = error.start - (content.rfind(b"\n", 0, error.start) + 1) + 1
        message = say("fault.V007", content=content[error.start])
        raise InputError([Fault(message, file, line, column)]) from error
    structure = _structure(text)
    if line := _too_deep(structure):
        nested = say("fault.V008", parts=_MAX_KEY_PARTS, nesting=_MAX_NESTING)
        raise InputError([Fault(nested, file, line)])
    try:
        data = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        from coursework.variant.toml.faulty import explained

        raise InputError(explained(str(error), text, structure, file)) from error
    source = Source(file, folder, data, locate(text))
    # Hexadecimal digits make integers of any size, which Python neither prints nor converts to float.
    if huge := [*_huge(data, ())]:
        raise InputError([source.fault(path, say("fault.V005", digits=int(bits * 0.30103) + 1)) for path, bits in huge])
    return source


def _huge(data: Any, path: KeyPath) -> Iterator[tuple[KeyPath, int]]:
    """Yield path and number of bits of every integer too large to have a meaning."""
    if isinstance(data, int) and data.bit_length() > _MOST_BITS:
        yield path, data.bit_length()
    entries = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in entries:
        yield from _huge(value, (*path, key))


def _structure(text: str) -> list[str]:
    """Return the lines of a text without its strings and comments."""
    return _NOT_STRUCTURE.sub(lambda match: "q" + "\n" * match[0].count("\n"), text).split("\n")


def _too_deep(structure: list[str]) -> int:
    """Return the first line whose keys or brackets are nested too deeply, 0 if there is none.  Each letter is read once."""
    depth = 0
    for number, line in enumerate(structure, start=1):
        for bracket in _BRACKET.findall(line):
            depth += 1 if bracket in "[{" else -1
            if depth > _MAX_NESTING:
                return number
        if _MANY_PARTS.search(line):
            return number
    return 0
