"""All single slips of the pen in a formula: a sign, a function, a name, a factor.

Enters: a wrong equation as a tree.  Leaves: `Edit`s, each with the replacement for one node of the tree.
Used by `equations.py` and `own_numbers.py`.  An edit changes one place; the values of all other nodes are computed once.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import accumulate, pairwise
from typing import Any, Literal

import numpy as np

from coursework.grading.marking.equations.numbers import NoValue, combined, computed
from coursework.system.frozen import frozen
from coursework.system.grouped import grouped
from coursework.variant.formula.made import unsigned
from coursework.variant.formula.tree import Formula, factors, named, number, replaced, spelled

Kind = Literal["sign", "function", "name", "factor"]
_LIKELIEST = ("sign", "function", "removed", "name", "factor")
_OTHER = {"sin": "cos", "cos": "sin"}
_OPPOSITE = {"+": "-", "-": "+"}
_SUMS = {*_OPPOSITE, "neg"}
_BEGINS_MINUS = re.compile(r"^\(-([\w.]+)\)(?=[*/])")


@frozen
class Edit:
    """`replacement` for the node that `path` leads to (an argument's index at each level), at `column` of the text."""

    kind: Kind
    path: tuple[int, ...]
    replacement: Formula
    column: int


def edits(tree: Formula, kinds: Mapping[str, str], values: Mapping[str, float] | None = None) -> Iterator[Edit]:
    """Yield every single edit of `left - right`; `kinds` maps names to kinds, and names of one kind are exchanged.

    So are the `values` of data that a line has put in.
    """
    alike = grouped((kind, name) for name, kind in kinds.items())
    data = {name: Fraction(str(value)) for name, value in (values or {}).items() if value > 0 and name in kinds}
    by = [named(name) for name, kind in kinds.items() if kind in {"m", "rad/s", "m/s"}]
    angles = [named(name) for name, kind in kinds.items() if kind == "rad"]
    by += [Formula("call", (angle,), name=call) for angle in angles for call in ("sin", "cos")]
    for path, node, is_term, leads in places(tree):
        column = column_of(node)
        if node.op in _OPPOSITE and path:
            yield Edit("sign", path, Formula(_OPPOSITE[node.op], node.args, column=node.column), column_of(node.args[1]))
        if node.op == "neg":
            yield Edit("sign", path, node.args[0], column)
        # Of a term that begins with a minus the sign is turned there, as no student writes -(-r2)*w2 for -r2*w2.
        if is_term and leads and next(factors(node, "*/"))[0].op != "neg":
            yield Edit("sign", path, Formula("neg", (node,)), column)
        if is_term:
            for factor in (number(2), *by):
                yield Edit("factor", path, _multiplied(factor, node), column)
            yield Edit("factor", path, Formula("/", (node, number(2))), column)
        if node.op == "call" and node.name in _OTHER:
            yield Edit("function", path, Formula("call", node.args, name=_OTHER[node.name], column=node.column), column)
        if node.op == "name" and node.name in kinds:
            for other in alike[kinds[node.name]]:
                if other != node.name:
                    yield Edit("name", path, Formula("name", name=other, column=node.column), column)
        if node.op == "number" and node.value in data.values():
            kind = next(kinds[name] for name, value in data.items() if value == node.value)
            for value in sorted({data[other] for other in alike[kind] if other in data} - {node.value}):
                yield Edit("name", path, replace(number(value), column=node.column), column)
        if node.op == "*":
            yield from (Edit("factor", path, arg, column) for arg in node.args)
        if node.op == "/":
            yield Edit("factor", path, node.args[0], column)


def places(
    node: Formula, path: tuple[int, ...] = (), is_term: bool = False, leads: bool = False
) -> Iterator[tuple[tuple[int, ...], Formula, bool, bool]]:
    """Yield every node, its path, whether it is a term of a sum, and whether no plus or minus stands before it."""
    sums = node.op in _SUMS
    yield path, node, is_term and not sums, leads
    for place, arg in enumerate(node.args):
        first = (
            not path or node.op in {"call", "part", "pair"} or (node.op in {"+", "-"} and not place and (leads or not is_term))
        )
        yield from places(arg, (*path, place), sums or node.op in {"call", "part", "pair"}, first)


def _multiplied(factor: Formula, node: Formula) -> Formula:
    """Return factor times node; in a product the factor is put in front, as one writes it."""
    if node.op in {"*", "/"}:
        return Formula(node.op, (_multiplied(factor, node.args[0]), node.args[1]), column=node.column)
    return Formula("*", (factor, node), column=node.column)


def column_of(node: Formula) -> int:
    """Return the column where a part of a formula begins in its text, 0 if none is known."""
    return min((part.column for part in node.walk() if part.column), default=0)


@dataclass
class Values:
    """The values of all nodes of a tree; after an edit, only the changed node and those above it are computed again, and where
    the whole depends linearly on the node, as nearly everywhere in an equation, only the node.
    """

    tree: Formula
    names: Mapping[str, Any]

    def __post_init__(self) -> None:
        self.known: dict[int, Any] = {}
        self.leads: dict[tuple[int, ...], tuple[Formula, Any]] = {}
        with np.errstate(all="ignore"):
            self._fill(self.tree)

    def _fill(self, node: Formula) -> Any:
        args = [self._fill(arg) for arg in node.args]
        self.known[id(node)] = combined(node, args, self.names)
        return self.known[id(node)]

    def after(self, edit: Edit) -> Any:
        """Return the value of the whole tree after an edit, up to round-off, None if it has none."""
        node, slope = self._lead(edit.path)
        try:
            if slope is not None:
                with np.errstate(all="ignore"):
                    moved = computed(edit.replacement, self.names, self.known) - self.known[id(node)]
                    return self.known[id(self.tree)] + slope * moved
            way = _way(self.tree, edit.path)
            with np.errstate(all="ignore"):
                value = computed(edit.replacement, self.names, self.known)
                for place, node in zip(reversed(edit.path), reversed(way[:-1]), strict=True):
                    args = [value if i == place else self.known[id(arg)] for i, arg in enumerate(node.args)]
                    value = combined(node, args, self.names)
        except NoValue:
            return None
        return value

    def _lead(self, path: tuple[int, ...]) -> tuple[Formula, Any]:
        """Return the node at a path, and the slope of the whole by it: None where it is not linear or somewhere has no value."""
        if path not in self.leads:
            self.leads[path] = self._found(path)
        return self.leads[path]

    def _found(self, path: tuple[int, ...]) -> tuple[Formula, Any]:
        if not path:
            return self.tree, 1.0 if np.isfinite(self.known[id(self.tree)]).all() else None
        above, slope = self._lead(path[:-1])
        place, op = path[-1], above.op
        if slope is None or op not in {"+", "-", "neg", "*", "/"} or (op == "/" and place):
            return above.args[place], None
        with np.errstate(all="ignore"):
            if op in {"*", "/"}:
                slope = combined(Formula(op), [slope, self.known[id(above.args[1 - place])]], self.names)
            elif op == "neg" or (op == "-" and place):
                slope = -slope
        return above.args[place], slope if np.isfinite(slope).all() else None


def _way(tree: Formula, path: tuple[int, ...]) -> list[Formula]:
    """Return the nodes from a tree down to the one that `path` leads to."""
    return [*accumulate(path, lambda node, place: node.args[place], initial=tree)]


def applied(tree: Formula, edit: Edit) -> Formula:
    """Return the tree after an edit."""
    return replaced(tree, edit.path, edit.replacement)


def term_of(tree: Formula, edit: Edit) -> Formula:
    """Return the innermost term of a sum that an edit changes, without its sign; of a plus or minus, the term behind it."""
    way = _way(tree, edit.path)
    if way[-1].op == "neg":  # at the beginning of a product the sign is that of the whole
        place = len(way) - 1
        while place and edit.path[place - 1] == 0 and way[place - 1].op in {"*", "/"}:
            place -= 1
        return replaced(way[place], edit.path[place:], way[-1].args[0])
    if way[-1].op in _OPPOSITE:
        return unsigned(way[-1].args[-1])
    terms = [node for above, node in pairwise(way) if above.op in _SUMS and node.op not in _SUMS]
    return unsigned(terms[-1] if terms else way[-1])


def unlikeliness(tree: Formula, edit: Edit, *, is_new_sign: bool) -> tuple[int, ...]:
    """Return numbers by which the likelier of two edits is less; `is_new_sign` tells that no sign was written in its place.

    A sign that was written is likelier wrong than one left out; a 2 is likelier one too many than a length is another of half
    its size; and a ½ is likelier missing than a length that has 0.5 m.
    """
    after = [node.op for node in applied(tree, edit).walk()] if edit.kind == "factor" else []
    kind = "removed" if after and len(after) < sum(1 for _ in tree.walk()) else edit.kind
    return _LIKELIEST.index(kind), is_new_sign, after.count("name"), len(after), edit.column


def written(tree: Formula) -> str:
    """Return `left - right` written as an equation, with -r1*w1 at the beginning of a side as people write it."""
    sides = tree.args if tree.op == "-" and len(tree.args) == 2 else (tree, number(0))
    return " = ".join(_BEGINS_MINUS.sub(r"-\1", spelled(side)) for side in sides)
