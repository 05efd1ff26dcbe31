"""The access control: the right host, no foreign page, the cookie of this desk, not too many requests.

Enters: requests.  Leaves: those that may pass; all others are refused with a status.  Used by `application.py`.

The secret in the opened address becomes a cookie and disappears from the address bar.  Pages of other origins are kept out by
the headers Host (other names may be made to point here) and Origin, and by the cookie's SameSite.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Sequence
from dataclasses import field
from hmac import compare_digest

from starlette.datastructures import MutableHeaders
from starlette.requests import Request
from starlette.responses import RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from coursework.desk.job import FORBIDDEN, tell_place, told
from coursework.desk.serving.limits import Limits
from coursework.desk.serving.replies import language_of, reply
from coursework.system.frozen import frozen

NO_COOKIE, TOO_MANY, MOVED = 401, 429, 303
OPEN = ("/health", "/metrics")  # need no cookie and reveal no names
LOCAL = ("127.0.0.1", "localhost", "[::1]")
HEADERS = {
    "X-Content-Type-Options": "nosniff", "Referrer-Policy": "no-referrer", "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin", "Cache-Control": "no-store", "X-Frame-Options": "SAMEORIGIN",
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
}  # fmt: skip


@frozen
class Gate:
    """The access rules of a desk: `port` of the server; a `secret` known to the user who opened it ("": open to everybody).

    `hosts`: its other names; `root`: prefix of every path, whether or not a proxy strips it; `proxied`: trust what a proxy
    says about the client; `limits` of a desk that is open to others.
    """

    port: int
    secret: str = ""
    hosts: Sequence[str] = ()
    root: str = ""
    proxied: bool = False
    limits: Limits | None = None
    cookie: str = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "cookie", f"coursework-desk-{self.port}")  # two desks do not log each other out

    def knows(self, host: str) -> bool:
        """Return whether `host`, with or without a port, is a name of this desk."""
        local = (f"{name}:{self.port}" for name in LOCAL)
        return host.lower() in {*local, *self.hosts} or host.rpartition(":")[0].lower() in self.hosts


class Guard:
    """The ASGI application in front of all others, which lets requests pass or refuses them."""

    def __init__(self, app: ASGIApp, gate: Gate) -> None:
        self.app, self.gate = app, gate

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let a request pass, or refuse it; errors of the application are reported without any of the user's text."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        scope["root_path"] = self.gate.root
        if not scope["path"].startswith(f"{self.gate.root}/"):
            scope["path"] = self.gate.root + scope["path"]
        request = Request(scope, receive)

        async def sent(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
            await send(message)

        scope["state"] = {"client": request.cookies.get(self.gate.cookie, ""), "limited": False}
        refusal = self._refusal(request)
        try:
            await (refusal or self.app)(scope, receive, sent)
        except Exception as error:  # which the application has answered
            tell_place(error)
        finally:
            if scope["state"]["limited"] and self.gate.limits:
                self.gate.limits.end(scope["state"]["limited"])

    def _refusal(self, request: Request) -> Response | None:
        gate, path = self.gate, request.scope["path"].removeprefix(self.gate.root)
        host = request.headers.get("x-forwarded-host" if gate.proxied else "host") or request.headers.get("host", "")
        origin = request.headers.get("origin")
        if not gate.knows(host):
            return self._told(request, FORBIDDEN, "desk.other_host")
        if origin is not None and origin.partition("://")[2].lower() != host.lower():
            return self._told(request, FORBIDDEN, "desk.other_origin")
        if path in OPEN:
            return None
        if gate.secret:
            return self._without_cookie(request, path)
        return self._too_often(request, path, gate.limits) if gate.limits else None

    def _without_cookie(self, request: Request, path: str) -> Response | None:
        known = self.gate.secret.encode()
        if path == "/" and compare_digest(request.query_params.get("secret", "").encode("utf-8", "replace"), known):
            moved = RedirectResponse(self.gate.root + "/", MOVED)
            moved.set_cookie(self.gate.cookie, self.gate.secret, httponly=True, samesite="strict", path="/")
            return moved
        if compare_digest(request.scope["state"]["client"].encode("utf-8", "replace"), known):
            return None
        return self._told(request, NO_COOKIE, "desk.no_cookie")

    def _too_often(self, request: Request, path: str, limits: Limits) -> Response | None:
        """Count a request that costs something, by browser and by address; return a refusal if there are too many."""
        if not path.startswith("/api/"):
            return None
        address = request.client.host if request.client else ""
        if self.gate.proxied:  # the last entry is the proxy's own; anybody can write those before it
            address = request.headers.get("x-forwarded-for", address).rpartition(",")[2].strip()
        client = request.scope["state"]["client"] or address
        if request.method == "GET":  # made once for all: what is typed beside a catalogue under way is none too many
            wait = limits.too_often(client, address, time.monotonic())
        elif not (wait := limits.wait(client, address, time.monotonic())):
            limits.begin(client)
            request.scope["state"]["limited"] = client
        return self._told(request, TOO_MANY, "desk.too_many", {"Retry-After": str(wait)}) if wait else None

    def _told(self, request: Request, status: int, key: str, headers: dict[str, str] | None = None) -> Response:
        return reply(told(status, language_of(request), key), {**(headers or {}), "Connection": "close"})


def new_cookie(response: Response, gate: Gate, secure: bool) -> None:
    """Give a browser a random name, by which its requests are counted."""
    response.set_cookie(gate.cookie, secrets.token_urlsafe(16), httponly=True, samesite="strict", secure=secure, path="/")
