"""The columns of Euler's table as formulas: which column holds what, and the formula of each cell.

Enters: a run.  Leaves: `StepTable`, columns with their formulas and the numbers that these give.  Used inside `workbook/`.
A velocity has the formula of the page: a law that is used only once is written out in it, any other has a column.  A block
without a formula is solved by MMULT and MINVERSE over its coefficients, which are in hidden columns.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.codegen.names import derivative, private
from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.symbolic import local, symbol
from coursework.equations.reduction.textbook.cramer import Cramer, cramer
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import AT_EVENT
from coursework.motion.schemes import Sum, scheme_of, share
from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array
from coursework.takeaway.workbook.cells import BEFORE, NEXT, ROW, SHEET, TIME, Column, Matrix, StepTable
from coursework.takeaway.workbook.formulas import spreadsheet
from coursework.takeaway.workbook.names import STEP, defined_names, letters, start_of
from coursework.takeaway.workbook.tables import Tables
from coursework.variant.formula.tree import Formula, mapped

TIMES = letters(0)  # the column with the times of the rows


class Maker:
    """What all slopes have in common: the table, its reduction, the laws, and how often formulas use each name."""

    def __init__(self, table: StepTable) -> None:
        scene = table.run.scene
        self.table, self.scene, self.rates = table, scene, scene.rates
        self.equations, self.reduction = scene.equations, scene.reduction
        self.scheme = scheme_of(table.motion.scheme)
        self.laws = {law.name: law for law in scene.variant.laws}
        self.solutions = dict(formula for index in self.rates.blocks for formula in scene.solutions[index])
        named_in = [name for tree in self.solutions.values() for name in tree.names()]
        self.uses = Counter([*named_in, *named_in] if self.scheme.slopes > 1 else named_in)


class Stage:
    """One slope of a step: the places of time, coordinates and velocities, and the formulas that follow from them."""

    def __init__(self, writer: Maker, number: int, places: dict[str, str], t: Array, q: Array) -> None:
        self.writer, self.number, self.places, self.t, self.q = writer, number, {TIME: TIMES, **places}, t, q
        self.until = int(number > 0)  # the last row has no further slopes
        self.matrices: dict[int, Matrix] = {}
        self.velocities = writer.table.motion.velocities if number == 0 else writer.rates.table(t, q)[0]

    def write(self, blocks: Iterable[int]) -> None:
        """Write the velocities of some blocks, and laws that are velocities."""
        writer, motion = self.writer, self.writer.table.motion
        for name in motion.velocity_names:
            if name in writer.laws:
                self._set(name, self.law_text(name))
        for index in blocks:
            self._block(writer.rates.blocks[index])

    def _block(self, index: int) -> None:
        block = self.writer.reduction.blocks[index]
        if not self.writer.scene.solutions[index]:
            self._solved(index, block)
            return
        for name, tree in self.writer.scene.solutions[index]:
            self._set(name, self._limit(index, name, self.text(tree)))

    def _limit(self, index: int, name: str, text: str) -> str:
        """Return the formula of a velocity, with its limit at times when a determinant vanishes but the motion goes on."""
        for passage in self.writer.scene.search.passages:
            if passage.block == index:
                at, value = passage.middle.time, passage.middle.velocities[name]
                text = f"IF(ABS({self.places[TIME]}{ROW}-{at!r})<={AT_EVENT * at!r},{value!r},{text})"
        return text

    def _set(self, name: str, formula: str) -> None:
        """Write a velocity into its column of the table, or into a new one."""
        table, names = self.writer.table, self.writer.table.motion.velocity_names
        if name in self.places:
            table.columns[table.number(self._head(name))].formula = formula
            return
        values = self.velocities[:, names.index(name)] if name in names else self.values([symbol(name)])[:, 0]
        self.places[name] = table.add(Column(self._head(name), formula, values, until=self.until))

    def _head(self, name: str) -> str:
        return name + "′" * self.number

    def _solved(self, index: int, block: Block) -> None:
        """Put the coefficients of a block without a formula beside the table, where it is solved."""
        writer, table, size = self.writer, self.writer.table, block.size
        order = writer.equations.order
        rows = [[*row, side] for row, side in zip(block.coefficients, block.sides, strict=True)]
        entries = [entry for row in rows for entry in row]
        texts = tuple(self.text(as_formula(entry, order)) for entry in entries)
        made = Matrix(0, size, texts, self.values(entries), self.until)
        self.matrices[index] = made
        table.matrices.append(made)
        for place, name in enumerate(block.unknowns):
            self._set(name, "")
            table.solved[table.number(self._head(name))] = (made, place)

    def values(self, wanted: Sequence[Expression]) -> Array:
        """Return the numbers (n, k) of k expressions in the n rows."""
        writer, variant = self.writer, self.writer.scene.variant
        q = np.zeros((len(self.t), len(variant.coordinates)))
        for index, coordinate in enumerate(variant.coordinates):
            if coordinate.name in writer.rates.coordinates:
                q[:, index] = self.q[:, writer.rates.coordinates.index(coordinate.name)]
        u = np.zeros((len(self.t), len(variant.velocities)))
        for index, name in enumerate(variant.velocities):
            if name in writer.table.motion.velocity_names:
                u[:, index] = self.velocities[:, writer.table.motion.velocity_names.index(name)]
        return compile_rows(writer.equations, wanted, 1)(self.t, q, u)

    def text(self, tree: Formula) -> str:
        """Return a formula over the cells of its own row."""
        opened = self._opened(tree)
        for name in opened.names():
            if name not in self.places and name not in self.writer.table.names and name != "pi":
                expression = self._expression(name)
                values = self.values([expression])[:, 0]
                column = Column(self._head(name), self.law_text(name), values, until=self.until)
                self.places[name] = self.writer.table.add(column)
        return spreadsheet(opened, self._cells(opened), self._table)

    def elsewhere(self, tree: Formula) -> str:
        """Return a formula over the cells of a row, for use on another sheet."""
        self.text(tree)  # first, so that all names in it have columns
        own = self.places
        self.places = {name: f"{SHEET}!{place}" for name, place in own.items()}
        try:
            return self.text(tree)
        finally:
            self.places = own

    def _table(self, called: str, argument: Formula) -> str:
        return self.writer.table.tables.value(called, self.text(argument))

    def law_text(self, name: str) -> str:
        """Return the formula of a law, or of its derivative."""
        law = self.writer.laws.get(name)
        if law is not None and law.formula is not None:
            return self.text(law.formula)
        symbols = self.writer.equations.symbols
        return self.text(as_formula(symbols.definitions[self._expression(name)], self.writer.equations.order))

    def _expression(self, name: str) -> Expression:
        """Return the symbol of a name in a formula of the page: of a law, or ∂r/∂φ."""
        if name in self.writer.laws:
            return symbol(name)
        law, by = self.writer.equations.symbols.derivatives_among([name])[name]
        return local(derivative(private(law), private(by), self.writer.scene.variant.names))

    def _opened(self, tree: Formula) -> Formula:
        """Return a formula in which laws that are used only once are written out."""
        if tree.op == "name" and tree.name in self.writer.laws and tree.name not in self.places:
            law = self.writer.laws[tree.name]
            if law.formula is not None and self.writer.uses[tree.name] == 1:
                return mapped(law.formula, self._opened) if law.formula.op != "name" else self._opened(law.formula)
        return mapped(tree, self._opened)

    def _cells(self, tree: Formula) -> dict[str, str]:
        names = self.writer.table.names
        return {name: names[name] if name in names else f"{self.places[name]}{ROW}" for name in tree.names() if name != "pi"}


def step_columns(run: SceneRun, tables: Tables) -> StepTable:
    """Return the table of the run's scheme as formulas; it is Euler's if the run's own table is the exact motion."""
    beside = run.scene.scheme_rows
    motion = run.motion if beside is None else beside
    shown = run.columns() if beside is None else (motion.names, motion.rows)
    table = StepTable.of(run, motion, defined_names(run.variant), tables, shown)
    _Writer(table).write()
    return table


class _Writer(Maker):
    """Puts the formulas into the columns."""

    def write(self) -> None:
        """Write time, coordinates, velocities, determinants and the further slopes."""
        table, motion, count = self.table, self.table.motion, len(self.rates.coordinates)
        steps = len(motion.t)
        slopes = motion.velocities[:, :count]
        places = {name: letters(1 + index) for index, name in enumerate(motion.names)}
        stages = [Stage(self, 0, places, motion.t, motion.coordinates)]
        stages[0].write(range(len(self.rates.blocks)))
        table.text = stages[0].elsewhere
        pairs = cramer(self.equations, self.reduction, [bool(solution) for solution in self.scene.solutions])
        for index, block in enumerate(self.rates.blocks):
            self._determinant(stages[0], block, motion.determinants[:, index], pairs[block])
        found = [slopes[:-1]]
        for stage in range(1, self.scheme.slopes if steps > 1 else 1):
            stages.append(self._later(stage, places, stages, found))
        for index, (name, rate) in enumerate(zip(self.rates.coordinates, motion.velocity_names, strict=False)):
            column = table.columns[1 + index]
            column.first = table.names[start_of(name)]
            if steps > 1:
                rates = [stage.places[rate] for stage in stages]
                column.formula = self._moved(places[name], self.scheme.outer, rates, BEFORE)

    def _moved(self, own: str, row: Sum, rates: Sequence[str], at: str) -> str:
        return f"{own}{at}+{row.text([f'{rate}{at}' for rate in rates], share(row.factor, STEP), '+')}"

    def _later(self, stage: int, places: dict[str, str], before: list[Stage], found: list[Array]) -> Stage:
        """Return a further slope, with its time and position in columns of their own."""
        table, motion, step = self.table, self.table.motion, self.table.motion.step
        node, inner, mark = self.scheme.nodes[stage], self.scheme.inner[stage], "′" * stage
        times, q = motion.t[:-1], motion.coordinates[:-1]
        own: dict[str, str] = {}
        text = f"{TIMES}{ROW}" + (f"+{node.numerator}*{STEP}/{node.denominator}" if node else "")
        ends = [table.names[name] for name in table.names if name.startswith("_end")]
        latest = np.array([self.rates.may_look_until(end) for end in motion.t[1:].tolist()])
        if ends:  # the last slope before a break of the drive still sees the old formula
            after = f"A{NEXT}"
            looks = [f"IF(ABS({after}-{end})<=1.2E-13*{end},{after}*(1-1E-13),1E+99)" for end in ends]
            text = f"MIN({','.join([text, *looks])})"
        shifted = np.minimum(times + float(node) * step, latest)
        own[TIME] = table.add(Column(TIME + mark, text, shifted, until=1))
        moved = inner.added(q, step, found)
        for index, name in enumerate(self.rates.coordinates):
            rates = [one.places[motion.velocity_names[index]] for one in before]
            formula = self._moved(places[name], inner, rates, ROW) if inner.terms else f"{places[name]}{ROW}"
            own[name] = table.add(Column(name + mark, formula, moved[:, index], until=1))
        made = Stage(self, stage, own, shifted, moved)
        made.write(map(self.rates.blocks.index, self.reduction.needed(motion.velocity_names[: len(self.rates.coordinates)])))
        found.append(made.velocities[:, : len(self.rates.coordinates)])
        return made

    def _determinant(self, stage: Stage, block: int, values: Array, pair: Cramer | None) -> None:
        """Write a determinant, of a pair of velocities with the sign of the page."""
        own, table, head = self.reduction.blocks[block], self.table, f"D{block + 1}"
        if block in stage.matrices:
            table.solved[len(table.columns)] = (stage.matrices[block], own.size)
            table.add(Column(head, "", values))
        else:
            assert own.determinant is not None
            shown, sign = (own.determinant, 1) if pair is None else (pair.determinant, pair.sign)
            table.add(Column(head, stage.text(shown), sign * values))
