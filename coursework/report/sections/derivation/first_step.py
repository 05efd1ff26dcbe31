"""The formula by which the scheme goes from row to row, and the first step by hand.

Enters: a `PageContext`.  Leaves: displayed equations with the words around them.  Used by `solution.py`, `method.py`.
"""

from __future__ import annotations

from collections.abc import Collection

from coursework.motion.schemes import SEMI_IMPLICIT, title_of
from coursework.report.formulas import lecture
from coursework.report.text.numbers import MINUS, first_of
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Display, Equations, Paragraph, Part
from coursework.report.text.symbols import Symbol
from coursework.report.text.text_runs import begun
from coursework.report.wording.sought import corrections

DECIMALS = 5  # of a result
DIGITS, MOST_DIGITS = 6, 15  # least and most digits of a factor; it has as few as give the printed result
INDICES = "kinjm"  # letters that may count the steps; a datum of the file may already have one
MOST_LINES = 8  # coordinates whose step is written out; the others are only named


def first_step(context: PageContext) -> list[Part]:
    """Return the formula of the scheme, for schemes of one slope a line per name and the step from row 1 in numbers.

    Empty for exact rows.
    """
    run = context.run
    scheme = run.tableau
    if scheme is None:
        return []
    added = context.words.sentences(besides_the_scheme(context))
    rest: list[Part] = [Paragraph(context.lettered(added))] if added else []
    if scheme.slopes > 1:
        lines = Equations([Display(math, text) for math, text in lecture.lines(scheme)])
        named = {"coordinates": context.symbol_list(context.stepped), "rates": context.symbol_list(context.stepped.values())}
        free = "_free" if run.variant.motor else ""
        return [Paragraph(context.say(f"derivation.scheme{free}", scheme=context.told(title_of(scheme)), **named)), lines, *rest]
    # The semi-implicit scheme steps the coordinates with the new rates.
    ahead = set(run.motion.coordinate_names) if scheme is SEMI_IMPLICIT else set()
    every = dict(sorted(context.stepped.items(), key=lambda one: one[0] in ahead))
    stepped, others = (dict(list(every.items())[part]) for part in (slice(MOST_LINES), slice(MOST_LINES, None)))
    index = index_of_steps(run.variant.names)
    told = {"index": context.lettering(index), "step": context.step}
    if run.variant.motor is None:
        along = context.say("derivation.along", **told)
    else:
        along = context.say("derivation.along_free", scheme=begun(context.told(title_of(scheme))), **told)
    steps = [_line(context.symbol(name), context.symbol(rate), index, ahead=name in ahead) for name, rate in stepped.items()]
    if others:
        rest.insert(0, Paragraph(context.say("derivation.alike", coordinates=context.symbol_list(others))))
    parts: list[Part] = [Paragraph(along), Equations(steps, flow=True), *rest]
    if len(run.motion.t) > 1 and not run.settings.project and not run.settings.gain:
        made = _accelerations(context) if run.variant.motor else {}
        known = {name: made[name] if name in made else float(run.motion.column(rate)[1]) if name in ahead
                 else first_of(run.motion, rate) for name, rate in stepped.items()}  # fmt: skip
        numbers = [_numbers(context, name, speed) for name, speed in known.items()]
        units = dict.fromkeys(context.unit(run.variant.unit_of(name)) for name in known)
        listed = context.words("join.comma").join(units)
        parts += [Paragraph(context.say("derivation.first_step", units=listed)), Equations(numbers, flow=True)]
    return parts


def besides_the_scheme(context: PageContext) -> list[str]:
    """Return the sentences on what determines the rows besides the scheme: closed positions under forces, drift corrections."""
    has_others = context.run.variant.motor is not None and {*context.run.motion.names} - {*context.stepped}
    return [*([context.words("method.closed")] if has_others else []), *corrections(context)]


def index_of_steps(names: Collection[str]) -> str:
    """Return the letter that counts the steps: the first of `INDICES` that is not in `names`, else the first of all.

    >>> index_of_steps(["k", "L1", "i"])
    'n'
    """
    return next((letter for letter in INDICES if letter not in names), INDICES[0])


def _accelerations(context: PageContext) -> dict[str, float]:
    """Return the accelerations of the free rates at the start, by name of the rate (rad/s², m/s²)."""
    from coursework.scene.motor_scene import MotorScene

    scene, motor = context.run.scene, context.run.variant.motor
    assert isinstance(scene, MotorScene) and motor is not None
    start, free = scene.begin_of_forces
    return dict(zip(motor.rates, scene.free_equations.slope(0.0, *start, *free[len(motor.rates) :]), strict=False))


def _line(q: Symbol, w: Symbol, k: str, *, ahead: bool) -> Display:
    at = f"{k} + 1" if ahead else k
    math = f"{q.typst} ({k} + 1) = {q.typst} ({k}) + {w.typst} ({at}) thin h"
    return Display(math, f"{q.text}({k} + 1) = {q.text}({k}) + {w.text}({at}) h")


def _numbers(context: PageContext, name: str, speed: float) -> Display:
    """Return phi1(1) = 1.63 + (-1.57554) * 0.02 = 1.59849, with the fewest digits that give the printed result."""
    motion, step = context.run.motion, context.run.step
    start, end = first_of(motion, name), float(motion.column(name)[1])
    result = f"{end:.{DECIMALS}f}"
    written = ("", "", "")
    for digits in range(DIGITS, MOST_DIGITS + 1):
        written = (f"{start:.{digits}g}", f"{speed:.{digits}g}", f"{step:.{digits}g}")
        if f"{float(written[0]) + float(written[1]) * float(written[2]):.{DECIMALS}f}" == result:
            break
    begin, factor, h = (context.numbers.dressed(text) for text in written)
    factor = f"({factor})" if factor.startswith(MINUS) else factor
    q = context.symbol(name)
    text = f"{begin} + {factor} · {h} = {context.numbers.dressed(result)}"
    return Display(f'{q.typst} (1) = "{text}"', f"{q.text}(1) = {text}")
