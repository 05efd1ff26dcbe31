"""What is taken away from the desk and brought back, and what a table of one's own is worth."""

from __future__ import annotations

import base64
import io
import zipfile
from pathlib import Path

import pytest

from coursework.api import solve
from coursework.desk.job import Policy
from coursework.report.output.results import Results
from coursework.variant.reading.reader import parse_variant
from tests.desk.desks import TEXT, VARIANTS, desk
from tests.grading.batch.classroom import csv
from tests.grading.marking import students

NEW = {"If-None-Match": "*"}


@pytest.fixture
def client(tmp_path: Path):
    with desk(tmp_path) as opened:
        yield opened


def test_a_format_is_the_file_of_run(client):
    answer = client.post("/api/take/csv", json={"text": TEXT, "name": "mine"})
    (table,) = dict(Results(solve(parse_variant(TEXT, "mine"))).tables()).values()
    assert (answer.text, answer.headers["content-type"]) == (table, "text/csv; charset=utf-8")
    assert "mine.csv" in answer.headers["content-disposition"]


def test_a_format_of_several_files_is_one_zip(client):
    text = (VARIANTS / "example-1.toml").read_text(encoding="utf-8")
    answer = client.post("/api/take/csv", json={"text": text, "name": "mine"})
    files = dict(Results(solve(parse_variant(text, "mine"))).tables())
    assert len(files) > 1
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        assert {name: archive.read(name).decode() for name in archive.namelist()} == files
    assert "mine-csv.zip" in answer.headers["content-disposition"]


@pytest.mark.long
def test_a_page_on_a_screen_and_one_on_paper(client):
    page = client.post("/api/take/html", json={"text": TEXT, "name": "mine"})
    assert page.headers["content-type"].startswith("text/html")
    assert page.content.startswith(b"<!DOCTYPE html>")
    pdf = client.post("/api/take/pdf", json={"text": TEXT, "name": "mine"})
    assert (pdf.headers["content-type"], pdf.content[:5]) == ("application/pdf", b"%PDF-")


def test_what_there_is_not_or_is_not_offered(client):
    (fault,) = client.post("/api/take/docx9", json={"text": TEXT}).json()["faults"]
    assert fault["code"] == "C015"
    assert client.post("/api/take/csv", json={"text": ""}).json()["faults"]
    with desk(policy=Policy(formats=("csv",))) as client:
        assert client.post("/api/take/html", json={"text": TEXT}).status_code == 403
        assert client.post("/api/take/csv", json={"text": TEXT}).status_code == 200


def tried(client, name: str, content: bytes) -> dict:
    return client.post(
        "/api/table", json={"text": TEXT, "name": name, "data": base64.b64encode(content).decode()}
    ).json()  # fmt: skip


def test_an_own_table_is_told_as_precheck_does(client):
    found = tried(client, "table.csv", csv(students.table()))
    assert found["state"] == "read"
    assert any("25" in sentence for sentence in found["sentences"])
    assert any("ω₄" in sentence for sentence in found["sentences"])
    assert tried(client, "table.csv", b"")["state"] == "unreadable"
    assert tried(client, "table.csv", csv(students.table()[:5]))["state"] == "partly"
    assert client.post("/api/table", json={"text": TEXT, "name": "a", "data": "###"}).status_code == 422


def test_a_table_may_be_larger_than_a_text(client):
    body = {"text": TEXT, "name": "a.csv", "data": "A" * 2 * 10**6}
    assert client.post("/api/table", json=body).status_code == 200
    assert client.post("/api/table", json=body | {"data": "A" * 6 * 10**6}).status_code == 413


def test_all_work_goes_into_a_zip_and_comes_back_on_another_computer(client, tmp_path):
    name = next(path.stem for path in sorted(VARIANTS.glob("*.toml")) if "table = " in path.read_text(encoding="utf-8"))
    client.put("/api/file/mine", content=(VARIANTS / f"{name}.toml").read_bytes(), headers=NEW)
    client.put("/api/file/other", content="a", headers=NEW)
    packed = client.get("/api/zip")
    assert packed.headers["content-type"] == "application/zip"
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "other.toml").write_text("b", encoding="utf-8")
    with desk(elsewhere) as second:
        found = second.post("/api/zip", content=packed.content).json()
        assert [each["name"] for each in found["skipped"]] == ["other.toml"]
        assert found["skipped"][0]["sentence"].endswith("Rename the file and open it again.")
        assert (elsewhere / "other.toml").read_text(encoding="utf-8") == "b"
        assert (elsewhere / "mine.toml").read_bytes() == (tmp_path / "mine.toml").read_bytes()
        assert len(found["written"]) == 2
        assert second.post("/api/zip", content=packed.content).json()["skipped"][0]["name"] == "other.toml"
        assert second.post("/api/zip", content=b"PK\x03\x04 no").status_code == 422


def test_a_hostile_zip_writes_nothing_outside(client, tmp_path):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("../out.toml", "/abs.toml", "a/../../up.toml", "CON.toml", "x.exe", ".deleted", "bomb.toml"):
            archive.writestr(name, b"0" * (10**7 if name == "bomb.toml" else 1))
    found = client.post("/api/zip", content=content.getvalue()).json()
    assert found["written"] == ["abs.toml", "out.toml", "up.toml"]  # by their names alone, in this folder
    why = {each["name"]: each["sentence"] for each in found["skipped"]}
    assert set(why) == {"CON.toml", "x.exe", ".deleted", "bomb.toml"}
    assert "cannot be the name of a file here" in why["CON.toml"] and "neither a variant nor a table" in why["x.exe"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["abs.toml", "out.toml", "up.toml"]
    assert not (tmp_path.parent / "out.toml").exists()


def test_no_file_of_a_zip_is_lost_unsaid(client, tmp_path):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("a/mine.toml", "b/mine.toml"):
            archive.writestr(name, name * 99)
    found = client.post("/api/zip", content=content.getvalue()).json()
    assert (found["written"], [each["name"] for each in found["skipped"]]) == (["mine.toml"], ["mine.toml"])
    assert (tmp_path / "mine.toml").read_text(encoding="utf-8") == "a/mine.toml" * 99
    start = 30 + len("a/mine.toml")  # of what is compressed, behind the head of its entry
    damaged = content.getvalue()[:start] + b"\xff" * 9 + content.getvalue()[start + 9 :]
    assert client.post("/api/zip", content=damaged).status_code == 422


def test_a_table_too_large_for_a_zip_is_left_out_whole(client, tmp_path):
    client.put("/api/file/mine", content='[functions]\nf = { table = "f.csv" }', headers=NEW)
    for size, packed in ((10**6, ["mine.toml", "f.csv"]), (10**6 + 1, ["mine.toml"])):
        (tmp_path / "f.csv").write_bytes(b"0" * size)
        assert zipfile.ZipFile(io.BytesIO(client.get("/api/zip").content)).namelist() == packed
