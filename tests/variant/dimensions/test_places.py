"""Where a formula of the geometry stands is told with the number of its rail, its circle, its group and its entry, from 1."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from coursework import load
from coursework.variant.record.places import _geometry


@pytest.mark.parametrize("name", ["31", "epicyclic", "example-6", "prp"])
def test_each_place_is_told_by_the_numbers_of_its_parts(name: str) -> None:
    """Every list twice, so that there are second ones; what holds is told without a number."""
    read = load(name)
    frame = replace(read.frame, rails=read.frame.rails * 2, circles=read.frame.circles * 2)
    numbered = 0
    for place in _geometry(replace(read, frame=frame, groups=read.groups * 2)):
        numbers = [part + 1 for part in place.path if isinstance(part, int)]
        if numbers and place.path[1] != "holds":
            told = [int(one) for one in re.findall(r"\d+", str(place.label))]
            assert sorted(told) == sorted(numbers), (place.path, str(place.label))
            numbered += max(numbers) > 1
    assert numbered >= 2
