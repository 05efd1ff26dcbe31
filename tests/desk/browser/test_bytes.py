"""What a browser loads of the desk, the editor included, is small, and comes from the desk alone."""

from __future__ import annotations

import gzip
import re
from pathlib import Path

DESK = Path(__file__).parents[3] / "reports" / "desk"
LOADED = [path for path in sorted(DESK.rglob("*")) if path.suffix in {".js", ".css", ".svg", ".j2"} and path.name != "entry.js"]


def test_the_shell_is_small() -> None:
    assert sum(len(gzip.compress(path.read_bytes(), 9)) for path in LOADED) < 260_000


def test_nothing_is_fetched_from_elsewhere() -> None:
    for path in LOADED:
        text = path.read_text(encoding="utf-8")
        assert re.findall(r"""(?:src|href|url\(|import|fetch\()\s*=?\s*["'(]*https?://[^"')]*""", text) == [], path.name


def test_the_editor_has_its_licence_and_its_recipe() -> None:
    editor = DESK / "editor"
    assert "MIT License" in (editor / "LICENSE.txt").read_text(encoding="utf-8")
    pinned = re.findall(
        r'"(@?[a-z-]+/?[a-z-]*)": "(.*?)"', (editor / "package.json").read_text(encoding="utf-8").partition("devDep")[2]
    )
    assert len(pinned) > 10
    assert all(re.fullmatch(r"\d+\.\d+\.\d+", version) for _, version in pinned)
