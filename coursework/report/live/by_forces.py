"""Additions to the live part of a page for a file with forces: sliders for masses and loads, forces on the links, free motion.

Enters: a `SceneRun` whose file has forces.  Leaves: `Moved`: functions and numbers for the script.
Used by `page.py`, for such a file only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from coursework.effects.acting import COUPLE, Acting, ActingWriter, accelerated
from coursework.effects.dynamics.closed_positions import newton_statements
from coursework.effects.dynamics.motion_writer import MotionWriter
from coursework.effects.scheme import read_scheme
from coursework.equations.algebra.expression import Expression
from coursework.equations.codegen.names import acceleration, private
from coursework.equations.codegen.programs import Assign, Solve, Statement
from coursework.equations.reduction.symbolic import local, symbol
from coursework.motion.schemes import DEFAULT_SCHEME, SCHEMES, SEMI_IMPLICIT, title_of
from coursework.report.live.functions import Functions, Piece, live_functions, rates_of, tableau
from coursework.report.text.words import Words
from coursework.scene.exact_scene import scene_of
from coursework.scene.scene import Scene
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, evaluate, named, number
from coursework.variant.record.entries import Given
from coursework.variant.record.forces import Load, Mass
from coursework.variant.record.variant import Variant
from coursework.words.sentences import Phrases


@frozen
class Moved:
    """The `scene` of a variant whose masses and loads are data, the `functions` of its motion, `numbers` of the script by key."""

    scene: Scene
    functions: Functions
    numbers: dict[str, Any]

    def pieces(self, known: Sequence[str]) -> list[str]:
        """Return the pieces of the script; `known` are those of a page without forces."""
        first, *others, last = known
        free = self.scene.variant.motor is not None
        begin, end = (["free_motion"], ["free_laboratory"]) if free else ([], [])
        return [first, *begin, *others, "acting", "forces", *end, last]


def given_once(statements: Sequence[Statement]) -> Iterator[Statement]:
    """Yield statements that assign each name once: a block solved again for another right side names its determinant anew.

    Assignments of the energies are left out, because `acting` has them.
    """
    known: set[Expression] = {local("_kinetic"), local("_potential")}
    for one in statements:
        if isinstance(one, Solve) and one.determinant in known:
            yield replace(one, determinant=local(f"_again{len(known)}"))
        elif isinstance(one, Solve) or one.target not in known:
            yield one
        known.add(one.determinant if isinstance(one, Solve) else one.target)


def said_of(
    found: Moved, said: Mapping[str, Any], phrases: Phrases, label: Callable[[str], str], unit: Callable[[str], str]
) -> dict[str, Any]:
    """Return `said`, the labels, units and words of a page without forces, with those that forces add."""
    forces = found.numbers["forces"]
    units = {"E": unit("J")} | {
        name: unit("N·m" if kind == COUPLE or name[0] == "M" else "N")
        for name, *_, kind, drive in forces["unknowns"] if drive
    }  # fmt: skip
    names = [*units, *found.scene.variant.values]
    semi = {f"scheme_{SEMI_IMPLICIT.name}": phrases.written(title_of(SEMI_IMPLICIT))} if "free" in forces else {}
    return {
        "labels": said["labels"] | {name: text for name in names if (text := label(name)) != name},
        "unit_words": said["unit_words"] | units,
        "behind": said["behind"] | {name: Words(phrases).behind(text) for name, text in units.items()},
        "words": said["words"] | semi,
    }


def moved_by(run: SceneRun, places: Sequence[Any]) -> Moved:
    """Return the scene, functions and numbers of the live part of a page with forces; `places` are the drawn points (m)."""
    scene = scene_of(with_weights(run.variant), run.settings)
    if scene.variant.motor is not None:
        return _by_motor(scene, run.scheme, places)
    acting = ActingWriter(scene.equations, read_scheme(scene.mechanism)).acting()
    own = Piece(
        "acting", [one for block in accelerated(scene.equations, scene.reduction) for one in block], acting.wanted,
        {"u": [*map(private, scene.variant.velocities)]}, [*map(symbol, scene.variant.velocities)],
    )  # fmt: skip
    return Moved(scene, live_functions(scene, places, [rates_of(scene), own]), {"forces": _told(acting, scene.variant)})


def _by_motor(scene: Scene, scheme: str, places: Sequence[Any]) -> Moved:
    """Return the same for a mechanism that forces move: its rows have the coordinates, then the free rates."""
    variant, equations, forces = scene.variant, scene.equations, read_scheme(scene.mechanism)
    assert variant.motor is not None
    motor = MotionWriter(equations, scene.reduction, forces, tuple(scene.start))
    statements = motor.statements()
    before = [*given_once([*(Assign(local(name), value) for name, value in motor.weights.items()), *statements])]
    acting = ActingWriter(equations, forces).acting()
    free, v = [symbol(rate) for rate in motor.rates], {"v": [private(rate) for rate in motor.rates]}
    unknowns = [name for name, _ in variant.unknowns]
    slopes = [*map(symbol, variant.rates), *motor.solved, *map(symbol, unknowns)]
    slopes += [local(f"_det{index}") for index in range(len(scene.reduction.blocks))]
    # Forces depend on all velocities and their derivatives; derivatives that no row contains follow after the others.
    others = [name for name in variant.velocities if name not in motor.rates]
    more = [*map(motor.acceleration_of, others)]
    u = [*map(private, variant.rates), *map(acceleration, motor.rates), *map(private, unknowns)]
    u += [f"_det{index}" for index in range(len(scene.reduction.blocks))] + [*map(acceleration, others)]
    blocks, kept, held = newton_statements(equations, scene.start, motor.others)
    deltas = [local(f"_step{place}") for place in motor.others]
    pieces = [
        Piece("slope", before, [*slopes, *more], v, free), Piece("held", [], held),
        Piece("acting", [], acting.wanted, {"u": u}, [*map(symbol, variant.velocities)]),
        Piece("corrected", blocks, deltas, {"k": [f"_kept{k}" for k in range(len(kept))]}),
    ]  # fmt: skip
    functions = live_functions(scene, places, pieces)
    text = f"{functions.text}\nconst rates = (t, q, d, out) => {{\nreturn moving(t, q, d, out);\n}};"
    start, schemes = dict(variant.motor.start), {**SCHEMES, SEMI_IMPLICIT.name: SEMI_IMPLICIT}
    numbers = {
        "forces": _told(acting, variant)
        | {"free": list(motor.free), "others": list(motor.others), "held": len(held), "more": len(more)},
        "coordinates": [*(c.name for c in variant.coordinates), *motor.rates],
        "velocities": [*variant.rates, *(f"d{rate}" for rate in motor.rates), *unknowns],
        "start": [*scene.start, *(start.get(rate, 0.0) for rate in motor.rates)],
        "schemes": {name: tableau(one) | ({"early": True} if one is SEMI_IMPLICIT else {}) for name, one in schemes.items()},
        "scheme": scheme if scheme in schemes else DEFAULT_SCHEME.name,
        "own": scheme in schemes,
    }
    return Moved(scene, replace(functions, text=text), numbers)


def with_weights(variant: Variant) -> Variant:
    """Return the variant with masses and loads given as numbers turned into data: m_1 for link 1, a load under its name."""
    forces = variant.forces
    assert forces is not None
    masses = [_weighed(mass, variant) for mass in forces.masses]
    loads = [_loaded(load, variant) for load in forces.loads]
    more = tuple(given for _, given in (*masses, *loads) if given is not None)
    changed = replace(forces, masses=tuple(mass for mass, _ in masses), loads=tuple(load for load, _ in loads))
    return replace(variant, given=(*variant.given, *more), forces=changed)


def _weighed(mass: Mass, variant: Variant) -> tuple[Mass, Given | None]:
    """Return the mass with a datum in place of its number, and that datum; its inertia is scaled with it.

    Return the mass unchanged and None if it is a formula, is zero, or its name is taken.
    """
    name = f"m_{mass.body}"
    if mass.mass.names() or name in variant.names or not (size := evaluate(mass.mass, {})):
        return mass, None
    inertia = mass.inertia
    if isinstance(inertia, Formula) and not inertia.names():
        inertia = Formula("*", (inertia, Formula("/", (named(name), number(Fraction(size))))))
    return replace(mass, mass=named(name), inertia=inertia), Given(name, size, "kg", "", "kg")


def _loaded(load: Load, variant: Variant) -> tuple[Load, Given | None]:
    """Return the load with a datum, and that datum: the size of a constant torque, else a factor of the load.

    Return the load unchanged and None if its name is taken or it already depends on data.
    """
    given = {one.name for one in variant.given}
    formulas = [one for one in (load.torque, load.force) if one is not None]
    if load.name in variant.names or any(given.intersection(one.names()) for one in formulas):
        return load, None
    if load.torque is not None and not load.torque.names() and (size := evaluate(load.torque, {})):
        return replace(load, torque=named(load.name)), Given(load.name, size, "N*m", "", "N*m")
    torque, force = (one and Formula("*", (named(load.name), one)) for one in (load.torque, load.force))
    return replace(load, torque=torque, force=force), Given(load.name, 1.0, "1", "", "")


def _told(acting: Acting, variant: Variant) -> dict[str, Any]:
    """Return the data on forces for the script."""
    assert variant.forces is not None
    drives = [name for name, *_, drive in acting.unknowns if drive and variant.motor is None]
    arrows: dict[str, list[int]] = {}
    for place, (name, *_, kind, drive) in enumerate(acting.unknowns):
        if kind != COUPLE and not (drive and variant.motor is not None):
            arrows.setdefault(name.removesuffix("xy"[kind]) if kind < COUPLE else name, []).append(place)
    return {
        "bodies": acting.bodies, "places": acting.places, "unknowns": [*map(list, acting.unknowns)], "size": len(acting.wanted),
        "drives": drives, "arrows": [[f"{name[0]}_{name[1:]}", *columns] for name, columns in arrows.items()],
    }  # fmt: skip
