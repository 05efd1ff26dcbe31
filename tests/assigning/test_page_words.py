"""What a task sheet says of the drive and of the parts that earn marks."""

from dataclasses import replace

import pytest

import coursework
from coursework.assigning import sheet
from coursework.assigning.page_words import drives
from coursework.grading.marking.rubric import Rubric
from coursework.report.text.words import load_words

WORDS = load_words("en")


def test_a_drive_in_pieces_has_an_equation_a_piece_with_the_time_it_begins():
    shown, told = drives(coursework.load("engine-start"), WORDS)
    assert [(one["text"], one["name"]) for one in shown] == [
        ("ω₁ = ω_a + (ω_b − ω_a) t / t₁", "from t = 0\u00a0s"),
        ("ω₁ = ω_b", "from t = 0.4\u00a0s"),
    ]
    assert told == []


def test_a_drive_by_a_table_names_its_file():
    variant = coursework.load("engine-start")
    (law,) = variant.drive
    tabled = replace(variant, drive=(replace(law, pieces=(), file="speed.csv"),))
    shown, told = drives(tabled, WORDS)
    assert shown == []
    (sentence,) = told
    assert sentence.endswith(" is given in the file speed.csv.")


@pytest.mark.parametrize("name", ["31", "example-1"])
def test_the_table_has_the_rows_of_the_run(name):
    """Both where the task is told and where its marks are."""
    variant = coursework.load(name)
    rows = len(coursework.solve(name, quantities=["table"]).motion.t)
    handout = type("Handout", (), {"variant": variant, "check": None, "least_decimals": 3})()
    assert f"{rows} rows" in sheet._parts(handout, WORDS, Rubric())[0]
    assert f"{rows} rows" in sheet._tasks(handout, WORDS)[1]
