"""Every sentence about grades that the words file has is said in at least one case; what nobody can be told is not kept."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

import coursework
from coursework.grading.batch.work import Setup, Task, VariantSource, failed
from coursework.grading.batch.workshop import Workshop
from coursework.grading.marking.key.key import tables_of
from coursework.grading.marking.late import LATE
from coursework.grading.marking.reasons.reason import misconception_sentence
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


@pytest.fixture
def said(monkeypatch) -> set[str]:
    found: set[str] = set()
    composed = Phrases.composed

    def recorded(self, key, values):
        found.add(key)
        return composed(self, key, values)

    monkeypatch.setattr(Phrases, "composed", recorded)
    return found


def test_every_sentence_is_said_in_some_case(said, tmp_path):
    write_variants(tmp_path)
    text = VARIANT.read_bytes()
    tables = {name: table.tolist() for name, table in tables_of({"s02": coursework.load(str(tmp_path / "s02.toml"))}).items()}
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
        autograder_results(outcome.grade, read_rubric(RUBRIC), "gradescope", tmp_path / "results.json", "en")
        facts.add({"id": student, "name": None, "variant": source.name, "page": None} | outcome.grade, outcome.grade["reason"])
    late = Workshop(Setup(f"{RUBRIC}\n[late]\ndeadline = 2026-12-01T23:59:00Z\n"))
    for handed_in in ("2026-12-02T12:00:00", LATE):
        assert late.answer(plain_of(replace(scored, overrides=(), handed_in=handed_in))).grade["late"]["lost"] > 0
    for status in STATES:
        outcome = failed(task, setup, status, say("grading.memory"))
        assert "too much memory" in outcome.page
        facts.add({"id": status, "name": None, "variant": source.name, "page": None} | outcome.grade)
    class_page(facts, [], [], words)
    known = {key for key in keys(tomllib.loads(WORDS.read_text(encoding="utf-8"))) if key.startswith(("feedback.", "marking."))}
    assert sorted(known - said) == []


def test_a_student_is_never_told_whose_table_it_is():
    assert "s02" in misconception_sentence("variant_s02")
    assert "s02" not in misconception_sentence("variant_s02", for_student=True)
    assert "l_1, l_2" in misconception_sentence("swap_l_1_l_2")
