"""What a file lacks for the check by drawing: asked before anything is computed, so it imports nothing that computes.

Enters: a variant.  Leaves: a sentence.  Used by `graph_check.py` and `quantities.py`.
"""

from __future__ import annotations

from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def lacking(variant: Variant) -> Sentence | None:
    """Return a sentence that names all that is missing, None if a drawing can be made."""
    wanted = (
        ("[points]", variant.points or variant.groups),
        ("[links]", variant.links or variant.groups),
        (say("graph.frame"), variant.frame.hinges or variant.frame.rails or variant.frame.circles),
    )
    missing = tuple(name for name, there in wanted if not there)
    return say("fault.V516", missing=missing) if missing else None
