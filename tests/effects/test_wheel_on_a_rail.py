"""A wheel pulled along a rail, its centre of mass beside its middle: what drives a length is a force."""

import numpy as np

import coursework
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from tests.mechanisms.library import mechanism

WHEEL = mechanism("wheel-on-a-rail")


def test_a_driven_length_that_no_link_has_is_driven_by_a_force_in_newtons():
    run = coursework.solve(coursework.parse_variant(WHEEL), scheme="exact")
    found: ForceAnalysis = run.results.forces
    t, psi = found.rows.motion.t, found.rows.motion.column("psi")
    change, w = 1.2 * 9 * np.cos(9 * t), -1.2 * np.sin(9 * t) / 0.25
    epsilon, beside = -change / 0.25, 0.05 * np.exp(1j * (psi + 0.3))  # the centre of mass, from the middle
    total = 10 * (change + (1j * epsilon - w**2) * beside + 9.81j)  # drive, T along the rail, N across it
    # About the centre of mass: what the drive at the middle and T, N at the contact do.
    across, below = total.imag, -beside - 0.25j
    along = (0.4 * epsilon - below.real * across - beside.imag * total.real) / (-below.imag - beside.imag)
    largest = np.abs(total).max()
    assert found.drive_names == ("F",) and found.units[found.names.index("F")] == "N"
    for name, value in (("T01", along), ("N01", across), ("F", total.real - along)):
        assert np.abs(found.column(name) - value).max() < 1e-11 * largest, name
