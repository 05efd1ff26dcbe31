"""Reads one value or formula of a variant file at a time; faults are collected, not raised.

Enters: text and its path.  Leaves: SI numbers and formulas whose names are all declared.
Used by `reader.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Sequence
from functools import partial
from typing import Literal

from coursework.variant.formula import reader, units
from coursework.variant.formula.alphabet import letter_hint
from coursework.variant.formula.arms import with_arms
from coursework.variant.formula.made import part_of_pi
from coursework.variant.formula.motion_units import UNITS, advised_unit
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, mapped, spelled
from coursework.variant.reading.names import Names
from coursework.variant.record.no_value import known_value
from coursework.variant.record.vocabulary import FORCE_SECTIONS
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say

ZERO = Formula("number", name="0")
_NOTHING = units.Quantity(1.0, "", "", "1")
# The kinds of names that each scope allows: the frame stands still; [drive] is a function of time; geometry knows no velocities.
_SCOPES = {
    "still": {"given"},
    "time": {"given", "drive"},
    "geometry": {"given", "drive", "coordinate", "function", "point"},
    "motion": {"given", "drive", "coordinate", "function"},
    "velocity": {"given", "drive", "coordinate", "function", "rate", "unknown"},
    "force": {"given", "drive", "coordinate", "function", "rate", "unknown", "point"},
}
_ADVISED = 100
_TYPED = 9  # characters of a number that a person types
_FORMULA_AND_UNIT = r"\s*(.*[*/+)(].*?)\s+((?:1/)?(?:[^\W\d_]|°)[^\s*()]*)\s*"
_ENDS_IN_NUMBER = re.compile(r"(?<![\w./])[\d.]+$")
Kind = Literal["scalar", "vector", "any"]


class Parts:
    """Reads the parts of one file and keeps every fault."""

    def __init__(self, source: Source, names: Names, hidden: Collection[str] = ()) -> None:
        self.source = source
        self.names = names
        self.hidden = frozenset(hidden)
        self._read, self.is_quantity = _readers(source)
        self.faults: list[Fault] = []
        self.values: dict[str, float] = {}
        self.times: dict[KeyPath, Formula] = {}
        self.grads: list[tuple[KeyPath, str]] = []
        self.broken: set[KeyPath] = set()  # paths with a fault
        self._unread: list[tuple[KeyPath, Callable[[str], Sentence | None]]] = []

    def say(self, path: KeyPath, message: Sentence, column: int = 0) -> None:
        """Keep a fault."""
        self.broken.add(path)
        self.faults.append(self.source.fault(path, message, column))

    def once(self, path: KeyPath, names: Sequence[str]) -> None:
        """Keep a fault for each name that is twice in a list of points."""
        for place, name in enumerate(names):
            if name in names[:place]:
                self.say((*path, place), say("fault.V157", name=name))

    def undeclared(self, path: KeyPath, kinds: Collection[str], message: Sentence, column: int = 0) -> None:
        """Keep a fault about an undeclared name of some `kinds`, unless another fault may have hidden its declaration."""
        self.broken.add(path)
        if self.hidden.isdisjoint(kinds):
            self.say(path, message, column)

    def quantity(self, path: KeyPath, value: str | int | float, wanted: str = "") -> units.Quantity:
        """Return "value unit" in SI.

        Advice about an unknown unit offers units of the kind `wanted` (an SI unit).  With "" the advice waits until the rest of
        the file shows which kind is needed (`tell_unread`).
        """
        try:
            read = self._read(value, wanted)
            if read.unit.startswith("grad"):
                self.grads.append((path, f"{read.text} {read.unit}"))
            return read
        except units.UnitFault as fault:
            written_out = _written_out(str(value), wanted)
            later = partial(_written_out, str(value)) if written_out else fault.advised
            if advice := None if written_out else self._as_function(path, str(value)) or _without_unit(str(value)):
                self.say(path, advice)
            elif later and not wanted:
                self._unread.append((path, later))
                self.broken.add(path)
            elif written_out:
                self.say(path, written_out)
            else:
                self.say(path, fault.message)
            return _NOTHING

    def _as_function(self, path: KeyPath, text: str) -> Sentence | None:
        """Return the message about a datum that is a formula of others, such as "2*h - b"; None for any other value."""
        tree, formula, _ = _split(text)
        if path[0] != "given" or tree is None or not {*tree.names()} <= self.names.kinds.keys() | {"pi"}:
            return None
        return say("fault.V164", found=text[:60], line=f'{path[1]} = "{formula.strip()[:60]}"')

    @property
    def sound(self) -> bool:
        """Return whether no fault has been found so far."""
        return not self.faults and not self._unread

    def tell_unread(self, wanted: Callable[[str], str]) -> None:
        """Keep a fault for each missing or unknown unit; `wanted` gives the SI unit that a name must have, "" for any."""
        for path, advised in self._unread:
            name = self.names.canonical(str(path[1])) if len(path) > 1 else ""
            if told := advised(wanted(name)):
                self.say(path, told)

    def unit(self, path: KeyPath, text: str) -> str:
        """Return the SI unit named by `text`, "" after a fault."""
        unit = units.plain_unit(text)
        if unit not in UNITS:
            self._unread.append((path, partial(units.unknown_unit, text)))
            self.broken.add(path)
            return ""
        return UNITS[unit][1]

    def number(self, path: KeyPath, value: str | int | float, si: str) -> float:
        """Return a quantity of unit `si`, or the value of a formula of given data such as "2*pi/p"; nan after a fault."""
        if isinstance(value, str) and not self.is_quantity(value):
            tree = self.times[path] = self.formula(path, value, "scalar", "still")
            try:
                return evaluate(tree, self.values) if self.sound else math.nan
            except FormulaFault as fault:
                self.say(path, say("fault.V060", message=fault.message), fault.column)
            except KeyError:  # a datum whose section is misspelt, which is told
                self.broken.add(path)
            return math.nan
        read = self.quantity(path, value, si)
        if read.si not in {"", si}:
            self.say(path, units.unlike(si, value))
            return math.nan
        return read.value if read is not _NOTHING else math.nan

    def scalar(self, path: KeyPath, value: str | int | float, scope: str = "geometry", wanted: str = "") -> Formula:
        """Return a formula, also for a bare number or a quantity such as "30 deg", which must be of the kind `wanted`."""
        if isinstance(value, str) and not self.is_quantity(value):
            return self.formula(path, value, "scalar", scope)
        read = self.quantity(path, value, wanted)
        if not units.measures(read, wanted):
            self.say(path, units.unlike(wanted, value))
        quarters = read.quarters
        written = repr(abs(read.value)).removesuffix(".0")  # as a formula writes it
        size = Formula("number", name=written, si=read.si) if quarters is None else part_of_pi(abs(quarters) / 2)
        return size if read.value >= 0 else Formula("neg", (size,))

    def equation(self, path: KeyPath, text: str, *, closure: bool) -> tuple[Formula, Formula]:
        """Return both sides of a velocity equation, or of a closure (two scalars or two vectors)."""
        try:
            left, right = reader.parse_equation(text, vectors=closure)
        except FormulaFault as fault:
            self.say(path, fault.message, fault.column)
            return ZERO, ZERO
        scope = "geometry" if closure else "velocity"
        left, right = self._resolve(path, left, scope), self._resolve(path, right, scope)
        kinds = {self._kind(path, side) for side in (left, right)} if closure else {"scalar"}
        if len(kinds - {"?"}) > 1:
            self.say(path, say("fault.V058"))
        return with_arms(left), with_arms(right)

    def formula(self, path: KeyPath, text: str, kind: Kind, scope: str = "geometry") -> Formula:
        """Return one formula with every name resolved; zero after a fault."""
        try:
            tree = reader.parse(text, vectors=scope in {"geometry", "force"})
        except FormulaFault as fault:
            advice = _without_unit(text, "s" if path[0] == "time" else "")
            self.say(path, advice or fault.message, 0 if advice else fault.column)
            return ZERO
        tree = self._resolve(path, tree, scope, kind)
        found = self._kind(path, tree)
        if kind != "any" and found not in {kind, "?"}:
            wants = "fault.V050" if kind == "vector" else "fault.V051"
            self.say(path, say(wants, text=text[:60]))
        return with_arms(tree) if scope == "geometry" else tree

    def known_point(self, path: KeyPath, name: str) -> str:
        """Return the declared point that `name` means; keep a fault if it means none."""
        points = [point for point, kind in self.names.kinds.items() if kind == "point"]
        if self.names.canonical(name) not in points:
            self.undeclared(path, {"point"}, say("fault.V059", name=name, hint=letter_hint(name) or closest(name, points)))
        return self.names.canonical(name)

    def _resolve(self, path: KeyPath, tree: Formula, scope: str, wanted: Kind = "any") -> Formula:
        if tree.op != "name":
            return mapped(tree, lambda arg: arg if self.names.below_rate(arg, tree) else self._resolve(path, arg, scope))
        name = self.names.canonical(tree.name)
        kind = self.names.kinds.get(name)
        if name not in ({"pi"} if scope == "still" else {"t", "pi"}) and kind not in _SCOPES[scope]:
            if kind or name == "t":
                listed, its = say(f"fault.listed.{scope}"), say(f"fault.kind.{kind or 'time'}")
                self.say(path, say("fault.V052", name=tree.name, kind=its, listed=listed), tree.column)
            else:
                # Finding the closest name takes time; after so many faults nobody reads the advice.
                few = len(self.faults) < _ADVISED
                kinds = {"point"} if wanted == "vector" else _SCOPES[scope]  # a name alone in the place of a point
                allowed = [known for known, its in self.names.kinds.items() if its in kinds] if few else []
                built_in = () if wanted == "vector" else ("pi",) if scope == "still" else ("t", "pi")
                allowed += [one for one in built_in if one == name.casefold()]  # an undeclared psi is not meant as pi
                advice = self.names.meant(tree.name) or closest(name, allowed)
                advice = advice or say(f"fault.part.declare.{'place' if wanted == 'vector' else scope}")
                self.undeclared(path, _SCOPES[scope], say("fault.V053", name=tree.name[:40], hint=advice), tree.column)
        return tree if name == tree.name else Formula("name", (), name, tree.column)

    def _kind(self, path: KeyPath, tree: Formula) -> str:
        """Return scalar or vector; "?" after a fault."""
        if tree.op == "name":
            known = tree.name in self.names.kinds or tree.name in {"t", "pi"}
            return "?" if not known else "vector" if self.names.kinds.get(tree.name) == "point" else "scalar"
        kinds = [self._kind(path, arg) for arg in tree.args]
        expected = {"part": ["vector"], "@": ["scalar", "scalar"], "pair": ["scalar", "scalar"], "^": ["scalar", "scalar"]}
        result = {"part": "scalar", "@": "vector", "pair": "vector", "^": "scalar", "number": "scalar", "call": "scalar"}
        wrong = False
        if tree.op in expected:
            wrong = kinds != expected[tree.op]
        elif tree.op == "call":
            wrong = "vector" in kinds
        elif tree.op in {"+", "-"}:
            wrong = len(set(kinds)) > 1
        elif tree.op == "*":
            wrong = kinds.count("vector") > 1
        elif tree.op == "/":
            wrong = kinds[1] == "vector"
        if "?" in kinds:
            return "?"
        if wrong:
            told = spelled(tree)[:40] if tree.op == "pair" else tree.name or tree.op
            self.say(path, say("fault.V054", name=told), tree.column)
            return "?"
        return result.get(tree.op, "vector" if "vector" in kinds else "scalar")


def _readers(source: Source) -> tuple[Callable[[str | int | float, str], units.Quantity], Callable[[str], bool]]:
    """Return a reader of values and a test whether a text is one; with units of mass only if the file has masses or forces."""
    if FORCE_SECTIONS.isdisjoint(source.data):
        return units.read, units.is_quantity
    return units.read_mass, units.is_mass_quantity


def _without_unit(text: str, wanted: str = "") -> Sentence | None:
    """Return the message about a formula followed by a unit, such as "1/90 s"; None for any other text.

    The advice is the value in this unit, or in `wanted` (an SI unit) if the unit is of another kind.  A value of many digits is
    advised as the formula itself in `wanted`: no digit of it is missing, so neither is the last row of a table.
    The unit of "phi1 + 90 deg" belongs to the number, which would mean something else without it.
    """
    tree, formula, unit = _split(text)
    if tree is None or not unit:
        return None
    value = known_value(tree, {})
    if value is None and _ENDS_IN_NUMBER.search(formula) and units.size_of(unit) != 1:
        return None
    unit = unit if wanted in {"", UNITS[unit][1]} else wanted
    advised = formula if value is None else f"{value:.15g} {unit}"
    if value is not None and wanted and len(f"{value:.15g}") > _TYPED:
        advised = formula if units.size_of(unit) == 1 else f"{units.size_of(unit):g}*({formula})"
    return say("fault.V160", found=text[:60], advised=advised)


def _written_out(text: str, wanted: str) -> Sentence | None:
    """Return the message about a formula of numbers in place of a number, such as "pi/6" or "3/2"; None for any other text."""
    tree, _, unit = _split(text)
    value = None if tree is None else known_value(tree, {})
    if tree is None or value is None or (tree.args[0] if tree.op == "neg" else tree).op == "number":
        return None
    meant = unit or advised_unit(wanted) or ("rad" if "pi" in tree.names() else "")
    degrees = f"{math.degrees(value):.12g}"
    advised = f"{degrees} deg" if meant == "rad" and len(degrees) <= _TYPED else f"{value:.15g} {meant}".strip()
    return say("fault.V162", found=text[:60], advised=advised)


def _split(text: str) -> tuple[Formula | None, str, str]:
    """Return a formula, its text, and the unit after it ("" if none); None in place of a formula that cannot be read."""
    found = re.fullmatch(_FORMULA_AND_UNIT, text)
    formula, unit = (found[1], found[2]) if found and units.plain_unit(found[2]) in UNITS else (text, "")
    try:
        return reader.parse(formula, vectors=False), formula, unit
    except FormulaFault:
        return None, formula, unit
