"""The findings of the tool as sentences that can be written in any language.

Enters: a key of `reports/words.<language>.toml` and the values in the sentence.  Leaves: `Sentence`, English text to print, which
still knows its key and values, so that a page can write it in another language.
Used by every floor above; no finding that reaches a page is written in Python.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from string import Formatter
from typing import Any

from coursework.words.data_folders import REPORTS, folder, folder_of_package
from coursework.words.errors import InputError
from coursework.words.generated_code import made_once
from coursework.words.scripts import OPEN_SPACE, closed_up
from coursework.words.sentence import Sentence
from coursework.words.words_file import line_of, read_words

ENGLISH = "en"
# Name of a rule -> the plural form for a whole number.  "other" is used for a number that is not whole and for a form that the
# words file does not have.
PLURALS: dict[str, Callable[[int], str]] = {
    "one-other": lambda n: "one" if n == 1 else "other",
    "one-few-many": lambda n: (
        "one" if n % 10 == 1 and n % 100 != 11 else "few" if n % 10 in {2, 3, 4} and n % 100 not in {12, 13, 14} else "many"
    ),
    "other": lambda n: "other",
}
_ROUND = ":r}"  # our own format of numbers, see `_Number`
_NOUN = ";"  # our own format of a noun: "{more:.2g;раз|раза|раз}", see `_Counting`
_UNIT = re.compile("[A-Za-zµ]+")  # rad and s of "rad/s²"
FORMS = frozenset({"one", "few", "many", "other"})


@dataclass(frozen=True, slots=True)
class Phrases:
    """The words file of one language; `on_paper` is True for readers without a command line."""

    language: str
    entries: Mapping[str, Any]
    on_paper: bool = False
    _known: dict[str, object] = field(default_factory=dict, repr=False, compare=False)  # cache of lookups

    def has(self, key: str) -> bool:
        """Return whether this language has a sentence with this key."""
        found = self._found(key)
        return isinstance(found, str) or (isinstance(found, dict) and not FORMS.isdisjoint(found))

    def beside(self, key: str, number: object) -> str:
        """Return the key of the plural form for a number ("other" if it lacks that form), or `key` if it has no forms."""
        forms = self._found(key)
        if forms is None and self.language != ENGLISH:
            return load_phrases().beside(key, number)
        if not isinstance(forms, dict) or not isinstance(number, (int, float)):
            return key
        form = self.form_for(abs(int(number))) if number == int(number) else "other"
        return f"{key}.{form if form in forms else 'other'}"

    def form_for(self, number: int) -> str:
        """Return the form of a noun beside a whole number.  Raises `InputError` if the words file names a rule that is none."""
        if (rule := self.template("plural")) not in PLURALS:
            raise InputError(say("fault.L004", language=self.language, rule=rule, known=tuple(PLURALS)))
        return PLURALS[rule](number)

    def template(self, key: str) -> str:
        """Return a sentence with its gaps, in English if this language lacks it.  Raises `KeyError` for an unknown key."""
        found = self._found(key)
        if isinstance(found, str):
            return found
        if self.language == ENGLISH:
            raise KeyError(f"words.{ENGLISH}.toml has no sentence {key}")
        return load_phrases().template(key)

    def filled(self, key: str, template: str, values: Mapping[str, object]) -> str:
        """Return a template with its gaps filled.  Raises `InputError` for a gap that has no value."""
        if self.language != ENGLISH:
            template = template.replace(" {", f"{OPEN_SPACE}{{").replace("} ", f"}}{OPEN_SPACE}")
        try:
            filled = _Counting(self).vformat(template, (), values) if _NOUN in template else template.format(**values)
            return closed_up(filled)
        except InputError:
            raise
        except (KeyError, IndexError, ValueError, AttributeError) as error:
            known = ", ".join(f"{{{name}}}" for name in values) or "–"
            raise InputError(say("fault.L001", language=self.language, key=key, error=str(error), known=known)) from error

    def written(self, text: str) -> str:
        """Return a `Sentence` in this language, any other text unchanged."""
        if not isinstance(text, Sentence) or (self.language == ENGLISH and not self.on_paper):
            return text
        if not (self.has(text.key) or load_phrases().has(text.key)):
            return str(text)  # such as the title of a record, which is not translated
        return self.composed(text.key, text.values)

    def composed(self, key: str, values: Mapping[str, object]) -> str:
        """Return the sentence of a key, in the plural form for `number`, with its gaps filled."""
        template = self.template(self.beside(key, values["number"]) if "number" in values else key)
        parts = values.get("parts")
        if isinstance(parts, tuple):
            return template.join(map(self.written, parts))
        marked = self.language != ENGLISH or _ROUND in template  # else Python's own format of numbers is right
        return self.filled(key, template, {name: self._filling(name, value, marked) for name, value in values.items()})

    def said(self, key: str, /, **values: object) -> str:
        """Return the sentence of a key in this language, for use in templates."""
        return self.composed(key, values)

    def throughout(self, value: Any) -> Any:
        """Return nested dicts, lists and tuples with every `Sentence` in them translated to this language."""
        if isinstance(value, str):
            return self.written(value)
        if isinstance(value, dict):
            return {name: self.throughout(part) for name, part in value.items()}
        return type(value)(map(self.throughout, value)) if type(value) in {list, tuple} else value

    def number(self, value: float, spec: str) -> str:
        """Return a number in a format such as ".4g", with the decimal sign of this language."""
        return format(_Number(value, self.template("decimal")), spec)

    def listing(self, parts: Sequence[str]) -> str:
        """Return "a, b and c"."""
        *first, last = parts or [""]
        between = f"{OPEN_SPACE}{self.template('and')}{OPEN_SPACE}"
        return closed_up(between.join([self.template("join.comma").join(first), last] if first else [last]))

    def unit(self, unit: str) -> str:
        """Return a unit such as "rad/s" in this language, translated part by part if the words file lacks the whole."""
        known = self.entries.get("units", {})
        return str(known[unit]) if unit in known else _UNIT.sub(lambda part: str(known.get(part[0], part[0])), unit)

    def _found(self, key: str) -> object:
        if (known := self._known.get(key)) is not None:
            return known
        places = [self.entries]
        if self.on_paper and "paper" in self.entries:
            places.insert(0, self.entries["paper"])
        found = next((entry for place in places if (entry := _entry(place, key)) is not None), None)
        if found is not None:
            self._known[key] = found
        return found

    def for_paper(self) -> Phrases:
        """Return the same phrases with those of [paper] in place of texts that mention the command line."""
        return Phrases(self.language, self.entries, on_paper=True)

    def _filling(self, name: str, value: object, marked: bool) -> object:
        if isinstance(value, float):
            value += 0.0  # a zero has no sign: -0 is what a product with a drive of zero may give
            return _Number(value, self.template("decimal")) if marked else value
        if isinstance(value, str):
            return self.unit(self.written(value)) if name == "unit" else self.written(value)
        return self.listing([self.written(part) for part in value]) if isinstance(value, tuple) else value


def _entry(entries: Mapping[str, Any], key: str) -> object:
    entry: Any = entries
    for part in key.split("."):
        if not isinstance(entry, dict) or part not in entry:
            return None
        entry = entry[part]
    return entry


class _Counting(Formatter):
    """A formatter for gaps with a noun, "{more:.2g;раз|раза|раз}".

    It appends the form of the noun that fits the number as printed: one, few, many, or that of fractions ("few" if left out).
    """

    def __init__(self, phrases: Phrases) -> None:
        self._phrases = phrases

    def format_field(self, value: Any, format_spec: str) -> str:
        """Return a value in its format, followed by its noun."""
        spec, _, nouns = format_spec.partition(_NOUN)
        text = str(format(value, spec))
        if not nouns:
            return text
        forms = dict(zip(("one", "few", "many", "other"), nouns.split("|"), strict=False))
        written = "".join(text.replace(self._phrases.template("decimal"), ".").split())
        whole, _, part = written.partition(".")
        form = "many" if not whole.isdigit() else "other" if part.strip("0") else self._phrases.form_for(int(whole))
        return f"{text} {forms.get(form, forms['few'])}"


class _Number(float):
    """A number that is written with the decimal sign of a language in any format.

    The format "r" writes a number without a power of ten and without trailing zeros: 0.0002.
    """

    mark: str

    def __new__(cls, value: float, mark: str) -> _Number:
        made = super().__new__(cls, value)
        made.mark = mark
        return made

    def __format__(self, spec: str) -> str:
        text = f"{float(self):.12f}".rstrip("0").rstrip(".") if spec == "r" else super().__format__(spec)
        return text.replace(".", self.mark)


def languages() -> list[str]:
    """Return the languages that have a words file."""
    return sorted(path.name.split(".")[1] for path in folder(REPORTS).glob("words.*.toml"))


def load_phrases(language: str = ENGLISH) -> Phrases:
    """Return the phrases of a language.  Raises `InputError` if it has no words file."""
    return _phrases(folder("reports"), language)


@cache
def _phrases(place: Path, language: str) -> Phrases:
    name = f"words.{language}.toml"
    entries: dict[str, Any] = {}
    for path in dict.fromkeys((folder_of_package(REPORTS) / name, place / name)):  # own words replace the package's
        if path.is_file():
            entries = _over(entries, _read(path, language))
    if not entries:
        known = languages()
        hint = closest(language, known) or say("hint.there_is", known=tuple(known))
        raise InputError(say("fault.L002", language=language, place=place, hint=hint))
    return Phrases(language, entries)


def _read(path: Path, language: str) -> dict[str, Any]:
    try:
        words: dict[str, Any] = made_once(path, read_words)
        return words
    except ValueError as error:  # not TOML or not UTF-8
        if language == ENGLISH:
            raise  # the error itself could not be written
        raise InputError(say("fault.L003", language=language, line=line_of(error, path))) from error


def _over(below: dict[str, Any], above: dict[str, Any]) -> dict[str, Any]:
    """Return the sentences of two files, those of `above` where both have a key."""
    both = {key: _over(below[key], value) for key, value in above.items()
            if isinstance(value, dict) and isinstance(below.get(key), dict)}  # fmt: skip
    return below | above | both


def say(key: str, /, **values: object) -> Sentence:
    """Return the English sentence of a key, such as `say("check.STOP.pass", rows=25)`.  Raises `KeyError` for an unknown key."""
    return Sentence(load_phrases().composed(key, values), key, values)


def closest(word: str, known: Sequence[str], alike: float = 0.6) -> str:
    """Return ' Did you mean "…"?' with the closest known word, or an empty text; `alike` is 1 for the same word.

    Upper and lower case do not matter.
    """
    import difflib  # imported here, as only mistakes need it

    found = [name for name in known if name.casefold() == word.casefold() and name != word and alike < 1]
    found = found or [name for name in known if sorted(name) == sorted(word) and alike < 1]  # two letters in the other order
    likely = known if len(word) > 2 else [name for name in known if name[:1].casefold() == word[:1].casefold()]  # ws is no s
    found = found or difflib.get_close_matches(word, likely, n=1, cutoff=alike)
    return say("hint.closest", name=found[0]) if found else ""


def ranges(numbers: Iterable[int], most: int = 8) -> tuple[str, ...]:
    """Return sorted whole numbers as ranges for a person, at most `most` of them, then "…".

    >>> ranges([4, 7, 8, 9, 12])
    ('4', '7–9', '12')
    """
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    told = tuple(str(run[0]) if len(run) == 1 else f"{run[0]}–{run[-1]}" for run in runs)
    return told if len(told) <= most else (*told[:most], "…")


def either(words: Sequence[str]) -> str:
    """Return "a, b or c"."""
    *first, last = words
    return say("join.either", first=joined(first, "join.comma"), last=last) if first else last


def say_count(key: str, number: int, /, **values: object) -> Sentence:
    """Return the sentence in the plural form for a number ("key.one", "key.other" …), which fills {number}."""
    return say(key, number=number, **values)


def joined(parts: Iterable[str], between: str = "join.sentences") -> Sentence:
    """Return texts joined into one sentence; `between` is the key of the separator.  Empty texts are left out."""
    return say(between, parts=tuple(part for part in parts if part))
