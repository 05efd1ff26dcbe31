"""THE door between symbols and numbers: expressions -> straight-line Python over `math` or NumPy.

Enters: assignments, made by this program.  Leaves: plain functions.
No text of a user's file is compiled here.  Names were checked to be letters, digits and _ when the file was read, and are
replaced by private ones (`names.py`); numbers are printed by this program.  All other floors call what `compile_function`
returns and never see a symbol.
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
    """Solve a linear block of three or more unknowns numerically (LU); also assign its determinant.

    With `adjugate` the result is adj(A) b, the unknowns times the determinant, which exists even where the determinant is zero.
    """

    unknowns: tuple[Expression, ...]
    determinant: Expression
    entries: tuple[Expression, ...]  # matrix row by row, then the right side
    adjugate: bool = False


Statement = Assign | Solve


@frozen
class Program:
    """Lines, each after those it needs; they read the arguments, the names in `reads` and the tabulated laws.

    `known` are the lines that depend on data alone, `data` the names of the data that any line reads.
    """

    known: tuple[Line, ...]
    lines: tuple[Line, ...]
    reads: tuple[str, ...]
    data: tuple[str, ...]
    tables: Mapping[str, TableLaw]

    def bind(self, constants: Mapping[str, float]) -> Bound:
        """Return the program with its data; values of data alone are computed now, or in every call if one of them fails."""
        numbers = {name: constants[name] for name in self.data}
        try:
            numbers |= self._settled(numbers)
        except (ArithmeticError, ValueError):
            return Bound((*self.known, *self.lines), numbers, self.tables)
        return Bound(self.lines, {name: numbers[name] for name in self.reads}, self.tables)

    def free(self) -> Bound:
        """Return the program with the data as arguments of every call."""
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
    """The `lines` of a program, and the `numbers` (by name) that they read in addition to their arguments."""

    lines: tuple[Line, ...]
    numbers: Mapping[str, float]
    tables: Mapping[str, TableLaw]


def with_numbers(arguments: Iterable[str], numbers: Iterable[str]) -> str:
    """Return the parameter list of a function of bound lines: its arguments, then each number as a default that nobody passes."""
    return ", ".join([*arguments, *(f"{name}={name}" for name in numbers)])


def renamed(lines: Iterable[Line], rename: Mapping[str, str]) -> list[Line]:
    """Return lines with identifiers replaced according to `rename`."""
    return [Line(line.targets, _NAME.sub(lambda word: rename.get(word[0], word[0]), line.text)) for line in lines]


def program(
    wanted: Sequence[Statement],
    definitions: Mapping[Expression, Expression],
    data: Collection[str],
    tables: Mapping[str, TableLaw],
) -> Program:
    """Return a program for `wanted` with the definitions it needs; `data` are the names whose values are fixed in each run."""
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

    With both `numpy` and `outside`, a tabulated law gives nan beyond its table instead of raising `OutsideTable`.
    """
    source = _source(name, [with_numbers(arguments, body.numbers)], body.lines, results)
    return build(source, name, body, numpy=numpy, outside=outside)


def _source(name: str, arguments: Iterable[str], lines: Iterable[Line], results: Sequence[str]) -> str:
    written = [f"def {name}({', '.join(arguments)}):", *(f"    {line.text}" for line in lines)]
    return "\n".join([*written, f"    return ({', '.join(results)}{',' if len(results) == 1 else ''})"])


def compile_later(
    name: str, arguments: Sequence[str], body: Bound, results: Sequence[str], *, numpy: bool = False
) -> Callable[..., Any]:
    """Return the same function as `compile_function`, compiled at its first call, because many scenes never call it."""
    compiled: list[Callable[..., Any]] = []

    def call(*values: Any) -> Any:
        if not compiled:
            compiled.append(compile_function(name, arguments, body, results, numpy=numpy))
        return compiled[0](*values)

    return call


def in_formula(error: Exception) -> bool:
    """Return whether an error is a division by zero in generated code, that is, in a formula of the file."""
    last = error.__traceback__
    while last is not None and last.tb_next is not None:
        last = last.tb_next
    return isinstance(error, ZeroDivisionError) and last is not None and last.tb_frame.f_code.co_filename.startswith("<generated")


def _exp(value: float) -> float:
    """Return e to the power `value`, infinite if that overflows: 1/(1 + exp(800)) is 0."""
    try:
        return math.exp(value)
    except OverflowError:
        return math.inf


_MATH: dict[str, Any] = {name: vars(math)[name] for name in CALLS if hasattr(math, name)}
_MATH["exp"] = _exp
_MATH["sign"] = lambda value: math.copysign(1.0, value) if value and value == value else value  # plain: 1/0 is an error after it
_MATH["_choose"] = lambda holds, yes, no: yes() if holds else no()
_ARRAYS: dict[str, Any] = {name: vars(np)[name] for name in CALLS if hasattr(np, name)}
# NumPy functions under the names of `math`, where these differ.
_ARRAYS |= {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "pow": np.power}
_ARRAYS["_choose"] = lambda holds, yes, no: np.where(holds, yes(), no())


@lru_cache(maxsize=256)  # a structure needs about thirty
def _code(source: str, name: str) -> CodeType:
    """Return compiled source; variants that differ only in their data share it."""
    return compile(source, f"<generated {name}>", "exec")


def build(source: str, name: str, body: Bound, *, numpy: bool = False, outside: bool = False) -> Callable[..., Any]:
    """Return the function `name` of a source that this program has printed."""
    namespace = {**(_ARRAYS if numpy else _MATH), **body.numbers}
    namespace |= {"abs": abs, "range": range, "_adjugate": _adjugate}
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
    """Return a function over arrays that gives nan without a warning where there is no value; its callers look for nan.

    The function itself is available as `__wrapped__`, for callers that suppress warnings over many calls.
    """

    @wraps(function)
    def call(*values: Any, **named: Any) -> Any:
        with np.errstate(all="ignore"):
            return function(*values, **named)

    return call


def _beyond(law: TableLaw, order: int) -> Callable[[Any], Any]:
    """Return a function of a tabulated law over arrays that gives nan outside the table."""
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
    """Return adj(A) b and the determinant of a block of size n from its n*n + n entries.

    Rows are multiplied by powers of 2 that make them alike: singular values are right to a rounding error of the largest only.
    """
    size = _size(len(entries))
    matrix = np.array(entries[: size * size]).reshape(size, size)
    exponents = np.frexp(np.max(np.abs(matrix), axis=1))[1]
    u, sizes, v = np.linalg.svd(np.ldexp(matrix, -exponents[:, None]))
    others = np.array([np.prod(np.delete(sizes, i)) for i in range(size)])
    sign = np.linalg.det(u) * np.linalg.det(v)
    solution = sign * (v.T * others) @ (u.T @ np.ldexp(entries[size * size :], -exponents))
    return (*np.ldexp(solution, exponents.sum()).tolist(), float(np.ldexp(sign * np.prod(sizes), exponents.sum())))


def _solve_rows(entries: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return the same as `_solve` for arrays (n,), nan in the rows whose block is singular."""
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
