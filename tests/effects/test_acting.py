"""What acts on a body, as expressions: the torque of a motor beside the drives, and its reaction."""

from types import SimpleNamespace

import pytest

from coursework.effects import acting
from coursework.effects.acting import ActingWriter
from coursework.equations.algebra.expression import ZERO


@pytest.mark.parametrize(("body", "torques"), [("2", [7]), ("1", [-7]), ("3", [])])
def test_a_torque_beside_the_drives_acts_on_its_body_and_turned_round_on_what_that_stands_on(monkeypatch, body, torques):
    monkeypatch.setattr(acting, "torques_beside_drives", lambda _: [("2", "1", SimpleNamespace(torque=7))])
    scheme = SimpleNamespace(forces=SimpleNamespace(loads=()))
    own = SimpleNamespace(scheme=scheme, vector=lambda name: name, scalar=lambda value: value)
    loads = [*ActingWriter.loads(own, SimpleNamespace(name=body, centre="S"))]
    assert loads == [("S", (ZERO, ZERO), torque) for torque in torques]
