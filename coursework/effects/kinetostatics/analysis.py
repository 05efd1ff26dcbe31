"""The force analysis of a motion: reactions and drive in every row, found in three ways, and related results.

Enters: a mechanism, its equations, a motion with its accelerations.  Leaves: `ForceAnalysis`.  Raises `InputError`.
Used by `scene/quantities.py`, which computes it on request only.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property, partial

import numpy as np

from coursework.effects.effects import Action, actions_of
from coursework.effects.force_scheme import Body, ForceScheme, Unknown, drives_of
from coursework.effects.kinetostatics.energy import Energy, energy_of, reduced_inertia
from coursework.effects.kinetostatics.groups import by_groups
from coursework.effects.kinetostatics.kinetostatics import Reactions, react
from coursework.effects.kinetostatics.virtual_power import drive_by_power
from coursework.effects.rows import RATE, SECOND, Program, Rows, compile_program
from coursework.effects.scheme import read_scheme
from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.joints import FRAME
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.geometry.closed_start import likelier
from coursework.motion.geometry.closure import compile_closure
from coursework.motion.geometry.judging.misfits import misfits
from coursework.motion.geometry.judging.rails import off_rail
from coursework.motion.geometry.judging.rigid import may_be_hinges
from coursework.motion.integration.motion import Motion
from coursework.results.checks.computed_right.beginning import start_of
from coursework.results.kinematics.extra import ExtraTable
from coursework.system.arrays import Array, Complex
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say, say_count

# A point belongs to a link only if its velocity differs from the link's by less than this share of the largest speed: rounding in
# a chain, which closes exactly, else what start values with two digits leave open.
_OFF_AXES, _MEASURED = 1e-7, 0.02
_ROUND_OFF = 1e-13  # of a velocity


@dataclass(frozen=True, eq=False)
class ForceAnalysis:
    """The `reactions` in all `rows` by Newton and Euler; also by virtual power (drives only) and group by group."""

    rows: Rows
    reactions: Reactions
    equations: VelocityEquations

    @property
    def actions(self) -> tuple[Action, ...]:
        """Return every known force and couple, including friction."""
        return (*actions_of(self.rows), *self.reactions.friction)

    @property
    def drive_names(self) -> tuple[str, ...]:
        """Return the names of the driving couples and forces."""
        return self.reactions.names[len(self.reactions.names) - len(drives_of(self.rows.scheme)) :]

    def column(self, name: str) -> Array:
        """Return one reaction or drive (n,) by its name.  Raises `ValueError` for an unknown name."""
        return self.reactions.rows[:, self.reactions.names.index(name)]

    @cached_property
    def by_power(self) -> Array | None:
        """Return the drives (n, drives) by virtual power, None if the geometry does not determine them."""
        return drive_by_power(self.rows, self.equations, self.reactions.wrench)

    @cached_property
    def by_groups(self) -> Array | None:
        """Return the unknowns (n, k) group by group, None if the order of the groups is unknown."""
        return by_groups(self.rows.scheme, self.reactions)

    @cached_property
    def energy(self) -> Energy:
        """Return energies and powers of every row."""
        drives = zip(drives_of(self.rows.scheme), self.drive_names, strict=True)
        return energy_of(self.rows, {one: self.column(name) for one, name in drives}, self.reactions.friction)

    @cached_property
    def beside(self) -> dict[str, Array]:
        """Return columns that help to follow the forces: accelerations of mass centres and links, force along the path."""
        found: dict[str, Array] = {}
        for body in self.rows.scheme.bodies:
            if body.mass is not None:
                second = self.rows.vector(body.centre, SECOND)
                found |= {f"S{body.name}.ax": second.real, f"S{body.name}.ay": second.imag}
            if body.rate or np.any(self.rows.epsilon(body)):
                found[f"e{body.name}"] = self.rows.epsilon(body)
        drives = drives_of(self.rows.scheme)
        point = [one for one in drives if one.direction.kind in {"x", "y"}]
        if len(point) == 2 and point[0].at is not None:
            moved = self.rows.vector(point[0].at, RATE)
            force = self.column(self.drive_names[0]) + 1j * self.column(self.drive_names[1])
            speed = np.abs(moved)
            found["F_path"] = np.where(speed > 0, (np.conj(moved) * force).real / np.where(speed > 0, speed, 1.0), 0.0)
        if len(drives) == 1 and drives[0].direction.kind == "couple" and drives[0].off == FRAME:
            rate, change = self.rows.turns[drives[0].on]
            found["J"], found["dJ"] = reduced_inertia(self.rows, rate, change)
        for name, (value, angle) in self.reactions.partly.items():
            found |= {f"{name}.across": value, f"{name}.angle": angle}
        return found

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the columns of `forces.csv` after t."""
        return (*self.reactions.names, *self.beside)

    @property
    def table(self) -> Array:
        """Return the rows (n, names) of `forces.csv`, nan where a reaction is not unique."""
        return np.column_stack([self.reactions.rows, *self.beside.values()])

    @property
    def units(self) -> tuple[str, ...]:
        """Return the unit of each column."""
        # The drive of a coordinate that no link has is a couple for an angle and a force for a length.
        unknowns = self.rows.scheme.unknowns
        found = ["N·m" if one.direction.kind == "couple" or one.name[0] == "M" else "N" for one in unknowns]
        return (*found, *map(_unit_beside, self.beside))

    def as_table(self) -> ExtraTable:
        """Return the columns of `forces.csv`."""
        rows = np.column_stack([self.rows.motion.t, self.table])
        return ExtraTable(say("extra.forces"), ("t", *self.names), ("s", *self.units), rows, blanks=True)

    def over(self, motion: Motion, second: Array) -> ForceAnalysis:
        """Return the analysis of another motion of the same mechanism; its joints have been judged in these rows."""
        rows = _program(self.equations, lambda: self.rows.scheme).rows(self.equations, motion, second)
        return ForceAnalysis(rows, react(rows), self.equations)


def _unit_beside(name: str) -> str:
    if name == "F_path" or name.endswith(".across"):
        return "N"
    if name in {"J", "dJ"}:
        return "kg·m²"
    return "rad" if name.endswith(".angle") else "rad/s²" if name[0] == "e" else "m/s²"


def _program(equations: VelocityEquations, scheme: Callable[[], ForceScheme]) -> Program:
    found: Program = equations.once(("forces", equations.variant.forces), lambda: compile_program(equations, scheme()))
    return found


def analyse(
    mechanism: Mechanism, equations: VelocityEquations, motion: Motion, second: Array, moved: Motion
) -> ForceAnalysis:  # fmt: skip
    """Return the force analysis of a motion; `second` (n, k) are its accelerations.

    `moved` is the motion, or another of the same mechanism if nothing moves in it: it shows whether links keep their shape.
    """

    def near() -> tuple[tuple[str, str], ...]:
        return may_be_hinges(equations, motion.coordinates[0].tolist())

    program = _program(equations, lambda: read_scheme(mechanism, near=near))
    rows = program.rows(equations, motion, second)
    judged = rows if moved is motion else program.rows(equations, moved, np.zeros_like(moved.velocities))
    _require_rigid(judged, equations)
    return ForceAnalysis(rows, react(rows), equations)


def _require_rigid(rows: Rows, equations: VelocityEquations) -> None:
    """Raise `InputError` for pins and centres of mass not fixed in their links, and for forces on a link at points outside it."""
    scheme, variant = rows.scheme, equations.variant
    centres = {body.name: body.centre for body in scheme.bodies}
    share = _OFF_AXES if variant.groups else _MEASURED
    listed: list[tuple[tuple[str, ...], str, Formula | None]] = [(("masses", name), name, at) for name, at in scheme.pinned]
    listed += [
        (("masses", mass.body, "centre"), mass.body, centres[scheme.body_named(mass.body)]) for mass in scheme.forces.masses
    ]
    listed += [(("forces", load.name, "at"), load.on, load.at) for load in scheme.forces.loads if load.force is not None]
    faults, doubt = [], cache(partial(_doubt, rows, equations))
    for path, name, at in listed:
        body = scheme.by_name[scheme.body_named(name)]
        if at is None or not rows.count or _is_fixed(rows, body, scheme.own_point(name), at, share):
            continue
        turned_back = body.rate and _is_fixed(rows, body, scheme.own_point(name), at, share, sense=-1)
        why = say("fault.doubt.turned_back", name=body.name, rate=body.rate) if turned_back else doubt()
        if path[0] == "forces":
            told = say("fault.V732", name=body.name, held=", ".join(scheme.holds.get(body.name, ())), doubt=why)
        else:
            told = say("fault.V731" if len(path) > 2 else "fault.V735", name=body.name, point=spelled(at), doubt=why)
        faults.append(Fault(told, variant.file, variant.nearest_line(*path), 0, ".".join(path)))
    faults += [fault for one in scheme.unknowns if (fault := _moving_guide(rows, one, variant, share, doubt)) is not None]
    if faults:
        raise InputError([found] if (found := _open_start(rows, equations)) is not None else faults)


def _open_start(rows: Rows, equations: VelocityEquations) -> Fault | None:
    """Return the fault of start values that leave the mechanism open: then links seem to change their shape for that alone."""
    variant, begun = equations.variant, start_of(compile_closure(equations, rows.motion.coordinates[0].tolist()))
    if begun.verdict != "FAIL":
        return None
    return Fault(
        say("fault.V737", start=begun.sentence, hint=likelier(variant)), variant.file, variant.nearest_line("coordinates")
    )


def _is_fixed(rows: Rows, body: Body, own: Formula | None, at: Formula, share: float, *, sense: int = 1) -> bool:
    """Return whether a point moves with a body, as its `own` point does, for a `sense` of -1 if it turned the other way round."""
    if own is None or own == at:
        return True
    turned = 1j * sense * rows.omega(body) * (rows.vector(at) - rows.vector(own))
    return _are_equal(rows, share, rows.vector(at, RATE), rows.vector(own, RATE) + turned, turned)


def _doubt(rows: Rows, equations: VelocityEquations) -> Sentence | str:
    """Return that an equation is to be looked at first: one that does not fit the links, or else one that nothing judges."""
    unjudged, unfit = misfits(equations, rows.motion.t, rows.motion.coordinates)
    if unfit:
        return say_count("fault.doubt.unfit", len(unfit), names=unfit)
    return say("fault.doubt.unjudged", names=unjudged) if unjudged else ""


def _moving_guide(rows: Rows, one: Unknown, variant: Variant, share: float, doubt: Callable[[], Sentence | str]) -> Fault | None:
    """Return the fault of a straight guide that turns or shifts otherwise than the link that carries it, else None."""
    angle, at = one.direction.angle, one.at
    if one.direction.kind != "across" or angle is None or at is None or not rows.count:
        return None
    body, own = rows.scheme.by_name.get(one.off), rows.scheme.own_point(one.off)
    omega = rows.omega(body) if body is not None else np.zeros(rows.count)
    moved, turning = rows.vector(at, RATE), rows.values[angle, False, RATE]
    carried = 0j * moved
    if body is not None:
        carried = moved if own is None else rows.vector(own, RATE) + 1j * omega * (rows.vector(at) - rows.vector(own))
    across = np.conj(rows.along(one))
    shifts = (across * moved).real, (across * carried).real
    if _are_equal(rows, share, turning, omega) and _are_equal(rows, share, *shifts, moved, carried):
        return None
    index = next((k for k, group in enumerate(variant.groups) if angle in [guide.angle for guide in group.guides]), None)
    line = variant.nearest_line("frame", "rails") if index is None else variant.nearest_line("group", index, "guide")
    pin = variant.groups[index].meets if index is not None else None
    way = moved if len({*rows.vector(at)}) == 1 else rows.vector(at) - rows.vector(at)[0]
    farthest = complex(way[int(np.argmax(np.abs(way)))])
    if body is None and index is None and farthest and not turning.any():  # a rail of the frame is where it is
        is_curved = bool(np.abs((way * np.conj(farthest)).imag).max() > share * abs(farthest) ** 2)
        return Fault(off_rail(spelled(at), complex(1j * np.conj(across[0])), farthest, is_curved), variant.file, line)
    return Fault(say("fault.V736", name=one.off, point=pin or spelled(at), doubt=doubt()), variant.file, line)


def _are_equal(rows: Rows, share: float, found: Array | Complex, wanted: Array | Complex, *beside: Array | Complex) -> bool:
    """Return whether two velocities differ by no more than a `share` of the largest, in the rows whose positions do not drift.

    Where all of them are but round-off of the motion, as about a point that stands still, they do not differ.
    """
    kept = slice(None) if rows.motion.scheme == EXACT else slice(1)
    largest = max(np.abs(one[kept]).max() for one in (found, wanted, *beside))
    least = _ROUND_OFF * rows.length * float(np.abs(rows.motion.velocities).max())
    return bool(np.abs(found - wanted)[kept].max() <= share * largest + least)
