"""A boom that a cylinder raises, in a row of Euler that has drifted: the plan has the cylinder's speed from the drive."""

import cmath
import math
from typing import Any

import pytest

import coursework
from coursework.scene.quantities import PLANS
from tests.mechanisms.library import mechanism

RADIUS, PIVOT, SPEED, STEP = 0.9, 0.5 - 0.5j, 0.12, 0.5
REACH = RADIUS * cmath.exp(0.9j) - PIVOT
SLIDES = '2 = { points = ["B"], rate = "w2" }\n3 = { points = ["C"], slides = 2, rate = "w2" }'
SLEEVE = SLIDES.replace('slides = 2, rate = "w2"', "slides = 2")
BOTH = SLEEVE.replace('["B"]', '["B", "C"]')  # the rod's end stands among the points of the cylinder too
BAR = '2 = { points = ["B", "C"], rate = "w2" }'


def solved(links: str, ask: str = "") -> Any:
    text = mechanism(
        "boom", ('"1.5 m"', f'"{abs(REACH)!r} m"'), ("56.5095660113926 deg", "0.9 rad"), (SLIDES, links),
        ("81.6690103396294 deg", f"{cmath.phase(REACH)!r} rad"), ("check_row = 20", "check_row = 7"), c=f"{RADIUS} m",
        v1=f"{SPEED} m/s", xB="0.5 m", yB="-0.5 m", p=None, us="v1", step=f"{STEP} s", end="3 s", period=None,
    )  # fmt: skip
    return coursework.solve(
        coursework.parse_variant(f'{text}[ask]\nquantities = ["table", "plans"{ask}]\n', "boom.toml"), "euler"
    )


def by_hand() -> tuple[float, float, float, float]:
    """Return phi, psi, w1, w2 in the last row of Euler, from u = w1 r sin(psi - phi) and s w2 = w1 r cos(psi - phi)."""
    phi, psi, s = 0.9, cmath.phase(REACH), abs(REACH)
    for k in range(7):
        w1 = SPEED / (RADIUS * math.sin(psi - phi))
        w2 = w1 * RADIUS * math.cos(psi - phi) / s
        if k < 6:
            phi, psi, s = phi + STEP * w1, psi + STEP * w2, s + STEP * SPEED
    return phi, psi, w1, w2


def test_what_slides_at_a_driven_rate_has_it_in_the_plan_too():
    run = solved(SLEEVE)
    phi, psi, w1, _ = by_hand()
    last = {(s.plan, s.kind, s.start, s.end): complex(s.vector[-1]) for s in run.of(PLANS).table.segments}
    arm = RADIUS * cmath.exp(1j * phi) - PIVOT
    assert abs(abs(arm) - (abs(REACH) + 6 * STEP * SPEED)) > 0.01  # the row has drifted
    sliding = last["velocity", "sliding", "C'", "C"]
    assert sliding == pytest.approx(SPEED * cmath.exp(1j * psi), abs=1e-12)
    assert last["velocity", "absolute", "pole", "C'"] == pytest.approx(
        1j * w1 * RADIUS * cmath.exp(1j * phi) - sliding, abs=1e-12
    )
    assert abs(last["acceleration", "sliding", "C'", "C"]) < 1e-12  # the speed is constant


@pytest.mark.parametrize("links", [BOTH, BAR])
def test_a_cylinder_among_whose_points_the_rods_end_stands_is_drawn_and_no_rigid_link(links):
    run = solved(links)
    first = run.of(PLANS).drawings(str)[0].steps[0]
    assert "from the pole at right angles to BC." not in first
    assert ("No two known lines meet in c" in first) == (links == BAR)
    assert links == BAR or "12.0 mm along link 2, as its length is driven" in first
    with pytest.raises(coursework.InputError, match="BC changes"):
        solved(links, ', "graph_check"').graph_check.sheets(str)
