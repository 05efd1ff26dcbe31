"""Rows under forces as formulas: free coordinates and rates by Euler's rule, the others closed, accelerations from the
equations of motion.

Enters: a run with [motor].  Leaves: `StepTable`; the names of masses, loads and start rates are among its own.
Used by `book.py`.  Each line of the program of `listing/by_forces.py` is a column, hidden except determinants and
accelerations; a position is closed by several of Newton's corrections in succession.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from coursework.equations.codegen.names import public
from coursework.equations.codegen.programs import Bound, compile_function, renamed
from coursework.equations.codegen.straight_line import Line
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array
from coursework.takeaway.listing.by_forces import Moving, moving
from coursework.takeaway.listing.syntax import Syntax, expression
from coursework.takeaway.workbook.cells import BEFORE, FIRST, ROW, SHEET, TIME, Column, StepTable
from coursework.takeaway.workbook.formulas import spreadsheet
from coursework.takeaway.workbook.names import STEP, defined_names, letters, start_of
from coursework.takeaway.workbook.tables import Tables
from coursework.variant.formula.tree import Formula
from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say

CORRECTIONS = 3  # of a position: after a step its error is 1e-2 or less, and each correction leaves about its square
_NUMBER = re.compile(r"-?[\d.]+(?:e[-+]?\d+)?")
_CALLS = {name: name.upper() for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "sqrt", "abs", "sign")}
_CELLS = Syntax(frozenset(), "IF({holds},{yes},{no})", "", ("", ""), {**_CALLS, "log": "LN", "pow": "POWER"})


def forced_columns(run: SceneRun, tables: Tables) -> StepTable:
    """Return the table of a motion under forces as formulas.

    Raises `NotToBeHad` for other schemes than Euler's, for blocks without a formula, and for tables of values.
    """
    found, motion = moving(run), run.motion
    solves = any("_solve" in line.text or "_table_" in line.text for line in (*found.known, *found.closing, *found.lines))
    if motion.scheme != DEFAULT_SCHEME.name or solves:
        raise NotToBeHad(say("fault.W044"))
    table = StepTable.of(run, motion, defined_names(found.variant), tables, (motion.names, motion.rows))
    _Writer(table, found).write()
    return table


class _Writer:
    """Puts the formulas into the columns."""

    def __init__(self, table: StepTable, found: Moving) -> None:
        self.table, self.found = table, found
        # Cells by private name: data by their defined names, then the results of lines.
        self.cells = {name: table.names.get(public(name, ()), repr(value)) for name, value in found.numbers.items()}
        self.values: dict[str, Any] = {name: np.float64(value) for name, value in found.numbers.items()}
        self.places = {name: letters(1 + place) for place, name in enumerate(table.motion.names)}

    def write(self) -> None:
        """Write known values, positions, velocities and accelerations, and how each row follows from the one before."""
        table, found, motion = self.table, self.found, self.table.motion
        states = [c.name for c in found.variant.coordinates]
        self.cells["t"], self.values["t"] = f"$A{ROW}", motion.t
        self._lines(found.known, until=table.rows - 1)
        closed = [name for name, _ in found.closed]
        for name in states:
            self._stands(f"v_{name}", self.places[name], motion.column(name))
        for name in closed:  # first guess: where the rates of the row before lead
            self._stands(name, *self._guess(public(name, ())))
        self._corrected()
        for name in closed:
            self._column(public(name, ()), f"{self.cells[name]}")
            self._stands(name, self.places[public(name, ())], motion.column(public(name, ())))
        for rate in found.states:
            self._stands(rate, self.places[public(rate, ())], motion.column(public(rate, ())))
        own = dict(zip([*states, *(public(one, ()) for one in found.states)], found.outs, strict=False))
        self._lines(found.lines)
        for name in motion.velocity_names:
            if f"v_{name}" not in found.states:
                self._column(name, self.cells[f"v_{name}"])
        for name, out in own.items():
            if f"v_{name}" not in closed:
                text = f"{self.places[name]}{BEFORE}+{STEP}*{self.cells[out].replace(ROW, BEFORE)}"
                self._column(name, text, table.names[start_of(name)])
        table.text = self._elsewhere

    def _guess(self, name: str) -> tuple[str, Array]:
        motion = self.table.motion
        rate = next(c.rate for c in self.found.variant.coordinates if c.name == name)
        values, slopes = motion.column(name), motion.column(rate)
        moved = np.concatenate([values[:1], values[:-1] + motion.step * slopes[:-1]])
        text = f"{self.places[name]}{BEFORE}+{STEP}*{self.places[rate]}{BEFORE}"
        column = Column(f"{name}′", text, moved, self.table.names[start_of(name)], shown=False)
        return self.table.add(column), moved

    def _corrected(self) -> None:
        for turn in range(1, CORRECTIONS + 1):
            targets = {name for line in self.found.closing for name in line.targets}
            own = {name: f"{name}_t{turn}" for name in targets}
            before = {name: name if turn == 1 else f"{name}_t{turn - 1}" for name, _ in self.found.closed}
            known = dict(before)
            for line in self.found.closing:
                (made,) = renamed([line], known)
                (target,) = line.targets
                self._lines([Line((own[target],), f"{own[target]} = {made.value}")])
                known[target] = own[target]
        for name, _ in self.found.closed if self.found.closing else ():
            last = f"{name}_t{CORRECTIONS}"
            self.cells[name], self.values[name] = self.cells[last], self.values[last]

    def _lines(self, lines: Iterable[Line], until: int = 0) -> None:
        """Give every line a column, whose last `until` rows stay empty, with its results as cached numbers.

        A line that is only another name or a number needs no column.
        """
        listed = [line for line in lines if line.targets]
        if not listed:
            return
        names = [name for line in listed for name in line.targets]
        computed = self._computed(listed, names)
        for line, values in zip(listed, computed, strict=True):
            (target,) = line.targets
            text = line.value
            self.values[target] = values
            if text in self.cells or _NUMBER.fullmatch(text):
                self.cells[target] = self.cells.get(text, f"({text})")
            else:
                column = Column(self._head(target), expression(text, _CELLS, self.cells), _rows(values, self.table.rows))
                column.shown, column.until = target.startswith(("_det", "_acc")), until
                self.cells[target] = f"${self.table.add(column)}{f'${FIRST}' if until else ROW}"

    def _head(self, target: str) -> str:
        """Return the head of a column; determinants and accelerations have those of the table."""
        if target.startswith("_det"):
            return f"D{int(target[4:]) + 1}"
        if target.startswith("_acc"):
            return f"d{public(self.found.states[int(target[4:])], ())}"
        return target.strip("_").removeprefix("v_")

    def _computed(self, lines: Sequence[Line], names: list[str]) -> Sequence[Any]:
        arguments = list(self.values)
        run = compile_function("cells", arguments, Bound(tuple(lines), {}, {}), names, numpy=True)
        with np.errstate(all="ignore"):
            values: Sequence[Any] = run(*self.values.values())
        return values

    def _stands(self, name: str, place: str, values: Array) -> None:
        self.cells[name], self.values[name] = f"${place}{ROW}", values

    def _column(self, name: str, text: str, first: str | None = None) -> None:
        column = self.table.columns[self.table.number(name)]
        column.formula, column.first = text, first

    def _elsewhere(self, tree: Formula) -> str:
        """Return a formula of the page over the cells of a row, for use on another sheet."""
        names = {name: f"{SHEET}!${place}{ROW}" for name, place in self.places.items()} | {TIME: f"{SHEET}!$A{ROW}"}
        return spreadsheet(tree, {**self.table.names, **names})


def _rows(values: Any, count: int) -> Array:
    return np.broadcast_to(np.asarray(values, dtype=float), (count,)).copy()
