"""The server is killed while somebody types, then the tab is closed: at the next start every letter is there again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.desk.browser.conftest import Desk
from tests.desk.serving.server import running

pytestmark = [pytest.mark.browser, pytest.mark.long]
TYPED = "# what nobody has saved yet"


@pytest.mark.parametrize("letters", range(1, len(TYPED), 5))
def test_what_is_typed_outlives_server_and_tab(letters: int, browser: Any, tmp_path: Path) -> None:
    context = browser.new_context()
    with running("edit", "31", "--no-browser", folder=tmp_path) as server:
        one = Desk(context.new_page(), server.address)
        one.page.focus("#desk-text .cm-content")
        one.page.keyboard.press("Control+End")
        one.page.keyboard.type(TYPED[:letters])
        server.process.kill()
        one.page.keyboard.type(TYPED[letters:])
        one.rest("unreachable")
        text = one.text
        one.page.close()
        port = server.port
    assert text.endswith(TYPED)
    with running("edit", "31", "--no-browser", folder=tmp_path, port=port) as server:
        again = Desk(context.new_page(), server.address)
        assert again.text == text
        assert again.page.is_visible("[data-notice=restored]")
        again.page.keyboard.press("Control+s")
        again.rest("saved")
    context.close()
    assert (tmp_path / "31.toml").read_text(encoding="utf-8") == text
