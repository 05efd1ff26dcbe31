"""The one way to Typst: loaded when needed, with fonts that do not depend on the machine.

Enters: a template of `reports/` and data as JSON.  Leaves: PDF bytes, or one SVG or PNG a page.
Raises `OutputError` where Typst is not installed or refuses the page.
Used by `svg.py` and `pdf.py`.
"""

from __future__ import annotations

import atexit
import importlib.util
import json
import os
import re
import shutil
import tempfile
import threading
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from coursework.words.custom_templates import templates_in_use
from coursework.words.data_folders import folder
from coursework.words.errors import CourseworkError, InputError, OutputError
from coursework.words.sentences import say
from coursework.words.templates import failing_piece

if TYPE_CHECKING:
    import typst

# The sans face for figures and for signs the text face lacks; matplotlib brings it along.
FACES = ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "DejaVuSans-Oblique.ttf", "DejaVuSans-BoldOblique.ttf")

# Typst keeps what it has computed until ten further compilations had no use for it: 480 MB of reports that differ in their
# data.  So many empty ones before each PDF, 0.2 ms each, leave what the next report takes over, and half the memory.
EMPTY = 5
_PLACE = re.compile(r"┌─ .*?reports/(?P<name>[^:\n]+):(?P<line>\d+):")  # in Typst's account of an error
_ALONE = threading.Lock()  # a compiler that is used again serves one thread at a time


def _typst() -> Any:
    try:
        import typst
    except ImportError as error:
        raise OutputError(say("fault.W014", error=error)) from error
    return typst


def _fonts(everything: bool) -> typst.Fonts:
    """Return Typst's own faces, DejaVu Sans and those of `reports/fonts`; `everything` adds those of the machine."""
    return _fonts_in((_faces(), folder("reports") / "fonts"), everything)


@lru_cache(maxsize=2)
def _fonts_in(places: tuple[Path, ...], everything: bool) -> typst.Fonts:
    fonts: typst.Fonts = _typst().Fonts(include_system_fonts=everything, font_paths=list(map(str, places)))
    return fonts


_places: list[Path] = []


def _faces() -> Path:
    """Return a folder with `FACES` alone: matplotlib's own folder holds faces that would be taken for missing signs.

    Typst reads a face when it first needs it, so a folder that was cleared away in between is made anew.
    """
    if _places and _places[-1].is_dir():
        return _places[-1]
    found = importlib.util.find_spec("matplotlib")
    if found is None or found.origin is None:
        raise OutputError(say("fault.W013"))
    source = Path(found.origin).parent / "mpl-data" / "fonts" / "ttf"
    try:
        place = Path(tempfile.mkdtemp(prefix="coursework-fonts-"))
        atexit.register(_removed, place, os.getpid())
        for face in FACES:
            _link(source / face, place / face)
    except OSError:
        place = source  # no room for temporary files: the whole folder serves as well
    _places.append(place)
    return place


def _removed(place: Path, owner: int) -> None:
    if os.getpid() == owner:  # a forked child must not take the fonts away from its parent
        shutil.rmtree(place, ignore_errors=True)


def _link(source: Path, target: Path) -> None:
    try:
        target.symlink_to(source)
    except OSError:  # Windows lets only administrators
        shutil.copyfile(source, target)


def typeset(
    template: str, data: Any, kind: Literal["pdf", "svg", "png"], *, standard: str | None = None, everything: bool = False,
    ppi: float | None = None,
) -> Any:  # fmt: skip
    """Return what Typst makes of `reports/<template>` and `data`; the same bytes for the same data.

    Parameters: `standard` such as "ua-1" (checked while compiling); `everything` also uses the fonts of the machine; `ppi` are
    the dots an inch of a PNG.
    Raises `typst.TypstError` as it comes; `OutputError` where Typst is not installed.
    """
    place = folder("reports")
    if kind == "pdf":
        _forget()
    return _typst().compile(
        sources(template, data),
        font_paths=_fonts(everything),
        root=str(place),
        format=kind,
        ppi=ppi,
        timestamp=0,
        pdf_standards=[standard] if standard else [],
    )


def sources(template: str, data: Any) -> dict[str, bytes]:
    """Return what Typst does not read from the folder: the page that is the template, and its data as a file.

    As a value told to Typst, data would be part of all that it knows, and nothing of the report before could be taken over.
    Typst parses every file as a source of its own too: what follows two slashes on a line is a remark there, and soon read.
    """
    return {"main.typ": f'#include "{template}"'.encode(), "data.json": json.dumps(["//", data], ensure_ascii=False).encode()}


def refusal(error: RuntimeError) -> CourseworkError:
    """Return what is told of a `typst.TypstError`: by which own piece of the instructor it came, else that no page was set."""
    told = " ".join(str(error).split())
    found = _PLACE.search(getattr(error, "diagnostic", ""))
    if found and (name := found["name"]) in templates_in_use():
        return InputError([failing_piece(name, int(found["line"]), told)])
    return OutputError(say("fault.W015", refused=told[:2000]))


def _forget() -> None:
    """Let Typst drop what only earlier reports had use for."""
    with _ALONE:
        for _ in range(EMPTY):
            _empty().compile(b"", format="svg")


@cache
def _empty() -> typst.Compiler:
    compiler: typst.Compiler = _typst().Compiler(b"", root=str(folder("reports")), font_paths=_fonts(everything=False))
    return compiler
