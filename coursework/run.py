"""A run as users get it: its table as a pandas frame, its points, its plots, its form in a notebook.

Enters: a `Scene` and the names asked for, from `api.py`.  Leaves: `Run`.
Used by `api.py` and `commands/`; lower layers make pages and files from it as a `SceneRun`.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursework.motion.settings import stepping
from coursework.scene.motion_results import MotionResults
from coursework.scene.quantities import Quantity, known_quantities, no_quantity
from coursework.scene.scene_run import SceneRun
from coursework.system.files.whole_files import write_bytes, wrong_ending
from coursework.system.frozen import frozen
from coursework.system.on_demand import Plan
from coursework.variant.record.variant import changed
from coursework.words.errors import CourseworkError, InputError, visible
from coursework.words.sentences import say

if TYPE_CHECKING:
    import pandas as pd

    from coursework.results.accuracy.round_off import RoundOffRow
    from coursework.takeaway.findings import Findings
    from coursework.takeaway.frames import ExactRows
    from coursework.takeaway.study import Study


@frozen
class Advice:
    """Advice for a table that is coarse: a `step` (s), or a `scheme` with the same step, that suffices; None if not found."""

    step: float | None
    scheme: str | None
    sentence: str


@dataclass(frozen=True, repr=False, eq=False)
class Run(SceneRun):
    """A run: `scene` (variant, settings and motion) and the names `asked` for; results are computed when they are read.

    `table` is a pandas frame (index t); `checks` are the checks with their verdicts; `stop` is why the motion ended early, or
    None; `of(QUANTITY)` returns any quantity, by its record or its name.  `timed`, if given, is the study of accuracy with
    running times, and replaces the one without.

    >>> import coursework
    >>> run = coursework.solve("31", scheme="rk4", quantities=["table", "checks"])
    >>> run.table.shape, run.stop, run.passed
    ((25, 7), None, True)
    >>> run.points["B"].acceleration.shape  # m/s², x and y
    (25, 2)
    """

    precision: str = "double"

    def framed(self, results: MotionResults) -> pd.DataFrame:
        """Return the columns of a motion as a frame: index t (s), units, variant and scheme in `attrs`."""
        import pandas as pd

        from coursework.takeaway.frames import time_index

        motion, (names, rows) = results.motion, self.columns_of(results)
        table = pd.DataFrame(rows, index=time_index(motion.t), columns=list(names))
        table.attrs = {"variant": self.variant.name, "scheme": motion.scheme, "units": self.units_of(results)}
        return table

    @property
    def table(self) -> pd.DataFrame:
        """Return the results table: index t (s), columns as in the file, then accelerations and points if asked for.

        Angles are in rad, slides in m, rates in rad/s and m/s; `table.attrs["units"]` has the unit of each column.
        """
        return self.framed(self.results)

    @property
    def points(self) -> pd.DataFrame:
        """Return the points of the rows: columns (point, quantity, axis) in m, m/s, m/s²; `.points["B"].velocity` is (n, 2)."""
        from coursework.takeaway.frames import point_frame

        return point_frame(self.scene, self.motion)

    @cached_property
    def exact(self) -> ExactRows:
        """Return the motion without the scheme's error on the same rows, `.at(t)` between them, `.points` its points."""
        from coursework.takeaway.frames import exact_rows

        return exact_rows(self.scene, self.scene.exact)

    @cached_property
    def checks(self) -> Findings:
        """Return the finding of each check."""
        from coursework.takeaway.findings import Findings

        return Findings(super().checks)

    @property
    def accuracy(self) -> Study:
        """Return the study of accuracy against cost, also if it was not asked for.

        Raises `InputError` where the motion stops or passes a singular position, and for a restricted table.
        """
        from coursework.takeaway.study import study_of

        if self.study is None:
            raise InputError(say("fault.D039"))
        return study_of(self.study, self)

    @property
    def remarks(self) -> tuple[str, ...]:
        """Return the likely slips in the file, and a remark if the last row is not at the end asked for."""
        end = self.variant.time.end
        told = str(say("remark.last_row", last=self.end, end=end))
        return (*self.slips, *([told] if self.end != end and told not in self.slips else []))

    @property
    def slips(self) -> tuple[str, ...]:
        """Return the sentences on likely slips in the file."""
        return tuple(str(remark.sentence) for remark in self.variant.plausibility)

    @property
    def advice(self) -> Advice:
        """Return the step or scheme that suffices if the table is coarse; without step and scheme if it is not."""
        coarse = [check for check in self.results.checks if check.option]
        if not coarse:
            return Advice(None, None, "")
        first = coarse[0]
        return Advice(first.step, first.scheme or None, str(first.advised))

    @property
    def round_off(self) -> pd.DataFrame:
        """Return the effect of round-off: by number of steps, the error (rad or m) in double, single, and single with t += h."""
        import pandas as pd

        rows = list(self.round_off_rows())
        listed = {name: [getattr(row, name) for row in rows] for name in ("double", "single", "running")}
        return pd.DataFrame(listed, index=pd.Index([row.steps for row in rows], name="steps"))

    def round_off_rows(self) -> Iterator[RoundOffRow]:
        """Yield the rows of `round_off` as they are found.  Raises `InputError` for a motion that stops or that forces give."""
        import numpy as np

        from coursework.results.accuracy.round_off import round_off_curve

        if self.stop is not None:
            raise self.stop.refusal
        if self.variant.motor is not None:
            raise InputError(say("fault.D040"))
        scheme, rates = stepping(self.variant, self.scheme), self.scene.rates
        end = np.array([self.exact.column(name)[-1] for name in rates.coordinates])
        return round_off_curve(rates, scheme, self.scene.begin, self.step, len(self.motion.t) - 1, end)

    @property
    def end(self) -> float:
        """Return the time of the last row asked for (s), which a motion that stops does not reach."""
        return self.variant.time.last

    @property
    def passed(self) -> bool:
        """Return whether the motion reached its end and no check failed; COARSE is not a failure."""
        return self.status() == 0

    @property
    def plan(self) -> Plan:
        """Return the plan: what is computed for the quantities asked for, and what is left out."""
        return self.plan_with()

    def of(self, quantity: Quantity[Any] | str) -> Any:
        """Return a quantity of the rows, by its record or by its name.  Raises `InputError` for an unknown name."""
        if isinstance(quantity, str):
            if quantity not in known_quantities():
                raise InputError(no_quantity(quantity))
            quantity = known_quantities()[quantity]
        return super().of(quantity)

    def compute(self) -> Run:
        """Return the run after computing everything asked for, so that a worker process can send it back complete."""
        for name in self.asked:
            self.of(name)
        return self

    def plot(self, *names: str, exact: bool = False, ax: Any = None) -> Any:
        """Return Axes with columns against time; with `exact`, the exact motion as a line beside the rows.

        Columns are those of the table, accelerations ("dw3") and points ("B.x", "B.vx", "B.ax"), asked for or not.
        Returns one Axes if all `names` (the velocities if none are given) have one unit, else an array with one per unit.
        Draws into `ax` if it is given.  Raises `InputError` for an unknown name.

        >>> import coursework
        >>> axes = coursework.solve("31").plot("w3", exact=True)
        >>> axes.get_ylabel(), [line.get_label() for line in axes.lines]
        ('ω₃, rad/s', ['explicit Euler', 'exact motion'])
        """
        from coursework.takeaway.plots import plot_run

        return plot_run(self, names, exact, ax)

    def to_excel(self, path: Path | str, *, language: str = "en") -> None:
        """Write the workbook that computes: data, table as formulas, the exact motion, checks and graphs.

        Raises `NotToBeHad` without XlsxWriter, or if the rows follow no formula; `OutputError` for a path that cannot be
        written or does not end in .xlsx.

        >>> from pathlib import Path
        >>> from tempfile import TemporaryDirectory
        >>> import coursework
        >>> with TemporaryDirectory() as folder:
        ...     coursework.solve("31").to_excel(Path(folder, "31.xlsx"))
        ...     [file.name for file in Path(folder).iterdir()]
        ['31.xlsx']
        """
        from coursework.takeaway.workbook.book import workbook_of

        target = Path(path)
        if target.suffix.lower() != ".xlsx":
            raise wrong_ending(target, ".xlsx")
        write_bytes(target, workbook_of(self, language))

    def __repr__(self) -> str:
        ends = f"0 to {self.end:g} s"
        with suppress(CourseworkError, ArithmeticError, ValueError):
            if (stop := self.scene.stop) is not None:
                ends = f"stops at {stop.time:.4g} s"
        name = f"{visible(self.variant.name)}{changed(self.variant.set_values)}"
        return f"<Run of {name}: {self.scheme}, h = {self.step:g} s, {ends}>"

    def _repr_html_(self) -> str:
        from coursework.report.pages.notebook import notebook_html

        return notebook_html(self)

    def __getstate__(self) -> dict[str, Any]:
        return {one.name: getattr(self, one.name) for one in fields(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name, value in state.items():
            object.__setattr__(self, name, value)

    def _made_of(self) -> tuple[object, ...]:
        others = (getattr(self, one.name) for one in fields(self) if one.name != "scene")
        return (self.scene.variant, self.scene.settings, *others)

    def __eq__(self, other: object) -> bool:
        return self._made_of() == other._made_of() if isinstance(other, Run) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.variant.name, self.settings, self.asked))
