"""Six mechanisms of a student's own, from `new --groups` to the table: motion against closed forms, every slip told."""

from pathlib import Path

import mpmath as mp
import pytest

import coursework
from coursework.report.wording.data_meanings import meanings
from tests.command import call
from tests.commands.own_files import CLOSED, EQUATIONS, GROUPS, edited, turned
from tests.sample import first

pytestmark = pytest.mark.usefixtures("folder")
H = mp.mpf("1e-8")


def file_of(name):
    assert call("new", "mine", "--groups", GROUPS[name]).exit_code == 0
    return edited(name, Path("mine.toml").read_text(encoding="utf-8"))


def solved(text):
    return coursework.solve(coursework.parse_variant(text), quantities=("table", "checks", "accelerations"))


def parted(values):
    """Return rate and acceleration at the middle of five values, an angle as the vector along its link."""
    if any(isinstance(value, mp.mpc) for value in values):
        values = [mp.arg(value / values[2]) for value in values]
    a, b, c, d, e = values
    return (a - 8 * b + 8 * d - e) / (12 * H), (-a + 16 * b - 30 * c + 16 * d - e) / (12 * H**2)


@pytest.mark.parametrize("name", GROUPS)
def test_velocities_and_accelerations_are_those_of_the_closed_form(name):
    run = solved(file_of(name))
    (agreement,) = (one for one in run.checks if one.code == "AGREEMENT")
    assert agreement.verdict == "PASS" and run.stop is None
    second = run.scene.results.accelerations
    rates = {coordinate.name: coordinate.rate for coordinate in run.variant.coordinates}
    with mp.workdps(40):
        for row in range(0, len(run.motion.t), 9):
            t = mp.mpf(float(run.motion.t[row]))
            around = [CLOSED[name](t + k * H) for k in (-2, -1, 0, 1, 2)]
            for coordinate in around[2]:
                rate, acceleration = parted([values[coordinate] for values in around])
                column = run.motion.velocity_names.index(rates[coordinate])
                assert float(run.motion.velocities[row, column]) == pytest.approx(float(rate), rel=1e-9, abs=1e-9)
                assert float(second[row, column]) == pytest.approx(float(acceleration), rel=1e-9, abs=1e-8)


@pytest.mark.parametrize("name", GROUPS)
@pytest.mark.parametrize("part", first(1, range(3)))
def test_every_turned_sign_is_refused_with_its_equation(name, part):
    text = file_of(name)
    for number, equation in enumerate(EQUATIONS[name], start=1):
        wrong = turned(equation)
        assert len(wrong) >= 3
        for other in wrong[part::3]:
            with pytest.raises(coursework.InputError, match=rf"V302 .* equation {number} contradicts"):
                solved(text.replace(equation, other)).columns()


def test_a_length_written_in_numbers_misses_no_factor():
    variant = coursework.parse_variant(text := file_of("inclined"))
    assert {remark.code for remark in variant.plausibility} == {"UNUSED"}  # of the data that it writes out in numbers
    missing = coursework.parse_variant(text.replace("0.27*w2*sin", "0.5*w2*sin"))
    assert "NUMBER" in [remark.code for remark in missing.plausibility]


def test_a_crank_without_a_start_is_a_fault():
    text = file_of("lift")
    with pytest.raises(coursework.InputError, match=r"V073 .*coordinates.phi2: .*start = \"0 rad\""):
        coursework.parse_variant(text.replace('start = "120 deg", ', ""))


def test_a_determinant_says_what_it_means_for_the_guides():
    told = {name: str(solved(file_of_once).reduction.blocks[0].meaning) for name, file_of_once in texts("oblique", "slots")}
    assert told == {"oblique": "it is never zero", "slots": "the two guides are parallel"}


def texts(*names):
    for name in names:
        Path("mine.toml").unlink(missing_ok=True)
        yield name, file_of(name)


def test_guides_that_become_parallel_carry_their_hinge_away_and_nothing_is_drawn_there():
    text = file_of("slots").replace('w2 = "-0.4*n2*sin(n2*t)"', 'w2 = "n2"')
    stop = solved(text).stop
    # The guides turn at pi/2 from phi1 and -pi/2 from phi2: parallel where phi2 - phi1 is half a turn.
    turn = mp.mpf(4) / 3 * mp.pi
    time = mp.findroot(lambda t: 2 * mp.pi / 3 + turn * t - mp.pi / 6 - mp.sin(turn * t) / 2 - mp.pi, 0.3)
    assert stop.time == pytest.approx(float(time), abs=1e-7) and set(stop.coordinates) == {"phi1", "phi2"}
    assert "Towards it the distance along the guides (s3 and s4) grows beyond all bounds" in str(stop.meaning)
    assert "asks for" not in str(stop.meaning)


def test_what_swings_and_what_turns_with_a_crank_is_said_of_the_data():
    found = meanings(solved(file_of("slots")).scene.mechanism)
    assert (str(found["swing1"]), str(found["delta4"])) == ("amplitude of phi1", "angle from AB to BF")
    assert str(found["gamma4"]) == "angle from CD to DF"


def test_a_new_chain_is_headed_by_its_name_alone_in_every_language():
    file_of("lever")
    for language, headed in (("ru", "Вариант mine"), ("en", "Variant mine")):
        call("run", "mine", "--format", "html", "--out", "page", "--language", language)
        assert f">{headed}</h1>" in Path("page/report.html").read_text(encoding="utf-8")
