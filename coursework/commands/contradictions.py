"""What is told of equations that contradict the geometry: the search for the term that differs, made when one does.

Used by `check.py` and `run.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from coursework.variant.record.variant import Variant
from coursework.words.errors import InputError


@contextmanager
def terms_named(variant: Variant) -> Iterator[None]:
    """Within it, an `InputError` names the term by which an equation of the variant contradicts the geometry."""
    try:
        yield
    except InputError as error:
        from coursework.desk.answering.contradicted import with_terms

        text = variant.path.read_text(encoding="utf-8-sig") if variant.path is not None else ""
        raise with_terms(error, variant, text) from error
