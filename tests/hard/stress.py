"""Random mechanisms by the thousand: every run ends in a right table, a located and explained stop, or a refusal.

python -m tests.hard.stress 10000               counts by outcome; two processes
python -m tests.hard.stress --seed 123          one case, with its file
"""

from __future__ import annotations

import argparse
import collections
import gc
import multiprocessing
import sys
import time
from collections.abc import Iterable, Iterator

import numpy as np
from scipy.optimize import brentq, minimize_scalar

import coursework
from coursework.motion.integration.integrate import March
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import scheme_of
from coursework.run import Run
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.hard.case import Case, Margin
from tests.hard.families import random_case

OPEN = 1e-9  # of the largest length: how far the loops of an exact table may be open
LOCATED = 1e-6  # s of the run's own end: how far a stop may lie from the reach of the links
AGREED = 1e-6  # rad or m: how far Runge-Kutta 4 with small steps may be from the exact table
TOUCHING = 1e-9  # of the largest length: a margin that touches zero to this may be judged either way
SLOW = 20.0  # s of processor time for one case
_LOOKS = 4000
Tally = tuple[collections.Counter[str], list[tuple[int, str]], float]


def judge(seed: int) -> tuple[str, str]:
    """Return the outcome of a case and what is wrong with it ("" where nothing is)."""
    case = random_case(seed)
    begun = time.process_time()
    try:
        outcome, fault = _judged(case)
    except Exception as error:  # whatever it is, it is a fault of the tool
        outcome, fault = "unexplained", f"{type(error).__name__}: {error}"
    if time.process_time() - begun > SLOW:
        return "unexplained", f"took {time.process_time() - begun:.0f} s"
    return (outcome, fault) if not fault else ("unexplained", f"{case.family}, {case.form}: {fault}")


def _judged(case: Case) -> tuple[str, str]:
    try:
        run = coursework.solve(parse_variant(case.text), "rk4", quantities=("table",))
        stop = run.scene.stop
        exact = run.exact
    except InputError as error:
        told = str(error)
        return "refused", "" if not case.closes and told.endswith((".", "?")) else f"refused although it closes: {told}"
    if not case.closes:
        return "table", "a start that does not close was not refused"
    impossible, lowest = first_impossible(case)
    if stop is None:
        if impossible is not None and lowest < -TOUCHING * case.size:
            return "table", f"the links do not reach from t = {impossible:.9g} s on ({lowest:.3g} m), and nothing stopped"
        if abs(lowest) < 1e-13 * case.size:
            return "table", f"the links touch the end of their reach at t = {impossible} s, and nothing stopped"
        outcome = "table"
    else:
        outcome = stop.kind
        if fault := _stop_fault(case, run, impossible):
            return outcome, fault
    fault = _exact_fault(case, run)
    scheme = run.motion
    if not fault and not np.all(np.isfinite(run.columns()[1])):
        fault = "the table has values that are no numbers"
    if not fault and len(scheme.t):
        shared = min(len(scheme.t), len(exact.t))
        off = float(np.max(np.abs(scheme.coordinates[:shared] - exact.coordinates[:shared]), initial=0.0))
        if not _signs_are_right(case, scheme, 4 * off):
            fault = "a determinant of the scheme's rows changes its sign"
    if not fault and scheme.stop is not None and scheme.stop.kind == "step too large":
        return "table, scheme too coarse", ""
    return outcome, fault or _scheme_fault(run, exact.coordinates)


def first_impossible(case: Case) -> tuple[float | None, float]:
    """Return the first time at which the links do not reach (None if they always do), and the smallest margin met (m)."""
    t = np.linspace(0, case.end, _LOOKS + 1)
    first, lowest = case.end, np.inf
    for margin in case.margins:
        values = margin(t)
        inner = values[1:-1]
        bottoms = np.flatnonzero((inner <= values[:-2]) & (inner <= values[2:]) & (inner < 0.05 * case.size)) + 1
        lows = [(float(t[place]), float(values[place])) for place in np.flatnonzero(values < 0)[:1]]
        lows += [_bottom(margin, float(t[place - 1]), float(t[place + 1])) for place in bottoms]
        lowest = min([lowest, float(np.min(values)), *(value for _, value in lows)])
        for time_of, value in sorted(lows):
            if value < 0 and time_of < first + t[1]:
                before = t[(t < time_of) & (values > 0)]
                if len(before):
                    first = min(first, float(brentq(lambda x, m=margin: float(m(np.array(x))), before[-1], time_of, xtol=1e-14)))
                else:  # the start itself stands at the end of its reach
                    first = 0.0
                break
    return (first if first < case.end else None), lowest


def _bottom(margin: Margin, low: float, high: float) -> tuple[float, float]:
    found = minimize_scalar(lambda x: float(margin(np.array(x))), bounds=(low, high), method="bounded", options={"xatol": 1e-13})
    return float(found.x), float(found.fun)


def _stop_fault(case: Case, run: Run, impossible: float | None) -> str:
    stop = run.scene.stop
    if len(stop.sentence) < 80 or not stop.coordinates:
        return f"the stop is not explained: {stop.sentence}"
    if impossible is not None and abs(stop.time - impossible) <= LOCATED * case.end:
        return ""
    margins = [float(margin(np.array(stop.time))) for margin in case.margins]
    if stop.kind == "change point" and min(map(abs, margins)) < 1e3 * TOUCHING * case.size and stop.branches:
        return ""
    if min(map(abs, margins)) < TOUCHING * case.size and (impossible is None or stop.time < impossible):
        return ""  # it touches the end of its reach without leaving it
    return f"stopped at {stop.time:.12g} s ({stop.kind}), but the links reach until {impossible}"


def _exact_fault(case: Case, run: Run) -> str:
    exact = run.exact
    if not len(exact.t):
        return ""
    columns = {name: exact.column(name) for name in exact.coordinate_names}
    gap = np.abs(case.loops(exact.t, columns))
    if not np.all(np.isfinite(exact.rows)) or float(np.max(gap)) > OPEN * case.size:
        return f"the exact table is open by {np.max(gap):.3g} m in row {int(np.argmax(np.max(gap, axis=1))) + 1}"
    if not _signs_are_right(case, exact):
        return "a determinant of the exact rows changes its sign"
    if case.passing:
        beside = np.abs(np.exp(1j * columns["p"]) - case.passing.link(exact.t))
        if float(np.max(beside)) > LOCATED:
            return f"the exact table leaves the one motion that goes on by {np.max(beside):.3g} rad"
    stop = run.scene.stop
    rows = int(np.floor(case.end / case.step * (1 + 1e-12) + 1e-9)) + 1
    if stop is not None:
        rows = min(rows, int(np.ceil(stop.time / case.step * (1 - 1e-9) - 1e-9)))
    return "" if len(exact.t) == rows else f"{len(exact.t)} exact rows, {rows} were expected"


def _signs_are_right(case: Case, motion: Motion, off: float = 0.0) -> bool:
    """Return whether every determinant keeps its sign, or changes it exactly where the case's own length does.

    `off` (rad): rows nearer to that place than this can be on either side of it.
    """
    products = motion.determinants * motion.determinants[0]
    if case.passing is None:
        return bool(np.all(products > 0))
    signed = case.passing.signed(motion.t)
    told = np.abs(signed) > (OPEN + off) * case.size
    return bool(np.all((products * np.sign(signed * signed[0])[:, None])[told] > 0))


def _scheme_fault(run: Run, exact: np.ndarray) -> str:
    """Return what is wrong where Runge-Kutta 4 does not come to the exact rows with smaller steps."""
    motion = run.motion
    count = min(len(motion.t), len(exact))
    gap = float(np.max(np.abs(motion.coordinates[:count] - exact[:count]), initial=0.0))
    parts = 1
    while gap > AGREED:
        parts *= 4
        rates, passages = run.scene.passing(run.scene.rates), run.scene.search.passages
        finer = March(rates, scheme_of("rk4"), motion.step / parts, passages=passages).until(run.scene.start, float(motion.t[-1]))
        if len(finer.t) < parts * (count - 1) + 1:
            return "" if parts < 4096 else "Runge-Kutta 4 with small steps leaves the motion"
        now = float(np.max(np.abs(finer.coordinates[::parts][:count] - exact[:count])))
        if parts > 4096 or (now > 0.5 * gap and parts > 256):
            return f"Runge-Kutta 4 does not come to the exact table: off by {now:.3g} with {parts} steps a row"
        gap = now
    return ""


def outcomes(seeds: Iterable[int]) -> Tally:
    """Return the counts of some seeds, (seed, fault) of those that went wrong, and the longest time of one (s)."""
    counts: collections.Counter[str] = collections.Counter()
    faults = []
    longest = 0.0
    for seed in seeds:
        begun = time.process_time()
        outcome, fault = judge(seed)
        longest = max(longest, time.process_time() - begun)
        counts[outcome] += 1
        if fault:
            faults.append((seed, fault))
    return counts, faults, longest


def _chunk(bounds: tuple[int, int]) -> Tally:
    # Formulas leave few circles behind: one collection a chunk does, and saves a twelfth of the time.
    gc.disable()
    tally = outcomes(range(*bounds))
    gc.collect()
    return tally


def run_many(count: int, first: int = 0, workers: int = 2) -> Iterator[Tally]:
    """Yield the results of chunks of `count` seeds from `first` on, computed by `workers` processes."""
    bounds = [(seed, min(seed + 50, first + count)) for seed in range(first, first + count, 50)]
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        yield from pool.imap_unordered(_chunk, bounds)


def main() -> int:
    """Return 0 where nothing is unexplained."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", nargs="?", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seed", type=int, help="show one case")
    chosen = parser.parse_args()
    if chosen.seed is not None:
        print(random_case(chosen.seed).text)
        print(judge(chosen.seed))
        return 0
    begun = time.perf_counter()
    total: collections.Counter[str] = collections.Counter()
    faults: list[tuple[int, str]] = []
    longest = 0.0
    for counts, wrong, slowest in run_many(chosen.count, chosen.first, chosen.workers):
        total += counts
        faults += wrong
        longest = max(longest, slowest)
        if sys.stderr.isatty():
            print(f"\r{sum(total.values())} of {chosen.count}", end="", file=sys.stderr)
    seconds = time.perf_counter() - begun
    print(f"\n{chosen.count} mechanisms in {seconds:.0f} s with {chosen.workers} processes; the slowest took {longest:.2f} s")
    for outcome, number in total.most_common():
        print(f"  {number:>6}  {outcome}")
    for seed, fault in sorted(faults)[:40]:
        print(f"  seed {seed}: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
