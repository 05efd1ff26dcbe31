"""All words of a report, from one file per language: `reports/words.<language>.toml`.

Enters: the key of a sentence and the values for its gaps.  Leaves: text.  No sentence of the report stands in Python.
Used by `report/`, `assigning/` and `commands/`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from coursework.report.text.numbers import Numbers, unit_text, with_unit
from coursework.report.text.text_runs import ITALIC
from coursework.system.frozen import frozen
from coursework.variant.formula.motion_units import in_latin
from coursework.words.sentences import ENGLISH, Phrases, load_phrases

_OWN_LETTER = re.compile(r"\*(\w)\*")  # *h* in the words file: a letter set italic


@frozen
class Words:
    """The words of one language, as a page sets them."""

    phrases: Phrases

    def __call__(self, key: str, **values: object) -> str:
        """Return a sentence, such as `words("table.thinned", step="5", …)`.  Raises `KeyError` for an unknown key."""
        text = with_own_letters(self.phrases.template(key))
        return self.phrases.filled(key, text, values) if values else text

    def has(self, key: str) -> bool:
        """Return whether there is a sentence with this key."""
        return self.phrases.has(key)

    def written(self, text: str) -> str:
        """Return a sentence of the tool in this language; any other text unchanged."""
        return self.phrases.written(text)

    def count(self, key: str, number: int, **values: object) -> str:
        """Return the sentence in the form that fits `number` ("key.one", "key.other" …), with {number} filled in."""
        return self(self.phrases.beside(key, number), number=self.numbers.whole(number), **values)

    def listing(self, words: list[str]) -> str:
        """Return "a, b and c"."""
        return self.phrases.listing(words)

    def sentences(self, told: Iterable[str]) -> str:
        """Return the sentences joined; empty ones are left out."""
        return self("join.sentences").join(part for part in told if part)

    def unit(self, unit: str) -> str:
        """Return a unit such as "rad/s" as this language writes it, "рад/с"."""
        return unit_text(self.phrases.unit(in_latin(unit)))

    def behind(self, unit: str) -> str:
        """Return the text that follows a symbol at an axis or in a head: ", rad/s" or "/(rad/s)"; "" without a unit."""
        join = self("join.unit")
        whole = f"({unit})" if "/" in join and "/" in unit else unit
        return join + whole if unit else ""

    def amount(self, number: str, unit: str) -> str:
        """Return a number followed by its unit, as this language writes it."""
        return self("amount.percent", value=number) if unit == "%" else with_unit(number, self.phrases.unit(in_latin(unit)))

    @property
    def numbers(self) -> Numbers:
        """Return the writer of numbers of this language."""
        return Numbers(self("decimal"), self.phrases.entries.get("units", {}))


def with_own_letters(text: str) -> str:
    """Return a sentence of the words file in which *h* is marked as a letter to be set italic."""
    return _OWN_LETTER.sub(rf"{ITALIC[0]}\1{ITALIC[1]}", text) if "*" in text else text


def load_words(language: str = ENGLISH) -> Words:
    """Return the words of a language.  Raises `InputError` if there is no file for it."""
    return Words(load_phrases(language).for_paper())
