"""What a file says about its variant in other languages than the author's: [text.ru], [text.uk] …

Enters: the checked file.  Leaves: `Texts`.
Used by `reader.py` and `variant.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from coursework.system.frozen import frozen


@frozen
class Texts:
    """Texts of a variant in one language; what is empty or missing is said as the author wrote it.

    `because` holds the reason of a constraint by its name, `means` the meaning of a datum by its name.
    """

    title: str = ""
    source: str = ""
    teaches: str = ""
    remarks: tuple[str, ...] = ()
    because: Mapping[str, str] = field(default_factory=dict)
    means: Mapping[str, str] = field(default_factory=dict)

    @property
    def all(self) -> frozenset[str]:
        """Return every text there is."""
        one_by_one = (self.title, self.source, self.teaches)
        return frozenset((*one_by_one, *self.remarks, *self.because.values(), *self.means.values()))
