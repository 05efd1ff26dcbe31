"""Whether everything in a file measures what it must: one fault at most, the datum named where it is known.

Enters: a `Variant` as read, its `Source`, the formulas of its times.  Leaves: `Dimensions`.  Used by `reader.py` only.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import chain, islice

from coursework.variant.dimensions.exponents import Dimension, is_known, si_unit, symbols
from coursework.variant.dimensions.formulas import Clash, Measurer, Term
from coursework.variant.formula.tree import Formula
from coursework.variant.judging.coordinate_order import fault_of_order, is_angle_first
from coursework.variant.judging.dimension_words import Blame, disagreement_of, fault_of_datum, fault_of_either, fault_of_terms
from coursework.variant.record.places import Place, measures, places
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence

# Names and parts of formulas gone through while a culprit is looked for: half a second; a file of coursework has some hundreds.
_MOST_PARTS = 300_000


@dataclass(frozen=True, slots=True)
class Dimensions:
    """What was found: `places` that were judged, and what each name is `known` to measure.

    `fault`, or in a file whose data carry no units the `disagreement` (path, label, two formulas); `numbers`: terms of
    velocity equations whose number had to measure something (SI unit); `times_as_angles`: calls such as sin(t).
    """

    places: tuple[Place, ...]
    known: Mapping[str, Dimension]
    fault: Fault | None
    disagreement: tuple[KeyPath, Sentence] | None
    numbers: tuple[tuple[KeyPath, Formula, str], ...]
    times_as_angles: tuple[tuple[KeyPath, Formula], ...]

    def si_of(self, name: str) -> str:
        """Return the SI unit of what a name measures, "" where the file does not tell."""
        return si_unit(self.known[name]) if name in self.known else ""


@dataclass(slots=True)
class _Outcome:
    """One pass over a file, up to the first place that cannot hold."""

    measurer: Measurer
    clash: Clash | None = None
    place: Place | None = None
    numbers: list[tuple[KeyPath, Formula, str]] = field(default_factory=list)
    times_as_angles: list[tuple[KeyPath, Formula]] = field(default_factory=list)

    def solved(self, dimension: Dimension) -> Dimension | None:
        found = self.measurer.system.reduced(dimension)
        return found if is_known(found) else None


def check_dimensions(variant: Variant, source: Source, times: Mapping[KeyPath, Formula]) -> Dimensions:
    """Return whether every +, =, argument and place of a file can hold, exponents of length and time being unknowns."""
    names = measures(variant)
    listed = tuple(places(variant, names, times))
    outcome = _pass(variant, names, listed)
    known = {name: found for name in names if (found := outcome.solved(names[name])) is not None}
    fault = disagreement = None
    if outcome.clash and outcome.place:
        if outcome.measurer.measured or outcome.clash.first.tree.si:
            fault = _fault(outcome.clash, outcome.place, outcome, variant, source, times)
        else:
            disagreement = outcome.place.path, disagreement_of(outcome.place, outcome.clash)
    return Dimensions(listed, known, fault, disagreement, tuple(outcome.numbers), tuple(outcome.times_as_angles))


def _freed(variant: Variant, times: Mapping[KeyPath, Formula], free: KeyPath | None = None) -> _Outcome:
    """Return a pass in which the datum at the path `free` may measure anything."""
    names = measures(variant, free)
    return _pass(variant, names, places(variant, names, times))


def _pass(variant: Variant, names: dict[str, Dimension], listed: Iterable[Place]) -> _Outcome:
    measurer = Measurer(names, frozenset(given.name for given in variant.given if given.si))
    outcome = _Outcome(measurer)
    factors = []
    for place in listed:
        counted, angles = len(measurer.factors), len(measurer.times_as_angles)
        try:
            _judge(place, measurer)
        except Clash as clash:
            outcome.clash, outcome.place = clash, place
            break
        outcome.times_as_angles += [(place.path, whole) for whole in measurer.times_as_angles[angles:]]
        if place.velocity:
            factors += [(place.path, factor) for factor in measurer.factors[counted:]]
    for path, factor in factors:
        if measured := outcome.solved({factor.key: 1}):
            outcome.numbers.append((path, factor.term, symbols(measured)))
    return outcome


def _judge(place: Place, measurer: Measurer) -> None:
    tree = place.formulas[0] if len(place.formulas) == 1 else Formula("-", place.formulas)
    found = measurer.measure(tree)
    if place.wanted is not None:
        measurer.compare("place", found, Term(tree, place.wanted))


def _fault(
    clash: Clash, place: Place, outcome: _Outcome, variant: Variant, source: Source, times: Mapping[KeyPath, Formula]
) -> Fault:
    if (swapped := _swapped(variant, source, times)) is not None:
        return swapped
    at = source.path_of(place.path)
    names = outcome.measurer.names
    parts = sum(1 for one in places(variant, names, times) for formula in one.formulas for _ in formula.walk())
    passes = max(1, _MOST_PARTS // (len(names) + parts))
    data = [*_data(variant)]
    tried = data if len(data) <= passes else []
    candidates = [(datum, freed) for datum in tried if (freed := _freed(variant, times, datum.path)).clash is None]
    must = candidates[0][1].solved({candidates[0][0].name: 1}) if len(candidates) == 1 else None
    if must is None or not si_unit(must):
        return source.fault(at, fault_of_terms(place, clash, outcome.solved))
    datum, freed = candidates[0]
    blame = replace(datum, must=must)
    line = source.positions.find(source.path_of(blame.path))[0]
    # The unit of an unknown is read off the equations; and a name left out of a drive, or too many in it, looks like a datum
    # with a strange unit.
    of_formula = place.path[0] in {"drive", "functions"} and (
        freed.times_as_angles or _mends_itself(place, variant, times, passes)
    )
    if of_formula or blame.path[0] == "unknowns":
        return source.fault(at, fault_of_either(blame, line, place, clash, outcome.solved))
    return Fault(fault_of_datum(blame, place, clash, freed.solved), source.file, line)


def _swapped(variant: Variant, source: Source, times: Mapping[KeyPath, Formula]) -> Fault | None:
    """Return the fault of a group whose coordinates stand in the other order, None where no such one makes the file hold."""
    for index, group in enumerate(variant.groups):
        if is_angle_first(group):
            turned = replace(group, coordinates=group.coordinates[::-1])
            groups = (*variant.groups[:index], turned, *variant.groups[index + 1 :])
            if _freed(replace(variant, groups=groups), times).clash is None:
                return fault_of_order(index, group, source)
    return None


def _data(variant: Variant) -> Iterator[Blame]:
    """Yield everything of a file that carries a unit."""
    for given in variant.given:
        if given.si:
            yield Blame(("given", given.name), given.name, given.text, given.unit, given.si)
    for coordinate in variant.coordinates:
        if coordinate.unit_was_given:
            yield Blame(
                ("coordinates", coordinate.name),
                coordinate.name,
                coordinate.text,
                coordinate.written or coordinate.unit,
                coordinate.unit,
            )
    for name, unit in variant.unknowns:
        yield Blame(("unknowns", name), name, "", unit, unit)


def _mends_itself(place: Place, variant: Variant, times: Mapping[KeyPath, Formula], passes: int) -> bool:
    """Return whether the formula holds as soon as one name is taken out of a product, or one term put into a bracket."""
    for shorter in islice(chain(_shortened(place.formulas[0]), _bracketed(place.formulas[0])), passes):
        drive, functions = (
            tuple(replace(law, formula=shorter) if law.name == place.path[1] and law.formula else law for law in laws)
            for laws in (variant.drive, variant.functions)
        )
        if _freed(replace(variant, drive=drive, functions=functions), times).clash is None:
            return True
    return False


def _shortened(tree: Formula) -> Iterator[Formula]:
    """Yield the formula without one of the factors in it that are a name or depend on t alone."""
    for index, arg in enumerate(tree.args):
        if arg.op == "name" or {*arg.names()} == {"t"}:
            if tree.op == "*":
                yield tree.args[1 - index]
            if tree.op == "/" and index == 1:
                yield tree.args[0]
        for shorter in _shortened(arg):
            yield replace(tree, args=(*tree.args[:index], shorter, *tree.args[index + 1 :]))


def _bracketed(tree: Formula) -> Iterator[Formula]:
    """Yield the formula with a term that stands beside a call inside the call: sin(p*t) + alpha as sin(p*t + alpha)."""
    if tree.op in {"+", "-"} and len(tree.args) == 2:
        for whole, term in (tree.args, tree.args[::-1]):
            yield from _with_term(whole, term)
    for index, arg in enumerate(tree.args):
        for other in _bracketed(arg):
            yield replace(tree, args=(*tree.args[:index], other, *tree.args[index + 1 :]))


def _with_term(tree: Formula, term: Formula) -> Iterator[Formula]:
    """Yield the formula with a term added to the argument of one of its calls."""
    if tree.op == "call" and len(tree.args) == 1:
        yield replace(tree, args=(Formula("+", (tree.args[0], term)),))
    for index, arg in enumerate(tree.args):
        for other in _with_term(arg, term):
            yield replace(tree, args=(*tree.args[:index], other, *tree.args[index + 1 :]))
