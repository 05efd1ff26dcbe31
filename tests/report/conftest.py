"""Fixtures of the report's tests: the hand-made run, a browser where one is installed."""

from __future__ import annotations

import importlib.util
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

HERE = Path(__file__).parent
BROWSERS = ("chromium", "google-chrome", "chromium-browser", "google-chrome-stable", "chrome", "msedge")


def _load(name: str) -> ModuleType:
    """Load a file beside this one (the tests are no package)."""
    full = f"report_tests_{name}"
    if full not in sys.modules:
        spec = importlib.util.spec_from_file_location(full, HERE / f"{name}.py")
        assert spec is not None and spec.loader is not None
        sys.modules[full] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[full])
    return sys.modules[full]


@pytest.fixture(scope="session")
def stand_in() -> ModuleType:
    """The hand-made run of variant 31."""
    return _load("stand_in")


@pytest.fixture(scope="session")
def reading() -> ModuleType:
    """Readers of what the report wrote."""
    return _load("reading")


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """A headless Chromium; tests that need it are skipped, with the reason, on machines without one."""
    driver = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    found = next((path for name in BROWSERS if (path := shutil.which(name))), None)
    if found is None:
        pytest.skip(f"no browser on this machine (looked for {', '.join(BROWSERS)})")
    quiet = ["--no-sandbox", "--disable-gpu", "--disable-background-networking"]
    with driver.sync_playwright() as play:
        running = play.chromium.launch(executable_path=found, args=quiet)
        yield running
        running.close()
