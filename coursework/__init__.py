"""Euler-scheme teaching tool for two-degree-of-freedom mechanism coursework.

    import coursework
    run = coursework.solve("31")        # Run: .table (pandas), .checks, .stop
    coursework.exact("31")              # the same table without the scheme's error
    coursework.write_report(run, "report.html")

Nothing is imported until it is used: `coursework --help` must not wait for SymPy.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from coursework import groups
    from coursework.api import compile_model, exact, load, solve
    from coursework.assigning.variants import draw, draw_many
    from coursework.many import Solutions, feasible, feasible_many, solve_many
    from coursework.model.data import Data
    from coursework.model.model import Model
    from coursework.output.write import write_report
    from coursework.report import notebook_html
    from coursework.run import Run
    from coursework.variant.reader import parse_variant
    from coursework.variant.record import Variant
    from coursework.words.errors import CourseworkError, InputError, OutputError

__version__ = "1.0.0"

_HOMES = {
    "load": "coursework.api", "solve": "coursework.api", "exact": "coursework.api", "compile_model": "coursework.api",
    "solve_many": "coursework.many", "feasible": "coursework.many", "feasible_many": "coursework.many",
    "draw": "coursework.assigning.variants", "draw_many": "coursework.assigning.variants",
    "Solutions": "coursework.many", "Model": "coursework.model.model", "Data": "coursework.model.data", "Run": "coursework.run",
    "write_report": "coursework.output.write", "notebook_html": "coursework.report", "Variant": "coursework.variant.record",
    "parse_variant": "coursework.variant.reader",
    "CourseworkError": "coursework.words.errors", "InputError": "coursework.words.errors",
    "OutputError": "coursework.words.errors",
}  # fmt: skip

__all__ = [
    "CourseworkError", "Data", "InputError", "Model", "OutputError", "Run", "Solutions", "Variant", "compile_model", "draw",
    "draw_many", "exact", "feasible", "feasible_many", "groups", "load", "notebook_html", "parse_variant", "solve",
    "solve_many", "write_report",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    if name == "groups":
        return import_module("coursework.groups")
    raise AttributeError(f"module 'coursework' has no attribute '{name}'")


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
