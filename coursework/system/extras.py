"""The optional extras of the package: which packages each contains, and how to install one that is missing.

Enters: the name of an extra.  Leaves: its packages, and the argument for pip that installs it.
Used by `report/`, `takeaway/`, `grading/`, `assigning/` and `commands/`.
"""

from __future__ import annotations

import re
import sys
from importlib.util import find_spec
from pathlib import Path

from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say

ROOT = Path(__file__).resolve().parents[2]
PROJECT = ROOT / "pyproject.toml"
OWN = "coursework"
_OF_EXTRA = re.compile(r"([\w.-]+).*extra == ['\"](\w+)['\"]")


def installed_from(extra: str) -> str:
    """Return the argument for pip that installs an extra: the folder of the checkout if there is one, else the package name."""
    return f'"{ROOT}[{extra}]"' if PROJECT.is_file() else f'"{OWN}[{extra}]"'


def installing(what: str) -> str:
    """Return the command that installs a package, or another argument of pip, into the Python that runs."""
    python = f'"{sys.executable}"' if " " in sys.executable else sys.executable
    return f"{python} -m pip install {what}"


def installing_extra(extra: str) -> str:
    """Return the command that installs the packages of an extra."""
    return installing(installed_from(extra))


def require(module: str, format_name: str, extra: str) -> None:
    """Raise `NotToBeHad`, with the line that installs it, if a `module` that a format needs cannot be found."""
    if find_spec(module) is None:
        raise NotToBeHad(say("fault.W040", format=format_name, package=module, command=installing_extra(extra)))


def packages() -> dict[str, list[str]]:
    """Return the packages of every extra; from the checkout if there is one, because the installed metadata may be older."""
    found: dict[str, list[str]] = {}
    for line in _requirements():
        if (one := _OF_EXTRA.match(line)) and one[2] != "all":
            found.setdefault(one[2], []).append(one[1])
    return found


def _requirements() -> list[str]:
    if not PROJECT.is_file():
        from importlib.metadata import requires

        return requires(OWN) or []
    import tomllib

    extras = tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    return [f"{line}; extra == '{extra}'" for extra, lines in extras.items() for line in lines]
