"""What the lesson under forces says a scheme does to the energy."""

from dataclasses import replace

import pytest

from coursework.effects.dynamics.dynamics_lesson import lesson
from tests.effects.test_dynamics import reference
from tests.solved import solved


def test_the_energy_that_euler_makes_of_a_free_arm_is_told():
    """21.015 J at 2 s where 17.940 J must stay: the reference run of the arm."""
    run = solved("falling-arm", scheme="exact")
    scene = run.scene
    rows = lesson(replace(scene.moved, exact=run.motion))
    listed = reference("arm")["free"]["euler energy"]
    assert rows[0].slopes == len(listed) - 1
    assert rows[0].gained == pytest.approx(listed[-1] - listed[0], abs=1e-6)


class Dear:
    """Equations of motion that take so many times as long to evaluate."""

    def __init__(self, equations, dear):
        self.equations, self.dear = equations, dear

    def __getattr__(self, name):
        return getattr(self.equations, name)


@pytest.mark.parametrize(("dear", "slopes"), [(7, [200, 800, 200, 800, 400, 1600, 800]), (8, [])])
def test_only_trials_that_take_a_quarter_of_a_second_are_made(dear, slopes):
    """200 steps in 1, 4 and 16 parts, with 1, 1, 2 and 4 slopes each; 20 000 slopes, a seventh of them for these equations.

    Thus 2857 each and twelve times that together are few enough; an eighth, 2500, is less than a twelfth of all 33 600.
    """
    run = solved("falling-arm", scheme="exact")
    scene = run.scene
    rows = lesson(replace(scene.moved, equations=Dear(scene.free_equations, dear), exact=run.motion))
    assert [row.slopes for row in rows] == slopes
