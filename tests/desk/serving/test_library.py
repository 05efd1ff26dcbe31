"""What can be started from, and what may stand in a text, in every language."""

from __future__ import annotations

import xml.etree.ElementTree as tree
from pathlib import Path
from types import SimpleNamespace

import pytest

from coursework.desk.serving import library
from coursework.variant.catalogue import names
from coursework.variant.reading.schema import VariantFile
from tests.desk.desks import VARIANTS, desk, ended


@pytest.fixture
def client(tmp_path: Path):
    with desk(tmp_path) as opened:
        yield opened


def test_every_variant_has_a_picture_that_moves(client):
    found = client.get("/api/catalogue", params={"language": "uk"}).json()
    assert [each["name"] for each in found] == names()
    own = {each["name"]: each for each in found}
    assert (
        own["31"]["title"] == "Колесо, що котиться, прямокутна ланка, кривошип і стрижень"
        or "колес" in own["31"]["title"].lower()
    )
    assert (own["31"]["links"], own["31"]["groups"]) == (5, ["II", "RRR"])
    assert own["jansen"]["groups"].count("RRR") == 3
    for each in found:
        picture = tree.fromstring(each["svg"])
        assert picture.get("stroke") == "currentColor"
        assert [part for part in picture.iter() if part.tag.endswith("animate")], each["name"]
        assert "script" not in each["svg"]


def test_the_text_of_a_variant_comes_with_its_tables(client):
    name = next(path.stem for path in sorted(VARIANTS.glob("*.toml")) if "table = " in path.read_text(encoding="utf-8"))
    answers = [client.get(f"/api/variant/{name}{more}") for more in ("", "/tables")]
    assert all("max-age=600" in each.headers["cache-control"] for each in answers), "a browser asks once in ten minutes"
    assert answers[0].content == (VARIANTS / f"{name}.toml").read_bytes()
    tables = answers[1].json()
    assert tables == {table: (VARIANTS / table).read_text(encoding="utf-8") for table in tables} != {}
    for wrong in ("nothing", "..", "variant.schema", "%2e%2e%2fpyproject"):
        assert client.get(f"/api/variant/{wrong}").status_code == 404


@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_every_key_of_the_schema_has_its_line(client, language):
    found = client.get("/api/keys", params={"language": language}).json()
    sections = {each["name"]: each for each in found["sections"]}
    assert list(sections) == list(VariantFile.keys())
    told = [each["means"] for each in (*sections.values(), *(key for section in sections.values() for key in section["keys"]))]
    assert all(told)
    assert [key["name"] for key in sections["time"]["keys"]] == ["step", "end", "period", "check_row", "scheme"]
    assert {"from", "guides", "through"} <= {key["name"] for key in sections["group"]["keys"]}
    assert (sections["group"]["many"], sections["given"]["many"]) == (True, False)
    assert (sections["given"]["named"], sections["time"]["named"]) == (True, False)
    assert (sections["coordinates"]["lines"][0].split()[0], sections["time"]["lines"]) == ("phi1", [])
    assert "deg" in found["units"]
    assert {"name": "rk4"}.items() <= found["schemes"][-2].items()


@pytest.mark.parametrize(("status", "asked"), [(200, 1), (503, 2)])
def test_what_was_answered_is_kept_here_and_by_the_browser_and_a_refusal_is_not(monkeypatch, status, asked):
    calls = []

    async def answer(request, kind, data):
        calls.append(kind)
        return SimpleNamespace(status=status)

    monkeypatch.setattr(library, "language_of", lambda _: "en")
    monkeypatch.setattr(library, "reply", lambda answer, headers: headers)
    request = SimpleNamespace(url=SimpleNamespace(path="/api/schema"), headers={})
    kept = library.Library(answer)
    found = [ended(kept.made_once(request)) for _ in range(2)]
    assert (calls, found) == (["schema"] * asked, [library.KEPT if status == 200 else None] * 2)
