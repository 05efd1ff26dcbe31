"""A template compiled once gives, for its own data and for others, what a scene of those data gives."""

from dataclasses import replace

import numpy as np
import pytest

import coursework
from coursework.equations.algebra.functions import call
from coursework.equations.reduction.symbolic import symbol
from coursework.variant.catalogue import names
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import mechanism
from tests.solved import solved

RUNS = {}


def scene(name):
    """Return the model and the rows of a catalogue variant."""
    if name not in RUNS:
        RUNS[name] = coursework.compile_model(name), solved(name, quantities=["table"]).motion
    return RUNS[name]


BY_FORCES = {"example-2-motor", "falling-arm"}  # whose velocities do not follow from time and positions


def scaled(variant, factor):
    """Return a variant with every given datum multiplied."""
    return replace(variant, given=tuple(replace(given, value=given.value * factor) for given in variant.given))


@pytest.mark.parametrize("name", [name for name in names() if name not in BY_FORCES])
def test_velocities_and_determinants_are_those_of_the_run(name):
    model, motion = scene(name)
    scale = 1.0 + np.max(np.abs(motion.velocities))
    assert np.max(np.abs(model.rates(motion.t, motion.coordinates) - motion.velocities)) < 1e-12 * scale
    assert np.allclose(model.determinants(motion.t, motion.coordinates), motion.determinants, rtol=1e-12, atol=1e-13)


def test_a_free_rate_is_one_and_the_others_go_with_it():
    """r1 e(theta1) + r2 e(theta2) = (s3, 0) gives the other rates per unit of w1; in the rows they are w1 times these."""
    model, motion = scene("example-2-motor")
    one, two = motion.coordinates[:, 0], motion.coordinates[:, 1]
    second = -0.4 * np.cos(one) / (1.2 * np.cos(two))
    analogs = np.column_stack([np.ones(len(one)), second, -0.4 * np.sin(one) - 1.2 * np.sin(two) * second])
    found = model.rates(motion.t, motion.coordinates)
    assert np.allclose(found, analogs, rtol=1e-12, atol=1e-13)
    assert np.allclose(found * motion.velocities[:, :1], motion.velocities, rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("name", ["31", "stephenson", "example-6", "variable-crank-table", "v110"])
def test_other_data_are_those_of_another_scene(name):
    model, motion = scene(name)
    own = {given.name: given.value for given in model.variant.given}
    sets = {key: np.array([value, 1.001 * value, 0.999 * value]) for key, value in own.items()}
    together = model.rates(motion.t, np.tile(motion.coordinates, (3, 1, 1)), sets)
    for index, factor in enumerate((1.0, 1.001, 0.999)):
        other = coursework.compile_model(scaled(model.variant, factor)).rates(motion.t, motion.coordinates)
        assert np.allclose(together[index], other, rtol=1e-12, atol=1e-12)
        one = model.rates(motion.t, motion.coordinates, {key: column[index] for key, column in sets.items()})
        assert np.array_equal(together[index], one)


@pytest.mark.parametrize("name", ["31", "stephenson", "example-6", "v110"])
def test_a_block_reads_the_velocities_before_it_and_no_others(name):
    model, motion = scene(name)
    found = []
    for index, block in enumerate(model.blocks):
        earlier = np.full_like(motion.velocities, np.nan)
        before = {unknown for other in model.blocks[:index] for unknown in other.unknowns}
        for place, velocity in enumerate(model.velocities):
            if velocity in before:
                earlier[:, place] = motion.velocities[:, place]
        found.append(model.block_velocities(index, motion.t, motion.coordinates, earlier))
        places = [model.velocities.index(unknown) for unknown in block.unknowns]
        assert np.allclose(found[-1], motion.velocities[:, places], rtol=1e-11, atol=1e-11)


def test_wrong_velocities_before_a_block_are_believed():
    """What a student's own w3 makes of w4: the rolling wheel gives w4 = -2 w3 (2 sin φ3 - cos φ3)."""
    model, motion = scene("31")
    earlier = np.zeros((1, 4))
    earlier[0, 2] = 7.0
    angle = motion.coordinates[0, 2]
    found = model.block_velocities(1, 0.0, motion.coordinates[:1], earlier)
    assert found[0, 0] == pytest.approx(-14.0 * (2 * np.sin(angle) - np.cos(angle)), rel=1e-13)


def test_beyond_the_table_of_a_law_there_is_no_value_and_no_complaint():
    model, motion = scene("variable-crank-table")
    law = next(law for law in model.variant.functions if law.table)
    place = model.coordinates.index(law.of)
    q = np.tile(motion.coordinates[0], (4, 1))
    q[:, place] = [law.table[0][0] - 0.1, law.table[0][0], law.table[-1][0], law.table[-1][0] + 0.1]
    known = np.isfinite(model.rates(0.0, q)).all(axis=1)
    assert known.tolist() == [False, True, True, False]


def test_at_a_dead_point_there_is_no_value_and_no_complaint():
    model, _ = scene("31")
    found = model.rates(0.0, [[1.0, 1.0, 2.87], [1.0, 2.0, 2.87], [np.nan, 2.0, 2.87]])
    assert np.isnan(found[0, :2]).all() and np.isfinite(found[0, 2:]).all()
    assert np.isfinite(found[1]).all()
    assert np.isnan(found[2, :2]).all()


BLOCK = mechanism("block-of-three-equations")


def test_a_singular_block_of_three_spoils_its_own_rows_only():
    model = coursework.compile_model(parse_variant(BLOCK, "block"))
    assert [block.size for block in model.blocks] == [3]
    q = np.array([[0.1, 0.2, 0.3], [np.pi / 2, np.pi / 2, 0.3], [0.2, 0.1, 0.3]])
    found = model.rates(0.0, q, {"a": 2.0})
    singular = model.determinants(0.0, q)[:, 0]
    assert np.isfinite(found[[0, 2]]).all()
    assert np.array_equal(np.isnan(found[1]).all(), singular[1] == 0.0)
    flat = model.rates(0.0, q, {"a": [2.0, 0.0, 1.0]})
    assert np.isnan(flat[1]).all() and np.isfinite(flat[[0, 2]]).all()


def test_over_columns_what_has_no_value_is_told_by_its_number_and_by_no_warning():
    """The root of -1 and the reciprocal of 0, each beside a set that has one."""
    model = coursework.compile_model("31")
    numbers = [value * np.ones(2) for value in model.variant.values.values()]
    found = model.compiled((call("sqrt", symbol("phi1")), 1 / symbol("phi2")))(
        0.0, np.array([-1.0, 4.0]), np.array([0.0, 2.0]), np.zeros(2), *numbers
    )
    assert np.isnan(found[0][0]) and np.isinf(found[1][0])
    assert [column[1] for column in found] == [2.0, 0.5]
