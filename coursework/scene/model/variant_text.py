"""The text of a variant's file with other data, which reads as that variant.

Enters: a variant that was read from a file, perhaps with other data.  Leaves: TOML text.
Used by `commands/new.py` and by individual variants.
"""

from __future__ import annotations

from coursework.equations.reduction.equations import differentiate
from coursework.mechanism.mechanism import build
from coursework.motion.geometry.start import START_TOLERANCE, start_values
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.rewriting import SAID_OF_NUMBERS, rewritten

_DECIMALS = 9
assert 10.0**-_DECIMALS < START_TOLERANCE


def variant_text(variant: Variant, original: str, scheme: str = "") -> str:
    """Return `original`, the text of the variant's file, with the variant's data in it, and with a `scheme` if one is named.

    Starts that follow from other data are written as the geometry closes them.  If data were set, what the file says of its
    own numbers (remarks, quotes) is left out.  Raises `InputError` if the geometry does not close.
    """
    changes: dict[KeyPath, str | float] = {p: value for p, value in variant.changes.items() if not isinstance(value, float)}
    if scheme:
        changes["time", "scheme"] = scheme
    moved = [place for place, c in enumerate(variant.coordinates) if c.start is None and c.start_guess is not None]
    if moved:
        start = start_values(differentiate(build(variant)))
        for place in moved:
            coordinate = variant.coordinates[place]
            closed = f"{start[place]:.{_DECIMALS}f}".rstrip("0").rstrip(".")
            changes["coordinates", coordinate.name, "start"] = f"{closed} {coordinate.unit}"
    return rewritten(original, changes, SAID_OF_NUMBERS if changes else ())
