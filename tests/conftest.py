"""Fixtures that several rooms' tests share: an empty folder to work in, a browser where one is installed."""

from __future__ import annotations

import gc
import inspect
import os
import shutil
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from _pytest.runner import runtestprotocol

from coursework.system.processes.one_thread import keep_to_one_thread
from tests.lent_pages import LentPages
from tests.sample import ask_long

# Before anything loads NumPy: a second thread for one system of equations spends a hundred times its processor time on waiting.
keep_to_one_thread()
# Compiled once for all processes of the suite, some two hundred, whatever the environment says; .gitignore knows the folders.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
# What tests share is kept to the end: looked through for garbage rarely, it costs a fifteenth less.
gc.set_threshold(50_000, 20, 100)
# PyMuPDF would load a neural net that looks for paragraphs, and nobody asks it for any.
sys.modules["pymupdf.layout"] = None  # type: ignore[assignment]

# The first is the engine of the others alone: it opens the same pages for three quarters of the processor time.
BROWSERS = (
    "chromium-headless-shell", "chromium", "google-chrome", "chromium-browser", "google-chrome-stable", "chrome", "msedge",
)  # fmt: skip
# Without hinting, letters are as wide in the engine alone as in a whole browser.
STARTED = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--font-render-hinting=none"]


def pytest_configure(config: pytest.Config) -> None:
    ask_long(config.option.markexpr != "not long")


@pytest.hookimpl(tryfirst=True)
def pytest_unconfigure() -> None:
    """Look through all that was kept for garbage once: pytest would do so twice, and the end of the process once more."""
    gc.collect()
    gc.freeze()


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(collector: Any, obj: object) -> list[Any] | None:
    """Make no items of a long test that is not asked: a third of all, in each of the processes.

    Where a test is named by itself, the usual line says that it is left out.
    """
    config = collector.config
    named = any("::" in word for word in config.args)
    marks = (
        getattr(obj, "pytestmark", ()) if inspect.isfunction(obj) and not named and config.option.markexpr == "not long" else ()
    )
    return [] if any(mark.name == "long" for mark in marks) else None


@pytest.hookimpl(tryfirst=True)
def pytest_collection(session: pytest.Session) -> None:
    """Let the first of several processes read the tests alone: what it compiles, others that begin with it would each compile."""
    if getattr(session.config, "workerinput", {}).get("workerid", "gw0") != "gw0":
        patient_until = time.monotonic() + 120  # s: the first may hang
        have_been_read = of_readers(Path(session.config.option.basetemp).parent)
        while not have_been_read.exists() and time.monotonic() < patient_until:
            time.sleep(0.1)


def pytest_collection_finish(session: pytest.Session) -> None:
    if hasattr(session.config, "workerinput"):
        of_readers(Path(session.config.option.basetemp).parent).touch()


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """Let nobody wait for a process that died while it read the tests."""
    of_readers(node.config._tmp_path_factory.getbasetemp()).touch()


def of_readers(folder: Path) -> Path:
    """Return the file that is there once a process has read the tests, in the `folder` that holds those of all processes."""
    return folder / "tests-have-been-read"


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """From one process to another, tell of a test that passed one thing, that it did: its five reports cost a millisecond."""
    if not hasattr(item.config, "workerinput"):
        return None
    reports = runtestprotocol(item, log=False, nextitem=nextitem)
    passed = all(report.passed for report in reports) and not item.config.option.durations  # of setting up, too
    for report in reports:
        if passed:
            report.keywords = {}
        if not passed or report.when == "call":
            item.ihook.pytest_runtest_logreport(report=report)
    return True


def installed_browser() -> str | None:
    """Return the path of a browser of this machine, None where there is none."""
    return next((path for name in BROWSERS if (path := shutil.which(name))), None)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder, which a command finds itself in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """A headless Chromium; tests that need it are skipped, with the reason, on machines without one."""
    driver = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    found = installed_browser()
    if found is None:
        pytest.skip(f"no browser on this machine (looked for {', '.join(BROWSERS)})")
    with driver.sync_playwright() as play:
        running = play.chromium.launch(executable_path=found, args=STARTED)
        yield running
        running.close()


@pytest.fixture(scope="session")
def lent_pages(browser: Any) -> LentPages:
    """Pages of the browser; a fixture of one test takes back what it has lent."""
    return LentPages(browser)
