"""A mechanism built from pieces: each hangs on a point there is, closes through the whole motion, and changes nothing else."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from coursework import load, solve
from coursework.desk.answering import pieces
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.vocabulary import GROUP_KINDS
from tests.desk.desks import TEXT, VARIANTS, desk


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    with desk(tmp_path_factory.mktemp("pieces")) as opened:
        yield opened


def put(client, text: str, kind: str, *on: str) -> dict:
    return client.post("/api/piece", json={"text": text, "kind": kind, "on": list(on), "language": "ru"}).json()


def test_each_kind_is_shown_with_what_it_asks(client):
    found = client.get("/api/pieces", params={"language": "zh"}).json()
    assert [each["kind"] for each in found] == [*GROUP_KINDS, "point", "guide", "wheel"]
    assert [len(each["asks"]) for each in found] == [0, 1, 1, 1, 1, 1, 0, 1, 1]
    assert all("<animate" in each["svg"] and each["title"] for each in found)


@pytest.mark.long
def test_from_an_empty_text_to_a_chain_of_every_kind(client):
    text = put(client, "", "crank")["text"]
    assert "coursework run" not in text  # nor of what it is a chain, which it is not for long
    for kind, point in (("RRR", "B"), ("RRP", "D"), ("RPR", "D"), ("PRP", "D"), ("crank", ""), ("RPP", "B")):
        before, found = text, put(client, text, kind, *([point] if point else []))
        text = found["text"]
        variant = parse_variant(text)
        assert variant.groups[-1].kind == kind
        rest = iter(text.split("\n"))
        longer = ("hinges", "rails")
        assert all(any(line == own for own in rest) for line in before.split("\n") if not line.startswith(longer))
        lines = text.split("\n")
        assert all(lines[one["line"] - 1] != before for one in found["ranges"])
    told = client.post("/api/check", json={"text": text}).json()
    assert (told["faults"], len(variant.groups)) == ([], 7)
    assert "5 of 5" in told["summary"]


@pytest.mark.parametrize(
    ("kind", "on", "word"),
    [
        ("RRR", ["B", "Q", "Z"], "Q"),
        ("XYZ", [], "XYZ"),
        ("PRP", ["B"], "PRP"),
        ("RRR", [], "RRR"),
        ("RRR", ["A"], "A не движется"),
    ],
)
def test_what_cannot_be_had_says_why_and_changes_nothing(client, kind, on, word):
    text = put(client, "", "crank")["text"]
    found = put(client, text, kind, *on)
    assert (found["text"], found["ranges"]) == (text, [])
    assert word in found["sentence"]


def test_a_piece_on_a_mechanism_of_the_catalogue(client):
    text = (VARIANTS / "example-1.toml").read_text(encoding="utf-8")
    found = put(client, text, "RRP", "C")
    assert len(parse_variant(found["text"]).groups) == 3
    assert client.post("/api/check", json={"text": found["text"]}).json()["faults"] == []


def test_a_mechanism_that_cannot_begin_to_move_is_told_as_such_and_not_as_a_text_without_the_point(client):
    """Links on one line at the start; a crank beside them can be added."""
    text = (VARIANTS / "example-1.toml").read_text(encoding="utf-8")
    text = text.replace('r2 = "1.0 m"', 'r2 = "0.5 m"').replace('r3 = "0.7 m"', 'r3 = "0.3 m"')
    found = put(client, text, "RRP", "C")
    assert found["text"] == text and "sin(theta2 - theta3) = 0" in found["sentence"]
    assert len(parse_variant(put(client, text, "crank")["text"]).groups) == 3


def test_a_text_with_faults_is_told_them(client):
    assert put(client, "[given", "RRR", "B")["faults"]


def test_from_an_empty_text_to_a_wheel_that_rolls(client):
    """A driven point, a rod with a slider, a wheel about the slider; each is computed at once and drawn once."""
    text = put(client, "", "point")["text"]
    for kind, point in (("guide", "A"), ("wheel", "B"), ("guide", "M")):
        text = put(client, text, kind, point)["text"]
        assert client.post("/api/check", json={"text": text}).json()["faults"] == []
    variant = parse_variant(text)
    assert [(link.name, link.points, link.wheel, link.contact) for link in variant.links[2:]] == [
        ("3", ("A", "B"), None, None), ("4", (), "B", "C"), ("5", ("M", "E"), None, None),
    ]  # fmt: skip
    # The wheel rolls on a line through its contact, in the place of the guide of its centre.
    assert [through.name for through, _ in variant.frame.rails] == ["C", "E"]
    run = solve(variant, quantities=["table"])
    column = run.motion.column
    slides = -0.5 * column("w1") * np.sin(column("phi1")) - variant.values["r3"] * column("w3") * np.sin(column("phi3"))
    assert column("w4") * variant.values["R4"] == pytest.approx(-slides, abs=1e-9)


def test_equations_of_ones_own_are_not_left_without_those_of_a_piece(client):
    found = put(client, TEXT, "guide", "A")
    assert client.post("/api/check", json={"text": found["text"]}).json()["faults"] == []
    assert parse_variant(found["text"]).constraints[-1].name not in {"11", "12", "16", "18"}
    assert [line for line in TEXT.split("\n") if "# " in line and line not in found["text"]] == [
        'holds  = ["C.y"]               # scalar expressions that keep their start value'
    ]


def test_the_mark_that_some_editors_put_before_a_text_is_no_part_of_it(client):
    assert put(client, f"\ufeff{TEXT}", "guide", "A")["text"] == put(client, TEXT, "guide", "A")["text"]


def test_a_rod_with_a_slider_on_a_chain_is_its_group(client):
    text = put(client, put(client, "", "crank")["text"], "guide", "B")["text"]
    assert parse_variant(text).groups[-1].kind == "RRP"


def test_a_wheel_under_the_slider_of_a_chain_that_lists_its_links(client):
    text = (VARIANTS / "example-2.toml").read_text(encoding="utf-8")
    group = parse_variant(text).groups[-1]
    found = put(client, text, "wheel", group.meets)
    told = client.post("/api/check", json={"text": found["text"]}).json()
    assert (told["faults"], parse_variant(found["text"]).links[-1].wheel) == ([], group.meets)


@pytest.mark.parametrize(
    ("begun", "kind", "on", "word"),
    [
        ("", "wheel", "B", "кривошипа или точки с заданным движением"),
        ("", "guide", "B", "кривошипа или точки с заданным движением"),
        (TEXT, "point", "", "начните с пустого"), (TEXT, "RRR", "A", "RRR"),
        (TEXT, "wheel", "A", "A не скользит"),
    ],
)  # fmt: skip
def test_what_does_not_go_together_says_why(client, begun, kind, on, word):
    found = put(client, begun, kind, *([on] if on else []))
    assert (found["text"], found["ranges"]) == (begun, [])
    assert word in found["sentence"]


@pytest.mark.parametrize(("kind", "on", "ends"), [("crank", [], ["z"]), ("crank", ["x"], ["x"]), ("RRR", ["x"], ["x"])])
def test_a_crank_that_hangs_on_nothing_stands_beside_the_last_point(monkeypatch, kind, on, ends):
    found = {name: SimpleNamespace(name=name, amplitude=1.0) for name in "xyz"}
    monkeypatch.setattr(pieces, "_ends", lambda scene: found)
    monkeypatch.setattr(pieces, "_hang", lambda kind, ends, number, taken, desk: (kind, [one.name for one in ends], number))
    asked = SimpleNamespace(body={"kind": kind, "on": on}, text="a", variant=load("example-1"))
    assert pieces.piece(asked) == (kind, ends, 5)  # lengths of example 1 go up to r4
