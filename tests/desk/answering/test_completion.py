"""What the desk offers while one types, from a schema of two sections: keys of a section, of models inside it, their words."""

from types import SimpleNamespace

import pytest

from coursework.desk.answering.completion import _heading, _models, _section, keys
from coursework.words.sentences import load_phrases

MODELS = {
    "Link": {"properties": {"points": {"type": "array"}, "rate": {"$ref": "#/$defs/Rate"}}},
    "Rate": {"properties": {"unit": {"type": "string"}}}, "Alone": {"properties": {"points": {}}},
}  # fmt: skip
WORDS = {
    "desk.key.links": "Links", "desk.key.points": "Points", "desk.key.links_points": "Points of a link", "desk.key.rate": "Rate",
    "desk.key.unit": "Unit", "desk.key.list": "List",
}  # fmt: skip
STUB = SimpleNamespace(words=SimpleNamespace(has=WORDS.__contains__, template=WORDS.__getitem__))
LINK = {"$ref": "#/$defs/Link"}


@pytest.mark.parametrize(("entry", "found"), [
    (LINK, ["Link", "Rate"]), ({"anyOf": [{"type": "null"}, {"$ref": "#/$defs/Rate"}]}, ["Rate"]), ({"type": "string"}, []),
    ("Link", []),
    ({"items": [LINK, {"$ref": "#/$defs/Alone"}]}, ["Link", "Rate", "Alone"]),
])  # fmt: skip
def test_models_inside_models_are_found(entry, found):
    assert list(_models(entry, MODELS)) == found


@pytest.mark.parametrize(("entry", "many", "named", "inner"), [
    ({"type": "array", "items": LINK}, True, False, ["Points of a link", "Rate", "Unit"]), ({"type": "array"}, False, False, []),
    ({"additionalProperties": LINK}, False, True, ["Points of a link", "Rate", "Unit"]),
    ({"$ref": "#/$defs/Rate"}, False, False, ["Unit"]),
])  # fmt: skip
def test_a_section_has_the_keys_of_its_models_by_their_own_words_before_the_common_ones(entry, many, named, inner):
    found = _section("links", entry, MODELS, STUB)
    assert (found["name"], found["means"], found["many"], found["named"]) == ("links", "Links", many, named)
    assert [pair["means"] for pair in found["keys"]] == inner
    assert [line.partition(" ")[0] for line in found["lines"]] == ["1", "4"]
    assert _section("list", entry, MODELS, STUB)["lines"] == []


def test_what_can_be_typed_is_named_in_the_language_of_the_desk():
    found = keys(SimpleNamespace(words=load_phrases("en")))
    named = {kind: {pair["name"] for pair in found[kind]} for kind in ("quantities", "schemes", "kinds")}
    assert {"table", "checks", "forces"} <= named["quantities"] and {"euler", "rk4", "exact"} <= named["schemes"]
    assert {"crank", "RRR", "RRP", "RPR", "RPP", "PRP"} <= named["kinds"] and "sin" in found["functions"]
    assert {"m", "rad/s", "deg"} <= {*found["units"]} and all(unit.isascii() for unit in found["units"])
    sections = {section["name"]: section for section in found["sections"]}
    assert sections["constraint"]["many"] and sections["given"]["named"] and not sections["time"]["named"]
    assert {pair["name"] for pair in sections["time"]["keys"]} >= {"step", "end", "period"}
    assert all(pair["means"] for section in sections.values() for pair in section["keys"])


def test_a_quantity_without_a_heading_is_among_the_results():
    words = SimpleNamespace(has="section.checks".__eq__, template=str)
    found = [_heading(name, SimpleNamespace(words=words)) for name in ("checks", "other")]
    assert found == ["section.checks", "section.results"]
