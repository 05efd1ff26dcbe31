"""Fixtures of the report's tests: real runs and readers of pages."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

HERE = Path(__file__).parent


def _load(name: str) -> ModuleType:
    """Load a file beside this one (the tests are no package)."""
    full = f"report_tests_{name}"
    if full not in sys.modules:
        spec = importlib.util.spec_from_file_location(full, HERE / f"{name}.py")
        assert spec is not None and spec.loader is not None
        sys.modules[full] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[full])
    return sys.modules[full]


@pytest.fixture(scope="session")
def real() -> ModuleType:
    """Real runs, and readers of their model."""
    return _load("real")


@pytest.fixture(scope="session")
def reading() -> ModuleType:
    """Readers of what the report wrote."""
    return _load("reading")
