"""Decorators like `@dataclass`, in a fifth of its time: `@frozen`, `@single` (equal only to itself), `@caching`, `@changing`.

Enters: a class with annotations.  Leaves: a data class.  Used by every floor above.

The standard decorator compiles six methods for each class; for the 160 classes that a table needs, this takes longer than
loading NumPy.  Here all classes share these methods, except `__init__`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, FrozenInstanceError, dataclass, field, fields
from operator import attrgetter
from reprlib import recursive_repr
from typing import Any, NoReturn, TypeVar, dataclass_transform

Kind = TypeVar("Kind")
_NONE = ("ClassVar", "InitVar", "KW_ONLY")  # annotations with these words may declare something that is not a field
_HASH = "the hash"  # no name of a field
_FEW = 16  # objects of a class before its `__init__` is compiled: compiling costs what twenty objects save


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(kind: type[Kind]) -> type[Kind]:
    """Return the frozen data class of `kind`, with slots; methods that the class defines itself are kept."""
    return _made(kind, {"__setattr__": _refuse, "__delattr__": _refuse})


@dataclass_transform(eq_default=False, frozen_default=True, field_specifiers=(field,))
def single(kind: type[Kind]) -> type[Kind]:
    """Return the frozen data class of `kind`, with slots, each object of which equals only itself."""
    alone = {"__eq__": object.__eq__, "__hash__": object.__hash__}
    return _made(kind, {"__setattr__": _refuse, "__delattr__": _refuse, **alone})


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def caching(kind: type[Kind]) -> type[Kind]:
    """Return the frozen data class of `kind` without slots, so that its objects can store cached properties and their hash."""
    made: Any = _made(kind, {"__setattr__": _refuse, "__delattr__": _refuse, "__getstate__": _without_hash}, slots=False)
    made.__hash__ = _once(made.__hash__)
    result: type[Kind] = made
    return result


@dataclass_transform(field_specifiers=(field,))
def changing(kind: type[Kind]) -> type[Kind]:
    """Return the data class that `@dataclass(slots=True)` makes of `kind`: not frozen, not hashable."""
    return _made(kind, {"__hash__": None})


def _made(kind: type[Kind], own: dict[str, Any], *, slots: bool = True) -> type[Kind]:
    kind.__doc__ = kind.__doc__ or kind.__name__  # otherwise `dataclass` builds a docstring from the signature
    told = vars(kind).get("__annotations__", {})
    # `dataclass` parses every annotation to find those that are not fields, half its time: so it sees only doubtful ones.
    kind.__annotations__ = {name: said if any(one in str(said) for one in _NONE) else object for name, said in told.items()}
    made: Any = dataclass(init=False, repr=False, eq=False, slots=slots)(kind)
    made.__annotations__ = told
    for name, said in told.items():
        if name in made.__dataclass_fields__:
            made.__dataclass_fields__[name].type = said
    equal, number = _compared(tuple(one.name for one in fields(made) if one.compare))
    methods = {"__init__": _first_init(made), "__repr__": _repr, "__eq__": equal, "__hash__": number}
    if slots:
        methods |= {"__getstate__": _state, "__setstate__": _restore}
    for name, method in (methods | own).items():
        if vars(kind).get(name) is None:  # Python itself sets __hash__ to None if the class defines __eq__
            setattr(made, name, method)
    result: type[Kind] = made
    return result


def _first_init(made: Any) -> Callable[..., None]:
    """Return the `__init__` for the first objects of a class: most classes have too few objects to be worth compiling one."""
    left, every = _FEW, fields(made)
    wanted = dict.fromkeys(one.name for one in every if one.init)

    def __init__(self: Any, *values: Any, **named: Any) -> None:
        nonlocal left
        left -= 1
        if left < 0 or not _filled(self, every, wanted, values, named):
            made.__init__ = _init(made)
            made.__init__(self, *values, **named)
        elif hasattr(made, "__post_init__"):
            self.__post_init__()

    return __init__


def _filled(self: Any, every: tuple[Any, ...], wanted: dict[str, None], values: tuple[Any, ...], named: dict[str, Any]) -> bool:
    """Set the fields of an object; return False if the arguments are wrong, which the compiled `__init__` then reports."""
    content = dict(zip(wanted, values, strict=False)) | named
    if len(values) + len(named) != len(content) or not content.keys() <= wanted.keys():
        return False
    for one in every:
        if one.name in content:
            value = content[one.name]
        elif one.default_factory is not MISSING:
            value = one.default_factory()
        elif one.default is not MISSING:
            value = one.default
        elif one.init:
            return False
        else:
            continue
        object.__setattr__(self, one.name, value)
    return True


def _init(made: Any) -> Callable[..., None]:
    """Return a compiled `__init__` that sets the fields in the order of the class."""
    scope: dict[str, Any] = {"MISSING": MISSING}
    heads: list[str] = []
    lines: list[str] = [] if "__slots__" in vars(made) else ["    kept = self.__dict__"]
    for place, one in enumerate(fields(made)):
        value, default = one.name, f"default{place}"
        if one.default_factory is not MISSING:
            scope[default], default = one.default_factory, "MISSING"
            value = f"default{place}() if {value} is MISSING else {value}"
        elif one.default is not MISSING:
            scope[default] = one.default
        else:
            default = ""
        if one.init:
            heads.append(f"{one.name}={default}" if default else one.name)
        elif default:
            value = f"default{place}" if default != "MISSING" else f"default{place}()"
        else:
            continue
        if "__slots__" in vars(made):
            scope[f"set{place}"] = getattr(made, one.name).__set__
            lines.append(f"    set{place}(self, {value})")
        else:
            lines.append(f"    kept[{one.name!r}] = {value}")
    if hasattr(made, "__post_init__"):
        lines.append("    self.__post_init__()")
    exec(f"def __init__(self, {', '.join(heads)}):\n" + ("\n".join(lines) or "    pass"), scope)  # field names only
    init: Callable[..., None] = scope["__init__"]
    init.__qualname__ = f"{made.__qualname__}.__init__"  # shown in the error message of a wrong call
    return init


def _compared(names: tuple[str, ...]) -> tuple[Callable[[Any, Any], Any], Callable[[Any], int]]:
    """Return `__eq__` and `__hash__` that use the fields `names`."""
    get = attrgetter(*names) if names else lambda _: ()
    key = get if len(names) != 1 else lambda one: (get(one),)
    return (
        lambda one, other: key(one) == key(other) if other.__class__ is one.__class__ else NotImplemented,
        lambda one: hash(key(one)),
    )


def _once(number: Callable[[Any], int]) -> Callable[[Any], int]:
    """Return the function that hashes an object once: a variant is the key of many caches, and all its formulas count."""

    def hashed(one: Any) -> int:
        kept: dict[str, Any] = one.__dict__
        if _HASH not in kept:
            kept[_HASH] = number(one)
        return int(kept[_HASH])

    return hashed


def _without_hash(self: Any) -> dict[str, Any]:
    return {name: value for name, value in self.__dict__.items() if name != _HASH}  # another process hashes texts otherwise


@recursive_repr()
def _repr(self: Any) -> str:
    shown = ", ".join(f"{one.name}={getattr(self, one.name)!r}" for one in fields(self) if one.repr)
    return f"{type(self).__qualname__}({shown})"


def _refuse(self: Any, name: str, *_: object) -> NoReturn:
    raise FrozenInstanceError(f"{type(self).__name__}.{name} is frozen")


def _state(self: Any) -> list[Any]:
    return [getattr(self, one.name) for one in fields(self)]


def _restore(self: Any, state: list[Any]) -> None:
    for one, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, one.name, value)
