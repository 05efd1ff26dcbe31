"""The functions of `import coursework` for one variant: its solution, and its exact motion.

Enters: a name, a path or a `Variant`.  Leaves: `Run`, tables.  Raises `InputError`.
Used by `commands/`, `desk/` and `grading/marking/key/`.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from coursework.motion.settings import Settings, scheme_for, stepping
from coursework.run import Run
from coursework.scene.exact_scene import scene_of
from coursework.scene.motion_results import needs_all
from coursework.scene.quantities import TABLE, known_quantities, no_quantity, quantities_for
from coursework.variant.catalogue import load, variant_from
from coursework.variant.judging.bounds import seconds, timed
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.variant import Variant
from coursework.words.errors import CourseworkWarning, Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

if TYPE_CHECKING:
    import pandas as pd

    from coursework.results.accuracy.step_search import StepChoice

Given = Variant | str | Path | int
PRECISIONS = ("double", "single")


def solve(
    variant: Given,
    scheme: str | None = None,
    step: float | str | None = None,
    end: float | str | None = None,
    *,
    quantities: Iterable[str] | None = None,
    project: int = 0,
    gain: float = 0.0,
    error: float | None = None,
    precision: str = "double",
    student: str | None = None,
    group: str | None = None,
    date: str | None = None,
    teacher: str | None = None,
    institution: str | None = None,
    blank: bool = False,
) -> Run:
    """Return a run of a variant: its name, a path, or what `load` and `parse_variant` return.

    `scheme`: one of `SCHEMES`, or "exact" for the motion without a scheme's error; if None, that of the file, else "exact" for
    a chain of groups and "euler" for other files.  `step`: in s, or "20 ms", or "h/18" (h is the step of the file), or "auto"
    for the largest step within `error` (rad or m).  `end`: in s, or with a unit; if None, step and end are those of the file.
    `quantities`: the names asked for, those of the file if None; names of columns restrict the table to them.  `project`:
    Newton corrections per step; `gain` of Baumgarte's correction in 1/s; `precision`: "single" shows round-off, see
    `Run.round_off`.  `student` to `institution` stand in the title block; on a `blank` sheet of the graph-analytical check
    the student makes the construction.  Warns with `CourseworkWarning` of likely slips; raises `InputError`.

    >>> import coursework
    >>> run = coursework.solve("31", scheme="rk4", quantities=["table"])
    >>> run.table.shape, list(run.table.columns), run.stop
    ((25, 7), ['phi1', 'phi2', 'phi3', 'w1', 'w2', 'w3', 'w4'], None)
    >>> coursework.solve("31", step=0.01).table["phi3"].round(4).tolist()[:3]  # rad
    [2.87, 2.9255, 2.9806]
    >>> coursework.solve("31", quantities=["phi3", "w3"]).table.columns.tolist()
    ['phi3', 'w3']
    >>> coursework.solve("31", step=coursework.solve("31").advice.step).passed
    True
    """
    run = make_run(
        variant, scheme, step, end, quantities=quantities, project=project, gain=gain, error=error, precision=precision,
        student=student, group=group, date=date, teacher=teacher, institution=institution, blank=blank,
    )  # fmt: skip
    for remark in run.remarks if end is not None else run.slips:
        warnings.warn(remark, CourseworkWarning, stacklevel=2)
    return run


def make_run(
    variant: Given, scheme: str | None = None, step: float | str | None = None, end: float | str | None = None, *,
    quantities: Iterable[str] | None = None, project: int = 0, gain: float = 0.0, error: float | None = None,
    precision: str = "double", blank: bool = False, **title: str | None,
) -> Run:  # fmt: skip
    """Return what `solve` returns, without warnings: the command line reports likely slips itself."""
    for name, text in title.items():
        if not (text is None or isinstance(text, str)):
            raise InputError(say("fault.D032", name=name, found=repr(text)))
    for name, number in (("gain", gain), ("error", error)):
        if number is not None and (isinstance(number, bool) or not isinstance(number, (int, float))):
            raise InputError(say("fault.D025", name=name, found=repr(number)))
    if precision not in PRECISIONS:
        raise InputError(say("fault.D034", found=repr(precision)))
    chosen = variant_from(variant, _asked_in_vain)
    if step == "auto":
        scheme = stepping(chosen, scheme)
        step = step_choice(make_run(chosen, scheme, end=end, quantities=(TABLE.name,)), error).step
    elif error is not None:
        raise InputError(say("fault.C029"))
    chosen = timed(chosen, step_of(step, chosen), seconds(end))
    asked, columns = _sorted(chosen, quantities)
    corrections = int(project) if isinstance(project, bool) else project  # True means one correction
    order = max((one.order for one in quantities_for(asked).values()), default=1)
    asked_for = Settings(scheme_for(chosen, scheme), corrections, gain, columns, order=order)
    settings = asked_for.checked(chosen.time.step, by_forces=chosen.motor is not None)
    return Run(scene_of(chosen, settings), asked, blank=blank, precision=precision, **title)  # type: ignore[arg-type]


def exact(
    variant: Given, step: float | str | None = None, end: float | str | None = None, *, quantities: Iterable[str] | None = None
) -> pd.DataFrame:
    """Return the table of the exact motion (index t), with the same columns as `solve(variant).table`.

    `step`, `end` and `quantities` as in `solve`.  Warns with `CourseworkWarning` if the motion ends early; raises
    `InputError`.

    >>> import coursework
    >>> exact, table = coursework.exact("31"), coursework.solve("31").table
    >>> exact.shape == table.shape, round(float((table["phi3"] - exact["phi3"]).abs().max()), 3)  # Euler's error, rad
    (True, 0.152)
    """
    run = make_run(variant, step=step, end=end, quantities=quantities)
    if (stop := run.scene.stop) is not None:
        warnings.warn(stop.sentence, CourseworkWarning, stacklevel=2)
    table = run.framed(run.scene.over(run.scene.exact))
    rates = run.scene.rates
    return table[[*rates.coordinates, *rates.velocities]] if run.settings.columns else table


def variant_of(path_or_name: str | Path) -> Variant:
    """Return the variant of a file or of the catalogue; raise `InputError` also for quantities that it cannot ask for."""
    return load(path_or_name, _asked_in_vain)


def variant_in(text: str, name: str, tables: Mapping[str, bytes]) -> Variant:
    """Return the variant of a text as `variant_of` does for a file; `tables` are those that the text may name."""
    return parse_variant(text, name, tables, _asked_in_vain)


def step_of(step: float | str | None, variant: Variant) -> float | None:
    """Return a step in seconds, given as a number, as text with a unit, or as h/N or 2h/N, where h is the step of the file.

    Raises `InputError` for other text; None stays None.
    """
    if not isinstance(step, str):
        return step
    part = re.fullmatch(r"\s*(\d{0,9})\s*h\s*/\s*(\d{1,9})\s*", step)
    if part and int(part[1] or 1) and int(part[2]):
        return variant.time.step * int(part[1] or 1) / int(part[2])
    found = seconds(step)
    if isinstance(found, str):
        raise InputError(say("fault.C031", text=step, hint=say("hint.point") if "," in step else ""))
    return found


def step_choice(run: Run, error: float | None) -> StepChoice:
    """Return the largest step with which a run stays within `error` (rad or m), and its cost.

    Raises `InputError` if `error` is missing or cannot be reached, and for a motion that stops.
    """
    if error is None:
        raise InputError(say("fault.C030"))
    if (stop := run.scene.stop) is not None:
        raise stop.refusal
    from coursework.results.accuracy.step_rules import step_rules
    from coursework.results.accuracy.step_search import choose_step

    scene = run.scene
    return choose_step(
        scene.rates, run.scheme, scene.begin, run.step, scene.variant.time.end, error,
        step_rules(scene.equations, scene.search), lambda scheme, step: scene.rerun(scheme, step) is not None,
    )  # fmt: skip


def _asked_in_vain(variant: Variant) -> list[Fault]:
    known = {*known_quantities(), *variant.columns}
    return [
        _in_file(told, variant, name, True) for name in variant.ask if name not in known and (told := _cannot_ask(variant, name))
    ]


def _sorted(variant: Variant, quantities: Iterable[str] | None) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Split the names asked for into quantities and columns of the table.  Raises `InputError` for impossible ones."""
    listed = _listed(variant, quantities)
    columns = tuple(name for name in listed if name in variant.columns)
    asked = tuple(name for name in listed if name not in columns)
    faults = [_in_file(why, variant, name, quantities is None) for name in asked if (why := _cannot_ask(variant, name))]
    records = known_quantities()
    whole = [name for name in asked if not faults and not records[name].restrictable]
    if columns and whole:
        told = needs_all(whole[0], columns)
        faults.append(_in_file(told, variant, whole[0], quantities is None))
    if faults:
        raise InputError(faults)
    return asked or (TABLE.name,), columns


def _listed(variant: Variant, quantities: Iterable[str] | None) -> tuple[str, ...]:
    if quantities is None:
        return variant.ask or tuple(name for name, one in known_quantities().items() if one.usual)
    listed = (quantities,) if isinstance(quantities, str) else tuple(quantities) if isinstance(quantities, Iterable) else (None,)
    if not all(isinstance(name, str) for name in listed):
        raise InputError(say("fault.D033", found=repr(quantities)))
    return listed


def _cannot_ask(variant: Variant, name: str) -> Sentence | None:
    """Return why a quantity is not possible for a variant, None if it is possible."""
    records = known_quantities()
    if name in records:
        return records[name].refuses(variant)
    if name.partition(".")[0] in {point for point, _ in variant.points} and "." in name:
        return say("fault.D029", name=name, known=variant.columns)
    return no_quantity(name, variant.columns)


def _in_file(message: Sentence, variant: Variant, name: str, is_in_file: bool) -> Fault:
    """Return the fault, with its line if the file itself asks for the quantity."""
    if not is_in_file:
        return Fault(message)
    line = variant.line_of("ask", "quantities", variant.ask.index(name))
    return Fault(message, variant.file, line, 0, "ask.quantities")
