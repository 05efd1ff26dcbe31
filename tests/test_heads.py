"""The head of a module tells who uses it, and that is true: each file named imports it."""

import ast
import re
from functools import cache
from pathlib import Path

from tests.sources import PACKAGE, files, nodes, tree

PATHS = [path.relative_to(PACKAGE) for path in files()]
USED = re.compile(r"\b(?:[Uu]sed|[Rr]ead|[Mm]ade)(?: only)? by (.*?)(?:\.(?:\s|$)|;)", re.S)
NAMES = re.compile(r"`([\w/]+(?:\.py|/))`")


def dotted(path: Path) -> str:
    parts = ("coursework", *path.with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported(path: Path) -> set[str]:
    found = [node for node in nodes(path) if isinstance(node, ast.ImportFrom) and node.module]
    return {node.module for node in found} | {f"{node.module}.{alias.name}" for node in found for alias in node.names}


@cache
def users() -> dict[Path, list[Path]]:
    """Return for each module those that import it."""
    imports = {path: imported(PACKAGE / path) for path in PATHS}
    return {path: [user for user, names in imports.items() if dotted(path) in names] for path in PATHS}


def head(path: Path) -> str:
    return ast.get_docstring(tree(PACKAGE / path)) or ""


def is_one(user: Path, named: str) -> bool:
    return named.strip("/") in {user.as_posix(), user.name, *map(str, user.parent.parts), user.parent.as_posix()}


def test_who_is_said_to_use_a_module_imports_it():
    told = [(path, name) for path in PATHS for said in USED.findall(head(path)) for name in NAMES.findall(said)]
    assert len(told) > 100
    wrong = [(path, named) for path, named in told if not any(is_one(user, named) for user in users()[path])]
    assert not wrong, [f"{path} is used by {sorted(map(str, users()[path]))}, not by {named}" for path, named in wrong]


def test_a_module_that_others_import_says_who_uses_it():
    said = re.compile(r"\b[Uu]sed\b|[Rr]ead by|[Mm]ade by|every floor")
    used = [path for path in PATHS if path.name != "__init__.py" and any(user != path for user in users()[path])]
    assert [str(path) for path in used if not said.search(head(path))] == []
