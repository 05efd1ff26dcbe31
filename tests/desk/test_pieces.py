"""A mechanism built from pieces: each hangs on a point there is, closes through the whole motion, and changes nothing else."""

from __future__ import annotations

import pytest

from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.vocabulary import GROUP_KINDS
from tests.desk.desks import VARIANTS, desk


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    with desk(tmp_path_factory.mktemp("pieces")) as opened:
        yield opened


def put(client, text: str, kind: str, *on: str) -> dict:
    return client.post("/api/piece", json={"text": text, "kind": kind, "on": list(on), "language": "ru"}).json()


def test_each_kind_is_shown_with_what_it_asks(client):
    found = client.get("/api/pieces", params={"language": "zh"}).json()
    assert [each["kind"] for each in found] == list(GROUP_KINDS)
    assert [len(each["asks"]) for each in found] == [0, 1, 1, 1, 1, 1]
    assert all("<animate" in each["svg"] and each["title"] for each in found)


def test_from_an_empty_text_to_a_chain_of_every_kind(client):
    text = put(client, "", "crank")["text"]
    for kind, point in (("RRR", "B"), ("RRP", "D"), ("RPR", "D"), ("PRP", "D"), ("crank", ""), ("RPP", "B")):
        before, found = text, put(client, text, kind, *([point] if point else []))
        text = found["text"]
        variant = parse_variant(text)
        assert variant.groups[-1].kind == kind
        rest = iter(text.split("\n"))
        assert all(any(line == own for own in rest) or "hinges" in line for line in before.split("\n") if "hinges" not in line)
        lines = text.split("\n")
        assert all(lines[one["line"] - 1] != before for one in found["ranges"])
    told = client.post("/api/check", json={"text": text}).json()
    assert (told["faults"], len(variant.groups)) == ([], 7)
    assert "5 of 5" in told["summary"]


@pytest.mark.parametrize(
    ("kind", "on", "word"),
    [("RRR", ["Q"], "Q"), ("XYZ", [], "XYZ"), ("PRP", ["B"], "PRP"), ("RRR", [], "RRR"), ("RRR", ["A"], "A не движется")],
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


def test_a_text_with_faults_is_told_them(client):
    assert put(client, "[given", "RRR", "B")["faults"]
