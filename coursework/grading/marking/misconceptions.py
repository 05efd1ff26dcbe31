"""Which hypothesis explains a wrong table, named only where the printed digits prove it.

Enters: a `Key`, marked cells.  Leaves: `Misconception` or None.  Used by `grade.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.cells import ANGLES, EARLIER, KEY, STEP, STEP_TRUE, Cells, mark_cells
from coursework.grading.marking.hypotheses import Claim, Printed, claims
from coursework.grading.marking.key import Key

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
# Named from this share on, if it explains this much more than Euler's rules do; nearly as good ones are ties.
NAMED, BETTER, TIE = 0.93, 0.02, 0.005
# A table wrong in fewer cells has slips, not a misconception.
FEWEST, FEWEST_SHARE = 2, 0.02
_STEPS, _VELOCITIES = (STEP, STEP_TRUE), (KEY, ANGLES, EARLIER)


@dataclass(frozen=True, slots=True)
class Misconception:
    """`code` explains `share` of the cells it speaks about, Euler's rules `euler_share` of theirs; `ties` explain as much."""

    code: str
    share: float
    euler_share: float
    ties: tuple[str, ...]

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        return {
            "code": self.code, "share": round(self.share, 4), "euler_share": round(self.euler_share, 4), "ties": list(self.ties),
        }  # fmt: skip


def looked_for(cells: Cells, count: int) -> bool:
    """Return whether a table of `count` cells is wrong in so many that a misconception is looked for."""
    return int(cells.wrong.sum()) > max(FEWEST, FEWEST_SHARE * count)


def find_misconception(
    key: Key, cells: Cells, confusions: Mapping[str, float] | None = None, others: Mapping[str, Array] | None = None
) -> Misconception | None:
    """Return what explains a table, None where nothing does with ground."""
    printed = Printed(key, cells.student)
    explained, spoken = euler_cells(key, cells)
    euler_share = _share(explained, spoken)
    shares: dict[str, float] = {}
    for claim in claims(printed, confusions or {}, others or {}):
        share = claim_share(key, cells, claim, explained, spoken)
        shares[claim.code] = max(share, shares.get(claim.code, 0.0))
    named = {code: share for code, share in shares.items() if share >= NAMED and share > euler_share + BETTER}
    if not named:
        return None
    best = max(named.values())
    tied = [code for code, share in named.items() if share >= best - TIE]
    return Misconception(tied[0], named[tied[0]], euler_share, tuple(tied[1:]))


def euler_cells(key: Key, cells: Cells) -> tuple[Flags, Flags]:
    """Return which cells follow Euler's rules, and of which they speak (start values apart)."""
    m = len(key.coordinates)
    values = cells.student.values
    explained = np.zeros(values.shape, dtype=bool)
    for way in cells.ways:
        columns = slice(0, m) if way.name in _STEPS else slice(m, None)
        if way.name in (*_STEPS, *_VELOCITIES):
            explained[:, columns] |= way.holds(values)[:, columns]
    spoken = ~cells.missing
    spoken[0, :m] = False
    return explained & spoken, spoken


def claim_share(key: Key, cells: Cells, claim: Claim, explained: Flags, spoken: Flags) -> float:
    """Return which share of the cells it speaks about a claim explains; `explained` and `spoken` are Euler's."""
    m = len(key.coordinates)
    if claim.student is not None:
        put_right = mark_cells(key, claim.student)
        return _share(*euler_cells(key, put_right))
    with np.errstate(invalid="ignore"):
        holds = np.abs(cells.student.values - claim.expected) <= claim.tolerance
    says = np.isfinite(claim.expected) & spoken
    holds &= says
    for part, columns in (("steps", slice(0, m)), ("velocities", slice(m, None))):
        if claim.euler == part:
            says[:, columns], holds[:, columns] = spoken[:, columns], explained[:, columns]
    return _share(holds, says)


def _share(explained: Flags, spoken: Flags) -> float:
    return float(explained.sum()) / float(spoken.sum()) if spoken.any() else 0.0
