"""What the tool finds, in sentences that can be said in any language.

Enters: a key of `reports/words.<language>.toml` and what the sentence speaks about.  Leaves: `Sentence`, English text for
whoever prints it, which still knows key and parts for whoever writes a page in another language.
Used by every floor above; no finding that reaches a page is written in Python.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from coursework.data import folder
from coursework.errors import InputError, closest, listing
from coursework.schemes import Scheme

ENGLISH = "en"


class Sentence(str):
    """English text with its `key` and `values`; values may be numbers, texts, sentences, or tuples that become a list."""

    key: str
    values: Mapping[str, object]

    def __new__(cls, text: str, key: str, values: Mapping[str, object]) -> Sentence:
        """Return the text with what it was made of."""
        made = super().__new__(cls, text)
        made.key, made.values = key, values
        return made

    def __getnewargs__(self) -> tuple[str, str, Mapping[str, object]]:  # type: ignore[override]
        """Return what a copy in another process is made from."""
        return str(self), self.key, self.values


@dataclass(frozen=True, slots=True)
class Phrases:
    """The words file of one language."""

    language: str
    entries: Mapping[str, Any]
    _templates: dict[str, str] = field(default_factory=dict, repr=False, compare=False)  # those read so far

    def has(self, key: str) -> bool:
        """Return whether there is such a sentence."""
        return isinstance(self._found(key), str)

    def template(self, key: str) -> str:
        """Return a sentence with its gaps, in English where this language has none yet.  Raises `KeyError` for an unknown key."""
        if (known := self._templates.get(key)) is not None:
            return known
        found = self._found(key)
        if isinstance(found, str):
            self._templates[key] = found
            return found
        if self.language == ENGLISH:
            raise KeyError(f"words.{ENGLISH}.toml has no sentence {key}")
        return load_phrases().template(key)

    def filled(self, key: str, template: str, values: Mapping[str, object]) -> str:
        """Return a template with its gaps filled.  Raises `InputError` for a gap that the program does not know."""
        try:
            return template.format(**values)
        except (KeyError, IndexError, ValueError, AttributeError) as error:
            known = ", ".join(f"{{{name}}}" for name in values) or "none"
            place = f"words.{self.language}.toml, {key}"
            raise InputError(f"{place}: the gaps of this sentence cannot be filled ({error}). Known gaps: {known}.") from error

    def written(self, text: str) -> str:
        """Return a `Sentence` in this language; any other text as it is."""
        if not isinstance(text, Sentence) or self.language == ENGLISH:
            return text
        if not (self.has(text.key) or load_phrases().has(text.key)):
            return str(text)  # the title of a record, which this language does not translate
        return self.composed(text.key, text.values)

    def composed(self, key: str, values: Mapping[str, object]) -> str:
        """Return the sentence of a key with its gaps filled."""
        template = self.template(key)
        parts = values.get("parts")
        if isinstance(parts, tuple):
            return template.join(map(self.written, parts))
        return self.filled(key, template, {name: self._filling(value) for name, value in values.items()})

    def _found(self, key: str) -> object:
        entry: Any = self.entries
        for part in key.split("."):
            if not isinstance(entry, dict) or part not in entry:
                return None
            entry = entry[part]
        return entry

    def _filling(self, value: object) -> object:
        if isinstance(value, tuple):
            return listing([self.written(part) for part in value], self.template("and"))
        if isinstance(value, float):
            return _Number(value, self.template("decimal"))
        return self.written(value) if isinstance(value, str) else value


class _Number(float):
    """A number that is written with the decimal sign of a language, whatever its format."""

    mark: str

    def __new__(cls, value: float, mark: str) -> _Number:
        made = super().__new__(cls, value)
        made.mark = mark
        return made

    def __format__(self, spec: str) -> str:
        return super().__format__(spec).replace(".", self.mark)


@cache
def load_phrases(language: str = ENGLISH) -> Phrases:
    """Return the words of a language.  Raises `InputError` where there is no such file."""
    place = folder("reports")
    path = place / f"words.{language}.toml"
    if not path.is_file():
        known = sorted(file.name.split(".")[1] for file in place.glob("words.*.toml"))
        hint = closest(language, known) or f" There is: {listing(known)}."
        raise InputError(f'no words for the language "{language}" in {place}.{hint}')
    return Phrases(language, tomllib.loads(path.read_text(encoding="utf-8")))


def say(key: str, /, **values: object) -> Sentence:
    """Return a finding, such as `say("check.STOP.pass", rows=25)`.  Raises `KeyError` for an unknown key."""
    return Sentence(load_phrases().composed(key, values), key, values)


def title_of(scheme: Scheme) -> Sentence:
    """Return what a scheme is called: by its record, or where a words file says so by the key `scheme.NAME`."""
    key = f"scheme.{scheme.name}"
    return say(key) if load_phrases().has(key) else Sentence(scheme.title, key, {})


def say_count(key: str, number: int, /, **values: object) -> Sentence:
    """Return the finding for one or for many ("key.one", "key.many"), with {number}."""
    return say(f"{key}.{'one' if number == 1 else 'many'}", number=number, **values)


def joined(parts: Iterable[str], between: str = "join.sentences") -> Sentence:
    """Return findings one behind the other; `between` is the key of what stands between them.  Empty ones are left out."""
    return say(between, parts=tuple(part for part in parts if part))
