"""Every sentence of the words files can be said, and what counts takes the form of its number."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from string import Formatter
from types import ModuleType
from typing import Any

import pytest

from coursework import solve
from coursework.report.pages import build_model
from coursework.report.pages.notebook import notebook_html
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import Words, load_words
from coursework.results.checks.result import Finding
from coursework.variant.catalogue import load
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from coursework.words.sentences import load_phrases, say
from tests.hard.test_change_points import past_the_pivot
from tests.mechanisms.library import mechanism
from tests.report.own import BOOM
from tests.report.wording.test_sought import CRANK
from tests.results.kinematics.mechanisms import FIVE_BAR, SHAPER
from tests.solved import solved

VARIANTS = Path(__file__).parents[3] / "variants"


def keys(table: Mapping[str, Any]) -> set[str]:
    """Return the keys of all sentences in a words file."""
    return set(flat(table))


def flat(table: Mapping[str, Any], path: str = "") -> dict[str, str]:
    """Return the sentences of a words file by their keys."""
    found: dict[str, str] = {}
    for key, value in table.items():
        found |= flat(value, f"{path}{key}.") if isinstance(value, dict) else {f"{path}{key}": value}
    return found


def judged(real: ModuleType, verdicts: tuple[str, ...], codes: tuple[str, ...] = ("UNKNOWN",)) -> Any:
    """Return variant 31 with a finding of each verdict for each code."""
    findings = tuple(Finding(verdict, "Told.", 1.5, code=code) for code in codes for verdict in verdicts)  # type: ignore[arg-type]
    return Judged(real.full(), findings)


def claimed(real: ModuleType) -> Any:
    """Return variant 31 with a finding for each sentence of a check that the section of control has words of its own for."""
    said = flat(load_phrases().entries)
    chosen = [key for key in said if key.startswith("check.") and f"control.{key.removeprefix('check.')}" in said]
    gaps = {key: [name for _, name, _, _ in Formatter().parse(said[key]) if name] for key in chosen}
    findings = tuple(Finding("PASS", say(key, **dict.fromkeys(gaps[key], 1.5)), 1.5, code=key.split(".")[1]) for key in chosen)
    return Judged(real.full(), findings)


class Judged:
    """A run with other findings."""

    def __init__(self, run: Any, findings: Any) -> None:
        self.run, self.checks = run, findings

    def __getattr__(self, name: str) -> Any:
        return getattr(self.run, name)


def behind() -> list[tuple[Any, str, float]]:
    """Return variants with scheme and end (s) of runs that go on behind a whole number of periods."""
    shaper = parse_variant(SHAPER)
    # One turn of an engine that starts up is taken for its period: it comes back, but faster.
    engine = (VARIANTS / "engine-start.toml").read_text(encoding="utf-8")
    faster = parse_variant(engine.replace('end  = "0.64 s"', 'end = "0.8 s"\nperiod = "0.64 s"'))
    near = load("31").with_data(given={"p": 13.089942})  # a micro-second off 24 steps
    return [
        ("31", "euler", 0.6), ("31", "exact", 0.6), (shaper, "euler", 0.75), (shaper, "exact", 0.75), (near, "euler", 0.6),
        (faster, "exact", 0.8),
    ]  # fmt: skip


def unbound() -> Any:
    """Return Cardan's circles whose file does not say of which point u is the velocity: equation 2 is open to doubt."""
    text = (VARIANTS / "cardan.toml").read_text(encoding="utf-8")
    return solve(parse_variant(text.replace(', of = "E", along = "0 deg"', "")), quantities=["table", "checks"])


def unusual(real: ModuleType) -> list[Any]:
    """Return runs that between them make the report say everything it can say; each says something that no other does."""
    codes = tuple(check.code for check in real.full().checks)
    verdicts = ("PASS", "COARSE", "FAIL", "SKIP", "ERROR")
    extras = ["table", "plots", "checks", "accelerations", "points", "analogs", "invariants"]
    dated = solved("31", date="D", student="S", group="G", quantities=real.EVERYTHING)
    return [
        dated, real.full(), real.stopped(), judged(real, verdicts, codes),
        judged(real, verdicts), judged(real, ("PASS",)), solved("v108"), solved("v112", quantities=["table"]),
        solved("31", project=1), solved("31", project=2), solved("31", gain=5.0), solved("31", scheme="rk4"),
        solved("31", scheme="exact"), solved("31", quantities=["table", "listing", "flowchart"]),
        solved("31", step=0.48 / 999, quantities=["table", "plots"]), solved("example-2", quantities=extras),
        solved("variable-crank-table"), solved("robot-arm", step=0.04), solved("jansen", quantities=["table"]), unbound(),
        solved("engine-start", quantities=["checks"]),
        solved("v110", quantities=["table"]), solved("31-forces"), solved("falling-arm"),
        solved("falling-arm", quantities=["accuracy"]),
        solved("31", quantities=["trajectories", "hodographs", "plans", "points"]),
        real.timed(), *real.oddities(), claimed(real), solve(parse_variant(FIVE_BAR)),
        *(solve(name, scheme, end=end, quantities=["table", "checks"]) for name, scheme, end in behind()),
        solve(parse_variant(past_the_pivot(0.001, 0.02)), quantities=["table", "checks"]),
        solve("example-2-motor", "semi-implicit", quantities=["table"]),
        solve("example-2-motor", "rk4", quantities=["table"]),
        solve(parse_variant(CRANK), quantities=["table"]), solve(parse_variant(BOOM), quantities=["table"]),
        solve(parse_variant(mechanism("ten-wheels")), quantities=["table"]),
        solve(parse_variant(mechanism("pantograph-on-a-rail")), quantities=["table"]),
    ]  # fmt: skip


def test_every_word_of_a_page_can_be_said(real: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """No key is missing for whatever can be asked, and no sentence is translated for nothing."""
    said: set[str] = set()
    speak = Words.__call__

    def recorded(self: Words, key: str, **values: object) -> str:
        said.add(key)
        return speak(self, key, **values)

    monkeypatch.setattr(Words, "__call__", recorded)
    for run in unusual(real):
        build_model(run, stamp="0123456789abcdef")
    notebook_html(real.full())
    everything = keys(load_phrases().entries)
    assert sorted(said - everything) == []
    unsaid = sorted(key for key in everything - said if key.partition(".")[0] in PAGE and key not in BELOW)
    assert not unsaid, unsaid


# Said by the rooms that draw, or by their tests: a caption, a file without a frame, a formula too long to print.
BELOW = {
    "graph.alt", "graph.caption", "graph.blank", "graph.blank_plan", "graph.close", "graph.fastest", "graph.frame",
    "graph.unread", "graph.unread_free", "graph.unread_given", "graph.unread_left", "graph.unread_lengths",
    "graph.unread_still", "graph.unread_together",
    "derivation.long.one", "derivation.long.other", "stop.kept_only",
}  # fmt: skip
# What the page itself says; all else is said by the rooms below it: test_language.py.
PAGE = {
    "decimal", "or", "title", "statement", "result", "count", "section", "given", "drive", "constraints", "derivation",
    "table", "first_last", "why", "tangent", "control", "graphs", "stop", "checks", "graph", "accuracy", "method",
    "label",
}  # fmt: skip


def test_an_unknown_language_is_refused_with_the_known_ones() -> None:
    with pytest.raises(InputError, match=r'no words for the language "xx" .* There is: en'):
        load_words("xx")


def test_what_counts_is_said_in_the_form_of_its_number(real: ModuleType) -> None:
    cardan = unbound()
    sections = ("equations", "results", "control", "checks")
    told = " ".join(real.text_of(real.parts(cardan, section)) for section in sections).replace("\u00a0", " ")
    assert "1 of 2 equations agree; 2 is not judged: nothing in the geometry gives u." in told
    assert "ψ2 made −1 whole turn, subtracted" in told
    assert "1 of φ1; −1 of ψ2" in told
    assert "these equations; the geometry of the file confirms the signs of (1). Nothing here checks the signs of (2)." in told
    assert "differs most" not in told, "nothing differs"
    assert load_words("en").count("unit.equations", 1) == "equation"
    assert load_words("ru").count("unit.equations", 3) == "уравнения"


def test_an_equation_of_a_group_has_its_number_on_the_page() -> None:
    """In a sentence of the tool, not in a text of the file; a name that is no equation's stays."""
    context = PageContext(solve("example-1", quantities=["table"]), load_words("en"))
    assert context.told(say("equation.same", name="G2x", others=("G2y",))) == "(1) says the same as (2)"
    assert context.told(say("equation.same", name="G9x", others=("G2y",))) == "G9x says the same as (2)"
    assert context.told("G2x") == "G2x"
