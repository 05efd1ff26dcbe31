"""The data of a text that can be moved: what each is, how far, and where it stands in the text.

Enters: a `Desk` whose text has no faults.  Leaves: a plain record a datum or start value.  Used by `variant_page.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from coursework.desk.answering.edits import value_place
from coursework.desk.answering.typed import Desk
from coursework.report.text.symbols import symbol
from coursework.report.wording.data_meanings import coordinate_meanings, meanings
from coursework.variant.formula.units import UNITS
from coursework.variant.toml.positions import KeyPath

MOST = 80
_FEWEST = 50  # places of a slider


def controls(desk: Desk) -> list[dict[str, Any]]:
    """Return the data of the task sheet and the start values that the file writes, in its order."""
    return [one for _, one in zip(range(MOST), _controls(desk), strict=False)]


def _controls(desk: Desk) -> Iterator[dict[str, Any]]:
    variant, mechanism, written = desk.variant, desk.run.scene.mechanism, desk.words.written
    said = variant.texts.get(desk.language)
    means = meanings(mechanism) | coordinate_meanings(mechanism)
    for given in variant.given:
        path: KeyPath = ("given", given.name)
        title = said.means.get(given.name) if said else None
        yield _control(desk, path, "given", given.text, given.unit, given.si == "rad") | {
            "title": title or written(means[given.name])
        }
    for one in variant.coordinates:
        if one.start is not None:
            path = ("coordinates", one.name, "start")
            unit = "" if one.start_has_no_unit else one.written
            yield _control(desk, path, "start", one.text, unit, one.unit == "rad") | {"title": written(means.get(one.name, ""))}


def _control(desk: Desk, path: KeyPath, kind: str, text: str, unit: str, is_angle: bool) -> dict[str, Any]:
    value = float(text.replace("−", "-").replace(",", "."))
    digits = len(text.partition(".")[2])
    whole = 1.0 if unit not in UNITS else float(UNITS[unit][0])
    if is_angle:
        low, high = value - math.pi / whole, value + math.pi / whole
    else:
        low, high = sorted((0.5 * value, 1.5 * value)) if value else (-1.0, 1.0)
    step = min(10.0**-digits, 10.0 ** math.floor(math.log10((high - low) / _FEWEST)))
    decimals = max(0, -round(math.log10(step)))
    name = str(path[1])
    return {
        "name": name, "kind": kind, "symbol": symbol(name).text, "value": value, "unit": unit, "digits": digits, "step": step,
        "low": round(math.floor(low / step) * step, decimals), "high": round(math.ceil(high / step) * step, decimals),
        "text": f"{text} {unit}".rstrip(), "place": value_place(desk.text, path), "line": desk.variant.line_of(*path[:2]),
    }  # fmt: skip
