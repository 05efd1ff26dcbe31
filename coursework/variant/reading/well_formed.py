"""A file of the right shape -> its records, without pydantic, whose models alone take longer than a table.

Enters: plain data of a TOML file.  Leaves: a `VariantFile`, or `Unfit`, which gives no details.
Used by `shape.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import cache
from types import UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

from coursework.variant.reading.schema import Limits, Section

Read = Callable[[Any], Any]
_FOR_EDITORS = {"alias", "description", "json_schema_extra"}
Kind = TypeVar("Kind", bound=Section)


class Unfit(Exception):
    """The data do not have the shape of the schema."""


def fitted(kind: type[Kind], data: Any) -> Kind:
    """Return the record of type `kind` for a table of a file.  Raises `Unfit`."""
    table: Any = kind
    record: Kind = _reader(table)(data)
    return record


@cache
def _reader(kind: Any) -> Read:
    """Return a function that reads a value of a type."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _within(_reader(inner[0]), inner[1:])
    if origin in {Union, UnionType}:
        return _one_of([_reader(each) for each in inner])
    if origin is Literal:
        return _plain(lambda value: any(value == each and type(value) is type(each) for each in inner))
    if origin is list:
        return _list_of(_reader(inner[0]))
    if origin is dict:
        return _dict_of(*map(_reader, inner))
    if issubclass(kind, Section):
        return _record(kind)
    return _plain(lambda value: isinstance(value, kind) and not isinstance(value, bool))


def _plain(fits: Callable[[Any], bool]) -> Read:
    def read(value: Any) -> Any:
        if not fits(value):
            raise Unfit
        return value

    return read


def _within(read: Read, bounds: Iterable[Limits]) -> Read:
    """Return a reader that also checks limits; those for editors are ignored, any other unknown limit is an error."""
    limits = {name: limit for each in bounds for name, limit in each.limits.items() if name not in _FOR_EDITORS}
    least, most = limits.pop("min_length", 0), limits.pop("max_length", None)
    lowest, pattern = limits.pop("ge", None), re.compile(limits.pop("pattern", ""))
    assert not limits, limits

    def read_within(value: Any) -> Any:
        value = read(value)
        if most is not None and not least <= len(value) <= most:
            raise Unfit
        if (lowest is not None and value < lowest) or (pattern.pattern and not pattern.search(value)):
            raise Unfit
        return value

    return read_within


def _one_of(readers: list[Read]) -> Read:
    def read(value: Any) -> Any:
        for each in readers:
            try:
                return each(value)
            except Unfit:
                continue
        raise Unfit

    return read


def _list_of(read: Read) -> Read:
    listed = _plain(lambda value: isinstance(value, list))
    return lambda value: [read(each) for each in listed(value)]


def _dict_of(read_key: Read, read: Read) -> Read:
    table = _plain(lambda value: isinstance(value, dict))
    return lambda value: {read_key(key): read(each) for key, each in table(value).items()}


def _record(kind: type[Section]) -> Read:
    table = _plain(lambda value: isinstance(value, dict))
    fields = {key: (name, _reader(kind.__annotations__[name])) for key, name in kind.keys().items()}
    needed = {name for name, _ in fields.values() if not hasattr(kind, name)}

    def read(data: Any) -> Section:
        if not table(data).keys() <= fields.keys():
            raise Unfit
        record = kind()
        for key, value in data.items():
            name, read_field = fields[key]
            vars(record)[name] = read_field(value)
        if not vars(record).keys() >= needed:
            raise Unfit
        return record

    return read
