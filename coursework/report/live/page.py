"""A run -> the live part of its page: labels, script with its hash, data.

Enters: a `SceneRun`, the words of a language, the writers of symbols and units.  Leaves: `LivePart`.  Used by the report.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from coursework.drawing.check_sheet.graph_words import letter_of_centres
from coursework.equations.reduction.blocks import angles_in_determinants
from coursework.motion.geometry.drives.drive import breaks, resolution, resolved
from coursework.motion.integration.integrate import WIDEST_STEP
from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE, SCHEMES, title_of
from coursework.motion.settings import scheme_for
from coursework.report.live.drawn import Drawn, drawn_of, frames_of
from coursework.report.live.functions import Functions, live_functions, tableau
from coursework.report.live.script import embedded, hash_of, packed, script_of, shortened, with_own
from coursework.report.text.page_context import PageContext
from coursework.scene.motion_results import given_constants
from coursework.scene.quantities import ENERGY, FORCES
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.variant.formula.motion_units import UNITS
from coursework.words.line_ends import marked
from coursework.words.sentences import Phrases, load_phrases

# Most bytes of script and data on one page, and most rows of a table that a laboratory computes anew at every move.
MOST_BYTES, MOST_ROWS = 60 * 1024, 512
FINE = 16  # points of the true motion per row, as laboratory_motion.js makes them
MOST_CELLS = 2000  # cells that are written out of a table finer than that of the file
_SAME = ("words", "schemes")  # data that are the same on every page in a language
# What ends the key of words that are used if the page's values are not those of the file, or the motion goes through a change
# point, where the moving part ends.
_SET, _PASSED = "_set", "_passed"
_PUT_TOGETHER = ("scheme_", "on_", "off_")  # beginnings of keys of words that a script puts together
SPEEDS = (0.05, 0.1, 0.2, 1.0)
_LABORATORY = (
    "numbers", "marching", "slices", "laboratory_motion", "page", "drawing", "names", "additions", "cursors", "panels", "lines",
    "stop_watch", "laboratory", "animation",
)  # fmt: skip
_RECORDED = ("recorded_motion", "page", "drawing", "names", "additions", "cursors", "animation")
# Places of a slider and points per step at which the drive is evaluated, and the error allowed in its travel per step (rad or
# share of the largest length): a kink causes as much, a pulse far more.
_PLACES, _POINTS, _OPEN = 5, 2, 1e-4
_ROUNDING = 1e-12


@frozen
class LivePart:
    """The live part: `words` by key, `speeds` (value, text), `last` row (from 0), `script` with its `hash`, `data` as JSON.

    Without a `laboratory` the page shows a motion computed in advance; with `forces` it has reactions and energy too.  If it is
    not `drawn`, the file has no points, so the page has graphs alone.
    """

    words: dict[str, str]
    speeds: tuple[tuple[float, str], ...]
    last: int
    laboratory: bool
    script: str
    hash: str
    data: str
    forces: bool = False
    drawn: bool = True

    @property
    def size(self) -> int:
        """Return the bytes of script and data in a page, where the script is packed."""
        return len(packed(self.script)) + len(self.data.encode())


def live_part(context: PageContext) -> LivePart | None:
    """Return the live part of a run; None if there is no row to show, or if the drive is too fast to be resolved.

    There is no laboratory if the table is too large, if it needs too many bytes, if the drive changes too fast for the steps
    of a script, or if forces move the mechanism against friction.
    """
    run = context.run
    driven = run.scene.follows_laws
    if not len(run.motion.t) or (driven and not resolution(run.scene.equations).met):
        return None
    drawn = drawn_of(run.scene, context.label)
    said = _said(context, drawn)
    sliders = sliders_of(run, context.unit) if len(run.motion.t) <= MOST_ROWS else {}
    sudden = driven and bool(sliders) and not followed(run, sliders, run.step / FINE)
    if len(run.motion.t) <= MOST_ROWS and not sudden:
        for part in _laboratories(context, drawn, said):
            if part.size <= MOST_BYTES:
                return part
    script = script_of("", _RECORDED)
    room = MOST_BYTES - len(script.encode()) - len(embedded(said).encode())
    part = _part(context, script, said | frames_of(run, drawn, room))
    why = "sudden" if sudden else "rubbing" if _rubs(run) else "no_laboratory"
    return replace(part, words=part.words | {"no_laboratory": part.words[why]})


def _rubs(run: SceneRun) -> bool:
    """Return whether forces move the mechanism against friction, which no script of a page computes."""
    forces = run.variant.forces
    return not run.scene.follows_laws and forces is not None and bool(forces.friction)


def _laboratories(context: PageContext, drawn: Drawn, said: dict[str, Any]) -> Iterator[LivePart]:
    """Yield the laboratories that a run may have, the best first: with forces if asked for, then without."""
    run = context.run
    if _rubs(run):
        return
    if not run.scene.follows_laws or (run.variant.forces is not None and (run.asks(FORCES) or run.asks(ENERGY))):
        from coursework.report.live.by_forces import moved_by, said_of

        found = moved_by(run, drawn.places)
        heavy = replace(run, scene=found.scene)
        own = said | said_of(found, said, context.words.phrases, context.label, context.unit)
        data = own | live_numbers(run, found.functions) | {"sliders": sliders_of(heavy, context.unit)} | found.numbers
        data |= {"given": heavy.variant.values, "given_order": list(heavy.variant.values)}
        script = script_of(shortened(found.functions.text), found.pieces(_LABORATORY))
        part = _part(context, script, data | {"most_cells": MOST_CELLS}, laboratory=True)
        yield replace(part, forces=True)
    if run.scene.follows_laws:
        functions = live_functions(run.scene, drawn.places)
        data = said | live_numbers(run, functions)
        data |= {"sliders": sliders_of(run, context.unit), "given_order": list(run.variant.values)}
        script = script_of(functions.text, _LABORATORY)
        yield _part(context, script, data | {"most_cells": MOST_CELLS}, laboratory=True)


def _part(context: PageContext, script: str, data: dict[str, Any], *, laboratory: bool = False) -> LivePart:
    phrases = context.words.phrases
    script = _speaking(script, embedded({key: data.pop(key) for key in _SAME if key in data}))
    mark = phrases.template("decimal")
    speeds = tuple((speed, phrases.template("live.speed_of").format(speed=f"{speed:g}".replace(".", mark))) for speed in SPEEDS)
    last = max(1, len(context.run.motion.t) - 1)
    told = script, hash_of(script), embedded(data)
    return LivePart(_words(phrases, context.run), speeds, last, laboratory, *told, drawn=bool(data["shown_points"]))


@lru_cache(maxsize=16)
def _speaking(script: str, own: str) -> str:
    """Return a script with the data `own`, from which words that it never names are left out: those stand in the page."""
    named = {*re.findall(r'(?<=["]|[.])\w+\b', script)}
    data = json.loads(own)
    words = {key: text for key, text in data["words"].items() if key in named or key.startswith(_PUT_TOGETHER)}
    return with_own(script, data | {"words": words})


def _said(context: PageContext, drawn: Drawn) -> dict[str, Any]:
    """Return the data on the drawing, and the labels, units and words of the page."""
    variant, phrases = context.run.variant, context.words.phrases
    names = ["t", *variant.columns, *variant.values, *drawn.data["shown_points"]]
    units = {name: context.unit(variant.unit_of(name)) for name in ("t", *variant.columns)}
    words = {key: marked(words) for key, words in _words(phrases, context.run).items()}
    words |= {f"scheme_{scheme.name}": phrases.written(title_of(scheme)) for scheme in SCHEMES.values()}
    contacts = {wheel["contact"] for wheel in drawn.data["wheels"]}
    return drawn.data | {
        "centre": letter_of_centres(drawn.data["points"], contacts, [link["name"] for link in drawn.data["links"]]),
        "words": words,
        "labels": {name: text for name in names if (text := context.label(name)) != name},
        "unit_words": units,
        "behind": {name: context.words.behind(text) for name, text in units.items()},
        "decimal": phrases.template("decimal"),
        "language": phrases.language,
    }


def _words(phrases: Phrases, run: SceneRun) -> dict[str, str]:
    """Return the words of the live part by key, their gaps open; those for `_set` and `_passed` where they hold."""
    words = {key: phrases.template(f"live.{key}") for key in load_phrases().entries["live"]}
    is_set = bool(run.variant.changes) or run.scheme != scheme_for(run.variant)
    ends = [end for end, holds in ((_SET, is_set), (_PASSED, run.scene.passed)) if holds]
    return words | {key.removesuffix(end): text for end in ends for key, text in words.items() if key.endswith(end)}


def sliders_of(run: SceneRun, unit: Callable[[str], str]) -> dict[str, dict[str, Any]]:
    """Return the sliders by datum: an angle through a whole turn, other data from half to one and a half of their value.

    A value is shown in the `unit` of the file, which is `size` times that of SI.

    There is no slider for a datum that is zero, which has no such range, or that sets a time at which a law changes.
    """
    variant = run.variant
    formulas = [formula for path, formula in variant.times.items() if path[0] != "time"]
    timed = {name for formula in formulas for name in formula.names()}
    found = {}
    for given in variant.given:
        if given.name in timed or not (given.value or given.si == "rad"):
            continue
        low, high = sorted((0.5 * given.value, 1.5 * given.value))
        if given.si == "rad":
            low = math.tau * math.floor(given.value / math.tau)
            high = low + math.tau
        size, si = UNITS.get(given.unit, (1, given.si))
        written = given.unit if si == given.si else given.si
        found[given.name] = {"low": low, "high": high, "unit": unit(written), "size": float(size) if si == given.si else 1.0}
    return found


def followed(run: SceneRun, sliders: dict[str, dict[str, Any]], step: float) -> bool:
    """Return whether steps of length `step` (s) resolve the drive at every place of the sliders."""
    variant = run.variant
    driving = {name for law in variant.laws for formula in law.formulas for name in formula.names()}
    ends = {name: (slider["low"], slider["high"]) for name, slider in sliders.items() if name in driving}
    moved = [(name, place) for name in ends for place in np.linspace(*ends[name], _PLACES)]
    data = {name: np.full(1 + len(moved), value) for name, value in variant.values.items()}
    for index, (name, place) in enumerate(moved, start=1):
        data[name][index] = place
    times = np.arange(int(run.end / step * (1 + _ROUNDING)) + 1).astype(np.float64) * step
    return bool(np.all(resolved(run.scene.equations, data, times, _POINTS, _OPEN)))


def live_numbers(run: SceneRun, functions: Functions) -> dict[str, Any]:
    """Return the numbers of a run by key; `scheme` is that with which the page begins, `precise` that of the true motion.

    `stop` is the time (s) at which the mechanism itself stops, else None; `own`: the table of the run comes from a scheme
    without corrections, as the tables that the page computes.
    """
    scene, variant = run.scene, run.variant
    angles = angles_in_determinants(scene.reduction.blocks, scene.equations)
    constant = given_constants(variant, run.motion.names, run.motion.rows)
    return {
        "coordinates": [c.name for c in variant.coordinates],
        "velocities": list(variant.velocities),
        "units": {name: variant.unit_of(name) for name in variant.columns},
        "shown": [name for name in run.motion.names if name not in constant],
        "start": scene.start,
        "step": run.step,
        "end": variant.time.end,
        "rows": len(run.motion.t),
        "given": variant.values,
        "numbers": list(functions.numbers),
        "closed": functions.closed,
        "moved": list(functions.moved),
        "followed": list(functions.followed),
        "tables": functions.tables,
        "determinants": len(scene.reduction.blocks),
        "guarded": [place for place, c in enumerate(variant.coordinates) if c.name in angles],
        "widest": WIDEST_STEP,
        "breaks": list(breaks(variant)),
        "stop": None if scene.stop is None else scene.stop.time,
        "schemes": {scheme.name: tableau(scheme) for scheme in SCHEMES.values()},
        "scheme": run.scheme if run.scheme in SCHEMES else DEFAULT_SCHEME.name,
        "own": run.scheme in SCHEMES and scene.correction is None,
        "precise": PRECISE.name,
    }
