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
        (
            "points = \n",
            'V009 rubric.toml:1:10  the file is not TOML here: a number, or a text in quotation marks " ", was expected',
        ),
        (
            "points = 60\n[answers]\n[answers]\n",
            "V009 rubric.toml:3:9  the file is not TOML here: the section [answers] occurs twice",
        ),
        ("points = 60\n[table]\ncarreid = 1\n", 'G042 rubric.toml:3  table: unknown key "carreid". Did you mean "carried"?'),
        ("points = 60\n[parts]\ntable = -60\n", "G038 rubric.toml:3  parts.table: a number from 0"),
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
    assert [one.line for one in fault.value.faults] == [2, 2, 3]


def test_each_confusion_is_told_of_for_itself_and_none_about_data_of_other_variants():
    texts = [("of_another", "2 parsec"), ("r1", "2 parsec"), ("r2", "0.9 m"), ("alpha", "3 kg")]
    rubric = read_rubric("".join(f'[[confusion]]\ndatum = "{datum}"\nvalue = "{value}"\n' for datum, value in texts))
    with pytest.raises(InputError) as fault:
        check_rubric(rubric, coursework.load("31"))
    assert [(one.place, found) for one in fault.value.faults for found in ("parsec", "kg") if found in one.message] == [
        ("confusion.r1", "parsec"), ("confusion.alpha", "kg"),
    ]  # fmt: skip
    assert rubric.confused(SimpleNamespace(given=[SimpleNamespace(name="r2", si="m")])) == {"r2": 0.9}


def answer(**changes):
    return "[parts]\nanswers = 1\n[answers.a]\n" + "\n".join(
        f"{key} = {value}" for key, value in ({"of": '"w2"'} | changes).items()
    )


@pytest.mark.parametrize(("text", "codes"), [
    ("parts = 3", "G037 parts"), ("table = 3\nlate = 4", "G037 table, G037 late"),
    ("answers = 3", "G039 answers"), ("[answers]\na = 3\nb = { of = 1 }", "G043 answers.a, G043 answers.b"),
    ("confusion = 3", "G045 confusion.1"), ("[[confusion]]\ndatum = 1\nvalue = '2'", "G045 confusion.1"),
    ("[[confusion]]\ndatum = 'a'\nvalue = '2'\n[[confusion]]\ndatum = 'a'\nvalue = 2", "G045 confusion.2"),
    ("[[confusion]]\ndatum = 'a'\nvalue = '2'\nwhy = ''", "G042 confusion.1"),
    (answer(row=1), ""), (answer(row=0), "G044 answers.a.row"), (answer(row="true"), "G044 answers.a.row"),
    (answer(row=1.5), "G044 answers.a.row"), (answer(tolerance=1), ""), (answer(tolerance=1.01), "G038 answers.a.tolerance"),
    (answer(tolerance=0), ""), (answer(tolerance=-0.01), "G038 answers.a.tolerance"), (answer(rows=1), "G042 answers.a"),
    ("points = 1e6", ""), ("points = 1.1e6", "G038 points"), ("[parts]\ntable = 1e6", ""),
    ("[parts]\ntable = 1.1e6", "G038 parts.table"),
    ("[parts]\ntable = 0\nequations = 0", "G034 parts"), ("[parts]\ntable = 0", ""),
    ("missing_part = 'none'", "G035 missing_part"),
    ("[conventions]\nclockwise = 'x'", "G089 conventions.clockwise"),
    ("[late]\ndeadline = 2026-05-05T12:00:00", "G081 late.deadline"),
    ("[late]\ndeadline = '2026-05-05T12:00:00+02:00'", ""), ("[late]\ndeadline = 'noon'", "G081 late.deadline"),
    ("[late]\ndeadline = 2026-05-05T12:00:00Z\ngrace = 5", "G082 late.grace"),
    ("[late]\ndeadline = 2026-05-05T12:00:00Z\nlost_per_day = 1\nat_most = 1", ""),
    ("[late]\ndeadline = 2026-05-05T12:00:00Z\nlost_per_day = 1.1\nat_most = -1", "G038 late.lost_per_day, G038 late.at_most"),
    ("a = [", "V009 "), ("a = " + "[" * 5000, "V008 "), ("[table]\nforces = 'M1'", ""),
])  # fmt: skip
def test_each_fault_of_a_rubric_is_told_where_it_stands(text, codes):
    try:
        read_rubric(text)
    except InputError as error:
        assert ", ".join(f"{fault.code} {fault.place}" for fault in error.faults) == codes
    else:
        assert codes == ""


def test_rows_up_to_the_last_may_be_asked_for():
    variant = coursework.load("31")
    last = variant.time.steps + 1
    check_rubric(read_rubric(answer(row=last)), variant)
    with pytest.raises(InputError, match="G041"):
        check_rubric(read_rubric(answer(row=last + 1)), variant)


def test_forces_are_a_name_or_a_list_of_them_and_are_asked_of_what_has_them():
    assert read_rubric("[table]\nforces = 'M1'").forces == ("M1",)
    rubric = read_rubric("[table]\nforces = ['N03', 'N9']")
    for name, refused in (("example-2-forces", ["N9"]), ("31", ["N03", "N9"])):
        with pytest.raises(InputError) as caught:
            check_rubric(rubric, coursework.load(name))
        assert [fault.message.values["of"] for fault in caught.value.faults] == refused
