"""Where a value is zero within a bracket, whatever its shape, and when a motion is another."""

import math
from dataclasses import replace

import numpy as np
import pytest

from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.motion import Stop
from tests.solved import solved


@pytest.mark.parametrize(("value", "root", "most"), [
    (lambda x: x - 0.3, 0.3, 2), (lambda x: 0.3 - x, 0.3, 2), (lambda x: x**3 - 0.027, 0.3, 14),
    (lambda x: 1 - 1e-3 / x, 1e-3, 40),
    (lambda x: math.expm1(20 * (x - 0.9)), 0.9, 40), (lambda x: -math.expm1(20 * (x - 0.1)), 0.1, 40),
    (lambda x: (x - 0.5) * 1e-300, 0.5, 2), (lambda x: x**9 - 1e-9, 0.1, 60), (lambda x: math.copysign(1.0, x - 0.7), 0.7, 60),
])  # fmt: skip
def test_a_zero_is_found_from_both_sides_in_few_looks(value, root, most):
    looked = []

    def seen(x):
        looked.append(x)
        return value(x)

    low = 1e-4
    found = crossing(seen, (low, 1.0), (value(low), value(1.0)), 1e-12)
    assert found == pytest.approx(root, abs=2e-12)
    assert len(looked) <= most and all(low < x < 1.0 for x in looked)


def test_a_wide_share_settles_soon_and_no_number_is_no_zero():
    looked = []
    crossing(lambda x: looked.append(x) or x**3 - 0.027, (0.0, 1.0), (-0.027, 0.973), 0.1)
    assert len(looked) <= 4
    assert crossing(lambda x: math.nan, (0.0, 1.0), (-1.0, 1.0), 1e-9) is None
    assert crossing(lambda x: math.inf, (0.0, 1.0), (-1.0, 1.0), 1e-9) is None
    assert crossing(lambda x: 0.0, (2.0, 4.0), (-1.0, 3.0), 1e-9) == 2.5  # the straight line's place, where it is zero
    assert crossing(lambda x: x, (2.0, 4.0), (0.0, 0.0), 1e-9) in {2.0, 4.0}  # both ends are zero
    assert crossing(lambda x: x, (0.0, 4.0), (0.0, 3.0), 1e-9) == 0.0


def test_motions_are_equal_where_their_names_scheme_step_stop_and_rows_are():
    motion = solved("31").motion
    rows = motion.coordinates.copy()
    rows[-1, -1] = np.nextafter(rows[-1, -1], 9.0)
    same = replace(motion, label="another", notes=("said",), evaluations=0)
    assert same == motion and hash(same) == hash(motion) and motion != motion.rows.tolist()
    others = [
        {"coordinates": rows}, {"step": 2 * motion.step}, {"scheme": "rk4"}, {"t": motion.t + 1.0},
        {"velocities": motion.velocities + 1.0}, {"velocity_names": motion.velocity_names[::-1]},
        {"stop": Stop("dead point", 0.1, 2.0, ("w2",), {}, "It stops.", "It cannot go on.")},
    ]  # fmt: skip
    assert all(replace(motion, **changes) != motion for changes in others)
    with pytest.raises(ValueError, match="read-only"):
        motion.rows[0, 0] = 1.0
    assert motion.column("t") is motion.t and motion.column("w3").tolist() == motion.rows[:, motion.names.index("w3")].tolist()
    with pytest.raises(KeyError, match=r"no column 'w9'.*t, .*w3"):
        motion.column("w9")
