"""The examples in docstrings run as written."""

import doctest
import importlib
import pkgutil

import pytest

import coursework

MODULES = [m.name for m in pkgutil.walk_packages(coursework.__path__, "coursework.") if not m.name.endswith("__main__")]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name):
    failed, _ = doctest.testmod(importlib.import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert not failed
