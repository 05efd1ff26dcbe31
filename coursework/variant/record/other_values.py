"""Other values for the data, starts, drives and times of a variant, as a caller gives them: by name.

Used by `variant.py` and `changes.py`; `data.py` refuses with the same sentence what has no names.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.system.frozen import frozen
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

Values = Mapping[str, float | str]


def not_by_name(values: object) -> Sentence:
    """Return the message about data without names."""
    return say("fault.D017", found=type(values).__name__)


def by_name(values: Values | None) -> Values:
    """Return data by name; a pandas Series is accepted, although it iterates over its values and has no truth value."""
    if values is None:
        return {}
    if not hasattr(values, "keys"):
        raise InputError(not_by_name(values))
    return {name: values[name] for name in values.keys()}  # noqa: SIM118  a Series iterates over its values


@frozen
class Changes:
    """Other values by name: for data, starts, drives, and times of the run."""

    given: Values
    start: Values
    drive: Values
    times: Values
