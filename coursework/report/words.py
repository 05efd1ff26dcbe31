"""All words of a report, from one file a language: `reports/words.<language>.toml`.

Enters: the key of a sentence and what it speaks about.  Leaves: text.  No sentence of the report stands in Python.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from coursework.data import folder
from coursework.errors import InputError, closest, listing
from coursework.report.lettering import ITALIC
from coursework.report.numbers import Numbers

_OWN_LETTER = re.compile(r"\*(\w)\*")  # *h* in the words file: a letter set italic


@dataclass(frozen=True, slots=True)
class Words:
    """The words of one language."""

    language: str
    entries: dict[str, Any]

    def __call__(self, key: str, **values: object) -> str:
        """Return a sentence, such as `words("table.thinned", step="5", …)`.  Raises `KeyError` for an unknown key."""
        entry: Any = self.entries
        for part in key.split("."):
            entry = entry[part]
        text = _OWN_LETTER.sub(rf"{ITALIC[0]}\1{ITALIC[1]}", str(entry))
        return text.format(**values) if values else text

    def has(self, key: str) -> bool:
        """Return whether there is such a sentence."""
        entry: Any = self.entries
        for part in key.split("."):
            if not isinstance(entry, dict) or part not in entry:
                return False
            entry = entry[part]
        return True

    def count(self, key: str, number: int, **values: object) -> str:
        """Return the sentence for one or for many ("key.one", "key.many"), with {number}."""
        return self(f"{key}.{'one' if number == 1 else 'many'}", number=self.numbers.whole(number), **values)

    def listing(self, words: list[str]) -> str:
        """Return "a, b and c"."""
        return listing(words, self("and"))

    @property
    def numbers(self) -> Numbers:
        """Return the writer of numbers of this language."""
        return Numbers(self("decimal"))


@lru_cache
def load_words(language: str = "en") -> Words:
    """Return the words of a language.  Raises `InputError` where there is no such file."""
    place = folder("reports")
    path = place / f"words.{language}.toml"
    if not path.is_file():
        known = sorted(file.name.split(".")[1] for file in place.glob("words.*.toml"))
        hint = closest(language, known) or f" There is: {listing(known)}."
        raise InputError(f'no words for the language "{language}" in {place}.{hint}')
    return Words(language, tomllib.loads(path.read_text(encoding="utf-8")))
