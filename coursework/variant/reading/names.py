"""The names that a variant file declares, each once, and the other spellings an author may use for them.

Enters: the checked file.  Leaves: `Names`.  Used while a file is read.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import field

from coursework.system.frozen import changing
from coursework.variant.formula.alphabet import foreign_letter, spell
from coursework.variant.formula.reader import FUNCTION_WORDS
from coursework.variant.formula.tree import Formula
from coursework.variant.reading.schema import VariantFile
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say

_SHAPE = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
_BUILT_IN = {"t", "pi"}
# Other spellings of the beginning of a name.
_ALIASES = (("omega", "w"), ("fi", "phi"), ("lambda", "lam"), ("epsilon", "eps"))


def _form(name: str) -> str:
    """Return the common form of the spellings of one name: omega_3 and w3, phi_1 and fi1."""
    for alias, usual in _ALIASES:
        name = re.sub(rf"^{alias}(?=\d|_|$)", usual, name)
    return re.sub(r"_(?=\d)", "", name)


@changing
class Names:
    """The declared names of a file.

    `kinds` maps each name to given, drive, coordinate, rate, unknown, function or point; `forms` maps a common form to names;
    `columns` are the velocities of the table with their paths.
    """

    kinds: dict[str, str] = field(default_factory=dict)
    forms: dict[str, list[str]] = field(default_factory=dict)
    declarations: list[tuple[str, str, KeyPath]] = field(default_factory=list)
    columns: list[tuple[str, KeyPath]] = field(default_factory=list)

    @classmethod
    def declared(cls, file: VariantFile) -> Names:
        """Return the declarations of a file, in file order."""
        names = cls()
        names._add_all(("given", "given", file.given), ("drive", "drive", file.drive))
        for key, entry in file.coordinates.items():
            names._add(key, "coordinate", ("coordinates", key))
            names.columns.append((entry.rate, ("coordinates", key, "rate")))
            if spell(entry.rate) not in {spell(law) for law in file.drive}:
                names._add(entry.rate, "rate", ("coordinates", key, "rate"))
        names.columns += [(key, ("unknowns", key)) for key in file.unknowns]
        names._add_all(
            ("unknowns", "unknown", file.unknowns), ("functions", "function", file.functions), ("points", "point", file.points)
        )
        for index, group in enumerate(file.group):
            if group.meets:
                names._add(group.meets, "point", ("group", index, "meets"))
        return names

    def _add_all(self, *sections: tuple[str, str, Iterable[str]]) -> None:
        for section, kind, keys in sections:
            for key in keys:
                self._add(key, kind, (section, key))

    def _add(self, name: str, kind: str, path: KeyPath) -> None:
        self.declarations.append((name, kind, path))
        plain = spell(name)
        if plain not in self.kinds:
            self.kinds[plain] = kind
            self.forms.setdefault(_form(plain), []).append(plain)

    @property
    def velocities(self) -> list[str]:
        """Return every name that may be a velocity."""
        return [name for name, kind in self.kinds.items() if kind in {"rate", "unknown", "drive"}]

    def meant(self, name: str) -> str:
        """Return what an undeclared name seems to mean: the rate of a coordinate or the velocity of a point; "" if neither."""
        of, rate = self._rate_meant(name)
        if rate:
            return say("hint.rate", of=of, name=rate)
        point, axis = name[1:-1], name[-1:]
        is_velocity = name[:1] == "V" and axis in {"x", "y"} and self.kinds.get(point) == "point"
        return say("hint.of_point", point=point, axis=axis) if is_velocity else ""

    def below_rate(self, part: Formula, whole: Formula) -> bool:
        """Return whether a part is the dt below a rate such as dphi1, which is told with its own name."""
        is_below = whole.op == "/" and part is whole.args[1] and part.name == "dt" and "dt" not in self.kinds
        return is_below and any(self._rate_meant(name)[1] for name in whole.args[0].names())

    def _rate_meant(self, name: str) -> tuple[str, str]:
        """Return the coordinate and the rate that are meant by dphi1 (as in "dphi1/dt") or phi1dot; "" for both if none is."""
        found = re.fullmatch(r"d_?(\w+?)(?:_?dt)?|(\w+?)_?dot", name)
        meant = self.canonical(found[1] or found[2]) if found else ""
        rates = {self.canonical(str(path[1])): self.canonical(rate) for rate, path in self.columns if path[0] == "coordinates"}
        if meant == "t":  # t is the denominator of dphi1/dt
            meant = next(iter(rates), "")
        return meant, rates.get(meant, "")

    def canonical(self, name: str) -> str:
        """Return the declared name that `name` means (Greek letters, omega3 for w3, phi_1 for phi1), or its plain spelling."""
        plain = spell(name)
        if plain in self.kinds or plain in _BUILT_IN:
            return plain
        alike = self.forms.get(_form(plain), [])
        return alike[0] if len(alike) == 1 else plain

    def faults(self, source: Source) -> list[Fault]:
        """Return a fault for each name declared twice, reserved, ill-formed, with foreign letters, or of an acceleration."""
        seen: dict[str, tuple[str, int]] = {}
        made = {f"d{self.canonical(velocity)}": (velocity, source.positions.find(path)[0]) for velocity, path in self.columns}
        found = []
        for name, kind, path in self.declarations:
            plain, text = spell(name), None
            if strange := foreign_letter(name):
                text = say("fault.V081", number=strange[0] + 1, name=name, strange=strange[1])
            elif not _SHAPE.match(plain):
                text = say("fault.V082", name=name)
            elif plain in _BUILT_IN or plain in FUNCTION_WORDS:
                text = say("fault.V083", name=name)
            elif plain in made and kind != "point":
                velocity, line = made[plain]
                text = say("fault.V084", name=name, velocity=velocity, line=line)
            elif plain in seen:
                first, line = seen[plain]
                known = {"name": name, "first": say(f"fault.kind.{first}"), "line": line, "kind": say(f"fault.kind.{kind}")}
                rate = next((rate for rate, place in self.columns if place[:-1] == path), "")
                a_law = (first, kind) == ("drive", "coordinate")  # a law of positions, where a law of velocities belongs
                text = say("fault.V161", rate=rate, name=name, line=line) if a_law else say("fault.V085", **known)
            found += [source.fault(path, text, at_key=kind != "rate")] if text else []
            seen.setdefault(plain, (kind, source.positions.find(path)[0]))
        return found
