"""Names in a platform's download -> the student they belong to; and feedback packed under them, as Moodle wants it.

Enters: the name of a folder or file.  Leaves: `Owner`, None if the name is not the platform's.
Used by `file_lists.py` and by the code that grades a class.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from pathlib import PurePosixPath

from coursework.grading.platforms.moodle_times import MOODLE
from coursework.grading.platforms.names import file_stem
from coursework.system.files.zipped import zipped
from coursework.system.frozen import frozen

# Moodle's importer reads "fullname_uniqueid_assignsubmission_plugin", then nothing, or in flat mode the file's own name.
_MOODLE = re.compile(
    r"(?P<owner>(?P<name>.*?)_(?P<number>[0-9]+)_assignsubmission_(?P<plugin>[a-z]+))(?:_(?P<rest>.*))?", re.DOTALL
)
# Canvas writes "name_LATE_user_attachment_file", and of a text typed there "name_LATE_user_text.html"; while marking is anonymous
# "LATE_anon_id" stands for name and user, where the id is a few letters and digits.
_CANVAS = re.compile(
    r"(?:(?P<late>LATE_)?(?P<anonymous>anon_[0-9A-Za-z]+)|(?P<name>[^_]+)(?P<delayed>_LATE)?_(?P<user>[0-9]+))"
    r"_(?:(?P<attachment>[0-9]+)_(?P<rest>.+)|(?P<typed>(?:text|link)\.html))",
    re.DOTALL,
)


@frozen
class Owner:
    """The owner of a folder or file: a `key` equal for all work of one student, the platform's number, the name given there.

    `attachment` is the platform's number of the file, "" if it has none; `folder` is the name under which feedback is returned;
    `file` is the name a file had before the platform changed it ("" for a folder); `late`: the platform marks it as late.
    """

    key: str
    number: str
    name: str | None
    attachment: str
    folder: str
    file: str
    late: bool = False


def moodle_owner(name: str) -> Owner | None:
    """Return the owner of a folder or file in Moodle's download, None if the name is not Moodle's.

    >>> moodle_owner("Ann Lee_7000_assignsubmission_file_table.csv").number
    '7000'
    """
    plain = unicodedata.normalize("NFC", name)
    match = _MOODLE.fullmatch(plain)
    if not match:
        return None
    full = match["name"].strip()
    shown = None if full.casefold() in MOODLE["anonymous"] or not full else full
    rest = match["rest"] or ""
    folder = match["owner"] if rest else plain
    return Owner(f"{match['name']}_{match['number']}", match["number"], shown, "", folder, rest)


def canvas_owner(name: str) -> Owner | None:
    """Return the owner of a file in Canvas's download, None if the name is not Canvas's.

    >>> canvas_owner("leeann_LATE_101_20777_table-1.csv").file
    'table-1.csv'
    >>> canvas_owner("anon_aB3xY_20777_table.csv").key
    'anon_aB3xY'
    """
    match = _CANVAS.fullmatch(unicodedata.normalize("NFC", name))
    if not match:
        return None
    # An anonymous id may consist of digits, but is nobody's number.
    key, number = match["anonymous"] or match["user"], match["user"] or ""
    late = bool(match["late"] or match["delayed"])
    return Owner(key, number, match["name"], match["attachment"] or "", "", match["rest"] or match["typed"], late)


def feedback_zip(pages: Iterable[tuple[str, str, bytes]]) -> bytes:
    """Return a zip of pages (folder of the download, id, page), each named `feedback-ID.html`; sorted, without times."""
    tops = ((PurePosixPath(folder.replace("\\", "/")).name, student, page) for folder, student, page in sorted(pages))
    return zipped(((f"{top}/feedback-{file_stem(student)}.html", page) for top, student, page in tops), 0o644)
