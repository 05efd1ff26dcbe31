"""Fixtures of the report's tests: real runs and readers of pages."""

from __future__ import annotations

from types import ModuleType

import pytest

from tests.report import reading as readers
from tests.report import real as runs


@pytest.fixture(scope="session")
def real() -> ModuleType:
    """Real runs, and readers of their model."""
    return runs


@pytest.fixture(scope="session")
def reading() -> ModuleType:
    """Readers of what the report wrote."""
    return readers
