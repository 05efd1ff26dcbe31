"""What a words file still lacks:  python -m tests.report.words_missing ru  lists key, and the English sentence with its gaps.

A key that English does not have, a gap that differs and a form beside a number that is missing are listed too.
"""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from string import Formatter
from typing import Any

from coursework.words.sentences import ENGLISH

REPORTS = Path(__file__).parents[2] / "reports"
FORMS = {"one-other": {"one", "other"}, "one-few-many": {"one", "few", "many"}, "other": {"other"}}
# Whoever names a scheme in English names it in its record.
UNLISTED = ("scheme.",)


def languages() -> list[str]:
    """Return the languages beside English."""
    found = {path.name.split(".")[1] for path in REPORTS.glob("words.*.toml")}
    return sorted(found - {ENGLISH})


def read(language: str) -> dict[str, str]:
    """Return every sentence of a words file by its whole key."""
    return dict(_flat(tomllib.loads((REPORTS / f"words.{language}.toml").read_text(encoding="utf-8")), ""))


def _flat(table: Mapping[str, Any], path: str) -> Iterator[tuple[str, str]]:
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{path}{key}.")
        else:
            yield f"{path}{key}", value


def counted(entries: Mapping[str, str]) -> set[str]:
    """Return the keys of English that have a form for one and another for the rest."""
    return {
        key.removesuffix(".one") for key in entries if key.endswith(".one") and f"{key.removesuffix('.one')}.other" in entries
    }


def gaps(sentence: str) -> set[str]:
    """Return the names of the gaps of a sentence."""
    return {name for _, name, _, _ in Formatter().parse(sentence) if name}


def numeric(sentence: str) -> set[str]:
    """Return the names of the gaps that take a number with decimals: a text there stops the page."""
    return {name for _, name, form, _ in Formatter().parse(sentence) if name and form and form[-1] in "efg"}


def complaints(language: str) -> Iterator[str]:
    """Yield a line for each key that is missing, unknown, or has other gaps than in English."""
    english, own = read(ENGLISH), read(language)
    forms = FORMS[own.get("plural", english["plural"])]
    plural = counted(english)
    wanted: dict[str, str] = {}
    for key, sentence in english.items():
        base, _, form = key.rpartition(".")
        if base in plural and form in {"one", "other"}:
            wanted |= {f"{base}.{each}": english[f"{base}.other"] for each in forms}
        else:
            wanted[key] = sentence
    for form, sentence in wanted.items():
        base = form.rpartition(".")[0]
        key = f"{base}.other" if base in plural and form not in own else form  # a form that is not there is that of the others
        if key not in own:
            yield f"{key} = {sentence!r}"
        elif (gaps(own[key]) ^ gaps(sentence)) - ({"number"} if base in plural else set()):
            yield f"{key}: gaps {sorted(gaps(own[key]))}, in English {sorted(gaps(sentence))}"
        elif wrong := sorted(numeric(own[key]) - numeric(sentence)):
            yield f"{key}: formats of a number for {wrong}, a text in English"
    parts = {f"{base}.other" for base in plural}  # the form beside a number that is not whole
    for key in sorted(own.keys() - parts):
        if key not in wanted and not key.startswith(UNLISTED):
            yield f"{key}: not in English"


if __name__ == "__main__":
    for asked in sys.argv[1:] or languages():
        for line in complaints(asked):
            print(line)
