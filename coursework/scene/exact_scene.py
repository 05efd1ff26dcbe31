"""A scene whose table is the exact motion of the mechanism, with a scheme's rows beside it.

Enters: a `Variant` and `Settings` with the scheme "exact".  Leaves: `ExactScene`; `scene_of` gives the kind that is asked for.
Used by `api.py` and `scene/model/model.py`; everything that reads a `Scene` reads it too.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from coursework.motion.geometry.chain import is_chain
from coursework.motion.geometry.drives.drive import refuse_aliasing
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE
from coursework.motion.settings import Settings
from coursework.scene.scene import Scene
from coursework.system.on_demand import computed
from coursework.variant.judging.bounds import refuse_unbounded
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


def scene_of(variant: Variant, settings: Settings) -> Scene:
    """Return the scene of a variant: with the rows of a scheme, or with the exact motion as its table."""
    if variant.motor is not None:
        from coursework.scene.motor_scene import MotorScene

        return MotorScene(variant, settings)
    return (ExactScene if settings.scheme == EXACT else Scene)(variant, settings)


@dataclass(frozen=True, eq=False, repr=False)
class ExactScene(Scene):
    """A scene whose rows come from closed positions; it needs a chain of groups, or a closure of all coordinates."""

    @computed("stop", "equations", "closure", "exact", "rates", "flow", "search")
    def motion(self) -> Motion:
        """Return the rows of the exact motion, for the columns asked for.  Raises `InputError` if positions are not closed."""
        variant, stop, rates = self.variant, self.stop, self.passing(self.rates)
        if not is_chain(variant) and (self.closure is None or not self.closure.complete):
            line = variant.line_of("time", "scheme") if variant.time.scheme else 1  # a missing entry has no line of its own
            loose = self.closure.loose if self.closure is not None else frozenset[str]()
            names = tuple(one.name for one in variant.coordinates if one.name in loose)
            told = say(f"fault.V502.{'some' if names else 'none'}", scheme=PRECISE.name, names=names)
            raise InputError([Fault(told, variant.file, line)])
        refuse_aliasing(self.equations, variant.time.step, self.fastest_wave)
        refuse_unbounded(variant)
        exact = self.exact
        if not len(exact.t) and stop is None:
            line = variant.nearest_line("time", "end")
            told = say("fault.V511", time=self.search.given_up or 0.0, scheme=PRECISE.name)
            raise InputError([Fault(told, variant.file, line)])
        if self.settings.columns and len(exact.t):
            places = [exact.coordinate_names.index(name) for name in rates.coordinates]
            coordinates = exact.coordinates[:, places]
            velocities, determinants = rates.table(exact.t, coordinates)
            exact = replace(
                exact, coordinates=coordinates, velocities=velocities, determinants=determinants,
                coordinate_names=rates.coordinates, velocity_names=rates.velocities,
            )  # fmt: skip
        if len(exact.t):
            exact = replace(exact, scaled=self.flow.relative(exact.determinants, rates.blocks))
        return replace(exact, step=variant.time.step, stop=stop)

    @computed("equations", "closure", "start", "rates", "reduction", "stop", "flow", "search")
    def scheme_rows(self) -> Motion:
        """Return the rows of the coursework's scheme with the same step, for comparison with the exact table."""
        return self.march(self.variant.time.step, DEFAULT_SCHEME.name)
