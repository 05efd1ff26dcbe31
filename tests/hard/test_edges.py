"""Three hundred scenes at the edge of doubles, drawn at random, against their true motion: nothing that passes is wrong.

A part runs always; `python3 -m coursework.bootstrap test --long tests/hard/test_edges.py` runs them all, some minutes.
"""

import re
import time

import mpmath as mp
import numpy as np
import pytest

import coursework
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.hard.edges import drawn

MOST_SECONDS, ROWS, LIMIT = 5.0, 24, 0.05


def judged(seed):
    """Return what is wrong with the answer to one scene, and how it ended."""
    mp.mp.dps = 50
    edge = drawn(seed)
    begun = time.process_time()
    try:
        run = coursework.solve(parse_variant(edge.text))
        verdicts = {one.code: one for one in run.checks}
        summary = run.summary
    except InputError as error:
        spent = time.process_time() - begun
        told = str(error)
        wrong = [] if re.match(r"[A-Z]\d{3} ", told) and "\n" not in told.strip() and "nan" not in told else ["no sentence"]
        if edge.family in {"quick", "turns"} or (edge.family == "dead" and edge.apart > 1e-8):
            wrong += [] if "V324" in told or "C021" in told else ["a motion that is possible is refused"]
        return edge, [*wrong, *(["time"] if spent > MOST_SECONDS else [])], f"refused: {told}", spent
    spent = time.process_time() - begun
    wrong = ["time"] if spent > MOST_SECONDS else []
    wrong += [f"ERROR {one.code}: {one.sentence}" for one in verdicts.values() if one.verdict == "ERROR"]
    motion = run.motion
    if not np.all(np.isfinite(motion.rows)):
        wrong.append("no number in the table")
    wrong += _ending(edge, run)
    wrong += _closeness(edge, run, verdicts)
    return edge, wrong, summary, spent


def _ending(edge, run):
    """Dead points: one that is there is found at its time, one that is not is not, and what cannot be told is said."""
    stop = run.scene.stop
    if stop is None:
        return ["goes on beyond its dead point"] if edge.apart < -1e-9 else []
    if edge.ends is not None and abs(stop.time - edge.ends) < 1e-5 * run.end + 3 * abs(edge.apart) ** 0.5 * run.end:
        return []
    if abs(edge.apart) <= 1e-8:  # of the crank; of the longest link the limit is 1e-9
        return [] if "not decided" in stop.sentence else [f"guessed: {stop.sentence}"]
    if edge.family == "far" and edge.digits < 6:
        return []
    return [f"stops falsely at {stop.time!r}: {stop.sentence}"]


def _closeness(edge, run, verdicts):
    """What passes is within its limit of the true motion, by a scale that is worked out here."""
    motion, exact = run.motion, run.scene.exact
    if edge.ends is not None or not len(motion.t):
        return []
    rows = np.unique(np.linspace(0, len(motion.t) - 1, ROWS).astype(int))
    near = [int(at / run.step) + more for at in edge.about for more in (0, 1)]
    rows = np.unique([*rows, *(row for row in near if row < len(motion.t))])
    true = [edge.true(mp.mpf(float(motion.t[row]))) for row in rows]
    angle = {name for name in motion.names if run.variant.unit_of(name) == "rad"}
    passes = verdicts["ACCURACY"].verdict == "PASS" and verdicts["CONDITION"].verdict == "PASS"
    known = 10.0 ** -max(edge.digits - 2, 0)
    bad = []
    for name in motion.names:
        wanted = np.array([float(one[name]) for one in true])
        if name in run.variant.known_rates or not np.all(np.isfinite(wanted)):
            continue
        place = motion.names.index(name)
        spread = (
            float(np.ptp(wanted))
            if name not in angle
            else min(float(np.ptp(exact.column(name))) if len(exact.t) else 1.0, 2 * np.pi)
        )
        size = float(np.max(np.abs(wanted))) if name not in run.variant.columns[: len(run.variant.coordinates)] else 0.0
        gap = np.abs([float(mp.mpf(float(motion.rows[row, place])) - one[name]) for row, one in zip(rows, true, strict=True)])
        if name in angle:
            gap = np.abs(gap - 2 * np.pi * np.round(gap / (2 * np.pi)))
        scale = run.results.evidence.scale[name] if passes else max(spread, 0.1 * size, 1e-9)
        if passes and np.max(gap) > LIMIT * scale * 1.01 + 1e-10:
            bad.append(f"PASS, but {name} is off by {np.max(gap) / scale:.3g}")
        if (
            passes
            and run.settings.scheme == "exact"
            and edge.family != "dead"
            and np.max(gap) > 1e-7 * max(1, size) + known * scale
        ):
            bad.append(f"exact, but {name} is off by {np.max(gap):.3g}")
    if edge.family == "dependent" and verdicts["CONDITION"].verdict == "PASS":
        lost = float(verdicts["CONDITION"].value) - edge.digits
        if lost > 2.5:
            bad.append(f"CONDITION says {verdicts['CONDITION'].value:.1f} digits of {edge.digits:.1f}")
    return bad


@pytest.mark.parametrize("seed", range(1000, 1040))
def test_nothing_that_passes_is_wrong(seed):
    edge, wrong, told, spent = judged(seed)
    assert not wrong, (edge.told, wrong, told, spent, edge.text)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(300))
def test_nothing_that_passes_is_wrong_in_three_hundred(seed):
    test_nothing_that_passes_is_wrong(seed)
