"""The appendix on the method: the formula, the step and the programs by which the numbers were computed.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

from coursework.motion.schemes import SEMI_IMPLICIT
from coursework.report.formulas import lecture
from coursework.report.sections.derivation.first_step import besides_the_scheme
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Bullets, Display, Equations, Paragraph, Part
from coursework.report.text.text_runs import printed, runs
from coursework.words.templates import clean


def method(context: PageContext) -> list[Part]:
    """Return the formula, the step and the programs by which the numbers were computed."""
    run, words = context.run, context.words
    if run.tableau is None:
        label = printed(context.told(run.motion.label)).rstrip(".")
        told = [words("method.rows_exact", step=context.step, label=label)]
        return [Paragraph(context.lettered(words.sentences([*told, *_lesson(context)]))), *_versions(context)]
    free = "_free" if run.variant.motor else ""
    intro = context.say(f"method.intro{free}", title=context.told(run.scheme_title), order=run.tableau.order)
    semi = run.tableau is SEMI_IMPLICIT
    formula = Equations([Display(math, text) for math, text in (lecture.SEMI_IMPLICIT if semi else lecture.lines(run.tableau))])
    parts: list[Part] = [Paragraph(intro), formula]
    states = [name for name in context.stepped if not semi or name in run.motion.coordinate_names]
    slopes = [context.stepped[name] for name in states]
    named = {"coordinates": context.symbol_list(states), "rates": context.symbol_list(slopes)}
    if semi:
        named["slopes"] = context.symbol_list(context.stepped[name] for name in slopes)
    sentences = [
        words("method.meaning_semi" if semi else f"method.meaning{free}", **named),
        *besides_the_scheme(context),
        words("method.time", step=context.step),
        words("method.slopes" if free else "method.evaluations", number=context.numbers.whole(run.motion.evaluations)),
    ]
    if context.exact is not None:
        label = context.words.written(context.exact.label) or words("graphs.exact")
        sentences.append(words("method.exact", label=printed(clean(label)).rstrip(".")))
    parts.append(Paragraph(context.lettered(words.sentences(sentences))))
    if run.motion.notes:
        parts.append(Bullets([context.rich(note) for note in run.motion.notes]))
    return [*parts, *_versions(context)]


def _lesson(context: PageContext) -> list[str]:
    """Return the sentence on how far the coursework's scheme is from an exact table; empty if it was not compared."""
    lesson = context.run.distance_to_exact
    return [] if lesson is None else [context.told(lesson.sentence)]


def _versions(context: PageContext) -> list[Part]:
    named = (f"{clean(name)} {clean(version)}" for name, version in context.run.versions.items())
    versions = context.words("join.comma").join(named)
    return [Paragraph(runs(context.words("method.versions", versions=versions)), "note")] if versions else []
