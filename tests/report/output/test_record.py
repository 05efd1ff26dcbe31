"""What `run.json` says stands in it where it was asked for, and nowhere else."""

from __future__ import annotations

import pytest

from coursework.report.output.record import record
from tests.solved import solved


@pytest.mark.parametrize(("name", "parts"), [
    ("example-6", set()), ("31", {"graph_check"}), ("example-1-forces", {"forces"}), ("falling-arm", {"dynamics"}),
])  # fmt: skip
def test_a_part_is_there_where_it_was_asked_for(name: str, parts: set[str]) -> None:
    run = solved(name)
    found = record(run)
    assert {part for part in ("graph_check", "forces", "dynamics") if part in found} == parts
    assert found["quantities"] == list(run.asked) and found["rows"] == len(run.table)
    assert bool(found["checks"]) is ("checks" in run.asked)
    assert record(solved(name, quantities=["table"])).keys().isdisjoint({"graph_check", "forces", "dynamics"})
