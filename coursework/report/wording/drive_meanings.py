"""What the constants of a drive mean: a speed, its direction, the amplitude, frequency and phase of its sines.

Enters: a `Variant`.  Leaves: names with sentences that are written in the language of a page later.
Used by `data_meanings.py`.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.variant.formula.tree import Formula, terms
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say

_WAVES = {"sin", "cos"}


def drive_meanings(variant: Variant) -> Iterator[tuple[str, str]]:
    """Yield what the constants of the drive are, those in doubt not at all; a name may come more than once.

    >>> import coursework
    >>> dict(drive_meanings(coursework.load("31")))["alpha"]
    'phase of the drive'
    """
    formulas = [(law.name, formula) for law in variant.drive for formula in law.formulas]
    for law, formula in formulas:
        turned = formula.args[0] if formula.op == "neg" else formula
        if turned.op == "name":
            yield turned.name, say("datum.speed", name=law)
    for _, formula in formulas:
        for wave in _waves(formula):
            if _swings(wave):
                yield from _inside(wave)
    headings = dict(_headings(formulas))
    for name, vector in headings.items():
        yield name, say("datum.heading", name=vector)
    turning = {coordinate.rate: coordinate.name for coordinate in variant.coordinates}
    for law, formula in formulas:
        for term in terms(formula):
            yield from _size(term, law, headings)
            if law in turning:
                yield from _swing(term, turning[law])


def _inside(wave: Formula) -> Iterator[tuple[str, str]]:
    """Yield what stands in sin(p*t + alpha), sin(2*pi*f*t) or sin(2*pi*t/T)."""
    for part in terms(wave.args[0]):
        above, below = _product(part)
        names = [factor.name for factor in above if factor.op == "name"]
        turns = "pi" in names
        if part.op == "name" and part.name != "t":
            yield part.name, say("datum.phase")
        elif "t" in names:
            yield from ((name, say("datum.cycles" if turns else "datum.frequency")) for name in names if name not in {"t", "pi"})
            if turns:
                yield from ((factor.name, say("datum.repeats")) for factor in below if factor.op == "name")


def _headings(formulas: list[tuple[str, Formula]]) -> Iterator[tuple[str, str]]:
    """Yield beta and "VM" where VMx has the factor cos(beta) and VMy the factor sin(beta)."""
    turned = {(law, name) for law, formula in formulas for name in _constant_waves(formula)}
    for law, (function, angle) in sorted(turned):
        if law.endswith("x") and function == "cos" and (f"{law[:-1]}y", ("sin", angle)) in turned:
            yield angle, law[:-1]


def _constant_waves(formula: Formula) -> Iterator[tuple[str, str]]:
    for wave in _waves(formula):
        if wave.args[0].op == "name" and not _swings(wave):
            yield wave.name, wave.args[0].name


def _size(term: Formula, law: str, headings: dict[str, str]) -> Iterator[tuple[str, str]]:
    """Yield V1 of V1*sin(p*t), of V1*sin(p*t)*cos(beta) and of V1*cos(beta), where it alone sizes the term."""
    above, below = _product(term)
    heading = next((headings[angle] for factor in above for _, angle in _constant_waves(factor) if angle in headings), None)
    sizes = [factor for factor in above if not [*_waves(factor)]]
    swinging = any(_swings(wave) for factor in above for wave in _waves(factor))
    if below or len(sizes) != 1 or sizes[0].op != "name" or not (swinging or heading):
        return
    yield sizes[0].name, say("datum.amplitude" if swinging else "datum.speed", name=heading or law)


def _swing(term: Formula, coordinate: str) -> Iterator[tuple[str, str]]:
    """Yield A of A*p*cos(p*t), the rate of a coordinate that swings by A to each side."""
    above, below = _product(term)
    waves = [factor for factor in above if factor.op == "call" and _swings(factor)]
    sizes = [factor.name for factor in above if factor.op == "name"]
    if below or len(waves) != 1 or waves[0].name not in _WAVES or len(sizes) != 2 or len(above) != 3:
        return
    turned = [name for part in terms(waves[0].args[0]) for name in part.names() if "t" in part.names() and name != "t"]
    if len(turned) == 1 and turned[0] in sizes and sizes[0] != sizes[1]:
        yield next(name for name in sizes if name != turned[0]), say("datum.amplitude", name=coordinate)


def _waves(formula: Formula) -> Iterator[Formula]:
    return (node for node in formula.walk() if node.op == "call" and node.name in _WAVES)


def _swings(wave: Formula) -> bool:
    return "t" in wave.names()


def _product(tree: Formula) -> tuple[list[Formula], list[Formula]]:
    """Return the factors above and below the line."""
    if tree.op not in {"*", "/"}:
        return [tree], []
    above, below = _product(tree.args[0])
    over, under = _product(tree.args[1])
    return ([*above, *over], [*below, *under]) if tree.op == "*" else ([*above, *under], [*below, *over])
