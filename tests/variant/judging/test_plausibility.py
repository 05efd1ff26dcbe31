"""Remarks: what looks like a slip of the pen is told with its line, and changes no status."""

import json
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from coursework.api import make_run
from coursework.commands.cli import main
from coursework.variant.judging.plausibility import _nearer
from coursework.variant.reading.reader import parse_variant
from coursework.words.data_folders import folder
from tests.mechanisms.library import mechanism

PAGE = (Path(__file__).parents[2] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")


def rewritten(*pairs):
    text = PAGE
    for plain, other in pairs:
        assert plain in text, plain
        text = text.replace(plain, other)
    return text


def remarks(*pairs):
    """Return code, line and sentence of each remark on variant 31 with something rewritten."""
    return [(remark.code, remark.line, str(remark.sentence)) for remark in parse_variant(rewritten(*pairs)).plausibility]


def line_of(begin):
    return next(number for number, line in enumerate(PAGE.split("\n"), start=1) if line.startswith(begin))


@pytest.mark.parametrize(
    ("written", "other", "begin", "told"),
    [
        ('"4.35 rad"', '"249.2 rad"', "alpha", [("ANGLE", "alpha = 249.2 rad is 39.7 turns; 249.2 deg?")]),
        ('"4.35 rad"', "249.2", "alpha", [("ANGLE", "alpha = 249.2 rad is 39.7 turns; 249.2 deg?")]),  # told once
        (
            '"V1*sin(p*t + alpha)"', '"V1*sin(p*t + 249.2)"', "VMy",
            [("ANGLE", "in VMy, 249.2 rad is 39.7 turns; 249.2 deg?")],
        ),
        ('"V1*sin(p*t + alpha)"', '"V1*sin(p*t + 6.28)"', "VMy", []),
        ('"V1*sin(p*t + alpha)"', '"V1*sin(p*t + 6.29)"', "VMy", [("ANGLE", "in VMy, 6.29 rad is 1 turn; 6.29 deg?")]),
        ('"1.63 rad"', '"193 rad"', "phi1", [("ANGLE", "phi1 = 193 rad is 30.7 turns; 193 deg?")]),
        ('"1.63 rad"', "93.4", "phi1", [("ANGLE", "phi1 = 93.4 rad is 14.9 turns; 93.4 deg?")]),
        ('"1.63 rad"', "1.63", "phi1", [("NO-UNIT", "phi1 = 1.63 has no unit, other data have one; it is read as 1.63 rad.")]),
        ('"0.953 m"', '"953 m"', "r1", [("LENGTH", "r1 = 953 m beside 0.847 m: 953 mm?")]),
        ('"0.953 m"', '"0.953 mm"', "r1", [("LENGTH", "r1 = 0.953 mm beside 0.457 m: 0.953 m?")]),
        ('"0.953 m"', '"953 м"', "r1", [("LENGTH", "r1 = 953 м beside 0.847 m: 953 мм?")]),
        ('"0.953 m"', '"0.0001 m"', "r1", [("LENGTH", "r1 = 0.0001 m beside 0.457 m: is the number right?")]),
        ('"0.953 m"', "953", "r1", [("LENGTH", "r1 = 953 m beside 0.847 m: 953 mm?")]),
        ('"0.953 m"', "0.953", "r1", [("NO-UNIT", "r1 = 0.953 has no unit, other data have one; it is read as 0.953 m.")]),
        ('"13.08 1/s"', "13.08", "p ", [("NO-UNIT", "p = 13.08 has no unit, other data have one; it is read as 13.08 rad/s.")]),
        ('"4.35 rad"', '"249.2 grad"', "alpha", [("GRAD", "grad is read as degrees: 249.2 grad is 249.2 deg.")]),
        (
            '"V1*sin(p*t + alpha)"', '"V1*sin(t)"', "VMy",
            [("TIME-AS-ANGLE", "in sin(t) the time in s stands for an angle in rad; is a factor in rad/s missing?")],
        ),
        (
            "r3*w3*cos(phi3) + 0.5*r3*w4 =", "r3*w3*cos(phi3) + 0.5*w4 =", 'equation = "2*r3*w3*sin',
            [("NUMBER", "the number in 0.5*w4 would have to be in m for constraint 12 to hold; is a factor missing?")],
        ),
    ],
)  # fmt: skip
def test_told(written, other, begin, told):
    found = [one for one in remarks((written, other)) if one[0] != "UNUSED"]  # a formula of numbers leaves data without a place
    assert found == [(code, line_of(begin), sentence) for code, sentence in told]


@pytest.mark.parametrize(
    ("written", "other"),
    [
        ('"4.35 rad"', '"6.2831853071 rad"'),
        ('"4.35 rad"', '"249.2 deg"'),
        ('"4.35 rad"', '"249.2 град"'),
        ('"1.63 rad"', '"-6.28 rad"'),
        ('"0.953 m"', '"25.4 m"'),  # 29.99 times its neighbour
        ('"0.953 m"', '"0.0153 m"'),
        ("2*r3*w3*sin(phi3)", "2*1*r3*w3*sin(phi3)"),
        ("0.5*r3*w4 + r3", "0.5*(r3*w4) + r3"),
        ('"1.63 rad"', "0"),
        ('end       = "0.48 s"', 'end = "8 min"'),
    ],
)
def test_just_inside_nothing_is_told(written, other):
    assert remarks((written, other)) == []


@pytest.mark.parametrize(
    ("written", "other", "code"),
    [('"4.35 rad"', '"6.2831853072 rad"', "ANGLE"), ('"0.953 m"', '"25.42 m"', "LENGTH"), ('"0.953 m"', '"0.0152 m"', "LENGTH")],
)
def test_just_outside_it_is(written, other, code):
    assert [remark[0] for remark in remarks((written, other))] == [code]


def test_of_two_sides_of_a_gap_the_smaller_is_named():
    both = remarks(('"0.953 m"', '"953 m"'), ('"0.847 m"', '"847 m"'))
    assert [(code, sentence) for code, _, sentence in both] == [("LENGTH", "r3 = 0.457 m beside 847 m: is the number right?")]


BARE = [('"0.953 m"', "0.953"), ('"0.847 m"', "0.847"), ('"0.457 m"', "0.457"), ('"4.5 m/s"', "4.5"), ('"13.08 1/s"', "13.08"),
        ('"4.35 rad"', "4.35")]  # fmt: skip


def test_where_no_datum_carries_a_unit_a_slip_is_only_remarked():
    told = remarks(*BARE, ("r2*w2*sin(phi2)", "r2*sin(phi2)"))
    assert told == [
        (
            "NO-UNIT",
            line_of('equation = "r3*w3*sin'),
            "no datum carries a unit, and in constraint 18 the parts r3*w3*sin(phi3) and r2*w2*cos(phi2) cannot be of "
            "the same dimension; is a factor missing?",
        )
    ]


def test_a_datum_without_a_unit_is_told_what_it_is_read_as():
    assert [sentence.rpartition(" as ")[2] for _, _, sentence in remarks(*BARE)] == [
        "0.953 m.", "0.847 m.", "0.457 m.", "4.5 m/s.", "13.08 rad/s.", "4.35 rad.",
    ]  # fmt: skip


def test_remarks_stand_in_the_record_on_the_console_and_on_the_first_page(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("mine.toml").write_text(rewritten(('"4.35 rad"', '"10.6331853072 rad"')), encoding="utf-8")
    result = CliRunner().invoke(main, ["run", "mine.toml", "--quantities", "table", "--format", "html,csv", "--out", "out"])
    assert result.exit_code == 0, result.output
    line = line_of("alpha")
    sentence = "alpha = 10.6331853072 rad is 1.69 turns; 10.6331853072 deg?"
    record = json.loads(Path("out/run.json").read_text(encoding="utf-8"))
    assert record["remarks"] == [{"code": "ANGLE", "line": line, "sentence": sentence}]
    assert f"ANGLE: Remark on line {line} of the file: {sentence}" in result.output
    page = Path("out/report.html").read_text(encoding="utf-8")
    assert f"Remark on line {line} of the file" in page
    checked = CliRunner().invoke(main, ["check", "mine.toml"])
    assert checked.exit_code == 0
    assert f"ANGLE: Remark on line {line} of the file: {sentence}" in checked.output


def test_a_remark_on_a_value_that_was_set_blames_no_line_of_the_file():
    bare = parse_variant(rewritten()).with_data({"alpha": "-25 rad"})
    (remark,) = bare.plausibility
    assert (remark.code, remark.line) == ("ANGLE", 0)
    assert str(remark.told) == "Remark on a value that was set: alpha = -25 rad is 3.98 turns; -25 deg?"
    assert str(bare.with_data({"r1": "953 m"}).plausibility[0].told).startswith("Remark on a value that was set: r1")
    typed = parse_variant(rewritten(('"4.35 rad"', '"10.6331853072 rad"'))).with_data({"V1": "4.4 m/s"})
    assert [one.line for one in typed.plausibility] == [line_of("alpha")]


def test_lengths_whose_quotient_is_no_number_are_told():
    told = remarks(('"0.953 m"', '"1e-312 m"'), ('"0.847 m"', '"1e11 m"'), ('"0.457 m"', '"2e11 m"'))
    assert [code for code, _, _ in told] == ["LENGTH"]


def test_links_of_a_chain_that_the_file_leaves_out_are_told():
    whole = (folder("variants") / "chebyshev.toml").read_text(encoding="utf-8")
    lines = whole.split("\n")
    place = next(k for k, line in enumerate(lines) if line.startswith("[links]"))
    told = parse_variant("\n".join(line for line in lines if not line.startswith(("1 = {", "3 = {")))).plausibility
    assert [(remark.code, remark.line) for remark in told] == [("LINKS", place + 1)]
    assert "has w1, w3 as its rate" in str(told[0].sentence)
    assert not parse_variant(whole).plausibility
    assert not parse_variant("\n".join(line for line in lines if " = { points" not in line and line != "[links]")).plausibility


def test_a_number_read_in_a_measure_that_has_no_unit_of_its_own_is_read_in_si():
    """An area: of lengths, angles, times and speeds the unit is named."""
    told = remarks(("[given]", "[given]\narea = 2"), ("r1*w1*cos(phi1)", "r1*w1*cos(phi1)*area/r1^2"))
    assert [(code, sentence) for code, _, sentence in told if "area" in sentence] == [
        ("NO-UNIT", "area = 2 has no unit, other data have one; it is read as 2 SI.")
    ]


def test_a_drive_that_stands_nowhere_is_told_unless_it_is_zero():
    assert remarks(("[drive] ", '[drive]\nVNx = "V1"\nVNy = "0"\n#')) == [
        (
            "IDLE",
            line_of("[drive]") + 1,
            "VNx of [drive] moves nothing: no coordinate has it as its rate, and no equation contains it.",
        )
    ]


def test_a_guide_through_a_point_that_no_link_has_is_told():
    begin = line_of("rails")
    told = "no link has the point D2, so nothing slides in the guide through it. Write the point that slides there"
    told += ", or give D2 to the link that slides."
    other = ('through = "P"', 'through = "D2"'), ('D = "(0, 0)"', 'D = "(0, 0)"\nD2 = "D + (r1, 0)"')
    assert ("GUIDE", begin + 1, told) in remarks(*other) and remarks() == []


def test_a_wheel_of_which_it_is_not_shown_what_it_rolls_on_is_told():
    told = remarks(('rails  = [ { through = "P", angle = "0" } ]', ""))
    assert [(code, line) for code, line, _ in told] == [("CONTACT", line_of("4 = { wheel"))]
    assert "the file does not list what wheel 4 touches at P" in told[0][2]


def test_a_guide_through_a_hinge_of_the_frame_is_one_that_begins_there():
    assert not any(code == "GUIDE" for code, _, _ in remarks(('through = "P"', 'through = "D"')))


def test_a_datum_that_no_formula_has_is_told_unless_it_is_zero():
    """As where r2 is written twice and r3 nowhere."""
    told = remarks(("[given]", '[given]\nspare = "0.4 m"\nlevel = "0 m"'))
    assert told == [
        ("UNUSED", line_of("[given]") + 1, "spare appears in no formula of the file. Is another name written in its place?")
    ]


def test_the_unit_advised_is_that_of_the_usual_length_and_not_of_the_least() -> None:
    """Beside an offset of 0.05 m, 0.62 mm as centimetres would be near; but most lengths are like 0.62 m."""
    text = mechanism("31", ('alpha = "4.35 rad"', 'alpha = "4.35 rad"\ne = "0.05 m"'), r3="0.62 mm")
    (told,) = (str(one.sentence) for one in parse_variant(text).plausibility if one.code == "LENGTH")
    assert told == "r3 = 0.62 mm beside 0.05 m: 0.62 m?"


@pytest.mark.parametrize(("travel", "told"), [
    ("2 mm", []), ("0.5 m", []), ("50 m", ["a = 50 m beside 0.3 m: 50 mm?"]),
])  # fmt: skip
def test_a_travel_of_a_drive_may_be_short_beside_the_links(travel: str, told: list[str]) -> None:
    """No link is short because a slider moves little; one that moves far past all links is a slip."""
    text = mechanism("driven-slider", ("a*p*sin(p*t)", "a*p*sin(p*t) + b*p*cos(p*t)"), a=travel).replace(
        "[drive]", 'b = "1 mm"\n[drive]'
    )
    assert [str(one.sentence) for one in parse_variant(text).plausibility if one.code == "LENGTH"] == told


@pytest.mark.parametrize(("step", "told"), [
    ("0.02 s", []), ("0.0200000000005 s", []), ("0.03 s", []),
    ("0.05 s", [(34, "the last row is at t = 0.45 s: the step does not lead to the requested end, 0.48 s")]),
    ("0.020000000001 s", [(34, "the last row is at t = 0.46 s: the step does not lead to the requested end, 0.48 s")]),
])  # fmt: skip
def test_an_end_to_which_the_step_does_not_lead_is_told(step: str, told: list[tuple[int, str]]) -> None:
    variant = parse_variant(mechanism("31", step=step))
    assert [(one.line, str(one.sentence)) for one in variant.plausibility if one.code == "END"] == told
    assert not [one for one in variant.timed(0.04).plausibility if one.code == "END"]
    run = make_run(variant)
    assert list(run.remarks) == list(run.slips) == [sentence for _, sentence in told]


def test_a_negative_ordinate_that_no_equation_contains_is_no_length_of_a_link() -> None:
    text = mechanism("slider-crank-equations", ("[given]", '[given]\nyD = "-0.1 m"'))
    assert not [one for one in parse_variant(text).plausibility if one.code == "LENGTH"]


@pytest.mark.parametrize("points", ['["D", "B"]', '["D", "A", "B"]'])
def test_a_block_that_is_pinned_to_its_guide_cannot_slide(points):
    variant = parse_variant(mechanism("shaper-equations", ('3 = { points = ["D", "B"]', f"3 = {{ points = {points}")))
    told = [str(remark.sentence) for remark in variant.plausibility]
    assert any(one.startswith("link 2 slides along link 3, but both hold A: pinned there,") for one in told) is ("A" in points)


def test_data_of_a_place_are_told_with_the_point_that_they_place() -> None:
    """As where the second pivot is written along the chain, and its coordinates stand beside it."""
    along = ('D = "(xD, yD)"', 'D = "B - r3 @ phi3"'), ('G = "(xG, yG)"', 'G = "E - r5 @ phi5"')
    wiper = mechanism("windshield-wiper", *along, holds=None)
    found = [str(remark.sentence) for remark in parse_variant(wiper).plausibility]
    assert found == [
        f"x{one} and y{one} appear in no formula of the file. If they say where {one} is, "
        f'write {one} = "(x{one}, y{one})" in [points].'
        for one in "DG"
    ]


@pytest.mark.parametrize(("text", "unit", "better"), [
    ("800", "m", "mm"), ("80", "m", "cm"), ("0.8", "mm", "m"), ("0.8", "cm", "m"), ("-80", "m", "cm"), ("−80", "мм", "см"),
    ("800", "м", "мм"), ("0.8", "", ""), ("0.8", "m", ""), ("23900", "m", "mm"), ("24100", "m", ""),
    ("0.0267", "mm", "m"), ("0.0266", "mm", ""), ("800", "km", "mm"),
])  # fmt: skip
def test_a_unit_is_advised_that_brings_a_number_within_thirty_times_the_usual_length(text: str, unit: str, better: str) -> None:
    """The usual length is 0.8 m; 24 m and 2.67 cm are thirty times as long and as short."""
    assert _nearer(SimpleNamespace(text=text, unit=unit), SimpleNamespace(value=-0.8), ()) == better


@pytest.mark.parametrize(
    ("text", "written", "better"), [("45", "cm", "cm"), ("45", "mm", "mm"), ("45", "ft", "mm"), ("800", "cm", "mm")]
)
def test_a_unit_of_the_others_is_advised_first_if_it_brings_the_number_near(text: str, written: str, better: str) -> None:
    """Beside 12 cm, 45 mm would be a little nearer than 45 cm; 800 cm is more than thirty times as long."""
    assert _nearer(SimpleNamespace(text=text, unit=""), SimpleNamespace(value=0.12), {written}) == better


def test_a_factor_that_turns_a_speed_once_more_is_told_with_its_equation():
    text = mechanism("slider-crank-equations", ("-r*w1*sin(phi1)", "-r*n*pi/30*sin(phi1)"), ("[given]", '[given]\nn = "60 rpm"'))
    (told,) = parse_variant(text).plausibility
    assert (told.code, told.line) == ("RPM", text.splitlines().index('name = "x"') + 3)
    assert "n = 60 rpm is already in rad/s; in constraint x the factor in r*n*pi/30*sin(phi1) turns it once more" in told.sentence


@pytest.mark.parametrize(("place", "stands"), [("(r, 0)", True), ("B + (r, 0)", False), ("C + (r, 0)", False)])
def test_a_point_of_a_link_that_stands_still_is_told_as_a_pivot_and_none_that_goes_with_a_group(place: str, stands: bool) -> None:
    links = '[links]\n1 = { points = ["A", "B"], rate = "w1" }\n2 = { points = ["B", "C", "E"], rate = "w2" }\n[frame]'
    text = mechanism("slider-crank", ('A = "(0, 0)"', f'A = "(0, 0)"\nE = "{place}"'), ("[frame]", links))
    assert any(one.code == "PIVOT" for one in parse_variant(text).plausibility) is stands
