"""What a program of a motion under forces keeps of its positions: a number where it is not nought, nothing where it is."""

import re

import coursework
from coursework.takeaway.listing.by_forces import moving
from tests.effects.moved import free_31


def test_what_positions_keep_is_a_number_of_the_program():
    """Variant 31 keeps how far the end of its chain is from an origin that the file leaves open; a slider keeps its height, 0."""
    for variant, count in ((coursework.parse_variant(free_31()), 1), (coursework.load("example-2-motor"), 0)):
        found = moving(coursework.solve(variant, quantities=["table"], end=0.02))
        kept = {name for name in found.numbers if name.startswith("_kept")}
        used = {name for line in (*found.closing, *found.lines) for name in re.findall(r"_kept\d+", line.text)}
        assert used <= kept and len(kept) == count
        assert all(found.numbers[name] for name in kept) and kept <= {*found.data}
