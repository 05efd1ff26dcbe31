"""axe-core, where `tests/javascript` has fetched it: the rules for access that a page is asked by."""

from __future__ import annotations

from pathlib import Path

AXE = Path(__file__).parent / "javascript" / "node_modules" / "axe-core" / "axe.min.js"
_FOUND = "({violations}) => violations.map((one) => `${one.id}: ${one.nodes[0].html}`)"
ASKED = f"axe.run(document, {{iframes: false}}).then({_FOUND})"
