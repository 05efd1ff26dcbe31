"""Many sets together are each set alone: rows to 1e-12, the same stops, and no dead point missed."""

import math

import numpy as np
import pandas as pd
import pytest

import coursework
from coursework.motion.geometry.drives.drive import resolved
from coursework.motion.schemes import SCHEMES
from coursework.scene.model.sets import prepare
from coursework.scene.model.start import start_of
from coursework.scene.model.watch import fewest_steps
from coursework.variant.catalogue import find, names
from tests.hard.drives import Law, four_bar
from tests.mechanisms.library import mechanism
from tests.sample import sampled

MODELS = {}


def model(name):
    if name not in MODELS:
        MODELS[name] = coursework.compile_model(name)
    return MODELS[name]


def spread(name, part, count, seed=0):
    """Return sets with every given datum off by at most a part of itself."""
    random = np.random.default_rng(seed)
    return {key: value * (1 + part * random.uniform(-1, 1, count)) for key, value in model(name).variant.values.items()}


def alone(name, data, index, **options):
    variant = model(name).variant
    times = {"step": variant.time.step, "end": variant.time.end, "scheme": "euler", **options}
    given = {key: float(column if np.ndim(column) == 0 else column[index]) for key, column in data.items()}
    start = {key: given.pop(key) for key in model(name).coordinates if key in given}
    return coursework.solve(variant.with_data(given, start), quantities=["table"], **times)


def same(name, data, **options):
    """Raise where sets together are not the sets alone; return the solutions."""
    time = model(name).variant.time
    solved = coursework.solve_many(model(name), data, **{"step": time.step, "end": time.end, "scheme": "euler", **options})
    for index, stop in enumerate(solved.stops):
        motion = alone(name, data, index, **options).motion
        scale = 1.0 + np.max(np.abs(motion.rows), initial=0.0)
        rows = solved.values[index]
        assert np.max(np.abs(rows[: len(motion.t)] - motion.rows), initial=0.0) < 1e-12 * scale
        assert np.isnan(rows[len(motion.t) :]).all()
        assert stop == motion.stop
    return solved


# Two of the files allow no other data: the table of one law ends where the motion does; a contact stands as a point of its own.
NARROW = {"variable-crank-table": 0.0, "v108": 0.0}


@pytest.mark.long
@pytest.mark.parametrize("name", sampled(names()))
def test_every_variant_of_the_catalogue(name):
    same(name, spread(name, NARROW.get(name, 0.01), 2))


@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_scheme(scheme):
    same("31", spread("31", 0.02, 2), scheme=scheme)


def test_dead_points_of_any_data():
    data = spread("31", 0.3, 24) | {"alpha": np.linspace(0, 2 * np.pi, 24)}
    solved = same("31", data)
    kinds = {stop.kind if stop else None for stop in solved.stops}
    assert {None, "dead point"} <= kinds
    assert sum(stop is None for stop in solved.stops) > 4


def test_only_where_lengths_stay_lengths_is_a_set_sure_to_move():
    found = prepare(model("31"), model("31").data({"r1": [0.953, -0.953, 0.94]}), model("31").variant.time.end)
    assert found.sure.tolist() == [True, False, True]


@pytest.mark.parametrize("edge", [1.5929, 4.6903])
def test_beside_the_edge_of_what_is_possible(edge):
    """The feasible phases of variant 31, to the digits its page gives, and closer than any step could see."""
    alpha = edge + np.array([-1e-2, -1e-4, -1e-5, 0.0, 1e-5, 1e-4, 1e-2])
    same("31", {"alpha": alpha})


def test_a_set_is_sure_only_if_it_can_move():
    data = spread("stephenson", 0.15, 40, seed=2)
    sets = prepare(model("stephenson"), model("stephenson").data(data), model("stephenson").variant.time.end)
    possible, reasons = coursework.feasible_many(model("stephenson"), data)
    assert 5 < possible.sum() < 35
    for index in range(40):
        try:
            given = {key: float(column[index]) for key, column in data.items()}
            truth = coursework.feasible(model("stephenson").variant.with_data(given))
        except coursework.InputError as error:
            truth = False, str(error)
        assert (possible[index], reasons[index]) == truth
        assert truth[0] or not sets.sure[index]


@pytest.mark.parametrize("step", [0.01, 0.06, 0.12])
def test_what_the_step_does_is_told_as_alone(step):
    same("31", spread("31", 0.02, 3), step=step)


def test_start_coordinates_are_columns_too():
    same("31", {"phi1": [1.6, 1.63, 1.7], "phi3": [2.8, 2.87, 2.9], "p": 12.0})


def test_the_end_and_the_step_are_those_asked_for():
    solved = coursework.solve_many("31", {"p": [13.08]}, step=0.01, end=0.2)
    assert solved.t.tolist() == (np.arange(21) * 0.01).tolist()
    assert solved.values.shape == (1, 21, 7)


def test_a_frame_in_and_tables_out():
    solved = coursework.solve_many(model("31"), pd.DataFrame({"alpha": [4.35, 0.02]}))
    table = solved.table(0)
    pd.testing.assert_frame_equal(table, coursework.solve("31", quantities=["table"]).table, rtol=1e-12)
    assert solved.columns == tuple(table.columns)
    stopped = solved.table(1)
    assert len(stopped) == 6 and solved.stops[1].time == pytest.approx(0.116889254610302411, abs=1e-8)
    with pytest.raises(ValueError, match="read-only"):
        solved.values[0, 0, 0] = 1.0


def test_no_sets_are_no_rows():
    solved = coursework.solve_many(model("31"), {"p": []})
    assert solved.values.shape == (0, 25, 7) and solved.stops == ()


@pytest.mark.parametrize(("width", "is_sure"), [(1e-4, False), (0.2, True)])
def test_a_set_whose_drive_has_a_pulse_that_no_step_shows_is_in_doubt(width, is_sure):
    law = Law(
        "pulse", "b + a*exp(-((t - tm)/T)^2)", {"a": "1 rad/s", "b": "1 rad/s", "tm": "0.05 s", "T": f"{width} s"}, math.sin
    )
    found = coursework.compile_model(coursework.parse_variant(four_bar(law, end=0.3)))
    assert prepare(found, found.data({"b": [1.0, 1.1]}), 0.3).sure.tolist() == [is_sure] * 2


PIECES = mechanism("drive-in-pieces")


@pytest.mark.parametrize(("fast", "is_seen"), [(20, True), (20_000, False)])
def test_a_stretch_is_looked_at_in_each_piece_of_its_law(fast, is_seen):
    found = coursework.compile_model(coursework.parse_variant(PIECES.replace("cos(20*t)", f"cos({fast}*t)"), "pieces"))
    values = {name: np.array([value]) for name, value in found.variant.values.items()}
    assert resolved(found.equations, values, np.array([0.0, 0.12])).all() == is_seen


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e7])
def test_what_a_drive_along_a_line_does_unseen_is_a_share_of_the_size(size):
    """A slider swings there and back by a sixth of its rod, between a few times or many."""
    lengths = {name: f"{part * size!r} m" for name, part in (("r", 0.1), ("l", 0.3), ("a", 0.05))}
    text = mechanism("driven-slider", ("0.25 m", f"{0.25 * size!r} m"), **lengths)
    equations = coursework.compile_model(coursework.parse_variant(text)).equations
    data = {name: np.array([value]) for name, value in equations.variant.values.items()}
    seen = [resolved(equations, data, np.linspace(0, 1.2, parts + 1), 2, 1e-4).item() for parts in (13, 14)]
    assert seen == [False, True]


@pytest.mark.parametrize("data", [{"V": [1.0, 1.5, 30.0]}, {"late": [0.05, 0.033, 0.06]}])
@pytest.mark.parametrize("scheme", ["euler", "rk4"])
def test_a_drive_in_pieces(data, scheme):
    variant = coursework.parse_variant(PIECES, "pieces")
    MODELS["pieces"] = coursework.compile_model(variant)
    same("pieces", data, scheme=scheme)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: coursework.solve_many("31", {"r1": [0.9, 0.0]}), "set 2: "),
        (lambda: coursework.solve_many("31", {"p": [13.0, 400.0]}), "set 2: The step 0.02 s is too large for this drive"),
        (lambda: coursework.solve_many("example-6", {"w0": [9.0, 10.0]}), "the step of example-6 depends on w0"),
        (lambda: coursework.solve_many("example-6", {"w0": [9.0]}, step=0.01), "the end of example-6 depends on w0"),
        (lambda: coursework.solve_many("31", {"p": [1.0]}, scheme="eular"), 'there is no scheme "eular"'),
        (lambda: coursework.solve_many("31", {"p": [1.0]}, step=-1.0), "the step must be a finite time greater than 0"),
        (lambda: coursework.solve_many("31", {"p": ["1 m"]}), "p, set 1: an angular velocity was expected"),
    ],
)  # fmt: skip
def test_what_cannot_be_solved_is_said(call, sentence):
    with pytest.raises(coursework.InputError) as caught:
        call()
    assert sentence in str(caught.value)


def test_why_a_set_cannot_move():
    possible, reasons = coursework.feasible_many("31", {"alpha": [4.35, 0.02, 4.35], "r1": [0.953, 0.953, 0.0]})
    assert possible.tolist() == [True, False, False]
    assert reasons[0] == "" and "0.116889" in reasons[1] and "zero length" in reasons[2]
    assert coursework.feasible("31") == (True, "")
    assert coursework.feasible("example-1")[0]


def test_equations_that_fit_their_own_data_alone_are_told_as_alone():
    """A factor of 1 in one equation: right for the file, against the geometry for any other number."""
    text = find("31").read_text(encoding="utf-8").replace('"r3*w3*sin(phi3) -', '"k*r3*w3*sin(phi3) -')
    variant = coursework.parse_variant(text.replace("[given]", "[given]\nk = 1"), "31")
    assert coursework.solve_many(variant, {"p": [13.0]}).stops == (None,)
    with pytest.raises(coursework.InputError, match=r"set 2: .*contradicts the geometry"):
        coursework.solve_many(variant, {"k": [1.0, 1.001]})
    possible, reasons = coursework.feasible_many(variant, {"k": [1.0, 1.001]})
    assert possible.tolist() == [True, False]
    assert "contradicts the geometry" in reasons[1]


def test_the_whole_motion_lasts_through_a_period_that_is_longer_than_the_table():
    """The table ends before the dead point of 0.116889 s: without a period nothing beyond it is asked, with one it is."""
    short = find("31").read_text(encoding="utf-8").replace("0.48", "0.1", 1)
    bare = "\n".join(line for line in short.splitlines() if not line.startswith("period"))
    data = {"alpha": [4.35, 0.02]}
    for text, seen in ((short, False), (bare, True)):
        variant = coursework.parse_variant(text, "31")
        possible, reasons = coursework.feasible_many(variant, data)
        assert possible.tolist() == [True, seen]
        assert (possible[1], reasons[1]) == coursework.feasible(variant.with_data(given={"alpha": 0.02}))
        assert seen or "0.116889" in reasons[1]


@pytest.mark.parametrize(("end", "steps"), [(0.5, 12), (10.0, 200), (1000.0, 4000)])
def test_in_a_step_of_the_first_look_no_drive_turns_further_than_half_a_radian(end, steps):
    """The crank of Example 1 turns at 10 rad/s; there are 12 steps at least and 4000 at most."""
    example = model("example-1")
    data = example.data({})
    numbers = example.numbers(data)
    start = start_of(example, data, numbers).closed
    assert fewest_steps(example, numbers, np.zeros(1), start, end) == steps


def test_each_set_is_followed_for_its_own_time():
    """With w0 the table of the homework lasts 2 π / w0: the dead point of a crank that cannot go round moves with it."""
    possible, reasons = coursework.feasible_many("homework", {"w0": [10.0, 2.0, 0.0], "r1": [0.4, 0.9, 0.4]})
    assert possible.tolist() == [True, False, False]
    variant = coursework.load("homework").with_data(given={"w0": 2.0, "r1": 0.9})
    assert (False, reasons[1]) == coursework.feasible(variant)


@pytest.mark.parametrize("mode", ["+1", "-1"])
def test_without_a_mode_a_dyad_closes_next_to_its_start_in_every_set(mode):
    """A start that is written says which of the two ways is meant, here two turns on."""
    text = find("example-1").read_text(encoding="utf-8").split("[ask]")[0] + '[ask]\nquantities = ["table"]\n'
    in_mode = coursework.parse_variant(text.replace('mode        = "+1"', f'mode        = "{mode}"'))
    data = {"w0": np.array([9.0, 10.0, 11.0])}
    wanted = coursework.solve_many(in_mode, data, scheme="exact", step=0.02, end=0.5).values
    second, third = (float(value) for value in wanted[0, 0, 1:3])
    for name, value in (("theta2", second), ("theta3", third - 4 * np.pi)):
        rate = name.replace("theta", "w")
        text = text.replace(
            f'{name} = {{ rate = "{rate}", unit = "rad" }}', f'{name} = {{ start = "{value!r} rad", rate = "{rate}" }}'
        )
    free = coursework.parse_variant(text.replace('mode        = "+1"', ""))
    found = coursework.solve_many(free, data, scheme="exact", step=0.02, end=0.5).values
    turned = np.isin(np.arange(found.shape[2]), [2]) * 4 * np.pi  # theta3
    assert np.max(np.abs(found + turned - wanted)) < 1e-9


def test_a_table_is_asked_for_by_the_number_of_its_set():
    many = coursework.solve_many("homework", {"r1": [0.4, 0.41]}, step=0.05)
    assert many[np.int64(-1)].equals(many[1])
    with pytest.raises(TypeError, match="slice"):
        _ = many[0:1]


@pytest.mark.long
def test_sets_that_forces_move_are_solved_one_by_one():
    """They had the velocities of a law of nobody's."""
    lengths = ["1.1 m", "1.2 m"]
    many = coursework.solve_many("example-2-motor", {"r2": lengths}, end=0.1)
    for table, length in zip(many, lengths, strict=True):
        alone = coursework.solve(coursework.load("example-2-motor").with_data({"r2": length}), end=0.1).table
        assert np.array_equal(table.to_numpy(), alone.to_numpy())
    possible, (none, why) = coursework.feasible_many("example-2-motor", {"r2": ["1.2 m", "0.35 m"]})
    assert possible.tolist() == [True, False] and not none and "At t = 0." in why


@pytest.mark.parametrize("scheme", ["semi-implicit", "euler"])
def test_sets_that_forces_move_may_be_solved_by_the_schemes_of_such_motion(scheme):
    pendulum = coursework.parse_variant(mechanism("pendulum"))
    (_, table) = coursework.solve_many(pendulum, {"k": [150.0, 200.0]}, scheme, end=0.1)
    assert np.array_equal(table.to_numpy(), coursework.solve(pendulum, scheme, end=0.1).table.to_numpy())
