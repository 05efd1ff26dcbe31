"""Units that contain a mass: of forces, torques, inertias, stiffnesses; used only for files with masses or forces.

Enters: nothing.  Leaves: `UNITS` and `KINDS`, in the same form as in `motion_units.py`.
Used by `units.py` and `exponents.py`, which import it when they need such a unit.
"""

from __future__ import annotations

from fractions import Fraction

# SI unit -> (length, time, mass) exponents, and the units that advice shows, the SI unit first.  If two units have the same
# exponents, the usual one comes first: a moment is written in N*m, an energy in J.
KINDS: dict[str, tuple[tuple[int, int, int], str]] = {
    "kg": ((0, 0, 1), "kg, g, t"),
    "N": ((1, -2, 1), "N, kN"),
    "N*m": ((2, -2, 1), "N*m, kN*m"),
    "J": ((2, -2, 1), "J, kJ"),
    "kg*m^2": ((2, 0, 1), "kg*m^2, g*cm^2"),
    "kg/m": ((-1, 0, 1), "kg/m, N*s^2/m^2"),  # a resistance quadratic in the speed
    "N/m": ((0, -2, 1), "N/m, N/mm"),
    "N*s/m": ((0, -1, 1), "N*s/m"),
    "N*m*s": ((2, -1, 1), "N*m*s"),
    "W": ((2, -3, 1), "W, kW"),
    "Pa": ((-1, -2, 1), "Pa, MPa"),
    "m^2": ((2, 0, 0), "m^2, cm^2, mm^2"),
}
_LATIN = ("kg", "g", "t", "N", "kN", "m", "cm", "mm", "s", "W", "kW", "J", "kJ", "Pa", "kPa", "MPa")
_CYRILLIC = ("кг", "г", "т", "Н", "кН", "м", "см", "мм", "с", "Вт", "кВт", "Дж", "кДж", "Па", "кПа", "МПа")
REFUSED = {
    "kgf": (Fraction("9.80665"), "N"), "kp": (Fraction("9.80665"), "N"), "кгс": (Fraction("9.80665"), "Н"),
    "lb": (Fraction("0.45359237"), "kg"), "lbf": (Fraction("4.4482216152605"), "N"),
    "kgf*m": (Fraction("9.80665"), "N*m"), "кгс*м": (Fraction("9.80665"), "Н*м"),
}  # fmt: skip
PARTS = frozenset((*_LATIN, *_CYRILLIC, *REFUSED))  # of which a unit is made


def _all_units() -> dict[str, tuple[Fraction, str]]:
    found: dict[str, tuple[Fraction, str]] = {}
    for letters in (_LATIN, _CYRILLIC):
        kg, g, t, n, kn, m, cm, mm, s, w, kw, j, kj, pa, kpa, mpa = letters
        masses = {kg: Fraction(1), g: Fraction(1, 1000), t: Fraction(1000)}
        forces = {n: Fraction(1), kn: Fraction(1000)}
        lengths = {m: Fraction(1), cm: Fraction(1, 100), mm: Fraction(1, 1000)}
        found |= {unit: (size, "kg") for unit, size in masses.items()}
        found |= {unit: (size, "N") for unit, size in forces.items()}
        found |= {w: (Fraction(1), "W"), kw: (Fraction(1000), "W"), j: (Fraction(1), "J"), kj: (Fraction(1000), "J")}
        found |= {pa: (Fraction(1), "Pa"), kpa: (Fraction(1000), "Pa"), mpa: (Fraction(10**6), "Pa")}
        for unit, size in lengths.items():
            found |= {f"{mass}*{unit}^2": (own * size**2, "kg*m^2") for mass, own in masses.items()}
            found |= {f"{mass}/{unit}": (own / size, "kg/m") for mass, own in masses.items()}
            found |= {f"{force}*{unit}": (own * size, "N*m") for force, own in forces.items()}
            found |= {f"{force}/{unit}": (own / size, "N/m") for force, own in forces.items()}
            found |= {f"{force}*{s}/{unit}": (own / size, "N*s/m") for force, own in forces.items()}
            found |= {f"{force}*{unit}*{s}": (own * size, "N*m*s") for force, own in forces.items()}
            found |= {f"{force}*{s}^2/{unit}^2": (own / size**2, "kg/m") for force, own in forces.items()}
            found |= {f"{force}*{unit}*{s}^2": (own * size, "kg*m^2") for force, own in forces.items()}
            found[f"{unit}^2"] = (size**2, "m^2")
    return found


UNITS = _all_units()
LATIN_OF = dict(zip(_CYRILLIC, _LATIN, strict=True))
WITHOUT_SIGN = {unit.replace("*", ""): unit for unit in UNITS if "*" in unit}
