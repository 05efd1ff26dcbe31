"""How fast it is, as ratios measured in one run on one machine:  python -m tests.benchmarks.table  measures them anew.

Each limit is asserted by `pytest tests/benchmarks`; README.md names some of them.

| what | against | ratio | limit |
|---|---|---|---|
| loop by hand, a call a step | generated Euler loop | 2.4 | at least 1.3 |
| march of a table, rows kept and determinants watched | a bare loop in C | 18 | at most 25 |
| exact rows of a closure | a bare loop in C | 71 | at most 170 (20 µs) |
| reduction of variant 31 | a bare linear_eq_to_matrix | 0.55 | at most 20 |
| `solve_many`, 1000 sets of variant 31 | Euler by hand over arrays, nothing watched | 7.5 | at most 10 |
| 1000 sets of variant 31, one by one | `solve_many` | 580 | at least 200 |
| one variant of a class, from its file to table and checks | 20 000 Euler steps by hand | 1.0 | at most 1.7 |
| a page of the desk for another datum, 31 | 20 000 Euler steps by hand | 4.3 | at most 6.8 |
| the same of jansen | 20 000 Euler steps by hand | 10 | at most 20 |
| a workbook beyond its page, 31 | XlsxWriter, a thousand formulas | 0.79 | at most 1 |
| the same of andrews | XlsxWriter, a thousand formulas | 2.1 | at most 2.7 |
| a note beyond its page, 31 | pandoc twice, one formula | 9.0 | at most 12 |
| `coursework run 31 --format csv` | importing numpy, click | 1.5 | at most 2.2 |
| `coursework run 31 --set r1=0.95m --format csv` | importing numpy, click | 1.6 | at most 2.3 |
| `coursework run jansen --format csv` | importing numpy, click | 1.7 | at most 2.4 |
| `coursework check 31` | importing numpy, click | 1.2 | at most 2.2 |
| `coursework run 31` | importing numpy, click | 5.8 | at most 7 |
| `coursework --help` | click alone, as many commands | 1.0 | at most 1.5 |
| the first page of a process | a further one with other data | 2.0 | at most 2.3 |
| a table of 25 000 rows with its checks | the 25 rows of variant 31, csv | 2.9 | at most 4 |
"""

import shutil
import tempfile
from dataclasses import replace
from pathlib import Path

import sympy as sp

import coursework
from coursework.equations.reduction.blocks import reduce
from coursework.motion.integration.loops import generate_loop
from coursework.motion.schemes import SCHEMES
from tests.benchmarks import test_desk as desk
from tests.benchmarks import test_many as many
from tests.benchmarks import test_march as march
from tests.benchmarks import test_takeaway as takeaway
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
            in_c = march.c_loop(compiler, Path(folder))[0]
            marched, exact = ratio(march.table_march(scene), in_c), ratio(march.exact_rows(scene), in_c)
        yield "march of a table, rows kept and determinants watched", "a bare loop in C", marched, "at most 25"
        yield "exact rows of a closure", "a bare loop in C", exact, "at most 170"
    equations, start = scene.equations, scene.start
    bare = march.uncached(lambda: sp.linear_eq_to_matrix(*march.as_sympy(equations)))
    reduced = ratio(march.uncached(lambda: reduce(replace(equations, facts={}), start)), bare)
    yield "reduction of variant 31", "a bare linear_eq_to_matrix", reduced, "at most 20"
    batch = "`solve_many`, 1000 sets of variant 31"
    yield batch, "Euler by hand over arrays, nothing watched", many.cost(0), f"at most {many.MOST}"
    yield "1000 sets of variant 31, one by one", "`solve_many`", many.gain(), f"at least {many.LEAST_GAIN}"
    for name, most in desk.MOST.items():
        yield f"a page of the desk for another datum, {name}", "20 000 Euler steps by hand", desk.cost(name), f"at most {most}"
    for suffix, against, limits in (
        ("xlsx", "XlsxWriter, a thousand formulas", takeaway.WORKBOOK), ("docx", "pandoc twice, one formula", takeaway.NOTE),
    ):  # fmt: skip
        for name, most in limits.items():
            yield f"{suffix} beyond its page, {name}", against, takeaway.cost(name, suffix), f"at most {most}"
    for arguments, yardstick, limit in whole.CASES:
        with tempfile.TemporaryDirectory() as folder:
            process = whole.against(arguments, yardstick, limit, folder)
        against = "click alone, as many commands" if yardstick == whole.BARE_HELP else yardstick.replace("import", "importing")
        yield f"`coursework {' '.join(arguments)}`", against, process, f"at most {limit}"
    with tempfile.TemporaryDirectory() as folder:
        first = whole.first_page(folder)
    yield "the first page of a process", "a further one with other data", first, f"at most {whole.MOST_FIRST}"
    with tempfile.TemporaryDirectory() as folder:
        yield f"the same with {whole.MANY} rows", "with 25 rows, csv", whole.growth(folder), f"at most {whole.MOST_GROWTH}"


if __name__ == "__main__":
    print("| what | against | ratio | limit |\n|---|---|---|---|")
    for what, against, measured, limit in rows():
        print(f"| {what} | {against} | {measured:.2f} | {limit} |")
