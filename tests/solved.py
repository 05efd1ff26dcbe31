"""Runs of the catalogue, each solved once a process, and what several ask of one scene computed once; nobody changes them.

Not for tests of the computing itself, of its plan or its ledger: those solve anew.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import coursework
from coursework.motion.settings import Settings
from coursework.run import Run
from coursework.scene.scene import Scene
from coursework.variant.record.variant import Variant

# Files of the catalogue, each read once a process: several lists of tests are made from all of them.
loaded = cache(coursework.load)
_scenes: dict[tuple[Variant, Settings], Scene] = {}


@cache
def _solved(variant: str, options: tuple[tuple[str, Any], ...]) -> Run:
    run = coursework.solve(variant, **dict(options))
    return replace(run, scene=_scenes.setdefault((run.variant, run.settings), run.scene))


def solved(variant: str, **options: Any) -> Run:
    """Return the run of a variant of the catalogue."""
    return _solved(variant, tuple((key, tuple(value) if isinstance(value, list) else value) for key, value in options.items()))
