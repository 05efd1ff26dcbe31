"""The examples in docstrings run as written, and every public function has one."""

import doctest
import importlib
import inspect
import pkgutil

import pytest

import coursework
from coursework import groups, procedures

MODULES = [m.name for m in pkgutil.walk_packages(coursework.__path__, "coursework.") if not m.name.endswith("__main__")]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name):
    failed, _ = doctest.testmod(importlib.import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert not failed


PUBLIC = {
    name: function
    for room in (coursework, procedures, groups)
    for name in room.__all__
    if inspect.isfunction(function := getattr(room, name))
}


@pytest.mark.parametrize("name", PUBLIC)
def test_a_public_function_shows_how_it_is_called(name):
    function = PUBLIC[name]
    assert function.__module__ in MODULES
    calls = [example.source for example in doctest.DocTestParser().get_examples(function.__doc__ or "")]
    assert any(f"{name}(" in call for call in calls)
