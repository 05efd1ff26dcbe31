"""One slope of a step as formulas: time, coordinates and velocities in cells, each velocity by the formula of the page.

Enters: `StepTable`, and the places of time and coordinates.  Leaves: formulas in its columns.  Used by `columns.py`.
A law that is used only once is written out in that formula, any other has a column.  A block without a formula is solved by
MMULT and MINVERSE over its coefficients, which are in hidden columns.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from coursework.equations.codegen.names import derivative, private
from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.symbolic import local, symbol
from coursework.equations.reduction.tidy import as_formula
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import AT_EVENT
from coursework.motion.schemes import scheme_of
from coursework.system.arrays import Array
from coursework.takeaway.workbook.cells import ROW, SHEET, TIME, Column, Matrix, StepTable
from coursework.takeaway.workbook.formulas import spreadsheet
from coursework.takeaway.workbook.names import letters
from coursework.variant.formula.tree import Formula, mapped

if TYPE_CHECKING:
    from coursework.equations.algebra.expression import Expression

TIMES = letters(0)  # the column with the times of the rows


class Maker:
    """What all slopes have in common: the table, its reduction, the laws, and how often formulas use each name."""

    def __init__(self, table: StepTable) -> None:
        scene = table.run.scene
        self.table, self.scene, self.rates = table, scene, scene.rates
        self.equations, self.reduction = scene.equations, scene.reduction
        self.scheme = scheme_of(table.motion.scheme)
        self.laws = {law.name: law for law in (*scene.variant.drive, *scene.variant.functions)}
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
