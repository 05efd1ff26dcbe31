"""Files that nobody would write, read until something breaks: `python -m tests.grading.reading.fuzz_readers 100000`.

Enters: how many cases, a first seed.  Leaves: counts of the outcomes; raises where a reader crashes, is slow, or opens a file.
A case is a good file (any dialect, equations, answers, a variant file, a zip) with bytes cut, doubled, flipped or spliced.
"""

from __future__ import annotations

import builtins
import contextlib
import io
import os
import random
import sys
import time
import zipfile
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from coursework.grading.reading.equations.answers import read_answer
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import StudentWork
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.system.processes.plain_lines import plain_of, record_of
from tests.grading.reading.table.dialects import DIALECTS, STYLES, archive, written
from tests.grading.scenes import expected, times

SLOWEST = 5.0  # seconds of processor time for one case, far beyond the fraction of one that is usual
GROWTH = 8  # times as long for four times the size: between 4 of a line and 16 of a square
TOKENS = [
    b";", b",", b"\t", b"\n", b"\r", b"\0", b'"', b"'", b"=", b"#", b"1e999", b"nan", "#ДЕЛ/0!".encode("cp1251"), b"(" * 80,
    b"[" * 40, b"**", b"9" * 400, b"1,234", b"0,05", "φ1".encode(), "ω".encode("utf-16-le"), b"\xff\xfe", b"\xef\xbb\xbf",
    b"PK\x03\x04", b"%PDF", b"<td>", b"&#x41;", b"sep=;", b"format = 1\n", b"sin", b"sin^2", b"atan2(1,2)", b"1_000", b"w1",
    b"__import__('os')", b"01.05", "01.май".encode(), b"-", b"<!DOCTYPE", b"/../", b"2r1", b"\xe2\x80\xae", b"1 234,5", b"- - -",
    "３".encode("gb18030"),
]  # fmt: skip


# What costs a careless reader the square of a file's size when it is repeated up to the size allowed.
REPEATED = [
    b"\n", b" ", b";", b",", b"\t", b"<", b"</p>", b"<p>", b"(", b"=", b"1;", b"1 ", b'"', b'";\n', b"a=b\n", b". . . -\n",
    b"#\n",    b"-" + b" ." * 990 + b"x\n", b"1,234;1,234\n", b"0\t0\t0\n", b"w1+",
    b"w1+w1+w1\n", b"[", b"format = 1\n", b"x = [\n", b"\0",
    b"\xff", b"\xd0\xb0", b"\xd0\xb0;", (b"a " * 90 + b";") * 39 + b"\n", (b"," * 199 + b";") * 39 + b"\n", b"<script>",
    (b"/" * 199 + b";") * 39 + b"\n", b"1" * 499 + b";\n", b"wAB=", b"wAB = \n", b"sin^2(", b"2l1 " * 400 + b"=0\n",
    b"r3w3" * 15 + b"+1\n", b"phi" * 19 + b"-w1\n", b"1.5;1.5;1.5;2,5\n", b"t;phi1;phi2\n1;2;3\n", b"<td>1</td>", b"1 234 567;",
    b"1e5;" * 30 + b"\n", b"t;" * 39 + b"\n", b"(\n", b"VMy -\n",
]  # fmt: skip

OPENED = [b"\\(", b"/* \n", b"-> * "]  # begins something that never ends: of a long text the square shows, of a short one not yet


def seeds() -> list[bytes]:
    """Return good files of every kind."""
    scene = expected("31", ("wAB",))
    columns = {column.name: (column.unit, column.values) for column in scene.grid.columns}
    good = []
    for place, dialect in enumerate(DIALECTS.values()):
        style = list(STYLES)[place % 4]
        good.append(dialect(scene.grid.names, written(times(scene.grid), columns, style, 2 + place % 4, "rad"), "rad"))
    path = scene.variant.path
    assert path is not None
    equations = "VMy - 2r3·ω3·cos φ3 − r3ω3sin^2(φ3) = 0,5\n(2) r3*w3 [cos(phi3)] + tg φ1\nwAB = 3/4 1/s\n".encode()
    page = b"<p>w1 = 2<br>w2 &lt; 3</p><table><tr><td>1</td></tr></table>"
    return [*good, path.read_bytes(), equations, page, archive({"a/t.csv": good[0], "e.txt": equations, "x.xlsx": good[-3]})]


def mutated(content: bytes, chance: random.Random) -> bytes:
    """Return a file after some accidents."""
    raw = bytearray(content)
    for _ in range(chance.choice((1, 1, 2, 4, 12))):
        place = chance.randrange(len(raw) + 1)
        what = chance.randrange(6)
        if what == 0 and raw:
            raw[place % len(raw)] = chance.randrange(256)
        elif what == 1:
            raw[place:place] = chance.choice(TOKENS) * chance.choice((1, 1, 1, 30))
        elif what == 2:
            del raw[place : place + chance.choice((1, 3, 40, 2000))]
        elif what == 3:
            piece = raw[place : place + chance.choice((5, 80, 3000))]
            raw[place:place] = piece * chance.choice((1, 3, 50))
        elif what == 4:
            other = chance.randrange(len(raw) + 1)
            raw[place:place] = raw[min(place, other) : min(place, other) + 60]
        else:
            raw[place:place] = chance.randbytes(chance.choice((1, 4, 60)))
    return bytes(raw[: 4 * 2**20])


def inside_a_zip(content: bytes, chance: random.Random) -> bytes:
    """Return a zip whose parts, not whose packing, had accidents; any other file as it is."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as file:
            parts: dict[str, str | bytes] = {name: file.read(name) for name in file.namelist()}
    except (zipfile.BadZipFile, OSError):
        return content
    name = chance.choice(sorted(parts))
    return archive(parts | {name: mutated(bytes(parts[name]), chance)})  # type: ignore[arg-type]


@contextlib.contextmanager
def no_file_written() -> Iterator[None]:
    """Raise where somebody opens a file for writing."""
    real_open, real_os = builtins.open, os.open

    def reading(file: object, mode: str = "r", *args: object, **options: object) -> object:
        assert not set(mode) & set("wax+"), f"{file} was opened for writing"
        return real_open(file, mode, *args, **options)  # type: ignore[call-overload]

    def reading_os(path: object, flags: int, *args: object, **options: object) -> int:
        assert not flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT), f"{path} was opened for writing"
        return real_os(path, flags, *args, **options)  # type: ignore[arg-type]

    builtins.open, os.open = reading, reading_os  # type: ignore[assignment]
    try:
        yield
    finally:
        builtins.open, os.open = real_open, real_os  # type: ignore[assignment]


def outcome(work: StudentWork) -> str:
    """Return what became of a case, having checked what must hold of every one."""
    assert (work.table is None) is (work.trouble is not None)
    if work.table is not None:
        rows = len(work.table.rows_present)
        for column in work.table.columns:
            sizes = {len(column.values), len(column.last_place), len(column.texts), len(column.flags)}
            assert sizes == {rows}
            for value, step, flag in zip(column.values, column.last_place, column.flags, strict=True):
                assert (value == value and abs(value) < float("inf")) is (flag == "")
                assert step > 0
        return "needs-review two_rows" if work.table.unsure else "table"
    assert work.trouble is not None
    return f"{work.trouble.state} {work.trouble.code}"


def run(cases: int, seed: int = 0) -> Counter[str]:
    """Read many cases; return how often each outcome came."""
    scene = expected("31", ("wAB",))
    good = seeds()
    counts: Counter[str] = Counter()
    with no_file_written():
        for case in range(seed, seed + cases):
            chance = random.Random(case)
            content = chance.choice(good)
            content = inside_a_zip(content, chance) if chance.random() < 0.5 else mutated(content, chance)
            handed = Submission(
                "x", None, (submitted_file(chance.choice(("table.csv", "t", "a.xlsx", "e.txt", "x.toml")), content),)
            )
            began = time.process_time()
            try:
                counts[outcome(read_submission(record_of(Submission, plain_of(handed)), scene))] += 1
                read_answer(content[:80].decode("utf-8", "replace"), ("wAB",))
            except Exception as error:
                raise AssertionError(f"case {case}: {error!r}") from error
            spent = time.process_time() - began
            assert spent < SLOWEST, f"case {case} took {spent:.1f} s"
    return counts


def run_repeated(size: int, pieces: Sequence[bytes] = REPEATED) -> Counter[str]:
    """Read files of one piece repeated up to `size` bytes, alone and behind a good table; the time grows with the size alone.

    Of three tries one is enough: a process that is full of other things tidies up now and then.
    """
    scene = expected("31", ("wAB",))

    def spent(content: bytes) -> tuple[float, str]:
        began = time.process_time()
        found = outcome(read_submission(Submission("x", None, (submitted_file("table.csv", content),)), scene))
        return time.process_time() - began, found

    counts: Counter[str] = Counter()
    good = seeds()[0]
    least = min(spent(good)[0] for _ in range(3))
    for piece in pieces:
        for start in (b"", b"t;phi1;w1\n0;1;2\n0.02;1;2\n0.04;1;2\n"):
            content = (start + piece * (size // len(piece) + 1))[:size]
            for fewer in range(3):  # a shorter text each time: of the same one the readers know much by now
                (quarter, _), (whole, found) = (spent(content[: length - fewer]) for length in (size // 4, size))
                if whole < GROWTH * max(quarter, least):
                    break
            else:
                raise AssertionError(f"{piece[:20]!r} took {quarter:.2f} s for a quarter of {whole:.2f} s")
            assert whole < SLOWEST or size > 2**15, f"{piece[:20]!r} took {whole:.2f} s"
            counts[found] += 1
    return counts


if __name__ == "__main__":
    before = set(Path.cwd().iterdir())
    run_repeated(4 * 2**20, REPEATED + OPENED)
    for what, number in sorted(run(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0).items()):
        sys.stdout.write(f"{number:8} {what}\n")
    assert set(Path.cwd().iterdir()) == before
