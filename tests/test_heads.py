"""The head of a module tells who uses it, and that is true: each file named imports it."""

import ast
import re
from pathlib import Path

import pytest

from tests.sources import PACKAGE, files, nodes, tree

TREES = {path.relative_to(PACKAGE): tree(path) for path in files()}
USED = re.compile(r"\b(?:[Uu]sed|[Rr]ead|[Mm]ade)(?: only)? by (.*?)(?:\.(?:\s|$)|;)", re.S)


def dotted(path: Path) -> str:
    parts = ("coursework", *path.with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported(path: Path) -> set[str]:
    found = [node for node in nodes(path) if isinstance(node, ast.ImportFrom) and node.module]
    return {node.module for node in found} | {f"{node.module}.{alias.name}" for node in found for alias in node.names}


IMPORTS = {path: imported(PACKAGE / path) for path in TREES}
USERS = {
    path: [user for user, names in IMPORTS.items() if name in names] for path, name in zip(TREES, map(dotted, TREES), strict=True)
}
NAMED = [
    (path, named)
    for path, tree in TREES.items()
    for told in USED.findall(ast.get_docstring(tree) or "")
    for named in re.findall(r"`([\w/]+(?:\.py|/))`", told)
]


@pytest.mark.parametrize(("path", "named"), NAMED, ids=lambda part: str(part))
def test_who_is_said_to_use_a_module_imports_it(path, named):
    users = USERS[path]
    hit = [
        user
        for user in users
        if named.strip("/") in {user.as_posix(), user.name, *map(str, user.parent.parts), user.parent.as_posix()}
    ]
    assert hit, f"{path} is used by {sorted(map(str, users))}, not by {named}"


def test_many_heads_are_looked_at():
    assert len(NAMED) > 100


@pytest.mark.parametrize("path", [path for path in TREES if path.name != "__init__.py"], ids=str)
def test_a_module_that_others_import_says_who_uses_it(path):
    used = any(user != path for user in USERS[path])
    said = re.search(r"\b[Uu]sed\b|[Rr]ead by|[Mm]ade by|every floor", ast.get_docstring(TREES[path]) or "")
    assert said or not used
