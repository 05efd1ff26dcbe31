"""Documents that nobody would write: `python -m tests.grading.reading.documents.fuzz_documents 100000`.

Enters: how many cases, a first seed.  Leaves: counts of the outcomes; raises where a reader crashes, is slow, or opens a file.
"""

from __future__ import annotations

import contextlib
import random
import sys
import time
from collections import Counter
from functools import cache

from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.marking import students
from tests.grading.reading.documents.papers import MAKERS
from tests.grading.reading.documents.test_right_work import GREEK, LATEX, PLAIN, rows
from tests.grading.reading.fuzz_readers import SLOWEST, inside_a_zip, mutated, no_file_written, outcome
from tests.grading.scenes import expected

# What means something to one of the readers, put where it should not be.
TOKENS = [
    b"<w:tbl>", b"</w:tc>", b"<w:p>", b"<m:oMath>", b"<m:f>", b'<w:gridSpan w:val="99"/>', b"<w:vMerge/>", b"<math:math>",
    b"<table:table>", b'<draw:object xlink:href="./A"/>', b"$$", b"|---|", b"{\\*\\moMath", b"\\cell ", b"\\row", b"\\u-1?",
    b"\\'d0", b"\\bin9 ", b"\\itap3 ", b'"cells"', b'"data": {', b"NaN", b"[[[[[[[", b"\\frac{", b"\\begin{align}", b"\\\\",
    b"stream", b"endobj", b"/FlateDecode", b"%PDF-", b"<</Kids[1 0 R]>>", b"&#x0;", b"<![CDATA[", b"xmlns:w='v'", b"\xff\xfe",
    b"\x00", b"<table>", b"</td>", b" role=\"math\" aria-label=\"", b"\\begin{tabular}{", b"\\end{longtable}", b"& &",
]  # fmt: skip


@cache
def seeds(with_pdf: bool) -> tuple[bytes, ...]:
    """Return good documents of every kind."""
    table = rows(students.table())
    makers = {kind: made for kind, (_, made) in MAKERS.items() if kind.startswith("pdf") is with_pdf}
    return tuple(made(GREEK if len(kind) % 2 else PLAIN, table, LATEX) for kind, made in makers.items())


def spoilt(content: bytes, chance: random.Random) -> bytes:
    """Return a document after some accidents, outside or inside its packing."""
    if chance.random() < 0.4:
        raw = bytearray(content)
        for _ in range(chance.choice((1, 1, 3))):
            place = chance.randrange(len(raw) + 1)
            raw[place:place] = chance.choice(TOKENS) * chance.choice((1, 1, 2, 40))
        content = bytes(raw)
    if content[:2] == b"PK" and chance.random() < 0.8:
        with contextlib.suppress(ValueError):  # a directory that points nowhere
            return inside_a_zip(content, chance)
    return mutated(content, chance)


def run(cases: int, seed: int = 0, with_pdf: bool = False) -> Counter[str]:
    """Read many cases; return how often each outcome came."""
    scene = expected("31", ("wAB",))
    good = seeds(with_pdf)
    counts: Counter[str] = Counter()
    with no_file_written():
        for case in range(seed, seed + cases):
            chance = random.Random(case)
            content = spoilt(chance.choice(good), chance)
            began = time.process_time()
            try:
                work = read_submission(Submission("x", None, (submitted_file("work", content),)), scene)
                counts[outcome(work)] += 1
            except Exception as error:
                raise AssertionError(f"case {case}: {error!r}") from error
            assert time.process_time() - began < SLOWEST + 5 * with_pdf, f"case {case}"
    return counts


if __name__ == "__main__":
    number, first = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0
    for what, count in sorted((run(number, first) + run(number // 100, first, True)).items()):
        sys.stdout.write(f"{count:8} {what}\n")
