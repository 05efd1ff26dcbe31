"""Which equation determines which unknown: matching, blocks in order, over- and under-determined parts.

Enters: for each equation the set of unknowns in it.  Leaves: indices only.  Used by `blocks.py`.
Source: Duff, Reid, "An implementation of Tarjan's algorithm for block triangularization", 1978; Dulmage, Mendelsohn 1958.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

Rows = Sequence[frozenset[int]]


def match(rows: Rows, columns: int) -> list[int]:
    """Return for each column the row matched to it, -1 for none (augmenting paths, rows in file order)."""
    owner = [-1] * columns

    def augment(start: int) -> bool:
        # Depth-first search with an explicit stack: a chain of eighty loops must not exceed the recursion limit.
        seen: set[int] = set()
        path: list[tuple[int, int]] = []
        stack = [(start, iter(sorted(rows[start])))]
        while stack:
            row, options = stack[-1]
            column = next((c for c in options if c not in seen), None)
            if column is None:
                stack.pop()
                if path:
                    path.pop()
                continue
            seen.add(column)
            path.append((row, column))
            if owner[column] < 0:
                for taker, taken in path:
                    owner[taken] = taker
                return True
            stack.append((owner[column], iter(sorted(rows[owner[column]]))))
        return False

    for row in range(len(rows)):
        augment(row)
    return owner


def blocks(rows: Rows, owner: Sequence[int]) -> list[list[int]]:
    """Return the columns grouped into blocks, each after all blocks it needs (Tarjan's algorithm)."""
    index: dict[int, int] = {}
    low: dict[int, int] = {}
    stack: list[int] = []
    found: list[list[int]] = []

    for root in range(len(owner)):
        if root in index:
            continue
        work = [(root, iter(sorted(rows[owner[root]])))]
        index[root] = low[root] = len(index)
        stack.append(root)
        while work:
            column, needed = work[-1]
            following = next((c for c in needed if c not in index or c in stack), None)
            if following is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[column])
                if low[column] == index[column]:
                    cut = stack.index(column)
                    found.append(sorted(stack[cut:]))
                    del stack[cut:]
            elif following not in index:
                index[following] = low[following] = len(index)
                stack.append(following)
                work.append((following, iter(sorted(rows[owner[following]]))))
            else:
                low[column] = min(low[column], index[following])
    return found


def over_and_under(rows: Rows, owner: Sequence[int]) -> tuple[tuple[list[int], list[int]], tuple[list[int], list[int]]]:
    """Return (rows, columns) of the over-determined part, and the same for the under-determined part."""
    matched = {row: column for column, row in enumerate(owner) if row >= 0}
    over = _reached((row for row in range(len(rows)) if row not in matched), rows, owner)
    holding = [frozenset(row for row in range(len(rows)) if column in rows[row]) for column in range(len(owner))]
    partners = [matched.get(row, -1) for row in range(len(rows))]
    under = _reached((column for column, row in enumerate(owner) if row < 0), holding, partners)
    return over, (under[1], under[0])


def _reached(waiting: Iterable[int], beside: Rows, partners: Sequence[int]) -> tuple[list[int], list[int]]:
    """Return the rows reached from `waiting` by steps to an adjacent column and on to its matched row, and those columns."""
    found, near = [*waiting], set[int]()
    for one in found:  # the list grows during the loop
        fresh = beside[one] - near
        near |= fresh
        found += {partners[other] for other in fresh if partners[other] >= 0} - {*found}
    return sorted(found), sorted(near)
