"""A group is fitted to the paths that the points it hangs on have in the file."""

import numpy as np
import pytest

import coursework
from coursework.mechanism.drafts import chain
from coursework.mechanism.drafts.text import text_of
from coursework.mechanism.groups import group_kind


@pytest.mark.long
@pytest.mark.parametrize("swinging", [set(), {1}])
def test_points_go_in_the_file_where_the_groups_on_them_were_fitted(swinging):
    """B = A + r1 at phi1 on the crank, D = C + r3 at phi3 where the dyad meets, over a whole turn or swing."""
    drafting, ends = chain._Drafting(swinging), []
    for name in ("crank", "RRR"):
        drafting.add(group_kind(name))
        ends.append(drafting.waiting[-1])
    places, lengths = drafting.draft.places, drafting.draft.lengths
    motion = coursework.solve(coursework.parse_variant(text_of(drafting.draft, "", str, ["table"])), scheme="exact").motion
    every = len(ends[0].path) // (len(motion.t) - 1)
    for end, (base, length, angle) in zip(ends, (("A", "r1", "phi1"), ("C", "r3", "phi3")), strict=True):
        found = places[base] + lengths[length] * np.exp(1j * motion.column(angle))
        assert np.abs(found[:-1] - end.path[::every]).max() < 1e-9, end.name


@pytest.mark.long
@pytest.mark.parametrize(("taken", "new"), [((), ["A", "C"]), (("A", "B"), ["C", "D"]), (("A", "B", "C", "E"), ["D", "F"])])
def test_a_group_drafted_on_a_point_takes_letters_and_numbers_that_are_free(taken, new):
    """It hangs on B, the pin of a crank; a name of nothing else is left out."""
    crank = chain._Drafting(set())
    crank.add(group_kind("crank"))
    (pin,) = crank.waiting
    (group,) = chain.draft_on("RRR", [pin], {*taken, "B"}, 5).groups
    assert [*group.points, group.meets] == ["B", *new]
    assert [coordinate.name for coordinate in group.coordinates] == ["phi5", "phi6"]
    assert group.lengths == ("r5", "r6")


def test_each_crank_stands_beside_what_was_drawn_last():
    """A pin that goes right round has its pivot in the middle; the next pivot stands four cranks to the right of that."""
    drafting = chain._Drafting(set())
    for _ in range(3):
        drafting.add(group_kind("crank"))
    pivots = [drafting.draft.places[group.points[0]] for group in drafting.draft.groups]
    assert pivots == pytest.approx([0, 4 * chain.CRANK, 8 * chain.CRANK])
