"""The extras of the package: what is in each, and what to type where a package of one is missing.

Enters: the name of an extra.  Leaves: its packages; what pip installs it from.  Used by `commands/` and `takeaway/`.
"""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROJECT = ROOT / "pyproject.toml"
OWN = "coursework"
_OF_EXTRA = re.compile(r"([\w.-]+).*extra == ['\"](\w+)['\"]")


def installed_from(extra: str) -> str:
    """Return what pip installs the extra from: the folder of the checkout, else the package by its name."""
    return f'"{ROOT}[{extra}]"' if PROJECT.is_file() else f'"{OWN}[{extra}]"'


def packages() -> dict[str, list[str]]:
    """Return the packages of every extra, by the checkout where there is one: what is installed may be older than it."""
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
