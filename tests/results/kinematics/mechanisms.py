"""Mechanisms that are in no file of the catalogue, with closed forms for their strokes and extremes."""

from __future__ import annotations

from tests.mechanisms.library import mechanism

# Crank 0.10 m, pivot of the lever 0.25 m below, lever 0.50 m, ram on a guide 0.48 m above the pivot, 120 rpm.
SHAPER = mechanism("shaper", ('"0 deg"', '"90 deg"'), step="2*pi/(100*n)")
# Two cranks of 0.1 m that turn against each other 0.6 m apart, and two links of 0.5 m: a mirror of itself.
TWO_CRANKS = mechanism(
    "five-bar", ('"30 deg"', '"0.3 rad"'), ('"120 deg"', '"2.841592653589793 rad"'), r1="0.1 m", r2="0.5 m", r3="0.5 m",
    r4="0.1 m", d="0.6 m", n1="10 rad/s", n4="10 rad/s", w4="-n4", step="2*pi/(40*n1)", end="2*pi/n1", period="2*pi/n1",
)  # fmt: skip
# A crank at constant speed, and a point that is driven up and down: two drives of two kinds.
FIVE_BAR = mechanism("crank-and-driven-point")


def slider_crank(e: float, start: float, drive: str, end: str = "2*pi/n") -> str:
    """Return a crank of 0.1 m and a rod of 0.5 m at n = 10 rad/s; the guide runs e (m) below the pivot of the crank."""
    return mechanism(
        "slider-crank", ('"0 deg"', f'"{start!r} rad"'), ('offset = "e"', 'offset = "-e"'), r="0.1 m", l="0.5 m", e=f"{e} m",
        n="10 rad/s", w1=drive, step="2*pi/(40*n)", end=end, period=None,
    )  # fmt: skip


def four_bar(a: float, b: float, c: float, d: float) -> str:
    """Return a crank, a coupler, a rocker or a second crank, and a frame of these lengths (m)."""
    return mechanism(
        "four-bar", ('"0 deg"', '"0.3 rad"'), ('mode = "+1"', 'mode = "-1"'), r1=f"{a} m", r2=f"{b} m", r3=f"{c} m", d=f"{d} m",
        n="10 rad/s", step="2*pi/(40*n)", period=None,
    )  # fmt: skip


ROCKER = four_bar(0.1, 0.35, 0.25, 0.4)
# A double crank: the follower goes round.
ROUND = four_bar(0.4, 0.35, 0.3, 0.1)
