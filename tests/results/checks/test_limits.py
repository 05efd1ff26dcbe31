"""Every limit from both sides: a table just inside it and one just outside, made from the exact motion of variant 31."""

import math
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.results.checks import check, evidence
from coursework.results.checks.close_to_motion import closeness, period, rows, sinusoid
from coursework.results.checks.computed_right import beginning, conditioning, equations
from coursework.results.checks.evidence import Evidence
from coursework.variant.reading.reader import parse_variant
from tests.hard.drives import Law, four_bar
from tests.mechanisms.library import mechanism
from tests.results.checks import closed_form
from tests.results.checks.scenes import V31, evidence_of, finding, found, solve, spoil

T = 2 * math.pi / 13.08


@pytest.fixture(scope="module")
def run():
    return solve("31")


def table_of(run, exact=None, **cells) -> Evidence:
    """Return the evidence about the exact motion handed in as somebody's table, single cells changed."""
    return evidence_of(run, motion=spoil(exact or run.exact, **cells), replay=None)


def test_the_limits_are_those_of_the_specification():
    assert (evidence.LIMIT, evidence.NO_ERROR, evidence.OF_SIZE, evidence.OF_UNIT) == (0.05, 1e-10, 0.1, 0.05)
    assert (period.RETURNS, sinusoid.SHARE, rows.ROWS_A_PERIOD, conditioning.WIDEST_STEP) == (0.03, 0.9, 20, 1.0)
    assert (closeness.SPOILT, equations.LIMIT, conditioning.FEWEST, beginning.START_LIMIT) == (1e-9, 1e-11, 6.0, 1e-6)


def test_the_exact_motion_as_a_table_passes(run):
    found = {code: finding(code, table_of(run)) for code in ("ACCURACY", "CONTINUITY", "PERIOD-POSITION", "DRIFT", "SINUSOID")}
    assert {one.verdict for one in found.values()} == {"PASS"}
    assert found["ACCURACY"].value == found["CONTINUITY"].value == 0.0
    assert "no entry is off" in found["ACCURACY"].sentence
    near = finding("ACCURACY", table_of(run, phi1=(3, 0.01)))
    assert near.verdict == "PASS"
    assert near.sentence != found["ACCURACY"].sentence


@pytest.mark.parametrize(("factor", "verdict"), [(0.999, "PASS"), (1.001, "COARSE")])
@pytest.mark.parametrize("column", ["phi1", "phi2", "phi3", "w1", "w2", "w3", "w4"])
def test_accuracy(run, column, factor, verdict):
    scale = run.results.evidence.scale[column]
    judged = finding("ACCURACY", table_of(run, **{column: (9, -factor * 0.05 * scale)}))
    assert (judged.verdict, judged.column, judged.row) == (verdict, column, 10)
    assert judged.value == pytest.approx(factor * 0.05, rel=1e-9)


@pytest.mark.parametrize(("factor", "verdict"), [(0.999, "PASS"), (1.001, "COARSE")])
def test_continuity_judges_the_change_and_not_the_place(run, factor, verdict):
    scale = run.results.evidence.scale["phi3"]
    judged = finding("CONTINUITY", table_of(run, phi3=(24, factor * 0.05 * scale)))
    assert (judged.verdict, judged.column, judged.row) == (verdict, "phi3", 24)
    shifted = run.exact.coordinates + 0.04 * scale
    assert finding("CONTINUITY", table_of(run, replace(run.exact, coordinates=shifted))).verdict == "PASS"


@pytest.mark.parametrize(("factor", "verdict"), [(0.999, "PASS"), (1.001, "COARSE")])
@pytest.mark.parametrize(("code", "column"), [("PERIOD-POSITION", "phi2"), ("PERIOD-VELOCITY", "w4")])
def test_period(run, code, column, factor, verdict):
    motion, scale = run.exact, run.results.evidence.scale[column]
    gap = motion.column(column)[24] - motion.column(column)[0]
    judged = finding(code, table_of(run, **{column: (24, factor * 0.05 * scale - gap)}))
    assert (judged.verdict, judged.column, judged.row) == (verdict, column, 25)
    assert judged.last - judged.first == pytest.approx(factor * 0.05 * scale)


def missed(period: float) -> dict[str, float]:
    """Return by which share the exact motion misses its start after `period`, from the closed form."""
    rows = closed_form.exact(1, period)
    range_of = closed_form.exact(24, 0.02)
    spans = np.ptp(range_of.rows, axis=0)
    sizes = np.array([0.0] * 3 + [0.1 * float(np.max(np.abs(column))) for column in range_of.velocities.T])
    widest = [max(spans[:3])] * 3 + [max(spans[3:])] * 4
    shares = np.abs(rows.rows[1] - rows.rows[0]) / np.maximum(np.maximum(spans, sizes), 0.05 * np.array(widest))
    return dict(zip(rows.names, shares.tolist(), strict=True))


@pytest.mark.parametrize(
    ("code", "columns"), [("PERIOD-POSITION", ("phi1", "phi2", "phi3")), ("PERIOD-VELOCITY", ("w1", "w2", "w3", "w4"))]
)
@pytest.mark.parametrize("side", [-1, 1])
def test_a_stated_period_the_motion_does_not_have(code, columns, side):
    """The period is moved away from the true one until the closed form says that the motion misses its start by 0.03."""
    low, high = 0.0, 0.1
    for _ in range(60):
        middle = (low + high) / 2
        share = max(missed(T * (1 + side * middle))[name] for name in columns)
        low, high = (middle, high) if share < 0.03 else (low, middle)
    for part, expected in ((0.998, False), (1.002, True)):
        stated = T * (1 + side * low * part)
        judged = finding(code, evidence_of(solve(V31.replace('"2*pi/p"', f'"{stated!r} s"'))))
        assert (judged.verdict == "FAIL") == expected, (stated, judged)
        assert ("does not repeat after" in judged.sentence) == expected
        assert (re.search(r"begins at -?[\d.]+ (rad|rad/s) and is -?[\d.]+ \1 then", str(judged.sentence)) is None) != expected


@pytest.mark.parametrize("stated", ["0.40 s", "0.45 s", "0.2*2"])
def test_a_wrong_period_is_wrong_and_not_coarse(stated):
    run = solve(V31.replace('"2*pi/p"', f'"{stated}"'))
    assert {one.verdict for one in run.checks if one.code in {"PERIOD-POSITION", "PERIOD-VELOCITY"}} == {"FAIL"}
    assert run.status() == 1
    assert "Wrong: PERIOD-POSITION and PERIOD-VELOCITY." in run.summary


@pytest.mark.parametrize("scheme", ["euler", "rk4"])
def test_a_period_with_three_digits_is_the_period(scheme):
    run = solve(V31.replace('"2*pi/p"', '"0.480 s"'), scheme)
    assert "FAIL" not in {one.verdict for one in run.checks}


def test_drift_is_a_share_of_a_link_and_not_of_an_offset_or_of_a_datum_that_nothing_has():
    """Where sines are written out instead of vectors: r = 0.1 m, l = 0.4 m, beside them an offset and the module of a gear."""
    start = f'"{math.asin((0.002 - 0.1 * math.sin(0.5)) / 0.4)!r} rad"'
    changes = ('l = "0.4 m"', 'l = "0.4 m"\ne = "2 mm"\nm = "1 mm"'), ("= 0", "= e"), ('"-0.1201453472 rad"', start)
    judged = evidence_of(solve(mechanism("slider-crank-loop", *changes)))
    closure, motion = judged.closure, judged.motion
    residual, _ = closure.residual(motion.t, motion.coordinates, closure.targets(motion.t)[0])
    assert finding("DRIFT", judged).value == pytest.approx(np.abs(residual).max() / 0.1, rel=1e-12)


@pytest.mark.parametrize(("factor", "verdict"), [(0.999, "PASS"), (1.001, "COARSE")])
def test_drift_is_a_share_of_the_shortest_link(run, factor, verdict):
    """D hangs on link 1 (0.953 m): turning phi1 in one row opens the loop by 2 sin(d/2) 0.953 m, of 0.457 m."""
    closure = run.scene.closure

    def opened(turn: float) -> float:
        motion = spoil(run.exact, phi1=(5, turn))
        residual, _ = closure.residual(motion.t[5], motion.coordinates[5], closure.targets(motion.t)[0][5])
        return float(np.max(np.abs(residual))) / 0.457

    low, high = 0.0, 0.2
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if opened(middle) < 0.05 * factor else (low, middle)
    judged = finding("DRIFT", table_of(run, phi1=(5, low)))
    assert (judged.verdict, judged.row) == (verdict, 6)
    assert judged.value == pytest.approx(0.05 * factor, rel=1e-6)


@pytest.mark.parametrize(("share", "verdict"), [(0.901, "PASS"), (0.899, "COARSE")])
def test_sinusoid(run, share, verdict):
    """A fifth harmonic is added to w3 until the first three carry just more, or less, than nine tenths."""
    t, clean = run.exact.t, run.exact.column("w3")
    fifth = np.sin(5 * 13.08 * t)

    def carried(size: float) -> float:
        motion = replace(run.exact, velocities=run.exact.velocities + size * np.outer(fifth, [0, 0, 1, 0]))
        return sinusoid.shares(motion, ("w3",), (13.08,), 1.0)["w3"]

    low, high = 0.0, float(np.ptp(clean))
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if carried(middle) > share else (low, middle)
    motion = replace(run.exact, velocities=run.exact.velocities + low * np.outer(fifth, [0, 0, 1, 0]))
    judged = finding("SINUSOID", evidence_of(run, motion=motion, replay=None))
    assert (judged.verdict, judged.column) == (verdict, "w3")
    assert judged.value == pytest.approx(share, abs=1e-9)


@pytest.mark.parametrize(("rows_a_period", "verdict"), [(20, "PASS"), (19.99, "COARSE")])
def test_rows_a_period_of_the_drive(rows_a_period, verdict):
    run = solve("31", step=T / rows_a_period)
    judged = finding("STEP", run.results.evidence)
    assert (judged.verdict, judged.value) == (verdict, pytest.approx(rows_a_period))
    assert (f"a step of at most {T / 20:.3g} s." in judged.sentence) == (verdict == "COARSE")


@pytest.mark.parametrize(("rows_a_turn", "verdict"), [(20, "PASS"), (19.99, "COARSE")])
def test_rows_a_turn_of_a_crank_at_constant_speed(rows_a_turn, verdict):
    variant = solve("example-1").variant
    speed = abs(solve("example-1").motion.column("w1")[0])
    run = solve("example-1", step=2 * math.pi / speed / rows_a_turn)
    judged = finding("STEP", run.results.evidence)
    assert (judged.verdict, judged.value) == (verdict, pytest.approx(rows_a_turn))
    assert judged.column == variant.coordinates[0].name


@pytest.mark.parametrize(("height", "is_seen"), [(0.19, False), (0.21, True), (-0.19, False), (-0.21, True)])
def test_a_drive_may_leave_the_line_between_two_rows_by_a_fifth_of_its_range(height, is_seen, monkeypatch):
    """It grows from 0 to 1 in the run of 1 s, with rows at 0.4 s and 0.6 s and a pulse of 0.02 s between them."""
    begin, end = np.array([0.49]), np.array([0.51])
    shorter = SimpleNamespace(shorter=lambda length: (begin, end) if length == 0.1 else pytest.fail("half a step is asked for"))
    monkeypatch.setattr(rows, "resolution", lambda equations: shorter)
    monkeypatch.setattr(rows, "breaks", lambda variant: ())
    monkeypatch.setattr(rows, "drive_values", lambda equations, names, t: (t + height * ((begin < t) & (t < end)))[:, None])
    variant = SimpleNamespace(drive=[SimpleNamespace(name="w")], time=SimpleNamespace(end=1.0))
    told = rows.between_rows(SimpleNamespace(variant=variant), 0.2)
    assert (told is not None) is is_seen
    if is_seen:
        name, time, share = told
        assert (name, share) == ("w", pytest.approx(0.21))
        assert 0.49 < time < 0.51


@pytest.mark.parametrize(
    ("late", "is_at_a_row"), [(0.0, True), (0.9e-9, True), (-0.9e-9, True), (3.2e-9, False), (-3.2e-9, False)]
)
def test_a_break_of_the_drive_is_at_a_row_to_a_billionth_of_its_time(late, is_at_a_row, monkeypatch):
    """Row 2 stands at 0.4 s: 1e-9 of 1 + 2 steps of 0.2 s."""
    monkeypatch.setattr(rows, "breaks", lambda variant: (0.2 * (2 + late),))
    for end, seen in ((1.0, not is_at_a_row), (0.3, False)):  # a break after the end is none
        assert rows.off_row(SimpleNamespace(time=SimpleNamespace(end=end)), 0.2) == ([0.2 * (2 + late)] if seen else [])


@pytest.mark.parametrize(("turned", "verdict"), [(0.999, "PASS"), (1.001, "COARSE")])
def test_one_radian_a_step(turned, verdict):
    law = Law("steady", "n", {"n": f"{turned / 0.01!r} rad/s"}, lambda t: t)
    judged = finding("PEAK", coursework.solve(parse_variant(four_bar(law, end=0.05))).results.evidence)
    assert (judged.verdict, judged.column, judged.value) == (verdict, "w1", pytest.approx(turned))


@pytest.mark.parametrize(("law", "moment"), [
    ('[["0 s", "3"], ["0.042 s", "-1"]]', "largest, and the same, in rows 1 to 5"),
    ('[["0 s", "1"], ["0.02 s", "1 + 50*(t - 0.02)"], ["0.06 s", "3"]]', "largest, and the same, in rows 7 to 11"),
    ('[["0 s", "3*sin(10*pi*t)"], ["0.09 s", "0.9"]]', "largest at t = 0.05 s"),
])  # fmt: skip
def test_a_rate_that_is_the_largest_for_a_while_has_no_time(law, moment):
    text = mechanism("four-bar", ('w1 = "n"', f"w1 = {{ pieces = {law} }}"), step="0.01 s", end="0.1 s", period=None)
    run = coursework.solve(parse_variant(text), quantities=["table", "checks"])
    assert str(finding("PEAK", run.results.evidence).sentence).startswith(f"w1 is {moment}: 3 rad/s")


@pytest.mark.parametrize(("factor", "verdict"), [(0.5, "PASS"), (2.0, "FAIL")])
@pytest.mark.parametrize("code", ["INITIAL", "RESIDUAL"])
def test_residuals_are_round_off(run, code, factor, verdict):
    """w4 stands alone in equation 12 with the coefficient r3/2: changed by a part of itself, its terms change by that part."""
    row = 0 if code == "INITIAL" else 8
    names, _ = run.results.evidence.residuals
    system = {}
    for size in (1e-6, 1e-7):
        spoilt = evidence_of(run, motion=spoil(run.exact, w4=(row, size)))
        system[size] = spoilt.residuals[1][row, names.index("12")] / size
    slope = system[1e-7]
    assert system[1e-6] == pytest.approx(slope, rel=1e-4)
    for side in (1, -1):
        judged = finding(code, evidence_of(run, motion=spoil(run.exact, w4=(row, side * factor * 1e-11 / slope))))
        assert judged.verdict == verdict


@pytest.mark.parametrize(("digits", "verdict"), [(6.01, "PASS"), (5.99, "FAIL")])
def test_six_digits_are_left(run, monkeypatch, digits, verdict):
    monkeypatch.setattr(conditioning.np.linalg, "cond", lambda matrices: np.full(len(matrices), 10 ** (16 - digits)))
    judged = finding("CONDITION", evidence_of(run))
    assert (judged.verdict, judged.value) == (verdict, pytest.approx(digits))


@pytest.mark.parametrize(("stated", "verdict"), [
    ("0.505 s", "FAIL"), ("0.90 s", "FAIL"), ("2*2*pi/p", "SKIP"), ("0.97 s", "SKIP"),
])  # fmt: skip
def test_a_period_behind_the_end_of_the_run(stated, verdict):
    """Judged where it ends within one more length of the run of 0.482 s, by the motion followed there."""
    run = solve(V31.replace('"2*pi/p"', f'"{stated}"'), end=0.482, step=0.0241)
    judged = [found(run, code) for code in ("PERIOD-POSITION", "PERIOD-VELOCITY")]
    assert {one.verdict for one in judged} == {verdict}
    if stated == "0.505 s":
        ends = {name: missed(0.505)[name] for name in ("phi1", "phi2", "phi3")}
        assert judged[0].value == pytest.approx(max(ends.values()), rel=0.02)
    if verdict == "SKIP":
        assert all(
            f"before one period of {2 * T if 'pi' in stated else float(stated[:-2]):.6g} s" in one.sentence for one in judged
        )
        assert all(("followed further, does" in one.sentence) == ("pi" in stated) for one in judged)


@pytest.mark.parametrize("end", [0.3, 0.26])
@pytest.mark.parametrize(("part", "verdict"), [(1.0, "SKIP"), (1.002, "SKIP"), (0.97, "FAIL"), (1.03, "FAIL")])
def test_a_short_run_is_judged_by_the_scale_of_a_whole_period(end, part, verdict):
    run = solve(V31.replace('"2*pi/p"', f'"{T * part!r} s"'), end=end)
    assert found(run, "PERIOD-POSITION").verdict == verdict


def test_rows_that_end_beside_a_run_without_a_stated_period_are_not_wrong():
    """Thirteen steps and seven tenths: no row is near the end, and nobody said that the motion repeats there."""
    run = solve(V31.replace("\nperiod", "\n# period"), end=0.5, step=0.5 / 13.7)
    assert found(run, "PERIOD-POSITION").verdict == found(run, "PERIOD-VELOCITY").verdict == "SKIP"


@pytest.mark.parametrize(("digits", "too_few"), [(1.5, True), (1.7, False)])
def test_digits_are_too_few_for_the_way_of_a_coordinate_in_its_own_scale(digits, too_few, monkeypatch):
    """A slide goes 0.2 m, twice its scale: 2 / 10^digits is more than 5 % of that, or less."""
    monkeypatch.setattr(check, "condition", lambda evidence: SimpleNamespace(value=digits))
    exact = SimpleNamespace(coordinate_names=("s",), column=lambda name: np.array([0.1, 0.3, 0.2]))
    judged = SimpleNamespace(restricted=False, exact=exact, names=("s", "u"), scale={"s": 0.1, "u": 1.0})
    assert check._too_few(judged) == (digits if too_few else None)
