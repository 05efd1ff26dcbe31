"""CONTINUITY, SINUSOID, STEP: the curves have no jump, look like the drive, and have rows enough."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, judged
from coursework.geometry.drive import breaks
from coursework.sentences import joined, say

Array = NDArray[np.float64]
# A difference this many times its neighbours' is a jump unless the half-step run shows the same steep slope.
JUMP = 4.0
# Part of a column's range below which a difference is no jump whatever its neighbours do.
SMALL = 0.05
# The first three harmonics of a velocity in a benign mechanism carry more than this part of its oscillation.
HARMONIC_SHARE = 0.9
# Explicit Euler wants at least twenty rows a period of the drive.
ROWS_A_PERIOD = 20
# A break of the drive this part of its time from a row is at the row.
AT_ROW = 1e-9


def continuity(evidence: Evidence) -> Check:
    """No curve jumps: a steep slope and a turn from 2π to 0 are no jumps."""
    motion = evidence.motion
    if len(motion.t) < 5:
        return judged("CONTINUITY", "SKIP", say("check.CONTINUITY.skip"))
    worst, where, name = 0.0, 0, motion.names[0]
    for place, column in enumerate(motion.names):
        ratios = _jump_ratios(evidence, place)
        if float(np.max(ratios)) > worst:
            worst, where, name = float(np.max(ratios)), int(np.argmax(ratios)), column
    begin, end = float(motion.t[where]), float(motion.t[where + 1])
    key = "check.CONTINUITY.pass" if worst <= 1.0 else "check.CONTINUITY.fail"
    sentence = say(key, name=name, row=where + 1, next=where + 2, begin=begin, end=end)
    return judged("CONTINUITY", "PASS" if worst <= 1.0 else "FAIL", sentence, worst, 1.0, say("unit.of_a_jump"))


def _jump_ratios(evidence: Evidence, place: int) -> Array:
    """Return for each interval |difference| over the difference that the curve's own slope allows."""
    motion = evidence.motion
    name = motion.names[place]
    differences = np.diff(motion.rows[:, place])
    if evidence.unit(name) == "rad":
        differences = differences - 2 * np.pi * np.round(differences / (2 * np.pi))
    span = float(np.ptp(motion.rows[:, place]))
    if place < len(motion.coordinate_names):
        rate = evidence.variant.rates[[c.name for c in evidence.variant.coordinates].index(name)]
        slopes = motion.column(rate)
        explained = motion.step * (slopes[1:] + slopes[:-1]) / 2
        allowed = motion.step * np.abs(np.diff(slopes)) + SMALL * motion.step * np.max(np.abs(slopes)) + 1e-12
        # A projected or corrected position may differ from the marched one by the scheme's own error.
        error = evidence.scheme_error
        if error is not None:
            allowed = allowed + np.max(np.abs(error[:, place])) * SMALL * 10
        return np.asarray(np.abs(differences - explained) / allowed)
    sizes = np.abs(differences)
    # The two neighbours on either side, of which the middle counts: a single wrong cell makes two large differences.
    padded = np.concatenate([sizes[2:0:-1], sizes, sizes[-2:-4:-1]])
    around = np.sort(np.stack([padded[:-4], padded[1:-3], padded[3:-1], padded[4:]]), axis=0)
    allowed = JUMP * around[2] + SMALL * span + 1e-12
    ratios = sizes / allowed
    steep = _steep(evidence, place, sizes)
    ratios = np.where((ratios > 1) & steep, 1.0, ratios)
    # Where the drive itself jumps, so do the velocities.
    for time in breaks(evidence.variant):
        ratios[(motion.t[:-1] < time * (1 - AT_ROW)) & (time * (1 - AT_ROW) <= motion.t[1:])] = 0.0
    return ratios


def _steep(evidence: Evidence, place: int, sizes: Array) -> Array:
    """Return where the half-step run makes the same change in two clearly smaller parts."""
    half = evidence.half
    if half is None or len(half.t) < 2 * len(sizes) + 1:
        return np.zeros(len(sizes), dtype=bool)
    parts = np.abs(np.diff(half.rows[: 2 * len(sizes) + 1, place])).reshape(-1, 2)
    return np.asarray((parts.max(axis=1) < 0.8 * sizes) & (parts.sum(axis=1) > 0.5 * sizes))


def sinusoid(evidence: Evidence) -> Check:
    """Under a sinusoidal drive the velocities are clearly sinusoidal (first three harmonics)."""
    motion, row = evidence.motion, evidence.period_row
    if not evidence.sinusoidal:
        return judged("SINUSOID", "SKIP", say("check.SINUSOID.drive"))
    if motion.stop is not None or row is None or row >= len(motion.t) or row < 8:
        return judged("SINUSOID", "SKIP", say("check.SINUSOID.rows"))
    shares = {name: _harmonic_share(motion.column(name)[: row + 1]) for name in motion.velocity_names}
    name = min(shares, key=lambda key: shares[key])
    share = shares[name]
    unit = say("unit.of_power")
    rows = tuple((key, value, unit) for key, value in shares.items())
    if share >= HARMONIC_SHARE:
        return judged("SINUSOID", "PASS", say("check.SINUSOID.pass", share=share, name=name), share, HARMONIC_SHARE, unit, rows)
    return judged("SINUSOID", "FAIL", say("check.SINUSOID.fail", share=share, name=name), share, HARMONIC_SHARE, unit, rows)


def _harmonic_share(values: Array) -> float:
    """Return the part of the variance in harmonics 1 to 3; the end-to-end drift is taken off first."""
    straight = values - np.linspace(0.0, values[-1] - values[0], len(values))
    power = np.abs(np.fft.rfft(straight[:-1] - np.mean(straight[:-1]))) ** 2
    total = float(np.sum(power[1:]))
    quiet = float(np.max(np.abs(values))) * 1e-12
    return 1.0 if total <= quiet**2 * len(values) ** 2 else float(np.sum(power[1:4])) / total


def rows_enough(evidence: Evidence) -> Check:
    """The step leaves at least twenty rows a period of the drive, and a row at each break of its formula."""
    step = evidence.motion.step
    between = [time for time in breaks(evidence.variant) if abs(time / step - round(time / step)) > AT_ROW * (1 + time / step)]
    if between:
        row = int(between[0] / step)
        late = row + 1 - between[0] / step
        listed = joined([say("check.STEP.time", time=time) for time in breaks(evidence.variant)], "join.comma")
        sentence = say("check.STEP.break", time=between[0], row=row + 1, next=row + 2, late=float(late), breaks=listed)
        return judged("STEP", "FAIL", sentence, float(late), 0.0, say("unit.of_a_step"))
    if not evidence.drive_frequency:
        return judged("STEP", "SKIP", say("check.STEP.skip"))
    rows = 2 * np.pi / (evidence.drive_frequency * step)
    enough = rows >= ROWS_A_PERIOD * (1 - 1e-9)
    most = 2 * np.pi / ROWS_A_PERIOD / evidence.drive_frequency
    key = "check.STEP.pass" if enough else "check.STEP.fail"
    sentence = say(key, frequency=evidence.drive_frequency, rows=float(rows), step=float(most))
    return judged("STEP", "PASS" if enough else "FAIL", sentence, float(rows), float(ROWS_A_PERIOD), say("unit.rows"))
