"""The server of the desk, started from the options of the command line, until Ctrl-C.

Enters: `Wish`.  Leaves: the address on standard output, then answers to requests.  Used by `commands/desk.py`.
"""

from __future__ import annotations

import asyncio
import errno
import os
import secrets
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable

import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from coursework.desk.serving.application import Application, Wish
from coursework.desk.serving.config import opened
from coursework.desk.serving.guard import Gate
from coursework.desk.serving.limits import Limits
from coursework.words.errors import InputError
from coursework.words.reasons import reason_of
from coursework.words.sentences import say

TRIED = 50  # ports tried, from the wished one on
LEAVING = 1  # s that a connection has to end by itself
MOST_CONNECTIONS = 500
BEAT = 0.5  # s between two checks whether to end
SILENCE = 20.0  # s allowed from the opening of a connection to the end of the head of a request
HERE = "127.0.0.1"


class Impatient(H11Protocol):
    """A connection that is closed if no request comes in time, so that silent connections do not use up the limit."""

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Start the time limit for the first request."""
        super().connection_made(transport)
        self.loop.call_later(SILENCE, self._look)

    def _look(self) -> None:
        if self.cycle is None:
            self.transport.close()


class Calm(uvicorn.Server):
    """A server that checks twice a second whether to end: ten times, as usual, would cost 1 % of a processor all day."""

    async def main_loop(self) -> None:
        """Update the date in the headers until it is time to end."""
        while not await self.on_tick(0):
            await asyncio.sleep(BEAT)


def serve(wish: Wish, tell: Callable[[str], None]) -> None:
    """Answer requests until Ctrl-C, which becomes `KeyboardInterrupt`; `tell` writes messages to standard error."""
    begin = opened(wish.name, wish.folder)
    sockets, port = bound(wish.host, wish.port)
    if wish.port not in {0, port}:
        tell(say("desk.port_taken", wished=wish.port, port=port))
    secret = secrets.token_urlsafe(32) if wish.folder else ""
    named = [wish.host.lower()] if wish.host not in {"", "0.0.0.0", "::"} else []
    hosts = (*(host.lower() for host in wish.hosts), *(f"{_bracketed(name)}:{port}" for name in named))
    gate = Gate(port, secret, hosts, wish.root_path, wish.proxied, None if wish.folder else Limits())
    shown = HERE if wish.host in {"", "0.0.0.0", "::"} else _bracketed(wish.host)
    address = f"http://{shown}:{port}{wish.root_path}/" + (f"?secret={secret}" if secret else "")
    sys.stdout.write(address + "\n")
    sys.stdout.flush()
    if wish.host:
        tell(say("desk.open_to_others", host=wish.host))
    config = uvicorn.Config(
        Application(wish, gate, begin).asgi(), lifespan="on", ws="none", http=Impatient, log_level="critical", access_log=False,
        server_header=False, proxy_headers=False, limit_concurrency=MOST_CONNECTIONS, timeout_graceful_shutdown=LEAVING,
    )  # fmt: skip
    if wish.browser:
        threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()
    asyncio.run(Calm(config).serve(sockets))


def _bracketed(host: str) -> str:
    return f"[{host}]" if ":" in host else host


def bound(host: str, wished: int) -> tuple[list[socket.socket], int]:
    """Return sockets and their port: on `host`, or only on this machine (IPv4 and IPv6) if `host` is "".

    If the `wished` port is taken, the next free one is used; 0 means any port.  Raises `InputError` if there is none.
    """
    last = min(wished + TRIED, 2**16) - 1
    for port in range(wished, last + 1) if wished else [0] * TRIED:
        try:
            return _listening(host, port)
        except (OSError, UnicodeError) as error:  # a name with a part that is empty or too long is no text for Python
            if getattr(error, "errno", 0) not in {errno.EADDRINUSE, errno.EACCES}:
                raise InputError(say("fault.C086", host=host or HERE, reason=reason_of(error))) from None
    raise InputError(say("fault.C085", wished=wished, last=last))


def _listening(host: str, port: int) -> tuple[list[socket.socket], int]:
    first = _socket(host or HERE, port)
    port = first.getsockname()[1]
    if host:
        return [first], port
    try:
        return [first, _socket("::1", port)], port
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            first.close()
            raise
        return [first], port  # a machine without IPv6


def _socket(host: str, port: int) -> socket.socket:
    family, *_, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    listening = socket.socket(family, socket.SOCK_STREAM)
    try:
        if os.name == "posix":  # on Windows it would let two servers have one port
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if family == socket.AF_INET6:
            listening.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
        listening.bind(address)
        listening.listen(socket.SOMAXCONN)
    except OSError:
        listening.close()
        raise
    return listening
