"""What a line says of a name: a legend names a coordinate or a velocity sought, and says nothing else."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for
from coursework.grading.reading.equations.text.legends import with_legend
from tests.grading.scenes import expected


@pytest.mark.parametrize(
    ("line", "called"),
    [
        ("ψ = φ1", {"psi": "phi1"}), ("φ1 = ψ", {"psi": "phi1"}), ("Ω = w1", {"Omega": "w1"}),
        ("- angle: ψ = φ1.", {"psi": "phi1"}),
        ("ψ, β - angles of links 1, 2", {"psi": "phi1", "beta": "phi2"}),
        ("ψ for link 1, β for link 2", {"psi": "phi1", "beta": "phi2"}),
        # a name too many, a name or a length of the task, no link of the task, more than a legend
        ("ψ, β, γ - angles of links 1, 2", {}), ("ψ, r1 - angles of links 1, 2", {}), ("ψ, β - angles of links 1, 7", {}),
        ("r1 = φ1", {}), ("sin = φ1", {}), ("L of link 1", {}), ("ψ for link 1 is small", {}), ("ψ = 2*φ1", {}),
        ("Ω = w1 + 2", {}), ("где ωк = w1 — колесо", {"ωк": "w1"}), ("Ω = w1 - speed of link 1", {}),
        ("Ω = w1 - speed of the crank", {"Omega": "w1"}), ("ψ = φ1 - beta", {}),
        ("ψ = r1", {}), ("φ2 = φ1", {}),
    ],
)  # fmt: skip
def test_a_line_is_a_legend_or_stays(line: str, called: dict[str, str]) -> None:
    names, rest = with_legend([(7, line)], names_for(expected()))
    assert {name: names.spellings.canonical(name) for name in called} == called
    assert (rest == [(7, line)]) is not bool(called)
    assert names.before is None
    assert names.spellings.canonical("r1") == "r1" and names.spellings.canonical("phi2") == "phi2"


@pytest.mark.parametrize(("row", "read"), [
    ("L ⇒ r1", "L = r1"),
    # of the task both, or none; no datum; an arrow between equations
    ("r2 ⇒ r1", ""), ("φ1 ⇒ r1", ""), ("L ⇒ K", ""), ("r1 ⇒ L", ""), ("L ⇒ w1 + 1", ""), ("w1 = 2 ⇒ w2 = 3", ""),
])  # fmt: skip
def test_a_row_that_leads_from_the_students_name_to_a_datum_gives_it_that_name(row: str, read: str) -> None:
    names, rest = with_legend([(7, row)], names_for(expected()))
    assert rest == [(7, read or row)]
    assert names == names_for(expected())


@pytest.mark.parametrize(("length", "is_one"), [(300, True), (301, False)])
def test_a_line_longer_than_three_hundred_signs_is_no_legend(length: int, is_one: bool) -> None:
    _, rest = with_legend([(1, "angle".ljust(length - 6) + "ψ = φ1")], names_for(expected()))
    assert (rest == []) is is_one


def test_the_first_legend_of_a_name_holds_and_the_letter_of_a_datum_may_be_an_angle() -> None:
    names, rest = with_legend([(1, "ψ = φ1"), (2, "ψ = φ2"), (3, "w1 = 2")], names_for(expected()))
    assert (names.spellings.canonical("ψ"), rest) == ("phi1", [(3, "w1 = 2")])
    task = names_for(expected("watt"))  # in which gamma is a datum
    names, rest = with_legend([(1, "γ = φ1")], task)
    assert (names.spellings.canonical("gamma"), rest) == ("phi1", [])
    assert names.before is not None and names.before.spellings.canonical("gamma") == "gamma"
