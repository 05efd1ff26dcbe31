"""Names become the textbook's symbols; text on its way to a page is cleaned and set."""

from __future__ import annotations

import re
from itertools import pairwise
from types import ModuleType

import pytest

import coursework
from coursework.report.text.symbols import Rates, symbol
from coursework.report.text.text_runs import derivative, printed, runs, with_letters, with_pairs, with_points
from coursework.variant.formula.alphabet import spell
from coursework.words.templates import LONGEST, clean


@pytest.mark.parametrize(
    ("name", "text", "typst"),
    [
        ("phi1", "φ₁", "φ_1"), ("w3", "ω₃", "ω_3"), ("w", "ω", "ω"), ("omega_3", "ω₃", "ω_3"), ("VMx", "V_Mx", "V_(M x)"),
        ("r1", "r₁", "r_1"), ("psi4", "ψ₄", "ψ_4"), ("alpha", "α", "α"), ("alpha0", "α₀", "α_0"), ("dw", "dw", '"dw"'),
        ("dphi2", "dphi₂", '"dphi"_2'), ("AB", "AB", "A B"), ("speed", "speed", '"speed"'), ("speed1", "speed₁", '"speed"_1'),
        ("s_max", "s_max", 's_"max"'), ("a_b_c", "a_b_c", 'a_"b c"'), ("lift", "lift", '"lift"'), ("pin", "pin", '"pin"'),
        ("A.x", "x_A", "x_A"), ("B1.vy", "v_B1y", "v_(B 1 y)"), ("phi12", "φ₁₂", "φ_12"), ("phiA", "φ_A", "φ_A"), ("t", "t", "t"),
        ("us", "u_s", "u_s"), ("vq", "v_q", "v_q"), ("r_eta2", "r_η2", "r_(η 2)"), ("l_mu", "l_mu", 'l_"mu"'),
        ("x1_dot", "x\u0307₁", "dot(x)_1"), ("phi_dot2", "φ̇₂", "dot(φ)_2"), ("xdot", "x\u0307", "dot(x)"),
        ("dot", "dot", '"dot"'), ("x_ddot", "x_ddot", 'x_"ddot"'),
        ("pivot_dot", "pivot_dot", '"pivot"_"dot"'), ("xB_dot", "x\u0307_B", "dot(x)_B"),
    ],
)  # fmt: skip
def test_names(name: str, text: str, typst: str) -> None:
    assert symbol(name).text == text
    assert symbol(name).typst == typst


def test_a_word_stands_upright_on_a_page_and_a_letter_has_its_index() -> None:
    shown = {"speed": {"t": "speed"}, "speed1": {"v": "speed", "s": "1"}, "phi1": {"v": "φ", "s": "1"}, "t": {"v": "t", "s": ""}}
    assert {name: symbol(name).run for name in shown} == shown


def test_an_acceleration_is_written_as_a_language_does() -> None:
    rates = Rates(frozenset({"w3", "u2", "w"}), "ε")
    assert [symbol(f"d{name}", rates).text for name in ("w3", "u2", "w")] == ["ε₃", "u̇₂", "ε"]
    assert symbol("du2", Rates(frozenset({"u2"}), linear="a")).text == "a₂"
    dotted = [symbol(name, Rates(frozenset({"w1", "phi2"}))) for name in ("dw1", "dphi2", "dw2")]
    assert [(one.text, one.typst) for one in dotted] == [("ω̇₁", "dot(ω)_1"), ("φ̇₂", "dot(φ)_2"), ("dw₂", '"dw"_2')]
    assert symbol("dw3", rates).typst == "ε_3" and symbol("w3", rates).text == "ω₃"


@pytest.mark.parametrize("text", ["", "a b", 'x"', "#eval", "a.b.c", "a-b", "$x$", "x\\"])
def test_what_is_no_name_never_becomes_source(text: str) -> None:
    with pytest.raises(ValueError, match="no name"):
        symbol(text)


def test_sentences_are_split_into_runs() -> None:
    assert runs("V_Cy = 0 along M-B-C") == [{"v": "V", "s": "Cy"}, {"t": " = 0 along M-B-C"}]
    assert runs("φ₃ = 1.2·10⁻⁷ m/s²") == [
        {"v": "φ", "s": "3"}, {"t": " = 1.2·10"}, {"p": "−7"}, {"t": " m/s"}, {"p": "2"},
    ]  # fmt: skip
    assert runs("take --step h/18.") == [{"t": "take "}, {"c": "--step h/18"}, {"t": "."}]
    assert runs("a--b, --strict ends") == [{"t": "a--b, "}, {"c": "--strict"}, {"t": " ends"}]
    assert runs("my_file_name") == [{"t": "my_file_name"}]
    assert runs("√(l2² − 1), l22²", ["l2"]) == [
        {"t": "√("}, {"v": "l", "s": "2"}, {"p": "2"}, {"t": " − 1), l22"}, {"p": "2"},
    ]  # fmt: skip
    assert runs("w3 and phi1, not w33 or a word", ["w3", "phi1", "a"]) == [
        {"v": "ω", "s": "3"}, {"t": " and "}, {"v": "φ", "s": "1"}, {"t": ", not w33 or a word"},
    ]  # fmt: skip


def test_sentences_of_the_tool_are_printed_properly() -> None:
    assert printed("1.07e-05 rad, -0.5 m, 2*cos(x)") == "1.07·10⁻⁵ rad, −0.5 m, 2·cos\u202fx"
    assert printed("sin(phi2 + k - psi2) is zero") == "sin(phi2 + k − psi2) is zero"
    assert printed("E.x - A.x - r2*cos(phi2), (-C.x)*sin(a + b)") == "x_E − x_A − r2·cos\u202fphi2, (−x_C)·sin(a + b)"
    assert printed("C.y drifts; B1.vx too; see v1.0, file A.txt") == "y_C drifts; v_B1x too; see v1.0, file A.txt"


def test_points_of_a_sentence_are_lettered_as_in_a_drawing() -> None:
    points = ("A", "B", "X", "P1", "P3", "D5", "Ki")
    told = runs(with_points("AB, XP1, P1P3 and AKi; A, D5", points))
    assert [run.get("t", "") for run in told] == ["AB, X", "", ", ", "", "", " and A", "", "; A, ", ""]
    assert [run["v"] + run["s"] for run in told if "v" in run] == ["P1", "P1", "P3", "Ki", "D5"]
    for other in ("P2", "AP2", "Kj", "G3x", "V_P1", "row 5"):
        assert with_points(other, points) == other
    assert runs(with_points(printed("along A-P1-B"), points)) == [{"t": "along "}, {"c": "A–P1–B"}]
    assert runs(with_points(printed("along P1-B"), points)) == [{"t": "along "}, {"c": "P1–B"}]


def test_letters_of_the_data_are_symbols_in_a_sentence_and_units_and_words_are_not() -> None:
    letters = ("s", "R", "a", "d", "phi1")
    told = runs(with_letters("a step of 0.4 s: s is off, 2 R and −R; Δ = R², R-S, rad/s, 1/R, d\u202fω/dt", letters))
    assert [run["v"] for run in told if "v" in run] == ["s", "R", "R", "R", "R", "ω"]
    assert runs(with_letters("Given besides: w and v", ("w", "v"))) == [
        {"t": "Given besides: "}, {"v": "ω", "s": ""}, {"t": " and "}, {"v": "v", "s": ""},
    ]  # fmt: skip
    assert [run["s"] for run in runs(with_pairs("it is off in si, at us", ("si", "us", "it", "is"))) if "v" in run] == ["i", "s"]


def test_derivatives_by_the_crank() -> None:
    assert (
        "".join(run.get("t", run.get("v", "") + run.get("s", "")) for run in derivative("dphi2/dphi1")) == "d\u2009φ2/d\u2009φ1"
    )
    assert {"p": "2"} in derivative("d2phi2/dphi12")
    coupler = {"v": "θ", "s": "coupler"}  # as a word it would be too wide for the head of a column, and stand over the next one
    assert coupler in derivative("dtheta_coupler/dphi1") and coupler in runs("θ_coupler = 3 rad")
    assert {"v": "ω", "s": "ConnectingRod"} in runs("ω_ConnectingRod = 3 rad/s")
    neither = f"see e_twelve_twice and x_{'m' * 25}"
    assert runs(neither) == [{"t": neither}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a\u202eb\u200fc", "abc"),
        ("a\x00\x07b\tc\nd", "ab c d"),
        ("\ud800x", "x"),
        ("\ue000x\ue001", "x"),
        ("e\u0301", "é"),
        ("  spaced   out ", "spaced out"),
        ("0.5\u00a0m", "0.5\u00a0m"),
    ],
)
def test_cleaning(text: str, expected: str) -> None:
    assert clean(text) == expected


def test_long_words_get_places_to_break_and_long_texts_an_end() -> None:
    word = clean("W" * 300)
    assert max(len(part) for part in word.split("\u200b")) < 24
    assert word.replace("\u200b", "") == "W" * 300
    assert len(clean("x y " * 5000)) <= LONGEST
    formula = "w1=(V1+V2)*sin(phi1-phi2)/(r1*sin(phi1+alpha_link)*0.123456)"
    pieces = clean(formula).split("\u200b")
    assert len(pieces) > 2 and not any(re.search(r"[\w.]$", one) and re.match(r"[\w.]", two) for one, two in pairwise(pieces))
    assert clean(formula, breaks=False) == formula
    assert clean("Internationalisierung") == "Internationalisierung"


def test_letters_of_the_table_of_invariants_are_symbols(real: ModuleType) -> None:
    [table] = [part for part in real.parts(coursework.solve("variable-crank"), "invariants") if "rows" in part]
    letters = {run["v"] for runs in (table["caption"], table["note"]) for run in runs if "v" in run}
    assert letters == {"s", "S", "Φ", "k", "φ", "a", "b", "c"}


def test_a_letter_that_a_file_may_use_is_the_same_letter_on_the_page() -> None:
    letters = "αβγδεζηθκλμνξπρστφχψωΓΔΘΛΞΠΣΦΨΩ"
    assert "".join(symbol(spell(letter)).letter for letter in letters) == letters
