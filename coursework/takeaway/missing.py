"""A package that a format needs and that is not installed here.

Enters: its name and that of its extra.  Leaves: `NotToBeHad` with the line that installs it.  Used by `figures/`.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec

from coursework.system.extras import installed_from
from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say


def require(module: str, format_name: str, extra: str) -> None:
    """Raise `NotToBeHad` where a module cannot be found."""
    if find_spec(module) is None:
        folder = installed_from(extra)
        raise NotToBeHad(say("fault.W040", format=format_name, package=module, python=sys.executable, folder=folder))
