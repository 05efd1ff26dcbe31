"""What is said of the largest rate: its moment, its rows, or nothing where it is constant; and when a step turns too far."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.computed_right.conditioning import _moment, peak
from coursework.words.sentences import say


@pytest.mark.parametrize(("rates", "when", "key", "told", "value"), [
    ([1, 3, 2, 1], 0.15, "moment", {"time": 0.15}, 3), ([1, 2, 1, 1], 0.15, "moment", {"time": 0.15}, 3),
    ([1, 3, -3, 2], 0.15, "held", {"first": 2, "last": 3}, 3), ([3, 3, 3, 3], 0.0, "held", {"first": 1, "last": 4}, 3),
    ([1, 3 - 2e-9, 3 + 2e-9, 2], 0.15, "held", {"first": 2, "last": 3}, 3), ([1, 3 - 4e-9, 3, 2], 0.15, "moment", {}, 3),
    ([1, 2, 3, 3], 0.3, "held", {"first": 3, "last": 4}, 3),
    ([3, 3, 3], None, "constant", {}, 3), ([-3, -3, -3], None, "constant", {}, -3), ([3, -3, 3], None, "size", {}, 3),
    (None, None, "constant", {}, 3),
])  # fmt: skip
def test_a_rate_is_largest_at_a_moment_or_in_rows_or_throughout(rates, when, key, told, value):
    columns = {} if rates is None else {"w": np.array(rates, dtype=float)}
    evidence = SimpleNamespace(motion=SimpleNamespace(names=(*columns,), column=columns.get), say=say)
    moment, size = _moment(evidence, "w", 3.0, when)
    assert (moment.key, size) == (f"check.PEAK.{key}", value)
    assert {name: moment.values[name] for name in told} == told


@pytest.mark.parametrize(("turned", "verdict"), [(1 + 0.9e-9, "PASS"), (1 + 1.1e-9, "COARSE")])
@pytest.mark.parametrize("is_trial", [False, True])
def test_the_angle_that_turns_most_in_a_step_is_judged(turned, verdict, is_trial):
    """b turns by so much in 0.1 s, a by half a radian; s is a length, and turns not at all."""
    coordinates = [
        SimpleNamespace(name=name, rate=f"w{name}", unit=unit) for name, unit in zip("sab", ("m", "rad", "rad"), strict=True)
    ]
    search = SimpleNamespace(
        given_up=None, fastest=lambda places: {place: (9.0 - place, 0.4) for place in places},
        way_within=lambda place: lambda step: {1: 5 * step, 2: turned * step / 0.1}[place],
        longest_step=lambda place, most, step: place + most + step,
    )  # fmt: skip
    evidence = SimpleNamespace(
        variant=SimpleNamespace(coordinates=coordinates), motion=SimpleNamespace(step=0.1, names=(), column=None), search=search,
        stop=None, say=say, is_trial=is_trial,
    )  # fmt: skip
    found = peak(evidence)
    assert (found.verdict, found.value, found.limit, found.column) == (verdict, turned, 1.0, "wb")
    values = found.sentence.values
    assert (values["rate"], values["name"], values["value"], values["turned"]) == ("wb", "b", 7.0, turned)
    assert verdict == "PASS" or values["step"] == (0.0 if is_trial else pytest.approx(3.1))


@pytest.mark.parametrize(("changes", "key"), [
    ({"search": None}, "stopped"), ({"stop": "dead"}, "stopped"), ({"search": SimpleNamespace(given_up=2.0)}, "given_up"),
    ({"search": SimpleNamespace(given_up=None, fastest=lambda places: {})}, "stopped"),
    ({"search": SimpleNamespace(given_up=None, fastest=lambda places: {"all": places == []})}, "no_angle"),
])  # fmt: skip
def test_where_the_motion_is_not_known_or_nothing_turns_no_peak_is_judged(changes, key):
    given = {
        "variant": SimpleNamespace(coordinates=[SimpleNamespace(unit="m")]),
        "motion": SimpleNamespace(step=0.1),
        "search": SimpleNamespace(given_up=None, fastest=lambda places: {"all": True}),
        "stop": None,
    }
    found = peak(SimpleNamespace(**{**given, "say": say, "is_trial": False, **changes}))
    assert (found.verdict, found.sentence.key) == ("SKIP", f"check.PEAK.{key}")
