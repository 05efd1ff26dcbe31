"""What the moving part knows as drawn: the arm from a pin ends on the line of the slot that it is rigid with."""

from types import SimpleNamespace

import numpy as np

from coursework.drawing.outline.poses import read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.report.live import spots
from coursework.report.live.spots import Scenery, _moving_lines
from coursework.variant.catalogue import names
from tests.solved import solved

SCALE = 300.0


def test_an_arm_stands_upright_on_its_slot_as_long_as_the_file_says():
    looked = 0
    for name in names():
        scene = solved(name, quantities=["table"]).scene
        outline = read_outline(scene.mechanism)
        if outline is None or not outline.slots:
            continue
        motion = scene.motion
        poses = read_poses(outline, scene.equations)(np.asarray(motion.t), np.asarray(motion.coordinates))
        rows = np.arange(len(motion.t))
        at = {point: np.asarray(SCALE * places[rows].conjugate()) for point, places in poses.at.items()}
        lines = [*_moving_lines(outline, poses, rows, SCALE, at)]
        first = sum(len(bar.corners) - 1 for bar in outline.bars)
        for place, slot in enumerate(outline.slots):
            (begin, end), (pin, foot) = lines[first + 2 * place : first + 2 * place + 2]
            beside = SCALE * poses.line(slot)[0]
            assert np.allclose(abs(foot - pin), abs(beside), atol=1e-9), name
            along = (end - begin) / abs(end - begin)
            assert np.allclose(((foot - begin) / along).imag, 0.0, atol=1e-9), name
            assert np.allclose(((foot - pin) / along).real, 0.0, atol=1e-9), name
            looked += abs(beside) > 1.0
    assert looked > 0


def test_a_word_without_room_leaves_those_behind_it_their_spots(monkeypatch):
    """A short side bears no number; the next link takes its best spot, and the one after it, there too, its second."""
    none = np.zeros((1, 0, 2))
    monkeypatch.setattr(spots, "scenery_of", lambda *_: Scenery({}, none, none, np.zeros((1, 0)), np.zeros((1, 0, 4))))
    one = np.array([[50 + 50j, 90 + 50j]])
    choices = {
        "1": spots._Choice(5.0, [], np.zeros(0), np.zeros((1, 0), complex)),
        "2": spots._Choice(5.0, [[1], [2]], np.array([0.0, 1.0]), one),
        "3": spots._Choice(5.0, [[3], [4]], np.array([0.0, 1.0]), one + 2),
        "4": spots._Choice(5.0, [[5], [6]], np.array([0.0, 1.0]), one + 300),
    }
    monkeypatch.setattr(spots, "_of_link", lambda outline, bar, seen, weight: choices[bar])
    outline, poses = SimpleNamespace(shown=(), bars=tuple(choices)), SimpleNamespace(t=np.zeros(1))
    assert spots._spots(outline, poses, 1.0, ()) == [[], [1], [4], [5]]
