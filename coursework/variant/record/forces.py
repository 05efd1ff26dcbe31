"""The masses and forces of a file, read and checked: frozen records, formulas in SI.

Leaves `reading/forces.py` inside a `Variant`, only for a file that has any.  Used by `variant.py` and `effects/`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, number
from coursework.variant.record.entries import Law
from coursework.variant.toml.positions import KeyPath

ROD, DISC, POINT = "rod", "disc", "point"
VECTORS = {"pair", "@", "part"}  # operations that make vectors or take them apart
SHAPES = (ROD, DISC, POINT)
GRAVITY = "gravity"
# The SI unit of each key of these sections.
MEASURED = {
    "mass": "kg", "inertia": "kg*m^2", "centre": "m", "at": "m", "force": "N", "torque": "N*m",
    "stiffness": "N/m", "free": "m", "damping": "N*s/m", "coefficient": "1", "radius": "m", "length": "m", "arm": "m",
    "unevenness": "1",
}  # fmt: skip


@frozen
class Mass:
    """The mass of a body, keyed by link or by the point of a block; `inertia` about its `centre` is a formula or one of `SHAPES`.

    `inertia` None means that the file gives none, which is allowed only for a body that does not turn; `centre` None is the
    middle of the body.
    """

    body: str
    mass: Formula
    inertia: Formula | str | None
    centre: Formula | None


@frozen
class Load:
    """A `force` at a point of the body `on`, or a `torque` on it, exerted by the body `source` ("0" is the frame)."""

    name: str
    on: str
    at: Formula | None
    force: Formula | None
    torque: Formula | None
    source: str = "0"


@frozen
class Spring:
    """A spring and damper between two points, which pulls them together with (stiffness (l - free) + damping dl/dt)."""

    name: str
    ends: tuple[str, str]
    stiffness: Formula | None
    free: Formula | None
    damping: Formula | None


@frozen
class Friction:
    """Friction at a point: a coefficient with the radius of a pin or the length of a guide, or the arm of a wheel."""

    at: str
    coefficient: Formula | None
    radius: Formula | None
    length: Formula | None
    arm: Formula | None


@frozen
class Motor:
    """A mechanism moved by forces: its free `rates`, their start values (SI), and the torques that act."""

    rates: tuple[str, ...]
    start: tuple[tuple[str, float], ...]
    torques: tuple[Load, ...]


@frozen
class Flywheel:
    """A flywheel on a link: its `inertia`, or the `unevenness` (w_max - w_min)/w_mean that it must achieve."""

    on: str
    inertia: Formula | None
    unevenness: Formula | None


@frozen
class Forces:
    """All masses and forces of a file; `gravity` is None if the file has none."""

    masses: tuple[Mass, ...] = ()
    gravity: tuple[Formula, Formula] | None = None
    loads: tuple[Load, ...] = ()
    springs: tuple[Spring, ...] = ()
    friction: tuple[Friction, ...] = ()
    motor: Motor | None = None
    flywheel: Flywheel | None = None

    @property
    def free(self) -> tuple[Law, ...]:
        """Return laws for the rates that forces move, as if they were drives: the geometry gives all other rates.

        Any law would do; these move, differently, because a wrong sign before a rate is not seen where the rate is zero.
        """
        return tuple(Law(rate, number(1 + place)) for place, rate in enumerate(self.motor.rates if self.motor else ()))

    def parts(self, known: Collection[str]) -> Iterator[Formula]:
        """Yield the largest parts of all formulas, vectors excepted, that contain only `known` names."""
        waiting = [formula for _, formula, _ in self.measured()]
        while waiting:
            one = waiting.pop()
            if set(one.names()) <= set(known) and not any(part.op in VECTORS for part in one.walk()):
                yield one
            else:
                waiting += one.args

    def measured(self) -> Iterator[tuple[KeyPath, Formula, str]]:
        """Yield every formula with its path and the SI unit that it must have."""
        for one in self.masses:
            yield from _measured(("masses", one.body), one)
        for part in self.gravity or ():
            yield ("forces", GRAVITY), part, "m/s^2"
        motor = self.motor.torques if self.motor else ()
        named: list[tuple[str, tuple[Load | Spring, ...]]] = [("forces", self.loads), ("motor", motor), ("forces", self.springs)]
        listed = [((section, one.name), one) for section, records in named for one in records]
        for path, record in (
            *listed,
            *((("friction", one.at), one) for one in self.friction),
            (("motor", "flywheel"), self.flywheel),
        ):
            yield from _measured(path, record)


def _measured(path: KeyPath, record: object) -> Iterator[tuple[KeyPath, Formula, str]]:
    """Yield the formulas of a record in the form of `measured`."""
    found = ((key, getattr(record, key, None), si) for key, si in MEASURED.items())
    yield from (((*path, key), formula, si) for key, formula, si in found if isinstance(formula, Formula))
