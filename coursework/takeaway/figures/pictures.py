"""`--format figures`: a folder with every drawing of the page as SVG, PDF and PNG, true to scale where the page is.

Enters: `Results`.  Leaves: the bytes of files.  Used by the list of formats, by name.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.report.output.results import Results
from coursework.takeaway.figures.drawings import as_pdf, as_png, pictures_of
from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say

FOLDER = "figures"


def write(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of each file.  Raises `NotToBeHad` if the page has no drawing."""
    pictures = list(pictures_of(results.model).values())
    if not pictures:
        raise NotToBeHad(say("fault.W041"))
    for one, png in zip(pictures, as_png(pictures, results.language), strict=True):
        stem = f"{FOLDER}/{one.name}"
        yield f"{stem}.svg", one.file.encode("utf-8")
        yield f"{stem}.pdf", as_pdf(one, results.language)
        yield f"{stem}.png", png
