"""The ways in which a quantity is shown: as columns, as a table or drawings of its own, in a section of the page.

Enters: the results of a motion.  Leaves: one class for each way.  Used by `quantities.py` and `scene_run.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from typing import TYPE_CHECKING, ClassVar, Generic, TypeVar

from coursework.scene.motion_results import MotionResults
from coursework.system.frozen import frozen

if TYPE_CHECKING:
    from coursework.drawing.paper.record import Drawing
    from coursework.results.kinematics.extra import ExtraTable

T = TypeVar("T")


@frozen
class Columns(Generic[T]):
    """Shown as columns beside those of the results table; `on_page` selects the columns that a page prints."""

    kind: ClassVar[str] = "columns"
    of: Callable[[MotionResults, T], ExtraTable]
    on_page: Callable[[ExtraTable], ExtraTable] = field(default=lambda table: table)


@frozen
class OwnTable(Generic[T]):
    """Shown as a table of its own, whose rows are not those of the results table."""

    kind: ClassVar[str] = "table"
    of: Callable[[MotionResults, T], ExtraTable]


@frozen
class OwnFigure(Generic[T]):
    """Shown as drawings; `of` also takes the function that puts a sentence into the language of the page.

    `lines` makes those of `polygons.csv`, their numbers in full precision; None if they have none of their own.
    """

    kind: ClassVar[str] = "figure"
    of: Callable[[MotionResults, T, Callable[[str], str]], tuple[Drawing, ...]]
    lines: Callable[[T], Iterable[tuple[object, ...]]] | None = None


@frozen
class OwnSection(Generic[T]):
    """Shown in a section of its own on the page (`report/sections.py`); `table` gives its CSV file, None if it has none."""

    kind: ClassVar[str] = "section"
    table: Callable[[MotionResults, T], ExtraTable] | None = None
    lines: Callable[[T], Iterable[tuple[object, ...]]] | None = None
