"""A drive that follows another law than the task's, told where its rate is a column: all other velocities follow from it.

Enters: a `TableUnderTest`.  Leaves: a `Claim`.  Used by `hypotheses.py`.
Velocities are linear in those of the drive: what they are with the drive and with its opposite tells them with any other one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.ways import near

# A velocity tells the drive in a row where the drive's part in it is at least this part of the column's largest.
_FELT = 0.05
# A rate that is never off by more than so many units of its last place is the task's, rounded in whatever way.
_ROUNDED = 2


def other_drive(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield the claim that each row's velocities follow from one value of the drive, that from which most of them do.

    A rate that was put right does not hide the value from which the others of its row were made.
    """
    key, laws = printed.key, printed.key.variant.drive
    opposite = key.misread("sign_drive")
    if not printed.closely or opposite is None or len(laws) != 1 or laws[0].name not in printed.key.variant.known_rates:
        return
    own, at = printed.student.values[:, printed.m :], printed.stacked(key.velocities_at)
    (task, spread), other = printed.with_spread(at), printed.stacked(opposite)(printed.q)
    first = key.velocities.index(laws[0].name)
    with np.errstate(invalid="ignore"):
        if not (np.abs(own - task)[:, first] > _ROUNDED * printed.w_units[:, first]).any():
            return
    still, driven = (task + other) / 2, (task - other) / 2
    best, most = np.full_like(own, np.nan), np.full(len(own), -1)
    tolerance = np.full_like(own, np.nan)
    for place in sorted(range(own.shape[1]), key=lambda one: one != first):
        felt = np.abs(driven[:, place]) >= _FELT * np.nanmax(np.abs(driven[:, place]), initial=0.0)
        with np.errstate(invalid="ignore", divide="ignore"):
            times = np.where(felt, (own[:, place] - still[:, place]) / driven[:, place], np.nan)[:, None]
            off = printed.w_units[:, place, None] / np.abs(driven[:, place, None])
            found, allowed = printed.velocities(still + times * driven, spread * np.abs(times) + off * np.abs(driven))
        count = near(own, found, allowed).sum(axis=1)
        more = count > most
        best[more], tolerance[more], most[more] = found[more], allowed[more], count[more]
    yield replace(printed.claim("other_drive", None, (best, tolerance)), is_read_off=True)
