"""What may be missing where links and joints leave more freedoms than are driven: a link at a pivot, a point in a link.

Enters: a `Mechanism`.  Leaves: sentences.  Used by `loose.py` and `mobility.py`.
"""

from __future__ import annotations

from coursework.mechanism.mechanism import Mechanism
from coursework.mechanism.structure import as_one
from coursework.variant.formula.tree import spelled
from coursework.variant.judging.unused import bare_hinges
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def left_out(mechanism: Mechanism) -> list[Sentence]:
    """Return a sentence for each pivot that no link has, and for each link that is joined to the others once or not at all."""
    told = [say("fault.meet.bare", point=point) for point in bare_hinges(mechanism.variant)]
    if mechanism.linkage is None or not mechanism.variant.links:
        return told
    linkage = as_one(mechanism.linkage)
    for body in linkage.bodies:
        joints = [joint for joint in linkage.joints if body in joint.bodies]
        if not joints:
            told.append(say("fault.meet.never", link=body))
        elif len(joints) == 1 and joints[0].where is not None:
            told.append(say("fault.meet.once", link=body, place=spelled(joints[0].where)))
    return told
