"""`--templates DIR`: an instructor's own pieces of pages, checked before they are used.

Enters: a folder, or None.  Leaves: a context that uses its pieces.  Raises `InputError`.  Used by `options.py` and `several.py`.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path, PurePath

from coursework.words.custom_templates import templates_in, templates_of
from coursework.words.data_folders import REPORTS, folder
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

STYLES = ("reference.docx", "reference.odt")  # a department's styles for notes; the package makes its own
MOST_BYTES = 4 * 2**20  # most bytes of one piece, as larger pages open badly


def with_templates(own: Path | None) -> AbstractContextManager[None]:
    """Return the context in which the pieces of `own` replace those of the package; None changes nothing."""
    if own is not None:
        _look_at(own)
    return templates_of(own)


def _look_at(own: Path) -> None:
    from coursework.words.templates import unreadable

    if not own.is_dir():
        raise InputError([Fault(say("fault.C061"), str(own))])
    found = [path.relative_to(own).as_posix() for path in templates_in(own)]
    place = folder(REPORTS)
    known = [path.relative_to(place).as_posix() for path in templates_in(place)]
    used = [
        name for name in found if name in known or PurePath(name).match("words.*.toml") or name in STYLES
    ]  # also words of another language
    if not used:
        advice = next((hint for name in found if (hint := closest(name, known))), "")
        raise InputError([Fault(say("fault.C062", advice=advice, known=tuple(sorted(known))), str(own))])
    if large := [name for name in used if (own / name).stat().st_size > MOST_BYTES]:
        raise InputError([Fault(say("fault.C063", most=MOST_BYTES // 2**20), str(own / large[0]))])
    if faults := [fault for name in used if (fault := unreadable(own / name))]:
        raise InputError(faults)
