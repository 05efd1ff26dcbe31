"""What the page says of a step is what its rows were made by, where laws drive the mechanism and where forces do."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

import coursework
from tests.mechanisms.library import mechanism
from tests.solved import solved


def lines(real: ModuleType, run: Any) -> dict[str, tuple[str, str]]:
    """Return of each column on the left of a step: the step in letters, and in numbers."""
    texts = [one["text"] for part in real.parts(run, "solution") if part["kind"] == "equations" for one in part["items"]]
    letters = {text.partition("(")[0]: text for text in texts if " + 1) = " in text}
    return {name: (text, next(one for one in texts if one.startswith(f"{name}(1) = "))) for name, text in letters.items()}


def in_numbers(text: str) -> tuple[float, float, float, float]:
    """Return start, slope, step and result of "x(1) = a + b · h = c"."""
    _, made, result = text.replace("−", "-").split(" = ")
    start, _, product = made.partition(" + ")
    slope, step = product.replace("(", "").replace(")", "").split(" · ")
    return float(start), float(slope), float(step), float(result)


@pytest.mark.parametrize(("scheme", "at"), [("euler", "i"), ("semi-implicit", "i + 1")])
def test_under_forces_the_free_coordinates_and_their_rates_alone_are_stepped(real: ModuleType, scheme: str, at: str) -> None:
    """θ₂ and s₃ were said to go along their rates, and follow from the closed position."""
    run = coursework.solve("example-2-motor", quantities=["table"], scheme=scheme)
    told = lines(real, run)
    assert {name: text for name, (text, _) in told.items()} == {
        "θ₁": f"θ₁(i + 1) = θ₁(i) + ω₁({at}) h", "ω₁": "ω₁(i + 1) = ω₁(i) + ω̇₁(i) h",
    }  # fmt: skip
    for name, column in (("θ₁", "theta1"), ("ω₁", "w1")):
        start, slope, step, result = in_numbers(told[name][1])
        rows = run.motion.column(column)
        assert (start, round(start + slope * step, 5)) == (rows[0], result) and abs(rows[1] - result) <= 5e-6
    words = " ".join(real.text_of(part["text"]) for part in real.parts(run, "method") if part["kind"] == "paragraph")
    assert "velocities of each row follow from the coordinates" not in words and "from its closed position" in words
    assert "θ₂" not in words and "θ2" not in words and "Evaluations of the accelerations: 200." in words


def test_letters_of_a_scheme_are_the_free_coordinates_and_their_rates(real: ModuleType) -> None:
    """With Runge-Kutta 4 q was said to be all coordinates and f their rates."""
    page = real.text_of(real.parts(solved("example-2-motor", scheme="rk4", quantities=["table"]), "solution"))
    assert "The scheme, Runge-Kutta 4, with q for θ1 and ω1 and f for their derivatives ω1 and ω̇1;" in page


def test_where_all_coordinates_are_free_no_other_is_spoken_of(real: ModuleType) -> None:
    run = solved("falling-arm", quantities=["table", "dynamics"])
    pages = [real.text_of(real.parts(run, section)) for section in ("solution", "method", "dynamics")]
    assert not [page for page in pages if "other coordinates" in page or "closed position" in page]
    assert "M is the inertia matrix" in pages[-1]


@pytest.mark.parametrize(("way", "told"), [({"project": 1}, "one Newton correction"), ({"gain": 5.0}, "Baumgarte’s term")])
def test_what_draws_the_drift_back_stands_beside_the_step(real: ModuleType, way: dict[str, Any], told: str) -> None:
    """φ₁(k + 1) = φ₁(k) + ω₁(k) h alone does not make the rows of such a table."""
    run = solved("31", scheme="euler", quantities=["table"], **way)
    assert all(told in real.text_of(real.parts(run, section)) for section in ("statement", "solution", "method"))
    assert told not in real.text_of(real.parts(solved("31", quantities=["table"]), "solution"))


def test_the_slope_of_a_rate_is_that_of_two_rods_let_go(real: ModuleType) -> None:
    """Lagrange's equations of the arm at rest, written down for its two uniform rods."""
    told = lines(real, coursework.solve("falling-arm", quantities=["table"]))
    (r1, m1, a), (r2, m2, b) = (0.5, 3.0, 1.6), (0.4, 2.0, 0.2)
    beside = m2 * r1 * r2 / 2 * np.cos(a - b)
    inertia = [[(m1 / 3 + m2) * r1**2, beside], [beside, m2 / 3 * r2**2]]
    weight = [-9.81 * (m1 / 2 + m2) * r1 * np.cos(a), -9.81 * m2 / 2 * r2 * np.cos(b)]
    slopes = [in_numbers(told[name][1])[1] for name in ("ω₁", "ω₂")]
    np.testing.assert_allclose(slopes, np.linalg.solve(inertia, weight), rtol=1e-5)


def test_of_a_driven_mechanism_every_coordinate_goes_along_its_rate(real: ModuleType) -> None:
    run = coursework.solve("31", quantities=["table"])
    told = lines(real, run)
    assert [text for text, _ in told.values()] == [f"φ{low}(k + 1) = φ{low}(k) + ω{low}(k) h" for low in "₁₂₃"]
    for name, (_, numbers) in zip(("phi1", "phi2", "phi3"), told.values(), strict=True):
        start, slope, step, result = in_numbers(numbers)
        assert round(start + slope * step, 5) == result and abs(run.motion.column(name)[1] - result) <= 5e-6


def test_the_box_and_the_first_and_last_row_tell_a_rate_that_forces_make(real: ModuleType) -> None:
    """ω₁ of a crank under a motor is what was sought, and was left out as if it were given."""
    run = coursework.solve("example-2-motor", quantities=["table", "checks"])
    box = next(part for part in real.parts(run, "statement") if part["kind"] == "result")
    assert any("ω1 = 2.5498 rad/s" in real.text_of(line).replace("\xa0", " ") for line in box["items"])
    table = next(part for part in real.parts(run, "results") if part.get("id") == "first-last")
    assert [real.text_of(column["head"]) for column in table["columns"]] == ["", "θ1", "θ2", "s3", "ω1", "ω2", "u3"]


def test_the_step_of_eight_coordinates_is_written_out_and_the_others_are_named(real: ModuleType) -> None:
    """The ninth was left out without a word."""
    run = coursework.solve(coursework.parse_variant(mechanism("ten-wheels")), quantities=["table"])
    assert list(lines(real, run)) == [f"φ{index}" for index in "₁₂₃₄₅₆₇₈"]
    assert "Likewise φ9 and φ10." in real.text_of(real.parts(run, "solution"))
    assert "Likewise" not in real.text_of(real.parts(solved("31"), "solution"))
