"""The only access to Typst, which is loaded when needed, with fonts that do not depend on the machine.

Enters: a template of `reports/` and data for JSON.  Leaves: PDF bytes, or one SVG or PNG per page.
Raises `OutputError` if Typst is not installed; `refusal` turns an error of Typst into one of ours.
Used by `svg.py` and `pdf.py`.
"""

from __future__ import annotations

import json
import re
import threading
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from coursework.system.extras import installing
from coursework.words.custom_templates import templates_in_use
from coursework.words.data_folders import folder
from coursework.words.errors import CourseworkError, InputError, OutputError
from coursework.words.sentences import say
from coursework.words.templates import failing_piece

if TYPE_CHECKING:
    import typst

# Typst keeps each result until ten further compilations have not used it: 480 MB for reports that differ in their data.  So
# many empty compilations before each PDF, 0.2 ms each, still keep what the next report reuses, and halve the memory.
EMPTY = 5
_PLACE = re.compile(r"┌─ .*?reports/(?P<name>[^:\n]+):(?P<line>\d+):")  # the place that Typst names in an error
_ALONE = threading.Lock()  # the compiler that is reused serves one thread at a time


def _typst() -> Any:
    try:
        import typst
    except ImportError as error:
        raise OutputError(say("fault.W014", error=error, command=installing("typst"))) from error
    return typst


@lru_cache(maxsize=2)
def _fonts(place: Path, everything: bool) -> typst.Fonts:
    """Return Typst's own fonts and those of the folder `place`; `everything` adds the fonts of the machine."""
    fonts: typst.Fonts = _typst().Fonts(include_system_fonts=everything, font_paths=[str(place)])
    return fonts


def typeset(
    template: str, data: Any, kind: Literal["pdf", "svg", "png"], *, standard: str | None = None, everything: bool = False,
    ppi: float | None = None,
) -> Any:  # fmt: skip
    """Return `reports/<template>` filled with `data` by Typst; the same bytes for the same data.

    `standard` is a PDF standard such as "ua-1", checked while compiling; `everything` adds the fonts of the machine; `ppi` is
    the resolution of a PNG in dots per inch.
    Raises `typst.TypstError` unchanged (see `refusal`); `OutputError` if Typst is not installed.
    """
    place = folder("reports")
    if kind == "pdf":
        _forget()
    return _typst().compile(
        sources(template, data),
        font_paths=_fonts(place / "fonts", everything),
        root=str(place),
        format=kind,
        ppi=ppi,
        timestamp=0,
        pdf_standards=[standard] if standard else [],
    )


def sources(template: str, data: Any) -> dict[str, bytes]:
    """Return the files that Typst does not read from the folder: a main page that includes the template, and the data.

    If data were passed as an input value, every result of Typst would depend on it, and the next report could reuse none.
    Typst also parses every file as its own source: after two slashes, which the data begins with, a line is a quick comment.
    """
    return {"main.typ": f'#include "{template}"'.encode(), "data.json": json.dumps(["//", data], ensure_ascii=False).encode()}


def refusal(error: RuntimeError) -> CourseworkError:
    """Return our error for a `typst.TypstError`: `InputError` if an instructor's own template caused it, else `OutputError`."""
    told = " ".join(str(error).split())
    found = _PLACE.search(getattr(error, "diagnostic", ""))
    if found and (name := found["name"]) in templates_in_use():
        return InputError([failing_piece(name, int(found["line"]), told)])
    return OutputError(say("fault.W015", refused=told[:2000]))


def _forget() -> None:
    """Let Typst drop the results that only earlier reports used, by `EMPTY` empty compilations."""
    with _ALONE:
        for _ in range(EMPTY):
            _empty().compile(b"", format="svg")


@cache
def _empty() -> typst.Compiler:
    place = folder("reports")
    compiler: typst.Compiler = _typst().Compiler(b"", root=str(place), font_paths=_fonts(place / "fonts", everything=False))
    return compiler
