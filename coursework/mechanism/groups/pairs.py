"""The input and output of a group: pairs, guides, and the motion of a group.

Enters: positions, velocities, accelerations of external pairs.  Leaves: frozen records, read-only arrays.
Used by every group and by all code that calls one.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups.assembly import numbers
from coursework.mechanism.groups.plane import Vectors, rows_of, vectors
from coursework.system.arrays import Array, as_columns
from coursework.system.frozen import single

STILL = (0.0, 0.0)


def _plane_rows(what: str, value: ArrayLike) -> Array:
    """Return a private, read-only copy of `value`, (n, 2) or (2,); raise `ValueError` for any other value."""
    try:
        raw = np.array(value)
    except ValueError:  # rows of different lengths
        raise ValueError(f"{what}: rows of (x, y) were expected, found {value!r}.") from None
    if raw.dtype.kind not in "iuf":
        raise ValueError(f"{what}: numbers were expected, found {value!r}.")
    rows = raw.astype(np.float64)
    if rows.ndim not in (1, 2) or rows.shape[-1] != 2:
        raise ValueError(f"{what}: (x, y) or rows of it, shape (n, 2), were expected, found shape {rows.shape}.")
    finite = np.isfinite(rows)
    if not finite.all():
        row = int(np.argmin(finite.reshape(-1, 2).all(axis=1)))
        raise ValueError(f"{what}: finite numbers were expected, found {rows.reshape(-1, 2)[row].tolist()} at row {row}.")
    rows.flags.writeable = False
    return rows


def count_rows(owner: str, **sizes: int) -> int:
    """Return the common number of rows; 1 agrees with any.  Raises `ValueError` with the names of parts that disagree."""
    several = {name: size for name, size in sizes.items() if size != 1}
    if len(set(several.values())) > 1:
        found = ", ".join(f"{name} {size}" for name, size in several.items())
        raise ValueError(f"{owner}: the same number of rows was expected everywhere, found {found}.")
    return next(iter(several.values()), 1)


@single
class Pair:
    """A joint, or any point, whose motion is known: the external pair of the textbook.

    `position` (n, 2) or (2,) m, `velocity` m/s, `acceleration` m/s^2; a fixed pair needs only its position.  None means
    *not known*, as for the meeting point of a group computed with `positions_only`.
    Raises `ValueError` for a wrong shape and for numbers that are not finite.

    >>> from coursework.procedures import Pair
    >>> Pair([0.4, 0.0]).velocity.tolist(), Pair([[0.0, 0.1], [0.0, 0.2]], velocity=[0.0, 0.5]).rows
    ([0.0, 0.0], 2)
    """

    position: Array
    velocity: Array | None
    acceleration: Array | None

    def __init__(self, position: ArrayLike, velocity: ArrayLike | None = STILL, acceleration: ArrayLike | None = STILL) -> None:
        for name, value in (("position", position), ("velocity", velocity), ("acceleration", acceleration)):
            known = None if value is None and name != "position" else _plane_rows(name, value)  # type: ignore[arg-type]
            object.__setattr__(self, name, known)
        self.rows  # noqa: B018  the property compares the numbers of rows

    @property
    def rows(self) -> int:
        """Return the number of rows; 1 for a pair given once."""
        known = {name: getattr(self, name) for name in ("position", "velocity", "acceleration")}
        return count_rows("pair", **{name: part.size // 2 for name, part in known.items() if part is not None})

    def motion(self, owner: str) -> tuple[Vectors, Vectors]:
        """Return velocity and acceleration as plane vectors; `owner` names group and pair for the error."""
        if self.velocity is None or self.acceleration is None:
            raise ValueError(
                f"{owner}: velocity and acceleration are not known; the group before it was computed with positions_only=True."
            )
        return vectors(self.velocity), vectors(self.acceleration)


@single
class Guide:
    """A straight guide that may travel and turn.

    `through`: a pair K on it, a group that meets there, or a fixed place; `angle` (rad) of its positive direction,
    `rate` (rad/s), `acceleration` (rad/s^2): one number or one per row; `offset` (m) of the pin's own line from the
    line through K, positive to the left of the direction.

    >>> from coursework.procedures import Guide, Pair
    >>> Guide(Pair([0.0, 0.4]), angle=[0.0, 0.1, 0.2], rate=5.0, offset=0.02).rows
    3
    """

    through: Pair
    angle: Array
    rate: Array
    acceleration: Array
    offset: Array

    def __init__(
        self,
        through: At,
        angle: ArrayLike,
        rate: ArrayLike = 0.0,
        acceleration: ArrayLike = 0.0,
        offset: ArrayLike = 0.0,
    ) -> None:
        object.__setattr__(self, "through", pair_of(through))
        given = {"angle": angle, "rate": rate, "acceleration": acceleration, "offset": offset}
        for name, value in given.items():
            entries = numbers(f"guide, {name}", value)
            entries.flags.writeable = False
            object.__setattr__(self, name, entries)
        self.rows  # noqa: B018  the property compares the numbers of rows

    @property
    def rows(self) -> int:
        """Return the number of rows; 1 for a guide given once."""
        turning = ("angle", "rate", "acceleration", "offset")
        return count_rows("guide", **{name: len(getattr(self, name)) for name in turning}, K=self.through.rows)


@single
class GroupMotion:
    """The motion of one group, with as many rows as the input.

    `coordinates` (n, 2) in the order of the group's unknowns, angles in (-pi, pi] rad, slides in m (crank: (n, 1), the angle
    as given); `rates` and `accelerations` are their time derivatives, None if only positions were asked for; `meets` is the
    point the next group hangs on; `determinant` (n,) is that of the 2x2 matrix that velocities and accelerations share,
    `scaled_determinant` (n,) the same without a unit, from -1 to 1; `mode` is the assembly mode.

    >>> from coursework.procedures import Pair, rrr
    >>> found = rrr(Pair([0.0, 0.0]), Pair([[0.5, 0.0], [0.6, 0.0]]), lengths=(0.4, 0.3), mode=1)
    >>> found.coordinates.shape, found.meets.rows, found.scaled_determinant.round(4).tolist()
    ((2, 2), 2, [-1.0, -0.8888])
    """

    coordinates: Array
    rates: Array | None
    accelerations: Array | None
    meets: Pair
    determinant: Array
    scaled_determinant: Array
    mode: int


# Where a group hangs: a pair, the group before it (its meeting pair), or a fixed place, (2,) or (n, 2) m.
At: TypeAlias = Pair | GroupMotion | ArrayLike


def pair_of(at: At) -> Pair:
    """Return the pair that a group hangs on.

    >>> from coursework.procedures import crank, rrr
    >>> turning = crank([0.0, 0.0], length=0.1, angle=[0.0, 1.0], rate=10.0)
    >>> rrr(turning, [0.4, 0.0], lengths=(0.35, 0.25), mode=1).coordinates.round(4).tolist()
    [[0.7752, 1.7722], [0.4851, 1.7167]]
    """
    if isinstance(at, Pair):
        return at
    return at.meets if isinstance(at, GroupMotion) else Pair(at)


def group_motion(
    group: str,
    mode: int,
    n: int,
    *,
    coordinates: tuple[Array, ...],
    meets: tuple[Vectors, Vectors | None, Vectors | None],
    determinant: Array,
    scaled: Array,
    rates: tuple[Array, ...] | None = None,
    accelerations: tuple[Array, ...] | None = None,
) -> GroupMotion:
    """Return the record of a solved group, every array with `n` rows.

    Raises `ValueError` if a number overflows: neither NaN nor infinity leaves a group.
    """
    determinants = _side_by_side(group, n, (determinant, scaled))
    return GroupMotion(
        coordinates=_side_by_side(group, n, coordinates),
        rates=None if rates is None else _side_by_side(group, n, rates),
        accelerations=None if accelerations is None else _side_by_side(group, n, accelerations),
        meets=Pair(rows_of(meets[0], n), *(None if part is None else rows_of(part, n) for part in meets[1:])),
        determinant=determinants[:, 0],
        scaled_determinant=determinants[:, 1],
        mode=mode,
    )


def _side_by_side(group: str, n: int, columns: tuple[Array, ...]) -> Array:
    table = as_columns(columns, (n,))
    finite = np.isfinite(table)
    if not finite.all():
        row = int(np.argmin(finite.all(axis=1)))
        raise ValueError(f"{group}: the numbers at row {row} are too large to compute with.")
    table.flags.writeable = False
    return table
