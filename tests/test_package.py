"""What the package says of itself, and what its wheel carries."""

import tomllib
from pathlib import Path

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_licence_keywords_and_classifiers():
    assert PROJECT["license"] == "MIT"
    assert not [line for line in PROJECT["classifiers"] if line.startswith("License ::")], "an SPDX expression stands alone"
    assert "Typing :: Typed" in PROJECT["classifiers"]
    assert {"mechanisms", "kinematics", "Euler method"} <= set(PROJECT["keywords"])
    assert "Programming Language :: Python :: " + PROJECT["requires-python"].removeprefix(">=") in PROJECT["classifiers"]


def test_types_are_marked():
    assert (ROOT / "coursework" / "py.typed").read_bytes() == b""
