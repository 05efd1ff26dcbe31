"""Mechanisms at random: in the first row every joint stands where the file says, and moves as the links allow."""

from __future__ import annotations

import random

import numpy as np
import pytest

import coursework
from coursework.takeaway.foreign import linkage, pmks, pylinkage
from coursework.takeaway.foreign.text import text_of
from tests.takeaway.foreign.files import MECHANISM, SLOTTED, changed


def solved(scheme):
    return coursework.solve(coursework.parse_variant(text_of(scheme, "own", str)), quantities=["table"])


def first_row(run, what):
    """The places or velocities of all points in the first row, by name, as complex numbers."""
    return {name: complex(*getattr(run.points[name], what).to_numpy()[0]) for name in {*run.points.columns.get_level_values(0)}}


@pytest.mark.parametrize("end", ["rocker", "slider", "six links"])
@pytest.mark.parametrize("seed", range(3))
def test_joints_of_pmks_stand_where_the_file_says_and_links_are_rigid(seed, end):
    chance = random.Random(seed)
    crank, pivot, pin, tracer, other, far = (complex(chance.uniform(-4, 4), chance.uniform(-4, 4)) for _ in range(6))
    slide = chance.uniform(0, 180)
    joints = [("ground,input,R", 0j), ("input,coupler,R", crank)]
    if end == "slider":
        joints += [("coupler,ground,RP", pin), ("coupler,R", tracer)]
    else:
        joints += [("coupler,follower,R", pin), ("follower,ground,R", pivot), ("coupler,R", tracer)]
    links = [(0, 1), (1, 2), (1, len(joints) - 1), (2, len(joints) - 1), *([(2, 3)] if end != "slider" else [])]
    if end == "six links":
        joints[-1] = "coupler,fifth,R", tracer
        joints += [("fifth,sixth,R", other), ("sixth,ground,R", far)]
        links += [(4, 5), (5, 6)]
    more = {2: f",{slide}"} if end == "slider" else {}
    text = "\n".join(f"{kind},{at.real},{at.imag}{more.get(k, '')}" for k, (kind, at) in enumerate(joints))
    run = solved(pmks.read(text.encode()))
    places, moves = first_row(run, "position"), first_row(run, "velocity")
    for letter, (_, at) in zip("ABCDEFG", joints, strict=False):
        assert places[letter] == pytest.approx(at, abs=1e-7), letter
    for a, b in (("ABCDEFG"[a], "ABCDEFG"[b]) for a, b in links):
        apart = places[b] - places[a]
        assert ((moves[b] - moves[a]) * apart.conjugate()).real == pytest.approx(0.0, abs=1e-8 * (1 + abs(moves[b])))
    assert moves["B"] == pytest.approx(1j * crank)
    if end == "slider":
        assert (moves["C"] * np.exp(-1j * np.radians(slide))).imag == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize(("x", "y"), [("192", "192"), ("-192", "192"), ("192", "-1000"), ("-100", "-900")])
def test_a_lever_of_linkage_has_its_end_where_the_file_says(x, y):
    places = first_row(
        solved(linkage.read(SLOTTED.replace(b'id="4" x="192" y="192"', f'id="4" x="{x}" y="{y}"'.encode()))), "position"
    )
    for at in (0j, 96 + 0j, -192j, complex(float(x), float(y)), 960 + 0j, 960 + 96j):
        assert min(abs(place - at / 96 * 0.0254) for place in places.values()) < 1e-12


def test_a_crank_that_rests_drives_no_other():
    links = [
        {"id": "G", "type": "ground", "joints": ["A", "D"]},
        {"id": "crank", "type": "driver", "joints": ["A", "B"], "angular_velocity": 0.0, "motor_joint": "A"},
        {"id": "rod", "type": "link", "joints": ["B", "C"]},
        {"id": "rocker", "type": "driver", "joints": ["D", "C"], "angular_velocity": 0.2, "motor_joint": "D"},
    ]
    assert pylinkage.read(changed(MECHANISM, links=links)).turned == ()
