"""Real runs that the tests of the report look at: variant 31 as it is, stopped, hostile, and what else a page can show."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import coursework
from coursework.scene.scene_run import SceneRun
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.variant import Variant
from tests.hard.scenes import four_bar, scene
from tests.mechanisms import library
from tests.report.made import model_of
from tests.solved import solved

ROOT = Path(__file__).parents[2]
V31 = (ROOT / "variants" / "31.toml").read_text(encoding="utf-8")
EVERYTHING = ("table", "plots", "checks", "graph_check", "accelerations", "points", "accuracy")
HOSTILE = (
    "<script>alert(1)</script> $x_$ $\\frac{$ #eval(\"1+1\") #read(\"/etc/passwd\") *b* `c` @label \\ {{7*7}} {student} %s "
    "]) & \"q\" 'q' abc\u202egfed\u202c \x00\x07\u0000 \ud800 "
)  # fmt: skip


def changed(changes: Mapping[str, str], text: str = V31) -> Variant:
    """Return the variant of a file in which some texts are others."""
    return parse_variant(library.changed(text, *changes.items()))


@cache
def full() -> SceneRun:
    """Return variant 31 with everything its file asks for."""
    return solved("31", student="Olena Kovalchuk", group="MT-21")


@cache
def stopped() -> SceneRun:
    """Return variant 31 with the phase of the drive that leads to a dead point."""
    return coursework.solve(changed({'"4.35 rad"': '"0.02 rad"'}))


def hostile() -> SceneRun:
    """Return variant 31 with hostile text wherever a file or a student may write some."""
    variant = full().variant
    constraints = tuple(replace(one, because=HOSTILE) for one in variant.constraints)
    given = tuple(replace(one, means=HOSTILE) for one in variant.given)
    texts = {"title": HOSTILE, "source": HOSTILE, "teaches": HOSTILE, "remarks": (HOSTILE,)}
    made = coursework.solve(replace(variant, constraints=constraints, given=given, **texts), student=HOSTILE, group=HOSTILE)
    return replace(made, teacher=HOSTILE, institution=HOSTILE, date=HOSTILE)


def parts(run: SceneRun, section: str) -> list[dict[str, Any]]:
    """Return the parts of a section as plain dicts."""
    found = [s for s in model_of(run).sections if s.name == section]
    assert found, f"no section {section}"
    return list(found[0].plain()["parts"])


def text_of(thing: Any) -> str:
    """Return all text inside a part, runs joined."""
    if isinstance(thing, str):
        return thing
    if isinstance(thing, dict):
        keys = ("t", "v", "s", "p", "c", "o") if set(thing) <= {"t", "v", "s", "p", "c", "o", "lang"} else thing
        return "".join(text_of(thing.get(key, "")) for key in keys)
    if not isinstance(thing, list | tuple):
        return ""
    return ("" if is_runs(thing) else " ").join(text_of(x) for x in thing)


def is_runs(thing: Any) -> bool:
    """Return whether a list is a sentence split into runs."""
    return bool(thing) and all(isinstance(x, dict) and set(x) <= {"t", "v", "s", "p", "c", "o", "lang"} for x in thing)


HELD = scene(
    'phi1 = { start = "1 rad", rate = "w1" }\nphi2 = { start = "-0.28 rad", rate = "w2" }',
    given='r1 = "0.4 m"\nr2 = "1.2 m"',
    drive='w1 = "3 rad/s"',
    more='[points]\nA = "(0, 0)"\nB = "A + r1 @ phi1"\nC = "B + r2 @ phi2"\n[closure]\nholds = ["C.y - 0.1*C.x"]\n',
)


def oddities() -> list[SceneRun]:
    """Return runs of files with rare marks: pieces, remarks, starts that follow, an equation too many, nothing written."""
    remarked = changed({'"4.35 rad"': "10.6331853072", '"1.63 rad"': "1.63"})
    twice = 'equation = "VMx - r3*w4 + 2*r3*w3*cos(phi3) - 4*r3*w3*sin(phi3) = 0"'
    redundant = parse_variant(f'{V31}\n[[constraint]]\nname = "twice"\nbecause = ""\n{twice}\n')
    moved = coursework.load("andrews").with_data(given={"u": 0.0401})
    fold = parse_variant(four_bar(1, 2, 1, 2, (0.0, 0.0, 0.0)))
    still = parse_variant(scene('phi = { start = "1 rad", rate = "w" }', equations=["w = 0"]))
    sums = ["wa + wb + wc = 3", "wa - wb + 2*wc = 2*cos(a)", "wa + 2*wb - wc = 2"]
    starts = "\n".join(f'{name} = {{ start = "0 rad", rate = "w{name}" }}' for name in "abc")
    three = parse_variant(scene(starts, equations=sums))
    table = coursework.load("variable-crank-table")
    smooth = replace(table, functions=tuple(replace(law, method="spline") for law in table.functions))
    more = 'rails  = [ { through = "C", angle = "0" }, {'
    guides = changed({'through = "P", angle = "0"': 'through = "M", angle = "90 deg"', "rails  = [ {": more})
    coarse = {'"0.02 s"': '"0.2 s"', '"0.48 s"': '"0.4 s"', "check_row = 4 ": "check_row = 2 "}
    dead = changed({'"4.35 rad"': '"0.02 rad"', **coarse})
    arm = (ROOT / "variants" / "robot-arm.toml").read_text(encoding="utf-8")
    closed = parse_variant(arm[: arm.index("[[constraint]]")] + arm[arm.index("[points]") :])
    ring = (ROOT / "variants" / "epicyclic.toml").read_text(encoding="utf-8")
    unjudged = parse_variant(ring[: ring.index("[closure]")])
    texts = (unjudged, closed, parse_variant(HELD), remarked, redundant, moved, fold, still, three, smooth, guides, dead)
    bare = [coursework.solve(one, quantities=["table"]) for one in texts]
    parts = {"31": "phi3", "example-1": "theta2", "v107": "accuracy"}
    return [*bare, *(solved(name, quantities=[quantity]) for name, quantity in parts.items())]


def timed() -> SceneRun:
    """Return variant 31 with a study of accuracy that names seconds, and one method that did not finish."""
    study = full().accuracy
    assert study is not None
    each = enumerate(study.rows)
    rows = tuple(replace(row, seconds=1e-6 * (row.evaluations + 1), failed="" if place else "why") for place, row in each)
    machine = {"system": "Linux x86_64", "processors": "2", "python": "CPython 3.11"}
    shown = replace(study, rows=rows, seconds_shown=True, overhead=(("imports", 0.9), ("reduce", 0.1)), machine=machine)
    return replace(full(), timed=shown)
