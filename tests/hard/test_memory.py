"""The largest scenes as a user runs them, each in a process of its own: how much memory it takes at its peak."""

import json
import subprocess
import sys

import pytest

from tests.hard.drives import Law, four_bar
from tests.hard.scenes import ROOT

MOST = 500  # MiB
PEAK = """
import json, resource, subprocess, sys
ended = subprocess.run(sys.argv[1:], capture_output=True, text=True)
print(json.dumps([ended.returncode, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024, ended.stdout, ended.stderr]))
"""
STEADY = Law("steady", "n", {"n": "6.2831853 rad/s"}, float)
UNEVEN = Law("uneven", "n + 0.3*n*sin(k*t)", {"n": "628.31853 rad/s", "k": "1.7 1/s"}, float)
PULSE = Law(
    "pulse", "b + a*exp(-((t - tm)/T)^2)", {"a": "1e4 rad/s", "b": "1 rad/s", "tm": "0.50437 s", "T": "1e-4 s"}, float
)  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize(
    ("text", "formats"),
    [
        (four_bar(STEADY, end=2000.0, scheme="euler"), "csv"),  # 200 001 rows
        (four_bar(UNEVEN, step=0.1, end=1000.0), "csv"),  # a hundred thousand turns
        (four_bar(PULSE, step=1e-4, scheme="rk4"), "html,pdf,csv"),
        (four_bar(STEADY, end=600.0, scheme="rk4"), "html"),
    ],
    ids=["rows", "turns", "pulse", "page"],
)
def test_the_largest_scenes_stay_below_half_a_gigabyte(tmp_path, text, formats):
    (tmp_path / "large.toml").write_text(text, encoding="utf-8")
    command = [sys.executable, "-c", PEAK, sys.executable, "-m", "coursework", "run", "large.toml", "--format", formats]
    env = {"PYTHONPATH": str(ROOT), "PATH": "/usr/bin:/bin"}
    told = subprocess.run([*command, "--out", "out"], cwd=tmp_path, env=env, capture_output=True, text=True, check=True)
    status, peak, _, errors = json.loads(told.stdout)
    assert status == 0, errors
    assert (tmp_path / "out" / "run.json").exists()
    assert peak < MOST
