"""The same reactions group by group, the last group first, as a student finds them by hand, one Assur group after another.

Enters: `Reactions` and their scheme.  Leaves: the unknowns found group by group (n, k).  Computed on request only.
Used by `analysis.py`.

The equations of one group contain only its own joints and the known forces of later groups: three a link, two a pin.
A pin shared by several groups belongs to the first of them in the order of assembly.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from coursework.effects.force_scheme import ForceScheme
from coursework.effects.kinetostatics.kinetostatics import Reactions, places_of
from coursework.mechanism.joints import FRAME
from coursework.system.arrays import Array


def sets_of(scheme: ForceScheme) -> list[tuple[tuple[str, ...], list[int], list[int]]]:
    """Return bodies, equations and unknowns of each group, the last first; empty if their numbers do not match."""
    places, known = places_of(scheme), set[int]()
    owners = {pin: next(_first(scheme, pin), ()) for pin in scheme.pins}
    found = []
    for group in (*reversed(scheme.groups), ()):
        pins = [pin for pin, owner in owners.items() if owner == group]
        own = {*group, *pins}
        unknowns = [k for k, one in enumerate(scheme.unknowns) if k not in known and own & {one.on, one.off}]
        equations = [places[name] + k for name in group for k in range(3)] + [places[pin] + k for pin in pins for k in range(2)]
        if len(equations) != len(unknowns):
            return []
        known.update(unknowns)
        found.append((group, equations, unknowns))
    return [one for one in found if one[1]]


def _first(scheme: ForceScheme, pin: str) -> Iterator[tuple[str, ...]]:
    """Yield the groups of the bodies at a pin in the order of assembly; none if it is on the frame, which comes before all."""
    held = {one.on for one in scheme.unknowns if one.off == pin}
    if FRAME not in held:
        yield from (group for group in scheme.groups if held & set(group))


def by_groups(scheme: ForceScheme, reactions: Reactions) -> Array | None:
    """Return the unknowns (n, k), each group solved by itself; None if the order of the groups is unknown."""
    sets = sets_of(scheme)
    count, _, k = reactions.matrix.shape
    if sum(len(unknowns) for *_, unknowns in sets) != k:
        return None
    values = np.zeros((count, k))
    for _, equations, unknowns in sets:
        left = reactions.right[:, equations] - np.einsum("nij,nj->ni", reactions.matrix[:, equations], values)
        block = reactions.matrix[:, equations][:, :, unknowns]
        try:
            values[:, unknowns] = np.linalg.solve(block, left[..., None])[..., 0]
        except np.linalg.LinAlgError:
            return None
    couples = [place for place, one in enumerate(scheme.unknowns) if one.direction.kind == "couple"]
    values[:, couples] *= reactions.length
    return values
