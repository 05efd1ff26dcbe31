"""The equations of a shaper as people write them: sliding as ds/dt, a length by its square, velocities of points."""

from __future__ import annotations

from functools import cache

import pytest

import coursework
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.key.key import key_to_mark_by
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.expected import Expected
from tests.mechanisms.library import FOLDERS


@cache
def key():
    return key_to_mark_by(coursework.load(FOLDERS[0] / "shaper-equations.toml"))


@cache
def judge():
    return Judge(key())


def marked(text: str) -> EquationMarks:
    return judge().mark(read_lines(text, "equations.txt", Expected(key().grid, key().variant)).equations)


RODS = "w4 = -L*w3*cos(phi3)/(b*cos(phi4))\nv = -L*w3*sin(phi3) - b*w4*sin(phi4)\n"
BLOCK = "r cos(phi1 - phi3) w1 = s w3\nu = r*w1*sin(phi3 - phi1)\n"
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
    "cells with a legend": """B1 = r, B2 = L, B3 = b, B4 = w1; row 9: B = phi1, C = phi3, D = phi4, E = s
F9: u = B$1*B$4*SIN(C9-B9)
G9 (w3): =B$1*B$4*COS(B9-C9)/E9
w4 in H9: =-B$2*G9*COS(C9)/(B$3*COS(D9))
v: I9 = -B$2*G9*SIN(C9) - B$3*H9*SIN(D9)
""",
    "differentials": BLOCK + "L cos(phi3) dphi3 + b cos(phi4) dphi4 = 0\nv dt = -L sin(phi3) dphi3 - b sin(phi4) dphi4\n",
    "rates that others use": """phi3p = r*w1*cos(phi1 - phi3)/s
phi4p = -L*phi3p*cos(phi3)/(b*cos(phi4))
u = r*w1*sin(phi3 - phi1)
v = -L*phi3p*sin(phi3) - b*phi4p*sin(phi4)
""",
    "round matrices": BLOCK + "(L*cos(phi3)  b*cos(phi4)\nL*sin(phi3)  b*sin(phi4))·(w3\nw4)=(0\n−v)\n",
    "pointers": """o->u = r*w1*sin(q->phi3 - q->phi1);
o->w3 = r*w1*cos(q->phi1 - q->phi3)/q->s;
o->w4 = -L*o->w3*cos(q->phi3)/(b*cos(q->phi4));
o->v = -L*o->w3*sin(q->phi3) - b*o->w4*sin(q->phi4);
""",
    "cells of Eigen": BLOCK
    + """Eigen::Matrix2d A; Eigen::Vector2d k;
A << L*cos(phi3), b*cos(phi4),
     L*sin(phi3), b*sin(phi4);
k << 0, −v;
Eigen::Vector2d x = A.partialPivLu().solve(k);
double w3 = x(0), w4 = x(1);
""",
    "names explained": "c1 = w3 (rocker), sl = u\nsl = r*w1*sin(phi3 - phi1)\nw3 = crank*w1*cos(phi1 - phi3)/s  # crank = r\n"
    + RODS,
}
SLIPS = {"- b*": "+ b*", "- b sin(phi4)": "+ b sin(phi4)", "- B$3*": "+ B$3*", "−v)": "v)", "−v;": "v;"}


@pytest.mark.parametrize("form", FORMS)
def test_the_equations_are_right_and_a_turned_sign_in_them_is_wrong(form):
    found = marked(FORMS[form])
    assert found.independent == 4 and not found.wrong
    slipped = next(FORMS[form].replace(*slip) for slip in SLIPS.items() if slip[0] in FORMS[form])
    assert len(marked(slipped).wrong) == 1


def test_a_velocity_that_the_task_does_not_name_is_not_read_as_a_product():
    found = marked("-r*w1*sin(phi1) = -s*w3*sin(phi3) + Vr*cos(phi3)\n" + RODS)
    assert not found.wrong and found.unread
