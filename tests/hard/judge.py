"""What is wrong with the answer to a scene whose true motion is known: a table, a verdict, a stop or a refusal that is not so.

Enters: an `Edge`.  Leaves: the faults of the answer, in words, and how it ended.  Used by `test_edges.py`.
"""

from __future__ import annotations

import re
import time

import mpmath as mp
import numpy as np

import coursework
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.hard.edges import HOLDS, Edge
from tests.hard.scenes import numbers

MOST_SECONDS, ROWS, LIMIT = 5.0, 24, 0.05


def judged(edge: Edge) -> tuple[list[str], str, float]:
    """Return what is wrong with the answer to one scene, what was said, and the processor time (s)."""
    mp.mp.dps = 50
    begun = time.process_time()
    try:
        run = coursework.solve(parse_variant(edge.text))
        verdicts = {one.code: one for one in run.checks}
        told = str(run.summary)
    except InputError as error:
        spent = time.process_time() - begun
        return [*_refusal(edge, str(error)), *_slow(spent)], f"refused: {error}", spent
    spent = time.process_time() - begun
    wrong = _slow(spent) + [f"ERROR {one.code}: {one.sentence}" for one in verdicts.values() if one.verdict == "ERROR"]
    if not np.all(np.isfinite(run.motion.rows)):
        wrong.append("no number in the table")
    return [*wrong, *_ending(edge, run), *_closeness(edge, run, verdicts)], told, spent


def _slow(spent: float) -> list[str]:
    return [f"{spent:.1f} s"] if spent > MOST_SECONDS else []


def _refusal(edge: Edge, told: str) -> list[str]:
    """A refusal is one line with a code, and its cause is so."""
    if not re.match(r"[A-Z]\d{3} ", told) or "\n" in told.strip() or "nan" in told:
        return [f"no sentence: {told}"]
    code, said = told[:4], numbers(told.split("  ", 1)[-1])
    is_true = {
        "V324": lambda: 2 * np.pi < _turned(said) <= 1.05 * edge.most * _step(edge),
        "C021": lambda: 3.14 < said[1] <= 1.05 * max(edge.most, edge.wave) * _step(edge),
        "V306": lambda: edge.gap > 0 and _near(_gap(told), edge.gap, 0.02),
        "V404": lambda: edge.part is not None and edge.part < 1e-7,
        "V403": lambda: edge.part is not None and edge.part < 1e-13,
        "V526": lambda: _near(_time(told), edge.until, 1e-4) or _near(edge.most * _time(told), 1e9, 2.0),
        "V323": lambda: _near(_time(told), edge.until, 1e-4),
        "V512": lambda: _near(_time(told), edge.until, 1e-4),
        "V019": lambda: _near(_time(told), edge.until, 1e-4),
        "V321": lambda: _near(_time(told), edge.until, 1e-4),
    }.get(code)
    return [] if is_true is not None and is_true() else [f"refused without that cause: {told}"]


def _near(found: float, wanted: float | None, part: float) -> bool:
    return wanted is not None and abs(found - wanted) <= part * abs(wanted)


def _time(told: str) -> float:
    """Return the time (s) that a sentence names."""
    return float(re.search(r"t = ([\d.e+-]+\d) s", told)[1])


def _turned(said: list[float]) -> float:
    """Return through how much (rad) the crank turns in a step, as a sentence has it after the number of the drive."""
    return next(value for value in said if value > 2 * np.pi)


def _gap(told: str) -> float:
    """Return by how much (m) links are said to be too short or too long."""
    return float(re.search(r"([\d.e+-]+) m too (?:short|long)", told)[1])


def _step(edge: Edge) -> float:
    return float(re.search(r'step = "([\d.e+-]+) s"', edge.text)[1])


def _ending(edge: Edge, run: coursework.Run) -> list[str]:
    """Dead points: one that is there is found at its time, one that is not is not, and what cannot be told is said."""
    stop = run.scene.stop
    if (
        edge.until is not None
        and edge.until < run.end * (1 - 1e-6)
        and run.motion.stop is None
        and not run.summary.count("known")
    ):
        return ["goes on where there is no motion"]
    if edge.gap > 1e-9:
        return ["begins open"]
    if stop is None:
        return ["goes on beyond its dead point"] if edge.apart < -1e-9 else []
    if edge.until is not None and abs(stop.time - edge.until) < 1e-9 * edge.until:
        return []
    if edge.ends is not None and abs(stop.time - edge.ends) < 1e-5 * run.end + 3 * abs(edge.apart) ** 0.5 * run.end:
        return []
    if abs(edge.apart) <= HOLDS["passing"]:  # of the crank; of the longest link the limit is 1e-9
        return [] if "not decided" in stop.sentence else [f"guessed: {stop.sentence}"]
    if edge.family == "far" and 10 ** (16 - edge.digits) > HOLDS["lengths"]:
        return []
    return [f"stops falsely at {stop.time!r}: {stop.sentence}"]


def _closeness(edge: Edge, run: coursework.Run, verdicts: dict) -> list[str]:
    """What passes is within its limit of the true motion, by a scale that is worked out here."""
    motion = run.motion
    if edge.ends is not None or edge.gap or (edge.until is not None and edge.until <= run.end) or not len(motion.t):
        return []
    rows = np.unique(np.linspace(0, len(motion.t) - 1, ROWS).astype(int))
    near = [int(at / run.step) + more for at in edge.about for more in (0, 1)]
    rows = np.unique([*rows, *(row for row in near if row < len(motion.t))])
    true = [edge.true(mp.mpf(float(motion.t[row]))) for row in rows]
    passes = verdicts["ACCURACY"].verdict == "PASS" and verdicts["CONDITION"].verdict == "PASS"
    known = 10.0 ** -max(edge.digits - 2, 0)
    bad = []
    for name in set(motion.names) & true[0].keys() if passes else ():
        wanted = np.array([float(one[name]) for one in true])
        if name in run.variant.known_rates or not np.all(np.isfinite(wanted)):
            continue
        size = float(np.max(np.abs(wanted))) if name not in run.variant.columns[: len(run.variant.coordinates)] else 0.0
        place = motion.names.index(name)
        gap = np.abs([float(mp.mpf(float(motion.rows[row, place])) - one[name]) for row, one in zip(rows, true, strict=True)])
        if run.variant.unit_of(name) == "rad":
            gap = np.abs(gap - 2 * np.pi * np.round(gap / (2 * np.pi)))
        scale = run.results.evidence.scale[name]
        if np.max(gap) > LIMIT * scale * 1.01 + 1e-10:
            bad.append(f"PASS, but {name} is off by {np.max(gap) / scale:.3g}")
        if run.settings.scheme == "exact" and edge.apart == 1.0 and np.max(gap) > 1e-7 * max(1, size) + known * scale:
            bad.append(f"exact, but {name} is off by {np.max(gap):.3g}")
    if edge.family == "far" and 10 ** (16 - edge.digits) <= HOLDS["lengths"] and verdicts["CONDITION"].verdict != "PASS":
        bad.append(str(verdicts["CONDITION"].sentence))
    if edge.family == "dependent" and verdicts["CONDITION"].verdict == "PASS":
        lost = float(verdicts["CONDITION"].value) - edge.digits
        if lost > 2.5:
            bad.append(f"CONDITION says {verdicts['CONDITION'].value:.1f} digits of {edge.digits:.1f}")
    return bad
