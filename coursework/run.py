"""A run as a person holds it: its table as a pandas frame, what a notebook shows of it.

Enters: a `Scene` and the names asked for, from `api.py`.  Leaves: `Run`.
Used by `api.py` and `commands/`; the floors below make pages and files of the `SceneRun` that it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from coursework.scene.scene_run import SceneRun
from coursework.system.on_demand import Plan
from coursework.words.errors import visible

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, slots=True, repr=False)
class Run(SceneRun):
    """A run: `scene` (variant, settings and the way to the motion), the names `asked` for, computed when looked at.

    `table` is a pandas frame (index t); `checks` the judged facts; `stop` why the motion ended early, or None; `of(QUANTITY)`
    anything that can be asked for.  `timed` replaces the study of accuracy by one with seconds.

    >>> import coursework
    >>> run = coursework.solve("31", scheme="rk4", quantities=["table", "checks"])
    >>> run.table.shape, run.stop, run.passed
    ((25, 7), None, True)
    """

    @property
    def table(self) -> pd.DataFrame:
        """Return the results table: index t (s), columns as in the file, then accelerations and points if asked for."""
        import pandas as pd

        names, rows = self.columns()
        return pd.DataFrame(rows, index=pd.Index(self.motion.t, name="t"), columns=list(names))

    @property
    def passed(self) -> bool:
        """Return whether the motion reached its end and no check failed; COARSE is no failure."""
        return self.status() == 0

    @property
    def plan(self) -> Plan:
        """Return what is computed for the asked quantities and what is left out."""
        return self.plan_with()

    def __repr__(self) -> str:
        names = ", ".join((*self.asked, *self.settings.columns))
        return (
            f"<Run of {visible(self.variant.name)}: {self.scheme}, h = {self.step:g} s, 0 to {self.end:g} s, asked for {names}>"
        )

    def _repr_html_(self) -> str:
        from coursework.report.pages import notebook_html

        return notebook_html(self)
