"""A variant with other data is the variant that its file would be with these data: nothing stays behind."""

import math
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.variant.catalogue import find, names
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import mechanism


def four_bar():
    return parse_variant(mechanism("four-bar-loop"), "bar")


def without_origin(variant):
    return replace(variant, path=None, name="", lines={}, reread=None, changes={}, before=None)


def test_period_texts_and_check_follow_the_data():
    variant = coursework.load("31").with_data(given={"p": 10})
    assert variant.time.period == pytest.approx(0.6283185307179586, rel=1e-15)
    assert next((given.text, given.unit) for given in variant.given if given.name == "p") == ("10", "1/s")
    run = coursework.solve(variant.with_data(end="2*pi/p", step=math.tau / 10 / 200), scheme="rk4")
    assert {check.code: check.verdict for check in run.checks}["PERIOD-POSITION"] == "PASS"


def test_it_is_the_file_with_these_data():
    text = find("31").read_text(encoding="utf-8")
    changed = text.replace('"0.953 m"', '"950 mm"').replace('"13.08 1/s"', '"10 1/s"').replace('"1.63 rad"', '"93 deg"')
    changed = changed.replace('"V1*sin(p*t + alpha)"', '"V1*cos(p*t)"').replace('"0.02 s"', '"0.01 s"')
    given, start, drive = {"r1": "950 mm", "p": "10 1/s"}, {"phi1": "93 deg"}, {"VMy": "V1*cos(p*t)"}
    found = coursework.load("31").with_data(given, start, drive, step="0.01 s")
    assert without_origin(found) == without_origin(parse_variant(changed, "31"))


@pytest.mark.parametrize("name", names())
def test_the_same_data_are_the_same_variant(name):
    variant = coursework.load(name)
    given = {one.name: one.value for one in variant.given}
    same = variant.with_data(given=given)
    assert same.values == variant.values
    assert same.time == variant.time
    assert (same.drive, same.constraints, same.groups, same.points) == (
        variant.drive, variant.constraints, variant.groups, variant.points
    )  # fmt: skip
    before, after = (coursework.solve(one, quantities=["table"]).scene.start for one in (variant, same))
    assert np.allclose(before, after, atol=1e-6)


def test_what_geometry_gives_is_closed_anew():
    variant = four_bar()
    for changes in ({"given": {"b": 0.32, "c": "26 cm"}}, {"start": {"phi1": 1.2}}):
        run = coursework.solve(variant.with_data(**changes), quantities=["table"])
        values = {**run.variant.values, **dict(zip(("phi1", "phi2", "phi3"), run.scene.start, strict=True))}
        a, b, c, d = (values[name] for name in "abcd")
        gap = a * np.exp(1j * values["phi1"]) + b * np.exp(1j * values["phi2"]) - d - c * np.exp(1j * values["phi3"])
        assert abs(gap) < 1e-12
        assert run.scene.start[1:] == pytest.approx([0.66, 1.4], abs=0.25)
        assert values["phi1"] == pytest.approx(changes.get("start", {}).get("phi1", math.pi / 3), rel=1e-15)


LOOPS = {  # both loops of [closure] as complex numbers, by hand
    "four-bar-with-relative-angles": lambda v, q: (
        v["r1"] * turned(q["q1"]) + v["r2"] * turned(q["q1"] + q["q2"]) - v["d"] - v["r3"] * turned(sum(q.values()))
    ),
    "four-bar-by-its-points": lambda v, q: (
        v["a"] * turned(q["phi1"]) + v["b"] * turned(q["phi2"]) - v["d"] - v["c"] * turned(q["phi3"])
    ),
    "four-bar-by-squared-lengths": lambda v, q: max(
        abs(math.hypot(q["xB"], q["yB"]) - v["r1"]), abs(math.hypot(q["xC"] - v["d"], q["yC"]) - v["r3"]),
        abs(math.hypot(q["xC"] - q["xB"], q["yC"] - q["yB"]) - v["r2"]),
    ),
}  # fmt: skip


def turned(angle):
    return np.exp(1j * angle)


@pytest.mark.parametrize("name", LOOPS)
def test_a_loop_that_equations_belong_to_is_closed_anew_too(name):
    """So do many sets at once; what is not in a loop, and what is said by name, stays."""
    variant = parse_variant(mechanism(name))
    coordinates = [one.name for one in variant.coordinates]
    longer = {given.name: 1.03 * given.value for given in variant.given if given.si == "m" and given.name in ("r2", "b")}
    run = coursework.solve(variant.with_data(given=longer), quantities=["table", "checks"])
    start = dict(zip(coordinates, run.scene.start, strict=True))
    assert abs(LOOPS[name](run.variant.values, start)) < 1e-12
    assert next(check.verdict for check in run.checks if check.code == "START") == "PASS"
    many = coursework.solve_many(variant, {key: [value] for key, value in longer.items()})
    assert [many.values[0, 0, many.columns.index(one)] for one in coordinates] == pytest.approx(list(start.values()), abs=1e-10)
    kept = coordinates[-1]
    said = coursework.solve(variant.with_data(given=longer, start={kept: variant.coordinates[-1].start}), quantities=["table"])
    assert said.scene.start[-1] == variant.coordinates[-1].start


LEVER = (  # the pin C of the four-bar moves in the slot of a lever about (d, -d)
    (
        "[time]",
        f'th = {{ start = "{math.atan2(0.29864227162241325 + 0.42, 0.3914904647494083 - 0.42)!r} rad", rate = "w3" }}\n[time]',
    ),
    ("[points]", '[[constraint]]\nequation = "vyC*cos(th) - vxC*sin(th) = w3*sqrt((xC - d)^2 + (yC + d)^2)"\n[points]'),
    ("holds = [", 'holds = ["(xC - d)*sin(th) - (yC + d)*cos(th)", '),
)


@pytest.mark.parametrize("longer", [{"r2": 0.41}, {"d": 0.43, "r3": 0.31}])
def test_what_is_held_beside_a_loop_is_kept(longer):
    variant = parse_variant(mechanism("four-bar-by-squared-lengths", *LEVER))
    run = coursework.solve(variant.with_data(longer), quantities=["table", "checks"])
    start = dict(zip([one.name for one in variant.coordinates], run.scene.start, strict=True))
    assert LOOPS["four-bar-by-squared-lengths"](run.variant.values, start) < 1e-12
    d = run.variant.values["d"]
    assert start["th"] == pytest.approx(math.atan2(start["yC"] + d, start["xC"] - d), abs=1e-12)
    assert next(check.verdict for check in run.checks if check.code == "START") == "PASS"
    many = coursework.solve_many(variant, {key: [value] for key, value in longer.items()})
    assert [many.values[0, 0, many.columns.index(one)] for one in start] == pytest.approx(list(start.values()), abs=1e-10)
    once_more = coursework.solve(variant.with_data({"w": 9.0}).with_data(longer), quantities=["table"])
    assert once_more.scene.start == pytest.approx(run.scene.start, abs=1e-12)


def test_what_geometry_does_not_hold_stays_as_it_was():
    assert coursework.solve(four_bar().with_data(given={"n": "90 rpm"}), quantities=["table"]).scene.start == (
        coursework.solve(four_bar(), quantities=["table"]).scene.start
    )


def test_data_that_cannot_close_are_told():
    with pytest.raises(coursework.InputError, match="no closed position lies near the old start"):
        coursework.solve(four_bar().with_data(given={"b": 0.001}), quantities=["table"]).columns()


def test_changes_add_up_and_survive_a_pickle():
    once = pickle.loads(pickle.dumps(coursework.load("31").timed(step=0.01).with_data(given={"p": 10})))
    twice = once.with_data(given={"r1": 0.94})
    assert (twice.values["p"], twice.values["r1"], twice.time.step, twice.time.own_step) == (10.0, 0.94, 0.01, 0.02)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"given": {"r1": "950 s"}}, '31, r1: a length was expected: m, cm, mm (found "950 s").'),
        ({"given": {"r9": 1}}, '31: "r9" is no given datum. Known: r1, r2, r3, V1, p, alpha, phi1, phi2, phi3.'),
        ({"given": {"r1": math.nan}}, "31, r1: a finite number was expected, found nan."),
        ({"given": {"r1": None}}, "31, r1: a number was expected, found None."),
        ({"start": {"phi1": "1 m"}}, '31, phi1: an angle was expected: rad, deg (found "1 m").'),
        ({"start": {"w1": 1}}, '31: "w1" is no coordinate. Known: phi1, phi2, phi3.'),
        ({"drive": {"VMz": "0"}}, '31: "VMz" is no drive. Did you mean "VMy"?'),
        ({"step": -1}, "31, step: the step must be greater than 0, found -1 s."),
        ({"given": {"r1": 0}}, "the link of length r1 has zero length"),
        ({"given": {"p": 0}}, "time.period"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused(changes, sentence):
    with pytest.raises(coursework.InputError) as caught:
        coursework.load("31").with_data(**changes)
    assert sentence in str(caught.value)


def test_a_file_in_memory_brings_its_tables():
    path = find("variable-crank-table")
    beside = {one.name: one.read_bytes() for one in path.parent.glob("*.csv")}
    variant = parse_variant(path.read_bytes(), path.stem, beside)
    assert without_origin(variant) == without_origin(coursework.load(path.stem))
    assert Path(path).exists() and variant.path is None


def test_a_table_in_memory_is_as_bounded_as_one_on_disk():
    path = find("variable-crank-table")
    beside = {one.name: b"0,1\n" * 70_000 for one in path.parent.glob("*.csv")}
    with pytest.raises(coursework.InputError, match="at most 262144 are read"):
        parse_variant(path.read_bytes(), path.stem, beside)
    (name,) = (one for one in beside if one.encode() in path.read_bytes())
    above = path.read_bytes().replace(name.encode(), b"../" + name.encode())
    with pytest.raises(coursework.InputError, match="lies outside the folder of the variant"):
        parse_variant(above, path.stem, {f"../{name}": b"0,1\n"})


def test_a_rod_of_less_than_nothing_is_refused_by_data_as_by_its_file():
    """Just inside: the shortest rod is read, whether or not it can be put together."""
    variant = coursework.load("example-1")
    assert variant.with_data(given={"r2": 1e-9}).values["r2"] == 1e-9
    with pytest.raises(coursework.InputError) as by_data:
        variant.with_data(given={"r2": -1e-9})
    text = find("example-1").read_text(encoding="utf-8")
    with pytest.raises(coursework.InputError) as by_file:
        parse_variant(text.replace('r2 = "1.0 m"', 'r2 = "-1e-09 m"'))
    told = [
        [(fault.code, fault.line, fault.column, str(fault.message)) for fault in error.value.faults]
        for error in (by_data, by_file)
    ]
    assert told[0] == told[1]
    ((*place, sentence),) = told[0]
    assert place == ["V308", 43, 16]
    assert sentence.startswith("r2: a finite length above zero was expected, found -1e-09 m. Write a length above zero;")
    assert sentence.endswith("turn its angle by pi instead.")
