"""Two faults of dimension that have nothing to do with each other are told in one go, and what follows from one is not.

The mechanism is in no catalogue: two wheels in mesh, a pin on the second pushes a slider.
"""

import itertools
from pathlib import Path

import pytest

from coursework.variant.formula.reader import parse
from coursework.variant.judging.dimension_words import text_of
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError

TEXT = (Path(__file__).parents[2] / "assigning" / "own" / "gears.toml").read_text(encoding="utf-8")
TEXT = TEXT.replace('w1 = "w0"', 'w1 = "w0*cos(k*t)"').replace('w0 = "6 rad/s"', 'w0 = "6 rad/s"\nk = "3 1/s"')
SLIPS = {
    "unit of a datum": ('l  = "0.30 m"', 'l  = "0.30 s"'),
    "unit of another datum": ('k = "3 1/s"', 'k = "3 s"'),
    "term without its velocity": ('"R1*w1 + R2*w2 = 0"', '"R1*w1 + R2 = 0"'),
    "place of a wrong kind": ('C = "A + R1 @ 0"', 'C = "A + R1 @ R2"'),
    "sine of a length": ('B = "(R1 + R2, 0)"', 'B = "(R1 + R2, sin(R1))"'),
}


def told(text):
    with pytest.raises(InputError) as caught:
        parse_variant(text)
    return [(fault.code, fault.line, str(fault.message)) for fault in caught.value.faults]


def slipped(names):
    text = TEXT
    for name in names:
        assert text.count(SLIPS[name][0]) == 1, name
        text = text.replace(*SLIPS[name])
    return text


def test_the_mechanism_is_right():
    parse_variant(TEXT)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_each_slip_is_told_beside_the_others_as_it_is_told_alone(count):
    alone = {name: told(slipped([name])) for name in SLIPS}
    assert all(len(found) == 1 for found in alone.values())
    for names in itertools.combinations(SLIPS, count):
        found = told(slipped(names))
        assert sorted(found) == sorted(fault for name in names for fault in alone[name]), names


@pytest.mark.parametrize("name", SLIPS)
def test_one_slip_is_one_fault_however_many_places_it_spoils(name):
    assert len(told(slipped([name]))) == 1


def test_the_same_slip_once_more_is_told_once():
    text = (
        TEXT.replace("w3*sin(theta3)", "w3*sin(R1)")
        .replace("w3*cos(theta3)", "w3*cos(R1)")
        .replace("w2*sin(theta2)", "w2*sin(R1)")
    )
    assert [(code, line) for code, line, _ in told(text)] == [
        ("V203", 1 + text[: text.index(place)].count("\n")) for place in ("-e*w2*sin", "e*w2*cos(theta2)")
    ]  # sin(R1), told where it stands first, and cos(R1)


@pytest.mark.parametrize("count", [5, 7])
def test_at_most_six_slips_are_told(count):
    more = "".join(f'X{k} = "A + R1 @ (R1/{k})"\n' for k in range(2, 2 + count))
    assert len(told(TEXT.replace("[points]\n", f"[points]\n{more}"))) == min(count, 6)


@pytest.mark.parametrize(("letters", "told"), [(80, "a" * 80), (81, "a" * 80 + "…")])
def test_a_term_is_told_with_at_most_eighty_letters(letters, told):
    assert text_of(parse("a" * letters)) == told


@pytest.mark.parametrize(("term", "slip", "codes"), [
    ("R2*w2", "", ["V086"]), ("R2*w2", "unit of another datum", ["V204"]), ("R2", "", ["V086"]),
    ("R2", "unit of another datum", ["V204", "V086"]),
])  # fmt: skip
def test_a_value_that_is_none_at_the_start_is_told_before_slips_of_its_line_and_behind_those_of_others(term, slip, codes):
    """A datum with a wrong unit may be why there is no value; in the line of a slip the value says more than the slip."""
    text = TEXT.replace('"R1*w1 + R2*w2 = 0"', f'"R1*w1*sqrt(e/l - 4) + {term} = 0"')
    assert [code for code, _, _ in told(text.replace(*SLIPS[slip]) if slip else text)] == codes
