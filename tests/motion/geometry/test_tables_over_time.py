"""Laws tabulated over t: a drive, a length; integrated node by node, and as good as the formula they were printed from."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import coursework
from coursework.motion.geometry.drives.drive import integrals
from coursework.variant.reading.reader import parse_variant
from coursework.words.data_folders import folder
from tests.hard.scenes import check, scene
from tests.mechanisms.library import mechanism

END = 0.5
BASE = (folder("variants") / "31.toml").read_text(encoding="utf-8")


def crank(law):
    """Return a slider-crank whose crank has a length that changes over time."""
    text = mechanism(
        "slider-crank", ('"0 deg"', '"0.5 rad"'), ("[time]", f"[functions]\nr = {law}\n[time]"), r=None, l="0.4 m", e="0 m",
        n="10 rad/s", step="0.01 s", end="0.5 s", period=None,
    )  # fmt: skip
    return f'{text}[ask]\nquantities = ["table", "checks", "accelerations", "points"]\n'


def drive(t):
    return 4.5 * np.sin(13.08 * t + 4.35)


def length(t):
    return 0.12 + 0.02 * np.sin(7 * t)


def write(path, law, count):
    times = np.linspace(0, END, count)
    rows = zip(times.tolist(), law(times).tolist(), strict=True)
    path.write_text("t,value\n" + "".join(f"{t!r},{value!r}\n" for t, value in rows), encoding="utf-8")
    return times


@pytest.fixture
def driven(tmp_path):
    """Return a function that makes variant 31 with its drive as a table of so many nodes."""

    def made(count, method):
        write(tmp_path / "v.csv", drive, count)
        law = f'VMy = {{ table = "v.csv", of = "t", method = "{method}" }}'
        (tmp_path / "v.toml").write_text(BASE.replace('VMy = "V1*sin(p*t + alpha)"', law), encoding="utf-8")
        return coursework.solve(tmp_path / "v.toml")

    return made


@pytest.mark.parametrize("count", [11, 49, 400])
def test_a_drive_is_integrated_between_its_nodes(driven, count):
    """The spline's own integral, piece by piece, to round-off: rows and nodes need not meet."""
    nodes = np.linspace(0, END, count)
    other = CubicSpline(nodes, drive(nodes), bc_type="not-a-knot").antiderivative()
    times = np.arange(25) * 0.02
    found = integrals(driven(count, "spline").scene.equations, ["VMy"], times)[:, 0]
    assert np.max(np.abs(found - (other(times) - other(0)))) < 1e-14


@pytest.mark.long
@pytest.mark.parametrize("method", ["five-point", "spline"])
def test_a_tabulated_drive_tends_to_its_formula(driven, method):
    """Errors of the fourth power of the spacing, in the rows of the scheme and in the exact motion."""
    plain = coursework.solve("31")
    errors = []
    for count in (48, 192):
        run = driven(count, method)
        assert run.stop is None
        assert {check.verdict for check in run.checks if check.code in {"INITIAL", "RESIDUAL"}} == {"PASS"}
        errors.append([np.max(np.abs(a.rows - b.rows)) for a, b in ((run.motion, plain.motion), (run.exact, plain.exact))])
    coarse, fine = np.array(errors)
    assert (fine < 1e-7).all()
    assert (coarse / fine > 4**3).all()


@pytest.mark.parametrize("method", ["five-point", "spline"])
def test_a_length_over_time_and_its_derivatives(tmp_path, method):
    write(tmp_path / "r.csv", length, 401)
    (tmp_path / "table.toml").write_text(crank(f'{{ table = "r.csv", of = "t", method = "{method}" }}'), encoding="utf-8")
    (tmp_path / "formula.toml").write_text(crank('"0.12 + 0.02*sin(7*t)"'), encoding="utf-8")
    tabled, plain = coursework.solve(tmp_path / "table.toml"), coursework.solve(tmp_path / "formula.toml")
    (names, rows), (others, wanted) = tabled.columns(), plain.columns()
    assert names == others
    errors = dict(zip(names, np.max(np.abs(rows - wanted), axis=0).tolist(), strict=True))
    second = {"five-point": 1e-6, "spline": 1e-3}[method]  # the cubic's second derivative is of second order, at the ends too
    for name, error in errors.items():
        assert error < (second if name in {"dw2", "du"} or ".a" in name else 1e-7), name
    assert np.max(np.abs(tabled.exact.rows - plain.exact.rows)) < 1e-7


def test_beyond_the_last_node_the_table_is_named(driven, tmp_path):
    driven(49, "spline")
    told = r"v\.toml:\d+  drive\.VMy: the table covers 0 to 0\.5 s, and the run 0 to 0\.6 s\. Add nodes, or end the run earlier\."
    with pytest.raises(coursework.InputError, match=told):
        coursework.solve(tmp_path / "v.toml", end=0.6).columns()
    assert len(coursework.solve(tmp_path / "v.toml", end=0.5).motion.t) == 26


@pytest.mark.parametrize(
    ("section", "of", "sentence"),
    [
        ("drive", "phi1", r'drive\.VMy\.of: a drive is tabulated over time, found of = "phi1"\. Write of = "t"\.'),
        ("functions", "x", r'functions\.f\.of: "x" is neither t nor in \[coordinates\]\.'),
    ],
)
def test_over_what_a_table_may_be(tmp_path, section, of, sentence):
    write(tmp_path / "v.csv", drive, 49)
    law = f'{{ table = "v.csv", of = "{of}" }}'
    text = BASE.replace('"V1*sin(p*t + alpha)"', law) if section == "drive" else f"{BASE}\n[functions]\nf = {law}\n"
    (tmp_path / "v.toml").write_text(text, encoding="utf-8")
    with pytest.raises(coursework.InputError, match=sentence):
        coursework.load(tmp_path / "v.toml")


def found_step(run):
    return next(check for check in run.checks if check.code == "STEP")


@pytest.mark.long
@pytest.mark.parametrize("law", ['{ table = "v.csv", of = "t" }', '"V1/4.5*f"'])
def test_a_tabulated_drive_wants_its_twenty_rows_a_period(tmp_path, law):
    """The same sine as a formula and as a table, of the driven point or of a drive that it is written with."""
    write(tmp_path / "v.csv", drive, 49)
    text = BASE.replace('"V1*sin(p*t + alpha)"', law)
    if "*f" in law:
        text = text.replace("VMx = ", 'f = { table = "v.csv", of = "t" }\nVMx = ', 1)
    (tmp_path / "v.toml").write_text(text, encoding="utf-8")
    for step, verdict in ((0.1, "COARSE"), (0.025, "COARSE"), (0.023, "PASS")):
        end = step * round(0.5 / step - 0.5)
        found, wanted = (found_step(coursework.solve(v, "exact", step=step, end=end)) for v in (tmp_path / "v.toml", "31"))
        assert (found.verdict, found.value) == (verdict, pytest.approx(wanted.value, rel=0.01))
        assert "the drive’s fastest oscillation" in found.sentence


@pytest.mark.parametrize(("rows", "verdict"), [(20, "PASS"), (19, "COARSE")])
def test_a_crank_that_turns_back_is_judged_by_the_speed_of_each_piece(rows, verdict):
    w0, turn = 10.0, 2 * np.pi / 10.0
    text = (folder("variants") / "example-1.toml").read_text(encoding="utf-8")
    law = f'w1 = {{ pieces = [["0 s", "w0"], ["{turn / 2!r} s", "-w0"]] }}'
    text = text.replace('w1 = "w0"', law).replace("2*pi/(36*w0)", f"2*pi/({rows}*w0)")
    assert law in text
    step = found_step(coursework.solve(parse_variant(text)))
    assert (step.verdict, step.value, step.column) == (verdict, pytest.approx(2 * np.pi / w0 * w0 * rows / (2 * np.pi)), "theta1")


@pytest.mark.parametrize(("speed", "verdict"), [("3*w0*t/T", "SKIP"), ("20*w0*t/T", "COARSE")])
def test_a_crank_of_growing_speed_is_judged_once_it_makes_a_turn(speed, verdict):
    text = (folder("variants") / "example-1.toml").read_text(encoding="utf-8")
    text = text.replace('w1 = "w0"', f'w1 = "{speed}"').replace("[given]", '[given]\nT = "1 s"')
    step = found_step(
        coursework.solve(parse_variant(text.replace('"2*pi/w0"', '"0.628 s"').replace("2*pi/(36*w0)", "0.0157")), "exact")
    )
    assert step.verdict == verdict
    if verdict == "COARSE":
        assert step.value == pytest.approx(2 * np.pi / (200 * 0.628 * 0.0157))
    else:
        assert "no driven coordinate is an angle that makes a whole turn" in step.sentence


@pytest.mark.parametrize(("scheme", "verdict"), [("exact", "PASS"), ("heun", "COARSE")])
def test_a_break_between_rows_is_an_error_of_schemes_only(scheme, verdict):
    text = (folder("variants") / "example-1.toml").read_text(encoding="utf-8")
    text = text.replace('w1 = "w0"', 'w1 = { pieces = [["0 s", "w0"], ["0.3 s", "-w0"]] }')
    step = found_step(coursework.solve(parse_variant(text), scheme))
    assert step.verdict == verdict
    assert ("error of first order" in step.sentence, "at the break itself" in step.sentence) == (
        scheme == "heun",
        scheme == "exact",
    )


def test_behind_its_table_nothing_is_known_of_a_period(tmp_path):
    """The same wrong period, 5 % behind the end of the run: a formula goes on, a table does not."""
    text = BASE.replace('"2*pi/p"', '"0.505 s"')
    verdicts = {}
    for law in ('"V1*sin(p*t + alpha)"', '{ table = "v.csv", of = "t" }'):
        write(tmp_path / "v.csv", drive, 49)
        (tmp_path / "v.toml").write_text(text.replace('"V1*sin(p*t + alpha)"', law), encoding="utf-8")
        run = coursework.solve(tmp_path / "v.toml")
        verdicts[law[0]] = {check.verdict for check in run.checks if check.code in {"PERIOD-POSITION", "PERIOD-VELOCITY"}}
    assert verdicts == {'"': {"FAIL"}, "{": {"SKIP"}}


@pytest.mark.parametrize("step", [0.13, 0.15, 0.4])
def test_a_table_that_ends_behind_the_last_row_is_judged(tmp_path, step):
    """Its points are 0.05 s apart; the last row comes before 1 s, and the table has nothing for the one that would follow."""
    t = np.linspace(0, 1, 21)
    (tmp_path / "w.csv").write_text("".join(f"{a:.10g},{2 + math.sin(2 * math.pi * a):.10g}\n" for a in t), encoding="utf-8")
    text = scene(
        'x = { start = "0 rad", rate = "w" }\ny = { start = "0 rad", rate = "v" }', drive='w = { table = "w.csv", of = "t" }',
        equations=["v = 2*w"], step=step, end=1.0,
    )  # fmt: skip
    (tmp_path / "w.toml").write_text(text + '\n[ask]\nquantities = ["table", "checks"]\n', encoding="utf-8")
    assert check(coursework.solve(tmp_path / "w.toml"), "STEP").verdict == "COARSE"  # fewer than twenty rows a period of 1 s
