"""The tests of the desk's JavaScript that need no browser, by node's own runner."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
def test_what_needs_no_browser() -> None:
    surroundings = os.environ | {"PYTHON": sys.executable}
    told = subprocess.run(["node", "--test"], cwd=Path(__file__).parent, env=surroundings, capture_output=True, text=True)
    assert told.returncode == 0, told.stdout
    assert "\n# pass 15\n" in told.stdout
