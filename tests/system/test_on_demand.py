"""Only what is asked for is computed, each once; what is not asked for is not even imported."""

import ast
import inspect
import textwrap
from dataclasses import FrozenInstanceError, replace
from graphlib import CycleError

import numpy as np
import pytest

import coursework
from coursework.equations.reduction.symbolic import symbol
from coursework.scene.motion_results import MotionResults
from coursework.scene.quantities import POINT_ACCELERATIONS, QUANTITIES, all_needs, quantities_for
from coursework.scene.scene import Scene
from coursework.scene.way_to_motion import WayToMotion
from coursework.system.on_demand import Computed, Ledger, computed, make_plan, needs_of

NEEDS = {"length": ("given",), "width": ("length",), "area": ("length", "width"), "unused": ("area",)}


class Field:
    """Three quantities on each other."""

    def __init__(self, given):
        self.given, self.ledger = given, Ledger()

    @computed()
    def length(self):
        return self.given + 1

    @computed("length")
    def width(self):
        return self.length * 2

    @computed("length", "width")
    def area(self):
        return self.length * self.width


def test_a_plan_names_ancestors_in_order_and_who_needs_them():
    plan = make_plan(NEEDS, ["area"])
    assert plan.order == ("length", "width", "area")
    assert plan.needed_by == {"length": "area", "width": "area", "area": "area"}
    assert plan.left_out == {"unused": ()}
    assert plan.lines() == [
        "Computed, in this order:",
        "  length               needed by area",
        "  width                needed by area",
        "  area                 asked for",
        "Left out:",
        "  unused               not asked for",
    ]


def test_a_plan_for_everything_leaves_nothing_out():
    assert make_plan(NEEDS, NEEDS).lines()[-2:] == ["Left out:", "  nothing"]


def test_values_are_computed_once_and_only_when_looked_at():
    field = Field(2)
    assert field.ledger.calls == {}
    assert field.width == 6
    assert field.ledger.calls == {"length": 1, "width": 1}
    assert field.area == 18
    assert field.area == 18
    assert field.ledger.calls == {"length": 1, "width": 1, "area": 1}
    assert field.ledger.seconds.keys() == field.ledger.calls.keys()
    assert needs_of(Field) == {name: needs for name, needs in NEEDS.items() if name != "unused"} | {"length": ()}


def test_an_unknown_quantity_is_told_with_the_closest_name():
    with pytest.raises(coursework.InputError) as told:
        coursework.solve("31", quantities=["acelerations"])
    assert str(told.value).startswith(
        'C002 there is no quantity "acelerations". Did you mean "accelerations"? Known: table, plots'
    )


def test_a_circle_is_a_fault_of_the_rules():
    with pytest.raises(CycleError):
        make_plan({"a": ("b",), "b": ("c",), "c": ("a",)}, ["a"])


def test_the_quantities_have_no_circle():
    assert set(make_plan(all_needs(), all_needs()).order) == set(all_needs())
    assert all(quantity.compute.__doc__ for quantity in QUANTITIES)


def looked_at(found):
    """Return the names of quantities that the source of one looks at, through `self`, `results`, `scene` and methods."""
    known = set(all_needs())
    methods = {name: method for kind in (WayToMotion, Scene, MotionResults) for name, method in vars(kind).items()}
    names, waiting, seen = set(), [found.compute], set()
    while waiting:
        source = ast.parse(textwrap.dedent(inspect.getsource(waiting.pop())))
        for node in ast.walk(source):
            if isinstance(node, ast.Attribute) and ast.unparse(node.value) in {
                "self",
                "results",
                "scene",
                "self.scene",
                "results.scene",
            }:
                name = node.attr
                method = methods.get(name)
                method = method.fget if isinstance(method, property) else method
                if name in known:
                    names.add(name)
                elif inspect.isfunction(method) and name not in seen | {"over"}:
                    seen.add(name)
                    waiting.append(method)
    return names


EVERY = [one for kind in (WayToMotion, Scene, MotionResults) for one in vars(kind).values() if isinstance(one, Computed)]
EVERY += [quantity.compute for quantity in QUANTITIES if quantity.compute not in EVERY]


@pytest.mark.parametrize("one", EVERY, ids=lambda one: one.name)
def test_what_a_quantity_declares_is_what_it_looks_at(one):
    assert set(one.needs) == looked_at(one)


def test_a_scene_is_frozen_to_its_users():
    run = coursework.solve("31", quantities=["table"])
    for owner, name in ((run, "asked"), (run.scene, "motion"), (run.scene, "event"), (run.results, "motion")):
        with pytest.raises(FrozenInstanceError):
            setattr(owner, name, None)


def test_any_motion_is_judged_by_the_same_code_with_a_cache_of_its_own():
    run = coursework.solve("31", quantities=["table", "checks"])
    exact = run.scene.over(run.exact)
    spoilt = run.scene.over(replace(run.motion, velocities=run.motion.velocities * 1.01))
    assert np.array_equal(exact.accelerations, run.scene.exact_accelerations)
    assert not np.array_equal(exact.accelerations, run.results.accelerations)
    verdicts = [{check.code: check.verdict for check in results.checks} for results in (exact, run.results, spoilt)]
    assert [verdict["RESIDUAL"] for verdict in verdicts] == ["PASS", "PASS", "FAIL"]
    assert exact.ledger.calls["checks"] == spoilt.ledger.calls["checks"] == run.scene.ledger.calls["checks"] == 1


MARCH = {"mechanism", "equations", "start", "closure", "reduction", "rates", "flow", "search", "stop", "motion"}
CHECKED = MARCH | {"exact", "extended_precision", "evidence"}
SCENES = {
    "one angle": ("31", ["phi3"], MARCH | {"table"}),
    "table": ("31", ["table"], MARCH | {"table"}),
    "a chain of groups": ("example-1", ["table"], MARCH | {"exact", "table"}),
    "plots": ("31", ["plots"], MARCH | {"exact", "plots"}),
    "checks": ("31", ["table", "checks"], CHECKED | {"table", "checks"}),
    "accelerations": ("31", ["accelerations"], MARCH | {"accelerations"}),
    "points": ("31", ["points"], MARCH | {"points"}),
    "points that accelerate": ("31", ["points", "accelerations"], MARCH | {"accelerations", "point_accelerations"}),
    "analogs": ("example-2", ["analogs"], MARCH | {"exact", "exact_accelerations", "analogs"}),
    "invariants": ("variable-crank", ["invariants"], MARCH | {"exact", "invariants"}),
    "accuracy": ("31", ["accuracy"], MARCH | {"exact", "accuracy"}),
    "drawing": ("31", ["graph_check"], MARCH | {"exact", "graph_check"}),
}


@pytest.mark.parametrize("scene", SCENES)
def test_exact_calls(scene):
    name, asked, computed = SCENES[scene]
    run = coursework.solve(name, quantities=asked)
    assert run.scene.ledger.calls == {}
    run.columns()
    for quantity in quantities_for(run.asked).values():
        run.of(quantity)
    assert run.scene.ledger.calls == dict.fromkeys(computed, 1)
    assert computed - {"motion"} <= set(run.plan.order) <= computed  # the rows are always made
    assert set(run.plan.left_out) == set(all_needs(type(run.scene))) - set(run.plan.order)


def test_what_nothing_asked_for_needs_names_what_would():
    told = make_plan(NEEDS, ["length"]).lines()
    assert "  width                only for area, not asked for" in told
    assert "  area                 only for unused, not asked for" in told


def test_points_bring_their_accelerations_where_both_are_asked_for():
    run = coursework.solve("31", quantities=["accelerations", "points"])
    assert POINT_ACCELERATIONS in quantities_for(run.asked).values()
    assert "M.ax" in run.columns()[0]


def test_looking_again_computes_nothing():
    run = coursework.solve("31", quantities=["table", "checks"])
    first, table = run.checks, run.table
    calls = dict(run.scene.ledger.calls)
    assert run.checks is first
    assert run.table.equals(table)
    assert run.motion is run.scene.motion is run.results.motion
    assert run.scene.ledger.calls == calls


@pytest.mark.parametrize(
    ("column", "coordinates", "velocities", "blocks"),
    [
        ("phi3", ("phi3",), ("w3",), (0,)),
        ("w3", ("phi3",), ("w3",), (0,)),
        ("w4", ("phi3",), ("w3", "w4"), (0, 1)),
        ("phi1", ("phi1", "phi2", "phi3"), ("w1", "w2", "w3"), (0, 1, 2)),
    ],
)
def test_a_column_restricts_the_right_hand_side(column, coordinates, velocities, blocks):
    run = coursework.solve("31", quantities=[column])
    whole = coursework.solve("31", quantities=["table"]).motion
    assert run.scene.rates.blocks == blocks
    assert (run.motion.coordinate_names, run.motion.velocity_names) == (coordinates, velocities)
    assert np.max(np.abs(run.motion.column(column) - whole.column(column))) < 1e-14


@pytest.mark.parametrize("columns", [["phi3"], ["w3"], ["w4"], ["phi1"]])
def test_the_exact_table_of_some_columns_has_the_same_columns(columns):
    table = coursework.exact("31", quantities=columns)
    assert list(table.columns) == list(coursework.solve("31", quantities=columns).table.columns)
    assert np.array_equal(table, coursework.exact("31")[list(table.columns)])


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"step": "fast"}, "a step in seconds, such as 0.02"),
        ({"step": True}, "the step must be a number of seconds, found True"),
        ({"end": "late"}, "the end must be a number of seconds, found 'late'"),
        ({"end": [1]}, "the end must be a number of seconds"),
        ({"end": float("inf")}, "the end must be a number of seconds, found inf"),
        ({"project": 1.5}, "0 to 20 Newton corrections per step, found 1.5"),
        ({"project": -1}, "0 to 20 Newton corrections per step, found -1"),
    ],
)
def test_arguments_that_are_no_numbers_are_refused_in_a_sentence(options, told):
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve("31", **options)
    assert told in str(caught.value)


def test_one_quantity_may_be_named_without_a_list():
    assert coursework.solve("31", quantities="table").asked == ("table",)


def test_asking_for_more_changes_nothing_behind_the_back():
    """What a page says of a run does not depend on what was asked of it before."""
    plain, asked = (coursework.solve("variable-crank", quantities=["table", "checks", "accelerations"]) for _ in range(2))
    asked.columns()
    assert asked.checks
    for run in (plain, asked):
        assert set(run.scene.equations.symbols.definitions) == {
            symbol(law.name) for law in (*run.variant.drive, *run.variant.functions)
        }
    assert plain.partials == asked.partials
    assert plain.solutions == asked.solutions
