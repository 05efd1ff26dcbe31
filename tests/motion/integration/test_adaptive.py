"""The next step of a pair: shorter by the root of its order, 0.85 of that to be safe, never much shorter or longer."""

import pytest

from coursework.motion.integration.adaptive import next_length


@pytest.mark.parametrize(
    ("ratio", "order", "part"),
    [
        (1.0, 5, 0.85), (32.0, 5, 0.425), (1 / 32, 5, 1.7), (256.0, 8, 0.425), (256.0, 4, 0.2125), (257**4, 4, 0.2),
        (0.85**4 / 3.9**4, 4, 3.9), (0.85**4 / 4.1**4, 4, 4.0), (0.85**4 / 0.21**4, 4, 0.21), (0.85**4 / 0.19**4, 4, 0.2),
        (0.0, 5, 4.0),
    ],
)  # fmt: skip
def test_the_next_step(ratio, order, part):
    assert next_length(3.0, ratio, order) == pytest.approx(3.0 * part, rel=1e-12)
    assert next_length(3.0, ratio) == next_length(3.0, ratio, 5)
