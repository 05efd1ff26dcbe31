"""The march and the reduction against yardsticks measured in the same process: ratios, never seconds."""

import ctypes
import math
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

import coursework
from coursework.equations.algebra.expression import add
from coursework.equations.algebra.symbolic_objects import symbolic
from coursework.equations.reduction.blocks import reduce
from coursework.equations.reduction.symbolic import local
from coursework.motion.integration.exact_motion import exact_motion
from coursework.motion.integration.integrate import March
from coursework.motion.integration.loops import generate_loop
from coursework.motion.schemes import SCHEMES
from tests.benchmarks.timer import ratio

STEPS = 20_000
START = (1.63, 3.37, 2.87)
C_SOURCE = """
#include <math.h>
void euler(long n, double h, double *q) {
    double p1 = q[0], p2 = q[1], p3 = q[2];
    for (long i = 0; i < n; i++) {
        double t = i*h, v = 4.5*sin(13.08*t + 4.35);
        double s3 = sin(p3), c3 = cos(p3), s1 = sin(p1), c1 = cos(p1), s2 = sin(p2), c2 = cos(p2);
        double w3 = v/(0.457*(2*c3 + s3)), w4 = 2*w3*(c3 - 2*s3);
        double a = 0.953*s1, b = 0.847*s2, c = -0.953*c1, d = -0.847*c2;
        double e = 0.5*0.457*w4 - 0.457*w3*c3, f = -0.457*w3*s3, det = a*d - b*c;
        p1 += h*(e*d - b*f)/det; p2 += h*(a*f - e*c)/det; p3 += h*w3;
    }
    q[0] = p1; q[1] = p2; q[2] = p3;
}
"""


def slopes(t, phi1, phi2, phi3):
    """The right-hand side as a careful student writes it."""
    v = 4.5 * math.sin(13.08 * t + 4.35)
    s3, c3 = math.sin(phi3), math.cos(phi3)
    w3 = v / (0.457 * (2 * c3 + s3))
    w4 = 2 * w3 * (c3 - 2 * s3)
    a, b = 0.953 * math.sin(phi1), 0.847 * math.sin(phi2)
    c, d = -0.953 * math.cos(phi1), -0.847 * math.cos(phi2)
    e, f = 0.5 * 0.457 * w4 - 0.457 * w3 * c3, -0.457 * w3 * s3
    det = a * d - b * c
    return (e * d - b * f) / det, (a * f - e * c) / det, w3


def step_by_hand(t, q, h):
    w = slopes(t, *q)
    return [x + h * y for x, y in zip(q, w, strict=True)]


def by_hand(steps, h):
    q = list(START)
    for i in range(steps):
        q = step_by_hand(i * h, q, h)
    return q


def compiled(compiler, folder):
    """Return the loop in C, compiled in `folder`."""
    (folder / "euler.c").write_text(C_SOURCE, encoding="utf-8")
    library = folder / "euler.so"
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", str(folder / "euler.c"), "-o", str(library), "-lm"], check=True)
    euler = ctypes.CDLL(str(library)).euler
    euler.argtypes = [ctypes.c_long, ctypes.c_double, ctypes.POINTER(ctypes.c_double)]
    return euler


def as_sympy(equations):
    """Return the equations as bare SymPy expressions, and the unknowns."""
    sums = [add(*[c * local(n) for n, c in e.coefficients.items()], -e.right_side) for e in equations.equations]
    return list(map(symbolic, sums)), [sp.Symbol(name, real=True) for name in equations.unknowns]


def uncached(work):
    """Return the work as it is the first time: without what SymPy remembers."""

    def run():
        sp.core.cache.clear_cache()
        work()

    return run


@pytest.fixture(scope="module")
def scene():
    return coursework.solve("31", quantities=["table"]).scene


@pytest.fixture(scope="module")
def loop(scene):
    return generate_loop(SCHEMES["euler"], scene.rates)


def test_generated_loop_against_a_function_call_a_step(loop):
    h = 0.48 / STEPS
    assert max(abs(a - b) for a, b in zip(loop(0.0, STEPS, h, *START), by_hand(STEPS, h), strict=True)) < 1e-11
    assert ratio(lambda: loop(0.0, STEPS, h, *START), lambda: by_hand(STEPS, h), most=1 / 1.3) <= 1 / 1.3


@pytest.fixture(scope="module")
def in_c(tmp_path_factory):
    """Return a call of the bare loop in C, which keeps no row and watches nothing, and the position it ends at."""
    compiler = next((found for name in ("cc", "gcc", "clang") if (found := shutil.which(name))), None)
    if compiler is None:
        pytest.skip("no C compiler on this machine to compare with")
    return c_loop(compiler, tmp_path_factory.mktemp("c"))


def c_loop(compiler, folder):
    """Return the call and the position for a compiler."""
    euler, h = compiled(compiler, folder), 0.48 / STEPS
    state = (ctypes.c_double * 3)(*START)
    euler(STEPS, h, state)
    return lambda: euler(STEPS, h, (ctypes.c_double * 3)(*START)), tuple(state)


def table_march(scene):
    """Return the call that makes the rows of a table as `coursework run` does: kept and watched."""
    return lambda: March(scene.rates, SCHEMES["euler"], 0.48 / STEPS, guarded=(0, 1, 2)).until(START, 0.48)


def exact_rows(scene):
    """Return the call that makes the exact rows: positions by the closure, velocities, determinants."""
    times = np.arange(STEPS + 1) * (0.48 / STEPS)
    return lambda: exact_motion(scene.rates, scene.closure, scene.start, times)


def test_the_march_of_a_table_against_c(scene, in_c):
    call, state = in_c
    motion = table_march(scene)()
    assert len(motion.t) == STEPS + 1
    assert np.max(np.abs(motion.coordinates[-1] - state)) < 1e-11
    assert ratio(table_march(scene), call, most=25) <= 25


def test_the_exact_rows_of_a_closure_against_c(scene, in_c):
    """A row costs at most 20 µs where a step of the loop in C costs 0.12 µs."""
    assert ratio(exact_rows(scene), in_c[0], most=170) <= 170


def test_reduction_against_a_bare_linear_eq_to_matrix():
    scene = coursework.solve("31", quantities=["table"]).scene
    equations = scene.equations
    rows, unknowns = as_sympy(equations)
    start = scene.start
    reduce(equations, start)
    sp.linear_eq_to_matrix(rows, unknowns)

    bare = uncached(lambda: sp.linear_eq_to_matrix(rows, unknowns))
    assert ratio(uncached(lambda: reduce(replace(equations, facts={}), start)), bare, most=20) <= 20
