"""`python -m tests.results.checks.verdicts [variants]`: the table of verdicts over the catalogue and over random variants.

Every verdict about closeness is compared with that of `independent.py`, and every step that a COARSE check advises is run.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from random import Random
from typing import Any

import coursework
from coursework.motion.schemes import DEFAULT_SCHEME, SCHEMES
from coursework.variant.catalogue import entries
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.vocabulary import EXACT
from coursework.words.errors import CourseworkError
from tests.results.checks.independent import Judge, judge, verdict

STEPS = {"h": 1.0, "h/4": 0.25, "3h": 3.0}
CODES = ("ACCURACY", "PERIOD-POSITION", "PERIOD-VELOCITY", "CONTINUITY", "DRIFT")
# Two ways to a share agree to this; a share closer to a limit than that may fall on either side.
AGREED = 1e-4


def verdicts(run: Any) -> dict[str, str]:
    """Return the verdict of each check."""
    return {finding.code: finding.verdict for finding in run.checks}


def contradictions(run: Any, truth: Judge) -> list[str]:
    """Return what the checks say and the independent comparison does not."""
    found = []
    values = {finding.code: finding for finding in run.checks}
    wanted = {
        "ACCURACY": truth.accuracy(), "PERIOD-POSITION": truth.period(False), "PERIOD-VELOCITY": truth.period(True),
        "CONTINUITY": truth.continuity(), "DRIFT": truth.drift(),
    }  # fmt: skip
    for code, share in wanted.items():
        finding = values[code]
        if verdict(share) != finding.verdict and not _on_the_edge(share):
            found.append(f"{code}: {finding.verdict}, but {share}")
        elif isinstance(share, float) and finding.value is not None and abs(finding.value - share) > AGREED * (1 + share):
            found.append(f"{code}: {finding.value}, but {share}")
    # Starts of a file do not follow a change of its lengths: where its own loop says so, START is right to call them wrong.
    rest = [f for f in run.checks if f.verdict in {"FAIL", "ERROR"} and f.code != "START"]
    judged = [f for f in rest if verdict(wanted.get(f.code)) != f.verdict]
    return found + [f"{f.code}: {f.verdict}: {f.sentence}" for f in judged]


def _on_the_edge(share: float | str | None) -> bool:
    return isinstance(share, float) and abs(share - 0.05) < AGREED


def unkept(run: Any, variant: Any, scheme: str) -> list[str]:
    """Return what is still COARSE when the steps that the checks advise are run."""
    found = []
    for step in {finding.step for finding in run.checks if finding.step is not None}:
        again = coursework.solve(variant, scheme, step=step, quantities=["table", "checks"])
        # What no step cures is told so, and is no promise.
        left = sorted(f.code for f in again.checks if f.group == "motion" and f.verdict == "COARSE" and f.cured)
        found += [f"{code} is COARSE with the advised step {step!r}" for code in left]
        found += contradictions(again, judge(again))
    return found


def driven() -> list[Any]:
    """Return the catalogue without what forces move: that is checked by its energy, which tests/effects judges."""
    variants = [coursework.load(entry.name) for entry in entries()]
    return [each for each in variants if each.forces is None or each.forces.motor is None]


def catalogue() -> Iterator[tuple[str, str, Counter[tuple[str, str]], list[str], int]]:
    """Yield (step, scheme, counts of (code, verdict), contradictions, advised steps run) over the catalogue."""
    for name, factor in STEPS.items():
        for scheme in (*SCHEMES, EXACT):
            counts: Counter[tuple[str, str]] = Counter()
            wrong, advised = [], 0
            for variant in driven():
                run = coursework.solve(variant, scheme, step=variant.time.step * factor, quantities=["table", "checks"])
                found = verdicts(run)
                counts.update(found.items())
                if run.stop is not None:
                    counts["STOPPED", ""] += 1
                    continue
                told = contradictions(run, judge(run)) + unkept(run, variant, scheme)
                advised += any(finding.step is not None for finding in run.checks)
                wrong += [f"{variant.name} {scheme} {name}: {text}" for text in told]
            yield name, scheme, counts, wrong, advised


def random_variants(count: int, seed: int = 1) -> Iterator[Any]:
    """Yield variants of the catalogue with every length, angle and speed changed by up to 5 %, as many as can move."""
    random = Random(seed)
    files = [variant.path for variant in driven()]
    texts = [text for text in (file.read_text(encoding="utf-8") for file in files) if "table =" not in text]
    made = 0
    while made < count:
        text = random.choice(texts)
        head, given, rest = text.partition("[given]")
        section, mark, tail = rest.partition("\n[")
        changed = re.sub(r'"(\d+\.?\d*)( ?[^"\d*/+-]*)"', lambda found: _changed(found, random), section)
        try:
            variant = parse_variant(head + given + changed + mark + tail, "random.toml")
            variant = replace(variant, quotes=())  # numbers of the file's own data
            run = coursework.solve(variant, random.choice([DEFAULT_SCHEME.name, *SCHEMES]), quantities=["table", "checks"])
            if run.stop is None:
                made += 1
                yield run
        except CourseworkError:
            continue


def _changed(found: re.Match[str], random: Random) -> str:
    return f'"{float(found[1]) * random.uniform(0.95, 1.05):.6g}{found[2]}"'


def main(count: int) -> int:
    """Print the tables; return 1 where a verdict is contradicted or an advised step does not keep its word."""
    print(f"{'step':5} {'scheme':9} " + " ".join(f"{code:>16}" for code in CODES) + "  stopped  advised")
    every = []
    for step, scheme, counts, wrong, advised in catalogue():
        cells = (
            "".join(f" {counts[code, v]}{v[0]}" for v in ("PASS", "COARSE", "FAIL", "ERROR") if counts[code, v]) for code in CODES
        )
        print(
            f"{step:5} {scheme:9} " + " ".join(f"{cell:>16}" for cell in cells) + f"  {counts['STOPPED', '']:>7}  {advised:>7}",
            flush=True,
        )
        every += wrong
    judged, advised = 0, 0
    kinds: Counter[tuple[str, str]] = Counter()
    for run in random_variants(count):
        judged += 1
        kinds.update((finding.code, finding.verdict) for finding in run.checks)
        # A period stated as a number does not follow a change of the lengths: to call it wrong is right, if the truth says so.
        told = contradictions(run, judge(run)) + unkept(run, run.variant, run.scheme)
        advised += any(finding.step is not None for finding in run.checks)
        every += [f"random {judged} ({run.variant.title}, {run.scheme}): {text}" for text in told]
    print(f"random variants: {judged}, advised steps run: {advised}")
    print("  " + ", ".join(f"{code} {kind} {number}" for (code, kind), number in sorted(kinds.items()) if code in CODES))
    print("\n".join(every) or "no verdict is contradicted")
    return int(bool(every))


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 200))
