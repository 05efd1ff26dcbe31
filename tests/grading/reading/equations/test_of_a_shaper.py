"""The equations of a shaper as people write them: sliding as ds/dt, a length by its square, velocities of points."""

from __future__ import annotations

from functools import cache

import pytest

import coursework
from coursework.grading.marking.equations.equations import EquationMarks, Judge
from coursework.grading.marking.key.key import key_to_mark_by
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.expected import Expected
from tests.mechanisms.library import FOLDERS


@cache
def key():
    return key_to_mark_by(coursework.load(FOLDERS[0] / "shaper-equations.toml"))


def marked(text: str) -> EquationMarks:
    return Judge(key()).mark(read_lines(text, "equations.txt", Expected(key().grid, key().variant)).equations)


RODS = "w4 = -L*w3*cos(phi3)/(b*cos(phi4))\nv = -L*w3*sin(phi3) - b*w4*sin(phi4)\n"
FORMS = {
    "the square of a length": "DA^2 = r² + d² + 2 r d sin(phi1)\nw3 = w1*r*cos(phi1 - phi3)/DA\nu = w1*r*sin(phi3 - phi1)\n"
    + RODS,
    "derivatives": """u = ds/dt
-r sin(phi1) dphi1/dt = ds/dt cos(phi3) - s sin(phi3) dphi3/dt
r cos(phi1) dphi1/dt = ds/dt sin(phi3) + s cos(phi3) dphi3/dt
L cos(phi3) dphi3/dt + b cos(phi4) dphi4/dt = 0
dx_C/dt = -L sin(phi3) dphi3/dt - b sin(phi4) dphi4/dt
""",
    "vectors above": "VA = VA' + Vr\nVC = VB + VCB\nVB = L*w3\nVCB = b*w4\nu = w1*r*sin(phi3 - phi1)\n"
    "s*w3 = w1*r*cos(phi1 - phi3)\n" + RODS,
}


@pytest.mark.parametrize("form", FORMS)
def test_the_equations_are_right_and_a_turned_sign_in_them_is_wrong(form):
    found = marked(FORMS[form])
    assert found.independent == 4 and not found.wrong
    slipped = FORMS[form].replace("- b*w4*sin(phi4)", "+ b*w4*sin(phi4)").replace("- b sin(phi4)", "+ b sin(phi4)")
    assert len(marked(slipped).wrong) == 1


def test_a_velocity_that_the_task_does_not_name_is_not_read_as_a_product():
    found = marked("-r*w1*sin(phi1) = -s*w3*sin(phi3) + Vr*cos(phi3)\n" + RODS)
    assert not found.wrong and found.unread
