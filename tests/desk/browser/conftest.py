"""A desk as a person meets it: the command is started, a real browser opens the address that it prints."""

from __future__ import annotations

import contextlib
import shutil
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.desk.serving.server import running

PATIENCE = 60_000  # ms: a machine may be busy; no test says how long anything takes
VIEW = "document.querySelector('#desk-text .cm-content').cmTile.view"
RESTS = "#desk-state:not([data-state=computing])"


class Desk:
    """A page of a desk with all that it said and asked; `asked` counts requests by method and path."""

    def __init__(self, page: Any, address: str) -> None:
        self.page, self.address, self.said, self.asked = page, address, list[str](), Counter[str]()
        page.set_default_timeout(PATIENCE)
        page.on("console", lambda message: self.said.append(message.text))
        page.on("pageerror", lambda error: self.said.append(str(error)))
        page.on(
            "request",
            lambda request: self.asked.update(
                [f"{request.method} {request.url.partition('?')[0].partition('//')[2].partition('/')[2]}"]
            ),
        )
        self.open(address)

    def open(self, address: str) -> None:
        self.page.goto(address)
        self.rest()

    def rest(self, *state: str) -> None:
        """Wait until the desk has answered for the text that stands there, in one of the states."""
        wanted = ",".join(f"#desk-state[data-state={one}]" for one in state) or RESTS
        self.page.wait_for_selector(wanted)

    def until(self, happened: Callable[[], object]) -> None:
        """Wait until something has happened on the page."""
        for _ in range(PATIENCE // 20):
            if happened():
                return
            self.page.wait_for_timeout(20)
        raise AssertionError("it did not happen")

    @property
    def text(self) -> str:
        return str(self.page.evaluate(f"{VIEW}.state.doc.toString()"))

    @property
    def state(self) -> tuple[str, str]:
        """Return data-state and data-file."""
        return tuple(self.page.get_attribute("#desk-state", f"data-{name}") for name in ("state", "file"))  # type: ignore[return-value]

    @property
    def report(self) -> Any:
        """Return the frame with the report."""
        return next(frame for frame in self.page.frames if frame.url.endswith("/desk/frame"))

    def replace(self, before: str, after: str) -> None:
        """Select a piece of the text and type another over it."""
        at = self.text.index(before)
        self.page.focus("#desk-text .cm-content")
        select = f"([anchor, head]) => {VIEW}.dispatch({{selection: {{anchor, head}}}})"
        self.page.evaluate(select, [at, at + len(before)])
        self.page.keyboard.insert_text(after)

    def faults(self) -> list[tuple[int, int, str]]:
        """Return line, column and sentence of each line below the text."""
        read = "list => list.map(({dataset: {line, column}, textContent}) => [Number(line), Number(column), textContent])"
        return [tuple(one) for one in self.page.eval_on_selector_all("#desk-faults li.fault", read)]


@pytest.fixture(scope="session")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., tuple[str, Path]]]:
    """Start a desk in a folder of its own, one for all tests that ask for the same; all are ended behind them."""
    found: dict[tuple[str, ...], tuple[str, Path]] = {}
    with contextlib.ExitStack() as stack:

        def start(*words: str) -> tuple[str, Path]:
            if words not in found:
                folder = tmp_path_factory.mktemp("desk")
                found[words] = stack.enter_context(running(*words, folder=folder)).address, folder
            return found[words]

        yield start


@pytest.fixture
def desk(browser: Any, served: Callable[..., tuple[str, Path]]) -> Iterator[Callable[..., tuple[Desk, Path]]]:
    """Open a desk in a browser that knows nothing yet, over an empty folder: its page and its folder."""
    contexts = []

    def start(*words: str, **look: Any) -> tuple[Desk, Path]:
        address, folder = served(*(words or ("edit", "31", "--no-browser")))
        for path in folder.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        context = browser.new_context(**({"viewport": {"width": 1400, "height": 900}} | look))
        contexts.append(context)
        return Desk(context.new_page(), address), folder

    yield start
    for context in contexts:
        context.close()
