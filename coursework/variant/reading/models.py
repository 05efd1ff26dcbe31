"""The pydantic models of the records of the schema: they find the faults of a file and give the JSON schema for editors.

Enters: `schema.py`.  Leaves: models, made when the first file with a fault is read.  Used by `shape.py` and the desk.
"""

from __future__ import annotations

from functools import cache, partial
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, create_model
from pydantic_core import PydanticCustomError

from coursework.variant.reading.schema import Section, VariantFile


@cache
def model_of(kind: Any) -> type[BaseModel]:
    """Return the pydantic model of a record."""
    fields = {name: (_type_of(told), _default_of(kind, name)) for name, told in kind.__annotations__.items()}
    settings = ConfigDict(extra="forbid", frozen=True, strict=True)
    made: type[BaseModel] = create_model(kind.__name__, __config__=settings, __doc__=kind.__doc__, **fields)  # type: ignore[call-overload]
    return made


def _type_of(kind: Any) -> Any:
    """Return a type of the schema in the form that pydantic accepts."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return Annotated[(_type_of(inner[0]), *(Field(**each.limits) for each in inner[1:]))]
    if origin in {Union, UnionType}:
        union: Any = Union[tuple(map(_type_of, inner))]  # noqa: UP007 (a union of as many types as there are)
        first = any(get_origin(each) is dict for each in inner)  # a table of known keys is tried before a table of arbitrary keys
        return Annotated[union, Field(union_mode="left_to_right")] if first else union
    if origin is Literal:
        return Annotated[kind, BeforeValidator(partial(_of_types, {*map(type, inner)}, ", ".join(map(repr, inner))))]
    if origin in {list, dict}:
        return origin[tuple(map(_type_of, inner))]
    is_table = isinstance(kind, type) and issubclass(kind, Section)
    return model_of(kind) if is_table else kind


def _of_types(types: set[type], expected: str, value: Any) -> Any:
    """Return a value; one of another type is refused, as pydantic takes true and 1.0 for 1."""
    if type(value) not in types:
        raise PydanticCustomError("literal_error", "{expected}", {"expected": expected})
    return value


def _default_of(kind: type[Section], name: str) -> Any:
    value = getattr(kind, name, ...)
    table: Any = type(value)
    return model_of(table)() if issubclass(table, Section) else value


def json_schema() -> dict[str, Any]:
    """Return the JSON schema that editors read from `variants/variant.schema.json`."""
    schema = model_of(VariantFile).model_json_schema(by_alias=True)
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    schema["title"] = "Variant of a mechanism coursework"
    return schema
