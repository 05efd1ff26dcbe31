"""The rows that a page shows of a table too long for a laboratory: as many as there is room for, found in few tries."""

import json

import pytest

import coursework
from coursework.report.live import drawn
from coursework.report.live.drawn import drawn_of, frames_of

ROOM = 36_000


@pytest.fixture(scope="module")
def run():
    return coursework.solve("31", step=0.48 / 20_000, scheme="rk4", quantities=["table"])


def written(found):
    return len(json.dumps(found, separators=(",", ":")))


def test_twenty_thousand_rows_are_written_out_a_few_times_only(run, monkeypatch):
    dumps, real = [], json.dumps
    monkeypatch.setattr(drawn.json, "dumps", lambda *given, **how: dumps.append(1) or real(*given, **how))
    found = frames_of(run, drawn_of(run.scene, str), ROOM)["frames"]
    assert len(dumps) <= 25
    assert written(found) <= ROOM
    # Positions in tenths of a millimetre tell no distance of 0.100 mm.
    assert found["finest"] == 1e-4 and found["rows"][3] == [round(value, 4) for value in found["rows"][3]]


def test_a_little_more_room_shows_rows_closer_together(run):
    strides = [
        round(frames_of(run, drawn_of(run.scene, str), room)["frames"]["step"] / run.step) for room in (ROOM, ROOM * 51 // 50)
    ]
    assert strides[1] < strides[0]
