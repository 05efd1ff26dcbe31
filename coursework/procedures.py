"""The library of procedures for a student's own script: Assur groups, analogs, invariants, tables, a crank of variable length.

Enters: numbers and NumPy arrays of a student.  Leaves: positions, velocities, accelerations, all rows at once.
Used by students, through `from coursework.procedures import …`; the tool itself imports each from its own module.

Kinematics of a linkage, group by group ([library], the lectures): turn a crank, hang a group on it, take the point it meets,
hang the next group on that.  With rate 1 everything is in analogs; `in_seconds` brings them to a crank that turns at omega_1.

>>> import numpy as np
>>> from coursework.procedures import Guide, Pair, crank, in_seconds, rrp, rrr
>>> phi = np.deg2rad([30.0, 90.0, 150.0])
>>> a = crank(Pair([0.0, 0.0]), length=0.1, angle=phi, rate=1.0).meets
>>> c = rrr(a, Pair([0.4, 0.0]), lengths=(0.35, 0.25), mode=1)
>>> slider = rrp(c.meets, Guide(Pair([0.0, 0.4]), 0.0), length=0.3, mode=1)
>>> np.rad2deg(c.coordinates[:, 0]).round(2).tolist()
[34.59, 23.13, 23.2]
>>> in_seconds(slider, omega_1=10.0).rates[:, 1].round(4).tolist()
[0.0963, -1.0627, -1.1885]

Slider-crank with a crank of variable length ([Pasika]): the length that moves the slider at one speed, its table
differentiated by five points, the slider's analogs from it, and the invariants of its way.

>>> from coursework.procedures import constant_speed_crank, derivative, from_analogs, second_derivative, slider_crank
>>> phi = np.deg2rad(np.linspace(76.72, 126.72, 51))
>>> length = constant_speed_crank(phi, speed=0.647723, omega_1=2 * np.pi, crank=0.1, rod=0.4).r / 0.1
>>> found = slider_crank(phi, length, derivative(phi, length), second_derivative(phi, length), l2=4.0)
>>> bool(np.allclose(found.v * 0.1 * 2 * np.pi, 0.647723, atol=1e-6))  # m/s, over the whole table
True
>>> way = from_analogs(found.s - found.s[0], found.v, found.a, stroke=found.s[-1] - found.s[0], angle=phi[-1] - phi[0])
>>> way.a[[0, 25, 50]].round(6).tolist(), way.b[[0, 25, 50]].round(4).tolist()
([0.0, 0.5, 1.0], [1.0, 1.0, 1.0])
"""

from __future__ import annotations

from coursework.equations.five_point import best_spacing, derivative, noise, rounding_error, second_derivative, truncation
from coursework.mechanism.groups import AtDeadPoint, CannotAssemble, GroupMotion, Guide, Pair, crank, prp, rpp, rpr, rrp, rrr
from coursework.results.kinematics.analogs import (
    acceleration_analog,
    in_analogs,
    in_seconds,
    true_acceleration,
    true_velocity,
    velocity_analog,
)
from coursework.results.kinematics.invariants import (
    Invariants,
    Stroke,
    crank_stroke,
    from_analogs,
    from_true,
    to_analogs,
    to_true,
)
from coursework.results.kinematics.variable_crank import (
    CrankLaw,
    SliderAnalogs,
    constant_speed_crank,
    displacement,
    outer_position,
    rod_acceleration,
    rod_angle,
    rod_velocity,
    slider_acceleration,
    slider_crank,
    slider_velocity,
)

__all__ = [
    "AtDeadPoint", "CannotAssemble", "CrankLaw", "GroupMotion", "Guide", "Invariants", "Pair", "SliderAnalogs", "Stroke",
    "acceleration_analog", "best_spacing", "constant_speed_crank", "crank", "crank_stroke", "derivative", "displacement",
    "from_analogs", "from_true", "in_analogs", "in_seconds", "noise", "outer_position", "prp", "rod_acceleration", "rod_angle",
    "rod_velocity", "rounding_error", "rpp", "rpr", "rrp", "rrr", "second_derivative", "slider_acceleration", "slider_crank",
    "slider_velocity", "to_analogs", "to_true", "true_acceleration", "true_velocity", "truncation", "velocity_analog",
]  # fmt: skip
