"""What the package says of itself, and what its wheel carries."""

import re
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
from hatchling.builders.wheel import WheelBuilder

from coursework.grading.batch.work import Setup
from coursework.grading.batch.workers import on_cluster
from coursework.system import extras
from coursework.words.errors import InputError

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_licence_keywords_and_classifiers():
    assert PROJECT["license"] == "MIT"
    assert not [line for line in PROJECT["classifiers"] if line.startswith("License ::")], "an SPDX expression stands alone"
    assert "Typing :: Typed" in PROJECT["classifiers"]
    assert {"mechanisms", "kinematics", "Euler method"} <= set(PROJECT["keywords"])
    assert "Programming Language :: Python :: " + PROJECT["requires-python"].removeprefix(">=") in PROJECT["classifiers"]


def test_all_is_every_extra_but_test():
    offered = PROJECT["optional-dependencies"]
    named = re.fullmatch(r"coursework\[(.+)\]", *offered["all"])[1].split(",")
    assert sorted(named) == sorted({*offered} - {"all", "test"})


def test_the_extras_of_what_is_installed_are_those_of_the_checkout(tmp_path, monkeypatch):
    (built,) = WheelBuilder(str(ROOT)).build(directory=str(tmp_path), versions=["standard"])
    with zipfile.ZipFile(built) as wheel:
        (metadata,) = (name for name in wheel.namelist() if name.endswith("METADATA"))
        lines = re.findall(r"^Requires-Dist: (.*)$", wheel.read(metadata).decode(), re.M)
    here = extras.packages()
    monkeypatch.setattr(extras, "PROJECT", tmp_path / "pyproject.toml")
    monkeypatch.setattr("importlib.metadata.requires", lambda _name: lines)
    plain = {extra: {name.lower().replace("_", "-") for name in names} for extra, names in here.items()}
    assert {extra: {name.lower() for name in names} for extra, names in extras.packages().items()} == plain


def test_the_wheel_carries_types_variants_and_looks(tmp_path):
    (built,) = WheelBuilder(str(ROOT)).build(directory=str(tmp_path), versions=["standard"])
    with zipfile.ZipFile(built) as wheel:
        carried = set(wheel.namelist())
        (metadata,) = (name for name in carried if name.endswith("METADATA"))
        assert "License-Expression: MIT\n" in wheel.read(metadata).decode()
    assert "coursework/py.typed" in carried
    for folder in ("variants", "reports"):
        there = {path.relative_to(ROOT).as_posix() for path in (ROOT / folder).rglob("*") if path.is_file()}
        assert {f"coursework/{name}" for name in there} <= carried
    assert not [name for name in carried if name.startswith("tests/")]


@pytest.mark.parametrize(
    ("python", "begins"),
    [("/usr/bin/python3", "/usr/bin/python3 -m pip"), ("C:\\My Files\\python.exe", '"C:\\My Files\\python.exe" -m pip')],
)
def test_the_line_that_installs_is_one_for_this_python_wherever_it_lies(monkeypatch, python, begins):
    monkeypatch.setattr(sys, "executable", python)
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InputError) as fault:
        next(on_cluster([], Setup(""), "nowhere:1"))
    assert f'Type: {begins} install "' in str(fault.value) and '[cluster]"   and the command again' in str(fault.value)
