"""Slips that students make in a new file: each has one sentence that says what to write, and none because of another."""

from __future__ import annotations

import re

import pytest

import coursework
from coursework.desk.answering.mends import mends_of
from coursework.words.data_folders import folder
from tests.mechanisms.library import mechanism
from tests.report.own import SHAPER

TEMPLATE = (folder("reports") / "new-variant.toml").read_text(encoding="utf-8").replace("NAME", "mine")

SLIPS = [
    ('A = "O + r1 @ phi1"', 'A = "O + 0.3 m @ phi1"', {"V143": 'put "0.3 m" into [given]'}),
    ("@ phi2", "@ (phi2 + 30 deg)", {"V143": 'put "30 deg" into [given]'}),
    ('angle = "0"', 'angle = "phi1 + 90 deg"', {"V143": 'put "90 deg" into [given]'}),
    ("V*sin(p*t)", "V*sin(p*t) + 9.81 m/s^2*t", {"V143": 'put "9.81 m/s^2" into [given]'}),
    ("V*sin(p*t)", "V*sin(p*t) - 20 N", {"V143": 'put "20 N" into [given]'}),
    ("V*sin(p*t)", "V*sin(p*t) - 0.5 N/mm*t", {"V143": 'put "0.5 N/mm" into [given]'}),
    ("V*sin(p*t)", "2 g*sin(p*t)", {"V120": 'an operator is missing before "g"'}),
    ("r1*w1*sin(phi1) = 0", "r1*w1*sin(phi1)) = 0", {"V144": "closes nothing"}),
    ("V*sin(p*t)", "V*Sin(p*t)", {"V126": 'Did you mean "sin"?'}),
    ("V*sin(p*t)", "V*sin(p*T)", {"V053": 'Did you mean "t"?'}),
    ("r1*w1*sin(phi1) = 0", "r1*dphi1*sin(phi1) = 0", {"V053": "The rate of phi1 is written w1."}),
    ('"2*pi/p"', '"2π/p"', {"V120": 'an operator is missing before "pi"'}),
    ("r1*w1*sin(phi1) = 0", "r1*w1*sin(phi1 + 20°) = 0", {"V101": "angles in formulas are radians: 20*pi/180"}),
    (
        "r1*w1*sin(phi1) = 0",
        "r1*w1*sin(phi1) = VAy",
        {"V053": "It is the velocity of A along y: where it is given, write its law"},
    ),
    ('["A", "M"], rate = "w2"', '["A", "M"], rate = "w1 + w2"', {"V078": "set it equal to w1 + w2 in a [[constraint]]"}),
    ('["A", "M"], rate = "w2"', '["A", "M"], rate = "-w2"', {"V078": "Leave the rate out: [points] show how the link turns"}),
    ('["A", "M"], rate = "w2"', '["A", "M"], rate = "− w2"', {"V078": "Leave the rate out: [points] show how the link turns"}),
    ('["A", "M"], rate = "w2"', '["A", "M"], rate = "w2 "', {"V078": 'Did you mean "w2"?'}),
    ("[given] ", '[given]\nr9 = "2*r1/sqrt(2)"\n#', {"V164": 'Write r9 = "2*r1/sqrt(2)" in [functions], or its'}),
    ('"0.02 s"', '"1/50 rad"', {"V160": 'Write "0.02 s".'}),
    ('"0.02 s"', '"1/60 s"', {"V160": 'Write "1/60".'}),
    ('"0.02 s"', '"1/3600 min"', {"V160": 'Write "60*(1/3600)".'}),
    ('["A", "M"]', '["A", "A"]', {"V157": "A stands twice in this list."}),
    ('hinges = ["O"]', 'hinges = ["O", "O"]', {"V157": "O stands twice in this list."}),
    ("[given] ", "[givens] ", {"V011": 'Did you mean "given"?'}),
    ("step      =", "stpe      =", {"V011": 'Did you mean "step"?'}),
    ('end       = "1 s"\n', "", {"V013": 'the key "end" is missing'}),
    ("[drive]", '[drive]\nphi1 = "p*t"', {"V161": "Write the derivative of the law there, w1 = …"}),
    ("\n", "\r", {"V009": "line ends of Windows or Unix"}),
    ("[given] ", "[gіven] ", {"V009": "letter 2 of the key is the Cyrillic small letter byelorussian-ukrainian i"}),
    ("rate =", "rаte =", {"V009": 'which looks like the Latin "a"'}),
    ("[[constraint]]", "[[constraint]", {"V009": "a bracket ] is missing"}),
    ("cos(phi1) = 0", "math.cos(phi1) = 0", {"V122": "a function stands alone: cos(phi)"}),
]


@pytest.mark.parametrize(("right", "wrong", "told"), SLIPS, ids=[wrong.strip() or "none" for _, wrong, _ in SLIPS])
def test_a_slip_is_told_by_one_sentence_with_what_to_write(right: str, wrong: str, told: dict[str, str]) -> None:
    assert right in TEMPLATE
    with pytest.raises(coursework.InputError) as caught:
        coursework.parse_variant(TEMPLATE.replace(right, wrong))
    assert sorted(fault.code for fault in caught.value.faults) == sorted(told)
    for fault in caught.value.faults:
        assert told[fault.code] in str(fault.message)


@pytest.mark.parametrize(("line", "told"), [
    ("a = { x = 1, x = 2 }", "this key occurs twice"), ("[[a.b]]\n[a]\nb.c = 1", "this key or section occurs twice"),
    ('a = "\\ud800"', "a backslash in a text is written twice"), ('a = "\\uzzzz"', "a backslash in a text is written twice"),
    ("a = '''b", "a quotation mark ' is missing"), ("# \x01", "a text contains a letter that does not print"),
    ("a = 2021-02-30", 'a number, or a text in quotation marks " ", was expected'),
])  # fmt: skip
def test_what_is_no_toml_is_told_in_words_of_the_tool_and_not_of_the_reader(line: str, told: str) -> None:
    with pytest.raises(coursework.InputError, match=rf"^V009 .*: {re.escape(told)}"):
        coursework.parse_variant(f"format = 1\n{line}\n")


@pytest.mark.parametrize(("name", "right", "wrong", "told"), [
    ("slider-crank-equations", '"m/s"', '"Hz"', "V110 .*unknowns.u: Hz does not say whether turns"),
    ("slider-crank-equations", '"m/s"', '{ unit = "m/s", of = 3 }', "V015 .*unknowns.u.of: a text in quotation marks"),
    ("four-bar", '["r2", "r3"]', '["r2", "r3"]\nguides = [{ through = "A", angle = "0" }]', "V343 .*found 1.. Take guides out"),
    ("four-bar", 'w1 = "n"', "w1 = [1]", "V015 .*drive.w1: a formula in quotation marks, .* or .* was expected"),
    ("four-bar", '"0 deg"', "[]", "V015 .*coordinates.phi1.start: .value unit., .* or a number was expected"),
    ("four-bar", "format = 1", "format = 1\nask = 3", "V015 .*ask: a section of lines key = value was expected, found 3"),
])  # fmt: skip
def test_what_has_another_form_is_told_alone(name: str, right: str, wrong: str, told: str) -> None:
    with pytest.raises(coursework.InputError, match=f"^{told}") as caught:
        coursework.parse_variant(mechanism(name, (right, wrong)))
    assert len(caught.value.faults) == 1


def test_an_acceleration_for_a_drive_is_told_as_that() -> None:
    with pytest.raises(coursework.InputError, match=r"V404 .*Nothing is moved by eps1 .* a velocity, such as w1; for an acceler"):
        assert coursework.solve(coursework.parse_variant(mechanism("slider-crank-loop", ("w1 =", "eps1 =")))).motion


def test_one_drive_too_many_for_a_chain_is_told_as_that() -> None:
    both = SHAPER.replace('w1 = "n"', 'w1 = "n"\nw3 = "n"')
    with pytest.raises(coursework.InputError, match="w1 and w3 are prescribed, but the mechanism has only 1 degree of freedom"):
        assert coursework.solve(coursework.parse_variant(both)).motion


def test_a_wrong_angle_in_a_closure_is_not_a_drive_too_many() -> None:
    """Both sides of the loop of a five-bar robot with two motors have the forearm at phi3; nothing is left that moves phi4."""
    starts = "".join(f'phi{k} = {{ start = "{60 * k} deg", rate = "w{k}" }}\n' for k in (1, 2, 3, 4))
    text = (
        f'[given]\nl = "0.3 m"\n[drive]\nw1 = "0.7 rad/s"\nw2 = "cos(t)"\n[coordinates]\n{starts}[time]\nstep = "0.1 s"\n'
        'end = "1 s"\n[[constraint]]\nclosure = "l @ phi1 + l @ phi3 = (l, 0) + l @ phi2 + l @ phi3"'
    )
    said = r":15  .*Equation 1y contradicts .* Missing: something for w3 and w4"
    with pytest.raises(coursework.InputError, match=said) as told:
        assert coursework.solve(coursework.parse_variant(text)).motion
    assert "prescribed" not in str(told.value)
    with pytest.raises(coursework.InputError, match=r"^V312 .* No closed position lies near it"):  # now it is open as well
        assert coursework.solve(coursework.parse_variant(text.replace('"120 deg"', '"90 deg"'))).motion


def test_one_velocity_that_two_equations_contradict_is_told_in_the_singular() -> None:
    text = mechanism("four-bar-loop", ('w1 = "n"', 'w1 = "n"\nw2 = "n"'))
    with pytest.raises(coursework.InputError, match=r"V403 .*1 unknown velocity \(w3\) and 1 independent equation of 2\."):
        assert coursework.solve(coursework.parse_variant(text)).motion


@pytest.mark.parametrize(
    ("name", "point", "written"),
    [("31", "D", '"(0, 0)"'), ("example-3", "F", '"(xF, yF)"'), ("jansen", "Y", '"(0, 0)"'), ("v105", "O", '"(xO, yO)"')],
)
def test_a_forgotten_pivot_is_one_fault_with_the_line_to_add(name: str, point: str, written: str) -> None:
    right = coursework.load(name).path.read_text(encoding="utf-8")
    wrong = re.sub(rf"(?m)^{point} += .*\n", "", right, count=1)
    with pytest.raises(coursework.InputError) as caught:
        coursework.parse_variant(wrong)
    (fault,) = caught.value.faults
    assert str(fault.message).endswith(f"Write its place in [points]: {point} = {written}")
    (mend,) = mends_of([fault], wrong.split("\n"))
    assert mend is not None
    mended = wrong.split("\n")
    mended[mend["line"] - 1] += mend["text"]
    assert point in dict(coursework.parse_variant("\n".join(mended)).points)


def test_a_speed_is_no_rate_of_a_link():
    """The slider of a crank: v is how fast x grows."""
    text = mechanism("jack", ("[frame]", '3 = { points = ["E"], rate = "vx" }\n[frame]'))
    told = [str(one.sentence) for one in coursework.parse_variant(text).plausibility]
    assert [one[:77] for one in told] == ["the rate of link 3 is how fast it turns, and vx is how fast x grows, in m/s. "]
    assert not coursework.parse_variant(text.replace('rate = "vx" }\n[frame]', 'rate = "w2" }\n[frame]')).plausibility
