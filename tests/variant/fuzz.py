"""Files of the catalogue spoilt at random: read, computed, written on pages.  `python -m tests.variant.fuzz N`.

Enters: how many files; the seed decides everything.  Leaves: counts of what became of them, and each file that made the tool
fail.  Used by `test_fuzz.py`, and by hand with a large N.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import re
import signal
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

import coursework
from coursework.report.output.gate import pass_gate
from coursework.report.output.record import record
from coursework.variant.catalogue import names
from coursework.variant.reading.reader import read_variant
from coursework.variant.record.variant import Variant
from coursework.words.data_folders import folder
from coursework.words.errors import CourseworkError

PIECES = [
    "0", "1", "-1", "1e9", "nan", "inf", "true", '""', '"0"', '"1 m"', "[", "{", "[]", "{}", "phi1", "w1", "w4", "r1", "t",
    "pi", "sin(", "cos(", ")", "(", "*", "/", "^", "+", "-", " = ", "=", "@", ".x", ".y", '"', "'", "\n", "[drive]",
    "[[constraint]]", "[points]", "D", "A", "M", "VMx", "9**9", "exp(", "sqrt(", "abs(", "log(", "asin(", "atan2(", "1/0",
    ",", "#", "φ1", "deg", "rate", "start", "closure", "driven", "kind", '"RRR"', "mode", "1000000", "1e-30", "0 @ phi1",
    "", "\ufeff", "\x00", "с", "0x" + "f" * 4000, "1979-05-27", '"5 rpm"', '"5 мм"', "\\ud800", "\U0001d6d1", "0.5", "^0.5",
    "abs(t - 0.1)/(t - 0.1)", "sqrt(0.1 - t)", "acos(3*t)", "{ pieces = [[0, 1], [0.1, 2]] }", "^(1/3)", "log(t)", "1/t", "e",
    "[[quote]]", "[functions]", '{ table = "variable-crank-table.csv", of = "phi1" }', "lambda", "None", "2^0.5", "(2).x",
]  # fmt: skip
_WORD = re.compile(r"[^\W\d]\w*|[\d.]+|[^\s\w]")
_NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.])")
_FACTORS = (0.0, -1.0, 0.5, 2.0, 1.1, 0.9, 10.0, 0.01, 1e6, 1e-9, 1.0001, 3.0)
SECONDS = 60  # a file that takes longer is a fault of the tool


def catalogue() -> dict[str, str]:
    """Return the texts that are spoilt."""
    return {name: (folder("variants") / f"{name}.toml").read_text(encoding="utf-8") for name in names()}


def spoilt(text: str, random: Random) -> str:
    """Return a text with one to three words, numbers or lines exchanged, left out or put in."""
    for _ in range(random.randint(1, 3)):
        text = random.choice(_SPOILERS)(text, random)
    return text


def _exchanged(text: str, random: Random) -> str:
    word = random.choice(list(_WORD.finditer(text)))
    return text[: word.start()] + random.choice(PIECES) + text[word.end() :]


def _copied(text: str, random: Random) -> str:
    words = list(_WORD.finditer(text))
    word, other = random.choice(words), random.choice(words)
    return text[: word.start()] + other[0] + text[word.end() :]


def _put_in(text: str, random: Random) -> str:
    word = random.choice(list(_WORD.finditer(text)))
    return text[: word.start()] + random.choice(PIECES) + text[word.start() :]


def _without_a_line(text: str, random: Random) -> str:
    lines = text.split("\n")
    del lines[random.randrange(len(lines))]
    return "\n".join(lines)


def _another_number(text: str, random: Random) -> str:
    found = list(_NUMBER.finditer(text))
    if not found:
        return text
    number = random.choice(found)
    return f"{text[: number.start()]}{float(number[0]) * random.choice(_FACTORS):g}{text[number.end() :]}"


_SPOILERS: tuple[Callable[[str, Random], str], ...] = (
    _exchanged, _copied, _put_in, _without_a_line, _another_number, _another_number, _another_number, _another_number,
)  # fmt: skip


class TooLong(BaseException):
    """A file took longer than anybody waits; no `Exception`, so that nothing in the tool takes it for its own."""


@dataclass
class Tally:
    """`counts` of outcomes by stage, `failures` (seed, stage, what happened), `memory` the most held (MiB)."""

    counts: Counter[str] = field(default_factory=Counter)
    failures: list[tuple[int, str, str]] = field(default_factory=list)
    memory: float = 0.0


def tried(seeds: range, runs: int, pages: int, place: Path) -> Iterator[Tally]:
    """Yield the tally after each file: every one is read, the first `runs` that can be are computed, `pages` of these written."""
    texts = catalogue()
    tally = Tally()
    for table in folder("variants").glob("*.csv"):
        (place / table.name).write_bytes(table.read_bytes())
    for seed in seeds:
        random = Random(seed)
        text = spoilt(texts[random.choice(sorted(texts))], random)
        path = place / "spoilt.toml"
        path.write_bytes(text.encode("utf-8", "replace"))
        variant = _attempt(seed, "read", tally, lambda path=path: read_variant(path))
        if isinstance(variant, Variant) and tally.counts["computed"] < runs:
            tally.counts["computed"] += 1
            run = _attempt(seed, "run", tally, lambda variant=variant: _computed(variant))
            if isinstance(run, coursework.Run) and tally.counts["written"] < pages:
                tally.counts["written"] += 1
                _attempt(seed, "pages", tally, lambda run=run: _written(run, place))
        tally.memory = most_held()
        yield tally


def _attempt(seed: int, stage: str, tally: Tally, work: Callable[[], object]) -> object:
    begun = time.process_time()
    try:
        with warnings.catch_warnings(), limited(SECONDS):
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", coursework.CourseworkWarning)  # a remark on a spoilt file is none of ours
            result = work()
    except CourseworkError as error:
        told = str(error)
        tally.counts[f"{stage}: refused"] += 1
        if not told or not told.replace("\n", "").isprintable() or "Traceback" in told:
            tally.failures.append((seed, stage, f"a sentence that is none: {told!r}"))
        elif not re.match(r".*spoilt\.toml:\d", told):
            tally.counts[f"{stage}: refused without a line"] += 1
        return None
    except TooLong:
        tally.failures.append((seed, stage, f"took more than {SECONDS} s"))
        return None
    except Exception as error:
        last = traceback.extract_tb(error.__traceback__)[-1]
        tally.failures.append((seed, stage, f"{type(error).__name__}: {error} ({Path(last.filename).name}:{last.lineno})"[:300]))
        return None
    outcome = "stopped" if isinstance(result, coursework.Run) and result.stop is not None else "done"
    tally.counts[f"{stage}: {outcome}"] += 1
    tally.counts[f"{stage}: longer than 10 s"] += time.process_time() - begun > 10
    return result


def _computed(variant: Variant) -> coursework.Run:
    run = coursework.solve(variant)
    pass_gate(run, pages=False)
    _, rows = run.columns()
    if not all(map(math.isfinite, rows.ravel().tolist())):
        raise ArithmeticError("a table holds what is no number")
    json.dumps(record(run), allow_nan=False).encode()
    return run


def _written(run: coursework.Run, place: Path) -> None:
    coursework.write_report(run, place / "report.html", place / "report.pdf")
    page = (place / "report.html").read_text(encoding="utf-8")
    if re.search(r">\s*[-−]?(?:nan|inf)\s*<", page):
        raise ArithmeticError("a page shows what is no number")


@contextlib.contextmanager
def limited(seconds: float) -> Iterator[None]:
    """End what takes longer, where the system can; elsewhere let it go on."""
    if not hasattr(signal, "setitimer"):
        yield
        return

    def end(_signal: int, _frame: object) -> None:
        raise TooLong

    before = signal.signal(signal.SIGVTALRM, end)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def most_held() -> float:
    """Return the most memory this process has held so far (MiB), 0 where the system does not say."""
    try:
        import resource
    except ImportError:
        return 0.0
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most / (2**20 if sys.platform == "darwin" else 2**10)


def main() -> int:
    """Print the counts, and each failure with the seed that makes it again."""
    parser = argparse.ArgumentParser(description="Read, compute and print files of the catalogue spoilt at random.")
    parser.add_argument("count", type=int, help="files to read")
    parser.add_argument("--runs", type=int, help="files to compute (a twentieth of them)")
    parser.add_argument("--pages", type=int, help="files to write on pages (a hundredth of them)")
    parser.add_argument("--seed", type=int, default=0, help="the first seed")
    given = parser.parse_args()
    runs = given.count // 20 if given.runs is None else given.runs
    pages = given.count // 100 if given.pages is None else given.pages
    shown = 0
    with tempfile.TemporaryDirectory() as place:
        for done, tally in enumerate(tried(range(given.seed, given.seed + given.count), runs, pages, Path(place)), start=1):
            for failure in tally.failures[shown:]:
                print("seed {}, {}: {}".format(*failure), flush=True)
            shown = len(tally.failures)
            if done % 1000 == 0 or done == given.count:
                print(done, dict(sorted(tally.counts.items())), f"{shown} failures, {tally.memory:.0f} MiB", flush=True)
    return int(shown > 0)


if __name__ == "__main__":
    sys.exit(main())
