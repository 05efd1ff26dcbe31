"""Euler-scheme teaching tool for two-degree-of-freedom mechanism coursework.

    import coursework
    run = coursework.solve("31")        # Run: .table (pandas), .checks, .stop
    coursework.exact("31")              # the same table without the scheme's error
    coursework.write_report(run, "report.html")

Nothing is imported until it is used: `coursework --help` must not wait for NumPy.

Changes.  1.0.0: the first version.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from coursework.system.version import VERSION

if TYPE_CHECKING:
    from coursework import procedures
    from coursework.api import exact, solve
    from coursework.assigning.variants import draw, draw_many
    from coursework.many import Solutions, feasible, feasible_many, solve_many
    from coursework.mechanism import groups
    from coursework.motion.schemes import SCHEMES
    from coursework.report.output.write import write_report
    from coursework.report.pages.notebook import notebook_html
    from coursework.run import Run
    from coursework.scene.model.data import Data
    from coursework.scene.model.model import Model, compile_model
    from coursework.variant.catalogue import load, names
    from coursework.variant.reading.reader import parse_variant
    from coursework.variant.record.variant import Variant
    from coursework.words.errors import CourseworkError, CourseworkWarning, InputError, OutputError

__version__ = VERSION

_HOMES = {
    "coursework.api": ("solve", "exact"),
    "coursework.many": ("solve_many", "feasible", "feasible_many", "Solutions"),
    "coursework.run": ("Run",),
    "coursework.motion.schemes": ("SCHEMES",),
    "coursework.assigning.variants": ("draw", "draw_many"),
    "coursework.scene.model.model": ("Model", "compile_model"),
    "coursework.variant.catalogue": ("load", "names"),
    "coursework.scene.model.data": ("Data",),
    "coursework.report.output.write": ("write_report",),
    "coursework.report.pages.notebook": ("notebook_html",),
    "coursework.variant.record.variant": ("Variant",),
    "coursework.variant.reading.reader": ("parse_variant",),
    "coursework.words.errors": ("CourseworkError", "CourseworkWarning", "InputError", "OutputError"),
}
_ROOMS = {"groups": "coursework.mechanism.groups", "procedures": "coursework.procedures"}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}

__all__ = [
    "SCHEMES", "CourseworkError", "CourseworkWarning", "Data", "InputError", "Model", "OutputError", "Run", "Solutions",
    "Variant", "compile_model", "draw", "draw_many", "exact", "feasible", "feasible_many", "groups", "load", "names",
    "notebook_html", "parse_variant", "procedures", "solve", "solve_many", "write_report",
]  # fmt: skip


if not TYPE_CHECKING:  # so that type checkers know every existing name, and no other

    def __getattr__(name: str) -> Any:
        if name in _HOME_OF:
            return getattr(import_module(_HOME_OF[name]), name)
        if name in _ROOMS:
            return import_module(_ROOMS[name])
        raise AttributeError(f"module 'coursework' has no attribute '{name}'")


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
