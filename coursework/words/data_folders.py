"""The folders of files that are not code: the variants and the templates of pages.

Enters: the name of a folder.  Leaves: a path.  Any floor may use it.
Used by `catalogue.py`, `custom_templates.py`, `templates.py`, `sentences.py`, `assigning/` and `commands/`.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

REPORTS = "reports"
standing_in: list[Path] = []  # folders in place of `reports/`, the innermost context last (`custom_templates.py`)


def folder(name: str) -> Path:
    """Return the folder `name` ("variants", "reports"), with an instructor's own pieces if they are in use.

    Raises `FileNotFoundError` if the package has no such folder (a broken installation).
    """
    return standing_in[-1] if name == REPORTS and standing_in else folder_of_package(name)


@cache
def folder_of_package(name: str) -> Path:
    """Return the folder `name` in the package, else beside it in a checkout.  Raises `FileNotFoundError` as `folder` does."""
    package = Path(__file__).resolve().parents[1]
    for place in (package / name, package.parent / name):
        if place.is_dir():
            return place
    raise FileNotFoundError(f'the folder "{name}" is missing beside {package}. Install the package again.')
