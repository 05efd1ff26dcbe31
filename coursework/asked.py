"""What was asked for of one motion, each by its record: columns beside the table, tables and drawings of their own.

Enters: `MotionResults` and the names asked for.  Leaves: rows, `ExtraTable`s, `Listing`s, `Drawing`s.
Used by `run.py` and `api.py`; an output iterates over what stands here and names no quantity.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.motion_results import MotionResults
from coursework.quantities import Columns, Listing, OwnFigure, OwnTable, Quantity, quantities_for

if TYPE_CHECKING:
    from coursework.drawing.paper.record import Drawing
    from coursework.results.kinematics.extra import ExtraTable

Names = tuple[str, ...]


def gather(results: MotionResults, asked: Names) -> tuple[Names, Any]:
    """Return the columns of a motion, with those of the quantities asked for that are columns."""
    names, rows = results.motion.names, [results.motion.rows]
    for *_, table in columns_beside(results, asked):
        names += table.names
        rows.append(table.rows)
    return names, np.hstack(rows)


def columns_beside(results: MotionResults, asked: Names) -> Iterator[tuple[str, Quantity[Any], ExtraTable]]:
    """Yield the names asked for, and their quantities, that stand as columns beside those of the results table."""
    for name, quantity in quantities_for(asked).items():
        if isinstance(quantity.shows, Columns):
            yield name, quantity, quantity.shows.of(results, quantity.compute.of(results))


def units_of(results: MotionResults, asked: Names) -> dict[str, str]:
    """Return the unit of each column of the results table, t and those beside it included."""
    motion, variant = results.motion, results.scene.variant
    units = {name: variant.unit_of(name) for name in ("t", *motion.names)}
    for *_, table in columns_beside(results, asked):
        units |= dict(zip(table.names, table.units, strict=True))
    return units


def page_tables(results: MotionResults, asked: Names) -> dict[str, ExtraTable]:
    """Return the tables asked for beside the results table, as a page prints them."""
    tables: dict[str, ExtraTable] = {}
    t = results.motion.t
    if len(t) < 2:
        return tables  # a motion that stops at once has nothing to tabulate beside its one row
    for name, quantity, table in columns_beside(results, asked):
        assert isinstance(quantity.shows, Columns)
        printed = quantity.shows.on_page(table)
        if printed.names:
            rows = np.column_stack([t, printed.rows])
            beside = replace(printed, names=("t", *printed.names), units=("s", *printed.units), rows=rows)
            tables[name] = replace(beside, sizes=(0.0, *printed.sizes)) if printed.sizes else beside
    return tables | own_tables(results, asked)


def own_tables(results: MotionResults, asked: Names) -> dict[str, ExtraTable]:
    """Return the tables asked for whose rows are not those of the results table."""
    records = ((one, one.shows) for one in quantities_for(asked).values())
    return {one.name: shows.of(results, one.compute.of(results)) for one, shows in records if isinstance(shows, OwnTable)}


def listings(results: MotionResults, asked: Names) -> tuple[Listing, ...]:
    """Return the files in which drawings that were asked for keep their numbers."""
    records = ((one, one.shows) for one in quantities_for(asked).values())
    return tuple(
        shows.listing(one.compute.of(results))
        for one, shows in records
        if isinstance(shows, OwnFigure) and shows.listing is not None
    )


def figures(results: MotionResults, asked: Names, written: Callable[[str], str]) -> dict[str, tuple[Drawing, ...]]:
    """Return the drawings asked for that have no section of their own, their words put into a language by `written`."""
    records = ((name, one, one.shows) for name, one in quantities_for(asked).items())
    return {
        name: shows.of(results, one.compute.of(results), written)
        for name, one, shows in records
        if isinstance(shows, OwnFigure)
    }  # fmt: skip
