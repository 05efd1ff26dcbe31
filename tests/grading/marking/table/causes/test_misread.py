"""A misconception written into a variant: which formulas are taken for degrees, and where the sign of the drive turns."""

from __future__ import annotations

import re

import numpy as np
import pytest

from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.key.misread import misread
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.motion.settings import Settings
from coursework.scene.scene import Scene
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant
from coursework.words.data_folders import folder
from tests.grading.marking.told import found_in
from tests.mechanisms.library import mechanism

SPLIT = 'equation = "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0"'
TEXT = (folder("variants") / "31.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(("code", "in_drive", "in_equations"), [
    ("degree_mode", True, True), ("degree_drive", True, False), ("degree_geometry", False, True),
    ("radian_mode", False, True), ("sign_drive", False, False), ("cosine_drive", False, False),
])  # fmt: skip
def test_every_sine_of_its_kind_is_taken_for_degrees(code: str, in_drive: bool, in_equations: bool) -> None:
    """On both sides of an equation, in every point."""
    assert SPLIT in TEXT
    variant = parse_variant(TEXT.replace(SPLIT, 'equation = "r3*w3*sin(phi3) - r2*w2*cos(phi2) = r1*w1*cos(phi1)"'))
    changed = misread(variant, Scene(variant, Settings()).equations, code)
    assert changed is not None
    factor = "180/pi" if code == "radian_mode" else "pi/180"

    def turned(formulas) -> set[bool]:
        """Return of formulas with sines and cosines whether the argument of each is turned."""
        texts = [spelled(one) for one in formulas]
        counts = [(len(re.findall(r"sin|cos", text)), text.count(factor)) for text in texts]
        return {{0: False, sines: True}[parts] for sines, parts in counts if sines}

    assert turned(formula for law in changed.drive for formula in law.formulas) == {in_drive}
    assert turned(one.left for one in changed.constraints) == {in_equations}
    assert turned(one.right for one in changed.constraints) == {in_equations}
    assert {factor in spelled(point) for _, point in changed.points if "@" in spelled(point)} == {in_equations}
    signs = [spelled(formula).startswith("-") for law in changed.drive for formula in law.formulas]
    assert any(signs) is (code == "sign_drive")
    laws = {law.name: [spelled(formula) for formula in law.formulas] for law in changed.drive}
    assert laws["VMy"][-1].lstrip("-").startswith("V1*cos(" if code == "cosine_drive" else ("V1*sin(", "(V1*sin("))


def test_velocities_that_the_geometry_gives_are_written_out_with_it() -> None:
    """They were still looked up at points that were written out, and each wrong table stopped the marks: KeyError."""
    key = key_of(parse_variant(mechanism("shaper-with-more-velocities")))
    table = key.table.copy()
    table[:, len(key.coordinates) :] *= 1.1
    cells = mark_cells(key, StudentTable(np.round(table, 4), np.full(table.shape, 1e-4)))
    found_in(key, cells)
    at_rest = key.misread("degree_mode")
    assert at_rest is not None
    turned = key.table[:1, : len(key.coordinates)] * np.where(
        [one.unit == "rad" for one in key.variant.coordinates], 180 / np.pi, 1
    )
    assert at_rest(key.t[:1], turned) == pytest.approx(key.table[:1, len(key.coordinates) :])
