"""A boom that a cylinder raises, in a row of Euler that has drifted: the plan has the cylinder's speed from the drive."""

import cmath
import math
from typing import Any

import pytest

import coursework
from coursework.scene.quantities import PLANS

RADIUS, PIVOT, SPEED, STEP = 0.9, 0.5 - 0.5j, 0.12, 0.5
REACH = RADIUS * cmath.exp(0.9j) - PIVOT
BOOM = f"""
[given]
r = "{RADIUS} m"
d = "0.5 m"
u0 = "{SPEED} m/s"
[drive]
u = "u0"
[coordinates]
phi = {{ start = "0.9 rad", rate = "w1" }}
psi = {{ start = "{cmath.phase(REACH)!r} rad", rate = "w2" }}
s = {{ start = "{abs(REACH)!r} m", rate = "u", unit = "m" }}
[time]
step = "{STEP} s"
end = "3 s"
check_row = 7
[points]
O = "(0, 0)"
C = "(d, -d)"
B = "O + r @ phi"
[links]
1 = {{ points = ["O", "B"], rate = "w1" }}
LINKS
[frame]
hinges = ["O", "C"]
[[constraint]]
name = "loop"
because = "the cylinder reaches from C to B"
closure = "C + s @ psi = O + r @ phi"
[ask]
quantities = ["table", "plans"]
"""
SLEEVE = '2 = { points = ["C"], rate = "w2" }\n3 = { points = ["B"], slides = "2" }'
BOTH = SLEEVE.replace('["C"]', '["C", "B"]')  # the rod's end stands among the points of the cylinder too
BAR = '2 = { points = ["C", "B"], rate = "w2" }'


def solved(links: str, ask: str = "") -> Any:
    text = BOOM.replace("LINKS", links).replace('"plans"', '"plans"' + ask)
    return coursework.solve(coursework.parse_variant(text, "boom.toml"), "euler")


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
    sliding = last["velocity", "sliding", "B'", "B"]
    assert sliding == pytest.approx(SPEED * cmath.exp(1j * psi), abs=1e-12)
    assert last["velocity", "absolute", "pole", "B'"] == pytest.approx(
        1j * w1 * RADIUS * cmath.exp(1j * phi) - sliding, abs=1e-12
    )
    assert abs(last["acceleration", "sliding", "B'", "B"]) < 1e-12  # the speed is constant


@pytest.mark.parametrize("links", [BOTH, BAR])
def test_a_cylinder_among_whose_points_the_rods_end_stands_is_drawn_and_no_rigid_link(links):
    run = solved(links)
    first = run.of(PLANS).drawings(str)[0].steps[0]
    assert "from the pole at right angles to CB." not in first
    assert ("No two known lines meet in b" in first) == (links == BAR)
    assert links == BAR or "12.0 mm along link 2, as its length is driven" in first
    with pytest.raises(coursework.InputError, match="BC changes"):
        solved(links, ', "graph_check"').graph_check.sheets(str)
