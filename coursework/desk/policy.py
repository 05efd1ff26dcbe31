"""The policy of a department for its desk, from a small TOML file.

    equations = false            # the desk does not write the equations for the student
    exact = false                # no table without the scheme's error
    formats = ["html", "csv"]    # the formats that can be downloaded
    language = "uk"              # used in place of the browser's language

Enters: a path.  Leaves: `Policy`.  Raises `InputError` with every fault.  Used by `commands/desk.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

from coursework.desk.job import Policy
from coursework.report.output.formats import chosen
from coursework.variant.toml.source import read_bytes, read_source
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, load_phrases, say


def read_policy(path: Path) -> Policy:
    """Return the policy in a file.  Raises `InputError`."""
    source = read_source(read_bytes(path), str(path), {})
    if faults := list(_faults(source.data)):
        raise InputError([Fault(fault, str(path), source.positions.find((key,), key=True)[0]) for key, fault in faults])
    read: dict[str, Any] = {key: tuple(value) if isinstance(value, list) else value for key, value in source.data.items()}
    return Policy(**read)


def _faults(data: dict[str, Any]) -> Iterator[tuple[str, Sentence]]:
    known = [field.name for field in fields(Policy)]
    for key, value in data.items():
        try:
            if key not in known:
                yield key, say("fault.C082", key=key, hint=closest(key, known) or say("hint.known", known=", ".join(known)))
            elif key == "language":
                load_phrases(str(value))
            elif key == "formats":
                chosen([str(one) for one in (value if isinstance(value, list) else [value])], "run")
            elif not isinstance(value, bool):
                yield key, say("fault.C083", key=key, found=str(value)[:40])
        except InputError as error:  # the functions called here name an unknown language or format
            yield from ((key, fault.message) for fault in error.faults)
