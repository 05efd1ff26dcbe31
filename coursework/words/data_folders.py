"""Where the files that are no code lie: the variants and the looks of a page.

Enters: the name of a folder.  Leaves: a path.  Any floor may ask.
Used by `catalogue.py`, `custom_templates.py`, `templates.py`, `sentences.py`, `assigning/` and `commands/`.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

REPORTS = "reports"
standing_in: list[Path] = []  # an instructor's own pieces of `reports/`, the innermost last (`custom_templates.py`)


def folder(name: str) -> Path:
    """Return the folder `name` ("variants", "reports"): inside the installed package, else beside it in a checkout.

    Raises `FileNotFoundError` where neither exists (a broken installation).
    """
    return standing_in[-1] if name == REPORTS and standing_in else folder_of_package(name)


@cache
def folder_of_package(name: str) -> Path:
    """Return the folder `name` as it came with the package.  Raises `FileNotFoundError` as `folder` does."""
    package = Path(__file__).resolve().parents[1]
    for place in (package / name, package.parent / name):
        if place.is_dir():
            return place
    raise FileNotFoundError(f'the folder "{name}" is missing beside {package}. Install the package again.')
