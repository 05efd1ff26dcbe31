"""The slider-crank with a crank of variable length: polynomial, exact law and table against independent numbers."""

import json
from pathlib import Path

import numpy as np
import pytest

import coursework

REFERENCE = json.loads((Path(__file__).parents[2] / "reference" / "pasika.json").read_text(encoding="utf-8"))


def exact(name: str, rows: int):
    variant = coursework.load(name)
    end = REFERENCE["interval_invariants"]["T_s"]
    step = variant.time.end / rows
    return coursework.exact(variant, step=step, end=variant.time.end, quantities=["table", "accelerations"]), end


def test_printed_polynomial():
    """Slider speed 0.6485 to 0.6654 m/s, not constant; acceleration 0.034 to 0.254 m/s²."""
    table, end = exact("variable-crank", 20)
    rows = [row["polynomial_13"] for row in REFERENCE["rows"]]
    assert table.index[-1] == pytest.approx(end, rel=1e-13)
    for column, key, sign in (("phi2", "phi2_rad", 1), ("s", "x_B", 1), ("u", "V_m_s", -1), ("w2", "omega2_rad_s", 1)):
        wanted = sign * np.array([row[key] for row in rows])
        assert np.max(np.abs(table[column].to_numpy() - wanted)) < 1e-12 * np.max(np.abs(wanted)), column
    for column, key, sign in (("du", "A_m_s2", -1), ("dw2", "eps2_rad_s2", 1)):
        wanted = sign * np.array([row[key] for row in rows])
        assert np.max(np.abs(table[column].to_numpy() - wanted)) < 1e-11, column


def test_exact_law_keeps_the_speed():
    table, _ = exact("variable-crank-exact", 20)
    assert np.max(np.abs(np.abs(table["u"]) - 0.647723)) < 1e-11
    assert np.max(np.abs(table["du"])) < 1e-6  # the law is ill-conditioned at its start: an error there grows 69 times


def test_table_with_five_point_formulas():
    """The 51-node table reproduces the printed program's own numbers: speed within 6.3e-6, acceleration within 0.0092."""
    table, _ = exact("variable-crank-table", 50)
    columns = REFERENCE["tabulated_51_nodes"]["columns"]
    rows = np.array(REFERENCE["tabulated_51_nodes"]["rows"], dtype=float)
    speed, acceleration = rows[:, columns.index("V_m_s")], rows[:, columns.index("A_m_s2")]
    assert np.max(np.abs(-table["u"].to_numpy() - speed)) < 1e-11
    assert np.max(np.abs(-table["du"].to_numpy() - acceleration)) < 1e-8
    assert np.max(np.abs(np.abs(table["u"]) - 0.647723)) == pytest.approx(6.26e-6, rel=0.01)


def test_invariants_of_the_exact_law():
    """a_k = k, b_k = 1, c_k = 0 for a slider of constant speed."""
    run = coursework.solve("variable-crank-exact", quantities=["invariants"])
    k, a, b, c = run.extra_tables["invariants"].rows.T
    assert np.max(np.abs(a - k)) < 1e-9
    assert np.max(np.abs(b - 1)) < 1e-9
    assert np.max(np.abs(c)) < 1e-4


def test_rounding_the_coefficients_breaks_the_speed_not_the_fit():
    """A least-squares polynomial in full precision keeps the speed to 5e-5 m/s; rounded to 4 decimals it loses a tenth."""
    stats = REFERENCE["stats"]
    text = (Path(coursework.load("variable-crank").path)).read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.startswith("r = "))
    from coursework.variant.reading.reader import parse_variant

    def speeds(key):
        coefficients = [repr(float(value)) for value in stats[key]["coefficients"]]
        formula = " + ".join(f"({value})*phi1^{power}" if power else value for power, value in enumerate(coefficients))
        variant = parse_variant(text.replace(line, f'r = "{formula}"'))
        return np.abs(coursework.exact(variant, quantities=["table"])["u"])

    full = speeds("own_degree6_least_squares_full_precision")
    assert full.max() - full.min() < 6e-5
    rounded = speeds("own_degree6_coefficients_rounded_to_4_decimals")
    assert rounded.min() == pytest.approx(0.5792, abs=2e-3)
