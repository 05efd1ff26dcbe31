"""Equations in braces on one line, with units inside, in degrees and minutes, and behind the dashes of a list."""

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for
from coursework.grading.reading.equations.formulas.plain_text import of_units
from coursework.grading.reading.equations.notation.degrees import with_factors
from coursework.grading.reading.equations.systems.parts import parts_of
from coursework.grading.reading.equations.text.slashes import parted_at_slashes
from tests.grading.reading.equations.notation.test_notations import PLAIN, marked
from tests.grading.scenes import expected

LINES = PLAIN.split("\n")
WRONG = [*LINES[:3], LINES[3].replace("- r1", "+ r1")]
BRACES = {
    "semicolons": lambda e: "{" + "; ".join(e) + "}",
    "blanks inside": lambda e: "{ " + "; ".join(e) + " };",
    "parentheses": lambda e: "(" + "; ".join(e) + ")",
    "and": lambda e: "{" + " and ".join(e) + "}",
    "a system": lambda e: "System: {" + ", ".join(e) + "}",
    "two systems": lambda e: "; ".join("{" + "; ".join(pair) + "}" for pair in (e[:2], e[2:])),
    "named": lambda e: "eqs = [" + "; ".join(e) + "]",
    "latex": lambda e: r"\left\{" + r"; ".join(e) + r"\right\}",
}
METRES, BRACKETS = (
    {"r1": "0,953 м", "r2": "0.847 m", "r3": "457 mm"},
    {"r1": "r1[m]", "r2": "r2 [м]", "r3": "r3[m]", "w1": "w1 [1/s]"},
)
MINUTES = ("90°0'", "89°60'0\"", r"90^\circ 0'", "90° 00′ 00″")


def other(line, names):
    for old, new in names.items():
        line = line.replace(old, new)
    return line


@pytest.mark.parametrize("form", BRACES)
def test_each_equation_of_a_system_in_braces_counts(form):
    assert marked(BRACES[form](LINES)).share == 1.0
    found = marked(BRACES[form](WRONG))
    assert (found.independent, [mark.line.text.partition(" ")[0] for mark in found.wrong]) == (3, ["r3*w3*sin(phi3)"])


def test_braces_without_end_are_no_system_and_are_bounded():
    deep = "{" * 9000 + "w1 = w2; w3 = w4" + "}" * 9000
    assert parts_of(deep) == [deep]
    assert len(parts_of("{w1 = w2; w3 = w4};" * 900)) > 2
    assert parts_of("fsolve({w1 = w2, w3 = w4}, {w1 = 0..5})") == ["w1 = w2", "w3 = w4"]


@pytest.mark.parametrize("units", [METRES, BRACKETS])
def test_units_inside_an_equation_are_no_names(units):
    found = marked("\n".join(other(line, units) for line in LINES))
    assert found.share == 1.0, [(mark.line.text, mark.verdict) for mark in found.marks]
    wrong = other(WRONG[3], units)
    mark = marked("\n".join([*(other(line, units) for line in LINES[:3]), wrong])).marks[3]
    assert (mark.verdict, mark.hint.kind, mark.hint.column) == ("wrong", "sign", wrong.index("+") + 1)


def test_a_number_with_a_unit_is_one_number_in_si():
    assert of_units("VMy/457 mm + 2*0.5 [m/s] + 3·рад") == "VMy/((457)*0.001) + 2*0.5 + 3"
    assert of_units("2 m1 + 0.5 cos(w3) + 3*w2 + r3[k]") == "2 m1 + 0.5 cos(w3) + 3*w2 + r3[k]"
    assert marked("w3 = VMy/457 mm/(2*cos(phi3) + sin(phi3))").marks[0].verdict == "right"


@pytest.mark.parametrize("angle", MINUTES)
def test_angles_may_be_in_degrees_and_minutes(angle):
    line = f"VMy - 2*r3*w3*cos(phi3) + r3*w3*cos(phi3 + {angle}) = 0"
    assert marked(line).marks[0].verdict in {"right", "rounded"}
    assert marked(line.replace("+ r3", "- r3")).marks[0].verdict == "wrong"
    assert len(marked(f"alpha = {angle}\n{PLAIN}").marks) == 4


@pytest.mark.long
@pytest.mark.parametrize("mark", ["- {e}", "– {e}", "{i} - {e}", "{i} – {e}", "({i}) - {e}"])
def test_a_dash_means_the_same_in_all_lines(mark):
    """A wrong first sign is not read away by taking the dash of its line alone for a minus."""

    def written(lines):
        return "\n".join(mark.format(i=place, e=line) for place, line in enumerate(lines, start=1))

    assert marked(written(LINES)).share == 1.0
    turned = [line[1:] if line.startswith("-") else f"-{line}" for line in LINES]
    for place, line in enumerate(turned):
        found = marked(written([*LINES[:place], line, *LINES[place + 1 :]]))
        assert (found.independent, found.different) == (3, 1), line


def test_a_dash_before_every_line_may_be_its_minus():
    signs = str.maketrans("+-", "-+")
    minus = [f"- {line.translate(signs)}" for line in (LINES[0], LINES[1], LINES[3])]
    found = marked("\n".join([*minus, "- 0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0"]))
    assert found.share == 1.0


@pytest.mark.parametrize("marks", ["----", "–––––", ("- ", "-", "- ", "-"), ("-", "-", "-", "- ")])
def test_a_dash_with_no_blank_behind_it_in_every_line_marks_them(marks):
    """The first line alone was right with its dash as a minus, and of the whole list 10 points of 40 were left."""
    written = [f"{mark}{line}" for mark, line in zip(marks, LINES, strict=False)]
    assert marked("\n".join(written)).share == 1.0
    turned = [f"{mark}{line}" for mark, line in zip(marks, WRONG, strict=False)]
    found = marked("\n".join(turned))
    assert (found.independent, found.different) == (3, 1)


def test_minus_signs_that_begin_all_lines_are_no_marks_for_that():
    signs = str.maketrans("+-", "-+")
    minus = [f"-{line.translate(signs)}" for line in (LINES[0], LINES[1], LINES[3])]
    found = marked("\n".join([*minus, LINES[2]]))
    assert LINES[2].startswith("-") and found.share == 1.0
    found = marked("\n".join([*minus, LINES[2].replace("-", "", 1)]))  # the last line has no dash: all others have their minus
    assert [mark.verdict for mark in found.marks] == ["right", "right", "right", "wrong"]


@pytest.mark.parametrize("places", ["3", "13", "013"])
def test_a_dash_that_may_be_a_minus_or_a_mark_is_a_question(places):
    """It was taken for a minus, and a right equation was wrong; behind no blank, -0.5*r3, it is one."""
    dashed = [f"- {line}" if str(place) in places else line for place, line in enumerate(LINES)]
    found = marked("\n".join(dashed))
    asked = [mark.verdict == "unreadable" and mark.hint.fault.code for mark in found.marks]
    assert any(asked) and {*asked} <= {False, "G068"} and not found.wrong and found.unread is not None
    signs = str.maketrans("+-", "-+")
    minus = [f"- {line.translate(signs)}" if line in LINES[:2] else line for line in LINES]  # with a minus they are right
    assert marked("\n".join(minus)).share == 1.0
    assert [mark.verdict for mark in marked("\n".join([*LINES[:3], f"-{LINES[3]}"])).marks] == ["right"] * 3 + ["wrong"]


def test_equations_may_be_parted_by_slashes_and_a_remark_behind_them_is_none():
    """Of four in a line one was left, and nobody was told."""
    assert marked(" // ".join(LINES)).share == 1.0
    assert len(marked("//".join(WRONG)).wrong) == 1
    for remark in ("w3 = 6.28", "projection on x", "VMy = V1*sin(p*t + alpha)"):
        assert len(marked("\n".join(f"{line} // {remark}" for line in LINES)).marks) == 4


@pytest.mark.parametrize("line", [
    "r1*w1 = VMy ¦ r2*w2 = V1", "r1*w1 = VMy ¦ r2*w2 = V1 ¦ r3*w3 = VMy", "r1*w1 = 0 ¦ r2*w2 = V1",
    "r1*w1 - VMy = 0 ¦ r2*w2 = V1",
    "r1*w1 = r2 ¦ r3*w3 = VMy",  # neither has one unit: each may be an equation
    "w1 = VMy / r2 = w3", "r1*w1 = VMy / r2", "r1*w1 = r1*VMy / r2 = w2*r2", "r1*w1 = (VMy / r2)*r2 = w2*r2",
    "r1*w1 = VMy / r2 = 3", "r1*w1 = VMy / r2 and r3",  # what stands behind is no equation for a velocity
    "0 = r1*w1 - VMy ¦ r2*w2 = V1", "r1*w1 - VMy = w4*r1 ¦ 0 = r2*w2 - V1", "r1*w1 = 0 ¦ w2 = VMy / r2 = w3",
])  # fmt: skip
@pytest.mark.parametrize("sign", ["/", "•", "·"])
def test_a_slash_parts_equations_where_it_cannot_divide(line, sign):
    """The velocities are w1 to w4, lengths r1 to r3, speeds V1 and VMy."""
    if sign == "/" or "/" not in line:
        assert parted_at_slashes(line.replace("¦", sign), names_for(expected())) == line.replace(" ¦", ";")


@pytest.mark.parametrize(("written", "means"), [
    ("cosd phi3 + r2*sind 30 - w1", "cos((pi/180)*phi3) + r2*sin((pi/180)*30) - w1"),
    ("cosd90*b", "cos((pi/180)*90)*b"), ("tand(a)*x", "tan((pi/180)*(a))*x"), ("sind (a*(b+c))*d", "sin((pi/180)*(a*(b+c)))*d"),
    ("r3*sin_deg(phi1 + pi) - cosdeg(a) = 0", "r3*sin((pi/180)*(phi1 + pi)) - cos((pi/180)*(a)) = 0"),
    ("sin(a deg)*b", "sin((a*pi/180))*b"), ("sin(a Degree + 30)", "sin((a*pi/180) + 30)"), ("sind(a + b", "sin((pi/180)*(a + b)"),
])  # fmt: skip
def test_functions_of_degrees_take_just_what_is_theirs(written, means):
    assert with_factors(written) == means


@pytest.mark.parametrize("sign", ["# ", "// ", "% ", "## "])
def test_equations_in_comments_are_read_where_no_others_are(sign):
    assert marked("\n".join(f"{sign}{line}" for line in LINES)).share == 1.0
    beside = marked("\n".join([*LINES[:2], f"{sign}{WRONG[3]}"]))  # equations are missing, and the comment may hold one
    assert [mark.verdict for mark in beside.marks] == ["right", "right", "unreadable"] and beside.different == 0
