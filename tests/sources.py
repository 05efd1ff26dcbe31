"""The package's own files, parsed once a process: many tests look through all of them."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parent.parent / "coursework"


@cache
def files() -> tuple[Path, ...]:
    """Return the Python files of the package, sorted."""
    return tuple(sorted(PACKAGE.rglob("*.py")))


@cache
def text(path: Path) -> str:
    """Return what a file says."""
    return path.read_text(encoding="utf-8")


@cache
def tree(path: Path) -> ast.Module:
    """Return a file parsed; nobody changes the tree."""
    return ast.parse(text(path))


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """Return all nodes of a file, in the order of `ast.walk`."""
    return tuple(ast.walk(tree(path)))


@cache
def strings(path: Path) -> frozenset[object]:
    """Return the constants of a file that are not docstrings."""
    prose = {id(node.value) for node in nodes(path) if isinstance(node, ast.Expr)}
    return frozenset(node.value for node in nodes(path) if isinstance(node, ast.Constant) and id(node) not in prose)
