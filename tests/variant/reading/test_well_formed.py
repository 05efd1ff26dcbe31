"""What reads a well-formed file and pydantic, which tells the faults of others: the same files, the same records.

Both are made from the annotations of `schema.py`; pydantic is the judge.
"""

import copy
import random
import tomllib
from pathlib import Path

import pytest
from pydantic import ValidationError

from coursework.variant.reading import schema
from coursework.variant.reading.models import model_of
from coursework.variant.reading.well_formed import Unfit, fitted
from coursework.variant.toml.source import read_source
from coursework.words.data_folders import folder
from coursework.words.errors import InputError

TESTS = Path(__file__).parents[2]
FILES = sorted(
    path
    for place in (folder("variants"), folder("reports"), TESTS)
    for path in place.rglob("*.toml")
    if not path.name.startswith(("words.", "ranges"))
)
OTHERS = (
    True,
    0,
    1,
    -1,
    1.5,
    2**70,
    float("nan"),
    "",
    "x",
    "−3.1",
    "+1",
    "x" * 41,
    "x" * 301,
    "x" * 2001,
    [],
    ["x"],
    {},
    {"x": 1},
)


def as_dumped(value):
    """Return a record as pydantic's `model_dump` gives it."""
    if isinstance(value, schema.Section):
        return {name: as_dumped(getattr(value, name)) for name in value.__annotations__}
    if isinstance(value, dict):
        return {key: as_dumped(each) for key, each in value.items()}
    return [as_dumped(each) for each in value] if isinstance(value, list) else value


def read_twice(data):
    """Return what both read, as texts, so that 1 is not True; None for what does not fit."""
    try:
        ours = repr(as_dumped(fitted(schema.VariantFile, data)))
    except Unfit:
        ours = None
    try:
        theirs = repr(model_of(schema.VariantFile).model_validate(data).model_dump())
    except ValidationError:
        theirs = None
    return ours, theirs


def test_the_same_of_every_file():
    read = 0
    for path in FILES:
        try:
            data = read_source(path.read_bytes(), path.name, {}).data
        except InputError:
            continue  # no TOML, or a number beyond all bounds: never comes so far
        ours, theirs = read_twice(data)
        assert ours == theirs, path
        read += ours is not None
    assert 35 < read < len(FILES)


def paths(data, before=()):
    """Yield the path of every value."""
    for key, value in data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ():
        yield (*before, key)
        yield from paths(value, (*before, key))


@pytest.mark.parametrize("name", ["31", "v107", "prp", "variable-crank-table", "engine-start"])
def test_the_same_of_files_with_another_value_or_key_somewhere(name):
    chance = random.Random(name)
    data = tomllib.loads((folder("variants") / f"{name}.toml").read_text(encoding="utf-8"))
    verdicts = set()
    for path in [*paths(data)] * 3:
        changed = copy.deepcopy(data)
        owner = changed
        for part in path[:-1]:
            owner = owner[part]
        if isinstance(owner, dict) and chance.random() < 0.2:
            owner[chance.choice(["unit", "from", "x" * 41, ""])] = owner.pop(path[-1])
        else:
            owner[path[-1]] = chance.choice(OTHERS)
        ours, theirs = read_twice(changed)
        assert ours == theirs, (path, owner)
        verdicts.add(ours is None)
    assert verdicts == {True, False}


@pytest.mark.parametrize("kind", schema.Section.__subclasses__())
def test_no_other_key_is_taken(kind):
    with pytest.raises(Unfit):
        fitted(kind, {"no such key": 1})


@pytest.mark.parametrize("rest", ["", "\n", "   \n# of the list\n\n[given]\nr = '1 m'\n"])
@pytest.mark.parametrize("items", ['"a", "bc"', '\n  "a",\n  "bc"'])
def test_a_list_that_is_not_closed_is_told_where_its_last_item_ends(items, rest):
    begun = f"format = 1\nx = [{items}"
    with pytest.raises(InputError) as caught:
        read_source((begun + rest).encode(), "a.toml", TESTS)
    (fault,) = caught.value.faults
    assert (fault.line, fault.column) == (begun.count("\n") + 1, len(begun.splitlines()[-1]) + 1)
