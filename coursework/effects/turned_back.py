"""Two names of one turning, in opposite senses: w = -w1 in a constraint, where a link turns against the angle that moves it.

Enters: a variant.  Leaves: the pairs of rates.  Used by `scheme.py`.
"""

from __future__ import annotations

from coursework.variant.formula.tree import signed
from coursework.variant.record.variant import Variant


def turned_back(variant: Variant) -> list[set[str]]:
    r"""Return the pairs of rates whose sum is zero by an equation of the file.

    >>> import coursework
    >>> text = coursework.load("example-1").path.read_text(encoding="utf-8")
    >>> text = text.replace("[time]", '[unknowns]\nw = "1/s"\n[time]', 1) + '[[constraint]]\nequation = "w = -w3"'
    >>> [sorted(pair) for pair in turned_back(coursework.parse_variant(text))]
    [['w', 'w3']]
    """
    velocities = [list(signed(one.difference)) for one in variant.constraints if not one.is_closure]
    pairs = [terms for terms in velocities if len({sign for _, sign in terms}) == 1 and len(terms) == 2]
    return [{term.name for term, _ in terms} for terms in pairs if all(term.op == "name" for term, _ in terms)]
