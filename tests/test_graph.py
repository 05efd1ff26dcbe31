"""Only what is asked for is computed, each once; what is not asked for is not even imported."""

import json
import subprocess
import sys

import numpy as np
import pytest

import coursework
from coursework.graph import UnknownQuantity, Values, make_plan
from coursework.quantities import ASKABLE, DEFAULT, QUANTITIES
from coursework.run import wanted

RULES = {
    "length": lambda given: given + 1,
    "width": lambda length: length * 2,
    "area": lambda length, width: length * width,
    "unused": lambda area: area,
}


def test_a_plan_names_ancestors_in_order_and_who_needs_them():
    plan = make_plan(RULES, ["area"], ["given"])
    assert plan.order == ("length", "width", "area")
    assert plan.needed_by == {"length": "area", "width": "area", "area": "area"}
    assert plan.left_out == {"unused": ()}
    assert plan.lines() == [
        "Computed, in this order:",
        "  length           needed by area",
        "  width            needed by area",
        "  area             asked for",
        "Left out:",
        "  unused           not asked for",
    ]


def test_a_plan_for_everything_leaves_nothing_out():
    assert make_plan(RULES, RULES, ["given"]).lines()[-2:] == ["Left out:", "  nothing"]


def test_what_is_given_is_not_computed():
    assert make_plan(RULES, ["area"], ["length"]).order == ("width", "area")
    assert make_plan(RULES, ["length"], ["length"]).order == ()


def test_values_are_computed_once_and_only_when_looked_at():
    values = Values(RULES, {"given": 2})
    assert values.calls == {}
    assert values["width"] == 6
    assert values.calls == {"length": 1, "width": 1}
    assert values["area"] == 18
    assert values["area"] == 18
    assert values.calls == {"length": 1, "width": 1, "area": 1}
    assert values.seconds.keys() == values.calls.keys()


def test_an_unknown_quantity_is_told_with_the_closest_name():
    with pytest.raises(UnknownQuantity) as caught:
        make_plan(RULES, ["aera"], ["given"])
    assert str(caught.value) == 'There is no quantity "aera". Did you mean "area"? Known: length, width, area, unused.'
    with pytest.raises(coursework.InputError) as told:
        coursework.solve("31", quantities=["acelerations"])
    assert str(told.value).startswith('there is no quantity "acelerations". Did you mean "accelerations"? Known: table, plots')


def test_a_circle_is_a_fault_of_the_rules():
    circle = {"a": lambda b: b, "b": lambda c: c, "c": lambda a: a}
    with pytest.raises(RuntimeError, match="quantities need each other in a circle: a needs b needs c needs a"):
        make_plan(circle, ["a"], [])


def test_the_rules_of_the_house_have_no_circle_and_no_stranger():
    plan = make_plan(QUANTITIES, QUANTITIES, ("variant", "settings"))
    assert set(plan.order) == set(QUANTITIES)
    assert set(DEFAULT) <= set(ASKABLE) <= set(QUANTITIES)
    for name, rule in QUANTITIES.items():
        assert rule.__name__ == name
        assert rule.__doc__


MARCH = {"mechanism", "equations", "start", "closure", "reduction", "rates", "flow", "event", "stop", "motion"}
CHECKED = MARCH | {"half", "exact", "wide"}
SCENES = {
    "one angle": ("31", ["phi3"], MARCH | {"table"}),
    "table": ("31", ["table"], MARCH | {"table"}),
    "a chain of groups": ("example-1", ["table"], MARCH | {"table"}),
    "plots": ("31", ["plots"], MARCH | {"exact", "plots"}),
    "checks": ("31", ["table", "checks"], CHECKED | {"table", "checks"}),
    "accelerations": ("31", ["accelerations"], MARCH | {"accelerations"}),
    "points": ("31", ["points"], MARCH | {"points"}),
    "points that accelerate": ("31", ["points", "accelerations"], MARCH | {"accelerations", "point_accelerations"}),
    "analogs": ("example-2", ["analogs"], MARCH | {"exact", "exact_accelerations", "analogs"}),
    "invariants": ("variable-crank", ["invariants"], MARCH | {"exact", "exact_accelerations", "invariants"}),
    "accuracy": ("31", ["accuracy"], CHECKED | {"budget", "accuracy"}),
    "drawing": ("31", ["graph_check"], MARCH | {"exact", "graph_check"}),
}


@pytest.mark.parametrize("scene", SCENES)
def test_exact_calls(scene):
    name, asked, computed = SCENES[scene]
    run = coursework.solve(name, quantities=asked)
    assert run.values.calls == {}
    run.columns()
    for quantity in wanted(run.asked):
        _ = run.values[quantity]
    assert run.values.calls == dict.fromkeys(computed, 1)
    assert set(run.plan.order) <= computed
    assert set(run.plan.left_out) == set(QUANTITIES) - set(run.plan.order)


def test_what_nothing_asked_for_needs_names_what_would():
    told = make_plan(RULES, ["length"], ["given"]).lines()
    assert "  width            only for area, not asked for" in told
    assert "  area             only for unused, not asked for" in told


def test_a_new_quantity_costs_a_table_nothing(monkeypatch):
    """A quantity added to the program is not computed, and nothing is computed more often, unless somebody asks for it."""
    before = coursework.solve("31", quantities=["table"])
    before.columns()

    def torque(motion, accelerations):
        """A quantity of tomorrow."""
        return motion.velocities * accelerations

    monkeypatch.setitem(QUANTITIES, "torque", torque)
    after = coursework.solve("31", quantities=["table"])
    after.columns()
    assert after.values.calls == before.values.calls
    assert after.plan.left_out["torque"] == ()
    assert after.values["torque"].shape == after.motion.velocities.shape
    assert after.values.calls["torque"] == 1


def test_looking_again_computes_nothing():
    run = coursework.solve("31", quantities=["table", "checks"])
    first, table = run.checks, run.table
    calls = dict(run.values.calls)
    assert run.checks is first
    assert run.table.equals(table)
    assert run.motion is run.values["motion"]
    assert run.values.calls == calls


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
    assert run.values["rates"].blocks == blocks
    assert (run.motion.coordinate_names, run.motion.velocity_names) == (coordinates, velocities)
    assert np.max(np.abs(run.motion.column(column) - whole.column(column))) < 1e-14


LOOK = """
import json, sys
{code}
print(json.dumps(sorted(sys.modules)))
"""
COMMAND = """
from coursework.cli import main
import contextlib, io
with contextlib.redirect_stdout(io.StringIO()):
    try:
        main({arguments!r})
    except SystemExit as end:
        assert not end.code, end.code
"""
HEAVY = {"numpy", "sympy", "pydantic", "pandas", "scipy", "matplotlib", "jinja2", "typst"}
PAGES = {"pandas", "scipy", "matplotlib", "jinja2", "typst", "coursework.report"}
EXTRA = {"coursework.kinematics.accelerations", "coursework.kinematics.points", "coursework.plans.graph_check",
         "coursework.checks.check", "coursework.accuracy.study"}  # fmt: skip


def imported(code, folder):
    done = subprocess.run([sys.executable, "-c", LOOK.format(code=code)], capture_output=True, text=True, cwd=folder, check=False)
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stdout.splitlines()[-1]))


def command(*arguments):
    return COMMAND.format(arguments=list(arguments))


@pytest.mark.parametrize(
    ("code", "absent"),
    [
        ("import coursework", HEAVY | {"click"}),
        (command("--help"), HEAVY),
        (command("run", "--help"), HEAVY),
        (command("variants"), HEAVY),
        (command("run", "31", "--quantities", "table", "--format", "csv"), PAGES | EXTRA),
        (command("run", "31", "--quantities", "phi3", "--format", "csv"), PAGES | EXTRA),
        (command("run", "31", "--quantities", "table,checks", "--format", "csv"), PAGES | EXTRA - {"coursework.checks.check"}),
        (
            command("run", "31", "--quantities", "accelerations", "--format", "csv"),
            PAGES | EXTRA - {"coursework.kinematics.accelerations"},
        ),
        (command("run", "31", "--quantities", "table,plots", "--format", "html"), {"pandas", "scipy", *EXTRA}),
        (command("check", "31"), PAGES | EXTRA),
        (command("run", "31", "--plan"), PAGES | EXTRA),
    ],
    ids=["import", "help", "run help", "variants", "table", "one angle", "checks", "accelerations", "html", "check", "plan"],
)
def test_what_is_not_imported(code, absent, tmp_path):
    found = imported(code, tmp_path)
    assert "coursework" in found
    assert found & absent == set()


def test_the_look_at_imports_sees_them(tmp_path):
    assert {"numpy", "sympy", "pandas"} <= imported(
        "import coursework\ncoursework.solve('31', quantities=['table']).table", tmp_path
    )


@pytest.mark.parametrize("columns", [["phi3"], ["w3"], ["w4"], ["phi1"]])
def test_the_exact_table_of_some_columns_has_the_same_columns(columns):
    table = coursework.exact("31", quantities=columns)
    assert list(table.columns) == list(coursework.solve("31", quantities=columns).table.columns)
    assert np.array_equal(table, coursework.exact("31")[list(table.columns)])


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"step": "fast"}, "the step must be a number of seconds, found 'fast'"),
        ({"end": [1]}, "the end must be a number of seconds"),
        ({"end": float("inf")}, "the end must be a number of seconds, found inf"),
        ({"project": 1.5}, "0 to 20 Newton corrections a step, found 1.5"),
        ({"project": -1}, "0 to 20 Newton corrections a step, found -1"),
    ],
)
def test_arguments_that_are_no_numbers_are_refused_in_a_sentence(options, told):
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve("31", **options)
    assert told in str(caught.value)


def test_one_quantity_may_be_named_without_a_list():
    assert coursework.solve("31", quantities="table").asked == ("table",)
