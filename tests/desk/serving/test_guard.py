"""Who may ask: every attack from another page, another machine or in too great a number is refused."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from coursework.desk.serving.limits import Limits
from coursework.words.sentences import say
from tests.desk.desks import COOKIE, HOST, PORT, SECRET, TEXT, Here, desk

CHECK = {"json": {"text": ""}}


@pytest.fixture
def client(tmp_path: Path):
    with desk(tmp_path) as opened:
        yield opened


def test_the_secret_becomes_a_cookie_and_leaves_the_address(client):
    client.cookies.clear()
    answer = client.get("/", params={"secret": SECRET})
    assert (answer.status_code, answer.headers["location"]) == (303, "/")
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith(f"{COOKIE}={SECRET}")
    assert "HttpOnly" in cookie
    assert "samesite=strict" in cookie.lower()
    assert client.get("/api/files").status_code == 200


def test_a_fault_of_ours_is_told_in_a_sentence_and_without_what_was_typed(client, monkeypatch, capsys):
    async def breaks(self, job, desk, gone):
        gone.close()
        raise RuntimeError("typed: r = 1")

    monkeypatch.setattr(Here, "answer", breaks)
    answer = client.post("/api/check", **CHECK)
    assert (answer.status_code, answer.json()["sentence"]) == (500, str(say("desk.our_fault")))
    told = capsys.readouterr().err
    assert told.startswith("RuntimeError in test_guard.py:") and "typed" not in told


@pytest.mark.parametrize("cookies", [{}, {COOKIE: "x"}, {COOKIE: SECRET[:-1]}, {f"coursework-desk-{PORT + 1}": SECRET}])
@pytest.mark.parametrize("path", ["/", "/desk/main.js", "/desk/frame", "/api/files", "/api/file/31", "/nothing"])
def test_without_the_cookie_of_this_desk_nothing_is_shown(client, cookies, path):
    client.cookies.clear()
    client.cookies.update(cookies)
    answer = client.get(path, params={"secret": "wrong"})
    assert answer.status_code == 401
    assert set(answer.json()) == {"sentence"}


def test_health_and_metrics_need_no_cookie_and_tell_no_names(client):
    client.put("/api/file/secretname", content=TEXT, headers={"If-None-Match": "*"})
    client.post("/api/check", json={"text": TEXT, "name": "secretname"})
    client.cookies.clear()
    assert client.get("/health").text == "ok\n"
    metrics = client.get("/metrics").text
    assert 'coursework_requests_total{route="check",status="200"} 1' in metrics
    assert "secretname" not in metrics


@pytest.mark.parametrize(
    "host", ["evil.example", f"evil.example:{PORT}", "127.0.0.1", f"127.0.0.1:{PORT + 1}", "", f"[::2]:{PORT}"]
)
def test_another_host_is_refused(client, host):
    for path in ("/", "/health", "/api/files"):
        assert (refused := client.get(path, headers={"Host": host})).status_code == 403
        assert "coursework serve --allow-host NAME" in refused.text


@pytest.mark.parametrize("host", [f"localhost:{PORT}", f"[::1]:{PORT}", HOST])
def test_this_machine_has_three_names(client, host):
    assert client.get("/api/files", headers={"Host": host, "Origin": f"http://{host}"}).status_code == 200


@pytest.mark.parametrize(
    "origin", ["null", "", "http://evil.example", f"http://127.0.0.1:{PORT + 1}", f"http://localhost:{PORT}", "["]
)
def test_another_origin_is_refused(client, origin):
    assert client.post("/api/check", headers={"Origin": origin}, **CHECK).status_code == 403


def test_no_answer_lets_other_pages_in(client):
    for answer in (client.get("/health"), client.post("/api/check", **CHECK), client.get("/nothing")):
        assert not [name for name in answer.headers if name.startswith("access-control")]
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert "unsafe" not in answer.headers["content-security-policy"]


def test_a_desk_for_others_has_their_names(tmp_path):
    with desk(hosts=("desk.example",), root="/desk") as client:
        for host in ("desk.example", "desk.example:8080", "DESK.example"):
            assert client.get("/health", headers={"Host": host}).status_code == 200
        assert client.get("/health", headers={"Host": "other.example"}).status_code == 403
        assert client.get("/desk/health").status_code == 200
        assert client.get("/api/files").status_code == 404


def test_a_proxy_is_believed_only_where_there_is_one():
    forwarded = {"X-Forwarded-Host": "desk.example", "Host": "evil.example"}
    with desk(hosts=("desk.example",)) as client:
        assert client.get("/health", headers=forwarded).status_code == 403
    with desk(hosts=("desk.example",), proxied=True) as client:
        assert client.get("/health", headers=forwarded).status_code == 200


def test_a_browser_may_ask_twenty_times_at_once_and_then_waits():
    with desk() as client:
        client.cookies.set(COOKIE, "one")
        answers = [client.post("/api/check", **CHECK) for _ in range(30)]
        assert [answer.status_code for answer in answers[:20]] == [200] * 20
        refused = [answer for answer in answers if answer.status_code == 429]
        assert refused
        assert all(re.fullmatch("[1-9]", answer.headers["retry-after"]) for answer in refused)
        client.cookies.set(COOKIE, "another")
        assert client.post("/api/check", **CHECK).status_code == 200
        assert client.get("/health").status_code == 200


def test_a_school_behind_one_address_may_ask_three_hundred_times():
    limits = Limits()
    waits = [limits.wait(f"browser {number}", "school", 0.0) for number in range(310)]
    assert waits == [0] * 300 + [1] * 10
    assert limits.wait("at home", "another address", 0.0) == 0
    assert [limits.wait("new", "school", 0.5) for _ in range(31)] == [0] * 20 + [1] * 11


def test_a_proxys_word_counts_not_what_stands_before_it():
    with desk(proxied=True) as client:
        client.cookies.clear()
        for number in range(30):  # without a cookie an address is one browser
            answer = client.get("/api/nothing", headers={"X-Forwarded-For": f"10.0.0.{number}, 192.0.2.1"})
        assert answer.status_code == 429


def test_a_browser_has_two_requests_at_once():
    limits = Limits()
    limits.begin("one")
    assert limits.wait("one", "here", 0.0) == 0
    limits.begin("one")
    assert limits.wait("one", "here", 0.0) == 1
    assert limits.too_often("one", "here", 0.0) == 0  # the catalogue, made once for all, may come beside them
    limits.end("one")
    assert limits.wait("one", "here", 0.0) == 0
