"""A hand-made run of variant 31, so that the report is tested without the rooms below it.

Numbers: Euler by the coursework's own formulas, the exact motion by the closed form of numerics.md 1.1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import atan, cos, pi, sin
from typing import Any

import numpy as np

from coursework.checks.result import Finding
from coursework.checks.summary import summary
from coursework.formula.reader import parse, parse_equation
from coursework.formula.tree import Formula
from coursework.integration.motion import Motion, Stop
from coursework.schemes import DEFAULT_SCHEME, Scheme
from coursework.variant.record import Coordinate, Frame, Given, Law, Time, Variant

R1, R2, R3, V, P, ALPHA, H, STEPS = 0.953, 0.847, 0.457, 4.5, 13.08, 4.35, 0.02, 24
START = (1.63, 3.37, 2.87)
COORDINATES = ("phi1", "phi2", "phi3")
VELOCITIES = ("w1", "w2", "w3", "w4")


@dataclass(frozen=True)
class Equation:
    name: str
    because: str
    left: Formula
    right: Formula
    derived: bool = False
    used: bool = True


@dataclass(frozen=True)
class Block:
    unknowns: tuple[str, ...]
    equations: tuple[str, ...]
    solution: tuple[tuple[str, Formula], ...]
    determinant: Formula | None
    meaning: str


@dataclass(frozen=True)
class Reduction:
    blocks: tuple[Block, ...]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class ExtraTable:
    title: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: Any


@dataclass(frozen=True)
class StudyRow:
    method: str
    steps_or_tolerance: str
    evaluations: int
    max_error: float
    end_error: float
    seconds: float | None = None
    failed: str = ""


@dataclass(frozen=True)
class Study:
    rows: tuple[StudyRow, ...]
    orders: dict[str, float]
    own: tuple[str, int, float, float | None] | None
    floor: float
    reference_label: str
    budget: tuple[tuple[str, str, float, float, float, float], ...]
    sentences: tuple[str, ...]
    overhead: tuple[tuple[str, float], ...]
    seconds_shown: bool = True
    machine: dict[str, str] = field(
        default_factory=lambda: {"system": "Linux x86_64", "processors": "2", "python": "CPython 3.11"}
    )


@dataclass(frozen=True)
class Graph:
    svg: str
    rows: tuple[tuple[str, float, float, float, str], ...] = ()
    exact: tuple[tuple[str, float, float, str], ...] = ()
    notes: tuple[str, ...] = ()

    def drawn(self, written: Callable[[str], str], *, upright: bool = False) -> str:
        return self.svg


@dataclass(frozen=True)
class Settings:
    project: int = 0
    gain: float = 0.0


@dataclass(frozen=True)
class Run:
    variant: Variant
    motion: Motion
    equations: tuple[Equation, ...]
    reduction: Reduction
    scheme: str = "euler"
    scheme_title: str = "explicit Euler"
    tableau: Scheme = DEFAULT_SCHEME
    lesson: None = None
    step: float = H
    end: float = 0.48
    exact: Motion | None = None
    checks: tuple[Finding, ...] = ()
    stop: Stop | None = None
    phases: str = ""
    asked: tuple[str, ...] = ("table", "plots", "checks")
    extra_tables: dict[str, ExtraTable] = field(default_factory=dict)
    accuracy: Study | None = None
    versions: dict[str, str] = field(default_factory=lambda: {"coursework": "0.1.0", "numpy": "2.4.6"})
    student: str | None = None
    group: str | None = None
    date: str | None = None
    graph: Graph | None = None
    settings: Settings = field(default_factory=lambda: Settings())
    partials: dict[str, tuple[str, str]] = field(default_factory=dict)

    def asks(self, quantity: Any) -> bool:
        return quantity.name in self.asked

    def mechanism(self) -> None:
        return None

    def figures(self, written: Callable[[str], str]) -> dict[str, Any]:
        return {}

    @property
    def summary(self) -> str:
        return summary(self.checks) if "checks" in self.asked else ""

    @property
    def solutions(self) -> tuple[tuple[tuple[str, Formula], ...], ...]:
        return tuple(block.solution for block in self.reduction.blocks)


def velocities(t: float, q: Any) -> Any:
    p1, p2, p3 = q
    w3 = V * sin(P * t + ALPHA) / (R3 * (2 * cos(p3) + sin(p3)))
    w4 = 2 * w3 * cos(p3) - 4 * w3 * sin(p3)
    a = 0.5 * R3 * w4 - R3 * w3 * cos(p3)
    b = -R3 * w3 * sin(p3)
    det = R1 * R2 * sin(p2 - p1)
    w1 = (a * -R2 * cos(p2) - b * R2 * sin(p2)) / det
    w2 = (b * R1 * sin(p1) + a * R1 * cos(p1)) / det
    return np.array([w1, w2, w3, w4])


def euler(steps: int = STEPS, h: float = H) -> Motion:
    q = np.array(START)
    rows, rates = [], []
    for i in range(steps + 1):
        u = velocities(i * h, q)
        rows.append(q)
        rates.append(u)
        q = q + h * u[:3]
    return _motion(np.arange(steps + 1) * h, np.array(rows), np.array(rates), "euler", "explicit Euler")


def exact(steps: int = STEPS, h: float = H) -> Motion:
    t = np.arange(steps + 1) * h
    u0 = 2 * sin(START[2]) - cos(START[2])
    u = u0 + V / (P * R3) * (cos(ALPHA) - np.cos(P * t + ALPHA))
    p3 = pi + atan(0.5) - np.arcsin(u / 5**0.5)
    mx = R1 * cos(START[0]) + R2 * cos(START[1]) + 2 * R3 * cos(START[2])
    cy = R1 * sin(START[0]) + R2 * sin(START[1]) + R3 * sin(START[2] + pi / 2)
    bx, by = mx - 2 * R3 * np.cos(p3), cy - R3 * np.cos(p3)
    bend = np.arccos((bx**2 + by**2 - R1**2 - R2**2) / (2 * R1 * R2))
    p1 = np.arctan2(by, bx) - np.arctan2(R2 * np.sin(bend), R1 + R2 * np.cos(bend))
    p1 = p1 + 2 * pi * np.round((START[0] - p1[0]) / (2 * pi))
    q = np.stack([p1, p1 + bend, p3], axis=1)
    rates = np.array([velocities(ti, qi) for ti, qi in zip(t, q, strict=True)])
    return _motion(t, q, rates, "exact", "exact positions from the closure (Newton)")


def _motion(t: Any, q: Any, u: Any, scheme: str, label: str) -> Motion:
    bare = np.zeros((len(t), 3))
    return Motion(t, q, u, bare, bare.copy(), COORDINATES, VELOCITIES, scheme, H, len(t) - 1, label=label)


def variant(**changes: Any) -> Variant:
    given = (
        Given("r1", R1, "m", "0.953", "m"), Given("r2", R2, "m", "84.7", "cm"), Given("r3", R3, "m", "0.457", "m"),
        Given("V1", V, "m/s", "4.5", "m/s"), Given("p", P, "1/s", "13.08", "1/s"), Given("alpha", ALPHA, "rad", "4.35", "rad"),
    )  # fmt: skip
    made = Variant(
        name="31", path=None, title="Rolling wheel, right-angled link, crank and rod",
        source="B. B. Ponomarev, coursework guide, Irkutsk 1995, variant 31",
        teaches="a chain is solved from one end", remarks=("The phase is 4.35 rad.",), given=given,
        drive=(Law("VMx", parse("0")), Law("VMy", parse("V1*sin(p*t + alpha)"))),
        coordinates=tuple(
            Coordinate(name, rate, start, "rad", str(start), "rad")
            for name, rate, start in zip(COORDINATES, VELOCITIES, START, strict=False)
        ),
        unknowns=(("w4", "1/s"),), functions=(), time=Time(H, 0.48, 2 * pi / P, 4), constraints=(), groups=(), points=(),
        links=(), frame=Frame(), driven="M", holds=(), ask=("table", "plots", "checks"),
    )  # fmt: skip
    return replace(made, **changes)


EQUATIONS = tuple(
    Equation(name, because, *parse_equation(text))
    for name, because, text in (
        ("11", "C keeps its height: V_Cy = 0 along M-B-C", "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"),
        ("12", "the wheel rolls: V_Px = 0 along M-B-C-P", "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0"),
        (
            "16",
            "D is fixed: V_Dx = 0 along P-C-B-A-D",
            "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0",
        ),
        ("18", "D is fixed: V_Dy = 0 along C-B-A-D", "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0"),
    )
)
REDUCTION = Reduction(
    (
        Block(
            ("w3",), ("11",), (("w3", parse("VMy/(r3*(2*cos(phi3) + sin(phi3)))")),),
            parse("r3*(2*cos(phi3) + sin(phi3))"), "the lever arms of link 3 cancel",
        ),
        Block(("w4",), ("12",), (("w4", parse("2*w3*(cos(phi3) - 2*sin(phi3))")),), parse("0.5*r3"), "it is never zero"),
        Block(
            ("w1", "w2"), ("16", "18"),
            (
                ("w1", parse("-r3*(w3*cos(phi2 - phi3) - 0.5*w4*cos(phi2))/(r1*sin(phi1 - phi2))")),
                ("w2", parse("r3*(w3*cos(phi1 - phi3) - 0.5*w4*cos(phi1))/(r2*sin(phi1 - phi2))")),
            ),
            parse("r1*r2*sin(phi2 - phi1)"), "link 1 and link 2 lie on one line (stretched or folded)",
        ),
    ),
)  # fmt: skip
CHECKS = (
    Finding("PASS", "The velocities of row 1 satisfy every constraint equation.", 4.4e-16, 1e-12, "m/s", code="INITIAL"),
    Finding(
        "COARSE", "The last row does not return to the first with explicit Euler at this step.", 0.0833, 0.05, "of the scale",
        "phi1", 25, 1.63, 1.547, 0.001, (
            ("φ₁: scheme error", -0.083332, "rad"), ("φ₁: T ≠ period", 0.000579, "rad"), ("φ₁: round-off", 1e-16, "rad"),
        ), option="--step h/20", code="PERIOD-POSITION", group="motion",
    ),
    Finding("FAIL", "ω₃ jumps between row 7 and row 8 by 12.3 rad/s.", 12.3, 3.0, "rad/s", code="CONTINUITY", group="motion"),
    Finding("SKIP", "The drive is no sine.", code="SINUSOID", group="motion"),
    Finding("ERROR", "The closure could not be evaluated.", code="DRIFT", group="motion"),
)  # fmt: skip


def run(**changes: Any) -> Run:
    """Return the run of variant 31; any attribute may be replaced."""
    made = Run(variant(), euler(), EQUATIONS, REDUCTION, exact=exact(), checks=CHECKS)
    return replace(made, **changes)


def stopped() -> Run:
    """Return the run with alpha = 0.02 as far as row 6, with its stop."""
    motion = euler(5)
    stop = Stop(
        "dead point", 0.11688925461, 5.84, ("w3",), {"phi1": 2.181074659, "phi2": 3.450245165, "phi3": 2.034443936},
        "r3 (2 cos phi3 + sin phi3) becomes zero.",
        "V_My of 4.499 m/s is demanded where the links allow none: the drive is impossible from here on.",
    )  # fmt: skip
    return run(motion=motion, stop=stop, exact=None)


def study(seconds_shown: bool = True) -> Study:
    """Return an accuracy study with the figures of numerics.md 2.3."""
    rows = [
        *(StudyRow("Euler", str(n), n, e, e / 1.8, n * 1.4e-6) for n, e in
          ((24, 0.152), (48, 0.0819), (96, 0.0429), (384, 0.0112), (1536, 2.82e-3), (6144, 7.07e-4), (24576, 1.77e-4))),
        *(StudyRow("Heun", str(n // 2), n, e, e / 4, n * 1.35e-6) for n, e in
          ((48, 3.93e-3), (96, 7.73e-4), (192, 1.67e-4), (768, 9.22e-6), (3072, 5.73e-7), (49152, 2.24e-9))),
        *(StudyRow("RK4", str(n // 4), n, e, e / 6, n * 1.33e-6) for n, e in
          ((96, 1.07e-5), (192, 7.25e-7), (384, 4.73e-8), (768, 3.02e-9), (1536, 1.9e-10), (6144, 7.5e-13), (24576, 8.4e-15))),
        StudyRow("RK45 adaptive", "1e-5", 56, 4.4e-4, 2.2e-4, 1.1e-3),
        StudyRow("RK45 adaptive", "1e-9", 260, 3.3e-8, 1e-8, 4.4e-3),
        StudyRow("exact closure", "Newton", 175, 1.3e-15, 1e-15, 2e-4),
        StudyRow("Euler, 1 projection", "3", 6, float("nan"), float("nan"), None, "Newton did not come to rest at row 2"),
    ]  # fmt: skip
    return Study(
        tuple(rows), {"Euler": 0.98, "Heun": 2.04, "RK4": 3.99}, ("Euler", 24, 0.152, 35e-6), 1e-14,
        "the closed form, agreeing with the closure to 4e-16",
        (("phi1", "rad", -0.082754, -0.083332, 0.000579, 1e-16), ("phi2", "rad", -0.036865, -0.037128, 0.000263, 0.0),
         ("phi3", "rad", 0.046754, 0.048785, -0.002031, 2e-16)),
        ("24 steps of Euler: 8.7° off at worst, 35 µs.",
         "To be as good as 24 steps of RK4, Euler needs about 410 000 steps, 4000 times the time."),
        (("importing", 0.9), ("reading and reducing", 0.11), ("24 steps of Euler", 35e-6)), seconds_shown,
    )  # fmt: skip
