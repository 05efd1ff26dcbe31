"""Files of the folder, and none outside: read, written whole over the version that was seen, put away and brought back."""

from __future__ import annotations

import hashlib
import io
import os
import time
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from coursework.desk.serving.folder import LEFT_OVER, Folder, Stale, etag_of
from tests.desk.desks import TEXT, VARIANTS, desk

NEW = {"If-None-Match": "*"}


@pytest.fixture
def client(tmp_path: Path):
    with desk(tmp_path) as opened:
        yield opened


def test_a_text_comes_back_with_its_version(client, tmp_path):
    assert client.get("/api/file/mine").status_code == 404
    answer = client.put("/api/file/mine", content=TEXT.encode(), headers=NEW)
    version = f'"{hashlib.sha256(TEXT.encode()).hexdigest()}"'
    assert (answer.status_code, answer.headers["etag"], answer.json()["etag"]) == (201, version, version)
    found = client.get("/api/file/mine")
    assert (found.text, found.headers["etag"]) == (TEXT, version)
    assert (tmp_path / "mine.toml").read_text(encoding="utf-8") == TEXT
    assert [each["name"] for each in client.get("/api/files").json()] == ["mine"]


def test_only_the_version_that_was_seen_is_written_over(client, tmp_path):
    assert client.put("/api/file/mine", content="a").status_code == 428
    first = client.put("/api/file/mine", content="a", headers=NEW).headers["etag"]
    for headers in (NEW, {"If-Match": etag_of(b"x")}):
        stale = client.put("/api/file/mine", content="b", headers=headers)
        assert (stale.status_code, stale.json()) == (409, {"mine": "b", "theirs": "a", "etag": first})
    second = client.put("/api/file/mine", content="", headers={"If-Match": first})
    assert second.status_code == 200
    (tmp_path / "mine.toml").write_bytes(b"by another program")
    assert client.put("/api/file/mine", content="c", headers={"If-Match": second.headers["etag"]}).status_code == 409
    (tmp_path / "mine.toml").unlink()
    gone = client.put("/api/file/mine", content="c", headers={"If-Match": second.headers["etag"]})
    assert gone.json() == {"mine": "c", "theirs": None, "etag": None}


NAMES = ["..", ".", ".hidden", "a.b", "a b", "CON", "nul", "com1", "LPT9", "x" * 61, "a\nb", "a;b", "a:b", "~", "%00", "COM¹"]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_that_some_system_misreads_is_refused(client, tmp_path, name):
    path = f"/api/file/{''.join(f'%{byte:02x}' for byte in name.encode())}"
    for answer in (client.get(path), client.put(path, content="a", headers=NEW)):
        assert answer.status_code in {403, 404}
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("path", ["/api/file/../../etc/passwd", "/api/file/..%2fx", "/api/file/%2e%2e%2fx", "/api/file//etc/x"])
def test_no_path_leads_out(client, tmp_path, path):
    (tmp_path.parent / "x.toml").write_text("outside", encoding="utf-8")
    assert "outside" not in client.get(path).text
    assert client.put(path, content="in", headers=NEW).status_code in {403, 404, 405}
    assert (tmp_path.parent / "x.toml").read_text(encoding="utf-8") == "outside"


@pytest.mark.parametrize("name", ["вариант", "варіант_2", "题目", "a-1", "-x", "_"])
def test_words_of_any_language_are_names(client, name):
    assert client.put(f"/api/file/{name}", content="a", headers=NEW).status_code == 201


def test_links_are_not_followed_out(client, tmp_path):
    outside = tmp_path.parent / "outside.toml"
    outside.write_text("outside", encoding="utf-8")
    (tmp_path / "link.toml").symlink_to(outside)
    (tmp_path / "t.csv").symlink_to(outside)
    assert client.get("/api/file/link").status_code == 404
    assert client.get("/api/files").json() == []
    text = TEXT + '[functions]\nf = { table = "t.csv", of = "t", method = "spline" }\n'
    told = client.post("/api/check", json={"text": text}).text
    assert "outside" not in told
    assert "There is" not in told, "what leads out is not offered"
    (tmp_path / "t.csv").unlink()
    (tmp_path / "t.csv").symlink_to("t.csv")
    (tmp_path / "own.csv").write_text("0,1", encoding="utf-8")
    told = client.post("/api/check", json={"text": text}).json()["faults"]
    assert "cannot be read: Too many levels of symbolic links" in told[0]["sentence"]
    told = client.post("/api/check", json={"text": text.replace("t.csv", "u.csv")}).json()["faults"]
    assert "There is: own.csv." in told[0]["sentence"]


def test_a_pipe_is_not_waited_for(client, tmp_path):
    os.mkfifo(tmp_path / "pipe.toml")
    assert client.get("/api/file/pipe").status_code == 404
    assert client.get("/api/files").json() == []


def test_what_is_no_file_or_cannot_be_read_costs_only_itself(client, tmp_path):
    client.put("/api/file/mine", content='[functions]\nf = { table = "f.csv" }', headers=NEW)
    for name in ("loop.toml", "f.csv"):
        (tmp_path / name).symlink_to(name)
    (tmp_path / "folder.toml").mkdir()
    assert client.get("/api/file/folder").status_code == 404
    answer = client.get("/api/file/loop")
    assert answer.status_code == 403 and answer.json()["sentence"].startswith("loop.toml cannot be opened: "), answer.text
    assert [each["name"] for each in client.get("/api/files").json()] == ["mine"]
    assert zipfile.ZipFile(io.BytesIO(client.get("/api/zip").content)).namelist() == ["mine.toml"]


def test_what_is_deleted_can_be_brought_back(client, tmp_path):
    version = client.put("/api/file/mine", content="a", headers=NEW).headers["etag"]
    assert client.delete("/api/file/mine").status_code == 428
    assert client.delete("/api/file/mine", headers={"If-Match": version}).status_code == 204
    assert [(each["name"], each["deleted"]) for each in client.get("/api/files").json()] == [("mine", True)]
    assert (tmp_path / ".deleted" / "mine.toml").read_text(encoding="utf-8") == "a"
    assert client.post("/api/file/mine", json={"restore": True}).status_code == 204
    assert client.get("/api/file/mine").text == "a"
    assert client.post("/api/file/mine", json={"restore": True}).status_code == 409


def test_rename_and_duplicate_overwrite_nothing(client):
    for name in ("a", "b"):
        client.put(f"/api/file/{name}", content=name, headers=NEW)
    for wish in ("rename", "duplicate"):
        assert client.post("/api/file/a", json={wish: "b"}).status_code == 409
        assert client.post("/api/file/a", json={wish: "../c"}).status_code == 403
        assert client.post("/api/file/no", json={wish: "c"}).status_code == 404
    assert client.post("/api/file/a", json={"duplicate": "c"}).status_code == 204
    assert client.post("/api/file/a", json={"rename": "d"}).status_code == 204
    assert client.post("/api/file/a", json={"other": 1}).status_code == 422
    assert [each["name"] for each in client.get("/api/files").json()] == ["b", "c", "d"]
    assert client.get("/api/file/d").text == "a"


def test_a_copy_of_a_variant_brings_its_tables(client, tmp_path):
    name = next(path.stem for path in sorted(VARIANTS.glob("*.toml")) if "table = " in path.read_text(encoding="utf-8"))
    text = (VARIANTS / f"{name}.toml").read_text(encoding="utf-8")
    client.put("/api/file/mine", content=text.encode(), headers=NEW)
    table = text.partition('table = "')[2].partition('"')[0]
    assert (tmp_path / table).read_bytes() == (VARIANTS / table).read_bytes()


def test_two_desks_that_write_at_once_do_not_lose_each_others_text(tmp_path):
    Folder(tmp_path).write("mine", b"0", None)

    def write(number: int) -> bool:
        try:
            return not Folder(tmp_path).write("mine", str(number).encode(), etag_of(b"0"))
        except Stale:
            return False

    with ThreadPoolExecutor(8) as threads:
        assert sum(threads.map(write, range(1, 17))) == 1
    assert [path.name for path in tmp_path.iterdir()] == ["mine.toml"]


def test_what_a_killed_process_left_is_removed(tmp_path):
    left = tmp_path / ".coursework-0.part"
    left.write_bytes(b"half")
    os.utime(left, (0, 0))
    Folder(tmp_path).clear()
    assert not any(tmp_path.iterdir())


def test_a_desk_that_opens_removes_what_a_killed_one_had_begun_to_write(tmp_path):
    """What is younger than a minute may be written at this very moment."""
    old, young, own = (tmp_path / name for name in (".coursework-1.part", ".coursework-2.part", "mine.toml"))
    for path, age in ((old, LEFT_OVER + 5), (young, LEFT_OVER - 5), (own, 1e6)):
        path.write_text("x")
        os.utime(path, (time.time() - age,) * 2)
    with desk(tmp_path):
        assert {path.name for path in tmp_path.iterdir()} >= {young.name, own.name}
        assert not old.exists()
