"""Greek letters, the usual aliases and every unit: other ways to write the same, to the last bit."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import coursework
from coursework.variant.formula import units
from coursework.variant.formula.alphabet import foreign_letter, spell
from coursework.variant.formula.motion_units import UNITS
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import FormulaFault
from coursework.variant.reading.reader import parse_variant

PAGE = (Path(__file__).parents[2] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")


def table(text):
    motion = coursework.solve(parse_variant(text), quantities=["table"]).motion
    return motion.names, motion.rows


@pytest.fixture(scope="module")
def plain():
    return table(PAGE)


def rewritten(*pairs):
    text = PAGE
    for plain, other in pairs:
        assert plain in text, plain
        text = text.replace(plain, other)
    return text


SPELLINGS = {
    "Greek in formulas": [("cos(phi3)", "cos(φ3)"), ("sin(phi1)", "sin(φ₁)"), ("r3*w3", "r3*ω3"), ("+ alpha", "+ α")],
    "Greek in names": [
        ("phi1 = {", '"φ1" = {'),
        ("phi2 = {", '"φ₂" = {'),
        ('rate = "w1"', 'rate = "ω1"'),
        ('w4 = "1/s"', '"ω4" = "1/s"'),
        ("alpha =", '"α" ='),
    ],
    "written out": [("r3*w3", "r3*omega3"), ("r2*w2", "r2*omega_2"), ("cos(phi3)", "cos(phi_3)"), ("sin(phi1)", "sin(fi1)")],
    "declared otherwise": [('rate = "w3"', 'rate = "omega3"'), ("phi1 = {", "phi_1 = {"), ("alpha =", '"α" =')],
    "signs": [("2*r3*w3", "2·r3·w3"), (" - r3", " − r3"), ("r1*w1", "r1×w1"), ("0.5*r3", "r3÷2"), ("- r2", "– r2")],
    "spaces": [("2*r3*w3*cos(phi3)", "2 * r3 *w3* cos ( phi3 )")],
    "powers": [("0.5*r3*w4", "(0.25**0.5)*r3*w4"), ("r2*w2*sin(phi2)", "r2²/r2*w2*sin(phi2)^1")],
    "tangent": [("r2*w2*sin(phi2)", "r2*w2*tg(phi2)*cos(phi2)")],
    "cotangent": [("r2*w2*cos(phi2)", "r2*w2*ctg(phi2)*sin(phi2)"), ("r1*w1*cos(phi1)", "r1*w1*cot(phi1)*sin(phi1)")],
    "inverse": [("sin(p*t + alpha)", "sin(p*t + arctg(tg(alpha)) + pi)"), ("2*pi/p", "2*π/p")],
    "logarithm": [("V1*sin", "exp(ln(2))/2*V1*sin")],
}


@pytest.mark.parametrize("kind", SPELLINGS)
def test_same_table(kind, plain):
    names, rows = table(rewritten(*SPELLINGS[kind]))
    ours = [name.replace("_", "").replace("omega", "w") for name in names]
    assert tuple(ours) == plain[0]
    exact = kind in {"Greek in formulas", "Greek in names", "written out", "spaces"}  # other names sort otherwise
    assert np.max(np.abs(rows - plain[1]) / np.max(np.abs(plain[1]), axis=0)) <= (0.0 if exact else 1e-13)


def test_names_alike_are_not_confused():
    """phi_1 and phi1 may both be declared; then each means itself."""
    text = rewritten(('r1    = "0.953 m"', 'r1 = "0.953 m"\nr_1 = "2 m"'))
    assert parse_variant(text).values["r_1"] == 2
    with pytest.raises(coursework.InputError, match='symbol "pi1" is not declared'):
        parse_variant(rewritten(("sin(phi1)", "sin(pi1)")))


def test_every_greek_letter_has_a_latin_name():
    assert spell("φ₁") == "phi1"
    assert spell("ω̇") != "w"
    for letter in "αβγδεζηθκλμνξπρστφχψωΓΔΘΛΞΠΣΦΨΩ":
        assert spell(letter).isascii(), letter
        assert foreign_letter(letter) is None, letter


@pytest.mark.parametrize(("letter", "looks_like"), [("с", "c"), ("о", "o"), ("р", "p"), ("х", "x"), ("ο", "o"), ("А", "A")])
def test_look_alikes_are_told(letter, looks_like):
    position, description = foreign_letter(f"ab{letter}")
    assert position == 2
    assert f'“{letter}”, which looks like the Latin "{looks_like}"' in description


@pytest.mark.parametrize(("letter", "script"), [("ж", "cyrillic"), ("ϐ", "greek"), ("長", "other"), ("é", "other")])
def test_a_letter_is_called_by_its_alphabet_where_the_words_have_one(letter, script):
    position, description = foreign_letter(f"a{letter}")
    assert (position, description.key, description.values["letter"]) == (1, f"fault.letter.{script}", letter)


TURN = 2 * math.pi
# Units of task sheets, written down here once more: text -> value in SI and SI unit.
LENGTHS = {"m": 1, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048, "м": 1, "см": 0.01, "мм": 0.001}
ANGLES = {"rad": 1, "deg": TURN / 360, "°": TURN / 360, "grad": TURN / 360, "рад": 1, "град": TURN / 360}
TIMES = {"s": 1, "ms": 0.001, "min": 60, "с": 1, "мс": 0.001, "мин": 60, "хв": 60}
TURNING = {
    "rad/s": 1, "1/s": 1, "deg/s": TURN / 360, "°/s": TURN / 360, "rpm": TURN / 60, "1/min": TURN / 60, "rev/s": TURN,
    "rev/min": TURN / 60, "рад/с": 1, "1/с": 1, "град/с": TURN / 360, "об/мин": TURN / 60, "об/с": TURN, "1/мин": TURN / 60,
    "об/хв": TURN / 60, "1/хв": TURN / 60,
    "grad/s": TURN / 360, "rad/min": 1 / 60, "r/min": TURN / 60, "r/s": TURN, "U/min": TURN / 60,
}  # fmt: skip
SPEEDS = {
    "m/s": 1,
    "cm/s": 0.01,
    "mm/s": 0.001,
    "m/min": 1 / 60,
    "in/s": 0.0254,
    "ft/s": 0.3048,
    "м/с": 1,
    "мм/с": 0.001,
    "м/мин": 1 / 60,
}
SPEEDING = {"m/s^2": 1, "mm/s^2": 0.001, "ft/s^2": 0.3048, "м/с^2": 1, "см/с^2": 0.01}
SPINNING = {
    "rad/s^2": 1,
    "1/s^2": 1,
    "deg/s^2": TURN / 360,
    "rev/s^2": TURN,
    "рад/с^2": 1,
    "1/с^2": 1,
    "об/с^2": TURN,
    "°/с^2": TURN / 360,
}
KINDS = {"m": LENGTHS, "rad": ANGLES, "s": TIMES, "1/s": TURNING, "m/s": SPEEDS, "m/s^2": SPEEDING, "1/s^2": SPINNING}
SI = {f"2 {unit}": (2 * size, si) for si, units_ in KINDS.items() for unit, size in units_.items()} | {
    "90°": (math.pi / 2, "rad"), "90º": (math.pi / 2, "rad"), "2 m/s²": (2, "m/s^2"), "2 m/s**2": (2, "m/s^2"), "2": (2, ""),
    "-2 mm": (-0.002, "m"), "−2 mm": (-0.002, "m"), "+2 mm": (0.002, "m"), "2e-3 m": (0.002, "m"), ".5 m": (0.5, "m"),
    "5. m": (5, "m"), " 2  m ": (2, "m"), "2m": (2, "m"), "2 m / s": (2, "m/s"), "2 1 / s": (2, "1/s"), "2 s^-1": (2, "1/s"),
    "2 с⁻¹": (2, "1/s"), "2 рад·с⁻²": (2, "1/s^2"), "2 m s^-1": (2, "m/s"), "2 1/c": (2, "1/s"), "2 oб/мин": (TURN / 30, "1/s"),
    "2 m/с": (2, "m/s"), "2 м/s": (2, "m/s"), "2 mm/с²": (0.002, "m/s^2"), "2 rad·с⁻¹": (2, "1/s"),
    "2 rev/хв": (TURN / 30, "1/s"), "2 m/c": (2, "m/s"), "2 град/s": (TURN / 180, "1/s"),
    "2 сm/s": (0.02, "m/s"), "2 cм": (0.02, "m"), "2 mм/с": (0.002, "m/s"), "2 мm": (0.002, "m"), "2 rаd/s": (2, "1/s"),
    "2 рad": (2, "rad"), "2 мs": (0.002, "s"), "2 mс": (0.002, "s"), "2 rpм": (TURN / 30, "1/s"), "2 сm/мин": (0.02 / 60, "m/s"),
}  # fmt: skip


@pytest.mark.parametrize("text", SI)
def test_units(text):
    value, si = SI[text]
    read = units.read(text)
    assert read.si == si
    assert read.value == pytest.approx(value, rel=4e-16, abs=0)


@pytest.mark.parametrize(("text", "is_one"), [
    ("10", True), ("10 rpm", True), ("10 об/мин", True), ("5°", True), ("-.5e-3 m", True),
    ("10 rmp", True), ("3 metre", True), ("2 radd/s", True), ("4 1/sek", True),  # a unit that is none is advised on
    ("2 pi", False), ("2π", False), ("2*pi/p", False), ("3 r1", False), ("r1", False), ("2 m*x", False),
])  # fmt: skip
def test_a_number_with_a_word_is_a_quantity_and_with_pi_a_formula(text, is_one):
    assert units.is_quantity(text) is is_one


def test_every_unit_the_tool_knows_is_one_of_these_or_made_of_two():
    for unit in set(UNITS) - {"1", "rpm"}:  # "1" names the unit of a number without one
        above, _, below = unit.partition("/")
        assert above in LENGTHS | ANGLES | TIMES | {"1": 1, "rev": 1, "r": 1, "U": 1, "об": 1}
        assert not below or below.removesuffix("^2") in TIMES


@pytest.mark.parametrize(
    ("text", "wanted", "advice"),
    [
        ("1.5 mps", "m/s", 'a speed was expected: m/s, cm/s, mm/s (found "1.5 mps").'),
        ("3.37 rd", "rad", 'Did you mean "rad"?'),
        ("60 сmm/s", "m/s", '"сmm" has letters of two alphabets: Cyrillic small letter es “с”, which looks like the Latin "c".'),
        ("60 кg", "", '"кg" has letters of two alphabets: Cyrillic small letter ka “к”. Write it in one.'),
        ("3.37 rd", "m", 'a length was expected: m, cm, mm (found "3.37 rd").'),
        ("2 rad/sec", "1/s", 'Did you mean "rad/s"?'),
        ("2 об/мн", "1/s", 'Did you mean "об/мин"?'),
        ("2 /s", "1/s", 'Did you mean "1/s"?'),
        ("2 o/min", "1/s", 'rad/s, 1/s, deg/s, rpm (found "2 o/min").'),
        ("0.4 kg", "", "Known units: m, cm, mm; rad, deg; s, ms, min; rad/s, 1/s, deg/s, rpm;"),
        ("50 Hz", "1/s", 'Hz does not say whether turns or radians per second are meant, found "50 Hz". Write rev/s, or 1/s.'),
        ("50 Гц", "", "Write rev/s, or 1/s."),
    ],
)
def test_advice_offers_units_of_what_is_wanted(text, wanted, advice):
    with pytest.raises(units.UnitFault) as caught:
        units.read(text, wanted)
    assert advice in str(caught.value)


@pytest.mark.parametrize(
    "unit", ["sec", "mps", "kmh", "rads", "degr", "metre", "inch", "rd", "м/сек", "гр", "m/sec", "t/min", "q/s"]
)
@pytest.mark.parametrize("wanted", KINDS)
def test_no_unit_of_another_dimension_is_ever_offered(unit, wanted):
    with pytest.raises(units.UnitFault) as caught:
        units.read(f"2 {unit}", wanted)
    offered = re.findall(r'Did you mean "(.*?)"', str(caught.value))
    assert all(UNITS[other][1] == wanted and ("/" in other) == ("/" in unit) for other in offered)


@given(st.integers(1, 10**6))
def test_millimetres_and_metres_are_the_same_doubles(number):
    assert units.read(f"{number} mm").value == units.read(f"{number / 1000} m").value == number / 1000


@given(st.floats(-1e12, 1e12).filter(lambda x: x == 0 or abs(x) > 1e-300))
def test_a_written_number_is_read_to_the_last_bit(number):
    assert units.read(repr(number)).value == number
    assert units.read(f"{number!r} m").value == number
    assert units.read(number).value == number


@given(st.text(max_size=30))
def test_any_text_is_a_quantity_or_a_fault(text):
    try:
        assert math.isfinite(units.read(text).value)
    except units.UnitFault as fault:
        assert "expected" in str(fault) or "too small" in str(fault) or "Hz" in str(fault)


@pytest.mark.parametrize(("written", "column", "meant"), [
    ("r*син(phi)", 3, "sin"), ("Кос(phi)", 1, "cos"), ("r + тг(phi)", 5, "tan"), ("корень(r^2)", 1, "sqrt"),
    ("сін(phi)", 1, "sin"),
])  # fmt: skip
def test_a_function_in_cyrillic_letters_is_named_as_a_whole(written, column, meant):
    with pytest.raises(FormulaFault, match=rf"is written {meant}\(…\), in Latin letters") as refused:
        parse(written)
    assert refused.value.column == column
