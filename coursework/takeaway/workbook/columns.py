"""The columns of Euler's table as formulas: which column holds what, and the formula of each cell.

Enters: a run.  Leaves: `StepTable`, columns with their formulas and the numbers that these give.  Used inside `workbook/`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.motion.schemes import Sum
from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array
from coursework.takeaway.listing.writer import weighted
from coursework.takeaway.workbook.cells import BEFORE, NEXT, ROW, TIME, Column, StepTable
from coursework.takeaway.workbook.names import STEP, defined_names, letters, start_of
from coursework.takeaway.workbook.stage import TIMES, Maker, Stage
from coursework.takeaway.workbook.tables import Tables


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
        for index, block in enumerate(self.rates.blocks):
            self._determinant(stages[0], block, index)
        positions = [[places[name] for name in self.rates.coordinates]]
        found = [slopes[:-1]]
        for stage in range(1, self.scheme.slopes if steps > 1 else 1):
            stages.append(self._later(stage, places, stages, found))
        for index, (name, rate) in enumerate(zip(self.rates.coordinates, motion.velocity_names, strict=False)):
            column = table.columns[1 + index]
            rates = [stage.places[rate] for stage in stages]
            column.first = table.names[start_of(name)]
            column.formula = self._moved(positions[0][index], self.scheme.outer, rates, BEFORE)

    def _moved(self, own: str, row: Sum, rates: Sequence[str], at: str) -> str:
        return f"{own}{at}+{weighted(row, [f'{rate}{at}' for rate in rates], STEP, '+')}"

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

    def _determinant(self, stage: Stage, block: int, index: int) -> None:
        own, table = self.reduction.blocks[block], self.table
        head, values = f"D{block + 1}", table.motion.determinants[:, index]
        if block in stage.matrices:
            table.solved[len(table.columns)] = (stage.matrices[block], own.size)
            table.add(Column(head, "", values))
        else:
            assert own.determinant is not None
            table.add(Column(head, stage.text(own.determinant), values))
