"""Which sentences about grades are said in no case at all."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

import coursework
from coursework.grading.batch.work import Setup, Task, VariantSource, failed
from coursework.grading.batch.workshop import Workshop
from coursework.grading.marking.key.key import tables_of
from coursework.grading.marking.late import LATE
from coursework.grading.marking.rubric import read_rubric
from coursework.grading.pages.class_facts import ClassFacts
from coursework.grading.pages.class_page import class_page
from coursework.grading.platforms.autograder import autograder_results
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.system.processes.plain_lines import plain_of
from coursework.words.sentences import Phrases, load_phrases, say
from tests.grading.pages.more_cases import RUBRIC, cases_of_all
from tests.grading.pages.truths import VARIANT, write_variants

WORDS = Path(__file__).parents[3] / "reports" / "words.en.toml"
FORMS = {"one", "other"}
# Said on the screen, or of states that the program of grading gives by itself.
STATES = ("timeout", "crashed-grader", "unreadable")


def keys(entries: dict, path: str = "") -> set[str]:
    found = set()
    for key, value in entries.items():
        whole = f"{path}{key}"
        if isinstance(value, dict) and not FORMS & set(value):
            found |= keys(value, f"{whole}.")
        else:
            found.add(whole)
    return found


@contextmanager
def every_key() -> Iterator[set[str]]:
    """Note the key of every sentence that is said."""
    found: set[str] = set()
    composed = Phrases.composed

    def recorded(self, key, values):
        found.add(key)
        return composed(self, key, values)

    with patch.object(Phrases, "composed", recorded):
        yield found


def unsaid(said_before: set[str], folder: Path) -> list[str]:
    """Return the sentences about grades that neither were said before nor are in any case of `more_cases.py`."""
    with every_key() as said:
        say_the_others(folder)
    entries = tomllib.loads(WORDS.read_text(encoding="utf-8"))
    return sorted({key for key in keys(entries) if key.startswith(("feedback.", "marking."))} - said - said_before)


def say_the_others(folder: Path) -> None:
    """Let everything about grades be said that the class of `truths.py` is not told."""
    write_variants(folder)
    text = VARIANT.read_bytes()
    tables = {name: table.tolist() for name, table in tables_of({"s02": coursework.load(str(folder / "s02.toml"))}).items()}
    setup = Setup(RUBRIC, class_tables=tables)
    workshop = Workshop(setup)
    facts = ClassFacts()
    words = load_phrases()
    scored = None
    for student, (files, source, overrides, review) in cases_of_all(VariantSource("s01", text)).items():
        handed = tuple(submitted_file(name, content) for name, content in files.items())
        task = Task(Submission(student, None, handed, review=review), source, overrides)
        outcome = workshop.answer(plain_of(task))
        scored = task if outcome.grade["score"] and not overrides else scored
        autograder_results(outcome.grade, read_rubric(RUBRIC), "gradescope", folder / "results.json", "en")
        facts.add({"id": student, "name": None, "variant": source.name, "page": None} | outcome.grade, outcome.grade["reason"])
    late = Workshop(Setup(f"{RUBRIC}\n[late]\ndeadline = 2026-12-01T23:59:00Z\n"))
    for handed_in in ("2026-12-02T12:00:00", LATE):
        assert late.answer(plain_of(replace(scored, overrides=(), handed_in=handed_in))).grade["late"]["lost"] > 0
    for status in STATES:
        outcome = failed(task, setup, status, say("grading.memory"))
        assert "too much memory" in outcome.page
        facts.add({"id": status, "name": None, "variant": source.name, "page": None} | outcome.grade)
    class_page(facts, [], [], words)
