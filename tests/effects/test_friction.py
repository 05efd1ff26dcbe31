"""Friction: its laws in one joint, the fixed point, power that is lost, self-locking told."""

import json

import numpy as np
import pytest

import coursework
from coursework.effects.kinetostatics.checks import check_forces
from coursework.effects.told import force_record
from coursework.report.pages import build_model, render_html
from tests.effects.massed import of, of_text
from tests.effects.test_ways import PARALLEL
from tests.mechanisms.library import mechanism
from tests.report.real import text_of as shown


def rubbing(name, entries):
    return of_text(mechanism(name, ("[ask]", f"[friction]\n{entries}\n\n[ask]")))


def test_friction_of_a_guide_is_its_force_times_the_coefficient():
    found = rubbing("example-2-forces", 'C = { coefficient = "0.1" }')
    force = next(one.force for one in found.reactions.friction if one.body == "3")
    sliding = found.rows.motion.column("u3")
    moves = np.abs(sliding) > 1e-9
    assert np.abs(force.real[moves] + 0.1 * np.abs(found.column("N03"))[moves] * np.sign(sliding[moves])).max() < 1e-9
    assert (force.real[~moves] == 0).all() and (~moves).any()


def test_a_guide_of_some_length_bears_a_couple_at_its_two_ends():
    """Two forces 50 mm apart with the sum N and the couple K: together |N|, or 2 |K|/length where they have two directions."""
    text = mechanism(
        "example-2-forces", ("[ask]", '[friction]\nC = { coefficient = "0.1", length = "50 mm" }\n\n[ask]'),
        ('C = { mass = "20 kg", ', 'C = { mass = "20 kg", centre = "C + (0, 0.1)", '),
    )  # fmt: skip
    found = of_text(text)
    force = next(one.force for one in found.reactions.friction if one.body == "3")
    across, couple = np.abs(found.column("N03")), 2 * np.abs(found.column("K03")) / 0.05
    assert (couple > across).any() and (couple < across).any()
    sliding = found.rows.motion.column("u3")
    wanted = -0.1 * np.maximum(across, couple) * np.sign(sliding) * (np.abs(sliding) > 1e-9)
    assert np.abs(force.real - wanted).max() < 1e-8 * couple.max()


def test_a_block_on_a_lever_rubs_both_and_the_drive_gives_what_that_takes():
    found = rubbing("whitworth-forces", 'B = { coefficient = "0.1", length = "1 mm" }')
    across, couple = np.abs(found.column("N32")), 2 * np.abs(found.column("K32")) / 0.001
    assert (couple > across).any() and (couple < across).any()
    lost = 0.1 * np.maximum(across, couple) * np.abs(found.rows.motion.column("u2"))
    assert found.energy.friction == pytest.approx(-lost, abs=1e-9)
    assert found.energy.drive == pytest.approx(of("whitworth-forces").energy.drive + lost, abs=1e-9)
    (block, force), (lever, back) = ((one.body, one.force) for one in found.reactions.friction)
    assert (block, lever) == ("2", "3") and np.abs(force + back).max() == 0


@pytest.mark.parametrize("rail", ['rails  = [ { through = "F", angle = "0" } ]\n', ""])
def test_a_slider_of_a_chain_rubs_whether_or_not_the_frame_names_its_rail(rail):
    """It was said that nothing rubs at F."""
    text = mechanism("whitworth-forces", ('rails  = [ { through = "F", angle = "0" } ]\n', rail))
    found = of_text(text.replace("[ask]", '[friction]\nF = { coefficient = "0.1" }\n\n[ask]'))
    lost = 0.1 * np.abs(found.column("N05") * found.rows.motion.column("u5"))
    assert found.energy.friction == pytest.approx(-lost, abs=1e-9)


def test_rows_in_which_a_pair_stands_still_are_told():
    """The slider stands in both dead positions: rows 1, 19 and 37 of a turn in steps of ten degrees."""
    for entries, told in (('C = { coefficient = "0.1" }', True), ('A = { radius = "20 mm", coefficient = "0.1" }', False)):
        checks = {one.code: one for one in check_forces(rubbing("example-2-forces", entries), None)}
        assert ("still in 3 of the rows (the first is row 1)" in str(checks["FRICTION"].sentence)) == told


def test_power_lost_is_what_the_drive_gives_more():
    pin = '{ radius = "20 mm", coefficient = "0.1" }'
    entries = f'A = {pin}\nB = {pin}\nC = {{ coefficient = "0.1" }}'
    found, ideal = rubbing("example-2-forces", entries), of("example-2-forces")
    energy = found.energy
    assert (energy.friction <= 1e-9).all() and energy.friction.min() < -10
    assert energy.drive + energy.friction == pytest.approx(ideal.energy.drive, abs=1e-6)
    checks = {one.code: one for one in check_forces(found, None)}
    for code in ("VIRTUAL-POWER", "GROUPS", "REACTIONS-SUM", "FRICTION"):
        assert checks[code].verdict == "PASS", code
    small = rubbing("example-2-forces", entries.replace("0.1", "0.01"))
    lost = np.trapezoid(found.energy.friction), np.trapezoid(small.energy.friction)
    assert lost[0] == pytest.approx(10 * lost[1], rel=0.1)


def test_a_wheel_rolls_against_an_arm():
    found = rubbing("31-forces", 'P = { arm = "2 mm" }')
    couple = next(one.couple for one in found.reactions.friction)
    assert np.abs(couple + 0.002 * np.abs(found.column("N04")) * np.sign(found.rows.motion.column("w4"))).max() < 1e-9


def test_self_locking_is_told_with_its_rows():
    # The rod presses the slider with N = F tan(theta2), up to 0.35 F: from a coefficient of 2.9 on it cannot be pushed there.
    found = rubbing("example-2-forces", 'C = { coefficient = "4" }')
    told = {one.code: one for one in check_forces(found, None)}["FRICTION"]
    assert told.verdict == "FAIL"
    assert str(told.sentence).startswith("Self-locking in ")
    locked = np.isnan(found.reactions.rows).all(axis=1)
    assert locked.any() and (np.isnan(found.energy.friction) == locked).all()


def test_where_friction_nearly_locks_the_drive_is_found_all_the_same():
    found = rubbing("example-2-forces", 'C = { coefficient = "2.5" }')
    checks = {one.code: one.verdict for one in check_forces(found, None)}
    assert [checks[code] for code in ("FRICTION", "VIRTUAL-POWER", "REACTIONS-SUM", "GROUPS")] == ["PASS"] * 4


def test_a_row_that_runs_away_does_not_make_another_look_settled():
    found = rubbing("example-2-forces", 'C = { coefficient = "40" }')
    free = ~np.isnan(found.reactions.rows).all(axis=1)
    force = next(one.force for one in found.reactions.friction if one.body == "3")
    assert free.any() and not free.all()
    assert np.abs(np.abs(force[free]) - 40 * np.abs(found.column("N03"))[free] * (force[free] != 0)).max() < 1e-6


def test_a_redundant_support_with_friction_locks_nothing():
    found = of_text(f'{PARALLEL}[friction]\nA = {{ radius = "10 mm", coefficient = "0.1" }}\n')
    finding = next(one for one in check_forces(found, None) if one.code == "FRICTION")
    assert finding.verdict == "SKIP" and "not unique" in str(finding.sentence)


def test_a_run_with_self_locking_rows_is_written_and_its_page_claims_nothing_of_them():
    text = mechanism("example-2-forces", ("[ask]", '[friction]\nC = { coefficient = "4" }\n\n[ask]'))
    run = coursework.solve(coursework.parse_variant(text), scheme="exact", quantities=["table", "checks", "forces", "energy"])
    page = shown(render_html(build_model(run, "en")))
    assert "in which friction locks the mechanism" in page and "a reaction that is not unique" not in page
    assert "gives power in every row" not in page
    record = json.dumps(force_record(run.results.forces, run.scene.variant.time.period), allow_nan=False)
    assert json.loads(record)["mean_moment"] is None


def test_a_coefficient_among_the_data_is_a_plain_number():
    data = ("[given]", '[given]\nmu = "7"'), ("[ask]", '[friction]\nC = { coefficient = "mu" }\n\n[ask]')
    assert coursework.parse_variant(mechanism("example-2-forces", *data)).remarks == ()


def test_a_file_without_friction_has_none():
    assert of("example-2-forces").reactions.friction == ()
    assert not of("example-2-forces").energy.friction.any()


@pytest.mark.parametrize(
    "entry", ['B = { coefficient = "0.1" }', 'S = { coefficient = "0.1", radius = "5 mm" }', 'C = { arm = "1 mm" }']
)
def test_friction_where_nothing_rubs_is_told_with_its_line(entry):
    text = mechanism(
        "example-2-forces", ("[points]\n", '[points]\nS = "B + 0.4 @ theta2"\n'), ("[ask]", f"[friction]\n{entry}\n\n[ask]")
    )
    line = text[: text.index(entry)].count("\n") + 1
    with pytest.raises(coursework.InputError, match=rf"V748 bad.toml:{line}.*nothing rubs at {entry[0]}.*Write them"):
        _ = coursework.solve(coursework.parse_variant(text, "bad.toml"), quantities=["forces"]).results.forces
