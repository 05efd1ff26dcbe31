"""Straight-line code of `codegen` -> expressions and names of five languages.

Enters: lines that this package generated.  Leaves: text with the same meaning.  Used by `writer.py`.
"""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Collection, Mapping
from dataclasses import field
from functools import cache
from pathlib import Path
from typing import Any

from coursework.equations.codegen.names import public
from coursework.system.frozen import changing, frozen

_MATH = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "sqrt", "pow", "abs", "sign", "pi")
# Shares of free rates in velocities, masses, inertias, constants of positions, corrections, matrix of the equations of motion.
_OF_FORCES = re.compile(r"_(?:u\d+_\w+|(?:m|j|jf|kept|step|near|mass|force)\d*(?:_n)?)")


@frozen
class Syntax:
    """The syntax in which languages differ: reserved words, the choice of two values, comments, loops, functions by name."""

    reserved: frozenset[str]
    choice: str
    comment: str
    loop: tuple[str, str]
    calls: Mapping[str, str] = field(default_factory=dict)
    rows: tuple[str, str] = ("", "")  # the loop over the rows
    test: tuple[str, str] = ("", "")
    stop: tuple[str, ...] = ()  # lines for a determinant that is zero
    prints: str = ""  # how the head line is printed
    assign: str = " = "
    end: str = ";"
    knows_case: bool = True
    declares: str = ""  # before the first assignment to a name inside a loop
    wrap: str = ""  # end of a line that is continued
    around: tuple[str, str] = ("", "")  # brackets around a value of several lines
    unpacks: str = ""  # how several names take the results of one function; "" if functions have one result
    divides: bool = False  # whether a column can be divided by a matrix
    brackets: tuple[str, str] = ("[", "]")  # brackets of a list of numbers
    node: str = "[s]"  # entry s of a list
    texts: Mapping[str, str] = field(default_factory=dict)  # texts of the listing, of its pieces, of its own functions


@cache
def syntax_of(language: str) -> Syntax:
    """Return the syntax of a language of `languages.toml`.

    >>> syntax_of("c").loop
    ('for (int {j} = 0; {j} < {times}; {j}++) {', '}')
    """
    text = Path(__file__).with_name("languages.toml").read_text(encoding="utf-8")
    told: dict[str, Any] = tomllib.loads(text)[language]
    told |= {key: tuple(value) for key, value in told.items() if isinstance(value, list)}
    return Syntax(**{**told, "reserved": frozenset(told["reserved"].split()) | {*_MATH}})


def filled(text: str, /, **known: object) -> str:
    """Return a text with the names in braces replaced by their values; other braces belong to the language.

    >>> filled("return ({kind}) {{outs}};", kind="Velocities", outs="w3, w4")
    'return (Velocities) {w3, w4};'
    """
    for name, value in known.items():
        text = text.replace(f"{{{name}}}", str(value))
    return text


@changing
class Names:
    """The names of a listing: those of the page if the language allows them, each of them unique."""

    syntax: Syntax
    declared: Collection[str]
    _found: dict[str, str] = field(default_factory=dict)
    _taken: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self._taken.update(map(self._key, self.syntax.reserved))

    def __getitem__(self, name: str) -> str:
        if name not in self._found:
            self._found[name] = self._free(self._shown(name))
        return self._found[name]

    def own(self, key: str, *wishes: str) -> str:
        """Return a name that only the listing has: the first of the wishes that is free."""
        if key not in self._found:
            wish = next((one for one in wishes if self._key(one) not in self._taken), wishes[-1])
            self._found[key] = self._free(wish)
        return self._found[key]

    def _free(self, wish: str) -> str:
        while self._key(wish) in self._taken:
            wish = f"{wish}_"
        self._taken.add(self._key(wish))
        return wish

    def _key(self, word: str) -> str:
        return word if self.syntax.knows_case else word.lower()

    def _shown(self, name: str) -> str:
        if name.startswith("_det"):
            return f"D{int(name[4:]) + 1}"
        if name.startswith("_acc"):
            return f"acc{int(name[4:]) + 1}"
        if name.startswith(("_rate_", "_closed_")):
            kind, _, coordinate = name[1:].partition("_")
            return f"{'d' if kind == 'rate' else ''}{coordinate}{'_closed' * (kind == 'closed')}"
        if _OF_FORCES.fullmatch(name):
            return name[1:].replace("v_", "").removesuffix("_n")
        if name.startswith("_end"):
            number, _, law = name[4:].partition("_")
            return f"{law}_end{int(number) + 1}"
        if name.startswith("_table_"):
            return f"{'slope' if name.endswith('_1') else 'value'}_{name[7:-2]}"
        if name[0] == "d" and name[1:2].isdigit():
            above, below = public(name, tuple(self.declared)).replace("∂", "d").split("/")
            return f"{above}_{below}"
        text = public(name, tuple(self.declared)) if name[:2] == "v_" or name == "t" else name
        return text.strip("_") + "_" * (text != text.strip("_")) if text.strip("_") else "x"


def expression(text: str, syntax: Syntax, names: Mapping[str, str] | Names) -> str:
    """Return a generated expression in a language.

    >>> names = Names(syntax_of("pascal"), ("t", "r", "R"))
    >>> expression("-v_r*pow(v_R, 3.0)", syntax_of("pascal"), names)
    '-r*power(R_, 3.0)'
    """
    return written(ast.parse(text, mode="eval").body, syntax, names)


def parts(text: str, syntax: Syntax, names: Names) -> list[str]:
    """Return the expressions in a call such as `_solve((a, b))`, one by one."""
    call = ast.parse(text, mode="eval").body
    assert isinstance(call, ast.Call) and isinstance(call.args[0], ast.Tuple)
    return [written(one, syntax, names) for one in call.args[0].elts]


_SIGNS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Gt: ">"}


def written(node: ast.expr, syntax: Syntax, names: Mapping[str, str] | Names) -> str:
    """Return a generated and parsed expression in a language, or as the formula of a cell."""

    def inner(one: ast.expr) -> str:
        return written(one, syntax, names)

    match node:
        case ast.Constant():
            return repr(node.value)
        case ast.Name():
            return names[node.id]
        case ast.UnaryOp():
            held = isinstance(node.operand, (ast.BinOp, ast.UnaryOp)) and not _is_product(node.operand)
            return f"-({inner(node.operand)})" if held else f"-{inner(node.operand)}"
        case ast.BinOp():
            sign, left, right = _SIGNS[type(node.op)], inner(node.left), inner(node.right)
            if _is_product(node):
                left = f"({left})" if _is_sum(node.left) else left
                right = f"({right})" if isinstance(node.right, (ast.BinOp, ast.UnaryOp)) else right
                return f"{left}{sign}{right}"
            right = f"({right})" if _is_sum(node.right) or isinstance(node.right, ast.UnaryOp) else right
            return f"{left} {sign} {right}"
        case ast.Compare():
            return f"{inner(node.left)} {_SIGNS[type(node.ops[0])]} {inner(node.comparators[0])}"
        case ast.Call(func=ast.Name(id="_choose"), args=[holds, ast.Lambda(body=yes), ast.Lambda(body=no)]):
            return filled(syntax.choice, holds=inner(holds), yes=inner(yes), no=inner(no))
        case ast.Call(func=ast.Name(id=name)):
            called = names[name] if name.startswith("_table_") else syntax.calls.get(name, name)
            args = node.args[::-1] if called == "ATAN2" else node.args  # a spreadsheet has x before y
            return f"{called}({', '.join(map(inner, args))})"
    raise AssertionError(ast.dump(node))


def _is_sum(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub))


def _is_product(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Mult, ast.Div))
