"""Which names a variant file declares, once each, and what an author may write for them.

Enters: the checked file.  Leaves: `Names`.  Used while a file is read.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from coursework.alphabet import foreign_letter, spell
from coursework.errors import Fault
from coursework.formula import FUNCTIONS
from coursework.variant.schema import VariantFile
from coursework.variant.source import Source

_SHAPE = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
_BUILT_IN = {"t", "pi"}


@dataclass(slots=True)
class Names:
    """`kinds` maps each declared name to given, drive, coordinate, rate, unknown, function or point."""

    kinds: dict[str, str] = field(default_factory=dict)
    declarations: list[tuple[str, str, tuple[str | int, ...]]] = field(default_factory=list)

    @classmethod
    def declared(cls, file: VariantFile) -> Names:
        """Collect the declarations of a file, in file order."""
        names = cls()
        for key in file.given:
            names._add(key, "given", ("given", key))
        for key in file.drive:
            names._add(key, "drive", ("drive", key))
        for key, entry in file.coordinates.items():
            names._add(key, "coordinate", ("coordinates", key))
            if spell(entry.rate) not in {spell(law) for law in file.drive}:
                names._add(entry.rate, "rate", ("coordinates", key, "rate"))
        for key in file.unknowns:
            names._add(key, "unknown", ("unknowns", key))
        for key in file.functions:
            names._add(key, "function", ("functions", key))
        for key in file.points:
            names._add(key, "point", ("points", key))
        for index, group in enumerate(file.group):
            if group.meets:
                names._add(group.meets, "point", ("group", index, "meets"))
        return names

    def _add(self, name: str, kind: str, path: tuple[str | int, ...]) -> None:
        self.declarations.append((name, kind, path))
        self.kinds.setdefault(spell(name), kind)

    @property
    def velocities(self) -> list[str]:
        """Return every name that may stand for a velocity."""
        return [name for name, kind in self.kinds.items() if kind in {"rate", "unknown", "drive"}]

    def canonical(self, name: str) -> str:
        """Return the declared name meant by `name` (Greek letters, omega3 for w3, phi_1 for phi1), or its spelling."""
        plain = spell(name)
        if plain in self.kinds or plain in _BUILT_IN:
            return plain
        for pattern, other in ((r"^w(?=\d|_|$)", "omega"), (r"^omega", "w"), (r"^fi(?=\d|_|$)", "phi"), (r"^ph?i", "phi")):
            candidate = re.sub(pattern, other, plain)
            for form in (candidate, candidate.replace("_", ""), plain.replace("_", "")):
                if form in self.kinds:
                    return form
        return plain

    def faults(self, source: Source) -> list[Fault]:
        """Return a fault for each name declared twice, reserved, or not spelt with Latin or Greek letters."""
        seen: dict[str, str] = {}
        found = []
        for name, kind, path in self.declarations:
            plain = spell(name)
            if strange := foreign_letter(name):
                found.append(source.fault(path, f'letter {strange[0] + 1} of "{name}" is the {strange[1]}, not a Latin one.'))
            elif not _SHAPE.match(plain):
                found.append(source.fault(path, f'"{name}" is no name: letters, digits and _ only, a letter first.'))
            elif plain in _BUILT_IN or plain in FUNCTIONS:
                found.append(source.fault(path, f'"{name}" has a meaning of its own in formulas; take another name.'))
            elif plain in seen:
                found.append(source.fault(path, f'"{name}" is declared twice: as {seen[plain]} and as {kind}.'))
            seen.setdefault(plain, kind)
        return found
