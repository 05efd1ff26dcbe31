"""The velocity equations on a page as the guide writes them: vectors along a path, their projections, the sums they come to."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Sequence
from fractions import Fraction
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from coursework import load, parse_variant, solve
from coursework.mechanism.derivation.derive import Combination
from coursework.report.sections.derivation.motion_equations import _rank, _reduction, _sum, _unchecked
from coursework.report.text.words import Words
from coursework.words.sentences import load_phrases
from tests.hard.families import random_case
from tests.report.made import model_of
from tests.solved import solved


def test_projections_are_written_as_in_the_guide():
    """Guide, (8): the velocity that is sought stands left, what it is made of right of it, in the order of the path."""
    (found,) = (one for one in model_of(solved("31")).sections if one.name == "equations")
    told = [[item.text for item in part.items] for part in found.parts if part.kind == "equations"]
    assert told[1][0] == "V_C = V_M + V_BM + V_CB"
    assert told[2][0] == "V_Cy = V_My + ω₃ · 2 r₃ cos(φ₃ + π) + ω₃ r₃ cos(φ₃ + π / 2) = 0"


def test_a_file_without_equations_shows_the_way_of_the_guide_too(real: ModuleType) -> None:
    """A driven chain of bars in a guide, given by its points alone; without a path between velocities only positions are left."""
    told = real.text_of(real.parts(solve(parse_variant(random_case(2).text), quantities=["table"]), "equations"))
    assert "by the links between them, along M–B–A–D" in told
    assert told.index("Projected onto the axes") < told.index("Also, from differentiating the position equations")
    alone = real.text_of(real.parts(solve(parse_variant(real.HELD), quantities=["table"]), "equations"))
    assert alone.startswith("From differentiating the position equations:")


@pytest.mark.parametrize("quarters", [1, 2, 3])
@pytest.mark.parametrize("function", ["cos", "sin"])
def test_what_an_angle_with_right_angles_is_reduced_to_is_the_same_number(function: str, quarters: int) -> None:
    """cos(φ + π) = -cos φ, and a number where no angle stands beside them: both sides at an angle of 0.7."""
    right = {"0": 0, "1": 1, "cos φ": math.cos(0.7), "sin φ": math.sin(0.7)}
    for base, angle in (("φ + ", 0.7), ("", 0.0)):
        left, reduced = _reduction(function, Fraction(quarters, 2), bool(base)).text.split(" = ")
        assert left.replace("(", " ").strip(")").split(" ", 1) == [function, base + ("π / 2", "π", "3 π / 2")[quarters - 1]]
        value = right[reduced.lstrip("−")] * (-1 if reduced.startswith("−") else 1)
        assert value == pytest.approx(getattr(math, function)(angle + quarters * math.pi / 2), abs=1e-15)
        assert ("φ" in reduced) == bool(base)


@pytest.mark.parametrize("signs", list(itertools.product((1, -1), repeat=3)))
def test_a_sum_of_equations_is_written_with_the_sign_of_each(signs: tuple[int, ...]) -> None:
    written = _sum(Combination("9", tuple(zip(signs, ("8", "10a", "11"), strict=True))))
    left, right = written.split(" = ")
    assert left == "(9)"
    assert re.findall(r"([−+]?) ?(\(\w+\))", right) == [
        ("−" if sign < 0 else "+" if place else "", name)
        for place, (sign, name) in enumerate(zip(signs, ("(8)", "(10a)", "(11)"), strict=True))
    ]  # fmt: skip


def told_of(agreed: Sequence[str] | None, **found: Any) -> tuple[str, str]:
    """What a page says of two equations that no path gives, beside those that it has and where it has none."""
    closure = None if agreed is None else SimpleNamespace(agreed=tuple(agreed), unjudged=(("10", ("VC",)), ("12", ("VC",))))
    nothing_derived = SimpleNamespace(equations=(), from_closure=(), bound=())
    scene = SimpleNamespace(closure=closure, equations=nothing_derived, start=())
    run = SimpleNamespace(scene=scene, variant=load("v102"))
    context: Any = SimpleNamespace(words=Words(load_phrases()), run=run, told=lambda sentence: "ADVICE.")
    given = {"projections": (), "rank": 0, "dependent": (), "followed": (), "beyond": ("10", "11"), **found}
    parts = _rank(context, SimpleNamespace(**given))  # type: ignore[arg-type]
    return "".join(run.get("t", "") for part in parts for run in part.text), _unchecked(context, ("10", "11"))  # type: ignore[union-attr]


@pytest.mark.parametrize("agreed", [None, (), ("11",), ("10",), ("10", "11")])
def test_signs_are_said_to_be_confirmed_of_the_equations_that_the_positions_confirm(agreed: Sequence[str] | None) -> None:
    """Advice comes once, though two equations lack the same velocity; without positions nobody knows what is lacking."""
    kept = [name for name in ("10", "11") if name in (agreed or ())]
    rest = [name for name in ("10", "11") if name not in kept]
    for told in told_of(agreed):
        assert ("the geometry of the file confirms the signs" in told) == bool(kept)
        assert ("nothing here checks the signs" in told.lower()) == bool(rest)
        assert told.count("ADVICE.") == (agreed is not None)
    beyond, alone = told_of(agreed)
    for name in ("10", "11"):
        sentences = [one for one in beyond.split(". ") if f"({name})" in one and "No path" in one]
        assert len(sentences) == 1 and ("confirms" in sentences[0]) == (name in kept)
        sentences = [one for one in alone.split(". ") if f"({name})" in one]
        assert len(sentences) == bool(kept) and all(("confirms" in one) == (name in kept) for one in sentences)


@pytest.mark.parametrize(
    ("count", "rank", "said"), [(1, 1, ""), (2, 2, "All of them"), (3, 3, "All of them"), (3, 2, "Of 3 equations, 2 are")]
)
def test_how_many_equations_are_independent_is_said_of_more_than_one(count: int, rank: int, said: str) -> None:
    projections = tuple(SimpleNamespace(name=str(place)) for place in range(count))
    sums = (Combination("2", ((1, "0"), (-1, "1"))), Combination("2", ()))
    told, _ = told_of(None, projections=projections, rank=rank, beyond=(), dependent=sums, followed=("0", "mixed"))
    assert told.startswith(said or "(2) = (0) − (1). ")
    assert ("independent" in told) == bool(said)
    assert told.endswith("(2) = (0) − (1). Sums of projections, that is, projections onto rotated axes: (mixed).")
    assert told_of(None, projections=projections[:1], rank=1, beyond=())[0] == ""
