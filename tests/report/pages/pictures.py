"""How ten pages looked when a person last looked at them: the top of each, an eighth as large, in grey.

All letters are those of one face, which comes with matplotlib: set in those of a machine a page would look like no other's.

`python -m tests.report.pages.pictures` takes them anew into `seen/`; whoever does that looks at the pages first.
"""

from __future__ import annotations

import base64
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib
import pymupdf

from tests.conftest import STARTED, installed_browser
from tests.report.pages.all_kinds import KINDS, make

SEEN = Path(__file__).parent / "seen"
HIGH, HALVINGS = 1600, 3  # px of a page, and how often it is made half as large
# Name -> kind of page, width, colours: every kind light at 1400 px, the report on a phone and in the dark besides.
VIEWS = {kind: (kind, 1400, "light") for kind in KINDS} | {
    "report-phone": ("report", 390, "light"), "report-dark": ("report", 1400, "dark"),
}  # fmt: skip


def take(browser: Any, page: Path, width: int, colours: str) -> pymupdf.Pixmap:
    """Return the top of a page as a small grey picture; what a clock or a machine says is covered."""
    shown = browser.new_page(viewport={"width": width, "height": HIGH}, color_scheme=colours, bypass_csp=True)
    shown.goto(page.as_uri())
    shown.add_style_tag(content=f"{_face()} #lab-time, #lab-time-ratio, #lab-diagram {{ visibility: hidden; }}")
    shown.evaluate("document.fonts.ready")
    picture = pymupdf.Pixmap(pymupdf.csGRAY, pymupdf.Pixmap(shown.screenshot()))
    shown.close()
    picture.shrink(HALVINGS)
    return picture


@cache
def _face() -> str:
    """Return a stylesheet that sets everything in a face that travels along."""
    data = (Path(matplotlib.get_data_path()) / "fonts" / "ttf" / "DejaVuSerif.ttf").read_bytes()
    source = f"url(data:font/ttf;base64,{base64.b64encode(data).decode()})"
    return f"@font-face {{ font-family: Seen; src: {source}; }} * {{ font-family: Seen !important; }}"


def main() -> None:
    """Take all of them anew."""
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        places = make(Path(folder))
        browser = play.chromium.launch(executable_path=installed_browser(), args=STARTED)
        for name, (kind, width, colours) in VIEWS.items():
            take(browser, places[kind], width, colours).save(SEEN / f"{name}.png")
        browser.close()


if __name__ == "__main__":
    main()
