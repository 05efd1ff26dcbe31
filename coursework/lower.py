"""THE door between symbols and numbers: SymPy expressions -> straight-line Python over `math` or NumPy.

Enters: assignments in SymPy, made by this program.  Leaves: plain functions.
No text of a user's file passes here: names were checked against letters, digits and _ when the file was read, numbers are
printed by us.  Every other floor calls what `compile_function` returns and never sees SymPy's numbers.
"""

from __future__ import annotations

import builtins
import keyword
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.pycode import PythonCodePrinter

from coursework.tabulated import TableLaw

SYMPY_VERSION: str = sp.__version__


@dataclass(frozen=True, slots=True)
class Assign:
    """`target = value`."""

    target: sp.Symbol
    value: sp.Expr

    @property
    def values(self) -> tuple[sp.Expr, ...]:
        """Return the expressions read."""
        return (self.value,)

    @property
    def targets(self) -> tuple[sp.Symbol, ...]:
        """Return the names written."""
        return (self.target,)

    def with_values(self, values: Sequence[sp.Expr]) -> Assign:
        """Return the same statement reading other expressions."""
        return Assign(self.target, values[0])


@dataclass(frozen=True, slots=True)
class Solve:
    """Solve a linear block of three or more numerically (LU); also writes its determinant."""

    unknowns: tuple[sp.Symbol, ...]
    determinant: sp.Symbol
    entries: tuple[sp.Expr, ...]  # matrix row by row, then the right side

    @property
    def values(self) -> tuple[sp.Expr, ...]:
        """Return the expressions read."""
        return self.entries

    @property
    def targets(self) -> tuple[sp.Symbol, ...]:
        """Return the names written."""
        return (*self.unknowns, self.determinant)

    def with_values(self, values: Sequence[sp.Expr]) -> Solve:
        """Return the same statement reading other expressions."""
        return Solve(self.unknowns, self.determinant, tuple(values))


Statement = Assign | Solve
_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")


@dataclass(frozen=True, slots=True)
class Program:
    """Statements in an order in which each needs only earlier ones, constants and the arguments."""

    statements: tuple[Statement, ...]
    constants: Mapping[str, float]
    tables: Mapping[str, TableLaw]
    _printed: dict[bool, list[str]] = field(default_factory=dict, repr=False, compare=False)

    def lines(self, rename: Mapping[str, str], *, numpy: bool = False) -> list[str]:
        """Return the program as source, names replaced by `rename`; SymPy prints it once, a loop reads it many times."""
        if numpy not in self._printed:
            printer = _printer(numpy, self.constants)
            self._printed[numpy] = [_line(statement, printer) for statement in self.statements]
        if not rename:
            return list(self._printed[numpy])
        spelt = {identifier(name): new for name, new in rename.items()}
        return [_NAME.sub(lambda word: spelt.get(word[0], word[0]), line) for line in self._printed[numpy]]


def program(
    wanted: Sequence[Statement],
    definitions: Mapping[sp.Symbol, sp.Expr],
    constants: Mapping[str, float],
    tables: Mapping[str, TableLaw],
    *,
    share: bool = True,
) -> Program:
    """Return a program for `wanted`: the definitions they need, common subexpressions taken out once."""
    written = {target for statement in wanted for target in statement.targets}
    statements = [*_needed(wanted, definitions, written), *wanted]
    if share:
        flat = [value for statement in statements for value in statement.values]
        shared, reduced = sp.cse(flat, symbols=sp.numbered_symbols("_c"), order="none")
        rest = iter(reduced)
        statements = [statement.with_values([next(rest) for _ in statement.values]) for statement in statements]
        statements = _weave(statements, dict(shared))
    return Program(tuple(statements), dict(constants), dict(tables))


def _needed(wanted: Sequence[Statement], definitions: Mapping[sp.Symbol, sp.Expr], written: set[sp.Symbol]) -> list[Statement]:
    order: dict[sp.Symbol, Statement] = {}

    def visit(expr: sp.Expr) -> None:
        for name in sorted(expr.free_symbols, key=str):
            if name in definitions and name not in order and name not in written:
                visit(definitions[name])
                order[name] = Assign(name, definitions[name])

    for statement in wanted:
        for value in statement.values:
            visit(value)
    return list(order.values())


def _weave(statements: list[Statement], shared: dict[sp.Symbol, sp.Expr]) -> list[Statement]:
    """Put each shared subexpression before its first use, after everything it needs."""
    done: set[sp.Symbol] = set()
    woven: list[Statement] = []

    def visit(expr: sp.Expr) -> None:
        for name in sorted(expr.free_symbols & shared.keys(), key=str):
            if name not in done:
                done.add(name)
                visit(shared[name])
                woven.append(Assign(name, shared[name]))

    for statement in statements:
        for value in statement.values:
            visit(value)
        woven.append(statement)
    return woven


def compile_function(
    name: str, arguments: Sequence[str], body: Program, results: Sequence[str], *, numpy: bool = False
) -> Callable[..., Any]:
    """Return `name(*arguments) -> (results…)`; with `numpy` every argument may be an array (n,)."""
    safe = {argument: identifier(argument) for argument in arguments}
    printer = _printer(numpy, body.constants)
    shown = [printer.doprint(sp.Symbol(result, real=True)) for result in results]
    lines = [f"def {name}({', '.join(safe.values())}):", *(f"    {line}" for line in body.lines({}, numpy=numpy))]
    lines.append(f"    return ({', '.join(shown)}{',' if len(shown) == 1 else ''})")
    return build("\n".join(lines), name, body, numpy=numpy)


def compile_later(name: str, arguments: Sequence[str], body: Program, results: Sequence[str]) -> Callable[..., Any]:
    """Return the function over arrays, compiled when it is first called: many scenes never ask for it."""
    compiled: list[Callable[..., Any]] = []

    def call(*values: Any) -> Any:
        if not compiled:
            compiled.append(compile_function(name, arguments, body, results, numpy=True))
        return compiled[0](*values)

    return call


def build(source: str, name: str, body: Program, *, numpy: bool = False) -> Callable[..., Any]:
    """Return the function `name` of a source that this program printed itself."""
    namespace: dict[str, Any] = dict(vars(np if numpy else math))
    namespace |= {"abs": abs, "sign": np.sign, "_solve": _solve_rows if numpy else _solve, "range": range}
    namespace |= {f"table_{key}_{order}": law.function(order) for key, law in body.tables.items() for order in range(3)}
    namespace["__builtins__"] = {}
    builtins.exec(compile(source, f"<generated {name}>", "exec"), namespace)
    function: Callable[..., Any] = namespace[name]
    function.__doc__ = source
    return function


def identifier(name: str) -> str:
    """Return a name that Python accepts and that hides nothing the generated code calls."""
    return f"{name}_" if keyword.iskeyword(name) or name in _RESERVED or name.startswith("table_") else name


_RESERVED = set(vars(math)) | set(vars(np)) | {"abs", "range", "sign"}


def _line(statement: Statement, printer: Any) -> str:
    # `doprint` walks each expression once more for parts that these expressions never have: half the time of a small scene.
    shown = printer._print
    targets = ", ".join(shown(target) for target in statement.targets)
    if isinstance(statement, Assign):
        return f"{targets} = {shown(statement.value)}"
    return f"{targets} = _solve(({', '.join(shown(value) for value in statement.entries)}))"


def _printer(numpy: bool, constants: Mapping[str, float]) -> Any:
    return _printer_of(numpy, tuple(constants.items()))


@lru_cache(maxsize=8)
def _printer_of(numpy: bool, items: tuple[tuple[str, float], ...]) -> Any:
    constants = dict(items)
    base: Any = NumPyPrinter if numpy else PythonCodePrinter

    class Printer(base):  # type: ignore[misc]
        def _print_Symbol(self, expr: sp.Symbol) -> str:
            if expr.name in constants:
                value = constants[expr.name]
                return repr(value) if value >= 0 else f"({value!r})"
            return identifier(expr.name)

        def _print_Float(self, expr: sp.Float) -> str:
            return repr(float(expr))

        def _print_Rational(self, expr: sp.Rational) -> str:
            # A quotient of two integers is rounded once by Python, so the decimal of the task sheet comes back exactly.
            return repr(int(expr.p) / int(expr.q))

        def _print_Pow(self, expr: sp.Pow, **options: Any) -> str:
            # A negative number to a fractional power is no real number; `**` would go on in complex ones.
            if numpy or expr.exp.is_Integer or abs(expr.exp) == sp.Rational(1, 2):
                text: str = super()._print_Pow(expr, **options)
                return text
            return f"pow({self._print(expr.base)}, {self._print(expr.exp)})"

        def _print_AppliedUndef(self, expr: Any) -> str:
            return f"{expr.func.__name__}({', '.join(self._print(arg) for arg in expr.args)})"

        _print_Function = _print_AppliedUndef

    printer = Printer({"fully_qualified_modules": False, "allow_unknown_functions": True})
    printer.doprint(sp.S.Zero)  # sets up what printing alone expects
    return printer


def _solve(entries: tuple[float, ...]) -> tuple[float, ...]:
    """Return the unknowns and the determinant of a block of size n from its n*n + n entries."""
    size = _size(len(entries))
    matrix = np.array(entries[: size * size]).reshape(size, size)
    determinant = float(np.linalg.det(matrix))
    if determinant == 0.0:
        raise ZeroDivisionError("the block is singular")
    return (*np.linalg.solve(matrix, np.array(entries[size * size :])).tolist(), determinant)


def _solve_rows(entries: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return the same for arrays (n,) at once."""
    size = _size(len(entries))
    rows = np.stack(np.broadcast_arrays(*entries), axis=-1).astype(float)
    matrix = rows[..., : size * size].reshape(*rows.shape[:-1], size, size)
    solution = np.linalg.solve(matrix, rows[..., size * size :][..., None])[..., 0]
    return (*np.moveaxis(solution, -1, 0), np.linalg.det(matrix))


def _size(entries: int) -> int:
    return int((math.isqrt(4 * entries + 1) - 1) // 2)
