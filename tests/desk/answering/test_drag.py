"""A joint dragged: the text follows, the mechanism stays one, and what does not move says why."""

from __future__ import annotations

import cmath
import re

import numpy as np
import pytest

from coursework.api import solve
from coursework.desk.answering.drag import _nearest, _places
from coursework.desk.job import Policy
from coursework.variant.reading import reader
from coursework.variant.reading.reader import parse_variant
from tests.desk.desks import TEXT, desk
from tests.mechanisms.library import mechanism
from tests.sample import sampled


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    with desk(tmp_path_factory.mktemp("drag")) as opened:
        yield opened


def drag(client, text: str, joint: str, by: complex, **more) -> dict:
    place = _places(parse_variant(text))[joint] + by
    return client.post("/api/drag", json={"text": text, "joint": joint, "place": [place.real, place.imag], **more}).json()


def test_start_values_follow_and_lengths_stay(client):
    found = drag(client, TEXT, "M", 0.1 + 0.05j)
    before, after = parse_variant(TEXT), parse_variant(found["text"])
    assert found["near"]
    assert after.values == before.values
    assert abs(_places(after)["M"] - complex(*found["reached"])) < 2e-3
    assert abs(_places(after)["M"] - (_places(before)["M"] + 0.1 + 0.05j)) < 5e-3
    lines = found["text"].split("\n")
    marked = [lines[one["line"] - 1][one["column"] - 1 : one["end_column"] - 1] for one in found["ranges"]]
    assert all(re.fullmatch(r"\d\.\d{3} rad", value) for value in marked)
    assert re.sub(r"\d\.\d+ rad", "", found["text"]) == re.sub(r"\d\.\d+ rad", "", TEXT)  # remarks, order and the rest stay


def test_with_alt_lengths_follow_with_the_digits_they_have(client):
    found = drag(client, TEXT, "M", 0.1 + 0.05j, free=True)
    before, after = parse_variant(TEXT), parse_variant(found["text"])
    assert [one.start for one in after.coordinates] == [one.start for one in before.coordinates]
    changed = [one for one, old in zip(after.given, before.given, strict=True) if one.value != old.value]
    assert {one.name for one in changed} == {"r1", "r2", "r3"}
    assert all(re.fullmatch(r"\d\.\d{3}", one.text) for one in changed)


@pytest.mark.parametrize(("name", "joint", "far"), [("jansen", "X", 0.01), ("jansen", "F", 0.1), ("example-1", "B", -0.5)])
def test_lengths_are_rounded_to_what_still_closes(client, name, joint, far):
    found = drag(client, mechanism(name), joint, far, free=True)
    reached = _places(parse_variant(found["text"]))  # raises where it does not close, and where a link has no length
    assert abs(reached[joint] - complex(*found["reached"])) < 1e-9


def test_the_file_is_read_anew_only_for_what_is_written(client, monkeypatch):
    read, build = [], reader._build
    monkeypatch.setattr(reader, "_build", lambda *given: read.append(given) or build(*given))
    assert not drag(client, mechanism("jansen"), "X", 0.01, free=True)["near"]
    assert len(read) < 10  # a hundred places are tried on the way


def test_what_rounding_takes_away_again_is_said(client):
    text = mechanism("robot-arm")
    found = drag(client, text, "A", 0.01, free=True)
    assert found["text"] == text
    assert "more digits" in found["sentence"]


@pytest.mark.parametrize(("name", "joint"), [("jansen", "F"), ("example-1", "C"), ("v102", "C"), ("watt", "E")])
@pytest.mark.parametrize("free", [False, True])
def test_a_closed_chain_stays_closed(client, name, joint, free):
    text = mechanism(name)
    size = max(map(abs, _places(parse_variant(text)).values()))
    found = drag(client, text, joint, 0.05 * size, free=free)
    run = solve(parse_variant(found["text"]))  # raises where it does not close
    assert run.scene.stop is None or found["text"] != text


# A Whitworth quick return: the pin A of the crank slides along the rod from C.
SLOT = mechanism("slotted-lever", ('start = "68.19859051363818 deg"', 'start = "68.1986 deg"'), (
    "\n[time]", '\ns = { start = "0.269258 m", rate = "u" }\n[time]',
), ('"(A - D).x*sin(th) - (A - D).y*cos(th)"', '"A.x - D.x - s*cos(th)", "A.y - D.y - s*sin(th)"'))  # fmt: skip


def test_what_a_closure_holds_follows_the_crank(client):
    hand = -0.18 + 0.06j
    found = drag(client, SLOT, "A", hand)
    assert (found["near"], found["sentence"]) == (True, None)
    crank, lever, slide = (one.start_or_guess for one in parse_variant(found["text"]).coordinates)
    pin = cmath.rect(0.1, crank)
    assert abs(pin - (0.1 + hand)) < 1e-3
    assert abs(pin + 0.25j - cmath.rect(slide, lever)) < 2e-6  # the rounding of the written values; it was 0.1
    assert 0 < lever < cmath.pi  # not a turn more, nor the slide below zero
    radial = drag(client, SLOT, "A", 0.05)
    assert (radial["text"], radial["ranges"], "No start that closes" in radial["sentence"]) == (SLOT, [], True)


def test_what_cannot_be_reached_is_shown_as_the_nearest_that_can(client):
    found = drag(client, TEXT, "A", 5.0)
    assert not found["near"]
    hand = _places(parse_variant(TEXT))["A"] + 5.0
    assert abs(complex(*found["reached"]) - 0.953 * hand / abs(hand)) < 5e-3  # stretched from D towards the hand


@pytest.mark.parametrize(("joint", "key"), [("D", "start value"), ("Q", "no point")])
def test_what_nothing_moves_says_why(client, joint, key):
    found = client.post("/api/drag", json={"text": TEXT, "joint": joint, "place": [1, 1]}).json()
    assert key in found["sentence"]
    assert (found["text"], found["ranges"]) == (TEXT, [])


def test_other_shapes_are_refused(client):
    for place in (["a", 1], [1], 1, [1, 1e300], [True, 1], None):
        assert client.post("/api/drag", json={"text": TEXT, "joint": "M", "place": place}).status_code == 422


WRITTEN = ["31", "cardan", "epicyclic", "robot-arm", "v101", "v102", "v104", "v105", "v107", "v108", "v110", "v112"]


def bare(text: str) -> str:
    return re.sub(r"\[\[constraint\]\].*?(?=\n\[(?!\[con)|\n# ---|\Z)", "", text, flags=re.S)


@pytest.mark.parametrize("name", sampled(WRITTEN))
def test_equations_that_are_written_for_a_student_are_right_and_enough(client, name):
    text = mechanism(name)
    assert client.post("/api/equations", json={"text": text}).json()["text"] == text  # none is lacking
    found = client.post("/api/equations", json={"text": bare(text), "language": "ru"}).json()
    told = client.post("/api/check", json={"text": found["text"]}).json()
    assert told["faults"] == []
    assert len(told["equations"]) == found["number"] == len(parse_variant(text).sought)
    assert all(one["right"] for one in told["equations"])
    assert re.search('because += ".*[а-я]', found["text"])


def test_one_equation_is_added_to_those_of_a_student(client):
    one = TEXT.index("[[constraint]]", TEXT.index('name     = "16"'))
    text = TEXT[:one] + TEXT[TEXT.index("# --- geometry") :]
    found = client.post("/api/equations", json={"text": text}).json()
    assert found["number"] == 1
    assert found["text"].count("[[constraint]]") == 4
    assert client.post("/api/check", json={"text": found["text"]}).json()["faults"] == []


def test_a_wrong_sign_is_a_fault_where_it_stands(client):
    wrong = TEXT.replace("VMy - 2*r3*w3*cos(phi3) -", "VMy + 2*r3*w3*cos(phi3) -")
    (fault, *_) = client.post("/api/check", json={"text": wrong}).json()["faults"]
    assert wrong.split("\n")[fault["line"] - 1].startswith("equation") or "constraint" in wrong.split("\n")[fault["line"] - 1]


def test_a_department_may_not_write_them():
    with desk(policy=Policy(equations=False)) as client:
        assert client.post("/api/equations", json={"text": TEXT}).status_code == 403


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "moves"), [(0.98e-4, False), (1.02e-4, True)])
def test_a_point_that_is_nearly_where_it_was_dragged_stays_at_any_size(size: float, part: float, moves: bool) -> None:
    """Two lengths are the place of the point; it is dragged by a part of the size."""
    found = _nearest(lambda values: complex(*values), np.array([size, 0.0]), size * (1 + 1j * part), size)
    assert found is not None and found.tolist() == pytest.approx([size, size * part if moves else 0.0], rel=1e-2, abs=1e-12)
