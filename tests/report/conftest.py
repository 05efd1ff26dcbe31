"""Fixtures of the report's tests: real runs and readers of pages, pages opened from disk in a browser."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from tests.lent_pages import LentPages
from tests.report import reading as readers
from tests.report import real as runs


@pytest.fixture(scope="session")
def real() -> ModuleType:
    """Real runs, and readers of their model."""
    return runs


@pytest.fixture(scope="session")
def reading() -> ModuleType:
    """Readers of what the report wrote."""
    return readers


class Opened:
    """A page in the browser with all that it said and fetched."""

    def __init__(self, page: Any, address: str) -> None:
        self.page = page
        self.said: list[str] = []
        self.fetched: list[str] = []
        self.listening = {
            "console": lambda message: self.said.append(message.text), "pageerror": lambda error: self.said.append(str(error)),
            "request": lambda request: self.fetched.append(request.url),
        }  # fmt: skip
        for event, listener in self.listening.items():
            page.on(event, listener)
        page.goto(address)

    def leave(self) -> None:
        """Listen no more."""
        for event, listener in self.listening.items():
            self.page.remove_listener(event, listener)

    def set(self, hook: str, value: object, event: str = "input") -> None:
        """Move a control as a hand does."""
        act = "(at, [value, event]) => { at.value = value; at.dispatchEvent(new Event(event, {bubbles: true})); }"
        self.page.eval_on_selector(hook, act, [value, event])

    def value(self, hook: str) -> str:
        """Return the data-value of an output."""
        return str(self.page.get_attribute(hook, "data-value"))

    @property
    def row(self) -> int:
        """Return the row at which the animation stands."""
        return int(self.page.get_attribute("#live", "data-row"))


@pytest.fixture
def opened(lent_pages: LentPages) -> Iterator[Callable[..., Opened]]:
    """Open a written page on a lent one, on which `script` runs first; where `before` changes the page, on one of its own."""
    pages: list[Opened] = []
    own: list[Any] = []

    def start(folder: Path, script: str = "", before: Callable[[Any], None] | None = None, **options: Any) -> Opened:
        if before is None:
            page = lent_pages.lend(script, **options)
        else:
            own.append(page := lent_pages.new(script, **options))
            before(page)
        pages.append(Opened(page, (folder / "report.html").as_uri()))
        return pages[-1]

    yield start
    for one in pages:
        one.leave()
    lent_pages.take_back()
    for page in own:
        page.context.close()
