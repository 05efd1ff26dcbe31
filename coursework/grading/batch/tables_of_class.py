"""The variants of a class -> Euler's tables of all of them, for finding a table made with somebody else's data.

Enters: variants by name.  Leaves: rows by name, plain numbers.  Used by the command, before the children start.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.variant.record.variant import Variant

MOST = 500  # variants; beyond these a class is a university, and looking through all of them helps nobody


def class_tables(variants: Mapping[str, Variant]) -> dict[str, list[list[float]]]:
    """Return the tables, nothing where everybody has the same variant."""
    if not 1 < len(variants) <= MOST:
        return {}
    from coursework.grading.marking.key import tables_of

    return {name: rows.tolist() for name, rows in tables_of(variants).items()}
