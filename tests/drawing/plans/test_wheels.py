"""Wheels in the plans: what touches something at rest has its contact at the pole, a gear goes with its rack."""

from __future__ import annotations

import pytest

from tests.drawing.plans.test_polygons import drawings_of, run_of, run_plans, vectors


def test_a_gear_moves_at_its_contact_as_its_rack_and_is_drawn_after_it() -> None:
    """By hand: Q of the gear has the speed of the rack c, and the acceleration of it beside the square of w4 times R."""
    drawn = drawings_of("v112")
    velocity, acceleration = (drawn[f"{plan}-plan"].steps for plan in ("velocity", "acceleration"))
    (place,) = (k for k, step in enumerate(velocity) if step.startswith("At Q the wheel has the velocity of the body it touches"))
    assert velocity[place - 1].startswith("c lies where two lines meet") and not any("at rest" in step for step in velocity)
    assert acceleration[place].startswith("Along the common tangent the point Q of the wheel has the acceleration of the body it")
    row = run_of("v112").of(run_plans()).row
    found = {key[1:]: z for key, z in vectors("v112", row).items() if key[0] == "table" and key[2] == "absolute"}
    rack, contact = (found["velocity", "absolute", "pole", name] for name in "CQ")
    assert contact == pytest.approx(rack, abs=1e-12)
    gap = found["acceleration", "absolute", "pole", "Q"] - found["acceleration", "absolute", "pole", "C"]
    radius = 0.225  # of the pitch circle
    assert abs(gap) == pytest.approx(abs(contact) ** 2 / radius, rel=1e-9)


def test_a_wheel_on_what_rests_has_its_contact_at_the_pole() -> None:
    assert any(step.startswith("The contact P of the wheel is at rest") for step in drawings_of("31")["velocity-plan"].steps)


@pytest.mark.parametrize("name", ["variable-crank", "variable-crank-table"])
def test_the_pin_of_a_crank_whose_length_is_a_law_is_carried_by_it(name: str) -> None:
    steps = drawings_of(name)["velocity-plan"].steps
    assert "V_A" not in steps[0] or "is given" not in steps[0]
    assert any("Link and length change as given" in step for step in steps)
