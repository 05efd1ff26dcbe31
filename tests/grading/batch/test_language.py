"""A class is marked in the language of whoever asks: pages, sentences and results in Ukrainian, numbers for programs as ever."""

import json
import re

import pytest

from coursework.grading.batch.work import Setup
from coursework.grading.reading.submission import Submission
from coursework.system.processes.plain_lines import line_of, read_line
from coursework.words.sentences import load_phrases, say
from tests.grading.batch.classroom import hand_in, small_class
from tests.grading.batch.test_batch import grade, rows, submissions

PAGE_WORDS = re.compile(r"<style>.*?</style>|<code>.*?</code>|<[^>]*>", re.DOTALL)
ENGLISH_WORD = re.compile(r"\b(the|of|is|are|and|row|marked|table|right|wrong|points|class|submissions)\b", re.IGNORECASE)


@pytest.mark.long
def test_a_class_in_ukrainian(tmp_path):
    source, out = small_class(tmp_path / "in"), tmp_path / "out"
    decided = tmp_path / "overrides.csv"
    decided.write_text("id,check,points,reason\nbert,table,51.5,", encoding="utf-8")
    assert grade(source, out, "--language", "uk", "--overrides", decided).exit_code == 0
    pages = [*sorted((out / "feedback").glob("*.html")), out / "class.html"]
    assert len(pages) == 8
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert '<html lang="uk">' in text
        shown = PAGE_WORDS.sub(" ", text).replace("table.csv", "").replace("equations.txt", "")
        assert not ENGLISH_WORD.findall(shown), page.name
    carl, bert = ((out / "feedback" / f"{name}.html").read_text(encoding="utf-8") for name in ("carl", "bert"))
    assert "Рядок 11" in carl
    assert not re.search(r"\d\.\d", PAGE_WORDS.sub(" ", carl).replace("1.05", ""))
    assert "51,5" in bert
    found, entries = rows(out), submissions(out)
    assert found["bert"]["points"] == "91.50"
    assert found["carl"]["sentence"].startswith("Рядок 11")
    assert "," in entries["carl"]["first_wrong"]["sentence"]
    assert isinstance(entries["carl"]["first_wrong"]["found"], float)
    assert entries["emil"]["equations"]["items"][3]["verdict"] == "wrong"
    assert not ENGLISH_WORD.search(found["fred"]["sentence"])
    assert 'lang="en"' in (grade(source, out) and (out / "feedback" / "ada.html").read_text(encoding="utf-8"))
    english = load_phrases()
    assert english.said("class.reason.overrides") in (out / "class.html").read_text(encoding="utf-8")


def test_an_unreadable_variant_file_has_a_code_in_every_language(tmp_path):
    told = {}
    hand_in(tmp_path / "in" / "hugo")
    (tmp_path / "in" / "hugo" / "equations.txt").unlink()
    (tmp_path / "in" / "hugo" / "31.toml").write_text("format = 1\ntitle = \n", encoding="utf-8")
    for language in ("en", "uk"):
        assert grade(tmp_path / "in", tmp_path / language, "--language", language).exit_code == 0
        told[language] = submissions(tmp_path / language)["hugo"]["equations"]["items"][0]["hint"]
    assert re.fullmatch(r"[A-Z]\d{3}", told["en"]["code"])
    assert told["uk"]["code"] == told["en"]["code"]
    assert told["uk"]["values"].keys() == told["en"]["values"].keys()
    assert told["uk"]["text"] != told["en"]["text"]


def test_the_results_for_an_autograder_in_ukrainian(tmp_path):
    small_class(tmp_path / "in")
    for student, wanted in (("emil", "feedback.equation.wrong"), ("gina", "feedback.state.missing")):
        done = grade(tmp_path / "in" / student, tmp_path / student, "--results", "gradescope", "--language", "uk")
        assert done.exit_code == 0, done.output
        text = (tmp_path / student / "results.json").read_text(encoding="utf-8")
        assert load_phrases("uk").said(wanted) in text
        assert not ENGLISH_WORD.search(json.loads(text)["output"])


def test_language_and_sentences_cross_to_another_process():
    setup = Setup(language="uk")
    assert read_line(Setup, line_of(setup)) == setup
    review = say("reading.review.resubmitted", names=("a", say("feedback.part.table")))
    crossed = read_line(Submission, line_of(Submission("1", None, (), review=review))).review
    uk = load_phrases("uk")
    assert crossed == review
    assert uk.written(crossed) == uk.written(review)
    assert uk.said("feedback.part.table") in uk.written(crossed)
