"""What grading costs: processor time a submission over a whole batch, start-up and every child included.

python -m tests.benchmarks.grading 500      with pages and without
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.benchmarks.test_whole_process import spent
from tests.grading.batch.classroom import EQUATIONS, hand_in
from tests.grading.marking import students


def fill(folder: Path, count: int) -> None:
    """Hand in `count` submissions: four of six right, one slip, one misconception or a wrong equation."""
    codes = list(students.MISCONCEPTIONS)
    for number in range(count):
        table, equations = students.table(), EQUATIONS
        if number % 6 == 3:
            table = students.slip(2 + number % 20, number % 4, 1.1)
        elif number % 12 == 4:
            table = students.MISCONCEPTIONS[codes[number // 12 % len(codes)]]()
        elif number % 12 == 10:
            equations = (*EQUATIONS[:3], EQUATIONS[3].replace("- r1", "+ r1"))
        hand_in(folder / f"st{number:05d}", table, equations, 3 + number % 3)


def cost(count: int, *options: str) -> float:
    """Return the processor time (s) a submission of one whole command."""
    with tempfile.TemporaryDirectory() as place:
        fill(Path(place) / "in", count)
        command = [sys.executable, "-m", "coursework", "grade", "in", "--variant", "31", "--out", "out", *options]
        before = spent()
        environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
        subprocess.run(command, cwd=place, env=environment, check=True, capture_output=True)
        return (spent() - before) / count


if __name__ == "__main__":
    wanted = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    print(f"without pages {1e3 * cost(wanted, '--no-pages'):.1f} ms, with pages {1e3 * cost(wanted):.1f} ms a submission")
