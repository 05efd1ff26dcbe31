"""The examples in docstrings run as written, and everything public has one."""

import doctest
import importlib
import importlib.util
import inspect
import linecache
import pkgutil
from collections.abc import Iterator

import pytest

import coursework
from coursework import procedures

MODULES = [m.name for m in pkgutil.walk_packages(coursework.__path__, "coursework.") if not m.name.endswith("__main__")]
WITH_EXAMPLES = [name for name in MODULES if ">>> " in (importlib.util.find_spec(name).loader.get_source(name) or "")]


@pytest.fixture(scope="module", autouse=True)
def no_look_at_every_source() -> Iterator[None]:
    """For each docstring doctest readies a debugger, which asks the disk whether any source read so far has changed."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(linecache, "checkcache", lambda filename=None: None)
        yield


def test_every_module_is_imported():
    assert len([importlib.import_module(name) for name in MODULES]) > 600


@pytest.mark.parametrize("name", WITH_EXAMPLES)
def test_examples(name):
    failed, _ = doctest.testmod(importlib.import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert not failed


PUBLIC = {
    name: thing
    for room in (coursework, procedures, coursework.groups)
    for name in room.__all__
    if inspect.isfunction(thing := getattr(room, name)) or inspect.isclass(thing)
}


@pytest.mark.parametrize("name", PUBLIC)
def test_examples_run_when_pasted_alone(name):
    """What a reader pastes into an empty interpreter finds every name it uses."""
    runner = doctest.DocTestRunner(verbose=False, optionflags=doctest.NORMALIZE_WHITESPACE)
    for example in doctest.DocTestFinder().find(PUBLIC[name], name, globs={}):
        example.globs = {"__name__": "__main__"}
        assert not runner.run(example).failed


@pytest.mark.parametrize("name", PUBLIC)
def test_what_is_public_shows_how_it_is_used(name):
    """A function is called in its example; a class is one that the user makes, or has from a function."""
    thing = PUBLIC[name]
    assert thing.__module__ in MODULES
    lines = [example.source for example in doctest.DocTestParser().get_examples(thing.__doc__ or "")]
    assert lines
    assert inspect.isclass(thing) or any(f"{name}(" in line for line in lines)
