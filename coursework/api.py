"""What `import coursework` offers for one variant: solve it, and its exact motion.

Enters: a name, a path or a `Variant`.  Leaves: `Run`, tables.  Raises `InputError`.
Used by `commands/`, `desk/` and `grading/marking/`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from coursework.motion.settings import Settings, scheme_for
from coursework.run import Run
from coursework.scene.exact_scene import scene_of
from coursework.scene.quantities import TABLE, known_quantities, quantities_for
from coursework.variant.catalogue import load
from coursework.variant.judging.bounds import timed
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say

if TYPE_CHECKING:
    import pandas as pd


def solve(
    variant: Variant | str | Path,
    scheme: str | None = None,
    step: float | None = None,
    end: float | None = None,
    *,
    quantities: Iterable[str] | None = None,
    project: int = 0,
    gain: float = 0.0,
    student: str | None = None,
    group: str | None = None,
    date: str | None = None,
    teacher: str | None = None,
    institution: str | None = None,
    blank: bool = False,
) -> Run:
    """Return a run of a variant.

    `scheme` one of `SCHEMES` or "exact", the motion without a scheme's error (where None that of the file, else "exact" for a
    chain of groups and "euler" for all others); `step` and `end` in s (those of the file where None); `quantities` asked for
    (those of the file where None; names of columns restrict the table to them); `project` Newton corrections a step; `gain` of
    Baumgarte's correction in 1/s; `student` to `institution` stand in the title block; a `blank` sheet of the
    graph-analytical check leaves the construction to the student.  Raises `InputError`.

    >>> import coursework
    >>> run = coursework.solve("31", scheme="rk4", quantities=["table"])
    >>> run.table.shape, list(run.table.columns), run.stop
    ((25, 7), ['phi1', 'phi2', 'phi3', 'w1', 'w2', 'w3', 'w4'], None)
    >>> coursework.solve("31", step=0.01).table["phi3"].round(4).tolist()[:3]  # rad
    [2.87, 2.9255, 2.9806]
    >>> coursework.solve("31", quantities=["phi3", "w3"]).table.columns.tolist()
    ['phi3', 'w3']
    """
    chosen = variant_of(variant) if isinstance(variant, (str, Path)) else variant
    chosen = timed(chosen, step, end)
    asked, columns = _sorted(chosen, quantities)
    order = max((one.order for one in quantities_for(asked).values()), default=1)
    settings = Settings(scheme_for(chosen, scheme), project, gain, columns, order=order).checked(chosen.time.step)
    return Run(scene_of(chosen, settings), asked, student, group, date, teacher=teacher, institution=institution, blank=blank)


def step_of(text: str | None, variant: Variant) -> float | None:
    """Return a step in seconds: a number, or h/N, a whole part of the step h of the file, as the command line has it."""
    if text in {None, "auto"}:
        return None
    assert text is not None
    head, slash, parts = text.partition("/")
    if slash and head.strip() == "h" and parts.strip().isdecimal() and int(parts) > 0:
        return variant.time.step / int(parts)
    try:
        return float(text.removesuffix("s").strip())
    except ValueError:
        told = say("fault.C031", text=text)
        raise InputError(told) from None


def exact(
    variant: Variant | str | Path, step: float | None = None, end: float | None = None, *, quantities: Iterable[str] | None = None
) -> pd.DataFrame:
    """Return the table of the exact motion (index t), with the same columns as `solve(variant).table`.

    `step` and `end` in s; `quantities` as in `solve`.  Raises `InputError`.

    >>> import coursework
    >>> exact, table = coursework.exact("31"), coursework.solve("31").table
    >>> exact.shape == table.shape, round(float((table["phi3"] - exact["phi3"]).abs().max()), 3)  # Euler's error, rad
    (True, 0.152)
    """
    import pandas as pd

    run = solve(variant, step=step, end=end, quantities=quantities)
    motion = run.exact
    names, rows = run.columns_of(run.scene.over(motion))
    table = pd.DataFrame(rows, index=pd.Index(motion.t, name="t"), columns=list(names))
    if not run.settings.columns:
        return table
    rates = run.scene.rates
    return table[[*rates.coordinates, *rates.velocities]]


def variant_of(path_or_name: str | Path) -> Variant:
    """Return the variant of a file or of the catalogue; among the faults of a file are the names that nobody can ask for."""
    return load(path_or_name, _asked_in_vain)


def variant_in(text: str, name: str, tables: Mapping[str, bytes]) -> Variant:
    """Return the variant of a text, as `variant_of` does that of a file; `tables` are those it may name."""
    return parse_variant(text, name, tables, _asked_in_vain)


def _asked_in_vain(variant: Variant) -> list[Fault]:
    known = {*known_quantities(), *variant.columns}
    return [
        _in_file(told, variant, name, True) for name in variant.ask if name not in known and (told := _cannot_ask(variant, name))
    ]


def _sorted(variant: Variant, quantities: Iterable[str] | None) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Split what is asked for into quantities and columns of the table.  Raises `InputError` for what cannot be had."""
    if isinstance(quantities, str):
        quantities = (quantities,)
    listed = (
        tuple(quantities)
        if quantities is not None
        else variant.ask or tuple(name for name, one in known_quantities().items() if one.usual)
    )
    columns = tuple(name for name in listed if name in variant.columns)
    asked = tuple(name for name in listed if name not in columns)
    faults = [_in_file(why, variant, name, quantities is None) for name in asked if (why := _cannot_ask(variant, name))]
    records = known_quantities()
    whole = [name for name in asked if not faults and not records[name].restrictable]
    if columns and whole:
        told = say("fault.C001", name=whole[0], columns=tuple(columns))
        faults.append(_in_file(told, variant, whole[0], quantities is None))
    if faults:
        raise InputError(faults)
    return asked or (TABLE.name,), columns


def _cannot_ask(variant: Variant, name: str) -> Sentence | None:
    """Return why a quantity cannot be had of a variant, None where it can."""
    records = known_quantities()
    if name in records:
        return records[name].refuses(variant)
    hint = closest(name, [*records, *variant.columns])
    return say("fault.C002", name=name, hint=hint, known=", ".join(records))


def _in_file(message: Sentence, variant: Variant, name: str, is_in_file: bool) -> Fault:
    """Return the fault, with its line where the file itself asks."""
    if not is_in_file:
        return Fault(message)
    line = variant.line_of("ask", "quantities", variant.ask.index(name))
    return Fault(message, variant.file, line, 0, "ask.quantities")
