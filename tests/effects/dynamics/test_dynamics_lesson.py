"""What the lesson under forces says a scheme does to the energy."""

import pytest

from coursework.effects.dynamics.dynamics_lesson import lesson
from tests.effects.test_dynamics import reference
from tests.solved import solved


def test_the_energy_that_euler_makes_of_a_free_arm_is_told():
    """21.015 J at 2 s where 17.940 J must stay: the reference run of the arm."""
    run = solved("falling-arm", scheme="exact")
    scene = run.scene
    rows = lesson(scene.free_equations, scene.begin_of_forces, scene.variant.time, run.motion)
    listed = reference("arm")["free"]["euler energy"]
    assert rows[0].slopes == len(listed) - 1
    assert rows[0].gained == pytest.approx(listed[-1] - listed[0], abs=1e-6)
