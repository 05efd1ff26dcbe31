"""Fixtures of the live page: pages written as a user writes them, opened from disk in a browser."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import coursework
from coursework.report.output.formats import chosen
from coursework.report.output.results import Results
from coursework.variant.record.variant import Variant
from tests.solved import solved

Written = Callable[..., Path]


@pytest.fixture(scope="session")
def written(tmp_path_factory: pytest.TempPathFactory) -> Written:
    """Write page and tables of a run into a folder of their own, each run once."""
    folders: dict[object, Path] = {}

    def write(variant: str | Variant, *, live: bool = True, **options: Any) -> Path:
        key = (variant if isinstance(variant, str) else repr(variant.changes), live, *sorted(options.items()))
        if key not in folders:
            folder = tmp_path_factory.mktemp("page")
            run = solved(variant, **options) if isinstance(variant, str) else coursework.solve(variant, **options)
            results = Results(run, live=live)
            for each in chosen(("html", "csv"), "run"):
                for name, content in each.write(results):
                    (folder / name).write_bytes(content)
            folders[key] = folder
        return folders[key]

    return write


class Opened:
    """A page in the browser with all that it said and fetched."""

    def __init__(self, page: Any, address: str) -> None:
        self.page, self.said, self.fetched = page, [], []
        page.on("console", lambda message: self.said.append(message.text))
        page.on("pageerror", lambda error: self.said.append(str(error)))
        page.on("request", lambda request: self.fetched.append(request.url))
        page.goto(address)

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
def opened(browser: Any) -> Iterator[Callable[..., Opened]]:
    """Open a written page; the context is closed behind the test."""
    contexts = []

    def start(folder: Path, before: Callable[[Any], None] | None = None, **options: Any) -> Opened:
        context = browser.new_context(**options)
        contexts.append(context)
        page = context.new_page()
        if before is not None:
            before(page)
        return Opened(page, (folder / "report.html").as_uri())

    yield start
    for context in contexts:
        context.close()
