"""The section of forces: example 1 in row 4, the crank at 30 degrees, worked again from the lengths of its links."""

from __future__ import annotations

import cmath
import itertools
import math
import re
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.report.sections.effects import forces as section
from coursework.report.sections.effects.forces import (
    _clear,
    _convention,
    _math_of,
    _sizes,
    _text_of,
    _told,
    _without_noise,
)
from coursework.words.sentences import ranges
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, page_of, solved
from tests.report.reading import html_text
from tests.report.sections.verdict.test_conclusion import plain

ROW, SPEED, CRANK, COUPLER, ROCKER, FRAME = 4, 10.0, 0.4, 1.0, 0.7, 1.2
MASSES, INERTIAS = np.array([4.0, 10.0, 7.0]), np.array([0.0533, 0.833, 0.286])


def placed(theta: float) -> tuple[list[complex], list[float]]:
    """Return the middles of the links and C (m), and the angles of the links (rad): C is above the line from B to D."""
    b, d = CRANK * cmath.exp(1j * theta), FRAME + 0j
    way = d - b
    bend = math.acos((COUPLER**2 + abs(way) ** 2 - ROCKER**2) / (2 * COUPLER * abs(way)))
    c = b + COUPLER * way / abs(way) * cmath.exp(1j * bend)
    return [b / 2, (b + c) / 2, (c + d) / 2, c], [theta, cmath.phase(c - b), cmath.phase(c - d)]


def moved(theta: float, step: float = 1e-4) -> tuple[np.ndarray, ...]:
    """Return places, velocities, accelerations of the four points, and speeds and accelerations of the three angles."""
    before, here, after = (placed(theta + part * step) for part in (-1, 0, 1))
    found = []
    for kind in (0, 1):
        low, mid, high = (np.array(one[kind]) for one in (before, here, after))
        found += [mid, (high - low) / (2 * step) * SPEED, (high - 2 * mid + low) / step**2 * SPEED**2]
    return tuple(found[place] for place in (0, 1, 2, 4, 5))


def torque(theta: float) -> float:
    """Return what the crank must do (N m): the powers of all that acts and of inertia vanish with that of the drive."""
    _, v, a, w, e = moved(theta)
    power = np.sum(-MASSES * (a[:3] * v[:3].conj()).real - INERTIAS * e * w - MASSES * 9.81 * v[:3].imag)
    return float(-(power - 200 * v[3].real - 60 * w[2]) / SPEED)


def parts(name: str = "forces") -> Any:
    model = model_of(solved("example-1-forces"))
    return next(one for one in model.sections if one.name == name).parts


def table(head: str, name: str = "forces") -> list[list[str]]:
    """Return the rows of the first table one of whose heads is so."""
    one = next(part for part in parts(name) if part.kind == "table" and head in [plain(column.head) for column in part.columns])
    return [[plain(cell).replace("−", "-") for cell in row] for row in one.rows]


def told() -> str:
    return " ".join(plain(part.text) for part in parts() if part.kind == "paragraph").replace("−", "-")


def test_masses_centres_and_inertia_of_the_row() -> None:
    at, _, a, _, e = moved(math.radians(30))
    lines = table("J")
    assert [line[0] for line in lines] == ["1", "2", "3"]
    for place, line in enumerate(lines):
        force = -MASSES[place] * a[place]
        right = [MASSES[place], INERTIAS[place], at[place].real, at[place].imag, force.real, force.imag]
        assert [float(cell) for cell in line[1:7]] == pytest.approx(right, rel=6e-4)
        assert float(line[7]) == pytest.approx(-INERTIAS[place] * e[place], rel=6e-4, abs=1e-4)


def test_the_arms_of_the_lever_their_moments_and_what_couples_add() -> None:
    _, v, a, w, e = moved(math.radians(30))
    acting = {f"Fin{k + 1}": (-MASSES[k] * a[k], v[k]) for k in range(3)}
    acting |= {f"G{k + 1}": (-9.81j * MASSES[k], v[k]) for k in range(3)} | {"F1": (-200 + 0j, v[3])}
    lines = {line[0]: [float(cell) for cell in line[1:]] for line in table("moment")}
    assert {*lines} == {*acting}
    unit = next(moment / force / h for force, h, moment in lines.values() if h)
    for name, (force, h, moment) in lines.items():
        f, velocity = acting[name]
        assert force == pytest.approx(abs(f), rel=6e-4)
        arm = (velocity.conjugate() * f).real / abs(f) / SPEED  # m, of a unit of the drive
        assert abs(h - arm / unit) <= 0.26 and moment == pytest.approx(force * h * unit, rel=6e-4, abs=1e-9)
    couples = float(np.sum(-INERTIAS * e * w) - 60 * w[2]) / SPEED
    needed = -sum(moment for *_, moment in lines.values()) - couples
    assert f"Couples add {couples:.4g} N·m; with the drive, the total must vanish, so M = {needed:.4g}"[:-1] in told()


def test_what_is_read_stands_beside_what_was_computed() -> None:
    for name, unit, computed, mm, read, apart in table("read"):
        right, found = float(computed), float(read)
        assert float(apart) == pytest.approx(100 * (found - right) / right, abs=0.06)
        if mm != "–":
            assert unit == "N" and found == pytest.approx(10 * float(mm)) and abs(found - right) <= 2.6
        else:
            assert (name, unit) == ("M", "N·m") and right == pytest.approx(torque(math.radians(30)), rel=6e-4)


def test_the_rows_where_the_drive_brakes_and_the_energy_it_must_store() -> None:
    turn = [torque(math.radians(10 * k)) for k in range(37)]
    brakes = [k + 1 for k, one in enumerate(turn) if one < 0]
    spans = [list(group) for _, group in itertools.groupby(brakes, key=lambda row: row - brakes.index(row))]
    assert f"brakes in rows {', '.join(f'{one[0]}–{one[-1]}' for one in spans)}:" in told()
    work = np.cumsum([0.0, *((a + b) / 2 * math.radians(10) for a, b in itertools.pairwise(turn))])
    assert "mean over the period is 0 N·m" in told()
    assert f"excess of energy over that mean {np.ptp(work):.3g}" in told()


def test_energies_and_powers_under_words_and_what_is_nought_below() -> None:
    heads = [plain(column.head) for part in parts("energy") if part.kind == "table" for column in part.columns]
    assert heads == ["row", "t", "kinetic", "potential", "drive", "loads"]
    for line in table("kinetic", "energy")[:4]:
        theta = math.radians(10 * (int(line[0]) - 1))
        at, v, _, w, _ = moved(theta)
        kinetic = np.sum(MASSES * abs(v[:3]) ** 2 + INERTIAS * w**2) / 2
        right = [kinetic, np.sum(9.81 * MASSES * at[:3].imag), torque(theta) * SPEED, -200 * v[3].real - 60 * w[2]]
        assert [float(cell) for cell in line[2:]] == pytest.approx(right, abs=0.06)
    assert "0 in every row: friction and dampers." in [plain(part.text) for part in parts("energy") if part.kind == "paragraph"]


def test_tables_say_of_which_row_they_are_in_which_units_with_how_many_digits() -> None:
    tables = [part for part in parts() if part.kind == "table" and not getattr(part, "id", "").startswith("extra")]
    known, lever, compare, *_ = tables
    assert "row 4" in plain(known.caption) and "row 4" in plain(compare.caption)
    assert [(plain(one.head), plain(one.unit) if one.unit else "") for one in lever.columns] == [
        ("force", ""), ("F", "N"), ("h", "mm"), ("moment", "N·m"),
    ]  # fmt: skip
    assert [len(line[2].partition(".")[2]) for line in table("moment") if line[2] != "0"] == [1] * 3
    assert {(len(line[5].partition(".")[2]), len(line[3].partition(".")[2])) for line in table("read")} == {(2, 1), (2, 0)}
    assert [[one.words for one in part.columns] for part in (lever, compare)] == [[True] + [False] * 3, [True] * 2 + [False] * 4]
    assert "Links 2 and 3. Moments" in told() and "Link 1." in told()
    about = re.findall(r"gives (-?[\d.]+) N·m, so \S+ = \1 N·m / ([\d.]+) m = ([\d.]+) N", told())
    assert [length for _, length, _ in about] == ["1.000", "0.7000"]
    assert all(float(force) == pytest.approx(abs(float(moment)) / float(length), rel=1e-3) for moment, length, force in about)


def test_a_power_is_nought_where_it_is_the_round_off_of_those_that_work() -> None:
    rows = np.array([[0.0, 5.0, -7.0, 3.0, 0.9e-10, 1.1e-10], [1.0, 2.0, 4.0, -100.0, 0.0, 0.0]])
    assert _sizes(rows).tolist() == [5.0, 7.0, 100.0, 0.0, 1.1e-10]
    slow = np.array([[0.0, 1.0, 0.0, 1.9e-12], [0.5, 0.0, 0.0, 2.1e-12], [1.0, np.nan, 0.0, 0.0]])
    assert _sizes(slow).tolist() == [1.0, 0.0, 2.1e-12]  # energy falls by 2 W
    assert _sizes(slow[:, :4] * [1, 1, 1, 0.9]).tolist() == [1.0, 0.0, 0.0]
    rows[:, 2:] = 0.0
    assert _sizes(rows[:1]).tolist() == [5.0, 0.0, 0.0, 0.0, 0.0]


def test_components_that_are_only_round_off_are_none() -> None:
    assert _clear(1e3 + 0.9e-9j) == 1e3 and _clear(1e3 + 1.1e-9j) == 1e3 + 1.1e-9j
    assert _clear(-0.9e-12 - 1j) == -1j and _clear(-1.1e-12 - 1j) == -1.1e-12 - 1j
    rows = np.array([[0.9e-12, -1.0, 0.5], [1.1e-12, 1.0, np.nan], [np.nan] * 3])
    found = _without_noise(SimpleNamespace(reactions=SimpleNamespace(rows=rows)))
    assert np.array_equal(found, [[0.0, -1.0, 0.5], [1.1e-12, 1.0, np.nan], [np.nan] * 3], equal_nan=True)


def test_names_of_forces_as_text_and_in_equations() -> None:
    assert [_text_of(name) for name in ("R12t", "R03n", "R23", "Fin2", "Mt", "t")] == ["R₁₂ᵗ", "R₀₃ⁿ", "R₂₃", "Fin₂", "Mt", "t"]
    words = [
        (("R", "12", "ᵗ"), "known"),
        (("R", "03", "ⁿ"), "direction"),
        (("F", "in2", ""), "sought"),
        (("M", "", ""), "sought"),
    ]
    roles = {"known": section.KNOWN, "direction": section.DIRECTION}
    found = [_math_of(SimpleNamespace(word=word, role=roles.get(role, role))) for word, role in words]
    assert found == ['underline(underline(R_"12"^t))', 'underline(R_"03"^n)', 'F_"in2"', '"M"']


def test_rows_that_follow_each_other_are_a_span() -> None:
    assert ranges([1, 2, 3, 7, 9, 10], 6) == ("1–3", "7", "9–10") and ranges([4], 1) == ("4",) and ranges([], 0) == ()


class Words(dict[str, str]):
    """Sentences as their keys, with what is set into them."""

    def __call__(self, key: str, **values: Any) -> str:
        return " ".join((key.removeprefix("forces."), *map(str, values.values())))

    listing = staticmethod(",".join)
    sentences = staticmethod(list)


CONTEXT: Any = SimpleNamespace(
    words=Words(), lettered=lambda text: text, quantity=lambda value, unit, digits: f"{value:g} {unit}",
    numbers=SimpleNamespace(without_noise=lambda value, largest: value if abs(value) > 1e-9 * largest else 0.0),
    run=SimpleNamespace(variant=SimpleNamespace(time=SimpleNamespace(period=1.0))),
)  # fmt: skip


def conventions(names: str, rows: Any, pins: str = "", friction: str = "", condition: float = 2.0) -> list[str]:
    scheme = SimpleNamespace(unknowns=(), pins=dict.fromkeys(pins), forces=SimpleNamespace(friction=friction))
    rows = np.array(rows, dtype=float)
    reactions = SimpleNamespace(names=names.split(), rows=rows, condition=np.full(len(rows), condition))
    return list(_convention(CONTEXT, SimpleNamespace(reactions=reactions, rows=SimpleNamespace(scheme=scheme))))  # type: ignore[arg-type]


def test_what_is_said_before_the_forces() -> None:
    none = np.nan
    assert conventions("R12x R12y", [[1, 2]]) == ["convention"]
    for name in ("N1", "K1", "T1"):
        assert conventions(f"R12x {name}", [[1, 2]]) == ["convention", "guides"]
    assert conventions("R12x", [[1]], pins="AE") == ["convention", "pins A,E"]
    assert conventions("R1 R2", [[1, none]]) == ["convention", "blank"]
    assert conventions("R1 R2", [[none, none], [1, 2]]) == ["convention", "blank"]  # without friction nothing locks
    assert conventions("R1 R2", [[none, none], [1, 2]], friction="B") == ["convention", "locked"]
    assert conventions("R1 R2", [[none, none], [1, none]], friction="B") == ["convention", "locked", "blank"]
    assert conventions("R1 R2", [[none, none]], friction="B", condition=math.inf) == ["convention", "blank"]


@pytest.mark.parametrize(("power", "wheel", "found"), [
    ([1, 2, 3], None, ["drives"]), ([1, np.nan, 3], None, []), ([1, -0.9e-9, 1], None, ["drives"]),
    ([1, -1.1e-9, -1], None, ["brakes 2–3"]), ([np.nan, -1, 5], None, ["brakes 2"]), ([-5e-9, -9], None, ["brakes 2"]),
    ([1, 2, 3], (3.0, 4.0, None), ["drives", "mean 3 N·m 4 J"]),
    ([1, -2, 3], (4.5e-9, 4.0, 0.5), ["brakes 2", "mean 0 N·m 4 J", "flywheel 0.5 kg·m²"]),
])  # fmt: skip
def test_what_is_said_behind_them(monkeypatch: pytest.MonkeyPatch, power: Any, wheel: Any, found: list[str]) -> None:
    kept = None if wheel is None else SimpleNamespace(mean=wheel[0], excess=wheel[1], needed=wheel[2])
    monkeypatch.setattr(section, "find_flywheel", lambda found, period: kept if period == 1.0 else None)
    drive = SimpleNamespace(
        energy=SimpleNamespace(drive=np.array(power)), drive_names=["M"], column=lambda name: np.array([-5.0, 4.0])
    )
    said = _told(CONTEXT, drive)  # type: ignore[arg-type]
    assert [text for part in said for text in part.text] == found  # type: ignore[union-attr]


def test_moments_are_taken_about_the_pin_where_it_has_no_letter(real: ModuleType) -> None:
    """The ram's pin is no joint with a name: "Moments about , link 4"."""
    nameless = mechanism(
        "whitworth-forces", ('meets       = "F"\n', ""), ('rails  = [ { through = "F", angle = "0" } ]\n', ""),
        ('at = "F"', 'at = "(s5, -d)"'),
    )  # fmt: skip
    for text, pin in ((mechanism("whitworth-forces"), "F, link 4"), (nameless, "the pin of link 4")):
        run = coursework.solve(coursework.parse_variant(text), quantities=["table", "forces"])
        page = real.text_of(real.parts(run, "forces"))
        assert f"Moments about {pin}: what is known gives" in page and "about ," not in page


def test_a_drive_between_two_links_is_said_to_act_on_both() -> None:
    """The elbow of an arm is driven by a moment between upper arm and forearm, the shoulder from the frame."""
    run = coursework.solve(coursework.parse_variant(mechanism("arm-driven-at-its-joints")), quantities=["table", "forces"])
    page = html_text(page_of(model_of(run)))
    assert "Mw2, the drive, acts between two links: on link 2 as listed, on link 1 the other way round." in page
    assert page.count("acts between two links") == 1
