"""A law of thousands of nodes costs what reading it costs: file, reduction, table and checks against those of 51 nodes."""

import math
import shutil

import pytest

import coursework
from coursework.equations.reduction.structure import structures
from coursework.words.data_folders import folder
from tests.benchmarks.timer import ratio


@pytest.mark.parametrize(("nodes", "method"), [(6000, "five-point"), (4000, "spline")])
def test_a_long_table_costs_little_more_than_a_short_one(nodes, method, tmp_path):
    small = folder("variants") / "variable-crank-table.toml"
    shutil.copy(small.with_suffix(".csv"), tmp_path)
    first, last = math.radians(76.72), math.radians(126.72)
    angles = [first + (last - first) * k / (nodes - 1) for k in range(nodes)]
    text = small.read_text(encoding="utf-8").replace("variable-crank-table.csv", "long.csv").replace("five-point", method)
    (tmp_path / "long.toml").write_text(text, encoding="utf-8")
    rows = "".join(f"{angle!r},{0.12 + 0.02 * math.sin(1.3 * angle)!r}\n" for angle in angles)
    (tmp_path / "long.csv").write_text(rows, encoding="utf-8")

    def whole(path):
        structures.cache_clear()
        run = coursework.solve(path, quantities=["table", "checks"])
        return run.columns(), run.checks

    assert ratio(lambda: whole(tmp_path / "long.toml"), lambda: whole(small), most=3.0, repeats=3) <= 3.0
