"""Variant 31: its forms as in the coursework, its derivation against the geometry, a wrong sign found, more equations named."""

import re
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.equations.reduction.system import compile_system
from coursework.variant.formula.tree import evaluate, spelled
from coursework.variant.reading.reader import parse_variant

PAGE = (Path(__file__).parents[3] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
WRITTEN = PAGE[: PAGE.index("# --- geometry")]
SHOWN = {
    "w3": "VMy/(r3*(2*cos(phi3) + sin(phi3)))",
    "w4": "2*w3*(cos(phi3) - 2*sin(phi3))",
    "w1": "-r3*w3*sin(phi3)*(2*cos(phi2) + sin(phi2))/(r1*sin(phi1 - phi2))",
    "w2": "r3*w3*sin(phi3)*(2*cos(phi1) + sin(phi1))/(r2*sin(phi1 - phi2))",
}
TERMS = {
    "11": ["VMy", " - 2*r3*w3*cos(phi3)", " - r3*w3*sin(phi3)"],
    "12": ["2*r3*w3*sin(phi3)", " - r3*w3*cos(phi3)", " + 0.5*r3*w4"],
    "16": ["-0.5*r3*w4", " + r3*w3*cos(phi3)", " + r2*w2*sin(phi2)", " + r1*w1*sin(phi1)"],
    "18": ["r3*w3*sin(phi3)", " - r2*w2*cos(phi2)", " - r1*w1*cos(phi1)"],
}
# The equations of mathematics.md section 3 beyond the four that are used, and what each repeats.
MORE = {
    "13": ("VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0", "11"),
    "14": ("2*r3*w3*sin(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0", "12 and 16 together"),
    "15": ("VMy - 2*r3*w3*cos(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0", "11 and 18 together"),
    "17": ("r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0", "18"),
}


def solved(text, **options):
    return coursework.solve(parse_variant(text, "v.toml"), quantities=["table"], **options)


def with_more(*names, text=WRITTEN, before=False):
    added = "".join(f'\n[[constraint]]\nname = "{name}"\nequation = "{MORE[name][0]}"\n' for name in names)
    return text.replace("\n[[constraint]]", added + "\n[[constraint]]", 1) if before else text + added


@pytest.fixture(scope="module")
def run():
    return solved(PAGE)


def points(run, count=25):
    """Return names with values: times, positions, and velocities from the full system of equations."""
    generator = np.random.default_rng(31)
    equations = run.scene.equations
    system = compile_system(equations, equations.equations)
    drive = run.variant.drive[1].formula
    for _ in range(count):
        t, q = generator.uniform(0, 0.48), generator.uniform(-3, 3, 3)
        matrix, right, _ = system.matrix(t, q.tolist())
        if abs(np.linalg.det(matrix)) < 1e-3:
            continue
        values = {**run.variant.values, "t": t, **dict(zip(("phi1", "phi2", "phi3"), q.tolist(), strict=True))}
        values["VMy"] = evaluate(drive, values)
        yield values | dict(zip(equations.unknowns, np.linalg.solve(matrix, right).tolist(), strict=True))


def test_shown_as_in_the_coursework(run):
    assert {name: spelled(formula) for block in run.solutions for name, formula in block} == SHOWN


def test_solved_from_one_end(run):
    assert [block.unknowns for block in run.reduction.blocks] == [("w3",), ("w4",), ("w1", "w2")]
    assert [block.equations for block in run.reduction.blocks] == [("11",), ("12",), ("16", "18")]
    assert [spelled(block.determinant) for block in run.reduction.blocks] == [
        "-r3*(2*cos(phi3) + sin(phi3))",
        "r3/2",
        "-r2*r1*sin(phi1 - phi2)",
    ]
    assert run.reduction.blocks[1].meaning == "it is never zero"
    assert run.reduction.blocks[2].meaning == "link 1 and link 2 lie on one line (stretched or folded)"


def test_what_is_shown_is_the_solution_of_the_equations(run):
    seen = 0
    for values in points(run):
        for block in run.solutions:
            for name, formula in block:
                assert evaluate(formula, values) == pytest.approx(values[name], rel=1e-10, abs=1e-10)
                seen += 1
    assert seen > 60


def test_what_is_computed_is_the_solution_of_the_equations(run):
    rates = run.scene.rates
    for values in points(run):
        found = rates.evaluate(values["t"], values["phi1"], values["phi2"], values["phi3"])
        assert found[:4] == pytest.approx([values[name] for name in ("w1", "w2", "w3", "w4")], rel=1e-10, abs=1e-10)


def test_the_geometry_alone_gives_the_same_velocities(run):
    """[points] and [closure] without a written equation: the tool differentiates M and C.y itself."""
    start, end = PAGE.index("[[constraint]]"), PAGE.index("# --- geometry")
    bare = (PAGE[:start] + PAGE[end:]).replace('w4 = "1/s"', "").replace(', rate = "w4" }', " }")
    derived = solved(bare)
    assert derived.scene.equations.unknowns == ("w1", "w2", "w3")
    assert all(equation.written is None for equation in derived.scene.equations.equations)
    for values in points(run):
        found = derived.scene.rates.evaluate(values["t"], values["phi1"], values["phi2"], values["phi3"])
        assert found[:3] == pytest.approx([values[name] for name in ("w1", "w2", "w3")], rel=1e-9, abs=1e-9)
    assert derived.motion.rows == pytest.approx(run.motion.rows[:, :6], rel=1e-11, abs=1e-11)


def turned(term):
    """Return a term with the other sign."""
    if term.startswith(" "):
        return term.replace(" + ", " - ") if " + " in term else term.replace(" - ", " + ")
    return term[1:] if term.startswith("-") else f"-{term}"


@pytest.mark.parametrize(("name", "place"), [(name, place) for name, terms in TERMS.items() for place in range(len(terms))])
def test_a_wrong_sign_is_refused_by_name(name, place):
    """The wheel's w4 is known to the geometry as well: it rolls on its rail."""
    right = "".join(TERMS[name])
    wrong = "".join(turned(term) if index == place else term for index, term in enumerate(TERMS[name]))
    assert PAGE.count(f'"{right} = 0"') == 1
    with pytest.raises(coursework.InputError) as caught:
        solved(PAGE.replace(right, wrong)).columns()
    assert re.search(
        rf"^V302 v\.toml:\d+  equation {name} contradicts the geometry of \[points\] and \[closure\]", str(caught.value)
    )


@pytest.mark.parametrize("factor", ["-", "2*", "(1 + sin(phi1)^2)*"])
def test_an_equation_may_be_multiplied(factor, run):
    left = "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3)"
    text = PAGE.replace(f'"{left} = 0"', f'"{factor}({left}) = 0"')
    assert solved(text).motion.rows == pytest.approx(run.motion.rows, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("text", [WRITTEN, PAGE], ids=["written", "geometry"])
def test_redundant_equations_are_named_and_not_used(text, run):
    more = solved(with_more(*MORE, text=text))
    assert more.reduction.used == ("11", "12", "16", "18")
    assert more.reduction.unused == tuple(MORE)
    assert {one.name: one.used for one in more.equations} == dict.fromkeys(more.reduction.used, True) | dict.fromkeys(MORE, False)
    assert more.reduction.notes == tuple(
        f"Equation {name} says the same as {same}; it is not needed and only checked." for name, (_, same) in MORE.items()
    )
    assert np.array_equal(more.motion.rows, run.motion.rows)


def test_the_author_order_decides_which_are_used():
    first = solved(with_more("13", "17", before=True))
    assert first.reduction.used == ("13", "17", "12", "16")
    assert first.reduction.notes == (
        "Equation 11 says the same as 13; it is not needed and only checked.",
        "Equation 18 says the same as 17; it is not needed and only checked.",
    )


def test_a_contradiction_among_them_is_refused():
    text = with_more("14").replace(MORE["14"][0], MORE["14"][0].replace("= 0", "= 1"))
    with pytest.raises(coursework.InputError) as caught:
        solved(text).columns()
    assert "Equation 14 contradicts equations 12 and 16 together" in str(caught.value)
