"""Files of the catalogue with masses that nobody gave them, and force analyses, each made once a process."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import coursework
from coursework.effects.kinetostatics.analysis import ForceAnalysis, analyse
from coursework.mechanism.joints import with_sliders
from coursework.mechanism.mechanism import build
from coursework.mechanism.structure import Bodies, fitting_linkage
from coursework.scene.scene import Scene
from coursework.variant.catalogue import load
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.forces import Forces, Mass
from coursework.variant.record.variant import Variant

CATALOGUE = Path(coursework.load("31").path).parent


def value(number: float) -> Formula:
    """Return a number as a file writes it."""
    size = Formula("number", name=repr(abs(number)))
    return size if number >= 0 else Formula("neg", (size,))


def massed(variant: Variant) -> Variant:
    """Return a variant in which every body is heavy, its centre of mass in the middle or in one of its points."""
    mechanism = build(variant)
    bodies = Bodies(mechanism, with_sliders(fitting_linkage(mechanism), lambda joint: bool(variant.groups)))
    masses = []
    for place, body in enumerate(sorted(bodies.linkage.bodies)):
        points = bodies.points()[body]
        centre = named(points[0]) if len(points) > 2 else None
        masses.append(Mass(bodies.called[body], value(2.0 + place), value(0.05 * (place + 1)), centre))
    return replace(variant, forces=Forces(tuple(masses), (value(0.7), value(-9.81))))


def analysis(scene: Scene, *, exact: bool = False) -> ForceAnalysis:
    """Return the forces of a scene's rows, or of its exact ones."""
    motion = scene.exact if exact else scene.motion
    second = scene.exact_accelerations if exact else scene.results.accelerations
    return analyse(scene.mechanism, scene.equations, motion, second, motion)


@cache
def of(name: str, scheme: str = "exact") -> ForceAnalysis:
    """Return the forces of a file of the catalogue."""
    return analysis(coursework.solve(name, scheme=scheme).scene)


def of_text(text: str, **options: Any) -> ForceAnalysis:
    """Return the forces of a file given as text."""
    return analysis(coursework.solve(coursework.parse_variant(text), **options).scene)


__all__ = ["CATALOGUE", "analysis", "load", "massed", "of", "of_text", "value"]
