"""Grids for the tests of grading: variants of the catalogue and their Euler tables."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import coursework
from coursework.grading.reading.expected import Expected, Grid, grid_of
from coursework.variant.record.variant import Variant

OWN = Path(__file__).parent / "whole_class"  # mechanisms that are in no catalogue


def variant_of(name: str) -> Variant:
    """Return a variant of the catalogue, or of the tests' own."""
    path = OWN / f"{name}.toml"
    return coursework.load(path if path.exists() else name)


@cache
def expected(name: str = "31", answers: tuple[str, ...] = ()) -> Expected:
    run = coursework.solve(variant_of(name), "euler", quantities=["table"])
    names, rows = run.columns()
    grid = grid_of(run.variant, dict(zip(names, (tuple(row) for row in rows.T.tolist()), strict=True)))
    return Expected(grid, run.variant, answers)


def times(grid: Grid) -> list[float]:
    return [place * grid.step for place in range(grid.rows)]
