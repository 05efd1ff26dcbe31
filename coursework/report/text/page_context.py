"""The context of every section: the run, the words of the language, the symbols of the names.

Enters: a `SceneRun` and a language.  Leaves: text, runs and numbers, ready for a part of the page.
Used by `report/`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from coursework.mechanism.derivation.constants import NamedAngles, named_angles
from coursework.motion.integration.motion import Motion
from coursework.report.text.numbers import Numbers, said_step
from coursework.report.text.parts import Runs
from coursework.report.text.symbols import LINEAR, Rates, Symbol, symbol
from coursework.report.text.text_runs import ITALIC, LONGEST_NAME, Names, derivative, printed, runs, with_names
from coursework.report.text.words import Words
from coursework.results.checks.result import beside
from coursework.scene.quantities import ACCURACY, CHECKS, PLOTS, TABLE
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import caching
from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import ENGLISH
from coursework.words.templates import LONGEST, clean

STOP_DIGITS = 6  # significant digits of the time of a stop, in every sentence
LONGEST_EQUATION = 40  # characters of the name of an equation
DATUM_DIGITS = 6  # significant digits of a converted datum or of a time: more than a task sheet ever gives

_OF_GROUP = re.compile(r"(?<![\w.])G\d+[xy](?!\w)")  # an equation of a group, as the tool names it


@caching
class PageContext:
    """One run and one language; `later`: sections of which only the heading is written."""

    run: SceneRun
    words: Words
    later: tuple[str, ...] = ()

    @cached_property
    def variant(self) -> Variant:
        """Return the variant with its texts in the language of the page, if its file has them."""
        return self.run.variant.in_language(self.words.phrases.language)

    @cached_property
    def stepped(self) -> dict[str, str]:
        """Return the names that a scheme steps from row to row, each with its derivative: the coordinates and their rates.

        If forces move the mechanism, these are only the free coordinates, and their rates with accelerations.
        """
        variant, shown = self.run.variant, self.run.motion.coordinate_names
        pairs = {one.name: one.rate for one in variant.coordinates if one.name in shown}
        if variant.motor is None:
            return pairs
        free = {name: rate for name, rate in pairs.items() if rate in variant.motor.rates}
        return free | {rate: f"d{rate}" for rate in free.values()}

    @property
    def numbers(self) -> Numbers:
        """Return the writer of numbers."""
        return self.words.numbers

    @property
    def exact(self) -> Motion | None:
        """Return the exact motion if plots are asked for, else None; reading it computes it."""
        return self.run.exact if self.run.asks(PLOTS) else None

    @property
    def is_about_accuracy(self) -> bool:
        """Return whether the page shows the accuracy study, and neither table nor checks."""
        return self.run.asks(ACCURACY) and not (self.run.asks(TABLE) or self.run.asks(CHECKS))

    @cached_property
    def rates(self) -> Rates:
        """Return the velocities and how their derivatives are written: with the language's letter if it is free, else a dot."""
        variant, letters = self.run.variant, {}
        taken = {symbol(name).letter for name in variant.names}
        names = self.run.motion.velocity_names
        for kind in ("angular", "linear"):
            if (letter := self.words(f"worked.{kind}")) not in taken:
                letters[kind] = letter
        if any(symbol(name).letter in LINEAR and "rad" in variant.unit_of(name) for name in names):
            letters.pop("linear", None)  # u is also the angular velocity of a link here
        return Rates(frozenset(names), **letters)

    @cached_property
    def angles(self) -> NamedAngles:
        """Return the constant angles of the equations with the names that the page gives them."""
        run, variant = self.run, self.run.variant
        shown = [side for one in run.equations for side in (one.left, one.right)]
        shown += [formula for solution in run.solutions for _, formula in solution]
        shown += [formula for _, formula in run.scene.mechanism.points]
        moving = {*variant.columns, *(law.name for law in variant.laws), "t"}
        return named_angles(shown, moving, variant.names, variant.values)

    @property
    def contours(self) -> dict[str, str]:
        """Return the numbers of the contours, by the tool's name ("G2") of the group that closes each."""
        of_groups = {f"G{number}" for number, _ in enumerate(self.run.variant.groups, start=1)}
        closing = [one.name for one in self.run.scene.mechanism.constraints if one.is_closure and one.name in of_groups]
        return {name: str(number) for number, name in enumerate(closing, start=1)}

    @property
    def equation_numbers(self) -> dict[str, str]:
        """Return numbers for the equations that follow from groups, by name; they continue the numbers given in the file."""
        shown = [one.name for one in self.run.equations]
        unnamed = [name for name in shown if name[:-1] in self.contours]
        first = 1 + max((int(name) for name in shown if name.isdecimal()), default=0)
        return {name: str(number) for number, name in enumerate(unnamed, start=first)}

    def equation(self, name: str) -> str:
        """Return the number or name at the margin of an equation, without parentheses."""
        return self.equation_numbers.get(name, clean(name, LONGEST_EQUATION))

    def symbol(self, name: str) -> Symbol:
        """Return the symbol of a name."""
        return symbol(name, self.rates)

    def label(self, name: str) -> str:
        """Return the symbol of a name as text."""
        return self.symbol(name).text

    def symbol_runs(self, names: Iterable[str], after: str = "") -> Runs:
        """Return "ω₁, ω₂" as runs, followed by `after`."""
        found: Runs = []
        for name in names:
            found += [{"t": self.words("join.comma")}] if found else []
            if "/" in name:
                found += derivative(name)
                continue
            found.append(self.symbol(name).run)
        return [*found, *runs(after)]

    def symbol_list(self, names: Iterable[str]) -> str:
        """Return "ω₁, ω₂ and ω₃" as text."""
        return self.words.listing([self.lettering(name) for name in names])

    def lettering(self, name: str) -> str:
        """Return the symbol of a name as text of a sentence that is split into runs later; a single letter is marked for that."""
        text = self.label(name)
        return f"{ITALIC[0]}{text}{ITALIC[1]}" if len(text) == 1 and text.isascii() else text

    def rich(self, text: str) -> Runs:
        """Return a sentence of the tool as runs: in the language of the page, cleaned, with numbers and symbols set."""
        return self.lettered(printed(self.told(text)))

    def told(self, text: str, longest: int = LONGEST) -> str:
        """Return a sentence of the tool in the language of the page, cleaned."""
        said = clean(self.words.written(text), longest)
        numbers = self.equation_numbers if isinstance(text, Sentence) and _OF_GROUP.search(said) else {}
        return _OF_GROUP.sub(lambda match: f"({numbers[match[0]]})" if match[0] in numbers else match[0], said)

    def event(self, kind: str) -> str:
        """Return the words for a kind of stop."""
        key = f"event.kind.{kind}"
        return self.words(key) if self.words.has(key) else clean(kind)

    def quoted(self, text: str) -> Runs:
        """Return a sentence of the file as runs, cleaned, with symbols set and nothing else changed."""
        return self.in_its_language(text, self.lettered(clean(text, LONGEST_NAME)))

    def in_its_language(self, text: str, found: Runs) -> Runs:
        """Return the runs `found` of a `text` of the file, marked if the text is in another language than the page."""
        return [{**run, "lang": ""} for run in found] if self.is_foreign(text) else found

    def is_foreign(self, text: str) -> bool:
        """Return whether a text of the file is not in the language of the page: a file without [text.…] is read as English."""
        language, texts = self.words.phrases.language, self.run.variant.texts
        return language != ENGLISH and (language not in texts or text not in texts[language].all)

    def lettered(self, text: str, *, data: bool = True) -> Runs:
        """Return a cleaned sentence as runs, with this variant's names as symbols; single letters only if `data`."""
        return [dict(run) for run in with_names(text, self.names, data)]

    @cached_property
    def names(self) -> Names:
        """Return the names that may stand in a sentence about this variant."""
        variant = self.run.variant
        others = (*variant.values, *(law.name for law in variant.laws))
        columns = (*variant.columns, *(law.name for law in variant.drive))
        return Names(tuple(name for name, _ in self.run.scene.mechanism.points), columns, others)

    def say(self, key: str, **values: object) -> Runs:
        """Return one of our own sentences as runs."""
        return runs(self.words(key, **values))

    def quantity(self, value: float, unit: str, digits: int = DATUM_DIGITS) -> str:
        """Return a datum with its unit."""
        return self.with_unit(self.numbers.plain(value, digits), unit)

    @property
    def step(self) -> str:
        """Return the step of the run with its unit."""
        return self.quantity(said_step(self.run.step), "s")

    def unit(self, unit: str) -> str:
        """Return a unit as the language of the page writes it."""
        return self.words.unit(unit)

    def unit_beside(self, value: float, unit: str) -> str:
        """Return a unit in the form that fits the number: "1 equation", "2 equations"."""
        return self.told(beside(unit, value))

    def with_unit(self, number: str, unit: str) -> str:
        """Return a number followed by its unit, as the language of the page writes it."""
        return self.words.amount(number, unit)
