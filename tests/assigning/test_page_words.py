"""What a task sheet says of the drive and of the parts that earn marks."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

import coursework
from coursework.assigning import class_page, sheet
from coursework.assigning.page_words import drives
from coursework.assigning.ranges import Range
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


@pytest.mark.parametrize(("name", "said"), [
    ("variable-crank-exact", ["x = l₁ cos φ₀ + √(l₂² − l₁² sin² φ₀) − (V / ω₀) (φ₁ − φ₀)", "r = x cos φ₁ + √(l₂² − x² sin² φ₁)"]),
    ("variable-crank-table", ["r is given in the file variable-crank-table.csv."]),
])  # fmt: skip
def test_functions_of_a_file_are_told_as_formulas_or_by_their_table(name, said):
    _, told = drives(coursework.load(name), WORDS)
    assert [one.translate({0xE000: None, 0xE001: None}) for one in told] == said


@pytest.mark.parametrize("name", ["31", "example-1"])
def test_the_table_has_the_rows_of_the_run(name):
    """Both where the task is told and where its marks are."""
    variant = coursework.load(name)
    rows = len(coursework.solve(name, quantities=["table"]).motion.t)
    handout = type("Handout", (), {"variant": variant, "check": None, "least_decimals": 3})()
    assert f"{rows} rows" in sheet._parts(handout, WORDS, Rubric())[0]
    assert f"{rows} rows" in sheet._tasks(handout, WORDS)[1]


@pytest.mark.parametrize("choice", [False, True])
def test_a_datum_is_shown_between_the_ends_of_its_range(choice, monkeypatch):
    """Of a choice the least and the largest, wherever they stand; of a range the first and the last."""
    monkeypatch.setattr(class_page, "_head", lambda *given: [])
    drawn = {"choice": ("0.5 m", "30 cm", "0.7 m")} if choice else {"first": 3, "step": 2, "decimals": 1, "unit": "m"}
    one = Range(("given", "r1"), count=3, **drawn)
    accepted = [SimpleNamespace(values={("given", "r1"): text}) for text in ("0.4 m", "0.6 m")]
    shown = class_page._datum(one, accepted, SimpleNamespace(), WORDS)["strip"]
    assert (shown.first, shown.last, shown.middle) == ("30\xa0cm" if choice else "0.3\xa0m", "0.7\xa0m", "0.5")
    (first, _), (second, _) = shown.marks
    assert float(first) < float(second) and float(first) + float(second) == pytest.approx(2 * float(shown.centre), abs=0.11)
    assert float(shown.band[1]) == pytest.approx(2 * (float(second) - float(first)), abs=0.21)


@pytest.mark.parametrize(("texts", "equal"), [("ab", []), ("aab", [["1", "2"]]), ("abaab", [["1", "3", "4"], ["2", "5"]])])
def test_students_with_the_same_data_are_told_together_whatever_their_times(texts, equal):
    given = [
        SimpleNamespace(id=str(place), values={("time", "end"): str(place), ("given", "r"): text})
        for place, text in enumerate(texts, start=1)
    ]
    assert class_page._equal(given) == equal


@pytest.mark.parametrize(("banded", "centre", "reach", "band"), [
    (True, 5.0, (1.0, 9.0), (2.0, 6.0)), (True, 12.0, (1.0, 12.0), (2.0, 6.0)), (False, 5.0, (1.0, 9.0), (1.0, 9.0)),
    (False, 0.5, (0.5, 9.0), (1.0, 9.0)),
])  # fmt: skip
def test_a_measure_is_shown_from_the_least_to_the_most(banded, centre, reach, band, monkeypatch):
    """Students have 1, 4 and 9; the band is from 2 to 6; what has none has its own reach for one."""
    name = next(iter(class_page.MEASURES))
    shown = []
    monkeypatch.setattr(class_page, "strip", lambda *given: shown.append(given))
    accepted = [SimpleNamespace(numbers={name: value}) for value in (4.0, 1.0, 9.0)]
    acceptance = SimpleNamespace(centre=SimpleNamespace(numbers={name: centre}), band=lambda name: (2.0, 6.0))
    difficulty = SimpleNamespace(numbers={name: 0.2} if banded else {})
    class_page._measure(
        name, accepted, SimpleNamespace(acceptance=acceptance, ranges=SimpleNamespace(difficulty=difficulty)), WORDS
    )
    ((values, low, high, middle, ends, told),) = shown
    assert (values, (low, high), middle) == ([4.0, 1.0, 9.0], band, centre)
    numbers = [float(end.split()[0]) for end in ends]
    assert numbers == pytest.approx(reach) and float(told) == centre
