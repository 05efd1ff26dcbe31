"""Drawn data: by SHA-256 alone, the same for a student in every company, inside the ranges, in the digits of the ranges."""

import hashlib
import json
from collections import Counter
from functools import cache

import pytest

import coursework
from coursework.assigning.accept import Acceptance
from coursework.assigning.ranges import Lots
from coursework.assigning.variants import Assignment, load_ranges
from tests.mechanisms.library import mechanism

STUDENTS = [f"student-{number}" for number in range(12)]


@cache
def model():
    return coursework.compile_model("31")


@cache
def acceptance(seed="7"):
    template = model().variant
    return Acceptance(model(), Lots(template, load_ranges("31", template), seed))


def lots(ranges, seed="7"):
    template = model().variant
    return Lots(template, load_ranges(ranges, template), seed)


def test_a_draw_is_what_sha_256_says():
    """The bytes of one datum, put together here from their description."""
    ranges = {"given": {"r1": {"from": "0.82 m", "to": "1.08 m", "step": "0.001 m"}}}
    data = [
        [["r1", "0.953", "m"], ["r2", "0.847", "m"], ["r3", "0.457", "m"], ["V1", "4.5", "m/s"], ["p", "13.08", "1/s"],
         ["alpha", "4.35", "rad"]],
        [["phi1", "1.63", "rad"], ["phi2", "3.37", "rad"], ["phi3", "2.87", "rad"]],
        [0.02, 0.48, 2 * 3.141592653589793 / 13.08],
    ]  # fmt: skip
    digest = json.dumps([["given", "r1", 820, 1, 261, 3, "m"]])
    shared = json.dumps(["7", data, digest], ensure_ascii=False)
    lot = json.dumps(["Jörg", 3, "r1"], ensure_ascii=False)
    number = int.from_bytes(hashlib.sha256((shared + lot).encode()).digest(), "big")
    value = f"{(820 + number % 261) / 1000:.3f} m"
    assert lots(ranges).draw("Jörg", 3) == {("given", "r1"): value}
    assert lots(ranges).draw("Jo\u0308rg", 3) == {("given", "r1"): value}


@pytest.mark.parametrize("changed", ["seed", "id", "attempt", "ranges"])
def test_everything_that_should_changes_the_draw(changed):
    wide = {"given": {"r1": {"from": "0 m", "to": "1000 m", "step": "0.000001 m"}}}
    other = {"given": {"r1": {"from": "0 m", "to": "1000 m", "step": "0.000002 m"}}}
    usual = lots(wide).draw("ada", 0)
    assert usual == lots(wide).draw("ada", 0)
    drawn = {
        "seed": lots(wide, "8").draw("ada", 0), "id": lots(wide).draw("bert", 0), "attempt": lots(wide).draw("ada", 1),
        "ranges": lots(other).draw("ada", 0),
    }  # fmt: skip
    assert drawn[changed] != usual


def test_limits_and_the_order_of_lines_change_no_draw():
    r1, p = {"from": "0.82 m", "to": "1.08 m", "step": "0.001 m"}, {"choice": ["12.5 1/s", "13.08 1/s"]}
    usual = lots({"given": {"r1": r1, "p": p}}).draw("ada", 0)
    assert lots({"given": {"p": p, "r1": r1}, "limits": {"tries": 5}, "difficulty": {"band": 0.5}}).draw("ada", 0) == usual


def test_every_value_is_equally_likely():
    """Chi-square of 2600 draws over 26 values: 25 degrees of freedom, 99.9 % below 52.6."""
    few = lots({"given": {"r1": {"from": "0.8 m", "to": "1.05 m", "step": "0.01 m"}}})
    counts = Counter(next(iter(few.draw(f"s{number}", 0).values())) for number in range(2600))
    assert len(counts) == 26
    assert sum((count - 100) ** 2 / 100 for count in counts.values()) < 52.6


@pytest.mark.long
def test_a_student_gets_the_same_in_every_company_and_order():
    together = acceptance().accepted(STUDENTS)
    turned = acceptance().accepted([*reversed(STUDENTS), "added later"])
    assert {one.id: one for one in together} == {one.id: one for one in turned if one.id != "added later"}
    alone = coursework.draw("31", "31", 7, STUDENTS[3])
    assert coursework.draw_many("31", "31", "7", STUDENTS[2:5])[1].values == alone.values
    assert len({tuple(one.values.values()) for one in together}) == len(STUDENTS)


def test_data_are_inside_their_ranges_to_the_printed_digit():
    for one in acceptance().accepted(STUDENTS):
        r1 = one.values["given", "r1"]
        assert r1 == f"{float(r1[:-2]):.3f} m"
        assert 0.82 <= float(r1[:-2]) <= 1.08
        assert one.values["given", "p"] == f"{float(one.values['given', 'p'][:-4]):.2f} 1/s"
        assert 3 <= int(one.values["time", "check_row"]) <= 9


def test_what_is_not_listed_stays_and_what_is_drawn_loads():
    ranges = {"given": {"p": {"choice": ["12.7 1/s", "12.9 1/s"]}}, "difficulty": {"numbers": []}}
    variant = coursework.draw("31", ranges, 1, "ada")
    assert {**variant.values, "p": 13.08} == coursework.load("31").values
    assert variant.time.period == pytest.approx(2 * 3.141592653589793 / variant.values["p"], abs=1e-15)
    assert not variant.remarks
    assert coursework.feasible(variant) == (True, "")


@pytest.mark.parametrize(("template", "drawn"), [
    ("v104", '[given]\nr1 = { from = "0.96 m", to = "1.02 m", step = "0.001 m" }\n'),
    ("v104", '[given]\nr1 = { from = "0.96 m", to = "1.02 m", step = "0.001 m" }\n[start]\n'
     'phi1 = { from = "4.80 rad", to = "4.90 rad", step = "0.01 rad" }\n'),
    ("four-bar-with-relative-angles", '[given]\nr2 = { from = "0.38 m", to = "0.42 m", step = "0.001 m" }\n'),
    ("four-bar-by-squared-lengths", '[given]\nr3 = { from = "0.29 m", to = "0.31 m", step = "0.001 m" }\n'),
])  # fmt: skip
def test_loops_held_beside_the_equations_are_closed_for_everybody(template, drawn, tmp_path):
    """A drawn length opens the loops of the template: its start follows, but not a start that is drawn too."""
    file, ranges = tmp_path / "template.toml", tmp_path / "ranges.toml"
    file.write_text(mechanism(template), encoding="utf-8")
    ranges.write_text(drawn, encoding="utf-8")
    for student in ("ada", "bob", "eve"):
        variant = coursework.draw(file, ranges, 7, student)
        assert variant.values != coursework.load(file).values
        checks = {check.code: check for check in coursework.solve(variant, quantities=["table", "checks"]).checks}
        assert checks["START"].verdict == "PASS"
        if "[start]" in drawn:
            assert round(variant.coordinates[0].start, 9) == round(variant.coordinates[0].start, 2)


def test_more_starts_than_the_geometry_leaves_free_are_refused(tmp_path):
    """V104 has two freedoms: three drawn angles leave its loop open."""
    angles = {"phi1": ("4.82", "4.92"), "phi2": ("0.05", "0.12"), "phi3": ("4.6", "4.75")}
    lines = [f'{name} = {{ from = "{low} rad", to = "{high} rad", step = "0.01 rad" }}' for name, (low, high) in angles.items()]
    ranges = tmp_path / "ranges.toml"
    for count, closes in ((1, True), (3, False)):
        ranges.write_text("\n".join(["[start]", *lines[:count]]), encoding="utf-8")
        if closes:
            assert coursework.draw("v104", ranges, 3, "ada").values == coursework.load("v104").values
        else:
            with pytest.raises(coursework.InputError, match="did not close: more start values are drawn"):
                coursework.draw("v104", ranges, 3, "ada")


def test_of_a_mechanism_that_forces_move_no_variants_are_drawn():
    """The keys held the motion of a law that nobody gave."""
    template = coursework.load("falling-arm")
    ranges = load_ranges({"given": {"r1": {"from": "0.4 m", "to": "0.6 m", "step": "0.1 m"}}}, template)
    with pytest.raises(coursework.InputError, match=r"A032 .*falling-arm\.toml:\d\d  forces move this mechanism"):
        Assignment(template, ranges, "7")
