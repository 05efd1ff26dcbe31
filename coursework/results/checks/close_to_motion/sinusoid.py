"""SINUSOID: under a drive of sines the velocities consist of its first three harmonics, and so does the table.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
The fit is by least squares on a constant, t, and cos, sin of every k w, k = 1, 2, 3, where w are the frequencies of the drive.
An oscillation is called sinusoidal, like the drive, only if k = 1 alone carries it; else the share of each k is told.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.geometry.drives.drive import frequencies
from coursework.motion.integration.finer import finer
from coursework.motion.integration.motion import Motion
from coursework.results.checks.evidence import NEAR_PERIOD, Evidence
from coursework.results.checks.result import Finding, floored, skipped
from coursework.system.arrays import Array

Harmonics = dict[str, tuple[float, ...]]  # by column: the shares of k = 1, 2, 3
_PARTS = ("first", "second", "third")
# In a benign mechanism the first three harmonics carry more than this share of an oscillation (catalogue: 0.984 to 1.000).
SHARE = 0.9
HARMONICS = (1, 2, 3)
# Number of exact rows for judging, in a period of the fastest sine in the drive.
_ROWS_A_PERIOD = 16
# Share of a column's largest size below which its oscillation is round-off.
_QUIET = 1e-12


def sinusoid(evidence: Evidence) -> Finding:
    """The first three harmonics of the drive carry at least nine tenths of the oscillation of every velocity."""
    found = evidence.once("frequencies", lambda: frequencies(evidence.equations))
    if not found:
        return skipped(evidence.say("check.SINUSOID.drive"))
    motion = evidence.motion
    slowest = 2 * np.pi / found[0]
    near = max(motion.step / 2, NEAR_PERIOD * slowest)
    periods = int((motion.t[-1] + near) / slowest)
    names = tuple(name for name in evidence.names if name in motion.velocity_names)
    if motion.stop is not None or periods < 1 or evidence.compared < len(motion.t) or not names:
        return skipped(evidence.say("check.SINUSOID.rows", period=slowest))
    window = periods * slowest + near
    dense = evidence.once("close to a sinusoid", lambda: _dense(evidence, found))
    if dense is None:
        return skipped(evidence.say("check.unknown"))
    true = evidence.once("sinusoid", lambda: shares(dense, names, found, window))
    name = min(names, key=lambda key: true[key])
    unit = evidence.say("unit.of_power")
    if true[name] < SHARE:
        return skipped(evidence.say("check.SINUSOID.not", name=name, share=100 * floored(true[name], 3)))
    if int(np.sum(motion.t <= window)) <= _terms(found):
        return skipped(evidence.say("check.SINUSOID.few", rows=int(np.sum(motion.t <= window)), least=_terms(found) + 1))
    own = shares(motion, names, found, window)
    column = min(names, key=lambda key: own[key])
    rows = tuple((name, own[name], unit) for name in names)
    least = {"name": column, "share": 100 * floored(own[column], 3), "exact": 100 * floored(true[name], 3)}
    if own[column] < SHARE:
        return Finding("COARSE", evidence.say("check.SINUSOID.coarse", **least), own[column], SHARE, unit, column, rows=rows)
    of_exact = evidence.once("harmonics", lambda: harmonics(dense, names, found, window))
    furthest = min(names, key=lambda key: of_exact[key][0])
    how = "pass" if of_exact[furthest][0] >= SHARE else "harmonics"
    parts = {key: 100 * part for key, part in zip(_PARTS, harmonics(motion, names, found, window)[furthest], strict=True)}
    parts |= {f"true_{key}": 100 * part for key, part in zip(_PARTS, of_exact[furthest], strict=True)}
    sentence = evidence.say(f"check.SINUSOID.{how}", **least, of=furthest, **parts)
    return Finding("PASS", sentence, own[column], SHARE, unit, column, rows=rows)


def _dense(evidence: Evidence, found: tuple[float, ...]) -> Motion | None:
    """Return the exact motion on rows that are close enough; None if it cannot be followed between rows."""
    exact = evidence.exact
    parts = int(np.ceil(_ROWS_A_PERIOD * exact.step * found[-1] / (2 * np.pi) * (1 - 1e-9)))
    return finer(exact, evidence.rates, parts, parts * (len(exact.t) - 1) + 1) if parts > 1 else exact


def _terms(found: tuple[float, ...]) -> int:
    return 2 + 2 * len(HARMONICS) * len(found)


def shares(motion: Motion, names: tuple[str, ...], found: tuple[float, ...], window: float) -> dict[str, float]:
    """Return the share of each column's oscillation carried by the harmonics of `found` (rad/s), up to `window` (s)."""
    t = motion.t[motion.t <= window]
    columns = np.array([motion.column(name)[: len(t)] for name in names]).T
    without_trend = _left_by_a_line(t, columns)
    unexplained = _left(np.column_stack([np.ones_like(t), t, *_turning(t, found)]), columns)
    quiet = _quiet(columns) * len(t)
    carried = np.where(without_trend <= quiet, 1.0, 1 - unexplained / np.where(without_trend > 0, without_trend, 1.0))
    return dict(zip(names, carried.tolist(), strict=True))


def harmonics(motion: Motion, names: tuple[str, ...], found: tuple[float, ...], window: float) -> Harmonics:
    """Return the share of each column's oscillation that k = 1, 2, 3 each carry: `shares`, split by squared amplitude.

    The row at the end of a period is the first row of the next, and must not count twice.
    """
    t = motion.t[motion.t <= window]
    whole = t[t < t[-1] - motion.step / 2]
    columns = np.array([motion.column(name)[: len(whole)] for name in names]).T
    terms = np.column_stack([np.ones_like(whole), *_turning(whole, found)])
    squares = np.linalg.lstsq(terms, columns, rcond=None)[0][1:] ** 2
    sizes = np.sum(squares.reshape(len(HARMONICS), -1, len(names)), axis=1)
    sizes[0] += np.sum(sizes, axis=0) <= _quiet(columns)  # no oscillation counts as sinusoidal
    parts = np.array([*shares(motion, names, found, window).values()]) * sizes / np.sum(sizes, axis=0)
    return {name: tuple(column) for name, column in zip(names, parts.T.tolist(), strict=True)}


def _quiet(columns: Array) -> Array:
    """Return the square (k,) of the amplitude below which the oscillation of each column (n, k) is round-off."""
    return np.asarray((_QUIET * np.max(np.abs(columns), axis=0)) ** 2)


def _turning(t: Array, found: tuple[float, ...]) -> list[Array]:
    return [shape(k * w * t) for k in HARMONICS for w in found for shape in (np.cos, np.sin)]


def _left_by_a_line(t: Array, columns: Array) -> Array:
    """Return the sum of squares (k,) of the residuals of each column (n, k) after fitting a straight line over t (n,)."""
    middle = t - np.mean(t)
    level = columns - np.mean(columns, axis=0)
    slope = middle @ level / (middle @ middle or 1.0)
    return np.asarray(np.sum((level - middle[:, None] * slope) ** 2, axis=0))


def _left(terms: Array, columns: Array) -> Array:
    """Return the sum of squares (k,) of the residuals of each column (n, k) after least squares on `terms` (n, j)."""
    coefficients = np.linalg.lstsq(terms, columns, rcond=None)[0]
    return np.asarray(np.sum((columns - terms @ coefficients) ** 2, axis=0))
