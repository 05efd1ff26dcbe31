"""The files of the page: their types, kept by their content, and policies without holes."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from pathlib import Path

import pytest

from coursework.desk.answering import bench
from coursework.desk.job import Policy
from coursework.report.output import formats
from coursework.report.output.formats import formats_for
from coursework.words.data_folders import folder_of_package, standing_in
from tests.desk.desks import COOKIE, TEXT, desk

INDEX = """<html lang="{{ language }}"><script type="application/json" id="desk-config">{{ config | tojson }}</script>
<script type="module" src="{{ asset("main.js") }}"></script><style nonce="{{ nonce }}"></style></html>"""


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    """The files of `reports/` with a desk of a few letters."""
    place = tmp_path_factory.mktemp("looks") / "reports"
    shutil.copytree(folder_of_package("reports"), place, ignore=shutil.ignore_patterns("desk", "fonts", "*.gif"))
    own = place / "desk"
    own.mkdir()
    for name, text in (
        ("index.html.j2", INDEX),
        ("frame.html.j2", '<script nonce="{{ nonce }}">1</script>'),
        ("main.js", "1;" * 5000),
    ):
        (own / name).write_text(text, encoding="utf-8")
    standing_in.append(place)
    yield place
    standing_in.remove(place)


@pytest.fixture
def client(tmp_path: Path, reports):
    (tmp_path / "mine.toml").write_text(TEXT, encoding="utf-8")
    with desk(tmp_path, name="mine") as opened:
        yield opened


def config_of(page: str) -> dict:
    return json.loads(re.search(r'id="desk-config">(.*?)</script>', page, re.S)[1])


def test_the_page_knows_what_was_opened(client, tmp_path):
    config = config_of(client.get("/", params={"language": "ru"}).text)
    assert (config["name"], config["text"], config["mode"], config["language"]) == ("mine", TEXT, "edit", "ru")
    assert config["etag"] == f'"{hashlib.sha256(TEXT.encode()).hexdigest()}"'
    assert (config["folder"], config["writable"]) == (str(tmp_path), True)
    assert [name for name, _ in config["languages"]] == ["en", "ru", "uk", "zh"]
    assert ["euler", "явная схема Эйлера"] in config["schemes"]
    assert config["formats"] == [*formats_for("run")]
    assert all(f"format_{suffix}" in config["words"] for suffix in config["formats"])
    (tmp_path / "mine.toml").write_text("another", encoding="utf-8")
    assert config_of(client.get("/").text)["text"] == "another"


def test_whoever_started_a_desk_is_told_how_to_start_it_again(client):
    assert config_of(client.get("/").text)["words"]["state_unreachable"].endswith("start it again: coursework edit")
    with desk() as of_others:
        assert "start" not in config_of(of_others.get("/").text)["words"]["state_unreachable"]


def test_a_folder_that_cannot_be_written_is_known_from_the_start(client, monkeypatch):
    monkeypatch.setattr("os.access", lambda *_: False)
    assert config_of(client.get("/").text)["writable"] is False


def test_the_shells_policy_has_no_holes(client):
    page = client.get("/")
    policy, nonce = page.headers["content-security-policy"], config_of(page.text)["nonce"]
    assert "unsafe" not in policy
    assert f"'nonce-{nonce}'" in policy
    assert "default-src 'none'" in policy
    assert config_of(client.get("/").text)["nonce"] != nonce


def test_the_report_lives_in_an_origin_of_its_own(client):
    page = client.get("/desk/frame")
    policy = page.headers["content-security-policy"]
    assert policy.startswith("sandbox allow-scripts;")
    assert "connect-src 'none'" in policy
    nonce = re.search(r'nonce="([^"]+)"', page.text)[1]
    assert f"script-src 'nonce-{nonce}'" in policy


def test_a_file_is_loaded_once(client):
    address = re.search(r'src="([^"]+)"', client.get("/").text)[1]
    first = client.get(address)
    assert first.headers["content-type"].startswith("text/javascript")
    assert first.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert (first.headers["content-encoding"], first.text) == ("gzip", "1;" * 5000)
    again = client.get("/desk/main.js", headers={"If-None-Match": first.headers["etag"]})
    assert (again.status_code, again.headers["cache-control"]) == (304, "no-cache")


@pytest.mark.parametrize("name", ["index.html.j2", "../words.en.toml", "%2e%2e/words.en.toml", "nothing.js", "%00.js", "x" * 300])
def test_nothing_else_is_served(client, name):
    assert client.get(f"/desk/{name}").status_code == 404


def test_an_extra_that_is_missing_is_told_to_who_can_install_it_alone(client, monkeypatch):
    monkeypatch.setattr(formats, "find_spec", lambda name: None if name == "ezdxf" else name)
    assert "dxf" in config_of(client.get("/").text)["formats"]
    with desk() as others:
        assert config_of(others.get("/").text)["formats"] == [each for each in formats_for("run") if each != "dxf"]


def test_a_desk_for_others_names_a_browser_without_meaning(reports):
    with desk(root="/our", policy=Policy(formats=("csv",))) as client:
        page = client.get("/our/")
        assert config_of(page.text)["formats"] == ["csv"]
        assert config_of(page.text)["root"] == "/our"
        assert config_of(page.text)["mode"] == "serve"
        assert 'src="/our/desk/main.js?v=' in page.text
        first = re.search(rf"{COOKIE}=([^;]+)", page.headers["set-cookie"])[1]
        assert "set-cookie" not in client.get("/our/").headers  # it has one now
        client.cookies.clear()
        assert first not in client.get("/our/").headers["set-cookie"]


@pytest.mark.parametrize(("others", "accepted", "more", "packed"), [
    (True, "gzip, br", 0, True), (True, "gzip", 1, False), (True, "identity", 0, False), (False, "gzip", 0, False),
])  # fmt: skip
def test_long_answers_are_packed_for_who_is_far_and_says_he_can_unpack_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, others: bool, accepted: str, more: int, packed: bool
) -> None:
    asked = {"text": TEXT, "name": "31"}
    with desk(None if others else tmp_path) as client:
        plain = client.post("/api/check", json=asked, headers={"Accept-Encoding": "identity"})
        monkeypatch.setattr(bench, "PACKED_FROM", len(plain.content) + more)
        answer = client.post("/api/check", json=asked, headers={"Accept-Encoding": accepted})
    assert answer.headers.get("content-encoding") == ("gzip" if packed else None)
    assert answer.content == plain.content
