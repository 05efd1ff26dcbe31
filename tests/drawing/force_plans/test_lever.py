"""Zhukovsky's lever: forces at the turned images of their points, arms from the pole, and what the drive must do by them."""

import numpy as np
import pytest

from coursework.drawing.force_plans.lever import ARROW, Arm, Lever, draw_lever, levers_of
from coursework.takeaway.figures.shapes import Arrow, Chain, Circle, shapes_of
from coursework.words.sentences import load_phrases
from tests.effects.massed import of

# Image (mm) and force (N): the arm is that of the force about the pole, + counter-clockwise.
ARMS = {"F2": (30 + 0j, 5j, 30.0), "G3": (-20 + 15j, 9 + 0j, -15.0), "P": (12 - 5j, 24 - 10j, 0.0)}


def test_each_force_stands_at_its_image_and_its_arm_across_its_line():
    arms = tuple(Arm(name, (name[0], name[1:], ""), force, image, h) for name, (image, force, h) in ARMS.items())
    drawing = draw_lever(Lever("M1", 0.01, arms, 0.0, 0.0, 0.0), 3, 0.06, load_phrases("en").written)
    shapes = list(shapes_of(drawing.svg, drawing.height))
    (pole,) = [one.middle for one in shapes if isinstance(one, Circle) and one.radius == pytest.approx(0.8)]
    arrows = {one.pen.data["force"]: one for one in shapes if isinstance(one, Arrow) and "force" in one.pen.data}
    assert list(arrows) == list(ARMS)
    chains = [tuple(point - pole for point in one.points) for one in shapes if isinstance(one, Chain)]

    def stands(begin, end):
        return any(abs(points[0] - begin) + abs(points[-1] - end) < 0.05 for points in chains if len(points) == 2)

    for name, (image, force, h) in ARMS.items():
        tip, tail = arrows[name].points[0] - pole, arrows[name].points[-1] - pole
        assert tail == pytest.approx(image, abs=0.02) and tip - tail == pytest.approx(ARROW * force / abs(force), abs=0.02)
        foot = h * -1j * force / abs(force)
        assert stands(0j, image)
        assert stands(0j, foot) is (h != 0.0) and stands(image, foot) is (abs(foot - image) > 0.3)
        assert 0 <= (pole + tip).real <= drawing.width and 0 <= (pole + tip).imag <= drawing.height
    assert (drawing.id, drawing.exact) == ("lever-M1", True)
    assert "row 4" in drawing.caption and "row 4" in drawing.alt
    around = [(pole, 6.0), *((one.points[k], 6.0 + k) for one in arrows.values() for k in (0, -1))]
    around += [(pole + h * -1j * force / abs(force), 3.0) for _, force, h in ARMS.values()]
    low, high = min(at.imag - room for at, room in around), max(at.imag + room for at, room in around)
    assert (low, high) == pytest.approx((17.0 + 2.0, drawing.height - 2.0), abs=0.03)  # over the foot
    left, right = min(at.real - room for at, room in around), max(at.real + room for at, room in around)
    assert left + right == pytest.approx(drawing.width, abs=0.03)


@pytest.mark.parametrize(("name", "row"), [("example-2-forces", 3), ("example-2-forces", 20), ("example-1-forces", 7)])
def test_the_arms_as_read_give_what_the_drive_must_do(name, row):
    found = of(name)
    (lever,) = levers_of(found, row)
    assert lever.computed == found.column(lever.drive)[row]
    by_arms = [abs(one.force) * lever.unit * (np.conj(one.image) * one.force / abs(one.force)).imag for one in lever.arms]
    assert -sum(by_arms) - lever.couples == pytest.approx(lever.computed, rel=1e-9)
    assert [one.h for one in lever.arms] == pytest.approx(
        [arm / abs(one.force) / lever.unit for arm, one in zip(by_arms, lever.arms, strict=True)], abs=0.26
    )
    assert lever.read == pytest.approx(-sum(abs(one.force) * one.h * lever.unit for one in lever.arms) - lever.couples)
    assert max(abs(one.image) for one in lever.arms) <= 40.0 < 2.5 * max(abs(one.image) for one in lever.arms)
