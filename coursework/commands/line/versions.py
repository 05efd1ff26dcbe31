"""`coursework --versions`: the installed packages of each extra.

Enters: nothing.  Leaves: one line per extra.  Used by `options.py`.
"""

from __future__ import annotations

import os
import platform
from importlib.metadata import PackageNotFoundError, version

from coursework.commands.line.screen import in_language, speak, tell
from coursework.system.extras import OWN, installing_extra, packages
from coursework.system.version import VERSION
from coursework.words.sentences import ENGLISH, joined, say


def tell_versions() -> None:
    """Print the package versions of each extra, and the command that installs missing packages."""
    speak(os.environ.get("COURSEWORK_LANGUAGE") or ENGLISH)
    tell(f"{OWN} {VERSION}, Python {platform.python_version()}")
    for extra, named in packages().items():
        found = {name: _version(name) for name in named}
        there = joined([f"{name} {number}" for name, number in found.items() if number], "join.comma")
        missing = joined([name for name, number in found.items() if not number], "join.comma")
        line = say("screen.missing", packages=missing, command=installing_extra(extra)) if missing else ""
        tell(f"{extra:<9} {in_language(joined([there, line], 'join.semicolon'))}")


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
