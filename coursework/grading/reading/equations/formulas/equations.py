"""Lines of text -> a student's equations, each as a checked tree or with the reason why it has none.

Enters: text with the names of the variant.  Leaves: `EquationLine`s.  The text is data: nothing in it is executed.
Used by `read_submission.py`, `lines.py` and the readers of the parts of a text.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import field, replace
from functools import lru_cache, partial
from itertools import combinations, pairwise

from coursework.grading.reading.equations.formulas.edges import unwrapped, without_edges
from coursework.grading.reading.equations.formulas.labels import bare_equations, without_labels
from coursework.grading.reading.equations.formulas.meanings import Meanings, in_smaller_units, meaning_of, put_in
from coursework.grading.reading.equations.formulas.names_in_text import BUILT_IN, Spellings, place_of_name, spellings_of
from coursework.grading.reading.equations.formulas.plain_text import of_one_component, of_products, of_units, plain
from coursework.grading.reading.equations.formulas.repair import Sides, is_name, is_value, sides_of
from coursework.grading.reading.equations.formulas.unnamed import called_otherwise, without_a_name
from coursework.grading.reading.equations.notation.degrees import with_angles_in_degrees
from coursework.grading.reading.equations.notation.signs import depths, plain_signs, relates_two_sides
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.grading.reading.student_work import EquationLine, EquationReading
from coursework.system.frozen import frozen
from coursework.variant.formula import reader
from coursework.variant.formula.tree import Formula, FormulaFault, spelled, with_names
from coursework.words.errors import Fault
from coursework.words.sentences import closest, say

MORE_LINES = 20  # so many lines are read in addition to twice the equations needed
WORD = re.compile(r"[^\W\d]\w*")
LETTER = re.compile(r"(?<![A-Za-z])\\?([^\W\d_]|[a-z]{3,5})(?![A-Za-z0-9_])(\u0307)?")
_PIECE = re.compile(r"[^\W\d]++\d+|[^\W\d_]+")  # the parts of names written without a sign between them
OWN_NAME = re.compile(r"[^\W\d][\w']{0,40}")
_SUM = re.compile(r"\b(?:sin|cos)\s+([\w\s*]{1,20}[-+]\s*)$", re.IGNORECASE)  # the argument of a function without brackets
_NUMBER = re.compile(r"[-+]?\s*(?:\d++\.?\d*+|\.\d++)(?:[eE][-+]?\d+)?")
DASH = re.compile(r"^\s*[-–—]\s*")  # the mark of an item, as a hyphen is; − is a minus
# A name and the formula of a residual, as in F(2) = r1*w1…, which is handed to a root finder.
_FUNCTION_OF_ROOTS = re.compile(r"\s*[^\W\d]\w{0,20}\s*(?:[(\[][\w\s,]{1,40}[)\]])?\s*=([^=]+)")
_NATURAL = re.compile(r"[一-鿿]{2}|[^\W\d_]{3,}")  # words of a sentence, two signs each in Chinese
_SEVERAL = 3  # so many of them make one
_SINES = re.compile(r"sin|cos|sen", re.IGNORECASE)
DRAWN = re.compile(r"=[^=]{0,80}(?:-{3}|[─―]{2})")  # a quotient drawn over several lines
TURNED = re.compile(r"(?:sin|cos)\s*[\[({]?\s*\\?[^\W\d]", re.IGNORECASE)  # a mark of an equation even if its names are unknown


def most_lines(expected: Expected) -> int:
    """Return the largest number of equations read from a submission."""
    return 2 * len(expected.variant.sought) + MORE_LINES


def names_for(expected: Expected) -> Names:
    """Return the names that equations may use."""
    return Names(spellings_of(expected.variant, expected.grid.units), expected)


def read_line(text: str, file: str, line: int, names: Names) -> EquationLine:
    """Return one line as an equation: as it stands if the strict reader accepts it, else repaired, else with its fault.

    A line that may be meant in several ways has the other readings in `others`: a label may be a number, and a formula without a
    name may be the value of any velocity.
    """
    bare = unwrapped(text)
    found, fault = _readings(bare, names)
    found = found if bare == text else [replace(one, text=one.text or bare) for one in found]
    variant = names.expected.variant
    if before := names.before:
        for meant in (text, _apart(text, names, before)):
            found += [replace(one, is_loose=True) for one in _readings(meant, before)[0]]
    in_si = of_units(text)
    for meant in (of_one_component(text, variant), of_products(text, names.spellings), in_si):
        is_loose = meant is not in_si or any(not one.is_loose for one in found)  # 0.4 m may also be a product with a datum m
        read = _readings(meant, names)[0] if meant != text else []
        found += [replace(one, text=one.text or meant, is_loose=is_loose) for one in read]
    called = called_otherwise(bare, fault) if fault and all(one.is_loose for one in found) else ""
    formula = called or without_labels(text)
    unnamed = without_a_name(formula, variant, partial(read_as_one, names=names)) if called or not found else ()
    found += [one for one in unnamed if one.is_loose or not called]
    found += [_loosely(tree) for one in found if (tree := with_angles_in_degrees(one.tree, variant)) is not None]
    shorter = [
        replace(one, text=one.text or meant, is_loose=True, asks=asks)
        for meant, asks in without_edges(bare, names.is_single)
        for one in _readings(meant, names)[0]
    ]
    found += shorter
    if text.count("=") > 1 and _is_cut(text, found):
        found = [replace(one, is_partial=True) for one in found]
    found.sort(key=lambda one: one.is_partial)  # a word before a chain is cut rather than its first side
    first = next((one for one in found if not one.is_loose), None)
    if first is not None:
        found += map(_loosely, in_smaller_units(first.tree, variant))
        others = tuple(one for one in found if one is not first)
        return EquationLine(file, line, text, others=others).read_as(first)
    assert fault is not None  # without a firm reading, the strict reader refused the line
    if unnamed and not called:
        fault = Fault(say("fault.G063", names=variant.sought, formula=without_labels(text).strip(" =")[:80]), column=1)
    short = text[: reader.MAX_CHARACTERS]
    told = Fault(fault.message, file, line, fault.column)
    relates = len(names_in(short, names.spellings)) > 1 or (
        relates_two_sides(short) and (TURNED.search(short) or DRAWN.search(short)) is not None
    )
    is_prose = not relates and _is_prose(short, names)
    return EquationLine(file, line, short, fault=told, others=tuple(found), relates=relates, is_prose=is_prose)


def _is_cut(text: str, found: Sequence[EquationReading]) -> bool:
    """Return whether a text has more sines and cosines than all sides that were read of it; those of numbers do not count."""
    sides = {side.strip() for one in found for side in (one.text or text).split("=")}
    typed = (side for side in text.split("=") if not is_value(side.strip()))
    return sum(len(_SINES.findall(side)) for side in sides) < sum(len(_SINES.findall(side)) for side in typed)


def _loosely(tree: Formula) -> EquationReading:
    """Return the reading of a line that may mean this tree instead, if it is right."""
    return EquationReading(tree, " = ".join(map(spelled, tree.args)), is_loose=True)


def _apart(text: str, names: Names, before: Names) -> str:
    """Return a line with the names of the angles for the student's letters, except in brackets with the time: sin(pt + α)."""
    plainly = plain_signs(text)
    for found in reversed([*LETTER.finditer(plainly)]):
        meant = names.spellings.canonical(found[1])
        if meant not in names.spellings.rates or meant == before.spellings.canonical(found[1]):
            continue
        inside = _around(plainly, found.start())
        read = read_as_one(inside, before) if inside else None
        if read is None or isinstance(read, Fault) or "t" not in read.tree.names():
            called = before.spellings.rates[meant] if found[2] else meant
            plainly = f"{plainly[: found.start()]} {called} {plainly[found.end() :]}"
    return plainly


def _around(text: str, place: int) -> str:
    """Return what stands in the innermost brackets around a place; outside of all the sum that it ends, sin pt + α, or ""."""
    if (sum_ := _SUM.search(text[:place])) is not None:
        return sum_[1] + text[place]
    inside = depths(text)
    begin = next((at for at in range(place, -1, -1) if inside[at] < inside[place]), -1) + 1
    end = next((at for at in range(place, len(text)) if inside[at] < inside[place]), 0)
    return text[begin + 1 : end] if begin and end else ""


def _is_prose(text: str, names: Names) -> bool:
    """Return whether a text has several words that mean nothing in a formula, at least two of them without a sign between."""
    strange = [found.span() for found in _NATURAL.finditer(text) if not names.is_name(found[0])]
    joined = any(not text[end:start].strip() for (_, end), (start, _) in pairwise(strange))
    return joined and len(strange) >= _SEVERAL


def _readings(text: str, names: Names) -> tuple[list[EquationReading], Fault | None]:
    """Return the readings of a line, the most likely first, and the fault of the line as it stands, None if it has none."""
    found: list[EquationReading] = []
    fault: Fault | None = None
    bare = without_labels(text)
    candidates = dict.fromkeys((names.listed.sub("", bare) if names.listed else text, bare, text))
    for candidate in candidates:
        strict = strictly(candidate, names)
        if isinstance(strict, Fault):
            fault = replace(strict, column=strict.column + max(text.find(candidate), 0))
        else:
            found.append(EquationReading(strict, "" if candidate == text else candidate))
    if len(text) > EQUATION_CHARACTERS:
        return found, fault
    named: Fault | None = None
    written = [plain(one, names.spellings) for one in candidates]
    for candidate in dict.fromkeys(one for whole in written for one in bare_equations(whole, names.is_name)):
        for closely in (False,) if found else (False, True):
            sides = sides_of(candidate, names.spellings, closely=closely)
            read = _of_sides(sides, names)
            if isinstance(read, Fault):
                # Only a name was not understood: report this fault, at the place of the name in the line as handed in.
                if read.place and not named:
                    fault = named = replace(read, column=place_of_name(read.place, text) + 1)
            else:
                found += [
                    replace(one, guessed=one.guessed or closely)
                    for one in read
                    if all(one.text != o.text and one.tree != o.tree for o in found if not o.is_loose)
                ]
    for candidate in written:
        if zero := _FUNCTION_OF_ROOTS.fullmatch(without_labels(candidate)):
            read = _of_sides(sides_of(zero[1], names.spellings), names)
            found += [] if isinstance(read, Fault) else [replace(one, is_loose=True) for one in read]
    return found, fault


def _of_sides(sides: Sides, names: Names) -> list[EquationReading] | Fault:
    """Return the equations that a chain of sides a = b = c means: each side equals the last readable one.  A fault if none.

    Non-zero numbers at the end of a longer chain are the value in some row and are dropped.  If a side cannot be read, the
    readings are loose, unless that side is one name, which labels the sum: V_Cy = … = 0; if it has a sine, there are none.
    """
    texts = sides.texts
    if len(texts) == 2:
        read = strictly(" = ".join(texts), names)
        if isinstance(read, Fault):
            return read
        return [EquationReading(read, " = ".join(texts), guessed=not sides.is_whole)]
    kept = [text for text in texts if not isinstance(strictly(f"{text} = 0", names), Fault)]
    is_loose = any(text not in kept for text in texts if not OWN_NAME.fullmatch(text.strip()))
    while len(kept) > 2 and is_value(kept[-1]):
        kept.pop()
    is_lost = any(TURNED.search(text) for text in texts if text not in kept)  # a formula of the line would be passed over
    if is_lost or len(kept) < 2 or all(OWN_NAME.fullmatch(text) or _NUMBER.fullmatch(text) for text in kept):
        if (unread := next((text.strip() for text in texts if text not in kept), None)) is not None:
            return Fault(say("fault.G074", text=unread), place=unread)
        read = strictly(" = ".join(texts), names)
        assert isinstance(read, Fault)  # no equation has three sides
        return read
    found = []
    given = [one for text in kept if (one := names_in(text, names.spellings) & {*names.expected.variant.sought})]
    is_sum = not OWN_NAME.fullmatch(kept[0].strip(" ()"))  # the law of sines, where v = b*w3 = … gives v alone
    is_partial = is_loose or (is_sum and any(not one <= other and not other <= one for one, other in combinations(given, 2)))
    said = [text for text in kept[:-1] if not OWN_NAME.fullmatch(text.strip()) or names.spellings.canonical(text.strip())]
    for text in dict.fromkeys(said or kept[:-1]):
        read = strictly(f"{text} = {kept[-1]}", names)
        if not isinstance(read, Fault):
            found.append(EquationReading(read, f"{text} = {kept[-1]}", is_loose=is_loose, is_partial=is_partial))
    # f1 = … = 0 and V_C = 0 are labels; in w2 = w3 = … both are sought
    sought = {*names.expected.variant.sought} if kept[-1] != "0" else set[str]()
    formulas = tuple(one for one in found if one.tree.args[0].op != "name" or one.tree.args[0].name in sought)
    return [replace(one, sides=tuple(other for other in formulas if other is not one)) for one in found]


@lru_cache(1024)  # several readers look at the same line in turn
def names_in(text: str, spellings: Spellings) -> frozenset[str]:
    """Return the declared names in a text, in any spelling, except t and pi."""
    found = {word: spellings.canonical(word) for word in {*WORD.findall(plain(text, spellings))}}
    pieces = {piece for word, meant in found.items() if meant is None for piece in _PIECE.findall(word)}
    return frozenset(known for known in (*found.values(), *map(spellings.canonical, pieces)) if known is not None) - {*BUILT_IN}


def names_of(line: EquationLine, names: Names) -> frozenset[str]:
    """Return the declared names in a line; if the line could not be read, those found in its text."""
    return names_in(line.text, names.spellings) if line.tree is None else frozenset(line.tree.names())


def read_as_one(text: str, names: Names) -> EquationReading | Fault:
    """Return the most likely reading of a text as one equation, or its fault."""
    found, fault = _readings(text, names)
    if found:
        return found[0]
    assert fault is not None
    return fault


@frozen
class Names:
    """What a name in a line may mean: a name of the variant in any spelling, or another known name.

    `own` are the definitions in the same text; `listed` matches the list mark that its lines begin with, no minus or factor.
    `before` are the names as they are without the student's letters for angles, if such a letter is a datum of the task.
    """

    spellings: Spellings
    expected: Expected
    own: Meanings = field(default_factory=dict)
    listed: re.Pattern[str] | None = None
    before: Names | None = None

    def declared(self, name: Formula) -> Formula:
        """Return a name as declared in the variant."""
        meant = self.spellings.canonical(name.name)
        return name if meant in {None, name.name} else replace(name, name=meant)

    def is_single(self, word: str) -> bool:
        """Return whether a word is one name of the task or of the text."""
        return self.spellings.canonical(word) is not None or word in self.own

    def is_name(self, word: str) -> bool:
        """Return whether a word has a meaning: a name, a function, a chain of these, or a name that `meaning_of` knows."""
        return is_name(word, self.spellings) or meaning_of(word, self.expected, self.own) is not None


def strictly(text: str, names: Names) -> Formula | Fault:
    """Return left - right with declared names, or the fault; the `place` of a fault is the undeclared name."""
    try:
        tree = Formula("-", reader.parse_equation(text))
    except FormulaFault as fault:
        return Fault(fault.message, column=fault.column)
    meant: dict[str, Formula] = {}
    for node in tree.walk():
        if node.op != "name" or names.spellings.canonical(node.name) is not None:
            continue
        meaning = meaning_of(node.name, names.expected, names.own)
        if meaning is None:
            built_in = {"t", "pi"} - {node.name.casefold()}  # an undeclared phi or psi is not meant as pi
            variant = names.expected.variant
            task = ", ".join((*(one.name for one in variant.coordinates), *variant.velocities, *variant.values))
            advice = closest(node.name, sorted(names.spellings.known - built_in)) or say("hint.known", known=task)
            return Fault(say("fault.G061", name=node.name[:40], hint=advice), column=node.column, place=node.name)
        meant[node.name] = meaning
    whole = put_in(tree, meant) if meant else tree
    return Fault(say("fault.G064"), column=1) if whole is None else with_names(whole, names.declared)
