"""Where the files that are no code lie: the variants and the looks of a page.

Enters: the name of a folder.  Leaves: its path.  Any floor may ask.
"""

from __future__ import annotations

from pathlib import Path


def folder(name: str) -> Path:
    """Return the folder `name` ("variants", "reports"): inside the installed package, else beside it in a checkout.

    Raises `FileNotFoundError` where neither exists (a broken installation).
    """
    package = Path(__file__).resolve().parent
    for place in (package / name, package.parent / name):
        if place.is_dir():
            return place
    raise FileNotFoundError(f'the folder "{name}" is missing beside {package}. Install the package again.')
