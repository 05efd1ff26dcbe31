"""JSON text -> lists, objects and scalars, without losing the digits of numbers or repeated names as other readers do.

Enters: text.  Leaves: lists, `JsonObject`s, `JsonNumber`s, texts, booleans, None.  Raises `Refused`.
Used by `json_data.py` and `notebook.py`.
"""

from __future__ import annotations

import json
import re
from typing import Any

from coursework.grading.reading.limits import unreadable
from coursework.system.frozen import frozen

_TEXT = re.compile(r'"(?:[^"\\]++|\\.)*+"?', re.DOTALL)
_SIGN = re.compile(rf"{_TEXT.pattern}|[\[{{]|[\]}}]", re.DOTALL)
_BARE_POINT = re.compile(r"(?<=\d)\.(?=[\s,\]}])")  # of a number that NumPy prints: 0.


class JsonNumber(str):
    """A number as written in the file, including NaN and Infinity."""

    __slots__ = ()


@frozen
class JsonObject:
    """Pairs (name, value) in their order; a name may occur twice."""

    pairs: tuple[tuple[str, Any], ...]

    def value(self, name: str) -> Any:
        """Return the first value of a name, None if there is none."""
        return next((value for key, value in self.pairs if key == name), None)


def is_json(text: str) -> bool:
    """Return whether a text begins like JSON: an object, or a list of objects, lists, texts or numbers."""
    number = r"(?:null|NaN|-?\d[\d.eE+-]*)\s*(?:,|\]\s*(?:[,\]]|\Z))"  # in a list; but [16] before an equation is its label
    begins = rf'[\ufeff\s]*(?:\{{\s*["}}]|(?:\[\s{{0,9}}){{3}}|(?:\[\s{{0,9}}){{1,2}}(?:[{{"\]]|{number}))'
    begun = text[:2000]
    return re.match(begins, begun) is not None and not re.search(r"[*(=]", _TEXT.sub("", begun))  # signs of a matrix of formulas


def read_json(text: str, levels: int) -> Any:
    """Return the data in a text.  Raises `Refused` if it is damaged or nested deeper than `levels` brackets."""
    depth = 0
    for found in _SIGN.finditer(text):
        sign = found[0][0]
        depth += 1 if sign in "[{" else -1 if sign in "]}" else 0
        if depth > levels:
            raise unreadable("json_deep", levels=levels)
    bare = text.lstrip("\ufeff")
    try:
        return _loaded(bare)
    except (ValueError, RecursionError):
        lines = [line.rstrip(", \t") for line in bare.split("\n") if line.strip()]
    try:  # one record per line
        return _loaded(f"[{','.join(lines)}]" if all(line.endswith(("}", "]")) for line in lines) else "")
    except (ValueError, RecursionError) as error:
        raise unreadable("json_damaged") from error


def _loaded(text: str) -> Any:
    return json.loads(
        text if '"' in text else _BARE_POINT.sub("", text),
        object_pairs_hook=lambda pairs: JsonObject(tuple(pairs)),
        parse_float=JsonNumber,
        parse_int=JsonNumber,
        parse_constant=JsonNumber,
    )
