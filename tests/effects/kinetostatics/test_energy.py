"""Energies, powers and the reduced inertia of motions by hand."""

from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.effects.kinetostatics import energy
from coursework.effects.kinetostatics.energy import energy_of, reduced_inertia, velocity_of_drive
from coursework.effects.rows import Rows
from coursework.variant.formula.tree import named

PHI = np.array([0.3, 1.1, -2.0, 2.5])
W, EPS = np.array([2.0, -0.7, 0.5, 3.0]), np.array([0.4, 5.0, -1.0, 0.0])


def motions(**places):
    """Return what gives place, rate and second derivative of points that are known as functions of phi with two derivatives."""
    return lambda name, level=0: [
        lambda f, d, dd: f, lambda f, d, dd: d * W, lambda f, d, dd: d * EPS + dd * W**2,
    ][level](*places[getattr(name, "name", name)])  # fmt: skip


def test_the_reduced_inertia_of_a_crank_a_slide_and_a_gear_is_that_by_hand():
    """2 kg on a crank of 0.3 m with 0.1 kg m^2, 3 kg at x = cos(phi), a gear of 0.05 kg m^2 that turns by phi^2.

    J = 0.28 + 3 sin^2 phi + 0.05 (2 phi)^2, and dJ = 3 sin 2 phi + 0.4 phi.
    """
    turn = np.exp(1j * PHI)
    crank, slide, gear = (SimpleNamespace(centre=name, mass=mass) for name, mass in (("S", 2), ("B", 3), ("", None)))
    turned, inertias = {id(crank): (1.0, 0.0), id(gear): (2 * PHI, 2.0)}, {id(crank): 0.1, id(gear): 0.05}
    rows = SimpleNamespace(
        count=4, scheme=SimpleNamespace(bodies=[crank, slide, gear]), mass=lambda body: np.full(4, body.mass),
        inertia=lambda body: np.full(4, inertias.get(id(body), 0.0)), omega=lambda body: turned.get(id(body), (0, 0))[0] * W,
        epsilon=lambda body: (lambda d, dd: d * EPS + dd * W**2)(*turned.get(id(body), (0.0, 0.0))),
        vector=motions(S=(0.3 * turn, 0.3j * turn, -0.3 * turn), B=(np.cos(PHI) + 2j, -np.sin(PHI), -np.cos(PHI))),
    )  # fmt: skip
    total, slope = reduced_inertia(rows, W, EPS)
    assert total == pytest.approx(0.28 + 3 * np.sin(PHI) ** 2 + 0.2 * PHI**2)
    assert slope == pytest.approx(3 * np.sin(2 * PHI) + 0.4 * PHI)
    total, slope = reduced_inertia(rows, np.where(PHI > 0, W, 0.0), EPS)
    assert np.isfinite(total).tolist() == np.isfinite(slope).tolist() == [True, True, False, True]


def still(**more):
    """Return two rows: a body of 2 kg and 0.5 kg m^2 at (1, 2) and (3, -1) m, with (1, 4) and (-3, 0) m/s, that turns."""
    body = SimpleNamespace(centre="S", mass=2.0)
    places = {
        "S": ([1 + 2j, 3 - 1j], [1 + 4j, -3 + 0j]), "B": ([3 + 4j, 6 + 8j], [1j, 2 + 1j]),
        "C": ([1 + 2j, 2 - 1j], [1 + 0j, -1j]), "D": ([4 + 6j, 8 + 7j], [1 + 1j, 2 + 0j]),
    }  # fmt: skip
    spring = SimpleNamespace(ends=("C", "D"), stiffness=100.0, free=4.0, damping=5.0)
    forces = SimpleNamespace(gravity=(3.0, -10.0), springs=[spring])
    rows = SimpleNamespace(
        count=2, scheme=SimpleNamespace(bodies=[body], by_name={"1": body}, forces=forces),
        scalar=lambda value: 0.0 if value is None else value, mass=lambda _: 2.0, inertia=lambda _: 0.5,
        omega=lambda _: np.array([2.0, -1.0]), vector=lambda name, level=0: np.array(places[getattr(name, "name", name)][level]),
        velocity=lambda _, at: np.array([1 + 1j, 2j]), along=lambda _: np.array([1.0, 1j]),
        motion=SimpleNamespace(column=lambda name: np.array([7.0, 8.0])),
    )  # fmt: skip
    vars(rows).update(stretch=partial(Rows.stretch, rows), **more)
    return rows


class Drive(SimpleNamespace):
    __hash__ = object.__hash__


def drive(kind="force", **more):
    direction = SimpleNamespace(kind=kind, coordinate=more.pop("coordinate", ""))
    return Drive(**{"direction": direction, "on": "1", "off": "0", "at": named("B"), "is_drive": "w", **more})


def test_energies_and_powers_are_those_by_hand(monkeypatch):
    """m v^2/2 + J w^2/2; -m g.r + c (L - L0)^2/2 with L = 5 and 10 m; a damper takes b (dL/dt)^2; a force f.v, a couple M w."""
    acts = [
        SimpleNamespace(body="1", couple=None, force=np.array([3 - 2j, 5j]), at="B"),
        SimpleNamespace(body="1", couple=np.array([10.0, 20.0]), force=None, at=None),
    ]
    monkeypatch.setattr(energy, "LOADS", SimpleNamespace(acts=lambda _: acts[:1]))
    monkeypatch.setattr(energy, "MOTOR", SimpleNamespace(acts=lambda _: acts[1:]))
    rows = still()
    found = energy_of(rows, {drive(): np.array([2.0, 3.0]), drive("couple"): np.array([1.0, 1.0])}, (*acts, acts[1]))
    assert found.kinetic == pytest.approx([17 + 1.0, 9 + 0.25])
    assert found.potential == pytest.approx([-2 * (3 - 20) + 50, -2 * (9 + 10) + 50 * 36])
    assert found.dampers == pytest.approx([-5 * 0.8**2, -5 * (0.6 * 2 + 0.8) ** 2])
    assert found.loads == pytest.approx([1.0, 10.0])
    assert found.drive == pytest.approx([2 * 0.0 + 2 + 20, 3 * 1.0 - 1 - 20])
    assert found.friction == pytest.approx([1.0 + 40, 10.0 - 40])
    weightless = still(scalar=lambda value: 0.0)
    weightless.scheme.forces.gravity, weightless.scheme.forces.springs = None, []
    assert energy_of(weightless, {}).potential.tolist() == [0.0, 0.0]


def test_a_drive_on_a_moving_body_moves_relative_to_it():
    """B is at (2, 2) and (3, 9) m from S, which goes along and turns by 2 and -1 rad/s; a couple has both bodies' rates."""
    rows = still()
    rows.velocity = partial(Rows.velocity, rows)
    assert velocity_of_drive(rows, drive(off="1")) == pytest.approx([0 - 1 + 4, 1 - 0 + 3])
    assert velocity_of_drive(rows, drive(coordinate="s")).tolist() == [7.0, 8.0]
    assert velocity_of_drive(rows, drive("couple", off="1")).tolist() == [0.0, 0.0]
    assert velocity_of_drive(rows, drive("couple")).tolist() == [2.0, -1.0]
