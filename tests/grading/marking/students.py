"""Tables of variant 31 as students make them, right and wrong, from formulas written out here: nothing of the tool is used."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

H, ROWS = 0.02, 25
START = (1.63, 3.37, 2.87)
DATA = {"r1": 0.953, "r2": 0.847, "r3": 0.457, "V1": 4.5, "p": 13.08, "alpha": 4.35}


def velocities(t, q, *, degrees=False, turned=1.0, **changed):
    """w1, w2, w3, w4 of variant 31; `degrees`: every argument of a sine taken for degrees; `turned`: sign of the drive."""
    d = DATA | changed
    unit = math.pi / 180 if degrees else 1.0

    def sin(x):
        return math.sin(unit * x)

    def cos(x):
        return math.cos(unit * x)

    phi1, phi2, phi3 = q
    drive = turned * d["V1"] * sin(d["p"] * t + d["alpha"])
    w3 = drive / (d["r3"] * (2 * cos(phi3) + sin(phi3)))
    w4 = 2 * w3 * (cos(phi3) - 2 * sin(phi3))
    a, b, c, e = d["r1"] * sin(phi1), d["r2"] * sin(phi2), d["r1"] * cos(phi1), d["r2"] * cos(phi2)
    right = (0.5 * d["r3"] * w4 - d["r3"] * w3 * cos(phi3), d["r3"] * w3 * sin(phi3))
    determinant = a * e - b * c
    return np.array([(right[0] * e - b * right[1]) / determinant, (a * right[1] - right[0] * c) / determinant, w3, w4])


def table(increment=None, printed: Callable = velocities, start=START):
    """The table (25, 7) of a march: `increment(t, q)` of the angles a row, `printed(t, q)` velocities of a row."""
    step = increment or (lambda t, q: H * printed(t, q)[:3])
    q, rows = np.array(start, dtype=float), []
    for k in range(ROWS):
        rows.append(np.concatenate([q, printed(k * H, q)]))
        q = q + step(k * H, q)
    return np.array(rows)


def slopes(t, q):
    return velocities(t, q)[:3]


def heun(t, q):
    first = slopes(t, q)
    return H / 2 * (first + slopes(t + H, q + H * first))


def midpoint(t, q):
    return H * slopes(t + H / 2, q + H / 2 * slopes(t, q))


def rk4(t, q):
    k1 = slopes(t, q)
    k2 = slopes(t + H / 2, q + H / 2 * k1)
    k3 = slopes(t + H / 2, q + H / 2 * k2)
    return H / 6 * (k1 + 2 * k2 + 2 * k3 + slopes(t + H, q + H * k3))


def slip(row, column, factor):
    """Euler's table with one velocity of one row wrong by a factor, and everything after it made from that."""
    q, rows = np.array(START, dtype=float), []
    for k in range(ROWS):
        w = velocities(k * H, q)
        if k == row:
            w[column] *= factor
        rows.append(np.concatenate([q, w]))
        q = q + H * w[:3]
    return np.array(rows)


def late():
    """Velocities of the row before; angles step with the velocity printed in the row after."""
    right = table()
    wrong = right.copy()
    wrong[1:, 3:] = right[:-1, 3:]
    return wrong


def signed(place):
    """One velocity with the wrong sign, everything else made from it."""
    sign = np.ones(4)
    sign[place] = -1

    def printed(t, q):
        w = velocities(t, q)
        if place == 2:
            return -w  # w1, w2, w4 are solved from w3
        return w * sign

    return table(printed=printed)


def row_above():
    """w3 computed with time and angles of the row before; w1, w2 and w4 are solved from it, as they are its multiples."""
    q, rows, above = np.array(START, dtype=float), [], None
    for k in range(ROWS):
        right = velocities(k * H, q)
        w = right if above is None else right * above / right[2]
        above = right[2]
        rows.append(np.concatenate([q, w]))
        q = q + H * w[:3]
    return np.array(rows)


def steps_of_rows_before():
    """Each step made with the velocities of the row before the one that it starts from, the first with its own."""
    q, rows = np.array(START, dtype=float), []
    for k in range(ROWS):
        rows.append(np.concatenate([q, velocities(k * H, q)]))
        q = q + H * rows[max(k - 1, 0)][3:6]
    return np.array(rows)


def one_by_one(t, q):
    """The increments of a program that overwrites its coordinates: each is moved with those before it already moved."""
    moved = q.copy()
    for place in range(len(q)):
        moved[place] += H * slopes(t, moved)[place]
    return moved - q


MISCONCEPTIONS = {
    "heun": lambda: table(heun),
    "midpoint": lambda: table(midpoint),
    "rk4": lambda: table(rk4),
    "time_ahead": lambda: table(printed=lambda t, q: velocities(t + H, q)),
    "time_behind": lambda: table(printed=lambda t, q: velocities(t - H, q)),
    "step_ahead": lambda: table(lambda t, q: H * slopes(t + H, q)),
    "step_behind": lambda: table(lambda t, q: H * slopes(t - H, q)),
    "row_before": steps_of_rows_before,
    "in_place": lambda: table(one_by_one),
    "omega_late": late,
    "other_step": lambda: table(lambda t, q: 2 * H * slopes(t, q)),
    "degree_mode": lambda: table(printed=lambda t, q: velocities(t, q, degrees=True)),
    "sign_drive": lambda: table(printed=lambda t, q: velocities(t, q, turned=-1.0)),
    "sign_w1": lambda: signed(0),
    "row_above_w3": row_above,
    "datum_r2": lambda: table(printed=lambda t, q: velocities(t, q, r2=2 * DATA["r2"])),
    "datum_V1": lambda: table(printed=lambda t, q: velocities(t, q, V1=10 * DATA["V1"])),
    "swap_r1_r2": lambda: table(printed=lambda t, q: velocities(t, q, r1=DATA["r2"], r2=DATA["r1"])),
    "swapped_columns": lambda: table()[:, [1, 0, 2, 3, 4, 5, 6]],
}
