"""A spring or a damper between two points that keep their distance is remarked on, whatever holds them together."""

import pytest

import coursework
from tests.mechanisms.library import mechanism


@pytest.mark.parametrize(
    ("name", "ends", "idle"),
    [
        ("pendulum", '["B", "K"]', ""),
        ("pendulum", '["B", "O"]', "B and O"),  # both on the rod
        ("pendulum", '["K", "O"]', "K and O"),  # both on the frame
        ("andrews-forces", '["S", "K"]', ""),
        ("block-on-a-spring", '["O", "C"]', ""),
    ],
)
def test_a_spring_that_never_changes_its_length_is_told(name: str, ends: str, idle: str) -> None:
    """In andrews-forces both ends move; the place of K follows from two coordinates."""
    own = {"pendulum": '["B", "K"]', "andrews-forces": '["S", "K"]', "block-on-a-spring": '["O", "C"]'}[name]
    variant = coursework.parse_variant(mechanism(name, (f"spring = {own}", f"spring = {ends}")))
    told = [str(one.sentence) for one in variant.plausibility if one.code == "IDLE"]
    assert len(told) == bool(idle) and all(f"of [forces] does nothing: {idle} keep their distance." in one for one in told)


@pytest.mark.parametrize(("times", "told"), [(29.99, []), (30.01, ["s.free = 24.008 m beside 0.8 m: is the number right?"])])
def test_the_free_length_of_a_spring_is_held_against_the_longest_length(times, told):
    own = ("[coordinates]", 'L = "0.8 m"\n[coordinates]'), ("0.6 @ phi", "L @ phi")
    text = mechanism("pendulum", *own, ('free = "0.4 m"', f'free = "{0.8 * times} m"'))
    assert [str(remark.sentence) for remark in coursework.parse_variant(text).plausibility] == told
