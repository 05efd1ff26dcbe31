"""The page of the desk and the files it loads, from `reports/desk/`; a browser caches each file until its content changes.

Enters: requests.  Leaves: the shell, the frame of the report, stylesheets and scripts.  Used by `application.py`.
"""

from __future__ import annotations

import gzip
import hashlib
import re
import secrets
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from starlette.requests import Request
from starlette.responses import HTMLResponse, Response

from coursework.desk.serving.bodies import Refused
from coursework.words.data_folders import REPORTS, folder
from coursework.words.sentences import say
from coursework.words.templates import filled

PLACE = "desk"
NOT_THERE, NOT_CHANGED = 404, 304
FOR_GOOD = "public, max-age=31536000, immutable"
TYPES = {
    ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".json": "application/json", ".txt": "text/plain",
    ".png": "image/png", ".woff2": "font/woff2",
}  # fmt: skip
_NAME = r"[\w./-]{1,200}"
_TEXTS = {".js", ".css", ".svg", ".json", ".txt"}
SHELL = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'nonce-{nonce}'; img-src 'self' data: blob:; connect-src 'self'; "
    "font-src 'self'; frame-src 'self'; form-action 'none'; base-uri 'none'; frame-ancestors 'none'"
)
# The report brings its own styles and scripts: in its own origin they have no access to the desk.
FRAME = (
    "sandbox allow-scripts; default-src 'none'; script-src 'nonce-{nonce}'; style-src 'unsafe-inline'; img-src data: blob:; "
    "font-src data:; connect-src 'none'; form-action 'none'; base-uri 'none'; frame-ancestors 'self'"
)


async def file(request: Request) -> Response:
    """Return one file; a browser may keep it forever if the address contains the hash of its content."""
    name = request.path_params["name"]
    content, packed, version = _piece(_path(name))
    headers = {"ETag": f'"{version}"', "Cache-Control": "no-cache", "Vary": "Accept-Encoding"}
    if request.query_params.get("v") == version:
        headers["Cache-Control"] = FOR_GOOD
    if f'"{version}"' in request.headers.get("if-none-match", ""):
        return Response(status_code=NOT_CHANGED, headers=headers)
    if packed and "gzip" in request.headers.get("accept-encoding", ""):
        return Response(packed, media_type=TYPES[Path(name).suffix], headers=headers | {"Content-Encoding": "gzip"})
    return Response(content, media_type=TYPES[Path(name).suffix], headers=headers)


def shell(root: str, config: Mapping[str, Any], **content: Any) -> Response:
    """Return the page of the desk; `config` is the data of its scripts at the start."""
    return _page("index.html.j2", SHELL, root, config=dict(config), **content)


def frame(root: str, language: str) -> Response:
    """Return the empty page with its own origin into which the shell puts the report."""
    return _page("frame.html.j2", FRAME, root, language=language)


def _page(template: str, policy: str, root: str, **content: Any) -> Response:
    nonce = secrets.token_urlsafe(16)
    if "config" in content:
        content["config"]["nonce"] = nonce

    def asset(name: str) -> str:
        return f"{root}/{PLACE}/{name}?v={_piece(_path(name))[2]}"

    page = filled(f"{PLACE}/{template}", root=root, nonce=nonce, asset=asset, **content)
    return HTMLResponse(page, headers={"Content-Security-Policy": policy.format(nonce=nonce)})


def _path(name: str) -> Path:
    """Return the path of a file of the desk.  Raises `Refused` for any other."""
    place = (folder(REPORTS) / PLACE).resolve()
    path = (place / name).resolve() if re.fullmatch(_NAME, name) else place
    if not path.is_relative_to(place) or path.suffix not in TYPES or not path.is_file():
        raise Refused(NOT_THERE, say("desk.no_file", name=name[:60]))
    return path


def _piece(path: Path) -> tuple[bytes, bytes, str]:
    return _read(path, path.stat().st_mtime_ns)


@lru_cache(maxsize=256)
def _read(path: Path, _changed: int) -> tuple[bytes, bytes, str]:
    """Return the content of a file, the compressed content (empty if it is not text), and the hash of the content."""
    content = path.read_bytes()
    packed = gzip.compress(content, 9) if path.suffix in _TEXTS else b""
    return content, packed, hashlib.sha256(content).hexdigest()[:16]
