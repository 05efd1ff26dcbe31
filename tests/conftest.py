"""Fixtures that several rooms' tests share: an empty folder to work in, a browser where one is installed."""

from __future__ import annotations

import gc
import os
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.lent_pages import LentPages

# Compiled once for all processes of the suite, some two hundred, whatever the environment says; .gitignore knows the folders.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
# What tests share is kept to the end: looked through for garbage rarely, it costs a fifteenth less.
gc.set_threshold(50_000, 20, 100)
# PyMuPDF would load a neural net that looks for paragraphs, and nobody asks it for any.
sys.modules["pymupdf.layout"] = None  # type: ignore[assignment]

BROWSERS = ("chromium", "google-chrome", "chromium-browser", "google-chrome-stable", "chrome", "msedge")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder, which a command finds itself in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


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


@pytest.fixture(scope="session")
def lent_pages(browser: Any) -> LentPages:
    """Pages of the browser; a fixture of one test takes back what it has lent."""
    return LentPages(browser)
