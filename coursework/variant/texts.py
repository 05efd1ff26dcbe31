"""What a file says about its variant in other languages than the author's: [text.ru], [text.uk] …

Enters: the checked file.  Leaves: `Texts`, and a variant that speaks one of them.
Used by `assigning/`, `reader.py`, `record.py` and `report/page_context.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coursework.variant.record import Variant


@dataclass(frozen=True, slots=True)
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


def in_language(variant: Variant, language: str) -> Variant:
    """Return the variant with its texts in a language, as far as its file has them."""
    texts = variant.texts.get(language)
    if texts is None:
        return variant
    return replace(
        variant,
        title=texts.title or variant.title,
        source=texts.source or variant.source,
        teaches=texts.teaches or variant.teaches,
        remarks=texts.remarks or variant.remarks,
        given=tuple(replace(one, means=texts.means.get(one.name, one.means)) for one in variant.given),
        constraints=tuple(replace(one, because=texts.because.get(one.name, one.because)) for one in variant.constraints),
    )
