"""A link whose rate is another's, or whose wheel would slip, is told by name; a sense counted clockwise is none of that."""

import pytest

import coursework
from coursework.variant.reading.reader import parse_variant
from coursework.words.data_folders import folder

# A four-bar whose angles are counted clockwise.
CLOCKWISE = """
[given]
a = "0.1 m"
b = "0.3 m"
c = "0.2 m"
d = "0.32 m"
n = "20 rpm"
[drive]
w1 = "n"
[coordinates]
f1 = { start = "30 deg", rate = "w1" }
f2 = { start = "0.516303664 rad", rate = "w2" }
f3 = { start = "1.432871917 rad", rate = "w3" }
[time]
step = "50 ms"
end = "0.5 s"
[[constraint]]
closure = "C = D + (c*cos(f3), -c*sin(f3))"
[points]
A = "(0, 0)"
D = "(d, 0)"
B = "A + (a*cos(f1), -a*sin(f1))"
C = "B + (b*cos(f2), -b*sin(f2))"
[links]
1 = { points = ["A", "B"], rate = "w1" }
2 = { points = ["B", "C"], rate = "w2" }
3 = { points = ["D", "C"], rate = "w3" }
[frame]
hinges = ["A", "D"]
[ask]
quantities = ["table"]
"""
MASSES = '[masses]\n2 = { mass = "1 kg", inertia = "rod" }\n'


def closure(text, *slips):
    for old, new in slips:
        assert old in text
        text = text.replace(old, new)
    return coursework.solve(parse_variant(text, "mine")).scene.closure


def of(name):
    return (folder("variants") / f"{name}.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "link", "slips"),
    [
        (of("chebyshev"), "2", [('"P"], rate = "w2"', '"P"], rate = "w3"')]),
        (CLOCKWISE, "3", [('["D", "C"], rate = "w3"', '["D", "C"], rate = "w1"')]),
        (CLOCKWISE, "2", [("[ask]", f"{MASSES}[ask]")]),  # forces count a rate as vectors do
        # The wheel would roll the wrong way: equation and position equation agree, its pin does not.
        (
            of("epicyclic"),
            "2",
            [("(R0 - R)*w1 + R*w2", "(R0 - R)*w1 - R*w2"), ("(R0 - R)*phi1 + R*psi2", "(R0 - R)*phi1 - R*psi2")],
        ),
    ],
)
def test_a_link_that_turns_otherwise_than_its_rate_is_named(text, link, slips):
    with pytest.raises(coursework.InputError, match=f"V309 .*link {link} turns at"):
        closure(text, *slips)


def test_the_rate_that_is_meant_is_named_where_another_link_has_it():
    slips = [('["B", "C"], rate = "w2"', '["B", "C"], rate = "w3"'), ('["D", "C"], rate = "w3"', '["D", "C"], rate = "w2"')]
    with pytest.raises(coursework.InputError) as told:
        closure(CLOCKWISE.replace("-a*", "a*").replace("-b*", "b*").replace("-c*", "c*"), *slips)
    assert ['rate = "w2"' in str(fault) for fault in told.value.faults] == [True, False]
    assert ['rate = "w3"' in str(fault) for fault in told.value.faults] == [False, True]


def test_angles_may_be_counted_clockwise():
    assert closure(CLOCKWISE) is not None
