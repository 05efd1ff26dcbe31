"""How one run is to be made: scheme, step, end, correction, and what is asked for.

Enters: options of the command line or arguments of `solve`.  Leaves: frozen `Settings`.
Used by `api.py`, `exact_scene.py`, `many.py`, `assigning/`, `checks/` and `model/`.
"""

from __future__ import annotations

from coursework.motion.geometry.chain import is_chain
from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.integrate import Correction, refuse_gain
from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE, SCHEMES, scheme_of
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT, OF_FORCES
from coursework.words.errors import InputError
from coursework.words.sentences import say

MOST_CORRECTIONS = 20  # Newton's method converges in far fewer


def scheme_for(variant: Variant, scheme: str | None = None) -> str:
    """Return the scheme of a run: the one asked for, else that of the file, else exact for a chain, else the default."""
    is_exact = variant.motor is None and is_chain(variant)
    return scheme or variant.time.scheme or (EXACT if is_exact else DEFAULT_SCHEME.name)


def stepping(variant: Variant, scheme: str | None) -> str:
    """Return the scheme whose step or precision is asked about.  Raises `InputError` for the exact motion, which has neither."""
    if scheme == EXACT:
        raise InputError(say("fault.C007", scheme=PRECISE.name))
    return scheme or (variant.time.scheme if variant.time.scheme in SCHEMES else DEFAULT_SCHEME.name)


@frozen
class Settings:
    """The settings of one run.

    `project` is the number of Newton corrections a step, `gain` Baumgarte's gain (1/s), `columns` the table columns asked for
    (empty for all), `order` the highest derivative of the motion asked for: 1 for velocities, 2 for accelerations.
    """

    scheme: str = DEFAULT_SCHEME.name
    project: int = 0
    gain: float = 0.0
    columns: tuple[str, ...] = ()
    order: int = 1

    def checked(self, step: float, *, by_forces: bool = False) -> Settings:
        """Return the settings after checking them; `by_forces` marks motion under forces, which has one more scheme and no drift.

        Raises `InputError` for an unknown scheme, for options that exclude each other and for gains that make the error grow.
        """
        if self.scheme != EXACT:
            scheme_of(self.scheme, OF_FORCES if by_forces else ())
        if not (isinstance(self.project, int) and 0 <= self.project <= MOST_CORRECTIONS):
            raise InputError(say("fault.C004", most_corrections=MOST_CORRECTIONS, project=self.project))
        if self.scheme == EXACT and (self.project or self.gain):
            raise InputError(say("fault.C006", scheme=PRECISE.name))
        if by_forces and (self.project or self.gain):
            raise InputError(say("fault.C078"))
        if self.gain:
            refuse_gain(self.gain, step)
        if self.gain and self.project:
            raise InputError(say("fault.C005"))
        return self

    def correction(self, closure: Closure | None) -> Correction | None:
        """Return the correction that keeps positions closed, None if not asked for.  Raises `InputError` if it is impossible."""
        if not (self.project or self.gain):
            return None
        if closure is None or not closure.complete:
            raise InputError(say("fault.C016"))
        if self.columns:
            raise InputError(say("fault.C017"))
        return Correction(closure, self.project, self.gain)
