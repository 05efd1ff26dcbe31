"""The velocities, the drawn places and the closed start of a mechanism as JavaScript functions of time, position and data.

Enters: a `Scene`.  Leaves: `Functions`, text and the numbers behind its data argument.
Used by the live page and by the test that runs every variant of the catalogue in a browser.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from coursework.equations.codegen.javascript import called_tables, javascript_function
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Bound, Statement
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.equations.reduction.system import scene_program
from coursework.scene.scene import Scene
from coursework.system.frozen import frozen
from coursework.variant.record.changes import follow_from


@frozen
class Functions:
    """`text` of the functions; `numbers` the data d they take, the given ones first; `tables` the laws they call.

    rates(t, q, d, out): velocities, then the determinant of each block; places(t, q, d, out): the expressions asked for;
    closing(t, q, d, out): the `closed` expressions that are zero at the start, and their derivatives by the `moved`
    coordinates, whose start follows from the data `followed`.
    """

    text: str
    numbers: tuple[float, ...]
    tables: dict[str, dict[str, Any]]
    closed: int
    moved: tuple[int, ...]
    followed: tuple[str, ...]


def live_functions(scene: Scene, places: Sequence[Any]) -> Functions:
    """Return the functions of a scene; `places` are the expressions (m or rad) that are drawn."""
    variant, equations = scene.variant, scene.equations
    blocks = scene.reduction.blocks
    velocities = (*variant.rates, *(name for name, _ in variant.unknowns))
    statements = [one for index, block in enumerate(blocks) for one in block_statements(block, index)]
    followed = {given.name: follow_from(variant, [("given", given.name)]) for given in variant.given}
    names = {name for follow in followed.values() for name in follow}
    moved = tuple(place for place, c in enumerate(variant.coordinates) if c.name in names)
    zero = [position.expression for position in equations.positions if position.target == "zero"]
    slopes = [
        equations.symbols.partial(expression, symbol(variant.coordinates[place].name)) for expression in zero for place in moved
    ]
    bodies: tuple[tuple[str, Sequence[Statement], Sequence[Any]], ...] = (
        ("rates", statements, [*map(symbol, velocities), *(local(f"_det{index}") for index in range(len(blocks)))]),
        ("places", [], places),
        ("closing", [], [*zero, *slopes] if moved else []),
    )
    programs = [(name, _program(scene, before, wanted), len(wanted)) for name, before, wanted in bodies]
    numbers = constants(variant)
    arrays = {"t": (), "q": [private(c.name) for c in variant.coordinates], "d": [*numbers]}
    functions = [
        javascript_function(name, arrays, body, [f"_out{place}" for place in range(count)]) for name, body, count in programs
    ]
    laws = {name: law for _, body, _ in programs for name, law in called_tables(body).items()}
    called = [f'const {name} = law("{key}", {order});' for name, (key, order) in sorted(laws.items())]
    return Functions(
        "\n".join((*called, *functions)), tuple(numbers.values()), _tables(scene, laws.values()), len(zero), moved,
        tuple(name for name, follow in followed.items() if follow),
    )  # fmt: skip


def _program(scene: Scene, before: Sequence[Statement], wanted: Sequence[Any]) -> Bound:
    outs = [Assign(local(f"_out{place}"), value) for place, value in enumerate(wanted)]
    return scene_program(scene.equations, [*before, *outs]).free()


def _tables(scene: Scene, called: Iterable[tuple[str, int]]) -> dict[str, dict[str, Any]]:
    """Return of every law that is called where its table begins, its step, its method, and what stands at its nodes."""
    laws = {name: scene.equations.tables[name] for name, _ in called}
    return {
        name: {"first": law.first, "step": law.step, "spline": law.method == "spline", "levels": [*map(list, law.levels)]}
        for name, law in laws.items()
    }
