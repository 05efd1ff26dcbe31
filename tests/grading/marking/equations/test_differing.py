"""Which term of a wrong line of a four-bar is one too many, has another factor, or is missing, told from the numbers alone."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.equations.differing import difference_of
from coursework.grading.marking.equations.linear import linear
from coursework.grading.marking.equations.probe import POINTS, Probe
from coursework.variant.formula import reader
from coursework.variant.formula.tree import Formula, spelled

ALONG = "l1*sin(phi1)*w1 + l2*sin(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u"
ACROSS = "l1*cos(phi1)*w1 + l2*cos(phi2)*w2 = l3*cos(phi3)*w3"
VARIANT = SimpleNamespace(
    coordinates=[SimpleNamespace(name=name, unit="m" if name == "s" else "rad") for name in ("phi1", "phi2", "phi3", "s")],
    drive=[SimpleNamespace(name="w1")], known_rates=("w1", "u"),
)  # fmt: skip


def tree_of(text):
    return Formula("-", reader.parse_equation(text))


def probe_of(count=POINTS):
    """Return points at which both lines hold: their velocities solved here."""
    draw = np.random.Generator(np.random.PCG64(5))
    l1, l2, l3 = 0.3, 0.7, 0.5
    phi1, phi2, phi3 = draw.uniform(-3, 3, (3, count))
    w1, u, s = draw.uniform(1, 2, (3, count))
    matrix = np.stack([[l2 * np.sin(phi2), -l3 * np.sin(phi3)], [l2 * np.cos(phi2), -l3 * np.cos(phi3)]]).transpose(2, 0, 1)
    right = np.stack([np.cos(phi1) * u - l1 * np.sin(phi1) * w1, -l1 * np.cos(phi1) * w1], axis=1)
    w2, w3 = np.linalg.solve(matrix, right[..., None])[..., 0].T
    names = {"l1": l1, "l2": l2, "l3": l3, "phi1": phi1, "phi2": phi2, "phi3": phi3, "s": s, "w1": w1, "u": u, "w2": w2, "w3": w3}
    return Probe(names | {"A": phi1 + 1j * phi2, "none": np.full(count, np.nan)}, ("w2", "w3"), np.stack([w2, w3], axis=1))


def told(text, probe=None, others=(ACROSS,)):
    probe = probe or probe_of()
    found = difference_of(tree_of(text), VARIANT, probe, [linear(tree_of(other), probe) for other in others])
    return None if found is None else f"{found.kind} {spelled(found.term)} {found.column}"


@pytest.mark.parametrize(("text", "difference"), [
    # one too many: the whole of a term, in a sum in parentheses too, on both sides of the sign
    (f"{ALONG} + l1*cos(phi1)*w1", "extra l1*cos(phi1)*w1 69"), (f"l3*w3 + {ALONG}", "extra l3*w3 1"),
    ("l1*sin(phi1)*w1 + l2*(sin(phi2) + sin(phi3))*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "extra sin(phi3) 35"),
    (f"{ALONG} + 2", "extra 2 69"), (f"{ALONG} - (l1*w1 + l2*w2)", None),
    # another factor, and which part of a sum has it
    ("l1*sin(phi1)*w1 + 3*l2*sin(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "factor 3*l2*sin(phi2)*w2 19"),
    ("l1*sin(phi1)*w1 - l2*sin(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "factor l2*sin(phi2)*w2 19"),
    ("l1*sin(phi1)*w1 + l2*sin(phi2)*w2 = l3*sin(phi3)*w3/7 + cos(phi1)*u", "factor l3*sin(phi3)*w3/7 37"),
    # a factor so large that what is left is the term itself but for a part in 3e7, or in 3e8
    ("l1*sin(phi1)*w1 + 30000000*l2*sin(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "factor 30000000*l2*sin(phi2)*w2 19"),
    ("l1*sin(phi1)*w1 + 300000000*l2*sin(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "extra 300000000*l2*sin(phi2)*w2 19"),
    # missing: a velocity that the line names nowhere before one that it names
    ("l1*sin(phi1)*w1 + l2*sin(phi2)*w2 = cos(phi1)*u", "missing w3 0"),
    ("l2*sin(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "missing w1 0"),
    ("l1*sin(phi1)*w1 + l2*sin(phi2)*w2 = l3*sin(phi3)*w3", "missing u 0"),
    # a term in the place of another of the same velocity: as many as a sine and a cosine
    ("l1*sin(phi1)*w1 + l2*cos(phi2)*w2 = l3*sin(phi3)*w3 + cos(phi1)*u", "other w2 32"),
    # right, more than one fault, nothing that could be judged
    (ALONG, None), (ACROSS, None), ("l1*sin(phi1)*w1 = l3*w3", None), ("w2*w3 = 1", None), ("A = 0", None),
    (f"{ALONG} + none", None),
    (f"{ALONG} + A", None),
])  # fmt: skip
def test_the_term_that_differs(text, difference):
    assert told(text) == difference


def test_a_change_that_makes_a_line_another_right_one_explains_nothing():
    """Without its last term the line is ACROSS, which stands there already."""
    line = f"{ACROSS} + s*u^2"
    assert (told(line, others=()), told(line)) == ("extra s*u^2 55", None)


def test_fewer_points_than_a_probe_has_tell_nothing():
    line = f"{ALONG} + l1*cos(phi1)*w1"
    assert told(line, probe_of(POINTS - 1)) is None
