"""Many sets together against the same Euler loop written by hand over arrays, and against one set alone."""

import numpy as np

import coursework
from coursework.equations.reduction.structure import structures
from tests.benchmarks.timer import ratio, spent

SETS = 1000
# A batch follows each motion a second time, more exactly than the scheme does, and watches what the loop by hand does not.
MOST, LEAST_GAIN = 10, 200


def sets(count=SETS):
    """Return data of variant 31 that differ by up to 3 %; all of them can move."""
    random = np.random.default_rng(5)
    given = coursework.load("31").values
    return {key: value * (1 + 0.03 * random.uniform(-1, 1, count)) for key, value in given.items()}


def by_hand(data):
    """Return the Euler rows (25, 3, n) as a careful student writes them with NumPy."""
    r1, r2, r3, v1, p, alpha = (data[name] for name in ("r1", "r2", "r3", "V1", "p", "alpha"))
    q = np.tile(np.array([[1.63], [3.37], [2.87]]), (1, len(r1)))
    h, rows = 0.02, []
    for i in range(25):
        rows.append(q)
        v = v1 * np.sin(p * (i * h) + alpha)
        s1, s2, s3 = np.sin(q)
        c1, c2, c3 = np.cos(q)
        w3 = v / (r3 * (2 * c3 + s3))
        w4 = 2 * w3 * (c3 - 2 * s3)
        a, b, c, d = r1 * s1, r2 * s2, -r1 * c1, -r2 * c2
        e, f = 0.5 * r3 * w4 - r3 * w3 * c3, -r3 * w3 * s3
        det = a * d - b * c
        q = q + h * np.array([(e * d - b * f) / det, (a * f - e * c) / det, w3])
    return np.array(rows)


def test_both_loops_give_the_same_rows():
    data = sets(20)
    solved = coursework.solve_many("31", data)
    assert all(stop is None for stop in solved.stops)
    assert np.max(np.abs(solved.values[:, :, :3] - by_hand(data).transpose(2, 0, 1))) < 1e-12


def cost(most=MOST):
    """Return the ratio of a batch, its model compiled before, to the loop by hand."""
    model, data = coursework.compile_model("31"), sets()
    return ratio(lambda: coursework.solve_many(model, data), lambda: by_hand(data), most=most)


def gain():
    """Return how many times more a set costs alone than among others."""
    model, data = coursework.compile_model("31"), sets()
    alone = spent(lambda: coursework.solve("31", quantities=["table"]).motion, 3)
    return alone * SETS / spent(lambda: coursework.solve_many(model, data), 5)


def test_a_batch_costs_a_few_loops_by_hand():
    assert cost() <= MOST


def test_a_set_among_others_is_much_cheaper_than_alone():
    assert gain() >= LEAST_GAIN


if __name__ == "__main__":
    model, data = coursework.compile_model("31"), sets()

    def compiled():
        structures.cache_clear()
        return coursework.compile_model("31").program

    print(f"compile {spent(compiled, 5) * 1e3:.1f} ms")
    print(f"{spent(lambda: coursework.solve_many(model, data), 20) / SETS * 1e6:.1f} µs a set, {cost(0):.1f} loops by hand")
    print(f"{gain():.0f} times cheaper than alone")
