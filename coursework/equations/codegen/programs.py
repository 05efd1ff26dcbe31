"""THE door between symbols and numbers: expressions -> straight-line Python over `math` or NumPy.

Enters: assignments, made by this program.  Leaves: plain functions.
No text of a user's file passes here: names were checked against letters, digits and _ when the file was read and are
private ones here (`names.py`), numbers are printed by us.  Every other floor calls what `compile_function` returns and
never sees a symbol.
"""

from __future__ import annotations

import builtins
import math
import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import lru_cache, wraps
from types import CodeType
from typing import Any

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.codegen.straight_line import CALLS, Line, StraightLine
from coursework.equations.codegen.tabulated import TableLaw
from coursework.system.frozen import frozen

_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")


@frozen
class Assign:
    """`target = value`."""

    target: Expression
    value: Expression


@frozen
class Solve:
    """Solve a linear block of three or more numerically (LU); also writes its determinant.

    With `adjugate` the unknowns are multiplied by it: adj(A) b, which has a value where the determinant vanishes, too.
    """

    unknowns: tuple[Expression, ...]
    determinant: Expression
    entries: tuple[Expression, ...]  # matrix row by row, then the right side
    adjugate: bool = False


Statement = Assign | Solve


@frozen
class Program:
    """Lines in an order in which each needs only earlier ones, the arguments and `reads`; the tabulated laws they call.

    `known` are the lines of what the data alone give, `data` the names of data that any line reads.
    """

    known: tuple[Line, ...]
    lines: tuple[Line, ...]
    reads: tuple[str, ...]
    data: tuple[str, ...]
    tables: Mapping[str, TableLaw]

    def bind(self, constants: Mapping[str, float]) -> Bound:
        """Return the program with its data; what they give is worked out now, or where it has no value in every call."""
        numbers = {name: constants[name] for name in self.data}
        try:
            numbers |= self._settled(numbers)
        except (ArithmeticError, ValueError):
            return Bound((*self.known, *self.lines), numbers, self.tables)
        return Bound(self.lines, {name: numbers[name] for name in self.reads}, self.tables)

    def free(self) -> Bound:
        """Return the program whose data are arguments of every call."""
        return Bound((*self.known, *self.lines), {}, self.tables)

    def _settled(self, numbers: Mapping[str, float]) -> dict[str, float]:
        if not self.known:
            return {}
        names = [name for line in self.known for name in line.targets]
        source = _source("settled", self.data, self.known, names)
        values = build(source, "settled", Bound((), {}, {}))(*numbers.values())
        return dict(zip(names, values, strict=True))


@frozen
class Bound:
    """The `lines` of a program with the `numbers`, by name, that they read beside their arguments."""

    lines: tuple[Line, ...]
    numbers: Mapping[str, float]
    tables: Mapping[str, TableLaw]


def with_numbers(arguments: Iterable[str], numbers: Iterable[str]) -> str:
    """Return the arguments of a function over bound lines: its own, then the numbers by name, which nobody passes."""
    return ", ".join([*arguments, *(f"{name}={name}" for name in numbers)])


def renamed(lines: Iterable[Line], rename: Mapping[str, str]) -> list[Line]:
    """Return lines with other identifiers."""
    return [Line(line.targets, _NAME.sub(lambda word: rename.get(word[0], word[0]), line.text)) for line in lines]


def program(
    wanted: Sequence[Statement],
    definitions: Mapping[Expression, Expression],
    data: Collection[str],
    tables: Mapping[str, TableLaw],
) -> Program:
    """Return a program for `wanted`, with the definitions it needs; `data` are the names of what is a number in every run."""
    written = {target for statement in wanted for target in _targets(statement)}
    collected = StraightLine(data, definitions, written)
    for statement in wanted:
        if isinstance(statement, Assign):
            collected.add([statement.target], [statement.value])
        else:
            collected.add(_targets(statement), statement.entries, "_adjugate" if statement.adjugate else "_solve")
    lines = tuple(collected.lines())
    read = tuple(name for name in data if name in collected.reads or name in collected.known_reads)
    return Program(tuple(collected.known), lines, tuple(collected.reads), read, dict(tables))


def _targets(statement: Statement) -> tuple[Expression, ...]:
    return (statement.target,) if isinstance(statement, Assign) else (*statement.unknowns, statement.determinant)


def compile_function(
    name: str, arguments: Sequence[str], body: Bound, results: Sequence[str], *, numpy: bool = False, outside: bool = False
) -> Callable[..., Any]:
    """Return `name(*arguments) -> (results…)`; with `numpy` every argument may be an array (n,).

    With `outside` too a tabulated law gives nan beyond its table instead of raising `OutsideTable`.
    """
    source = _source(name, [with_numbers(arguments, body.numbers)], body.lines, results)
    return build(source, name, body, numpy=numpy, outside=outside)


def _source(name: str, arguments: Iterable[str], lines: Iterable[Line], results: Sequence[str]) -> str:
    written = [f"def {name}({', '.join(arguments)}):", *(f"    {line.text}" for line in lines)]
    return "\n".join([*written, f"    return ({', '.join(results)}{',' if len(results) == 1 else ''})"])


def compile_later(
    name: str, arguments: Sequence[str], body: Bound, results: Sequence[str], *, numpy: bool = False
) -> Callable[..., Any]:
    """Return the same function, compiled when it is first called: many scenes never ask for it."""
    compiled: list[Callable[..., Any]] = []

    def call(*values: Any) -> Any:
        if not compiled:
            compiled.append(compile_function(name, arguments, body, results, numpy=numpy))
        return compiled[0](*values)

    return call


def in_formula(error: Exception) -> bool:
    """Return whether a division by zero was made by a program that was printed here, so by a formula of the file."""
    last = error.__traceback__
    while last is not None and last.tb_next is not None:
        last = last.tb_next
    return isinstance(error, ZeroDivisionError) and last is not None and last.tb_frame.f_code.co_filename.startswith("<generated")


def _exp(value: float) -> float:
    """Return e to a power, infinite where that is beyond the largest number: 1/(1 + exp(800)) is 0."""
    try:
        return math.exp(value)
    except OverflowError:
        return math.inf


_MATH: dict[str, Any] = {name: vars(math)[name] for name in CALLS if hasattr(math, name)}
_MATH["exp"] = _exp
_MATH["_choose"] = lambda holds, yes, no: yes() if holds else no()
_ARRAYS: dict[str, Any] = {name: vars(np)[name] for name in CALLS if hasattr(np, name)}
# The names of `math` for what NumPy calls otherwise.
_ARRAYS |= {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "pow": np.power}
_ARRAYS["_choose"] = lambda holds, yes, no: np.where(holds, yes(), no())


@lru_cache(maxsize=256)  # a structure has about thirty
def _code(source: str, name: str) -> CodeType:
    """Return a source compiled; variants that differ in their data have the same one."""
    return compile(source, f"<generated {name}>", "exec")


def build(source: str, name: str, body: Bound, *, numpy: bool = False, outside: bool = False) -> Callable[..., Any]:
    """Return the function `name` of a source that this program printed itself."""
    namespace = {**(_ARRAYS if numpy else _MATH), **body.numbers}
    namespace |= {"abs": abs, "sign": np.sign, "range": range, "_adjugate": _adjugate}
    namespace["_solve"] = _solve_rows if numpy else _solve
    for key, law in body.tables.items():
        for order in range(3):
            namespace[f"_table_{key}_{order}"] = _beyond(law, order) if outside else law.function(order)
    namespace["__builtins__"] = {}
    builtins.exec(_code(source, name), namespace)
    function: Callable[..., Any] = namespace[name]
    function = _quiet(function) if numpy else function
    function.__doc__ = source
    return function


def _quiet(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function over arrays that gives nan where there is no value, without a word; whoever reads it looks for nan.

    The function itself is its `__wrapped__`, for whoever keeps quiet over many calls.
    """

    @wraps(function)
    def call(*values: Any, **named: Any) -> Any:
        with np.errstate(all="ignore"):
            return function(*values, **named)

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


def _adjugate(entries: tuple[float, ...]) -> tuple[float, ...]:
    """Return adj(A) b and the determinant of a block of size n from its n*n + n entries."""
    size = _size(len(entries))
    u, sizes, v = np.linalg.svd(np.array(entries[: size * size]).reshape(size, size))
    others = np.array([np.prod(np.delete(sizes, i)) for i in range(size)])
    sign = np.linalg.det(u) * np.linalg.det(v)
    return (*(sign * (v.T * others) @ (u.T @ np.array(entries[size * size :]))).tolist(), float(sign * np.prod(sizes)))


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
