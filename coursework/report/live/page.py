"""A run -> the part of its page that moves: labels, script with its hash, data.

Enters: a `SceneRun`, the words of a language, the writers of symbols and units.  Leaves: `LivePart`.  Used by the report.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from coursework.motion.geometry.drive import resolution
from coursework.motion.schemes import SCHEMES, title_of
from coursework.report.live.drawn import Drawn, drawn_of
from coursework.report.live.frames import frames_of
from coursework.report.live.functions import live_functions
from coursework.report.live.numbers import live_numbers
from coursework.report.live.script import embedded, hash_of, script_of
from coursework.report.live.sliders import followed, sliders_of
from coursework.report.text.words import Words
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.words.line_ends import marked
from coursework.words.sentences import Phrases, load_phrases

# Script and data of one page (bytes), and rows of a table that a laboratory computes anew at every move.
MOST_BYTES, MOST_ROWS = 60_000, 512
FINE = 16  # points of the true motion from row to row, as laboratory_motion.js makes them
MOST_CELLS = 2000  # of a table finer than the file's that are written out
_PUT_TOGETHER = ("scheme_", "on_", "off_")  # words whose keys a script puts together
SPEEDS = (0.05, 0.1, 0.2, 1.0)
_LABORATORY = (
    "numbers", "marching", "slices", "laboratory_motion", "page", "drawing", "names", "additions", "cursors", "panels", "lines",
    "stop_watch", "laboratory", "animation",
)  # fmt: skip
_RECORDED = ("recorded_motion", "page", "drawing", "names", "additions", "cursors", "animation")


@frozen
class LivePart:
    """`words` of what stands still by key, `speeds` (value, text); `last` row from 0; `script` with its `hash`; `data` as JSON.

    Without a `laboratory` the page shows a motion that was computed before.
    """

    words: dict[str, str]
    speeds: tuple[tuple[float, str], ...]
    last: int
    laboratory: bool
    script: str
    hash: str
    data: str

    @property
    def size(self) -> int:
        """Return the bytes of script and data."""
        return len(self.script.encode()) + len(self.data.encode())


def live_part(run: SceneRun, phrases: Phrases, label: Callable[[str], str], unit: Callable[[str], str]) -> LivePart | None:
    """Return the live part of a run, None where there is no row to show or the true motion is not known.

    There is no laboratory where a table is too large, or the drive does more than a script would see.

    `label` writes the name of a quantity or a point, `unit` a unit, both as text.
    """
    if not len(run.motion.t) or not resolution(run.scene.equations).met:
        return None
    drawn = drawn_of(run.scene, label)
    said = _said(run, drawn, phrases, label, unit)
    sliders = sliders_of(run, unit) if len(run.motion.t) <= MOST_ROWS else {}
    sudden = bool(sliders) and not followed(run, sliders, run.step / FINE)
    if len(run.motion.t) <= MOST_ROWS and not sudden:
        functions = live_functions(run.scene, drawn.places)
        data = said | live_numbers(run, functions) | {"sliders": sliders, "given_order": list(run.variant.values)}
        script = script_of(functions.text, _LABORATORY)
        part = _part(run, phrases, script, embedded(_asked(data, script) | {"most_cells": MOST_CELLS}), True)
        if part.size <= MOST_BYTES:
            return part
    script = script_of("", _RECORDED)
    said = _asked(said, script)
    room = MOST_BYTES - len(script.encode()) - len(embedded(said).encode())
    part = _part(run, phrases, script, embedded(said | frames_of(run, drawn, room)), False)
    return replace(part, words=part.words | {"no_laboratory": part.words["sudden"]}) if sudden else part


def _part(run: SceneRun, phrases: Phrases, script: str, data: str, laboratory: bool) -> LivePart:
    mark = phrases.template("decimal")
    speeds = tuple((speed, phrases.template("live.speed_of").format(speed=f"{speed:g}".replace(".", mark))) for speed in SPEEDS)
    return LivePart(_words(phrases), speeds, max(1, len(run.motion.t) - 1), laboratory, script, hash_of(script), data)


def _said(
    run: SceneRun, drawn: Drawn, phrases: Phrases, label: Callable[[str], str], unit: Callable[[str], str]
) -> dict[str, Any]:
    """Return the outline and the words of the page."""
    variant = run.variant
    names = ["t", *variant.columns, *variant.values, *drawn.data["shown_points"]]
    units = {name: unit(variant.unit_of(name)) for name in ("t", *variant.columns)}
    words = {key: marked(words) for key, words in _words(phrases).items()} | {
        f"scheme_{scheme.name}": phrases.written(title_of(scheme)) for scheme in SCHEMES.values()
    }
    return drawn.data | {
        "words": words,
        "labels": {name: text for name in names if (text := label(name)) != name},
        "unit_words": units,
        "behind": {name: Words(phrases).behind(text) for name, text in units.items()},
        "decimal": phrases.template("decimal"),
        "language": phrases.language,
    }


def _asked(data: dict[str, Any], script: str) -> dict[str, Any]:
    """Return the data without the words that the script never names: those stand in the page itself."""
    named = {*re.findall(r'(?<=["]|[.])\w+\b', script)}
    words = {key: text for key, text in data["words"].items() if key in named or key.startswith(_PUT_TOGETHER)}
    return data | {"words": words}


def _words(phrases: Phrases) -> dict[str, str]:
    """Return the words of the live part by key, their gaps open."""
    return {key: phrases.template(f"live.{key}") for key in load_phrases().entries["live"]}
