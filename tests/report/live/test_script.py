"""The script of a page: its hash admits exactly its bytes, its size has a bound, no text ends it early."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import zlib
from dataclasses import replace
from itertools import pairwise
from typing import Any

import pytest

import coursework
from coursework.report.live.page import MOST_BYTES, LivePart, live_part
from coursework.report.live.script import embedded, hash_of, packed
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.variant.catalogue import names
from tests.sample import sampled

HOOKS = {"coordinates", "velocities", "start", "step", "rows", "given", "points", "links"}


def part_of(variant: Any, **options: Any) -> LivePart:
    found = live_part(PageContext(coursework.solve(variant, **options), load_words("en")))
    assert found is not None
    return found


def quartered(table: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    """Return the table with three more nodes between every two."""
    between = [(a + (b - a) * k / 4, u + (v - u) * k / 4) for (a, u), (b, v) in pairwise(table) for k in range(4)]
    return (*between, table[-1])


def test_the_policy_admits_exactly_the_bytes_between_the_tags(written: Any) -> None:
    page = (written("31") / "report.html").read_bytes()
    policy = re.search(rb'Content-Security-Policy" content="([^"]*)"', page)[1].decode()
    scripts = re.findall(rb"<script>(.*?)</script>", page, re.S)
    unpacked = zlib.decompress(base64.b64decode(re.search(rb'packed="([^"]*)"', scripts[0])[1]), -zlib.MAX_WBITS)
    admitted = [f"sha256-{base64.b64encode(hashlib.sha256(script).digest()).decode()}" for script in (*scripts, unpacked)]
    assert sorted(re.search(r"script-src ([^;]*)", policy)[1].split()) == sorted(f"'{one}'" for one in admitted)
    assert [hash_of(script.decode()) for script in (*scripts, unpacked)] == admitted
    assert not [script for script in scripts if b"\r" in script]
    assert len(scripts) == 2 and page.count(b"<script") == 3


@pytest.mark.parametrize("name", sampled(names()))
def test_every_variant_has_its_laboratory_in_sixty_kilobytes(name: str) -> None:
    part = part_of(name)
    assert part.laboratory
    assert part.size == len(packed(part.script)) + len(part.data.encode()) <= MOST_BYTES
    data = json.loads(part.data)
    assert {*data} >= HOOKS
    assert data["points"]
    assert not re.search(r"https?:(?!//www\.w3\.org/2000/svg)|\beval\b|\bFunction\b|innerHTML|localStorage|fetch\(", part.script)


@pytest.mark.browser
def test_what_is_packed_is_there_again_at_once(browser: Any) -> None:
    """Codes of its own, fixed ones, the longest repetition from the farthest place, many blocks, letters of three bytes."""
    page = browser.new_page()
    far = "".join(hashlib.sha256(bytes([k])).hexdigest() for k in range(256))
    texts = (part_of("31").script, "window.ran = 1", f"/*{far * 2}{'a' * 600}*/", "/*速度 ω₃*/" * 4, f"/*{list(range(30_000))}*/")
    for text in texts:
        page.set_content(f"<script>{packed(text)}</script><script>window.behind = document.scripts[0].textContent</script>")
        assert page.evaluate("window.behind") == text
    page.close()


def test_the_same_bytes_on_every_run() -> None:
    assert part_of("31") == part_of("31")


def test_a_table_too_large_leaves_the_laboratory_out() -> None:
    """Coefficients of a law with many nodes are numbers that no page needs."""
    whole = coursework.load("variable-crank-table")
    finer = [replace(law, table=quartered(quartered(law.table))) if law.table else law for law in whole.functions]
    part = part_of(replace(whole, functions=tuple(finer)))
    assert not part.laboratory
    assert part.size <= MOST_BYTES
    assert "tables" not in json.loads(part.data)


def test_text_of_a_file_ends_no_script() -> None:
    text = embedded({"a": "</script><!--<script>", "b": 0.1})
    assert "</" not in text
    assert "<!--" not in text
    assert json.loads(text) == {"a": "</script><!--<script>", "b": 0.1}
