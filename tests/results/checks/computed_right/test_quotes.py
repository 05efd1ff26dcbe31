"""QUOTE: what the remarks of the catalogue say is what their tables say, and a number one digit off is found."""

import re

import pytest

import coursework
from coursework.variant.catalogue import entries
from coursework.variant.reading.reader import parse_variant
from coursework.variant.reading.set_values import with_set
from tests.solved import solved

ASSIGNED = re.compile(r"(\w+) = (-?\d+(?:\.\d+)?)(?![\d.]*\d)(?! *(?:m|mm|s|deg)\b)")


def check(run):
    return next(check for check in run.checks if check.code == "QUOTE")


def assigned(variant):
    """Return (column, number) of every "column = number" in the paragraphs that speak of a row."""
    spoken = " ".join(text for text in variant.remarks if re.search(r"\brows? \d", " ".join(text.split())))
    return [(name, number) for name, number in ASSIGNED.findall(" ".join(spoken.split())) if name in variant.columns]


@pytest.mark.parametrize("name", [entry.name for entry in entries()])
def test_every_number_that_a_remark_assigns_to_a_row_is_a_quote(name):
    variant = coursework.load(name)
    quoted = [(quote.column, quote.value) for quote in variant.quotes]
    assert sorted(assigned(variant)) == sorted(quoted)


def test_the_catalogue_quotes_ten_numbers():
    """Were the pattern blind, the test above would hold for nothing."""
    assert sum(len(assigned(coursework.load(entry.name))) for entry in entries()) == 10


@pytest.mark.parametrize("name", ["example-3", "example-6", "engine-start"])
def test_the_quotes_of_the_catalogue_are_those_of_its_tables(name):
    run = solved(name, quantities=["table", "checks"])
    found = check(run)
    assert found.verdict == "PASS"
    assert f"({len(run.variant.quotes)} in all)" in found.sentence
    assert found.group == "computation"


@pytest.mark.parametrize(("set_here", "is_judged"), [([], True), (["wb=251 rpm"], False)])
def test_other_data_than_those_of_the_file_are_no_slip_of_its_remarks(set_here, is_judged):
    variant = coursework.load("engine-start")
    found = check(coursework.solve(with_set(variant, set_here) if set_here else variant, quantities=["table", "checks"]))
    assert (found.verdict == "PASS") is is_judged
    assert is_judged or (found.verdict, found.sentence.key) == ("SKIP", "check.QUOTE.set")


def text_with(value, name="example-3", old="-3.18045457492925"):
    text = coursework.load(name).path.read_text(encoding="utf-8")
    return text.replace(f'value = "{old}"', f'value = "{value}"')


@pytest.mark.parametrize(
    ("value", "verdict"),
    [
        ("-3.18045457492925", "PASS"),
        ("-3.18045457492927", "FAIL"),
        ("-3.18045", "PASS"),
        ("-3.18046", "FAIL"),
        ("-3.2", "PASS"),
        ("-3.1", "FAIL"),
        ("-3", "PASS"),
        ("−3.180", "PASS"),
        ("3.18045", "FAIL"),
    ],
)
def test_the_digits_of_the_remark_decide(value, verdict):
    assert check(coursework.solve(parse_variant(text_with(value)), quantities=["checks"])).verdict == verdict


def test_a_wrong_number_is_named_beside_the_right_one():
    found = check(coursework.solve(parse_variant(text_with("-4.58000")), quantities=["checks"]))
    assert found.sentence == "Row 7 of w5: the remark says -4.58000, the table -3.18045."
    assert (found.column, found.row) == ("w5", 7)


def test_another_scheme_or_step_is_not_judged_by_the_quotes():
    for options in ({"scheme": "euler"}, {"scheme": "rk4"}, {"step": 0.001}):
        assert check(coursework.solve("example-3", quantities=["checks"], **options)).verdict == "SKIP"


def test_a_quote_of_euler_is_compared_with_the_rows_beside_an_exact_table():
    text = text_with("10.89", "engine-start", "10.8909")
    assert check(coursework.solve(parse_variant(text), quantities=["checks"])).verdict == "PASS"
    text = text_with("10.8910", "engine-start", "10.8909")
    found = check(coursework.solve(parse_variant(text), quantities=["checks"]))
    assert found.sentence == "Row 41 of phi1: the remark says 10.8910, the table 10.8909."


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ('column = "w5"', 'column = "w55"', '"w55" is not a column of the table. Did you mean "w5"?'),
        ("row = 7", "row = 77", "row 77 is beyond the last row, 37."),
        ('value = "-3.18045457492925"', 'value = "about 3"', "about 3"),
        ('value = "-3.18045457492925"', 'value = "-3.18"\nscheme = "eulr"', 'there is no scheme "eulr". Did you mean "euler"?'),
    ],
)
def test_faults_of_a_quote_are_told_with_their_line(old, new, fault):
    text = coursework.load("example-3").path.read_text(encoding="utf-8")
    with pytest.raises(coursework.InputError) as told:
        parse_variant(text.replace(old, new, 1), "faulty")
    assert fault in str(told.value)
    assert re.search(r"faulty:\d+", str(told.value))
