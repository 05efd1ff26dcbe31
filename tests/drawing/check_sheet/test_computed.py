"""What no reading gives, of links that only all links together determine, is computed: each value once, and said so."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from coursework.drawing.check_sheet.check_plan import CheckPlan
from coursework.drawing.check_sheet.instant_centres import construct
from coursework.drawing.check_sheet.readings import Reading, read_off
from coursework.drawing.check_sheet.sketch import Body
from coursework.drawing.plans.plan_scale import PlanScale
from tests.drawing.check_sheet.checked import scene

# Two bars hang on driven points and meet in X, which moves at (0.4, 0.2) m/s; the bars turn at 0.7 and -1.3 rad/s.
AT = {"A": 0j, "X": 1 + 2j, "B": 3 - 1j}
SPEED, OMEGAS = 0.4 + 0.2j, (0.7, -1.3)
MOVED = {name: SPEED - 1j * omega * (AT["X"] - AT[name]) for name, omega in zip("AB", OMEGAS, strict=True)}


def read(*bodies: Body, rates: dict[str, float] | None = None, moving: str = "X") -> dict[str, Reading]:
    pose = scene(AT, [*bodies], velocities=MOVED, rates=rates)
    sketch: Any = SimpleNamespace(pose=pose, moving=tuple(moving), wheels={}, racks={}, hinges=())
    layout: Any = SimpleNamespace(near=frozenset(), scale=10)
    found = read_off(sketch, construct(pose), layout, {"ω₁": 0.7, "V_X": 0.5}, None)
    assert len({one.name for one in found}) == len(found)
    return {one.name: one for one in found}


@pytest.mark.parametrize("moving", ["X", ""])
def test_rates_and_speeds_of_a_dyad_are_computed_each_once(moving: str) -> None:
    found = read(Body("1", ("A", "X")), Body("2", ("X", "B")), moving=moving)
    assert [*found] == ["ω₁", *(["V_X"] if moving else []), "ω₂"]  # the speed of a point at rest is no reading
    values = {"ω₁": abs(OMEGAS[0]), "ω₂": abs(OMEGAS[1]), "V_X": abs(SPEED)}
    for name, one in found.items():
        assert one.found == pytest.approx(values[name]), name
        assert (one.relation, one.unit) == ("computed, from all links together", "m/s" if name == "V_X" else "rad/s")
        assert (one.length, one.read, one.computed, one.explained, one.rests) == ("", None, None, 0.0, False)
    assert found["ω₁"].table == 0.7 and found["ω₂"].table != found["ω₂"].table


def test_a_block_of_one_point_has_no_rate_to_compute() -> None:
    assert [*read(Body("1", ("A", "X")), Body("2", ("X", "B")), Body("3", ("X",)))] == ["ω₁", "V_X", "ω₂"]


@pytest.mark.parametrize("longest", [0.004, 250.0])
@pytest.mark.parametrize(("part", "moves"), [(0.98e-7, False), (1.02e-7, True)])
def test_a_point_moves_if_its_vector_is_no_round_off_beside_the_longest(longest: float, part: float, moves: bool) -> None:
    plan: Any = SimpleNamespace(drawn={"A": 1j * part * longest}, scale=SimpleNamespace(longest=longest))
    assert CheckPlan.moves(plan, "A") is moves


@pytest.mark.parametrize("longest", [0.004, 250.0])
@pytest.mark.parametrize(("part", "seen"), [(0.98e-7, False), (1.02e-7, True)])
def test_a_vector_has_no_length_on_paper_if_it_is_round_off(longest: float, part: float, seen: bool) -> None:
    length, _ = PlanScale(longest / 80, 1, longest).length(part * longest)
    assert length == (pytest.approx(80 * part) if seen else 0.0)
