"""Text of a TOML file -> the line and column of every key and value, which the standard reader does not keep.

Enters: TOML that the standard reader has accepted.  Leaves: `Positions`.  Used by `source.py` and by `rewriting.py`.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import field

from coursework.system.frozen import changing

KeyPath = tuple[str | int, ...]  # path of a key: names of tables, indices in lists
_BLANK = re.compile(r"(?:[ \t\n]+|#[^\n]*)*")
_KEY_PART = re.compile(r"""[ \t]*(?:"((?:\\.|[^"\\\n])*)"|'([^'\n]*)'|([\w-]+))[ \t]*""")
_STRING = re.compile(
    r'''"""(?:\\.|[^\\])*?"{3,5}|\'\'\'.*?\'{3,5}|"(?:\\.|[^"\\\n])*"|'[^'\n]*\'''', re.DOTALL
)  # fmt: skip
_BARE = re.compile(r"[^,\]}#\n]+")
# A key and a value on one line, the most common form.
_PLAIN = re.compile(r"""([\w-]+)[ \t]*=[ \t]*(?!\"{3}|'{3})("(?:\\.|[^"\\\n])*"|'[^'\n]*'|[^\s"'\[{,\]}#][^,\]}#\n]*)""")


@changing
class Positions:
    """Line and column (from 1) of each path: of its value in `values`, of its key in `keys`; list indices count from 0.

    `spans` gives start and end of the text of each value, as offsets in the text.
    """

    values: dict[KeyPath, tuple[int, int]] = field(default_factory=dict)
    keys: dict[KeyPath, tuple[int, int]] = field(default_factory=dict)
    spans: dict[KeyPath, tuple[int, int]] = field(default_factory=dict)

    @property
    def lines(self) -> dict[KeyPath, int]:
        """Return the line of each key, and of each entry of a list."""
        return {path: line for places in (self.values, self.keys) for path, (line, _) in places.items()}

    def find(self, path: KeyPath, *, key: bool = False) -> tuple[int, int]:
        """Return (line, column) of the value at `path`, of its `key`, or of the nearest known ancestor; else (0, 0).

        A list of tables stands where its first one does.
        """
        while path:
            for places in (self.keys, self.values) if key else (self.values, self.keys):
                if path in places:
                    return places[path]
            if (*path, 0) in self.keys:
                return self.keys[*path, 0]
            path = path[:-1]
        return (0, 0)


def locate(text: str) -> Positions:
    """Return the positions of all keys and values of `text`."""
    return _Scanner(text).document()


class _Scanner:
    """One pass from left to right; every step advances, whatever the text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0
        self.found = Positions()
        self.starts = [0, *(match.end() for match in re.finditer("\n", text))]
        self.counts: dict[KeyPath, int] = {}

    def document(self) -> Positions:
        table: KeyPath = ()
        while self.blank():
            if self.text.startswith("[", self.at):
                table = self.header()
            else:
                self.pair(table)
        return self.found

    def blank(self) -> bool:
        """Skip spaces and comments; return whether any text is left."""
        self.at = self._end(_BLANK)
        return self.at < len(self.text)

    def header(self) -> KeyPath:
        several = self.text.startswith("[[", self.at)
        self.at += 1 + several
        begin = self.place()
        path: KeyPath = ()
        names = self.key()
        for number, name in enumerate(names, start=1):
            path = (*path, name)
            if several and number == len(names):
                self.counts[path] = self.counts.get(path, -1) + 1
            if path in self.counts:
                path = (*path, self.counts[path])
        self.found.keys.setdefault(path, begin)
        following = self.text.find("\n", self.at)
        self.at = following if following >= 0 else len(self.text)
        return path

    def pair(self, table: KeyPath) -> None:
        begin = self.place()
        if plain := _PLAIN.match(self.text, self.at):
            path = (*table, plain[1])
            self.found.keys.setdefault(path, begin)
            first, self.at = plain.start(2), plain.end()
            self.found.values.setdefault(path, (begin[0], begin[1] + first - plain.start()))
            self.found.spans.setdefault(path, (first, first + len(plain[2].rstrip())))
            return
        path = (*table, *self.key())
        self.found.keys.setdefault(path, begin)
        self.at = min(len(self.text), self.text.find("=", self.at) + 1 or len(self.text))
        self.value(path)

    def key(self) -> KeyPath:
        names: KeyPath = ()
        while match := _KEY_PART.match(self.text, self.at):
            names = (*names, next(part for part in (*match.groups(), "") if part is not None))
            self.at = match.end()
            if not self.text.startswith(".", self.at):
                break
            self.at += 1
        return names

    def value(self, path: KeyPath) -> None:
        self.blank()
        # The text of a long string begins after three quotation marks; columns are counted from one.
        shift = 2 if self.text.startswith(('"""', "'''"), self.at) else 0
        line, column = self.place()
        self.found.values.setdefault(path, (line, column + shift))
        begin, opening = self.at, self.text[self.at : self.at + 1]
        if opening in {"[", "{"}:
            self.inside(path, "]" if opening == "[" else "}")
        else:
            self.at = max(self.at + 1, self._end(_STRING if opening in {'"', "'"} else _BARE))
        self.found.spans.setdefault(path, (begin, begin + len(self.text[begin : self.at].rstrip())))

    def inside(self, path: KeyPath, closing: str) -> None:
        """Step through a list or an inline table."""
        self.at += 1
        entry = 0
        while self.blank() and not self.text.startswith(closing, self.at):
            if self.text.startswith(",", self.at):
                self.at += 1
            elif closing == "}":
                self.pair(path)
            else:
                self.value((*path, entry))
                entry += 1
        self.at += 1

    def place(self) -> tuple[int, int]:
        line = bisect_right(self.starts, self.at)
        return line, self.at - self.starts[line - 1] + 1

    def _end(self, pattern: re.Pattern[str]) -> int:
        match = pattern.match(self.text, self.at)
        return match.end() if match else self.at
