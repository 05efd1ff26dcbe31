"""What to type where a package of an extra is missing.

Enters: the name of an extra.  Leaves: what pip installs it from.  Used by `commands/desk.py` and `takeaway/`.
"""

from __future__ import annotations

from pathlib import Path


def installed_from(extra: str) -> str:
    """Return what pip installs the extra from: the folder of the checkout, else the package by its name."""
    root = Path(__file__).resolve().parents[2]
    return f'"{root}[{extra}]"' if (root / "pyproject.toml").is_file() else f'"coursework[{extra}]"'
