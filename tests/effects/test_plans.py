"""Forces on paper: polygons close, the moments are those of the reactions, a ruler reads what was computed; the page shows it."""

import re
from functools import cache

import numpy as np
import pytest

import coursework
from coursework.drawing.force_plans.force_plans import make_force_plans
from coursework.drawing.force_plans.group_sheet import LINK
from coursework.report.pages import build_model
from coursework.report.sections.effects.forces import _convention
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.scene.quantities import FORCES
from tests.effects.massed import of

NAMES = ["31", "example-1", "example-2", "example-4", "whitworth", "andrews"]


@cache
def plans(name):
    return make_force_plans(of(f"{name}-forces"), 3)


@pytest.mark.parametrize("name", NAMES)
def test_each_polygon_closes_in_every_row(name):
    found = plans(name)
    assert sum(len(plan.bodies) for plan in found.plans) == len(found.analysis.rows.scheme.bodies)
    for plan in found.plans:
        assert all("".join(vector.word).replace("ᵗ", "t").replace("ⁿ", "n") == vector.name for vector in plan.vectors)
        largest = max(np.abs(vector.force).max() for vector in plan.vectors)
        assert np.abs(sum(vector.force for vector in plan.vectors)).max() <= 1e-9 * largest
        for moment in plan.moments:
            assert np.abs(moment.about - moment.length * moment.across).max() <= 1e-9 * largest


def test_the_order_of_a_dyad_is_that_of_the_textbook():
    first, second = plans("example-1").plans
    assert [v.name for v in first.vectors] == ["R12t", "Fin2", "G2", "Fin3", "G3", "F1", "R03t", "R03n", "R12n"]
    assert [v.name for v in second.vectors] == ["R01", "Fin1", "G1", "R21"]
    assert [(m.body, m.point) for m in first.moments] == [("2", "C"), ("3", "C")]
    assert first.inner[0] == "R23" and second.inner is None
    # The chord is the reaction in the inner pin: what acts on link 2 ends where it begins but for that.
    on_2 = sum(v.force for v in first.vectors if v.body == "2")
    found = of("example-1-forces")
    assert np.abs(on_2 - (found.column("R23x") + 1j * found.column("R23y"))).max() < 1e-9


@pytest.mark.parametrize(("name", "number", "bars"), [("example-1", 0, 2), ("example-1", 1, 1)])
def test_the_links_of_a_group_are_drawn_with_the_forces_on_them(name, number, bars):
    """A dyad of two bars, and a crank: each as a line from point to point, heavier than any force."""
    drawing = plans(name).group_drawing(number, str)
    assert (drawing.id, drawing.svg.count(f"{LINK}/>")) == (f"forces-{number + 1}", bars)


@pytest.mark.parametrize("name", NAMES)
def test_a_ruler_reads_the_forces_to_half_a_millimetre(name):
    for one in plans(name).readings():
        assert abs(one.read - one.computed) <= 0.25 * one.unit * (1 + 1e-9), one.name
        assert one.mm <= 80


@pytest.mark.parametrize("name", ["31", "example-1", "example-2", "example-4", "whitworth"])
def test_the_lever_gives_the_drive(name):
    levers = plans(name).levers
    assert [lever.drive for lever in levers] == list(of(f"{name}-forces").drive_names)
    for lever in levers:
        arms = sum(abs(arm.force) * (np.conj(arm.image) * arm.force).imag / abs(arm.force) * lever.unit for arm in lever.arms)
        assert -arms - lever.couples == pytest.approx(lever.computed, rel=1e-9)
        assert lever.read == pytest.approx(lever.computed, rel=0.02)


@pytest.mark.long
def test_the_page():
    model = build_model(coursework.solve("example-1-forces"), "en", "", live=False)
    section = next(one for one in model.sections if one.name == "forces")
    kinds = [part.kind for part in section.parts]
    assert kinds.count("figure") == 3 and kinds.count("panels") == 2
    ids = [part.id for part in section.parts if part.kind in {"table", "figure", "panels"}]
    assert {"forces-known", "forces-compare", "forces-1", "forces-2", "lever-M"} <= set(ids)
    drawing = next(part for part in section.parts if part.kind == "figure")
    assert drawing.exact
    assert len(re.findall('data-plan="force"', drawing.svg)) == 2 * 9  # a line and a head for each side
    equation = next(part for part in section.parts if part.kind == "equations")
    assert equation.items[0].text == "R₁₂ᵗ + Fin₂ + G₂ + Fin₃ + G₃ + F₁ + R₀₃ᵗ + R₀₃ⁿ + R₁₂ⁿ = 0"
    assert equation.items[0].math.count("underline(underline(") == 5


def test_what_is_not_known_has_no_plans(tmp_path):
    from tests.effects.test_ways import PARALLEL

    run = coursework.solve(coursework.parse_variant(PARALLEL), quantities=["forces"])
    section = next(one for one in build_model(run, "en", "", live=False).sections if one.name == "forces")
    assert "figure" not in [part.kind for part in section.parts]
    assert make_force_plans(run.of(FORCES), 0).plans == ()


def test_polygons_are_listed_with_those_of_velocities():
    run = coursework.solve("example-1-forces", quantities=["forces", "plans"])
    from coursework.report.output.tables import run_tables

    text = dict(run_tables(run))["polygons.csv"].splitlines()
    assert text[0] == "row,t,motion,plan,kind,from,to,x,y,unit"
    kinds = {line.split(",")[3] for line in text[1:]}
    assert kinds == {"velocity", "acceleration", "force"}
    assert sum(",force,force," in line for line in text) == 37 * (9 + 4)
    times = {(int(row), float(t)) for row, t, *_ in (line.split(",") for line in text[1:])}
    assert sorted(times) == [(row + 1, pytest.approx(float(t), abs=1e-6)) for row, t in enumerate(run.motion.t)]


def test_the_pins_of_more_than_two_links_are_listed_in_words():
    run = coursework.solve("andrews-forces", scheme="euler", end=0.001)
    told = " ".join(_convention(PageContext(run, load_words("en")), run.results.forces))
    assert "links meet at E and A:" in told
