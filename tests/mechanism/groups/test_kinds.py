"""A kind of group is one record in one file: added to `GROUPS`, and named where a file may name it,
it is read, solved, explained and counted everywhere."""

import json
import subprocess
import sys

import pytest

from coursework.mechanism.groups import GROUPS
from coursework.variant.record.vocabulary import GROUP_SHAPES
from tests.sources import PACKAGE, files, strings

# A second name for the dyad RRP, whose dead point means something else; the tool has never heard of it.
DUMMY = """
import json
from dataclasses import replace
from coursework.mechanism import groups
from coursework.mechanism.groups.rrp import RRP
from coursework.variant.record import vocabulary
vocabulary.GROUP_KINDS["LIFT"] = 1
groups.GROUPS = (*groups.GROUPS, replace(RRP, name="LIFT", meaning="determinant.parallel"))
import coursework
from coursework.variant.catalogue import find
from coursework.variant.reading.reader import parse_variant
from coursework.variant.reading.models import json_schema

def made(text):
    variant = parse_variant(text, "lift")
    run = coursework.solve(variant, quantities=["table", "checks"])
    return run, parse_variant(text.replace('r2 = "1.2 m"', 'r2 = "0.3 m"').replace('"0 deg"', '"90 deg"'), "short")

text = find("example-2").read_text(encoding="utf-8").replace('angle = "0"', 'angle = "0.3"')
(known, _), (lift, short) = made(text), made(text.replace('"RRP"', '"LIFT"'))
try:
    coursework.solve(short).motion
    told = ""
except coursework.InputError as error:
    told = str(error)
try:
    parse_variant(text.replace('"RRP"', '"LIFTS"'), "unknown")
    unknown = ""
except coursework.InputError as error:
    unknown = str(error)
print(json.dumps({
    "same": lift.table.equals(known.table),
    "exact": lift.exact.coordinates.tolist() == known.exact.coordinates.tolist(),
    "label": lift.exact.label,
    "meanings": [run.reduction.blocks[-1].meaning for run in (known, lift)],
    "reasons": [run.equations[0].because for run in (known, lift)],
    "mobility": lift.scene.mechanism.mobility.degrees,
    "told": told,
    "unknown": unknown,
    "schema": "LIFT" in json.dumps(json_schema()),
}))
"""


def test_a_kind_alone_is_found_everywhere(tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", DUMMY], capture_output=True, text=True, encoding="utf-8", check=False, cwd=tmp_path
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["same"]
    assert found["exact"]
    assert found["label"] == "closed form of the groups"
    assert found["meanings"][0].endswith("at a right angle to the guide")
    assert found["meanings"][1] == "the two guides are parallel"
    assert [("RRP" in reason, "LIFT" in reason) for reason in found["reasons"]] == [(True, False), (False, True)]
    assert found["mobility"] == 1
    assert "LIFT" in found["told"]
    assert '"LIFT"' in found["unknown"]
    assert found["schema"]


@pytest.mark.parametrize("kind", GROUPS, ids=repr)
def test_no_kind_is_named_outside_its_file(kind):
    home = f"mechanism/groups/{kind.name.lower()}.py"
    naming = {path.relative_to(PACKAGE).as_posix() for path in files() if kind.name in strings(path)}
    # Where the procedures are exported; what mechanisms of other programs are written down as; two dyads as formulas of cells.
    told = {"mechanism/groups/__init__.py", "procedures.py", "takeaway/workbook/dyads.py"}
    told |= {path for path in naming if path.startswith("takeaway/foreign/")}
    assert naming - told == {home, "variant/record/vocabulary.py"}


# How many points a group hangs on, lengths, guides, coordinates and how many of these are angles: Artobolevsky's classes.
COUNTS = {
    "crank": (1, (1,), 0, 1, 1), "RRR": (2, (2,), 0, 2, 2), "RRP": (1, (1,), 1, 2, 1),
    "RPR": (2, (0, 1), 0, 2, 1), "RPP": (1, (0,), 1, 2, 0), "PRP": (0, (0,), 2, 2, 0),
}  # fmt: skip


def test_each_kind_takes_as_many_points_lengths_and_guides_as_its_links_have() -> None:
    found = {name: (one.points, one.lengths, one.guides, one.coordinates, one.angles) for name, one in GROUP_SHAPES.items()}
    assert found == COUNTS
    assert {kind.name: kind.shape for kind in GROUPS} == GROUP_SHAPES
    assert [name for name, one in GROUP_SHAPES.items() if one.driven] == ["crank"]
    assert {name: {*one.modes} for name, one in GROUP_SHAPES.items()} == {
        name: {1, -1} if name in {"RRR", "RRP", "RPR"} else set() for name in COUNTS
    }
