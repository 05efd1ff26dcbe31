"""Fixtures of the live page: pages written as a user writes them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import coursework
from coursework.report.output.formats import chosen
from coursework.report.output.results import Results
from coursework.variant.record.variant import Variant
from tests.solved import solved

Written = Callable[..., Path]


@pytest.fixture(scope="session")
def written(tmp_path_factory: pytest.TempPathFactory) -> Written:
    """Write page and tables of a run into a folder of their own, each run once."""
    folders: dict[object, Path] = {}

    def write(variant: str | Variant, *, live: bool = True, **options: Any) -> Path:
        key = (variant if isinstance(variant, str) else repr(variant.changes), live, *sorted(options.items()))
        if key not in folders:
            folder = tmp_path_factory.mktemp("page")
            run = solved(variant, **options) if isinstance(variant, str) else coursework.solve(variant, **options)
            results = Results(run, live=live)
            for each in chosen(("html", "csv"), "run"):
                for name, content in each.write(results):
                    (folder / name).write_bytes(content)
            folders[key] = folder
        return folders[key]

    return write
