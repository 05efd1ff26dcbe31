"""A link whose rate is another's, or whose wheel would slip, is told by name; a sense counted clockwise is none of that."""

import pytest

import coursework
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import changed, mechanism

# A four-bar whose angles are counted clockwise.
CLOCKWISE = mechanism("clockwise-four-bar")
MASSES = '[masses]\n2 = { mass = "1 kg", inertia = "rod" }\n'


def closure(text, *slips):
    return coursework.solve(parse_variant(changed(text, *slips), "mine")).scene.closure


@pytest.mark.parametrize(
    ("text", "link", "slips"),
    [
        (mechanism("chebyshev"), "2", [('"P"], rate = "w2"', '"P"], rate = "w3"')]),
        (CLOCKWISE, "3", [('["D", "C"], rate = "w3"', '["D", "C"], rate = "w1"')]),
        (CLOCKWISE, "2", [("[ask]", f"{MASSES}[ask]")]),  # forces count a rate as vectors do
        # The wheel would roll the wrong way: equation and position equation agree, its pin does not.
        (
            mechanism("epicyclic"),
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
