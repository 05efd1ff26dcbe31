"""Matching, order of blocks, over- and under-determined parts against definitions tried out one by one."""

from itertools import combinations, permutations

from hypothesis import given, settings
from hypothesis import strategies as st

from coursework.equations.reduction.matching import blocks, match, over_and_under

SIZE = 5


@st.composite
def incidences(draw, square=False):
    rows = draw(st.integers(1, SIZE))
    columns = rows if square else draw(st.integers(1, SIZE))
    entries = draw(st.lists(st.sets(st.integers(0, columns - 1), max_size=columns), min_size=rows, max_size=rows))
    if square:  # a transversal, so that a matching exists
        order = draw(st.permutations(range(columns)))
        entries = [entry | {column} for entry, column in zip(entries, order, strict=True)]
    return [frozenset(entry) for entry in entries], columns


def largest_matchings(rows, columns):
    """Return every largest matching as a set of (row, column)."""
    found = {frozenset()}
    for size in range(min(len(rows), columns), 0, -1):
        found = {
            frozenset(zip(chosen, order, strict=True))
            for chosen in combinations(range(len(rows)), size)
            for order in permutations(range(columns), size)
            if all(column in rows[row] for row, column in zip(chosen, order, strict=True))
        }
        if found:
            return found
    return {frozenset()}


@settings(max_examples=100, deadline=None)
@given(incidences())
def test_as_many_are_matched_as_can_be(incidence):
    rows, columns = incidence
    owner = match(rows, columns)
    matched = [(row, column) for column, row in enumerate(owner) if row >= 0]
    assert all(column in rows[row] for row, column in matched)
    assert len({row for row, _ in matched}) == len(matched)
    assert len(matched) == len(next(iter(largest_matchings(rows, columns))))


@settings(max_examples=100, deadline=None)
@given(incidences(square=True))
def test_blocks_are_the_strong_components_in_an_order_that_can_be_solved(incidence):
    rows, columns = incidence
    owner = match(rows, columns)
    found = blocks(rows, owner)
    assert sorted(column for block in found for column in block) == list(range(columns))
    needs = {column: rows[owner[column]] for column in range(columns)}
    reach = {column: {column} for column in needs}
    for _ in range(columns):
        reach = {column: near.union(*(needs[other] for other in near)) for column, near in reach.items()}
    together = {frozenset(other for other in reach[column] if column in reach[other]) for column in reach}
    assert {frozenset(block) for block in found} == together
    done = set()
    for block in found:
        done |= set(block)
        assert all(needs[column] <= done for column in block)


@settings(max_examples=100, deadline=None)
@given(incidences())
def test_over_and_under_determined_parts(incidence):
    """Dulmage and Mendelsohn: a row that some largest matching leaves out is in the over-determined part, and vice versa."""
    rows, columns = incidence
    (over_rows, over_columns), (under_rows, under_columns) = over_and_under(rows, match(rows, columns))
    largest = largest_matchings(rows, columns)
    spare_rows = {row for found in largest for row in set(range(len(rows))) - {r for r, _ in found}}
    spare_columns = {column for found in largest for column in set(range(columns)) - {c for _, c in found}}
    assert set(over_rows) == spare_rows
    assert set(under_columns) == spare_columns
    assert set(over_columns) == {column for row in spare_rows for column in rows[row]}
    assert set(under_rows) == {row for row in range(len(rows)) if rows[row] & spare_columns}


def test_a_chain_of_a_thousand_needs_no_recursion():
    rows = [frozenset({i, i + 1}) for i in range(999)] + [frozenset({999})]
    owner = match(rows, 1000)
    assert owner == list(range(1000))
    assert blocks(rows, owner) == [[i] for i in range(999, -1, -1)]
    turned = [frozenset({i, (i + 1) % 1000}) for i in range(1000)]
    assert blocks(turned, match(turned, 1000)) == [list(range(1000))]


def test_variant_31_by_its_incidence():
    rows = [frozenset({2}), frozenset({2, 3}), frozenset({0, 1, 2, 3}), frozenset({0, 1, 2})]
    assert blocks(rows, match(rows, 4)) == [[2], [3], [0, 1]]


def test_hard_case_12_is_named():
    """Three equations for w1, w2 and one for w3, w4 (hard_cases.json, H12)."""
    rows = [frozenset({0}), frozenset({0, 1}), frozenset({1}), frozenset({2, 3})]
    assert over_and_under(rows, match(rows, 4)) == (([0, 1, 2], [0, 1]), ([3], [2, 3]))
