"""THE door between symbols and numbers: SymPy expressions -> straight-line Python over `math` or NumPy.

Enters: assignments in SymPy, made by this program.  Leaves: plain functions.
No text of a user's file passes here: names were checked against letters, digits and _ when the file was read and are
private ones here (`names.py`), numbers are printed by us.  Every other floor calls what `compile_function` returns and
never sees SymPy's numbers.
"""

from __future__ import annotations

import builtins
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from coursework.codegen.straight_line import Line, StraightLine
from coursework.codegen.tabulated import TableLaw

SYMPY_VERSION: str = sp.__version__
_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")


@dataclass(frozen=True, slots=True)
class Assign:
    """`target = value`."""

    target: sp.Symbol
    value: sp.Expr


@dataclass(frozen=True, slots=True)
class Solve:
    """Solve a linear block of three or more numerically (LU); also writes its determinant."""

    unknowns: tuple[sp.Symbol, ...]
    determinant: sp.Symbol
    entries: tuple[sp.Expr, ...]  # matrix row by row, then the right side


Statement = Assign | Solve


@dataclass(frozen=True, slots=True)
class Program:
    """Lines in an order in which each needs only earlier ones and the arguments; the tabulated laws they call."""

    lines: tuple[Line, ...]
    tables: Mapping[str, TableLaw]

    def renamed(self, rename: Mapping[str, str]) -> list[Line]:
        """Return the lines with other identifiers."""
        return [Line(line.targets, _NAME.sub(lambda word: rename.get(word[0], word[0]), line.text)) for line in self.lines]


def program(
    wanted: Sequence[Statement],
    definitions: Mapping[sp.Symbol, sp.Expr],
    constants: Mapping[str, float],
    tables: Mapping[str, TableLaw],
) -> Program:
    """Return a program for `wanted`, with the definitions it needs."""
    written = {target for statement in wanted for target in _targets(statement)}
    collected = StraightLine(constants, definitions, written)
    for statement in wanted:
        if isinstance(statement, Assign):
            collected.add([statement.target], [statement.value])
        else:
            collected.add(_targets(statement), statement.entries, "_solve")
    return Program(tuple(collected.lines()), dict(tables))


def _targets(statement: Statement) -> tuple[sp.Symbol, ...]:
    return (statement.target,) if isinstance(statement, Assign) else (*statement.unknowns, statement.determinant)


def compile_function(
    name: str, arguments: Sequence[str], body: Program, results: Sequence[str], *, numpy: bool = False, outside: bool = False
) -> Callable[..., Any]:
    """Return `name(*arguments) -> (results…)`; with `numpy` every argument may be an array (n,).

    With `outside` too a tabulated law gives nan beyond its table instead of raising `OutsideTable`.
    """
    lines = [f"def {name}({', '.join(arguments)}):", *(f"    {line.text}" for line in body.lines)]
    lines.append(f"    return ({', '.join(results)}{',' if len(results) == 1 else ''})")
    return build("\n".join(lines), name, body, numpy=numpy, outside=outside)


def compile_later(name: str, arguments: Sequence[str], body: Program, results: Sequence[str]) -> Callable[..., Any]:
    """Return the function over arrays, compiled when it is first called: many scenes never ask for it."""
    compiled: list[Callable[..., Any]] = []

    def call(*values: Any) -> Any:
        if not compiled:
            compiled.append(compile_function(name, arguments, body, results, numpy=True))
        return compiled[0](*values)

    return call


_MATH: dict[str, Any] = {**vars(math), "_choose": lambda holds, yes, no: yes() if holds else no()}
# The names of `math` for what NumPy calls otherwise.
_ARRAYS: dict[str, Any] = {
    **vars(np), "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "pow": np.power,
    "_choose": lambda holds, yes, no: np.where(holds, yes(), no()),
}  # fmt: skip


def build(source: str, name: str, body: Program, *, numpy: bool = False, outside: bool = False) -> Callable[..., Any]:
    """Return the function `name` of a source that this program printed itself."""
    namespace = dict(_ARRAYS if numpy else _MATH)
    namespace |= {"abs": abs, "sign": np.sign, "_solve": _solve_rows if numpy else _solve, "range": range}
    for key, law in body.tables.items():
        for order in range(3):
            namespace[f"_table_{key}_{order}"] = _beyond(law, order) if outside else law.function(order)
    namespace["__builtins__"] = {}
    builtins.exec(compile(source, f"<generated {name}>", "exec"), namespace)
    function: Callable[..., Any] = namespace[name]
    function = _quiet(function) if numpy else function
    function.__doc__ = source
    return function


def _quiet(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function over arrays that gives nan where there is no value, without a word; whoever reads it looks for nan."""

    def call(*values: Any) -> Any:
        with np.errstate(all="ignore"):
            return function(*values)

    return call


def _beyond(law: TableLaw, order: int) -> Callable[[Any], Any]:
    """Return the function of a tabulated law over arrays that gives nan where the table has ended."""
    function = law.function(order)

    def value(argument: Any) -> Any:
        covered = law.covers(argument)
        return np.where(covered, function(np.where(covered, argument, law.first)), np.nan)

    return value


def _solve(entries: tuple[float, ...]) -> tuple[float, ...]:
    """Return the unknowns and the determinant of a block of size n from its n*n + n entries."""
    size = _size(len(entries))
    matrix = np.array(entries[: size * size]).reshape(size, size)
    determinant = float(np.linalg.det(matrix))
    if determinant == 0.0:
        raise ZeroDivisionError("the block is singular")
    return (*np.linalg.solve(matrix, np.array(entries[size * size :])).tolist(), determinant)


def _solve_rows(entries: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return the same for arrays (n,) at once, nan where the block is singular."""
    size = _size(len(entries))
    rows = np.stack(np.broadcast_arrays(*entries), axis=-1).astype(float)
    matrix = rows[..., : size * size].reshape(*rows.shape[:-1], size, size)
    determinant = np.linalg.det(matrix)
    singular = ~np.isfinite(determinant) | (determinant == 0.0)
    safe = np.where(singular[..., None, None], np.eye(size), matrix)
    solution = np.linalg.solve(safe, rows[..., size * size :][..., None])[..., 0]
    return (*np.moveaxis(np.where(singular[..., None], np.nan, solution), -1, 0), determinant)


def _size(entries: int) -> int:
    return int((math.isqrt(4 * entries + 1) - 1) // 2)
