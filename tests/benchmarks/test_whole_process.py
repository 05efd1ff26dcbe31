"""What a user waits for: whole processes against processes that only import the same libraries (processor time, ratios)."""

import subprocess
import sys
import time

import pytest

try:
    import resource
except ImportError:  # Windows
    resource = None

LIBRARIES = "import numpy, pandas, sympy"
RUNS = 5
ROUNDS = 4
CALL = "from coursework.cli import main; main({arguments!r})"


def spent() -> float:
    """Return the processor time (s) of all children that have ended, to the microsecond; wall time where there is none."""
    if resource is None:
        return time.perf_counter()
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return children.ru_utime + children.ru_stime


def cost(code: str, folder) -> float:
    """Return the least cost (s) of a fresh Python that runs `code`, start and end included; a first run warms the disk."""
    costs = []
    for _ in range(RUNS + 1):
        before = spent()
        done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, encoding="utf-8")
        costs.append(spent() - before)
        assert done.returncode == 0, done.stderr
    return min(costs[1:])


def against(arguments, yardstick, limit, folder) -> float:
    """Return our cost against another code; least costs of up to four rounds, as a busy machine only ever adds to them."""
    ours = bare = float("inf")
    for _ in range(ROUNDS):
        ours = min(ours, cost(CALL.format(arguments=arguments), folder))
        bare = min(bare, cost(yardstick, folder))
        if ours <= limit * bare:
            break
    return ours / bare


# A program of as many commands and options that does nothing but print its help: what click itself costs.
BARE_HELP = """
import click
main = click.Group("main", help="What the program does.")
for number in range(10):
    options = [click.Option([f"--option-{k}"], help=f"What {k} says.", type=click.Path() if k % 2 else int) for k in range(8)]
    main.add_command(click.Command(f"command-{number}", params=[click.Argument(["one"]), *options], help=f"Do work {number}."))
main(["--help"])
"""

# A run judges its table against the exact motion and runs the step it advises before it tells it: that is in its time.
CASES = [
    (["run", "31", "--format", "csv"], LIBRARIES, 1.8),
    (["run", "31"], f"{LIBRARIES}, matplotlib.figure, jinja2, typst", 2.5),
    (["--help"], BARE_HELP, 1.5),
]


MANY, MOST_GROWTH = 25_000, 2.5


def growth(folder) -> float:
    """Return the cost of a table of 25 000 rows, checks included, against one of 25."""
    table = ["run", "31", "--format", "csv"]
    return against([*table, "--step", repr(0.48 / MANY)], CALL.format(arguments=table), MOST_GROWTH, folder)


def test_a_thousand_times_the_rows_against_the_rows_of_the_file(tmp_path):
    assert growth(tmp_path) <= MOST_GROWTH


@pytest.mark.parametrize(("arguments", "yardstick", "limit"), CASES, ids=["table", "report", "help"])
def test_against_the_bare_libraries(arguments, yardstick, limit, tmp_path):
    assert against(arguments, yardstick, limit, tmp_path) <= limit
