"""What the mobility of the links as listed tells of a file: as many freedoms as are driven, a pair left out, or one too many.

Enters: a `Run`.  Leaves: sentences.  Used by `check.py`, and by `run_on_screen.py` for what is left out.
"""

from __future__ import annotations

from coursework.mechanism.left_out import left_out
from coursework.mechanism.structure import driven_freedoms
from coursework.motion.geometry.judging.rigid import hinges_with_two_names
from coursework.run import Run
from coursework.variant.formula.tree import Formula, named, spelled
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def of_pairs_left_out(run: Run) -> list[Sentence]:
    """Return what `check` says where [links] and [frame] leave more freedoms than are driven, else nothing."""
    mobility, drives = run.scene.mechanism.mobility, driven_freedoms(run.variant)
    if mobility is None or run.variant.motor is not None or not 0 < drives < mobility.degrees:
        return []
    return of_mobility(run)


def of_mobility(run: Run) -> list[Sentence]:
    """Return the mobility of the links as listed, beside what is driven, and the pairs that may be missing."""
    mobility = run.scene.mechanism.mobility
    if mobility is None:
        return []
    sum_of = say("screen.mobility_sum", links=mobility.links, lower=mobility.lower_pairs, higher=mobility.higher_pairs)
    drives = driven_freedoms(run.variant)
    verdict = say("screen.driven", number=drives)
    joints: list[Sentence] = []
    if drives and mobility.degrees != drives:
        joints = _joints_of_two_names(run)
        if mobility.degrees > drives:
            joints += left_out(run.scene.mechanism)
            verdict = say("screen.driven_missing", drives=drives)
        else:
            way = _along_its_guide(run.variant) if drives == mobility.degrees + 1 else None
            is_bare = any(remark.code == "CONTACT" for remark in run.variant.plausibility)
            verdict = way or say("screen.driven_untouched" if is_bare else "screen.driven_special", drives=drives)
    if not drives or run.variant.motor is not None:
        verdict = say("screen.as_listed")
    return [say("screen.mobility", sum_of=sum_of, degrees=mobility.degrees, verdict=verdict), *joints]


def _joints_of_two_names(run: Run) -> list[Sentence]:
    """Return a sentence for each pair of points that may be one hinge, although they share no name."""
    closure = run.scene.closure
    pairs = hinges_with_two_names(run.scene.equations, closure) if closure is not None else ()
    return [say("screen.two_names", one=one, other=other) for one, other in pairs]


def _along_its_guide(variant: Variant) -> Sentence | None:
    """Return which law to write if the driven point moves along a guide of the frame, which leaves it one velocity; else None."""
    point = variant.driven
    angle = next((angle for through, angle in variant.frame.rails if through == named(point or "")), None)
    if not point or angle is None:
        return None
    cosine, sine = (_multiple(function, angle) for function in ("cos", "sin"))
    law = " + ".join(f"V{point}{axis}{part}" for axis, part in zip("xy", (cosine, sine), strict=True) if part is not None)
    x, y = (
        f"{point}.{axis}{'' if part is None else f' - s{point}{part}'}" for axis, part in zip("xy", (cosine, sine), strict=True)
    )
    return say("screen.driven_along", drives=driven_freedoms(variant), point=point, law=law, x=x, y=y)


def _multiple(function: str, angle: Formula) -> str | None:
    """Return a factor cos or sin of an angle as text after another factor, "" if it is 1, None if it is 0."""
    value = known_value(Formula("call", (angle,), function), {})
    if value is not None and (abs(value) < 1e-12 or value > 1 - 1e-12):
        return "" if value > 0.5 else None
    return f"*{function}({spelled(angle)})"
