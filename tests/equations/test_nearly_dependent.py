"""Equations that differ by too little for doubles neither say the same nor contradict each other; nor is what they say known."""

import re

import mpmath as mp
import pytest

from coursework.words.errors import InputError
from tests.hard.scenes import check, scene, solve


def hilbert(size):
    names = [f"u{i}" for i in range(size)]
    terms = [" + ".join(f"{1 / (i + j + 1)!r}*{name}" for j, name in enumerate(names)) for i in range(size)]
    starts = "\n".join(f'x{i} = {{ start = "0 rad", rate = "u{i}" }}' for i in range(size))
    return scene(starts, given='one = "1 rad/s"', equations=[f"{text} = one" for text in terms])


def two(part):
    starts = "\n".join(f'x{i} = {{ start = "0 rad", rate = "u{i}" }}' for i in (1, 2))
    return scene(starts, given='one = "1 rad/s"', equations=["u1 + u2 = one", f"u1 + {1 + part!r}*u2 = one"])


def test_twelve_equations_of_hilbert_do_not_say_the_same():
    with pytest.raises(InputError, match="except for a part of") as caught:
        _ = solve(hilbert(12)).motion
    assert "say the same" not in str(caught.value)
    assert "says the same" not in str(caught.value)
    assert "independent equations" not in str(caught.value)
    told = float(re.search(r"condition number is above ([\d.e+]+),", str(caught.value))[1])
    mp.mp.dps = 40
    known = mp.matrix(12, 12)
    for i in range(12):
        row = [mp.mpf(1 / (i + j + 1)) for j in range(12)]
        known[i, :] = mp.matrix([row]) / mp.norm(row)
    sizes = mp.svd_r(known, compute_uv=False)
    assert told == 1e15 and 5e15 < sizes[0] / sizes[11] < 1e16  # the power of ten below it


def test_just_inside_and_just_outside():
    """Two equations that differ by 1e-9 leave six digits; by less the velocities are computed, and told to mean little."""
    for part, verdict in ((1e-9, "PASS"), (4e-10, "FAIL"), (1e-12, "FAIL")):
        run = solve(two(part), quantities=("table", "checks"))
        assert run.motion.velocities[0] == pytest.approx([1.0, 0.0], abs=1e-3)
        assert check(run, "CONDITION").verdict == verdict
    # Of a way as long as the scale 10^-1.4 is not known, less than 5 %; or 10^-1.1, which is more.
    for part, verdict in ((1e-14, "PASS"), (5e-15, "SKIP")):
        found = check(solve(two(part), quantities=("table", "checks")), "ACCURACY")
        assert (found.verdict, "too few for motions" in found.sentence) == (verdict, verdict == "SKIP")
    with pytest.raises(InputError, match="says the same as 1"):
        _ = solve(two(0.0)).motion
