"""One run of one variant: what was asked for, computed when it is looked at.

Enters: a `Variant` and settings.  Leaves: `Run`.  `load`, `solve` and `exact` are what `import coursework` offers.
"""

from __future__ import annotations

import platform
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.catalogue import find
from coursework.errors import InputError
from coursework.graph import Plan, Values, make_plan
from coursework.motion import Motion, Stop
from coursework.quantities import ASKABLE, DEFAULT, QUANTITIES
from coursework.schemes import SCHEMES
from coursework.settings import Settings
from coursework.variant.reader import MAX_ROWS, read_variant
from coursework.variant.record import Variant

if TYPE_CHECKING:
    import pandas as pd

    from coursework.checks.result import Check


@dataclass(frozen=True, slots=True)
class Run:
    """A run: `variant` (with the step and end used), `settings`, `asked` quantities, and `values` computed on demand.

    `table` is a pandas frame (index t); `checks` the judged facts; `stop` why the motion ended early, or None.
    """

    variant: Variant
    settings: Settings
    asked: tuple[str, ...]
    values: Values = field(repr=False)
    student: str | None = None
    group: str | None = None
    date: str | None = None

    @property
    def motion(self) -> Motion:
        """Return the rows of the scheme."""
        motion: Motion = self.values["motion"]
        return motion

    @property
    def exact(self) -> Motion:
        """Return the motion without the scheme's error, on the same rows."""
        exact: Motion = self.values["exact"]
        return exact

    @property
    def checks(self) -> tuple[Check, ...]:
        """Return the checks."""
        checks: tuple[Check, ...] = self.values["checks"]
        return checks

    @property
    def stop(self) -> Stop | None:
        """Return why the motion ended before its time."""
        return self.motion.stop

    @property
    def passed(self) -> bool:
        """Return whether the motion reached its end and no computed check failed."""
        judged = self.checks if "checks" in self.asked else ()
        return self.stop is None and all(check.verdict in {"PASS", "SKIP"} for check in judged)

    @property
    def table(self) -> pd.DataFrame:
        """Return the results table: index t (s), columns as in the file, then accelerations and points if asked for."""
        import pandas as pd

        names, rows = self.columns()
        return pd.DataFrame(rows, index=pd.Index(self.motion.t, name="t"), columns=list(names))

    def columns(self) -> tuple[tuple[str, ...], np.ndarray[Any, np.dtype[np.float64]]]:
        """Return names and rows of the table after t, accelerations and points included where asked for."""
        return gather(self.motion, self.asked, self.values)

    @property
    def plan(self) -> Plan:
        """Return what is computed for the asked quantities and what is left out."""
        return make_plan(QUANTITIES, wanted(self.asked), ("variant", "settings"))

    @property
    def versions(self) -> dict[str, str]:
        """Return the versions that made the numbers."""
        import sympy

        import coursework

        return {
            "coursework": coursework.__version__, "python": platform.python_version(),
            "numpy": np.__version__, "sympy": sympy.__version__,
        }  # fmt: skip

    def _repr_html_(self) -> str:
        shown = self.table.head(60).to_html(float_format=lambda value: f"{value:.6g}")
        note = f"<p>{_escaped(self.stop.sentence)}</p>" if self.stop else ""
        return f"<h3>{_escaped(self.variant.title)}</h3><p>{SCHEMES[self.settings.scheme].title}, h = {self.motion.step:g} s</p>{note}{shown}"


def _escaped(text: str) -> str:
    import html

    return html.escape(text)


def wanted(asked: Iterable[str]) -> tuple[str, ...]:
    """Return the quantities to compute for what is asked: points bring their accelerations where both are asked for."""
    names = tuple(dict.fromkeys(asked))
    if {"points", "accelerations"} <= set(names):
        names = tuple("point_accelerations" if name == "points" else name for name in names)
    return names


def gather(motion: Motion, asked: Iterable[str], values: Mapping[str, Any] | Values) -> tuple[tuple[str, ...], Any]:
    """Return the columns of a motion, with those of the accelerations and points where asked for."""
    names, rows = motion.names, [motion.rows]
    if "accelerations" in asked:
        names += tuple(f"d{name}" for name in motion.velocity_names)
        rows.append(values["accelerations"])
    if "points" in asked:
        more, found = values["point_accelerations" if "accelerations" in asked else "points"]
        names += more
        rows.append(found)
    return names, np.hstack(rows)


def load(path_or_name: str | Path) -> Variant:
    """Return the variant of a file or of the catalogue.  Raises `InputError` with every fault."""
    return read_variant(find(path_or_name))


def solve(
    variant: Variant | str | Path,
    scheme: str = "euler",
    step: float | None = None,
    end: float | None = None,
    *,
    quantities: Iterable[str] | None = None,
    project: int = 0,
    gain: float = 0.0,
    student: str | None = None,
    group: str | None = None,
    date: str | None = None,
) -> Run:
    """Return a run of a variant.

    `scheme` one of `SCHEMES`; `step` and `end` in s (those of the file where None); `quantities` asked for (those of the
    file where None; names of columns restrict the table to them); `project` Newton corrections a step; `gain` of
    Baumgarte's correction in 1/s.  Raises `InputError`.
    """
    chosen = load(variant) if isinstance(variant, (str, Path)) else variant
    chosen = _timed(chosen, step, end)
    asked, columns = _sorted(chosen, quantities)
    settings = Settings(scheme, project, gain, columns).checked(chosen.time.step)
    values = Values(QUANTITIES, {"variant": chosen, "settings": settings})
    return Run(chosen, settings, asked, values, student, group, date)


def exact(
    variant: Variant | str | Path, step: float | None = None, end: float | None = None, *, quantities: Iterable[str] | None = None
) -> pd.DataFrame:
    """Return the table of the exact motion (index t), with the same columns as `solve(variant).table`."""
    import pandas as pd

    run = solve(variant, step=step, end=end, quantities=quantities)
    motion = run.exact
    # The quantities of a motion do not care which motion it is: they are computed for the exact rows here.
    values = Values(QUANTITIES, {**run.values.values, "motion": motion})
    names, rows = gather(motion, run.asked, values)
    return pd.DataFrame(rows, index=pd.Index(motion.t, name="t"), columns=list(names))


def _timed(variant: Variant, step: float | None, end: float | None) -> Variant:
    h = step if step is not None else variant.time.step
    last = end if end is not None else variant.time.end
    if not (np.isfinite(h) and h > 0):
        raise InputError(f"the step must be greater than 0, found {h:g} s.")
    if not (np.isfinite(last) and last >= h * (1 - 1e-9)):
        raise InputError(f"the end ({last:g} s) must be at least one step ({h:g} s).")
    if last / h > MAX_ROWS:
        raise InputError(f"{last / h:.3g} rows are asked for; at most {MAX_ROWS} are computed. Take a larger step.")
    return variant.timed(h, last)


def _sorted(variant: Variant, quantities: Iterable[str] | None) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Split what is asked for into quantities and columns of the table."""
    listed = tuple(quantities) if quantities is not None else variant.ask or DEFAULT
    columns = tuple(name for name in listed if name in variant.columns)
    asked = tuple(name for name in listed if name not in columns)
    unknown = [name for name in asked if name not in ASKABLE]
    if unknown:
        from coursework.errors import closest

        known = ", ".join(ASKABLE)
        raise InputError(
            f'there is no quantity "{unknown[0]}".{closest(unknown[0], [*ASKABLE, *variant.columns])} Known: {known}.'
        )
    return asked or ("table",), columns
