"""Groups that cannot be put together and dead points: every sentence, and the same verdict at every scale."""

from __future__ import annotations

import json
import pickle
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursework.mechanism import groups
from coursework.mechanism.groups import (
    GROUPS,
    AtDeadPoint,
    CannotAssemble,
    GroupMotion,
    Guide,
    Pair,
    crank,
    prp,
    rpp,
    rpr,
    rrp,
    rrr,
)
from coursework.mechanism.groups.plane import angle_of
from coursework.variant.record.vocabulary import GROUP_KINDS

REFERENCE = Path(__file__).parents[2] / "reference"
ORIGIN = Pair((0.0, 0.0))
X_AXIS = Guide(ORIGIN, 0.0)


def hard_case(number: str) -> dict[str, dict[str, object]]:
    cases = json.loads((REFERENCE / "hard_cases.json").read_text())["cases"]
    found: dict[str, dict[str, object]] = next(case for case in cases if case["id"] == number)
    return found


def row_of_pins(*places: float) -> Pair:
    return Pair(np.array([(place, 0.0) for place in places]))


def test_rrr_too_short_names_row_and_shortage() -> None:
    places = np.linspace(1.0, 1.9132, 13)
    with pytest.raises(CannotAssemble) as caught:
        rrr(ORIGIN, row_of_pins(*places), lengths=(1.0, 0.8), mode=1)
    assert str(caught.value) == (
        "RRR cannot be assembled at row 11: B and D are 1.8371 m apart, the two links reach 1.8000 m; "
        "together they are 0.0371 m too short. Nor can 1 later row."
    )
    assert (caught.value.row, caught.value.rows) == (11, (11, 12))
    assert caught.value.shortage == pytest.approx(places[11] - 1.8, abs=1e-15)

    with pytest.raises(CannotAssemble) as caught:
        rrr(ORIGIN, Pair((1.9132, 0.0)), lengths=(1.0, 0.8), mode=1)
    assert str(caught.value) == (
        "RRR cannot be assembled at row 0: B and D are 1.9132 m apart, the two links reach 1.8000 m; "
        "together they are 0.1132 m too short."
    )


def test_rrr_too_long_to_fold() -> None:
    with pytest.raises(CannotAssemble) as caught:
        rrr(ORIGIN, row_of_pins(1.0, 0.18), lengths=(0.8, 1.0), mode=-1)
    assert str(caught.value) == (
        "RRR cannot be assembled at row 1: B and D are 0.1800 m apart, the links differ by 0.2000 m; "
        "the longer link is 0.0200 m too long to fold."
    )
    assert caught.value.shortage == pytest.approx(0.02)


def test_rrp_and_rpr_out_of_reach() -> None:
    with pytest.raises(CannotAssemble) as caught:
        rrp(Pair((3.0, 0.52)), X_AXIS, length=0.5, mode=1)
    assert str(caught.value) == (
        "RRP cannot be assembled at row 0: B is 0.5200 m from the line of the pin, the rod is 0.5000 m long; "
        "it is 0.0200 m too short."
    )
    with pytest.raises(CannotAssemble) as caught:
        rpr(row_of_pins(1.0, 0.0999), ORIGIN, offset=-0.1)
    assert str(caught.value) == (
        "RPR cannot be assembled at row 1: B and D are 0.0999 m apart, the offset is 0.1000 m; it is 0.0001 m too long."
    )
    assert caught.value.shortage == pytest.approx(1e-4)


def test_parallel_slides() -> None:
    with pytest.raises(CannotAssemble, match=r"RPP .*row 0: the slides are parallel; .* are 0\.3000 m apart"):
        rpp(Pair((1.0, 0.3)), X_AXIS, slide_angle=np.pi)
    with pytest.raises(AtDeadPoint, match=r"coincide and a block may be anywhere.*nor is the position"):
        rpp(Pair((1.0, 0.0)), X_AXIS, slide_angle=0.0, positions_only=True)
    other = Guide(Pair((0.0, 1.0)), np.array([0.5, np.pi]))
    with pytest.raises(CannotAssemble, match=r"PRP .*row 1: the slides are parallel; .* are 1\.0000 m apart"):
        prp(X_AXIS, other)
    with pytest.raises(AtDeadPoint, match="PRP is at a dead point at row 0: the slides are parallel"):
        prp(X_AXIS, Guide(Pair((0.0, 1.0)), 0.0, offset=-1.0))


def test_nearly_parallel_guides_are_solved() -> None:
    hard_case("H11")
    solved = prp(X_AXIS, Guide(Pair((0.0, 1.0)), 1e-8))
    assert solved.coordinates[0] == pytest.approx((-1e8, -1e8), rel=1e-15)
    assert solved.determinant[0] == pytest.approx(-1e-8, rel=1e-15)


DEAD: dict[str, tuple[Callable[..., GroupMotion], str, tuple[float, float]]] = {
    "RRR stretched": (
        lambda **more: rrr(ORIGIN, Pair((1.8, 0.0), (0.0, 1.0)), lengths=(1.0, 0.8), mode=1, **more),
        "RRR is at a dead point at row 0: B, C and D lie on one line, the links are stretched. The determinant is 0, "
        "so velocities are not defined there; pass positions_only=True for the positions alone.",
        (0.0, np.pi),
    ),
    "RRR folded": (
        lambda **more: rrr(ORIGIN, Pair((0.25, 0.0)), lengths=(1.0, 0.75), mode=-1, **more),
        "RRR is at a dead point at row 0: B, C and D lie on one line, the links are folded.",
        (0.0, 0.0),
    ),
    "RRP": (
        lambda **more: rrp(Pair((2.0, 0.5)), X_AXIS, length=0.5, mode=1, **more),
        "RRP is at a dead point at row 0: the rod is perpendicular to the guide.",
        (-np.pi / 2, 2.0),
    ),
    "RPR": (
        lambda **more: rpr(Pair((0.1, 0.0)), ORIGIN, offset=0.1, **more),
        "RPR is at a dead point at row 0: the block is level with the pivot D, s = 0.",
        (-np.pi / 2, 0.0),
    ),
}


@pytest.mark.parametrize("name", DEAD)
def test_dead_points_give_positions_but_no_velocities(name: str) -> None:
    solve, sentence, coordinates = DEAD[name]
    with pytest.raises(AtDeadPoint) as caught:
        solve()
    assert str(caught.value).startswith(sentence)
    assert (caught.value.row, caught.value.rows) == (0, (0,))
    solved = solve(positions_only=True)
    assert solved.coordinates[0] == pytest.approx(coordinates, abs=1e-15)
    assert solved.determinant[0] == 0.0
    assert solved.scaled_determinant[0] == 0.0
    assert solved.rates is None
    assert solved.accelerations is None
    assert solved.meets.velocity is None
    assert solved.meets.acceleration is None


def test_no_position_where_the_links_may_turn_freely() -> None:
    with pytest.raises(AtDeadPoint, match=r"B and D coincide and the links are equal\. .*nor is the position"):
        rrr(ORIGIN, row_of_pins(1.0, 0.0), lengths=(1.0, 1.0), mode=1, positions_only=True)
    with pytest.raises(AtDeadPoint, match="B lies on D and the rod may point anywhere"):
        rpr(ORIGIN, row_of_pins(1.0, 0.0), positions_only=True)
    with pytest.raises(CannotAssemble, match=r"0\.0000 m apart, the links differ by 0\.5000 m"):
        rrr(ORIGIN, ORIGIN, lengths=(1.0, 0.5), mode=1)


@pytest.mark.long
@pytest.mark.parametrize("mode", [1, -1])
def test_grashof_neutral_linkage_folds_at_any_scale(mode: int) -> None:
    lengths = hard_case("H05")["data"]
    a, b, c, d = (float(str(lengths[name])) for name in "abcd")
    for scale in (*np.arange(1, 2001) / 1000, 1e-9, 1e9, 1 / 3, np.pi):
        pin = crank(ORIGIN, length=a * scale, angle=[0.0, 2.0], rate=1.0).meets
        ground = Pair((d * scale, 0.0))
        with pytest.raises(AtDeadPoint):
            rrr(pin, ground, lengths=(b * scale, c * scale), mode=mode)
        solved = rrr(pin, ground, lengths=(b * scale, c * scale), mode=mode, positions_only=True)
        assert solved.meets.position[0] == pytest.approx((5 * scale, 0.0), rel=1e-14, abs=1e-14 * scale)
        assert solved.determinant[0] == 0.0


@settings(max_examples=100, deadline=None)
@given(
    st.floats(0.1, 10.0),
    st.floats(0.1, 10.0),
    st.sampled_from([1e-3, 1.0, 1e3]),
    st.sampled_from(["stretch", "fold"]),
)
def test_an_excess_beyond_rounding_is_never_clipped(r_i: float, r_j: float, scale: float, how: str) -> None:
    limit = (r_i + r_j) * scale if how == "stretch" else abs(r_i - r_j) * scale
    step = 40 * np.spacing((r_i + r_j) * scale) * (1 if how == "stretch" else -1)
    if limit + step <= 0.0:
        return
    lengths = (r_i * scale, r_j * scale)
    with pytest.raises(CannotAssemble):
        rrr(ORIGIN, Pair((limit + step, 0.0)), lengths=lengths, mode=1, positions_only=True)
    inside = rrr(ORIGIN, Pair((limit - step, 0.0)), lengths=lengths, mode=1)
    assert inside.rates is not None
    assert inside.determinant[0] < 0.0


@pytest.mark.parametrize("mode", [1, -1])
@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_a_half_turn_is_plus_pi_whatever_the_sign_of_zero(mode: int, zero: float) -> None:
    left = rrr(ORIGIN, Pair((-1.75, zero)), lengths=(1.0, 0.75), mode=mode, positions_only=True)
    assert left.coordinates[0].tolist() == [np.pi, 0.0]
    right = rrr(ORIGIN, Pair((1.75, zero)), lengths=(1.0, 0.75), mode=mode, positions_only=True)
    assert right.coordinates[0].tolist() == [0.0, np.pi]
    block = rpr(Pair((-1.0, zero)), ORIGIN, mode=1)
    assert block.coordinates[0].tolist() == [np.pi, 1.0]
    assert angle_of(np.array([complex(-1.0, zero)])).tolist() == [np.pi]


def test_both_assemblies_of_the_hard_case() -> None:
    expected = hard_case("H32")["expected"]
    pin = crank(ORIGIN, length=1.0, angle=0.7, rate=1.0).meets
    for mode, branch in ((1, "branch +: phi_b,phi_c,det"), (-1, "branch -")):
        phi_b, phi_c, det = (float(str(part)) for part in expected[branch])  # type: ignore[attr-defined]
        solved = rrr(pin, Pair((2.5, 0.0)), lengths=(3.0, 2.0), mode=mode)
        assert solved.coordinates[0] == pytest.approx((phi_b, phi_c), rel=1e-15)
        # our matrix has the opposite order of angles in its determinant
        assert solved.determinant[0] == pytest.approx(-det, rel=1e-14)


def test_tangent_guide_near_its_dead_point() -> None:
    hard_case("H10")
    b = Pair((0.0, 0.3 + 0.1 * 1.9), (0.0, 0.1))
    solved = rrp(b, X_AXIS, length=0.5, mode=1)
    assert solved.rates is not None
    assert solved.coordinates[0, 1] == pytest.approx(0.099498743710661995, rel=1e-14)
    assert solved.rates[0, 0] == pytest.approx(-1.0050378152592121, rel=1e-14)


@pytest.mark.parametrize("error", [CannotAssemble("too short.", (3, 5), 0.25), AtDeadPoint("dead.", (4,))])
def test_errors_survive_a_process_pool(error: CannotAssemble | AtDeadPoint) -> None:
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.row, again.rows) == (str(error), error.row, error.rows)
    assert getattr(again, "shortage", None) == getattr(error, "shortage", None)


def test_every_group_is_listed_once() -> None:
    assert [kind.name for kind in GROUPS] == ["crank", "RRR", "RRP", "RPR", "RPP", "PRP"] == [*GROUP_KINDS]
    for kind in GROUPS:
        procedure = getattr(groups, kind.name.lower())
        assert procedure.__doc__ is not None
        assert pickle.loads(pickle.dumps(kind)) is kind
        if not kind.driven:
            assert "AtDeadPoint" in procedure.__doc__
            assert "determinant" in procedure.__doc__


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_equal_links_folded_onto_each_other_are_at_a_dead_point_to_round_off_of_their_length(size: float) -> None:
    for apart, is_dead in ((0.0, True), (1e-16, True), (1e-13, False)):
        if is_dead:
            with pytest.raises(AtDeadPoint, match="coincide"):
                rrr([0.0, 0.0], [apart * size, 0.0], lengths=(size, size), mode=1)
        else:
            assert np.isfinite(rrr([0.0, 0.0], [apart * size, 0.0], lengths=(size, size), mode=1).coordinates).all()
