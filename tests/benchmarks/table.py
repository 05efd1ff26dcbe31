"""The table "How fast it is" of README.md, measured anew:  python -m tests.benchmarks.table"""

import ctypes
import shutil
import tempfile
from pathlib import Path

import sympy as sp

import coursework
from coursework.integration.loops import generate_loop
from coursework.reduction.blocks import reduce
from coursework.schemes import SCHEMES
from tests.benchmarks import test_march as march
from tests.benchmarks import test_whole_process as whole
from tests.benchmarks.timer import ratio


def rows():
    """Yield (what, against what, ratio, limit)."""
    scene = coursework.solve("31", quantities=["table"]).scene
    loop = generate_loop(SCHEMES["euler"], scene.rates)
    h = 0.48 / march.STEPS

    def generated() -> None:
        loop(0.0, march.STEPS, h, *march.START)

    yield (
        "loop by hand, a call a step",
        "generated Euler loop",
        ratio(lambda: march.by_hand(march.STEPS, h), generated),
        "at least 1.3",
    )
    if compiler := shutil.which("cc") or shutil.which("gcc") or shutil.which("clang"):
        with tempfile.TemporaryDirectory() as folder:
            euler = march.compiled(compiler, Path(folder))
            in_c = ratio(generated, lambda: euler(march.STEPS, h, (ctypes.c_double * 3)(*march.START)))
        yield "generated Euler loop", "the same loop in C", in_c, "at most 10"
    equations, start = scene.equations, scene.start
    bare = march.uncached(lambda: sp.linear_eq_to_matrix(*march.as_sympy(equations)))
    reduced = ratio(march.uncached(lambda: reduce(equations, start)), bare)
    yield "reduction of variant 31", "a bare linear_eq_to_matrix", reduced, "at most 20"
    for arguments, imports, limit in whole.CASES:
        with tempfile.TemporaryDirectory() as folder:
            process = whole.ratio(arguments, imports, limit, folder)
        yield f"`coursework {' '.join(arguments)}`", f"importing {imports}", process, f"at most {limit}"


if __name__ == "__main__":
    print("| what | against | ratio | limit |\n|---|---|---|---|")
    for what, against, measured, limit in rows():
        print(f"| {what} | {against} | {measured:.2f} | {limit} |")
