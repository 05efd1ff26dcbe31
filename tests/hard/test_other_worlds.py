"""A mechanism in a world where every length and every time is many times larger or smaller: nothing is judged otherwise.

The factors are powers of two and the numbers of a file are multiplied as decimals, so nothing is rounded on the way: rows agree
to round-off, and a limit that counts metres or seconds instead of shares shows.
"""

import re
from collections.abc import Callable
from decimal import Decimal
from functools import cache

import numpy as np
import pytest

import coursework
from coursework.run import Run
from coursework.variant.formula.motion_units import KINDS, UNITS
from coursework.variant.reading.reader import parse_variant
from tests.hard.scenes import ROOT

VALUE = re.compile(r'"([-+]?[0-9]*\.?[0-9]+) ([^"{}\s]+)"')
# A file of the catalogue, and what stands otherwise in it: a period after which the drive is not back, a dead point, a short run.
FILES = {
    "31": ("31", "", ""),
    "31, far period": ("31", '"2*pi/p"', '"999*pi/p"'),
    "31, dead point": ("31", '"4.35 rad"', '"0.02 rad"'),
    "31, short": ("31", '"0.48 s"', '"0.2 s"'),
    "v105": ("v105", "", ""),
    "v107": ("v107", "", ""),
    "v112": ("v112", "", ""),
    "oscillating-cylinder": ("oscillating-cylinder", "", ""),
}
WORLDS = {name: ((10, -6), (-9, 7))[place % 2] for place, name in enumerate(FILES)}  # the powers of lengths and times
KIND_OF = {"position": "m", "velocity": "m/s", "acceleration": "m/s^2"}
ROUND_OFF = {"CONDITION", "RESIDUAL", "START", "INITIAL"}  # their numbers are round-off if all is well, and differ


def _factor(unit: str, length: int, time: int) -> float:
    of_length, of_time = KINDS.get(unit.replace("rad/s", "1/s").replace("²", "^2"), ((0, 0), ""))[0]
    return 2.0 ** (length * of_length + time * of_time)


@cache
def _run(name: str, length: int = 0, time: int = 0) -> Run:
    def larger(found: re.Match[str]) -> str:
        factor = Decimal(_factor(UNITS[found[2]][1], length, time)) if found[2] in UNITS else Decimal(1)
        return f'"{Decimal(found[1]) * factor:f} {found[2]}"'

    file, old, new = FILES[name]
    text = (ROOT / "variants" / f"{file}.toml").read_text(encoding="utf-8").replace(old, new)
    return coursework.solve(parse_variant(VALUE.sub(larger, text), f"{file}.toml"))


def _agree(name: str, close: float, of: Callable[[Run], dict[str, tuple[str, object]]]) -> None:
    """Assert that two worlds have the same values, each given with its unit; a text is not a number and stays."""
    world = WORLDS[name]
    here, there = of(_run(name)), of(_run(name, *world))
    assert here.keys() == there.keys()
    for key, (unit, value) in here.items():
        if isinstance(value, float | np.ndarray):
            factor = _factor(unit, *world)
            assert np.allclose(there[key][1], value * factor, rtol=close, atol=1e-10 * factor, equal_nan=True), key
        else:
            assert there[key][1] == value, key


@pytest.mark.parametrize("name", FILES)
def test_every_verdict_and_its_number_are_the_same(name):
    def of(run):
        found = {}
        for one in run.checks:
            found |= {f"{one.code} {part}": ("", getattr(one, part)) for part in ("verdict", "unit", "cured", "is_news")}
            if one.code not in ROUND_OFF:
                found |= {f"{one.code} {part}": (one.unit, getattr(one, part)) for part in ("value", "limit")}
                found |= {f"{one.code} {part}": ("", getattr(one, part)) for part in ("row", "column", "scheme")}
                found[f"{one.code} step"] = "s", one.step
        return found

    _agree(name, 2e-5, of)  # a peak is searched no closer


@pytest.mark.parametrize("name", FILES)
def test_every_row_and_the_end_of_the_motion_are_the_same(name):
    def of(run):
        table, points, period = run.table, run.points, run.scene.one_period
        found = {"t": ("s", table.index.to_numpy()), "period": ("s", period.t)}
        for column in table:
            found[column] = table.attrs["units"][column], table[column].to_numpy()
        for column in points:
            found[" ".join(column)] = KIND_OF[column[1]], points[column].to_numpy()
        for place, (one, unit) in enumerate(zip(run.exact.coordinate_names, run.variant.coordinates, strict=True)):
            found[f"exact {one}"] = unit.unit, run.exact.coordinates[:, place]
            found[f"period {one}"] = unit.unit, period.coordinates[:, place]
        if run.stop is not None:
            assert 0 < run.stop.time - run.scene.last_time < 1e-6 * run.stop.time  # the motion is known up to just before it
            found |= {"stop": ("s", run.stop.time), "kind": ("", run.stop.kind), "row": ("", run.stop.row)}
        return found

    _agree(name, 1e-9, of)


def test_a_run_that_is_shorter_than_its_period_has_the_whole_period_of_the_exact_motion():
    short, whole = _run("31, short").scene.one_period, _run("31").scene.one_period
    assert short.t[-1] == _run("31").variant.time.period
    assert np.allclose(short.coordinates, whole.coordinates, rtol=0, atol=1e-9)
