"""Grids for the tests of grading: variants of the catalogue and their Euler tables."""

from __future__ import annotations

from functools import cache

import coursework
from coursework.grading.reading.expected import Expected, Grid, grid_of


@cache
def expected(name: str = "31", answers: tuple[str, ...] = ()) -> Expected:
    run = coursework.solve(name, "euler", quantities=["table"])
    names, rows = run.columns()
    grid = grid_of(run.variant, dict(zip(names, (tuple(row) for row in rows.T.tolist()), strict=True)))
    return Expected(grid, run.variant, answers)


def times(grid: Grid) -> list[float]:
    return [place * grid.step for place in range(grid.rows)]
