"""The conclusion: the characteristic numbers of this mechanism, all computed; unknown ones are left out.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from coursework.mechanism.joints import FRAME, chain_of_groups
from coursework.report.text.page_context import STOP_DIGITS, PageContext
from coursework.report.text.parts import Bullets, Cell, Column, Part, Table
from coursework.report.text.text_runs import numeral, runs
from coursework.report.wording.closeness import evidence, largest_error_sentence, splits, unreturned
from coursework.results.checks.close_to_motion.period import Split, is_a_period
from coursework.results.kinematics.turning_points import TurningPoint, stroke, turning_points
from coursework.variant.record.variant import Coordinate

DIGITS = 6  # of a stroke or an extreme: more than in the table, which has no row there
ANGLE_DECIMALS = 2
NOISE = 9  # decimals of an angle in degrees that mean something
RATIO_DIGITS = 4
EVEN = 1e-6  # a ratio that differs less from 1 means that both strokes take equally long


def conclusion(context: PageContext) -> list[Part]:
    """Return stroke and ratio of stroke times, largest error, last row against first, and the table of extremes."""
    run, say = context.run, context.words
    if not len(run.motion.t):
        return []
    told = []
    if run.stop is not None:
        time, rows = context.quantity(run.stop.time, "s", STOP_DIGITS), say.count("count.rows", len(run.motion.t))
        told.append(say("result.stopped", time=time, kind=context.event(run.stop.kind), rows=rows))
    else:
        told += _stroke(context)
    told += [*_error(context), *_return(context)]
    extremes = _extremes(context) if run.stop is None else []
    return [*([Bullets([context.lettered(one) for one in told])] if told else []), *extremes]


def _outputs(context: PageContext) -> Iterator[Coordinate]:
    """Yield the coordinates that may have a stroke, last ones first: of sliders in the frame, then of links turning about it."""
    variant, mechanism = context.run.variant, context.run.scene.mechanism
    coordinates = {c.name: c for c in variant.coordinates if c.rate not in variant.known_rates}
    found: list[Coordinate] = []
    if variant.groups:
        chain = chain_of_groups(variant, dict(mechanism.points))
        for slides in (False, True):
            bodies = [body for joint in chain.joints if FRAME in joint.bodies and joint.kind.slides is slides
                      for body in joint.bodies if body != FRAME]  # fmt: skip
            names = dict.fromkeys(chain.coordinates[body] for body in bodies)
            unit = "m" if slides else "rad"
            found += [coordinates[name] for name in names if name in coordinates and coordinates[name].unit == unit]
    else:
        rates = [link.rate for link in variant.links if {*link.held} & {*variant.frame.hinges}]
        found += [c for c in coordinates.values() if c.rate in rates and c.unit == "rad"]
    yield from reversed(found)


def _stroke(context: PageContext) -> list[str]:
    say, driven = context.words, context.run.variant.driven_coordinates
    if len(driven) != 1 or len(context.run.variant.drive) != 1 or driven[0].unit != "rad":
        return []
    crank = driven[0].name
    for output in _outputs(context):
        found = stroke(evidence(context), output.name, output.rate, crank)
        if found is None:
            continue
        place = context.run.motion.coordinate_names.index(crank)
        values: dict[str, object] = {
            "symbol": context.lettering(output.name),
            "slow": context.quantity(found.slow, "s"), "fast": context.quantity(found.fast, "s"),
            "slow_angle": _degrees(context, found.slow_angle), "fast_angle": _degrees(context, found.fast_angle),
            "ratio": context.numbers.scalar(found.ratio, RATIO_DIGITS),
        }  # fmt: skip
        lengths = context.numbers.column([found.length, found.begin.value, found.end.value], digits=DIGITS)
        values |= {
            key: context.with_unit(length, output.unit) for key, length in zip(("length", "begin", "end"), lengths, strict=True)
        }
        for key, point in (("begin", found.begin), ("end", found.end)):
            values[f"{key}_angle"] = _degrees(context, point.row[place] % (2 * math.pi))
        key = "slider" if output.unit == "m" else "rocker"
        how = "even" if abs(found.ratio - 1) < EVEN else "ratio"
        letter = context.lettering(crank)
        told = [say(f"conclusion.{one}", crank=letter, **values) for one in (key, how)]
        return [say.sentences(told)]
    return []


def _degrees(context: PageContext, angle: float) -> str:
    return context.with_unit(context.numbers.fixed(round(math.degrees(angle), NOISE) % 360.0, ANGLE_DECIMALS), "°")


def _error(context: PageContext) -> list[str]:
    """Return the sentence on the scheme's largest error; if all checks pass, also that the step suffices."""
    say, sentence = context.words, largest_error_sentence(context)
    if not sentence:
        return []
    told = [sentence]
    if context.run.tableau is not None and all(one.verdict in {"PASS", "SKIP"} for one in context.run.checks):
        told.append(say("conclusion.fine", step=context.step))
    return [say.sentences(told)]


def _return(context: PageContext) -> list[str]:
    """Return the sentence that compares the row a period later with the first row."""
    say, variant = context.words, context.run.variant
    coordinates, left = context.run.motion.coordinate_names, unreturned(context)
    found = [split for split in splits(context) if split.name in coordinates]
    if not found:
        return []
    row = context.run.results.evidence.period_row or 0
    driven = variant.given_coordinates
    time = context.quantity(float(context.run.motion.t[row]), "s")
    moved = [split for split in left if split.name in coordinates]
    own = [split for split in moved if split.name not in driven] or moved
    if not own:
        key = "conclusion.positions" if left else "conclusion.repeats"
        return [say(key, row=row + 1, time=time)]
    scale = evidence(context).scale
    most = max(own, key=lambda split: abs(split.total) / scale.get(split.name, 1.0))
    values = {"row": row + 1, "symbol": context.lettering(most.name), "gap": _gap(context, most, most.total)}
    if context.run.tableau is None:
        return [say("conclusion.misses" if is_a_period(context.run.results.evidence) else "conclusion.away", **values)]
    parts = {"scheme": _gap(context, most, most.scheme + most.roundoff), "period": _gap(context, most, most.period)}
    has_returned = abs(most.period) <= EVEN * abs(most.total)
    key = "own" if has_returned else "parted" if is_a_period(context.run.results.evidence) else "moved"
    return [say(f"conclusion.{key}", **values, **parts, time=time, whole=context.quantity(variant.time.period or 0.0, "s"))]


def _gap(context: PageContext, split: Split, value: float) -> str:
    return context.with_unit(context.numbers.scalar(context.numbers.without_noise(value, split.first), 3), split.unit)


def _extremes(context: PageContext) -> list[Part]:
    """Return the table of least and greatest values of coordinates that turn back, with times and crank angles."""
    say, variant, judged = context.words, context.run.variant, evidence(context)
    exact, driven = judged.exact, context.run.variant.driven_coordinates
    if judged.restricted:
        return []
    crank = driven[0].name if len(driven) == 1 and driven[0].unit == "rad" else ""
    lines: list[tuple[Cell, list[TurningPoint]]] = []
    for coordinate in variant.coordinates:
        points = turning_points(judged, coordinate.name, coordinate.rate)
        if not points or coordinate.name == crank:
            continue
        place = exact.coordinate_names.index(coordinate.name)
        ends = [TurningPoint(float(exact.t[row]), float(exact.coordinates[row, place]), tuple(exact.coordinates[row].tolist()))
                for row in (0, -1)]  # fmt: skip
        head = context.symbol_runs([coordinate.name], context.words.behind(context.unit(coordinate.unit)))
        lines.append((head, [extreme([*points, *ends], key=lambda one: one.value) for extreme in (min, max)]))
    if not lines:
        return []
    times = [context.numbers.column(found[place].time for _, found in lines) for place in (0, 1)]
    rows: list[list[Cell]] = []
    for number, (symbol, found) in enumerate(lines):
        row: list[Cell] = [symbol]
        values = context.numbers.column([point.value for point in found], digits=DIGITS)
        for place, (point, value) in enumerate(zip(found, values, strict=True)):
            row += [numeral(value), numeral(times[place][number])]
            if crank:
                row.append(_degrees(context, point.row[exact.coordinate_names.index(crank)] % (2 * math.pi)))
        rows.append(row)
    heads = [Column([], words=True)]
    for key in ("least", "greatest"):
        heads.append(Column(context.say(f"conclusion.{key}")))
        heads.append(Column(runs(say("conclusion.when")), context.unit("s")))
        heads += [Column(context.symbol_runs([crank]))] if crank else []
    return [Table(heads, rows, context.say("conclusion.extremes"), id="extremes")]
