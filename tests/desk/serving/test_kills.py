"""The server is killed at fifty moments while a text is written, renamed, deleted, brought back: none is half, none is lost."""

from __future__ import annotations

import http.client
import signal
import threading
from pathlib import Path

import pytest

from coursework.desk.serving.folder import etag_of
from tests.desk.serving.server import Server, running

MOMENTS, ASKED = 50, (7, 31)  # the gate asks two of them
SIZE = 20_000  # lines: long enough to be met half written


def text(number: int) -> bytes:
    return b"# %d\n" % number * SIZE


class Writer(threading.Thread):
    """Writes one version after the other, and moves the file about, until nobody answers; knows what was answered last."""

    def __init__(self, server: Server) -> None:
        super().__init__(daemon=True)
        self.server, self.begun, self.done, self.number = server, threading.Event(), -1, 0

    def run(self) -> None:
        name, seen = "mine", {"If_None_Match": "*"}
        try:
            for self.number in range(10**6):
                assert self.server.ask("PUT", f"/api/file/{name}", text(self.number), **seen)[0] in {200, 201}
                self.done, seen = self.number, {"If_Match": etag_of(text(self.number))}
                self.begun.set()
                other = "other" if name == "mine" else "mine"
                if self.number % 4 == 1:
                    assert self.server.ask("DELETE", f"/api/file/{name}", **seen)[0] == 204
                    assert self.server.ask("POST", f"/api/file/{name}", {"restore": True})[0] == 204
                elif self.number % 4 == 3:
                    assert self.server.ask("POST", f"/api/file/{name}", {"rename": other})[0] == 204
                    name = other
        except (OSError, http.client.HTTPException):
            pass


@pytest.mark.parametrize("moment", [one if one in ASKED else pytest.param(one, marks=pytest.mark.long) for one in range(MOMENTS)])
def test_no_file_is_half_written_and_no_text_lost(moment: int, tmp_path: Path) -> None:
    with running("edit", "--no-browser", folder=tmp_path) as server:
        writer = Writer(server)
        writer.start()
        assert writer.begun.wait(60)
        writer.join(moment * 0.004)
        server.process.send_signal(signal.SIGKILL)
        writer.join(60)
    assert not writer.is_alive()
    files = {path: path.read_bytes() for path in tmp_path.rglob("*.toml")}
    whole = {number: text(number) for number in range(writer.number + 1)}
    assert files
    assert all(content in whole.values() for content in files.values())
    assert any(whole[number] in files.values() for number in range(writer.done, writer.number + 1))
