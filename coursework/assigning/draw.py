"""Seed, template, ranges and a student -> the data of one attempt, from SHA-256 and nothing else.

Enters: a template, `Ranges`, a seed.  Leaves: `Lots`, whose draws depend on no other student and not on their order.
Used by `accept.py`.
"""

from __future__ import annotations

import hashlib
import json
import unicodedata
from dataclasses import dataclass, field
from functools import cached_property

from coursework.assigning.ranges import Path, Ranges
from coursework.variant.record.variant import Variant

PILOT = ""  # the id of the draws that set the centre of difficulty; no student has an empty id


@dataclass(frozen=True, eq=False)
class Lots:
    """The random draws of one class."""

    template: Variant = field(repr=False)
    ranges: Ranges
    seed: str

    def draw(self, student: str, attempt: int) -> dict[Path, str]:
        """Return the drawn value of each datum as a variant file writes it, by its path in the file."""
        normal = unicodedata.normalize("NFC", student)
        drawn = {}
        for one in self.ranges.ranges:
            lot = json.dumps([normal, attempt, one.name], ensure_ascii=False).encode("utf-8", "surrogatepass")
            state = self._begun.copy()
            state.update(lot)
            # 256 bits are so many more than the values that none of them is noticeably likelier.
            drawn[one.path] = one.text(int.from_bytes(state.digest(), "big") % one.count)
        return drawn

    @cached_property
    def _begun(self) -> hashlib._Hash:
        """Return the hash of all data that are the same for all students."""
        variant = self.template
        data = [
            [[given.name, given.text, given.unit] for given in variant.given],
            [[c.name, c.text, c.written] for c in variant.coordinates],
            [variant.time.step, variant.time.end, variant.time.period],
        ]
        shared = json.dumps([self.seed, data, self.ranges.digest], ensure_ascii=False)
        return hashlib.sha256(shared.encode("utf-8", "surrogatepass"))
