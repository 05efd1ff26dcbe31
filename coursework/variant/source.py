"""Bytes of a variant file -> plain data and positions; sizes bounded before anything is read.

Enters: a path or bytes.  Leaves: `Source`.  Used by `reader.py`.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from coursework.errors import Fault, InputError
from coursework.variant.positions import Positions, locate

MAX_BYTES = 64 * 1024
# A dotted key of 100 000 parts keeps the TOML reader busy for half a minute; a variant needs three.
_MAX_KEY_PARTS = 8
_MAX_BRACKETS = 40


@dataclass(frozen=True, slots=True)
class Source:
    """One variant file as data; `file` is the name used in messages."""

    file: str
    folder: Path | None
    data: dict[str, Any]
    positions: Positions

    def fault(self, path: tuple[str | int, ...], message: str, column: int = 0) -> Fault:
        """Return a fault at a key; `column` counts inside the key's text (1 = its first character)."""
        line, start = self.positions.find(path)
        place = ".".join(str(part + 1) if isinstance(part, int) else part for part in path)
        if len(path) > 1 and path[0] == "constraint" and isinstance(path[1], int):
            place = f"constraint {self.data['constraint'][path[1]].get('name', path[1] + 1)}"
        where = start + column if column else start
        return Fault(message, self.file, line, where if line else 0, place + (f", column {column}" if column else ""))


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a variant file; raises `InputError` where it is missing, too large or not a file."""
    try:
        if path.stat().st_size > MAX_BYTES:
            message = f"the file has {path.stat().st_size} bytes; a variant file has at most {MAX_BYTES}."
            raise InputError([Fault(message, str(path))])
        return path.read_bytes()
    except OSError as error:
        reason = {"FileNotFoundError": "there is no such file", "IsADirectoryError": "this is a folder"}
        raise InputError(
            [Fault(f"the file cannot be read: {reason.get(type(error).__name__, error.strerror)}.", str(path))]
        ) from error


def read_source(content: bytes, file: str, folder: Path | None) -> Source:
    """Read TOML.  Raises `InputError` with line and column for anything that is not."""
    if len(content) > MAX_BYTES:
        raise InputError([Fault(f"the file has {len(content)} bytes; at most {MAX_BYTES} are read.", file)])
    try:
        text = content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        message = f"byte {error.start} is not UTF-8 text. Save the file as UTF-8 (in Notepad: Save as, Encoding UTF-8)."
        raise InputError([Fault(message, file, line)]) from error
    if problem := _too_deep(text):
        raise InputError([Fault("keys or lists are nested beyond what a variant needs.", file, problem)])
    try:
        data = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        raise InputError([_toml_fault(str(error), file)]) from error
    return Source(file, folder, data, locate(text))


def _too_deep(text: str) -> int:
    for number, line in enumerate(text.splitlines(), start=1):
        bare = re.sub(r'"[^"]*"|\'[^\']*\'', "", line).split("#")[0]
        if bare.split("=")[0].count(".") > _MAX_KEY_PARTS or bare.count("[") + bare.count("{") > _MAX_BRACKETS:
            return number
    return 0


def _toml_fault(message: str, file: str) -> Fault:
    match = re.search(r"^(.*?) \(at line (\d+), column (\d+)\)", message)
    reason, line, column = (match[1], int(match[2]), int(match[3])) if match else (message, 0, 0)
    if reason.startswith("Cannot overwrite"):
        reason = "this key stands twice"
    return Fault(f"the file is not TOML here: {reason[:1].lower()}{reason[1:]}.", file, line, column)
