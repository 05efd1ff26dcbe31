"""The real server: what it prints, that one bad request harms nobody else, that nothing is left running."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import json
import os
import resource
import signal
import socket
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import uvicorn
from uvicorn.server import ServerState

import coursework
from coursework.desk.serving import server as server_module
from coursework.desk.serving.server import Impatient
from tests.desk.desks import TEXT, ended
from tests.desk.serving.server import Server, running

NEW = {"If_None_Match": "*"}


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    with running("edit", "31", "--no-browser", "--budget", "3", "--memory", "600", folder=tmp_path_factory.mktemp("desk")) as one:
        yield one


def test_the_first_line_is_the_address_with_its_secret(server: Server):
    assert server.address.startswith("http://127.0.0.1:")
    assert len(server.secret) >= 43
    assert server.ask("GET", "/health")[0] == 200
    assert server.check(TEXT)["faults"] == []


def test_it_listens_on_this_machine_alone(server: Server):
    with (
        contextlib.suppress(OSError),
        socket.create_connection(("::1", server.port), 5) as line,
    ):  # where there is such an address
        line.sendall(f"GET /health HTTP/1.1\r\nHost: [::1]:{server.port}\r\n\r\n".encode())
        assert b"200" in line.recv(100)
    own = socket.gethostbyname(socket.gethostname())
    if not own.startswith("127."):
        with pytest.raises(OSError):
            socket.create_connection((own, server.port), 2).close()


def test_a_worker_that_is_killed_is_replaced_and_counted(server: Server):
    assert server.check(TEXT)["faults"] == []
    for worker in server.workers():
        os.kill(worker, signal.SIGKILL)
    assert server.check(TEXT)["faults"] == []
    assert b"coursework_workers_restarted_total 0" not in server.ask("GET", "/metrics")[2]


def test_a_text_without_end_costs_its_budget_and_the_desk_goes_on(server: Server):
    (fault,) = server.check(TEXT.replace('"0.48 s"', '"3990 s"'))["faults"]
    assert (fault["code"], fault["line"]) == ("E001", None)
    assert server.check(TEXT)["faults"] == []


def test_a_body_that_does_not_end_and_200_connections_harm_nobody(server: Server):
    lines = []
    for number in range(200):
        line = socket.create_connection(("127.0.0.1", server.port), 5)
        half = f"POST /api/check HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nContent-Length: 100\r\n"
        line.sendall((half + ("\r\n{" if number % 2 else "")).encode())
        lines.append(line)
    assert server.check(TEXT)["faults"] == []
    for line in lines:
        line.close()


def test_a_body_of_30_mb_is_refused_before_it_has_come(server: Server):
    connection = server.connection()
    connection.putrequest("POST", "/api/check")
    connection.putheader("Content-Length", str(30 * 10**6))
    connection.putheader("Cookie", f"coursework-desk-{server.port}={server.secret}")
    connection.endheaders()
    answer = connection.getresponse()
    assert (answer.status, answer.getheader("Connection")) == (413, "close")  # what is still to come nobody reads
    connection.close()


def test_who_sends_too_much_at_once_hears_why(server: Server):
    status, _, body = server.ask("POST", "/api/table", {"text": "", "name": "t.csv", "data": "A" * 7 * 10**6})
    assert status == 413
    assert b"6000000 bytes" in body


def test_a_newer_text_of_the_same_desk_is_answered_and_the_older_is_not(server: Server):
    slow = TEXT.replace('"0.48 s"', '"48 s"').replace('"table",', '"table", "accelerations",')
    with ThreadPoolExecutor(8) as threads:
        older = [threads.submit(server.ask, "POST", "/api/page", {"text": slow}, X_Desk="one") for _ in range(4)]
        time.sleep(0.1)
        newer = server.ask("POST", "/api/page", {"text": TEXT}, X_Desk="one")
        assert newer[0] == 200
        assert json.loads(newer[2])["page"]
        statuses = [one.result()[0] for one in older]
    assert statuses.count(409) >= 3


def test_what_another_program_changes_is_told_at_once(server: Server, tmp_path_factory):
    connection = server.connection(20)
    connection.request("GET", "/api/events", headers={"Cookie": f"coursework-desk-{server.port}={server.secret}"})
    stream = connection.getresponse()
    lines = iter(stream.readline, b"")
    first = next(line for line in lines if line.startswith(b"data:"))
    folder = Path(f"/proc/{server.process.pid}/cwd").resolve()
    (folder / "changed.toml").write_text("a", encoding="utf-8")
    told = json.loads(next(line for line in lines if line.startswith(b"data:"))[5:])
    assert "changed" not in first.decode()
    assert [each["name"] for each in told] == ["changed"]
    connection.close()


@pytest.mark.parametrize(("words", "end", "status"), [
    (("edit", "--no-browser"), signal.SIGINT, 130), (("serve",), signal.SIGKILL, -signal.SIGKILL),
])  # fmt: skip
def test_no_process_is_left(tmp_path, words, end, status):
    with running(*words, folder=tmp_path) as server:
        children = until(server.workers)
        server.process.send_signal(end)
        assert server.process.wait(60) == status
        until(lambda: not any(Path(f"/proc/{child}").exists() for child in children))


def until(found, patience: float = 60.0):
    """Return what is found once it is something."""
    late = time.monotonic() + patience
    while not (what := found()):
        assert time.monotonic() < late
        time.sleep(0.02)
    return what


def test_a_port_in_use_is_told_and_the_next_one_taken(tmp_path):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with running("serve", folder=tmp_path) as server:
            assert server.port != port
        command = [sys.executable, "-m", "coursework", "serve", "--port", str(port)]
        process = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        address = process.stdout.readline()
        told = process.stderr.readline()
        process.kill()
        process.communicate()
        assert f":{port}/" not in address
        assert f"Port {port} is taken" in told


def test_a_full_disk_leaves_the_file_as_it_was_and_says_so(tmp_path):
    (tmp_path / "mine.toml").write_text("old", encoding="utf-8")

    def small() -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    # Python, in the workers of the desk too, would leave the first kilobyte of a compiled module for every other test.
    known = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", "coursework", "edit", "--no-browser", "--port", "0"]
    process = subprocess.Popen(
        command, cwd=tmp_path, env=known, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=small
    )
    try:
        server = Server(process, process.stdout.readline().strip())
        version = server.ask("GET", "/api/file/mine")[1]["etag"]
        status, _, body = server.ask("PUT", "/api/file/mine", b"x" * 5000, If_Match=version)
        assert status == 507
        assert "Give me" in json.loads(body)["sentence"]
        assert (tmp_path / "mine.toml").read_text(encoding="utf-8") == "old"
        assert [path.name for path in tmp_path.iterdir()] == ["mine.toml"]
        assert server.ask("PUT", "/api/file/mine", b"new", If_Match=version)[0] == 200
    finally:
        process.kill()
        process.communicate()


def test_a_desk_looks_twice_a_second_whether_to_end_and_renews_the_date_of_answers(monkeypatch):
    config = uvicorn.Config(lambda *_: None, lifespan="off")
    config.load()
    calm, slept = server_module.Calm(config), []

    async def sleep(seconds: float) -> None:
        slept.append(seconds)
        calm.should_exit = len(slept) == 3

    monkeypatch.setattr(asyncio, "sleep", sleep)
    with pytest.raises(StopIteration):  # nothing in it waits but for that sleep, so no loop has to run
        calm.main_loop().send(None)
    assert slept == [0.5] * 3 and b"date" in dict(calm.server_state.default_headers)


def test_a_line_without_a_request_is_closed(monkeypatch):
    assert 5 <= server_module.SILENCE <= 60  # s: a slow line comes through, an idle one gives its place to others
    monkeypatch.setattr(server_module, "SILENCE", 0.05)

    async def opened() -> bytes:
        config = uvicorn.Config(lambda *_: None, lifespan="off")
        config.load()
        state = ServerState()
        listening = await asyncio.get_running_loop().create_server(lambda: Impatient(config, state, {}), "127.0.0.1", 0)
        async with listening:
            reader, writer = await asyncio.open_connection(*listening.sockets[0].getsockname())
            writer.write(b"GET /health HTTP/1.1\r\nHost:")
            found = await asyncio.wait_for(reader.read(), 30)
            writer.close()
        return found

    assert ended(opened()) == b""


def test_a_port_beyond_all_is_not_tried_and_a_host_of_no_name_is_told(monkeypatch):
    tried = []

    def taken(host: str, port: int) -> tuple[list[socket.socket], int]:
        tried.append(port)
        raise OSError(errno.EADDRINUSE, "")

    with pytest.raises(coursework.InputError, match=r"C086 the desk cannot be reached at a\.\.b: no network of this machine"):
        server_module.bound("a..b", 0)
    monkeypatch.setattr(server_module, "_listening", taken)
    for wished, last in ((65486, 65535), (65485, 65534), (65535, 65535)):
        tried.clear()
        with pytest.raises(coursework.InputError, match=f"C085 no port from {wished} to {last} is free"):
            server_module.bound("", wished)
        assert tried == [*range(wished, last + 1)]
