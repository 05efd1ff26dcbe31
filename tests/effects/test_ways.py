"""Newton and Euler, virtual power and the groups find the same; what balances must; what is not unique stays empty."""

import json
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.drawing.force_plans.lever import levers_of
from coursework.effects.dynamics import dynamics_checks
from coursework.effects.effects import _springs
from coursework.effects.kinetostatics.checks import check_forces
from coursework.effects.rows import PLACE, Rows
from coursework.motion.settings import Settings
from coursework.scene.exact_scene import scene_of
from coursework.variant.catalogue import names
from tests.effects.massed import analysis, massed, of, of_text
from tests.mechanisms.library import mechanism
from tests.solved import solved

REFERENCE = Path(__file__).parents[1] / "reference" / "forces"
# A crank of changing length is no rigid body, so it has no centre of mass: told as such.
OTHERS = [name for name in names() if not name.endswith("-forces") and not name.startswith("variable-crank")]
PARALLEL = mechanism("parallel-cranks")


UNNAMED = mechanism("slider-crank-without-rod-angle")


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=[] if n in {"31", "jansen", "v107", "cardan"} else pytest.mark.long) for n in OTHERS]
)
def test_every_mechanism_with_invented_masses(name):
    found = analysis(scene_of(massed(coursework.load(name)), Settings(scheme="euler")), exact=True)
    checks = {one.code: one for one in check_forces(found, found)}
    assert {one.verdict for one in checks.values()} <= {"PASS", "SKIP", "COARSE"}
    assert checks["VIRTUAL-POWER"].verdict == checks["REACTIONS-SUM"].verdict == "PASS"
    assert checks["VIRTUAL-POWER"].value < 1e-13
    assert checks["GROUPS"].verdict == "PASS" or name in {"cardan", "epicyclic"}  # an arm that is no link drives them


@pytest.mark.parametrize("name", ["31-forces", "andrews-forces", "whitworth-forces"])
def test_a_wrong_force_is_seen_by_each_way(name):
    found = of(name)
    spoilt = found.reactions.rows.copy()
    spoilt[3, -1] += 1e-6 * found.reactions.largest
    checks = {one.code: one for one in check_forces(replace_rows(found, spoilt), None)}
    for code in ("VIRTUAL-POWER", "GROUPS", "REACTIONS-SUM"):
        assert (checks[code].verdict, checks[code].row) == ("FAIL", 4), code
    assert {one.verdict for one in check_forces(found, found)} <= {"PASS", "SKIP", "COARSE"}
    assert "FRICTION" not in {one.code for one in check_forces(found, found)}  # nothing rubs


def replace_rows(found, rows):
    return replace(found, reactions=replace(found.reactions, rows=rows))


def test_power_is_the_change_of_the_energy_where_rows_are_close_enough():
    close = of_text(mechanism("example-2-forces", ("2*pi/(36*w0)", "2*pi/(180*w0)")))
    verdicts = {one.code: one.verdict for one in check_forces(close, close)}
    assert verdicts["POWER"] == "PASS"
    assert {one.code: one.verdict for one in check_forces(of("example-1-forces"), None)}["POWER"] == "COARSE"


@pytest.mark.parametrize("parts", [1, 4])
def test_power_is_not_read_off_rows_across_a_break_of_the_drive(parts):
    """The run-up ends in row 41 and the acceleration of the crank with it: no step makes that a slope of the energy."""
    engine = massed(coursework.load("engine-start"))
    finer = replace(engine, time=replace(engine.time, step=0.01 / parts))
    found = analysis(scene_of(finer, Settings(scheme="euler")), exact=True)
    power = next(one for one in check_forces(found, found) if one.code == "POWER")
    assert abs(power.row - 1 - 40 * parts) >= 2 and (power.verdict == "PASS") == (parts == 4)


def test_a_redundant_support_gives_what_is_unique_and_nothing_else():
    wanted = json.loads((REFERENCE / "hard_forces.json").read_text(encoding="utf-8"))["redundant crank"]
    found = of_text(PARALLEL)
    assert found.reactions.matrix.shape[1:] == (wanted["equations"], wanted["unknown"])
    assert np.isnan(found.reactions.rows[:, :-1]).all()
    # The cranks of the reference lie along x; here at 60 degrees, where half of the weight is across them.
    unique = {
        key: value for key, (is_unique, value) in wanted["unique, value (least norm where not unique)"].items() if is_unique
    }
    assert set(unique) == {"M", *(f"{pair} across" for pair in ("R01", "R14", "R02", "R24", "R03", "R34"))}
    assert found.column("M")[0] == pytest.approx(unique["M"] / 2, rel=1e-12)
    assert found.by_power[0, 0] == pytest.approx(unique["M"] / 2, rel=1e-12)
    for key, value in unique.items():
        if key != "M":
            pair = key.partition(" ")[0]
            assert found.beside[f"{pair}.across"][0] == pytest.approx(value / 2, rel=1e-9), pair
            assert found.beside[f"{pair}.angle"][0] == pytest.approx(np.deg2rad(150), abs=1e-9)
    checks = {one.code: one for one in check_forces(found, found)}
    assert checks["POWER"].verdict == "PASS"  # the drive is unique, and it alone gives power
    told = checks["FORCE-CONDITION"]
    assert told.verdict == "SKIP" and "13 unknown forces and 12 equations" in str(told.sentence)


def test_forces_grow_with_the_square_towards_a_dead_point():
    text = mechanism("31-forces", ('"4.35 rad"', '"0.02 rad"'), ('step      = "0.02 s"', 'step      = "0.0005 s"'))
    run = coursework.solve(coursework.parse_variant(text.replace('scheme    = "exact"', "")), scheme="exact")
    stop, found = run.stop.time, analysis(run.scene)
    left = stop - found.rows.motion.t
    grown = found.column("FMy") * left**2
    assert 3.95 < grown[-1] < 4.09  # which it reaches in the limit
    assert (np.diff(grown[-25:]) > 0).all()
    assert len(found.rows.motion.t) == len(run.motion.t) < 250
    assert np.isfinite(found.reactions.rows).all()


def test_a_rod_whose_rate_has_no_name_turns_as_its_ends_do():
    found = of_text(UNNAMED, scheme="rk4")
    crank = found.rows.motion.column("theta1")
    sine = -0.4 / 1.2 * np.sin(crank)  # of the angle of the rod
    cosine = np.sqrt(1 - sine**2)
    omega = -0.4 * np.cos(crank) * 10 / (1.2 * cosine)
    rate, second = found.rows.turns["2"]
    assert np.abs(rate - omega).max() < 1e-6
    assert np.abs(second - (0.4 * 10**2 * np.sin(crank) + 1.2 * omega**2 * sine) / (1.2 * cosine)).max() < 1e-4
    # With the crank along the guide B has 4 m/s and C none: both centres 2 m/s upwards, the rod 4/1.2 rad/s; nothing slows down.
    spun = 0.0533 * 10**2 / 2 + 12 * 1.2**2 / 12 * (4 / 1.2) ** 2 / 2
    assert found.energy.kinetic[0] == pytest.approx((4 + 12) * 2**2 / 2 + spun)
    assert found.column("M")[0] == pytest.approx((4 + 12) * 9.81 * 2 / 10)
    assert found.by_power is None  # a motion of the drive alone does not say how the rod turns
    assert {one.code: one.verdict for one in check_forces(found, None)}["VIRTUAL-POWER"] == "SKIP"


def test_a_rod_whose_rate_has_no_name_has_its_power_and_its_place_on_the_lever():
    held = '[closure]\nholds = ["(s3 - r1*cos(theta1))^2 + (r1*sin(theta1))^2 - r2^2"]\n'
    found = of_text(UNNAMED + held)
    assert found.by_power[:, 0] == pytest.approx(found.column("M"), abs=1e-12 * found.reactions.largest)
    (lever,) = levers_of(found, 5)
    assert lever.read == pytest.approx(lever.computed, rel=0.01)  # arms are read to half a millimetre


def test_the_drive_of_a_forearm_stands_on_the_upper_arm():
    """Rods of 3 and 2 kg, 0.5 and 0.4 m: Lagrange's equations of the angles, the second moment between the two links."""
    motor = mechanism("falling-arm").partition("[motor]")[2].partition("[ask]")[0]
    driven = '[drive]\nw1 = "2 rad/s"\nw2 = "3*sin(5*t)"\n\n[time]'
    text = mechanism("falling-arm", (f"[motor]{motor}", ""), ("[time]", driven), ('"dynamics", ', ""), ('"2 s"', '"0.2 s"'))
    found = of_text(text, scheme="rk4")
    first, second, w1, w2 = (found.rows.motion.column(name) for name in ("phi1", "phi2", "w1", "w2"))
    epsilon, apart, inertia, g = 15 * np.cos(5 * found.rows.motion.t), first - second, 2 * 0.5 * 0.4 / 2, 9.81
    forearm = 2 * 0.4**2 / 3 * epsilon - inertia * w1**2 * np.sin(apart) + 2 * g * 0.2 * np.cos(second)
    upper = inertia * (epsilon * np.cos(apart) + w2**2 * np.sin(apart)) + (3 / 2 + 2) * g * 0.5 * np.cos(first)
    assert found.column("M2") == pytest.approx(forearm, abs=1e-12)
    assert found.column("M1") == pytest.approx(upper + forearm, abs=1e-12)  # from the frame it turns both
    assert found.by_power == pytest.approx(np.column_stack([upper + forearm, forearm]), abs=1e-12)
    assert found.energy.drive == pytest.approx(found.column("M1") * w1 + found.column("M2") * (w2 - w1))


def test_no_mass_and_no_load_is_statics_of_nothing():
    text = mechanism("example-1-forces", ("F1 = {", "F9 = {"))
    still = text.replace('"4 kg"', '"0 kg"').replace('"10 kg"', '"0 kg"').replace('"7 kg"', '"0 kg"')
    light = of_text(
        still.replace('inertia = "0.0533 kg*m^2"', 'inertia = "point"')
        .replace('"0.833 kg*m^2"', '"point"')
        .replace('"0.286 kg*m^2"', '"point"')
    )
    heavy = of("example-1-forces")
    assert np.isfinite(light.reactions.rows).all()
    # A link without mass is a two-force member: its two reactions are equal.
    assert np.abs(light.column("R12x") - light.column("R23x")).max() < 1e-10
    assert np.abs(light.column("R12x") - heavy.column("R12x")).max() > 1


def test_rows_of_a_scheme_whose_links_have_drifted_apart_are_analysed_and_judged_by_the_exact_ones():
    run = coursework.solve("example-1-forces", scheme="euler")
    found = {one.code: one.verdict for one in run.results.force_checks}
    assert found["VIRTUAL-POWER"] == "PASS"
    assert found["FORCE-ACCURACY"] == "COARSE"


def test_links_are_judged_by_a_motion_in_which_something_moves():
    """A motion from rest shows in its later rows how links move; a scheme by its first, as others may only drift."""
    scene = solved("falling-arm").scene
    exact = scene.exact
    assert not exact.velocities[0].any() and exact.velocities.any()  # it falls from rest
    assert scene.stirred(exact) is exact
    drifted, sets_off = (replace(exact, scheme="euler", velocities=exact.velocities + begin) for begin in (0.0, 1.0))
    assert scene.stirred(sets_off) is sets_off
    for rests in (drifted, replace(exact, velocities=0 * exact.velocities)):
        assert scene.stirred(rests).velocities == pytest.approx(np.eye(2))  # each of the two free rates by itself


def test_the_inertia_reduced_to_the_crank_and_its_slope_give_the_moment_that_the_links_need():
    """M = J eps + J'/2 omega^2 - M of loads and weight, by five points of J over equal angles too."""
    found = of("example-2-forces")
    j, slope, t = found.beside["J"], found.beside["dJ"], found.rows.motion.t
    omega = found.rows.motion.column("w1")
    assert np.allclose(j * omega**2 / 2, found.energy.kinetic, rtol=1e-12)
    h = omega[0] * (t[1] - t[0])
    by_points = (j[:-4] - 8 * j[1:-3] + 8 * j[3:-1] - j[4:]) / (12 * h)
    assert np.abs(by_points - slope[2:-2]).max() < 2e-2 * np.abs(slope).max()
    change = np.gradient(found.energy.potential, t, edge_order=2)
    power = slope / 2 * omega**3 - found.energy.loads + change
    assert np.abs(power - found.energy.drive)[2:-2].max() < 2e-2 * np.abs(found.energy.drive).max()
    assert found.names[-2:] == ("J", "dJ")
    assert "J" not in of("31-forces").beside


def test_a_spring_pulls_with_its_stretch_and_the_rate_of_it_whatever_its_length():
    """From (0, 0) to (3, 4) m: 5 m long, stretched by 1 m at 2 m/s, it pulls with 10 * 1 + 3 * 2 N along (0.6, 0.8)."""
    spring = SimpleNamespace(ends=("A", "B"), stiffness=10.0, free=4.0, damping=3.0, name="s")
    at = {"A": (0j, 0j), "B": (3 + 4j, 1.2 + 1.6j)}
    rows = SimpleNamespace(
        scheme=SimpleNamespace(forces=SimpleNamespace(springs=[spring]), holder={"A": "1", "B": "2"}.get),
        scalar=np.float64, vector=lambda formula, level=PLACE: np.array([at[formula.name][level]]),
    )  # fmt: skip
    rows.stretch = partial(Rows.stretch, rows)
    found = {action.body: action.force[0] for action in _springs(rows)}
    assert found == {"1": pytest.approx(16 * (0.6 + 0.8j)), "2": pytest.approx(-16 * (0.6 + 0.8j))}


def test_a_spring_from_a_fixed_hinge_pulls_at_the_frame_and_not_at_the_link_that_turns_there():
    """So the reactions at both ends of the crank differ by what the crank itself weighs, with the spring or without."""
    load = 'gravity = "9.81 m/s^2"'
    plain = mechanism("example-1-forces")
    sprung = mechanism("example-1-forces", (load, f'{load}\nk = {{ spring = ["A", "C"], stiffness = "1 kN/m", free = "0.9 m" }}'))
    found, bare = of_text(sprung), of_text(plain)
    for axis in "xy":
        pairs = [(one.column(f"R01{axis}"), one.column(f"R12{axis}")) for one in (found, bare)]
        (first, second), (third, fourth) = pairs
        assert np.abs(first - third).max() > 50
        assert np.allclose(first - second, third - fourth, atol=1e-9)


@pytest.mark.parametrize(("count", "rows"), [(1, [0]), (39, [*range(39)]), (200, [*range(0, 200, 5)])])
def test_how_fast_deviations_die_out_and_swing_is_looked_at_in_forty_rows_from_the_first_on(count, rows, monkeypatch):
    looked = []
    t = np.arange(float(count))
    motion = SimpleNamespace(t=t, coordinates=t[:, None], column=lambda name: t, stop=None)
    monkeypatch.setattr(
        dynamics_checks, "_slopes", lambda *given: looked.append(int(given[1])) or (np.array([[-3.0]]), np.array([[-4.0]]))
    )
    variant = SimpleNamespace(forces=SimpleNamespace(motor=SimpleNamespace(rates=("w",))))
    exact = SimpleNamespace(rows=SimpleNamespace(motion=motion), equations=SimpleNamespace(variant=variant))
    stands = SimpleNamespace(exact=exact, dynamics=SimpleNamespace(rubbing=None))
    assert (dynamics_checks.stiffness(stands), looked) == ((3.0, 2.0), rows)
