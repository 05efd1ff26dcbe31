"""What the listings of all languages have in common: names, comments numbered as in the block diagram, lines block by block.

Enters: a `Program`, a syntax, the words of the comments.  Leaves: lines.  Used inside `listing/`.
"""

from __future__ import annotations

from collections.abc import Iterable

from coursework.equations.codegen.straight_line import Line
from coursework.motion.schemes import SEMI_IMPLICIT, Sum, share
from coursework.report.text.words import Words
from coursework.takeaway.listing.program import Box, Program
from coursework.takeaway.listing.syntax import Names, Syntax, expression, filled, parts
from coursework.words.templates import clean

WIDEST = 100  # letters of a line; a longer one is continued in the next


class Writer:
    """The parts of a listing, which differ between languages only in syntax."""

    def __init__(self, program: Program, syntax: Syntax, words: Words) -> None:
        self.program, self.syntax, self.words = program, syntax, words
        self.names = Names(syntax, program.declared)
        for datum in (*program.data, *program.start):
            _ = self.names[datum.name]
        for name in program.velocities:
            _ = self.names[name]
        own = self.names.own
        self.t, self.h, self.row = self.names["t"], own("_step", "h", "step"), own("_row", "i", "k", "row")
        self.rates, self.steps = own("_rates", "rates", "velocities"), own("_steps", "n", "steps")
        self.gauss, self.look = own("_gauss", "gauss"), own("_look", "before_break")
        self.count = own("_count", "j", "turn")
        self.tables = [name for name in sorted(program.calls) if name.startswith("_table_")]
        lines = (line for block in program.blocks for line in block.lines)
        self.largest = max((len(line.targets) - 1 for line in lines if "_solve" in line.text), default=0)  # by elimination

    @property
    def coordinates(self) -> list[str]:
        """Return the names of the coordinates and, under forces, of the free rates."""
        return [self.names[name] for name in self.program.coordinates]

    def slope(self, stage: int) -> str:
        """Return the name of a slope of the step."""
        return self.names.own(f"_k{stage}", f"u{stage + 1}", f"slope{stage + 1}")

    def out(self, stage: int, rate: str) -> str:
        """Return the name of a velocity in a slope of the step; in the first slope it is the plain name."""
        if "out" in self.syntax.texts:
            return filled(self.syntax.texts["out"], slope=self.slope(stage), rate=rate)
        return self.names.own(f"_{rate}_{stage}", f"{rate}_{stage + 1}") if stage else rate

    def shown(self) -> list[str]:
        """Return the names printed beside the time."""
        states = self.program.coordinates
        return [self.names[one] if one in states else self.out(0, self.names[one]) for one in self.program.shown]

    def closed(self) -> list[str]:
        """Return the assignments that replace coordinates by their closed values."""
        return [self.sets(self.names[name], self.out(0, self.names[after])) for name, after in self.program.closed]

    @property
    def velocities(self) -> list[str]:
        """Return the names of the velocities."""
        return [self.names[name] for name in self.program.velocities]

    @property
    def data(self) -> list[str]:
        """Return the names at the top of the listing: data, and values that follow from the data alone."""
        return [self.names[name] for name in (*(one.name for one in self.program.data), *self.targets(self.program.known))]

    def targets(self, lines: Iterable[Line]) -> list[str]:
        """Return the private names that lines assign."""
        return [name for line in lines for name in line.targets]

    @property
    def locals(self) -> list[str]:
        """Return the names of other values that are computed inside the velocities."""
        found = self.targets(line for block in self.program.blocks for line in block.lines)
        taken = (*self.program.velocities, *self.program.coordinates)
        return [self.names[name] for name in dict.fromkeys(found) if name not in taken]

    def comment(self, text: str) -> str:
        """Return a comment line; no text from a file can end it or begin another one."""
        return f"{self.syntax.comment}{clean(text)}".replace("\\", "/")

    def box(self, key: str) -> str:
        """Return the comment of a box of the main program."""
        return self.of(self.program.boxes[key])

    def of(self, box: Box) -> str:
        """Return the comment of a box."""
        return self.comment(f"{box.number}  {box.text}")

    def say(self, key: str, **values: object) -> str:
        """Return a comment of a key in the words of the page."""
        return self.comment(self.words(f"listing.{key}", **values))

    def head(self) -> list[str]:
        """Return the first lines: the title and the scheme."""
        beside = [self.say("beside_exact")] if self.program.beside_exact else []
        return [self.comment(self.program.title), self.say("scheme", title=self.program.scheme_title), *beside]

    def sets(self, name: str, value: str) -> str:
        """Return an assignment."""
        return f"{name}{self.syntax.assign}{value}{self.syntax.end}"

    def assigned(self, line: Line) -> list[str]:
        """Return an assignment of the straight-line code in the language."""
        value = line.value
        if value.startswith("_solve("):
            return self.solved(line, parts(value, self.syntax, self.names))
        return self.wrapped(self.sets(self.names[line.targets[0]], expression(value, self.syntax, self.names)))

    def solved(self, line: Line, entries: list[str]) -> list[str]:
        """Return the lines that solve a block by elimination; `entries` are the matrix row by row, then the right side."""
        syntax, found, size = self.syntax, [self.names[name] for name in line.targets], len(line.targets) - 1
        rows = [[*entries[row * size : (row + 1) * size], entries[size * size + row]] for row in range(size)]
        if syntax.unpacks:
            listed = ", ".join(f"[{', '.join(row)}]" for row in rows)
            return self.wrapped(f"{filled(syntax.unpacks, names=', '.join(found))}{self.gauss}([{listed}]){syntax.end}")
        work = self.names.own("_work", "work")
        if syntax.divides:
            matrix = self.wrapped(f"{work} = [{'; '.join(', '.join(f'({one})' for one in row) for row in rows)}];")
            return [
                *matrix,
                f"{found[size]} = det({work}(:, 1:{size}));",
                f"{work} = {work}(:, 1:{size}) \\ {work}(:, {size + 1});",
                *(f"{one} = {work}({place});" for place, one in enumerate(found[:size], 1)),
            ]
        cells = [(row, column, value) for row, values in enumerate(rows) for column, value in enumerate(values)]
        cells_set = [line for row, column, value in cells for line in self.wrapped(self.sets(f"{work}[{row}][{column}]", value))]
        read = [self.sets(one, f"{work}[{place}][{size}]") for place, one in enumerate(found[:size])]
        return [*cells_set, self.sets(found[size], f"{self.gauss}({size})"), *read]

    def wrapped(self, line: str) -> list[str]:
        """Return a line, broken into several if it is too long."""
        if len(line) <= WIDEST:
            return [line]
        name, sign, value = line.partition(self.syntax.assign)
        if not sign:
            name, value = "", line
        begin, end = self.syntax.around if sign else ("", "")
        found = [f"{name}{sign}{begin}"]
        for word in value.split(" "):
            if len(found[-1]) + len(word) > WIDEST and found[-1].strip():
                found[-1] = found[-1].rstrip() + self.syntax.wrap
                found.append("    ")
            found[-1] += f"{word} "
        return [*found[:-1], found[-1].rstrip() + end]

    @property
    def of_velocities(self) -> str:
        """Return the comment above the velocities."""
        return self.of(Box(len(self.program.boxes) + 1, "terminator", self.words("listing.velocities")))

    def blocks(self) -> list[str]:
        """Return the velocities block by block, with the lines for a determinant that is zero."""
        lines: list[str] = []
        for block in self.program.blocks:
            lines.append(self.of(block.box))
            if block.repeats:
                inside = (line for one in block.lines for line in self.assigned(one))
                lines += held(self.syntax.loop, inside, j=self.count, times=block.repeats)
                continue
            for one in block.lines:
                lines += self.assigned(one)
                if block.checked and block.checked in one.targets:
                    name = self.names[block.checked]
                    lines.append(self.of(Box(block.box.number + 1, "decision", self.words("listing.zero", name=name))))
                    lines += [filled(line, name=name) for line in self.syntax.stop]
        return [*lines, self.of(self.program.returned(self.words))]

    def moved(self, name: str, row: Sum, rates: list[str]) -> str:
        """Return the value of a coordinate after one row of the tableau; `rates` are its rates in the slopes so far."""
        return f"{name} + {row.text(rates, share(row.factor, self.h))}" if row.terms else name

    def arguments(self, stage: int) -> list[str]:
        """Return the arguments of a slope: its time and position."""
        scheme = self.program.scheme
        node, inner = scheme.nodes[stage], scheme.inner[stage]
        time = f"{self.t} + {share(node, self.h)}" if node else self.t
        if stage and self.program.breaks:
            time = f"{self.look}({time}, ({self.row} + 1)*{self.h})"
        return [time, *(self.moved(name, inner, rates) for name, rates in self.rates_of(stage))]

    def rates_of(self, stages: int) -> list[tuple[str, list[str]]]:
        """Return each coordinate with the names of its rate in the slopes so far."""
        pairs = zip(self.coordinates, self.velocities, strict=False)
        return [(name, [self.out(stage, rate) for stage in range(stages)]) for name, rate in pairs]

    def steps_on(self) -> list[str]:
        """Return the assignments of the new coordinates."""
        scheme = self.program.scheme
        moved = [(name, self.moved(name, scheme.outer, rates)) for name, rates in self.rates_of(scheme.slopes)]
        if scheme is SEMI_IMPLICIT:  # the free rates first, then the coordinates by the new rates
            count = len(self.program.coordinates) - len(self.free)
            moved = [*moved[count:], *((name, f"{name} + {self.h}*{self.free.get(name, rates[0])}")
                     for name, rates in self.rates_of(1)[:count])]  # fmt: skip
        return [line for name, value in moved for line in self.wrapped(self.sets(name, value))]

    @property
    def free(self) -> dict[str, str]:
        """Return the free rate of each coordinate that is moved by forces."""
        free = [name for name, out in zip(self.coordinates, self.program.velocities, strict=False) if out.startswith("_rate_")]
        return dict(zip(free, self.coordinates[len(self.coordinates) - len(free) :], strict=True))


def held(around: tuple[str, str], lines: Iterable[str], **names: object) -> list[str]:
    """Return lines, indented, between the line that begins a block and the one that ends it, if the language has one."""
    begin, end = around
    return [filled(begin, **names), *(f"    {line}" for line in lines), *([end] if end else [])]
