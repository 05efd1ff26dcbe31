"""A text that still knows its key and the values it was made of.

Enters: English text, its key in the words files, the values in it.  Leaves: `Sentence`.
Used by `errors.py`, which carries it, and `sentences.py`, which makes it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class Sentence(str):
    """English text with its `key` and `values`; values may be numbers, texts, sentences, or tuples that become a list."""

    key: str
    values: Mapping[str, object]

    def __new__(cls, text: str, key: str, values: Mapping[str, object]) -> Sentence:
        """Return the text with its key and values."""
        made = super().__new__(cls, text)
        made.key, made.values = key, values
        return made

    def plain(self) -> dict[str, Any]:
        """Return the values for a JSON file; numbers stay numbers, everything else becomes a text.

        >>> Sentence("row 3: 1.5 rad", "told", {"row": 3, "found": (1.5, Sentence("rad", "unit", {}))}).plain()
        {'row': 3, 'found': [1.5, 'rad']}
        """
        return {name: _plain(value) for name, value in self.values.items()}

    def __getnewargs__(self) -> tuple[str, str, Mapping[str, object]]:  # type: ignore[override]
        """Return the arguments from which a copy in another process is made."""
        return str(self), self.key, self.values


def _plain(value: object) -> Any:
    if isinstance(value, (list, tuple)):
        return [_plain(part) for part in value]
    return value if isinstance(value, (int, float)) else str(value)
