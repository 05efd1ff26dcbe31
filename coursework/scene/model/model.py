"""A template compiled once: its velocities as functions of time, position and data, over arrays of any shape.

Enters: a `Variant`.  Leaves: `Model`, whose programs take the data as arguments.
Used by `start.py`, `watch.py`, `many.py`, and by who judges tables with data of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from coursework.equations.algebra.expression import Expression
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Statement, compile_function
from coursework.equations.codegen.tabulated import OutsideTable
from coursework.equations.reduction.blocks import Block, Reduction, angles_in_determinants, reduce
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.structure import structure_of
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.equations.reduction.system import scene_program
from coursework.motion.geometry.drives.drive import breaks
from coursework.motion.geometry.start import start_values
from coursework.motion.settings import Settings
from coursework.scene.exact_scene import scene_of
from coursework.scene.model.data import Data, read_data
from coursework.scene.scene import Scene
from coursework.system.arrays import Array, as_columns
from coursework.variant.catalogue import variant_from
from coursework.variant.formula.tree import evaluate
from coursework.variant.record.changes import follow_from
from coursework.variant.record.places import lengths_of
from coursework.variant.record.variant import Variant
from coursework.words.errors import InputError, visible
from coursework.words.sentences import say

Columns = list[Any]
_SETS_KEPT = 32  # sets of data whose numbers are kept: who looks for the data of a table asks for the same ones row by row


@dataclass(frozen=True, eq=False, repr=False)
class Model:
    """The structure of one template; numbers come with every call.

    `equations` and `reduction` are those of the template.  Functions take t (…,) in s, q (…, m) in rad or m, and `Data`: a single
    set goes with arrays of any shape, several sets run along the first axis of t and q.  Where a velocity has no value (beyond
    the table of a law, at a dead point) the result is nan; nothing is raised or warned about.

    >>> import coursework
    >>> model = coursework.compile_model("31")
    >>> model.coordinates, model.velocities, [block.unknowns for block in model.blocks]
    (('phi1', 'phi2', 'phi3'), ('w1', 'w2', 'w3', 'w4'), [('w3',), ('w4',), ('w1', 'w2')])
    """

    variant: Variant
    equations: VelocityEquations
    reduction: Reduction
    _compiled: dict[Any, Callable[..., Any]] = field(default_factory=dict)

    def __repr__(self) -> str:
        return (
            f"<Model of {visible(self.variant.name)}: blocks {', '.join(f'({chr(44).join(b.unknowns)})' for b in self.blocks)}>"
        )

    def bind(self, data: Any = None, settings: Settings | None = None) -> Scene:
        """Return the scene of one data set (that of the file if None); nothing of the template is made again.

        Raises `InputError` for data that do not fit.

        >>> import coursework
        >>> model = coursework.compile_model("31")
        >>> [round(float(model.bind({"r3": length}).exact.velocities[0, 2]), 4) for length in ("457 mm", "450 mm")]
        [5.5518, 5.6382]
        """
        sets = self.data(data)
        if sets.count != 1:
            raise InputError(say("fault.D023", count=sets.count))
        given, start = sets.of(0, self.variant)
        return scene_of(self.variant.with_data(given, start) if given or start else self.variant, settings or Settings())

    @cached_property
    def coordinates(self) -> tuple[str, ...]:
        """Return the names of the coordinates, in the order of q."""
        return tuple(coordinate.name for coordinate in self.variant.coordinates)

    @cached_property
    def velocities(self) -> tuple[str, ...]:
        """Return the names of the velocities: rates in file order, then unknowns."""
        return self.variant.velocities

    @property
    def blocks(self) -> tuple[Block, ...]:
        """Return the blocks in the order of solution."""
        return self.reduction.blocks

    @cached_property
    def breaks(self) -> tuple[float, ...]:
        """Return the times (s) at which a law of the template changes its formula."""
        return breaks(self.variant)

    def own_breaks(self, changed: Iterable[str]) -> bool:
        """Return whether changed data move the times at which laws change."""
        formulas = [formula for path, formula in self.variant.times.items() if path[0] != "time"]
        return any(name in formula.names() for formula in formulas for name in changed)

    @cached_property
    def angles_in_determinants(self) -> list[int]:
        """Return the indices of the angles that are not driven and occur in a determinant."""
        angles = angles_in_determinants(self.blocks, self.equations)
        return [place for place, name in enumerate(self.coordinates) if name in angles]

    @cached_property
    def lengths(self) -> tuple[Expression, ...]:
        """Return expressions that must stay positive: link lengths that follow from data alone, and the squares of the data."""
        variant, symbols = self.variant, self.equations.symbols
        known = {*variant.values, "pi"}
        sizes = [
            (symbols.scalar(length), evaluate(length, variant.values))
            for length in lengths_of(variant)
            if {*length.names()} <= known
        ]
        # A length that is negative in the file itself is intended.  A datum of zero may remove a velocity from the equations.
        scalars = [length if value > 0 else -length for length, value in sizes]
        return tuple(dict.fromkeys([*scalars, *(symbol(given.name) ** 2 for given in variant.given if given.value)]))

    def data(self, columns: Any = None) -> Data:
        """Return sets of data from a mapping or a frame of given names and start coordinates; None for the file's own.

        >>> import coursework
        >>> coursework.compile_model("31").data({"p": [10.0, 13.08], "r1": "953 mm"}).count
        2
        """
        return columns if isinstance(columns, Data) else read_data(self.variant, columns)

    def rates(self, t: ArrayLike, q: ArrayLike, data: Any = None) -> Array:
        """Return the velocities (…, k) in rad/s and m/s at times and positions.

        A free rate of [motor] follows from forces and from what was before, not from a position: here it is 1, and the others
        are those that go with it.  The motion under forces is that of `bind`, of `solve` and `solve_many`.

        >>> import coursework
        >>> coursework.compile_model("31").rates(0.0, [1.63, 3.37, 2.87]).round(4).tolist()
        [-1.5755, -0.7173, 5.5518, -16.6542]
        """
        return self._at(self.program, t, q, data, row=self.row_program)[..., : len(self.velocities)]

    def determinants(self, t: ArrayLike, q: ArrayLike, data: Any = None) -> Array:
        """Return the determinants (…, blocks) at times and positions."""
        return self._at(self.program, t, q, data)[..., len(self.velocities) :]

    def block_velocities(self, block: int, t: ArrayLike, q: ArrayLike, earlier: ArrayLike, data: Any = None) -> Array:
        """Return the velocities (…, size) of one block if those of the other blocks are `earlier` (…, k).

        `earlier` has the columns of `rates`; only those that occur in the block's equations are read.
        """
        own = self.blocks[block]
        others = [name for name in self.variant.sought if name not in own.unknowns]
        if block not in self._compiled:
            self._compiled[block] = self.compile(block_statements(own, block), [symbol(name) for name in own.unknowns], others)
        read = np.asarray(earlier, dtype=float)
        return self._at(self._compiled[block], t, q, data, [read[..., self.velocities.index(name)] for name in others])

    @property
    def row_program(self) -> Callable[..., Any]:
        """Return the same function as `program` for numbers alone, which raises where there is no value."""
        return self._of_blocks("row", numpy=False)

    @property
    def program(self) -> Callable[..., Any]:
        """Return the function (t, *q, *numbers) -> velocities then determinants, for numbers or arrays that broadcast."""
        return self._of_blocks("program", numpy=True)

    def _of_blocks(self, kept_as: str, *, numpy: bool) -> Callable[..., Any]:
        if kept_as not in self._compiled:
            statements = [one for index, block in enumerate(self.blocks) for one in block_statements(block, index)]
            results = [symbol(name) for name in self.velocities] + [local(f"_det{index}") for index in range(len(self.blocks))]
            self._compiled[kept_as] = self.compile(statements, results, numpy=numpy)
        return self._compiled[kept_as]

    def compile(
        self,
        statements: Sequence[Statement],
        results: Sequence[Expression],
        velocities: Iterable[str] = (),
        *,
        numpy: bool = True,
    ) -> Callable[..., Any]:
        """Return the function (t, *q, *velocities, *numbers) of some statements; a known law as a result gives its value."""
        known = tuple(velocities)
        outs = [Assign(local(f"_out{place}"), result) for place, result in enumerate(results)]
        body = scene_program(self.equations, [*statements, *outs], map(symbol, known)).free()
        arguments = [*map(private, ("t", *self.coordinates, *known)), *constants(self.variant)]
        names = [f"_out{place}" for place in range(len(results))]
        return compile_function("values", arguments, body, names, numpy=numpy, outside=numpy)

    def compiled(self, wanted: tuple[Expression, ...], velocities: tuple[str, ...] = ()) -> Callable[..., Any]:
        """Return the function (t, *q, *velocities, *numbers) of some expressions, compiled once."""
        if (wanted, velocities) not in self._compiled:
            names = [local(f"_value{place}") for place in range(len(wanted))]
            values = [Assign(name, value) for name, value in zip(names, wanted, strict=True)]
            self._compiled[wanted, velocities] = self.compile(values, names, velocities)
        return self._compiled[wanted, velocities]

    def follow(self, changed: Iterable[str]) -> frozenset[str]:
        """Return the coordinates whose start follows from changed data, by the rule of `Variant.with_data`."""
        keys = {("coordinates", name, "start") if name in self.coordinates else ("given", name): 0.0 for name in changed}
        return follow_from(self.variant, keys)

    def numbers(self, data: Data, beside: int = 0) -> Columns:
        """Return the arguments for the data: floats for one set, else arrays (count, 1, …) with `beside` further axes."""
        if data.count == 1:
            return [*self._one_set(data), *self._ends]
        columns = [data.given[given.name] for given in self.variant.given]
        return [*(column.reshape(-1, *[1] * beside) for column in columns), *self._ends]

    @cached_property
    def _one_set(self) -> Callable[[Data], list[float]]:
        """Return the function that gives the numbers of one set of data, for those last asked for without reading them again."""
        names = [given.name for given in self.variant.given]
        return lru_cache(_SETS_KEPT)(lambda data: [float(data.given[name][0]) for name in names])

    @cached_property
    def _of_file(self) -> Data:
        """Return the data of the file: made once, as most calls have no others."""
        return read_data(self.variant)

    @cached_property
    def _ends(self) -> list[float]:
        """Return the times (s) at which laws change: they follow the data in the arguments of a program."""
        return list(constants(self.variant).values())[len(self.variant.given) :]

    def _at(
        self, function: Callable[..., Any], t: ArrayLike, q: ArrayLike, data: Any, more: Sequence[Array] = (),
        row: Callable[..., Any] | None = None,
    ) -> Array:  # fmt: skip
        times, positions = np.asarray(t, dtype=float), np.asarray(q, dtype=float)
        if positions.shape[-1:] != (len(self.coordinates),):
            told = {"m": len(self.coordinates), "t": str(times.shape), "q": str(positions.shape)}
            raise InputError(say("fault.D036", **told))
        sets = self._of_file if data is None else self.data(data)
        if row is not None and positions.size == len(self.coordinates) and times.size == sets.count == 1:
            with suppress(ArithmeticError, ValueError, OutsideTable):  # one row in numbers takes a tenth of the time
                found = row(times.item(), *positions.ravel().tolist(), *self.numbers(sets))
                if all(map(isfinite, found)):
                    return np.array(found, dtype=float).reshape(*_common([times.shape, positions.shape[:-1]]), -1)
        shape = _common([times.shape, positions.shape[:-1], *(part.shape for part in more)])
        if sets.count != 1:
            shape = np.broadcast_shapes(shape, (sets.count, *[1] * (len(shape) - 1)))
        numbers = self.numbers(sets, max(0, len(shape) - 1))
        found = function(times, *(positions[..., place] for place in range(len(self.coordinates))), *more, *numbers)
        values = as_columns(found, shape)
        values[~np.isfinite(values)] = np.nan
        return values


def _common(shapes: list[tuple[int, ...]]) -> tuple[int, ...]:
    """Return the shape to which all broadcast; shapes that are equal, as nearly always, take a tenth of the time."""
    return shapes[0] if shapes.count(shapes[0]) == len(shapes) else np.broadcast_shapes(*shapes)


def model_of(variant: Variant) -> Model:
    """Return the model of a variant, reusing what another variant of its template has compiled before.

    Raises `InputError` if the equations do not determine the velocities.
    """
    structure = structure_of(variant)
    equations = structure.equations(structure.mechanism(variant))
    first = equations.once("model", lambda: Model(variant, equations, reduce(equations, start_values(equations))))
    return replace(first, variant=variant, equations=equations)


def compile_model(variant: Variant | str | Path | int) -> Model:
    """Return a template compiled once, whose functions take the data as arguments.  Raises `InputError`.

    >>> import coursework
    >>> coursework.compile_model("31").velocities
    ('w1', 'w2', 'w3', 'w4')
    """
    return model_of(variant_from(variant))
