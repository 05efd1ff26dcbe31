"""The rubric: its defaults, what it refuses, and each bound from both sides."""

from types import SimpleNamespace

import pytest

import coursework
from coursework.grading.marking.rubric import Rubric, check_rubric, read_rubric
from coursework.words.errors import InputError


def test_an_empty_file_is_the_default():
    assert read_rubric("") == Rubric()
    assert Rubric().most("table") == 60
    assert Rubric().most("equations") == 40


def test_weights_are_scaled_to_the_points():
    rubric = read_rubric("points = 20\n[parts]\ntable = 3\nequations = 1\nanswers = 0\n")
    assert (rubric.most("table"), rubric.most("equations")) == (15, 5)


def test_answers_and_confusions():
    text = '[parts]\nanswers = 10\n[answers]\nw2 = { of = "w2", row = 4 }\nvC = { of = "v_C" }\n'
    rubric = read_rubric(text + '[[confusion]]\ndatum = "alpha"\nvalue = "0.02 rad"\nbecause = "the step"\n')
    check_rubric(rubric, coursework.load("31"))
    assert [(a.name, a.of, a.row, a.tolerance) for a in rubric.answers] == [("w2", "w2", 4, 0.05), ("vC", "v_C", None, 0.05)]
    assert rubric.confused(coursework.load("31")) == {"alpha": 0.02}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[part]\ntable = 3\n", 'unknown key "part". Did you mean "parts"?'),
        ("[parts]\ntabel = 3\n", 'Did you mean "table"?'),
        ("[table]\ncarried = 1.01\n", "a number from 0 to 1 was expected, found 1.01"),
        ("[table]\ncarried = true\n", "found True"),
        ("points = 0\n", "must be greater than 0"),
        ("[parts]\nanswers = 5\n", "none is listed"),
        ('missing_part = "nothing"\n', '"review" or "zero"'),
        ('missing_part = ["review"]\n', '"review" or "zero"'),
        ("missing_part = { zero = 1 }\n", '"review" or "zero"'),
        ("points = \n", "this is not TOML"),
        ("[answers]\nw = 3\n", "the quantity was expected"),
        ('[answers]\nw = { of = "w2", row = 0 }\n', "a row from 1"),
    ],
)
def test_faults_are_told_with_the_nearest_known_key(text, told):
    with pytest.raises(InputError) as fault:
        read_rubric(text)
    assert told in str(fault.value)


def test_what_the_variant_does_not_have_is_refused():
    rubric = read_rubric('[answers]\nw = { of = "w9", row = 26 }\n[[confusion]]\ndatum = "alpha"\nvalue = "2 parsec"\n')
    with pytest.raises(InputError) as fault:
        check_rubric(rubric, coursework.load("31"))
    assert 'no quantity "w9"' in str(fault.value)
    assert "the table has 25 rows, found 26" in str(fault.value)
    assert "confusion.alpha" in str(fault.value)


def test_each_confusion_is_told_of_for_itself_and_none_about_data_of_other_variants():
    texts = [("of_another", "2 parsec"), ("r1", "2 parsec"), ("r2", "0.9 m"), ("alpha", "3 kg")]
    rubric = read_rubric("".join(f'[[confusion]]\ndatum = "{datum}"\nvalue = "{value}"\n' for datum, value in texts))
    with pytest.raises(InputError) as fault:
        check_rubric(rubric, coursework.load("31"))
    assert [(one.place, found) for one in fault.value.faults for found in ("parsec", "kg") if found in one.message] == [
        ("confusion.r1", "parsec"), ("confusion.alpha", "kg"),
    ]  # fmt: skip
    assert rubric.confused(SimpleNamespace(given=[SimpleNamespace(name="r2", si="m")])) == {"r2": 0.9}
