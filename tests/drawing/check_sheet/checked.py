"""Graph-analytical checks of the catalogue, each made once for all tests of this room."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from coursework.drawing.check_sheet.graph_check import GraphCheck, check_graph
from coursework.drawing.check_sheet.sketch import Body, Pose, Sketch
from coursework.run import Run
from coursework.variant.record.variant import Variant
from tests.solved import solved

# Links that [links] and [frame] alone determine; V107 has a bar in a swivelling sleeve.
DRAWABLE = ("V101", "V102", "V104", "V105", "V108", "V110", "V112")


@cache
def run_of(name: str) -> Run:
    return solved(name, quantities=["graph_check"])


@cache
def check_of(name: str, row: int | None = None) -> GraphCheck:
    """Return the check of a catalogue's variant, in its own row or another; the variant is solved once."""
    run = run_of(name)
    if row is None:
        assert run.graph_check is not None
        return run.graph_check
    equations = replace(run.scene.equations, variant=at_row(run.variant, row))
    check = check_graph(run.scene.mechanism, equations, run.motion, run.exact)
    assert check is not None
    return check


@cache
def svg_of(name: str) -> str:
    return check_of(name).drawing().svg


def at_row(variant: Variant, row: int | None) -> Variant:
    return replace(variant, time=replace(variant.time, check_row=row))


def sketch_of(name: str) -> Sketch:
    return check_of(name).sketch


def scene(
    points: dict[str, complex], bodies: list[Body], *, fixed: str = "", guided: dict[str, complex] | None = None,
    velocities: dict[str, complex] | None = None, rates: dict[str, float] | None = None,
) -> Pose:  # fmt: skip
    return Pose(points, tuple(bodies), frozenset(fixed), guided or {}, velocities or {}, rates or {})
