"""Pages of a browser that are lent to one test after the other: a new one takes longer than a report takes to open in it.

Enters: a browser, and what a page is to be like.  Leaves: an empty page, on which nothing is left of who had it before.
"""

from __future__ import annotations

import json
from typing import Any

WINDOW = {"width": 1280, "height": 720}  # that of playwright
OUTSIDE = (-9, -9)


class LentPages:
    """Pages that nobody has at the moment, by what they are like; each has a context of its own."""

    def __init__(self, browser: Any) -> None:
        self.browser = browser
        self.free: dict[str, list[Any]] = {}
        self.lent: list[tuple[str, Any]] = []

    def lend(self, script: str = "", viewport: dict[str, int] = WINDOW, **options: Any) -> Any:
        """Return a page with the options of a context, in each of whose documents `script` runs first."""
        key = json.dumps([script, options], sort_keys=True)
        page = self.free[key].pop() if self.free.get(key) else self.new(script, **options)
        self.lent.append((key, page))
        page.set_viewport_size(viewport)
        return page

    def new(self, script: str = "", **options: Any) -> Any:
        """Return a page that is lent to nobody else."""
        context = self.browser.new_context(**options)
        if script:
            context.add_init_script(script)
        return context.new_page()

    def take_back(self) -> None:
        """Empty all pages that are lent; what listens to them has gone before."""
        while self.lent:
            key, page = self.lent.pop()
            page.goto("about:blank")
            page.mouse.move(*OUTSIDE)
            page.emulate_media(media="null", color_scheme="light")
            self.free.setdefault(key, []).append(page)
