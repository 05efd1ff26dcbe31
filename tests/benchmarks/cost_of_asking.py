"""What each thing asked for costs: processor time of variant 31 from its file to the result, imports apart.

python -m tests.benchmarks.cost_of_asking            prints this table
python -m tests.benchmarks.cost_of_asking cost.svg   draws it too, as in README.md

| asked for | ms | times a table |
|---|---|---|
| one column (phi3) | 18 | 1.0 |
| table | 19 | 1.0 |
| + accelerations | 22 | 1.2 |
| + points | 29 | 1.6 |
| table + checks | 29 | 1.6 |
| table + accuracy | 77 | 4.1 |
| HTML report (table, plots, checks) | 83 | 4.5 |
| HTML and PDF | 97 | 5.2 |
| everything the file asks for | 261 | 14.0 |
"""

import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import coursework
from coursework.equations.reduction.structure import structures
from coursework.report.output.tables import table_csv
from coursework.system.files.whole_files import write_bytes


def _write(quantities: list[str], *kinds: str) -> None:
    run = coursework.solve("31", quantities=quantities)
    with tempfile.TemporaryDirectory() as folder:
        write_bytes(Path(folder) / "table.csv", table_csv(run).encode("utf-8"))
        if "checks" in quantities:
            _ = run.checks
        if kinds:
            coursework.write_report(run, *(Path(folder) / f"report.{kind}" for kind in kinds))
        elif "accuracy" in quantities:
            _ = run.accuracy


SCENES: dict[str, Callable[[], None]] = {
    "one column (phi3)": lambda: _write(["phi3"]),
    "table": lambda: _write(["table"]),
    "+ accelerations": lambda: _write(["table", "accelerations"]),
    "+ points": lambda: _write(["table", "accelerations", "points"]),
    "table + checks": lambda: _write(["table", "checks"]),
    "table + accuracy": lambda: _write(["table", "accuracy"]),
    "HTML report (table, plots, checks)": lambda: _write(["table", "plots", "checks"], "html"),
    "HTML and PDF": lambda: _write(["table", "plots", "checks"], "html", "pdf"),
    "everything the file asks for": lambda: _write(["table", "plots", "checks", "accuracy"], "html", "pdf"),
}


def measure(repeats: int = 7) -> dict[str, float]:
    """Return the least processor time (s) of each scene."""
    found = {}
    for name, work in SCENES.items():
        work()
        times = []
        for _ in range(repeats):
            structures.cache_clear()  # what a run of its own costs
            begun = time.process_time()
            work()
            times.append(time.process_time() - begun)
        found[name] = min(times)
    return found


def draw(found: dict[str, float], path: Path) -> None:
    """Write the chart."""
    import matplotlib
    from matplotlib.figure import Figure

    matplotlib.rcParams["svg.hashsalt"] = "cost"
    figure = Figure(figsize=(7.2, 3.2))
    axes = figure.add_axes((0.36, 0.16, 0.6, 0.8))
    names = list(found)[::-1]
    bars = axes.barh(names, [1e3 * found[name] for name in names], color="0.75", edgecolor="black")
    axes.bar_label(bars, fmt="%.0f", padding=3)
    axes.set_xlabel("processor time, ms (variant 31, imports apart)")
    axes.margins(x=0.12)
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    measured = measure()
    base = measured["table"]
    print(f"{'asked for':<38} {'ms':>7} {'times a table':>14}")
    for scene, seconds in measured.items():
        print(f"{scene:<38} {seconds * 1e3:>7.0f} {seconds / base:>14.1f}")
    if len(sys.argv) > 1:
        draw(measured, Path(sys.argv[1]))
