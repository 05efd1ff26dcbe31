"""The texts of a file about its variant in other languages than the author's: [text.ru], [text.uk] …

Enters: the checked file.  Leaves: `Texts`.
Used by `reader.py` and `variant.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from coursework.system.frozen import frozen


@frozen
class Texts:
    """The texts of a variant in one language; an empty or missing text is shown in the author's language.

    `because` maps the name of a constraint to its reason, `means` the name of a datum to its meaning.
    """

    title: str = ""
    source: str = ""
    teaches: str = ""
    remarks: tuple[str, ...] = ()
    because: Mapping[str, str] = field(default_factory=dict)
    means: Mapping[str, str] = field(default_factory=dict)

    @property
    def all(self) -> frozenset[str]:
        """Return all texts."""
        one_by_one = (self.title, self.source, self.teaches)
        return frozenset((*one_by_one, *self.remarks, *self.because.values(), *self.means.values()))
