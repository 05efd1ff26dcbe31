"""The real command as a process of its own, and a client that speaks to its sockets."""

from __future__ import annotations

import contextlib
import http.client
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit


@dataclass
class Server:
    """A running desk: its process, the address that it printed."""

    process: subprocess.Popen[str]
    address: str

    @property
    def port(self) -> int:
        return urlsplit(self.address).port or 0

    @property
    def secret(self) -> str:
        return parse_qs(urlsplit(self.address).query).get("secret", [""])[0]

    def connection(self, timeout: float = 60) -> http.client.HTTPConnection:
        return http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)

    def ask(self, method: str, path: str, body: Any = None, **headers: str) -> tuple[int, dict[str, str], bytes]:
        content = body if isinstance(body, (bytes, type(None))) else json.dumps(body).encode()
        connection = self.connection()
        cookie = {"Cookie": f"coursework-desk-{self.port}={self.secret}"} if self.secret else {}
        with contextlib.closing(connection):
            connection.request(method, path, content, cookie | {name.replace("_", "-"): value for name, value in headers.items()})
            answer = connection.getresponse()
            return answer.status, {name.lower(): value for name, value in answer.getheaders()}, answer.read()

    def check(self, text: str, **more: Any) -> Any:
        return json.loads(self.ask("POST", "/api/check", {"text": text, **more})[2])

    def workers(self) -> list[int]:
        """The processes that compute."""
        listed = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children")
        found = [Path(path) for path in Path(f"/proc/{self.process.pid}/task").glob("*/children")] or [listed]
        return [int(child) for path in found for child in path.read_text().split()]


@contextlib.contextmanager
def running(*words: str, folder: Path, port: int = 0, **environment: str) -> Iterator[Server]:
    """Start a desk, on any port where none is said, and end it with what is left."""
    command = [sys.executable, "-m", "coursework", *words, "--port", str(port)]
    process = subprocess.Popen(
        command, cwd=folder, env=os.environ | {"PYTHONPATH": str(Path(__file__).parents[3])} | environment,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    try:
        assert process.stdout is not None
        yield Server(process, process.stdout.readline().strip())
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGKILL)
        process.communicate()
