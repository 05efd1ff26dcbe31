"""Functions whose modules are imported only when they are called, also those of a layer above.

Enters: a module below `coursework` and a name in it.  Leaves: a function.  Used by `formats.py`, `sections.py` and `options.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any


def late(module: str, name: str) -> Callable[..., Any]:
    """Return the function `name` of a module, which is imported when the function is called."""

    def called(*given: Any) -> Any:
        return getattr(import_module(f"coursework.{module}"), name)(*given)

    called.__name__ = name
    return called
