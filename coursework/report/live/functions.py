"""The velocities, the drawn places and the closed start of a mechanism as JavaScript functions of time, position and data.

Enters: a `Scene`.  Leaves: `Functions`, their text and the numbers of their data argument.
Used by the live page and by the test that runs every variant of the catalogue in a browser.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from typing import Any

from coursework.equations.codegen.javascript import called_tables, javascript_function
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Bound, Statement
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.equations.reduction.system import scene_program
from coursework.motion.geometry.start import kept_at_start
from coursework.motion.schemes import Scheme, Sum
from coursework.scene.scene import Scene
from coursework.system.frozen import frozen
from coursework.variant.record.changes import follow_from


@frozen
class Functions:
    """The `text` of the functions; `numbers`: their data argument d, given data first; `tables`: the laws they call.

    rates(t, q, d, out): velocities, then the determinant of each block; places(t, q, d, out): the drawn expressions;
    closing(t, q, d, out): the expressions that are zero at the start (their number is `closed`), then their derivatives with
    respect to the coordinates at the places `moved`, whose start follows from the data `followed`.
    """

    text: str
    numbers: tuple[float, ...]
    tables: dict[str, dict[str, Any]]
    closed: int
    moved: tuple[int, ...]
    followed: tuple[str, ...]


@frozen
class Piece:
    """A function `name`(t, q, …, d, out) that executes the statements `before` and writes the expressions `wanted`.

    `arrays` are its arguments between q and d, each with the private names of its elements; symbols in `given` are arguments
    even if laws define them.
    """

    name: str
    before: Sequence[Statement]
    wanted: Sequence[Any]
    arrays: Mapping[str, Sequence[str]] = field(default_factory=dict)
    given: Sequence[Any] = ()


def rates_of(scene: Scene) -> Piece:
    """Return the function of velocities and block determinants of a scene that laws drive."""
    variant, blocks = scene.variant, scene.reduction.blocks
    statements = [one for index, block in enumerate(blocks) for one in block_statements(block, index)]
    determinants = [local(f"_det{index}") for index in range(len(blocks))]
    return Piece("rates", statements, [*map(symbol, variant.velocities), *determinants])


def live_functions(scene: Scene, places: Sequence[Any], moving: Sequence[Piece] = ()) -> Functions:
    """Return the functions of a scene; `places` are the expressions (m or rad) that are drawn.

    `moving` are the functions of its motion, if they are others than `rates`.
    """
    variant, equations = scene.variant, scene.equations
    followed = {given.name: follow_from(variant, [("given", given.name)]) for given in variant.given}
    names = {name for follow in followed.values() for name in follow}
    moved = tuple(place for place, c in enumerate(variant.coordinates) if c.name in names)
    zero = [equations.positions[place].expression - value for place, value in kept_at_start(equations, len(moved)).items()]
    numbers = constants(variant)

    def written() -> tuple[str, tuple[tuple[str, int], ...]]:
        names = [symbol(variant.coordinates[place].name) for place in moved]
        slopes = [equations.symbols.partial(expression, name) for expression in zero for name in names]
        pieces = (
            *(moving or [rates_of(scene)]),
            Piece("places", [], places),
            Piece("closing", [], [*zero, *slopes] if moved else []),
        )
        return _written(scene, pieces, [*numbers])

    blocks = tuple((block.equations, block.unknowns) for block in scene.reduction.blocks)
    text, laws = written() if moving else equations.once(("javascript", tuple(places), tuple(zero), moved, blocks), written)
    return Functions(
        text, tuple(numbers.values()), _tables(scene, laws), len(zero), moved,
        tuple(name for name, follow in followed.items() if follow),
    )  # fmt: skip


def _written(scene: Scene, pieces: Sequence[Piece], numbers: Sequence[str]) -> tuple[str, tuple[tuple[str, int], ...]]:
    """Return the functions as text, and the laws that they call; data occur in the text only by name."""
    programs, q = [(piece, _program(scene, piece)) for piece in pieces], [private(c.name) for c in scene.variant.coordinates]
    functions = [
        javascript_function(
            piece.name, {"t": (), "q": q, **piece.arrays, "d": numbers}, body,
            [f"_out{place}" for place in range(len(piece.wanted))],
        )
        for piece, body in programs
    ]  # fmt: skip
    laws = {name: law for _, body in programs for name, law in called_tables(body).items()}
    called = [f'const {name} = law("{key}", {order});' for name, (key, order) in sorted(laws.items())]
    return "\n".join((*called, *functions)), tuple(laws.values())


def _program(scene: Scene, piece: Piece) -> Bound:
    outs = [Assign(local(f"_out{place}"), value) for place, value in enumerate(piece.wanted)]
    return scene_program(scene.equations, [*piece.before, *outs], piece.given).free()


def _tables(scene: Scene, called: Iterable[tuple[str, int]]) -> dict[str, dict[str, Any]]:
    """Return for every law that is called the begin of its table, its step, its method, and the values at its nodes."""
    laws = {name: scene.equations.tables[name] for name, _ in called}
    return {
        name: {"first": law.first, "step": law.step, "spline": law.method == "spline", "levels": [*map(list, law.levels)]}
        for name, law in laws.items()
    }


def tableau(scheme: Scheme) -> dict[str, Any]:
    """Return the tableau of a scheme with the common factor of each row taken out and fractions as pairs of integers."""
    nodes = [[node.numerator, node.denominator] for node in scheme.nodes]
    return {"order": scheme.order, "nodes": nodes, "inner": [*map(_row, scheme.inner)], "outer": _row(scheme.outer)}


def _row(row: Sum) -> dict[str, Any]:
    return {"factor": [row.factor.numerator, row.factor.denominator], "terms": [*map(list, row.terms)]}
