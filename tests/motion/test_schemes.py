"""Every scheme of `SCHEMES`: its order, its loop, its time; and laws of motion that no scheme may break."""

from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.motion.integration.exact_motion import refine
from coursework.motion.integration.loops import generate_loop
from coursework.motion.schemes import SCHEMES
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import changed, mechanism
from tests.solved import solved

PAGE = (Path(__file__).parents[1] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
WRITTEN = PAGE[: PAGE.index("# --- geometry")]
GEOMETRY = PAGE[: PAGE.index("[[constraint]]")].replace('w4 = "1/s"', "") + PAGE[PAGE.index("[points]") : PAGE.index("[links]")]
GEOMETRY += PAGE[PAGE.index("[closure]") : PAGE.index("[ask]")]
CHAIN = mechanism(
    "four-bar", ('"(d, 0)"', '"d @ g"'), ("[drive]", 'g = "0 rad"\n[drive]'), ('"0 deg"', '"0.3 rad"'), r1="0.4 m", r2="1 m",
    r3="0.7 m", d="1.2 m", n=None, w1="10", step="0.01 s", end="0.6 s", period=None,
)  # fmt: skip


def rows(text, scheme="euler", pairs=(), **options):
    """Return the coordinates and velocities of a run of a text with some pieces exchanged."""
    motion = coursework.solve(parse_variant(changed(text, *pairs)), scheme, quantities=["table"], **options).motion
    assert motion.stop is None
    return motion.coordinates, motion.velocities


@pytest.mark.parametrize("scheme", SCHEMES)
def test_observed_order(scheme):
    """By the largest error over the whole grid: at the end of a period alone Heun would look like order 3 (numerics.md 1.4)."""
    errors = []
    for halvings in (3, 4, 5):
        run = coursework.solve("31", scheme, step=0.02 / 2**halvings, quantities=["table"])
        errors.append(np.max(np.abs(run.motion.coordinates - run.exact.coordinates)))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx(SCHEMES[scheme].order, abs=0.1)


def test_the_orders_are_those_of_the_lecture():
    found = {name: scheme.order for name, scheme in SCHEMES.items()}
    assert found == {"euler": 1, "midpoint": 2, "heun": 2, "ralston": 2, "rk4": 4}


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ["31", "v108", "example-1", "jansen"])
def test_the_generated_loop_is_the_march_bit_for_bit(scheme, name):
    run = solved(name, scheme=scheme, quantities=["table"])
    loop = generate_loop(SCHEMES[scheme], run.scene.rates)
    for last in (0, 1, 2, len(run.motion.t) - 1):
        assert loop(0.0, last, run.step, *run.scene.start) == tuple(run.motion.coordinates[last])


@pytest.mark.parametrize("scheme", SCHEMES)
def test_slopes_are_counted(scheme):
    assert coursework.solve("31", scheme, quantities=["table"]).motion.evaluations == 24 * SCHEMES[scheme].slopes


@pytest.mark.parametrize(
    ("step", "end", "count"), [(0.02, 0.48, 25), (0.01, 0.48, 49), (0.001, 0.48, 481), (0.07, 0.48, 7), (0.02, 0.1, 6)]
)
def test_time_is_a_multiple_of_the_step_and_no_running_sum(step, end, count):
    motion = coursework.solve("31", step=step, end=end, quantities=["table"]).motion
    assert motion.t.tolist() == [i * step for i in range(count)]


@pytest.mark.long
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("text", [WRITTEN, GEOMETRY], ids=["written", "geometry"])
def test_a_mechanism_twice_as_large_and_fast_has_the_same_angles(scheme, text):
    """Powers of two lose no digit, so even the last bit is the same."""
    pairs = [("0.953 m", "1.906 m"), ("0.847 m", "1.694 m"), ("0.457 m", "0.914 m"), ("4.5 m/s", "9 m/s")]
    for plain, scaled in zip(rows(text, scheme), rows(text, scheme, pairs), strict=True):
        assert np.array_equal(plain, scaled)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_motion_four_times_as_fast_takes_a_quarter_of_the_time(scheme):
    pairs = [("4.5 m/s", "18 m/s"), ("13.08 1/s", "52.32 1/s"), ("0.02 s", "0.005 s"), ("0.48 s", "0.12 s")]
    (angles, rates), (again, faster) = rows(WRITTEN, scheme), rows(WRITTEN, scheme, pairs)
    assert np.array_equal(again, angles)
    assert np.array_equal(faster, 4 * rates)


@pytest.mark.parametrize("unit", ["mm", "cm"])
def test_units_change_nothing(unit):
    factor = {"mm": 1000, "cm": 100}[unit]
    pairs = [(f"{x} m", f"{x * factor:g} {unit}") for x in (0.953, 0.847, 0.457)] + [("4.5 m/s", f"{4.5 * factor:g} {unit}/s")]
    for plain, other in zip(rows(WRITTEN), rows(WRITTEN, pairs=pairs), strict=True):
        assert np.array_equal(plain, other)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_the_image_in_a_mirror_moves_as_the_image(scheme):
    """About the x axis: angles, rates and the drive change their sign, the right angle of link 3 its side."""
    pairs = [('"1.63 rad"', '"-1.63 rad"'), ('"3.37 rad"', '"-3.37 rad"'), ('"2.87 rad"', '"-2.87 rad"')]
    pairs += [('"V1*sin', '"-V1*sin'), ("phi3 + pi/2", "phi3 - pi/2")]
    for plain, image in zip(rows(GEOMETRY, scheme), rows(GEOMETRY, scheme, pairs), strict=True):
        assert image == pytest.approx(-plain, rel=1e-12, abs=1e-12)


def test_a_chain_in_the_mirror_has_the_other_assembly_mode():
    pairs = [('"0.3 rad"', '"-0.3 rad"'), ('w1 = "10"', 'w1 = "-10"'), ('"+1"', '"-1"')]
    for plain, image in zip(rows(CHAIN), rows(CHAIN, pairs=pairs), strict=True):
        assert image == pytest.approx(-plain, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("angle", [0.7, -2.0])
def test_a_mechanism_turned_as_a_whole_moves_as_before(angle):
    angles, rates = rows(CHAIN, "rk4")
    turned, same = rows(CHAIN, "rk4", [('g = "0 rad"', f'g = "{angle} rad"'), ('"0.3 rad"', f'"{0.3 + angle} rad"')])
    difference = turned - angles - angle
    assert np.max(np.abs(difference - 2 * np.pi * np.round(difference[0] / (2 * np.pi)))) < 1e-12
    assert same == pytest.approx(rates, rel=1e-12, abs=1e-11)


@pytest.mark.parametrize("text", [WRITTEN, GEOMETRY], ids=["refined", "closure"])
def test_the_exact_motion_runs_backwards_as_it_ran_forwards(text):
    """From the last row, with the drive run backwards: V(T - t) with the other sign."""
    forwards = coursework.solve(parse_variant(text), quantities=["table"]).exact
    last = dict(zip(forwards.coordinate_names, forwards.coordinates[-1].tolist(), strict=True))
    for name, start in (("phi1", "1.63 rad"), ("phi2", "3.37 rad"), ("phi3", "2.87 rad")):
        text = text.replace(f'"{start}"', f'"{last[name]!r} rad"')
    text = text.replace("V1*sin(p*t + alpha)", "-V1*sin(p*(0.48 - t) + alpha)")
    backwards = coursework.solve(parse_variant(text), quantities=["table"]).exact
    assert np.max(np.abs(backwards.coordinates[::-1] - forwards.coordinates)) < 2e-10
    assert np.max(np.abs(backwards.velocities[::-1] + forwards.velocities)) < 1e-8


@pytest.mark.parametrize(("count", "each"), [(100, 3 * 8), (2001, 3 * 2)])
def test_a_long_table_takes_fewer_steps_between_its_rows(count, each):
    """So many and twice as many, which have to agree."""
    scene = solved("31").scene
    assert refine(scene.rates, scene.start, np.linspace(0, 0.48, count))[2] == each * (count - 1)


def test_two_steps_of_half_the_length_are_not_one():
    """A check that the laws above can fail at all."""
    assert not np.array_equal(rows(WRITTEN)[0], rows(WRITTEN, step=0.01)[0][::2])


def test_equations_with_the_same_name_are_told_apart():
    text = WRITTEN.replace('name     = "12"', 'name     = "11"')
    run = coursework.solve(parse_variant(text), quantities=["table", "accelerations"])
    assert run.reduction.used == ("11", "11'", "16", "18")
    assert np.all(np.isfinite(run.columns()[1]))
