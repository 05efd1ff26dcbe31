"""The operating system's reason why a file or an address could not be used, in the reader's language.

Enters: the exception.  Leaves: `reason_of`.  Used by whoever opens or writes a file that a person named.
"""

from __future__ import annotations

import errno

from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_REASONS = {
    errno.ENOENT: "missing", errno.ENOTDIR: "no_folder", errno.EISDIR: "folder", errno.EEXIST: "exists",
    errno.EADDRNOTAVAIL: "address", **dict.fromkeys((errno.EACCES, errno.EPERM), "access"),
}  # fmt: skip


def reason_of(error: Exception) -> Sentence | str:
    """Return why, as a sentence if it is a usual reason, else as the operating system tells it.

    >>> str(reason_of(PermissionError(13, "Permission denied", "a.csv"))), reason_of(OSError(5, "Input/output error"))
    ('access is denied', 'Input/output error')
    """
    import socket  # imported here, as loading it takes 3 ms and few runs have anything to tell

    if isinstance(error, (socket.gaierror, UnicodeError)):
        return say("reason.address")
    if isinstance(error, OSError) and (key := _REASONS.get(error.errno or 0)):
        return say(f"reason.{key}")
    return getattr(error, "strerror", None) or str(error)
