"""The six examples, the homework and an example of PRP against reference numbers of sixty digits.

The files in `tests/reference` hold their own provenance: closure in closed form with exact derivatives.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from coursework.mechanism.groups import GroupMotion, Guide, Pair, crank, prp, rpp, rpr, rrp, rrr

Array = NDArray[np.float64]
Levels = tuple[Array, Array, Array]
Solved = dict[str, Levels]
REFERENCE = Path(__file__).parents[2] / "reference"
A = Pair((0.0, 0.0))
TOLERANCE = 1e-12  # of the largest value in a column; the files hold 15 digits


def levels(motion: GroupMotion, place: int) -> Levels:
    assert motion.rates is not None
    assert motion.accelerations is not None
    return motion.coordinates[:, place], motion.rates[:, place], motion.accelerations[:, place]


def components(name: str, pair: Pair) -> Solved:
    assert pair.velocity is not None
    assert pair.acceleration is not None
    known = (pair.position, pair.velocity, pair.acceleration)
    return {f"{name}.{axis}": (known[0][:, i], known[1][:, i], known[2][:, i]) for i, axis in enumerate("xy")}


def driving(phi: Array, length: float) -> Pair:
    return crank(A, length=length, angle=phi, rate=10.0).meets


def fourbar(phi: Array) -> Solved:
    b = driving(phi, 0.4)
    dyad = rrr(b, Pair((1.2, 0.0)), lengths=(1.0, 0.7), mode=1)
    return {
        "theta2": levels(dyad, 0),
        "theta3": levels(dyad, 1),
        **components("B", b),
        **components("C", dyad.meets),
    }


def slider_crank(phi: Array) -> Solved:
    b = driving(phi, 0.4)
    dyad = rrp(b, Guide(A, 0.0), length=1.2, mode=1)
    return {
        "theta2": levels(dyad, 0),
        "s3": levels(dyad, 1),
        **components("B", b),
        **components("C", dyad.meets),
    }


def two_rrr(phi: Array) -> Solved:
    b = driving(phi, 26.5)
    first = rrr(b, Pair((87.5, 0.0)), lengths=(105.6, 67.5), mode=1)
    second = rrr(first.meets, Pair((150.0, 70.0)), lengths=(65.0, 48.0), mode=-1)
    return {
        "theta2": levels(first, 0),
        "theta3": levels(first, 1),
        "theta5": levels(second, 0),
        "theta6": levels(second, 1),
        **components("B", b),
        **components("C", first.meets),
        **components("E", second.meets),
    }


def homework(phi: Array) -> Solved:
    d = Pair((1.2, 0.0))
    b = driving(phi, 0.4)
    first = rrr(b, d, lengths=(1.0, 0.7), mode=1)
    second = rrp(first.meets, Guide(d, 0.0), length=1.2, mode=1)
    return {
        "theta2": levels(first, 0),
        "theta3": levels(first, 1),
        "theta5": levels(second, 0),
        "s6": levels(second, 1),
        **components("B", b),
        **components("C", first.meets),
        **components("E", second.meets),
    }


def inverted_slider(phi: Array) -> Solved:
    b = driving(phi, 0.4)
    dyad = rpr(b, Pair((0.0, -1.0)), end_length=1.6)
    return {
        "theta3": levels(dyad, 0),
        "s2": levels(dyad, 1),
        **components("B", b),
        **components("E", dyad.meets),
    }


def two_blocks(phi: Array) -> Solved:
    b = driving(phi, 0.4)
    dyad = rpp(b, Guide(Pair((0.0, 0.8)), 0.0), slide_angle=-np.pi / 2)
    return {
        "s2": levels(dyad, 0),
        "s3": levels(dyad, 1),
        **components("B", b),
        **components("D", dyad.meets),
    }


def shaper(phi: Array) -> Solved:
    b = driving(phi, 0.4)
    first = rpr(b, Pair((0.0, -1.0)), end_length=1.6)
    second = rpp(first.meets, Guide(Pair((0.0, 0.8)), 0.0), slide_angle=-np.pi / 2)
    return {
        "theta3": levels(first, 0),
        "s2": levels(first, 1),
        "s4": levels(second, 0),
        "s5": levels(second, 1),
        **components("B", b),
        **components("E", first.meets),
        **components("D5", second.meets),
    }


def crossed_guides(phi: Array) -> Solved:
    swing = (
        np.pi / 3 + 0.6 * np.sin(phi),
        6.0 * np.cos(phi),
        -60.0 * np.sin(phi),
    )  # psi, its rate and acceleration at 10 rad/s
    k_i = crank(A, length=0.3, angle=swing[0], rate=swing[1], acceleration=swing[2]).meets
    dyad = prp(
        Guide(k_i, swing[0] - 0.9, swing[1], swing[2], offset=0.15),
        Guide(Pair((1.1, -0.2)), 1.9207963267949, offset=0.1),
    )
    return {
        "psi": swing,
        "theta_i": (swing[0] - 0.9, swing[1], swing[2]),
        "si": levels(dyad, 0),
        "sj": levels(dyad, 1),
        **components("Ki", k_i),
        **components("C", dyad.meets),
    }


EXAMPLES: dict[str, Callable[[Array], Solved]] = {
    "example1_fourbar": fourbar,
    "example2_slidercrank": slider_crank,
    "example3_rrr_rrr": two_rrr,
    "homework_rrr_rrp": homework,
    "example4_rpr": inverted_slider,
    "example5_rpp": two_blocks,
    "example6_rpr_rpp": shaper,
    "example_prp": crossed_guides,
}


def columns(rows: list[dict[str, Any]]) -> Solved:
    """Return every column of a reference file, in the order pos, vel, acc."""
    found: Solved = {}
    for name, known in rows[0]["q"].items():
        pos, vel, acc = (np.array([row["q"][name][kind] for row in rows]) for kind in known)
        found[name] = (pos, vel, acc)
    for name in rows[0]["points"]:
        for axis in "xy":
            kinds = (axis, f"v{axis}", f"a{axis}")
            pos, vel, acc = (np.array([row["points"][name][kind] for row in rows]) for kind in kinds)
            found[f"{name}.{axis}"] = (pos, vel, acc)
    return found


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_row_of_the_reference(name: str) -> None:
    data = json.loads((REFERENCE / f"{name}.json").read_text())
    expected = columns(data["rows"])
    phi = np.deg2rad([row["crank_deg"] for row in data["rows"]])
    solved = EXAMPLES[name](phi)
    assert set(solved) == set(expected)
    for column, wanted in expected.items():
        angle = column.startswith(("theta", "psi"))
        for level in range(3):
            difference = solved[column][level] - wanted[level]
            if angle and level == 0:  # the reference is in (-pi, pi], and pi may come out as -pi
                difference = np.angle(np.exp(1j * difference))
            limit = TOLERANCE * np.abs(wanted[level]).max()
            assert np.abs(difference).max() <= limit, f"{column}, derivative {level}"


def test_example_6_printed_s4_belongs_to_a_guide_one_metre_above() -> None:
    # The deck prints s4 = 0.4 at crank 90 deg for a guide 0.8 above A; E is then 0.6 above A, which leaves 0.2.
    e = rpr(driving(np.array([np.pi / 2]), 0.4), Pair((0.0, -1.0)), end_length=1.6).meets
    printed = {height: rpp(e, Guide(Pair((0.0, height)), 0.0), slide_angle=-np.pi / 2) for height in (0.8, 1.0)}
    assert printed[0.8].coordinates[0, 0] == pytest.approx(0.2, abs=1e-15)
    assert printed[1.0].coordinates[0, 0] == pytest.approx(0.4, abs=1e-15)
    for height in printed:
        assert levels(printed[height], 0)[1][0] == pytest.approx(0.0, abs=1e-14)
        assert levels(printed[height], 1)[1][0] == pytest.approx(-32 / 7, abs=1e-14)
