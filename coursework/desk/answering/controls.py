"""The sliders for the data of a text: what each datum is, its range, and its place in the text.

Enters: a `Desk` whose text has no faults.  Leaves: a plain record per datum or start value.
Used by `variant_page.py` and `drag.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice
from typing import Any

from coursework.desk.answering.edits import value_place
from coursework.desk.answering.typed import Desk
from coursework.report.text.symbols import symbol
from coursework.report.wording.data_meanings import coordinate_meanings, meanings
from coursework.system.frozen import frozen
from coursework.variant.formula.units import size_of
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath

MOST = 80
_FEWEST = 50  # least number of places of a slider


@frozen
class Written:
    """A number written in the file: its `path`, its `text` and `unit` as written, and the SI unit of what it measures (`si`)."""

    path: KeyPath
    text: str
    unit: str
    si: str

    @property
    def name(self) -> str:
        """Return the name of the datum, or of the coordinate whose start it is."""
        return str(self.path[1])

    @property
    def digits(self) -> int:
        """Return the number of decimals that the file writes."""
        return len(self.text.partition(".")[2])

    @property
    def size(self) -> float:
        """Return the size of its unit in SI."""
        return size_of(self.unit) or 1.0

    def spelled(self, value: float, decimals: int) -> str:
        """Return another value (SI) in the unit of the file, with `decimals`."""
        return f"{value / self.size:.{decimals}f} {self.unit}".rstrip()


def written_numbers(variant: Variant) -> Iterator[Written]:
    """Yield the data of the task sheet, then the start values that the file writes, in its order."""
    for given in variant.given:
        yield Written(("given", given.name), given.text, given.unit, given.si)
    for one in variant.coordinates:
        if one.start is not None:
            yield Written(("coordinates", one.name, "start"), one.text, "" if one.start_has_no_unit else one.written, one.unit)


def controls(desk: Desk) -> list[dict[str, Any]]:
    """Return the sliders, at most `MOST`, each with its title in the language of the desk."""
    mechanism, said = desk.run.scene.mechanism, desk.variant.texts.get(desk.language)
    means = meanings(mechanism) | coordinate_meanings(mechanism) | (dict(said.means) if said else {})
    shown = islice(written_numbers(desk.variant), MOST)
    return [_control(desk, one) | {"title": desk.words.written(means.get(one.name, ""))} for one in shown]


def _control(desk: Desk, one: Written) -> dict[str, Any]:
    value = float(one.text.replace("−", "-").replace(",", "."))
    if one.si == "rad":
        low, high = value - math.pi / one.size, value + math.pi / one.size
    else:
        low, high = sorted((0.5 * value, 1.5 * value)) if value else (-1.0, 1.0)
    step = min(10.0**-one.digits, 10.0 ** math.floor(math.log10((high - low) / _FEWEST)))
    decimals = max(0, -round(math.log10(step)))
    return {
        "name": one.name, "kind": "given" if one.path[0] == "given" else "start", "symbol": symbol(one.name).text, "value": value,
        "unit": one.unit, "digits": one.digits, "step": step, "low": round(math.floor(low / step) * step, decimals),
        "high": round(math.ceil(high / step) * step, decimals), "text": f"{one.text} {one.unit}".rstrip(),
        "place": value_place(desk.text, one.path), "line": desk.variant.line_of(*one.path[:2]),
    }  # fmt: skip
