"""The check of all dimensions in a file: one fault for each cause, naming the datum to blame if it is known.

Enters: a `Variant` as read, its `Source`, the formulas of its times.  Leaves: `Dimensions`.  Used by `reader.py` only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from itertools import chain, islice

from coursework.system.frozen import changing, frozen
from coursework.variant.dimensions.exponents import Dimension, is_known, si_unit, symbols
from coursework.variant.dimensions.formulas import Clash, Measurer, Term
from coursework.variant.formula.tree import Formula, replaced
from coursework.variant.judging.coordinate_order import fault_of_order, is_angle_first
from coursework.variant.judging.dimension_words import Blame, disagreement_of, fault_of_datum, fault_of_either, fault_of_terms
from coursework.variant.record.places import Place, measures, places
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence

# Names and nodes visited in the search for one culprit: half a second; a file of coursework has some hundreds of them.
_MOST_PARTS = 300_000
# Independent faults reported at once; an author with more corrects these first.
MOST_FAULTS = 6


@frozen
class Dimensions:
    """The result: the `places` that were checked, and the dimension of each name if `known`.

    Either `faults`, none of which follows from another, or, in a file whose data have no units, one `disagreement` (path and
    sentence).  `numbers` are terms of velocity equations whose number must have a dimension (path, term, SI unit);
    `times_as_angles` are calls such as sin(t).
    """

    places: tuple[Place, ...]
    known: Mapping[str, Dimension]
    faults: tuple[Fault, ...]
    disagreement: tuple[KeyPath, Sentence] | None
    numbers: tuple[tuple[KeyPath, Formula, str], ...]
    times_as_angles: tuple[tuple[KeyPath, Formula], ...]

    def si_of(self, name: str) -> str:
        """Return the SI unit of a name, "" if the file does not determine it."""
        return si_unit(self.known[name]) if name in self.known else ""

    @property
    def only_in_drives(self) -> set[str]:
        """Return the names that stand in formulas of [drive] and of no other section."""
        placed = [(place.path[0] == "drive", name) for place in self.places for one in place.formulas for name in one.names()]
        inside, outside = ({name for is_drive, name in placed if is_drive is side} for side in (True, False))
        return inside - outside


@changing
class _Outcome:
    """One pass over a file: `clashes` by the number of the place; only the first one if the pass ended there."""

    measurer: Measurer
    clashes: dict[int, tuple[Clash, Place]] = field(default_factory=dict)
    numbers: list[tuple[KeyPath, Formula, str]] = field(default_factory=list)
    times_as_angles: list[tuple[KeyPath, Formula]] = field(default_factory=list)

    def solved(self, dimension: Dimension) -> Dimension | None:
        found = self.measurer.system.reduced(dimension)
        return found if is_known(found) else None


def check_dimensions(variant: Variant, source: Source, times: Mapping[KeyPath, Formula]) -> Dimensions:
    """Return the check of every sum, equation, argument and place of a file, with the exponents of dimensions as unknowns."""
    names = measures(variant)
    listed = tuple(places(variant, names, times))
    outcome = _pass(variant, names, listed)
    known = {name: found for name in names if (found := outcome.solved(names[name])) is not None}
    faults, disagreement = [], None
    for clash, place in outcome.clashes.values():
        if outcome.measurer.measured or clash.first.tree.si:
            faults = [*_Search(source, times).faults(variant)]
        else:
            disagreement = place.path, disagreement_of(place, clash)
    return Dimensions(listed, known, tuple(faults), disagreement, tuple(outcome.numbers), tuple(outcome.times_as_angles))


def _pass(variant: Variant, names: dict[str, Dimension], listed: Iterable[Place], whole: bool = False) -> _Outcome:
    measurer = Measurer(names, frozenset(given.name for given in variant.given if given.si))
    outcome = _Outcome(measurer)
    factors = []
    for number, place in enumerate(listed):
        solved = dict(measurer.system.solved)
        counted, angles = len(measurer.factors), len(measurer.times_as_angles)
        try:
            _judge(place, measurer)
        except Clash as clash:
            outcome.clashes[number] = clash, place
            if not whole:
                break
            measurer.system.solved = solved  # a place with a clash tells nothing about the others
            continue
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


# A fault, the numbers of places wrong for other reasons, and the variant and the freed paths with only these left.
_Found = tuple[Fault, frozenset[int], Variant, frozenset[KeyPath]]


@frozen
class _Search:
    """Searches for the causes of clashes, one after the other."""

    source: Source
    times: Mapping[KeyPath, Formula]

    def faults(self, variant: Variant) -> Iterator[Fault]:
        """Yield a fault for each cause; a place that an earlier cause may explain is not reported again."""
        freed: frozenset[KeyPath] = frozenset()
        wanted: frozenset[int] | None = None
        for _ in range(MOST_FAULTS):
            outcome = self._pass(variant, freed)
            left = sorted(number for number in outcome.clashes if wanted is None or number in wanted)
            if not left:
                return
            fault, others, variant, freed = self._found(left[0], outcome, variant, freed)
            yield fault
            wanted = others if wanted is None else wanted & others

    def _pass(self, variant: Variant, freed: frozenset[KeyPath]) -> _Outcome:
        """Return a pass over the whole file in which the data at the paths `freed` may have any dimension."""
        names = measures(variant, freed)
        return _pass(variant, names, places(variant, names, self.times), whole=True)

    def _found(self, number: int, outcome: _Outcome, variant: Variant, freed: frozenset[KeyPath]) -> _Found:
        """Return the cause of the clash at place `number`, the first one."""
        clash, place = outcome.clashes[number]
        before = outcome.clashes.keys()
        for turned, fault in _turned(variant, self.source):
            kept = self._pass(turned, freed).clashes.keys()
            if number not in kept and kept < before:
                return fault, frozenset(kept), turned, freed
        source, at = self.source, self.source.path_of(place.path)
        names = outcome.measurer.names
        parts = sum(1 for one in places(variant, names, self.times) for formula in one.formulas for _ in formula.walk())
        passes = _MOST_PARTS // (len(names) + parts)
        data = [datum for datum in _data(variant) if datum.path not in freed]
        tried = [(datum, self._pass(variant, freed | {datum.path})) for datum in (data if len(data) <= passes else [])]
        mended = [(datum, after) for datum, after in tried if number not in after.clashes and after.clashes.keys() < before]
        fewest = min((len(after.clashes) for _, after in mended), default=0)
        candidates = [(datum, after) for datum, after in mended if len(after.clashes) == fewest]
        must = candidates[0][1].solved({candidates[0][0].name: 1}) if len(candidates) == 1 else None
        if must is None or not si_unit(must):
            fault = source.fault(at, fault_of_terms(place, clash, outcome.solved))
            apart = frozenset(one for one in before if _is_independent(outcome, number, one))
            return fault, apart.intersection(*(after.clashes for _, after in mended)), variant, freed
        datum, after = candidates[0]
        others, now_freed = frozenset(after.clashes), freed | {datum.path}
        blame = replace(datum, must=must)
        line = source.positions.find(source.path_of(blame.path))[0]
        # The unit of an unknown follows from the equations; and a name missing from a drive, or one too many, looks like a
        # datum with a wrong unit.
        of_formula = place.path[0] in {"drive", "functions"} and (
            after.times_as_angles or self._mends_itself(number, outcome, variant, freed, passes)
        )
        if of_formula or blame.path[0] == "unknowns":
            fault = source.fault(at, fault_of_either(blame, line, place, clash, outcome.solved))
        else:
            fault = Fault(fault_of_datum(blame, place, clash, after.solved), source.file, line)
        return fault, others, variant, now_freed

    def _mends_itself(self, number: int, outcome: _Outcome, variant: Variant, freed: frozenset[KeyPath], passes: int) -> bool:
        """Return whether the formula becomes right by dropping one name from a product or moving one term into a bracket."""
        place = outcome.clashes[number][1]
        for shorter in islice(chain(_shortened(place.formulas[0]), _bracketed(place.formulas[0])), passes):
            drive, functions = (
                tuple(replace(law, formula=shorter) if law.name == place.path[1] and law.formula else law for law in laws)
                for laws in (variant.drive, variant.functions)
            )
            after = self._pass(replace(variant, drive=drive, functions=functions), freed).clashes.keys()
            if number not in after and after < outcome.clashes.keys():
                return True
        return False


def _is_independent(outcome: _Outcome, number: int, other: int) -> bool:
    """Return whether two places are wrong in different parts, and share no name whose dimension the file leaves open."""
    (first, place), (second, another) = outcome.clashes[number], outcome.clashes[other]
    if (first.first.tree, first.second.tree) == (second.first.tree, second.second.tree):
        return False  # the same place, or the same slip again
    shared = {*_names(place)} & {*_names(another)}
    return all(is_known(outcome.measurer.names[name]) for name in shared)


def _names(place: Place) -> Iterator[str]:
    yield from (name for formula in place.formulas for name in formula.names())
    if place.path[0] in {"drive", "functions"}:
        yield str(place.path[1])  # the name that the formula defines


def _turned(variant: Variant, source: Source) -> Iterator[tuple[Variant, Fault]]:
    """Yield the variant with the coordinates of one group swapped, and the fault that this would mean."""
    for index, group in enumerate(variant.groups):
        if is_angle_first(group):
            turned = replace(group, coordinates=group.coordinates[::-1])
            groups = (*variant.groups[:index], turned, *variant.groups[index + 1 :])
            yield replace(variant, groups=groups), fault_of_order(index, group, source)


def _data(variant: Variant) -> Iterator[Blame]:
    """Yield everything in a file that has a unit."""
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


def _shortened(tree: Formula) -> Iterator[Formula]:
    """Yield the formula without one factor that is a name or depends on t alone, for each such factor."""
    for index, arg in enumerate(tree.args):
        if arg.op == "name" or {*arg.names()} == {"t"}:
            if tree.op == "*":
                yield tree.args[1 - index]
            if tree.op == "/" and index == 1:
                yield tree.args[0]
    yield from _inside(tree, _shortened)


def _bracketed(tree: Formula) -> Iterator[Formula]:
    """Yield the formula with a term moved into a neighbouring call: sin(p*t) + alpha becomes sin(p*t + alpha)."""
    if tree.op in {"+", "-"} and len(tree.args) == 2:
        for whole, term in (tree.args, tree.args[::-1]):
            yield from _with_term(whole, term)
    yield from _inside(tree, _bracketed)


def _with_term(tree: Formula, term: Formula) -> Iterator[Formula]:
    """Yield the formula with a term added to the argument of one of its calls."""
    if tree.op == "call" and len(tree.args) == 1:
        yield replace(tree, args=(Formula("+", (tree.args[0], term)),))
    yield from _inside(tree, lambda arg: _with_term(arg, term))


def _inside(tree: Formula, changed: Callable[[Formula], Iterable[Formula]]) -> Iterator[Formula]:
    """Yield the formula with every change of one of its arguments."""
    for index, arg in enumerate(tree.args):
        yield from (replaced(tree, (index,), other) for other in changed(arg))
