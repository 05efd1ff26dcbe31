"""The velocity equations on a page as the guide writes them: vectors along a path, their projections, the sums they come to."""

from __future__ import annotations

from types import ModuleType

from coursework import parse_variant, solve
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
