"""What a user waits for: whole processes against processes that only import the same libraries (processor time, ratios)."""

import os
import subprocess
import sys
import time

import pytest

RUNS = 5
CALL = "from coursework.cli import main; main({arguments!r})"


def cost(code: str, folder) -> float:
    """Return the least cost (s) of a fresh Python that runs `code`, start and end included; a first run warms the disk.

    Processor time of the child where the system tells it (POSIX), else wall time.
    """
    costs = []
    for _ in range(RUNS + 1):
        before, begun = os.times(), time.perf_counter()
        done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, encoding="utf-8")
        after, ended = os.times(), time.perf_counter()
        assert done.returncode == 0, done.stderr
        spent = after.children_user + after.children_system - before.children_user - before.children_system
        costs.append(spent or ended - begun)
    return min(costs[1:])


CASES = [
    (["run", "31", "--format", "csv"], "numpy, pandas, sympy", 1.5),
    (["run", "31"], "numpy, pandas, sympy, matplotlib.figure, jinja2, typst", 2.0),
    (["--help"], "click", 1.5),
]


@pytest.mark.parametrize(("arguments", "imports", "limit"), CASES, ids=["table", "report", "help"])
def test_against_bare_imports(arguments, imports, limit, tmp_path):
    ours = cost(CALL.format(arguments=arguments), tmp_path)
    assert ours <= limit * cost(f"import {imports}", tmp_path)
