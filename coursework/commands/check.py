"""`coursework check`: what a file says and whether its motion is possible, before anything is integrated.

Used by `cli.py`.
"""

from __future__ import annotations

from coursework.api import solve
from coursework.commands.run_on_screen import tell_remarks
from coursework.commands.screen import tell, title_of
from coursework.run import Run
from coursework.variant.catalogue import load
from coursework.variant.formula.tree import spelled
from coursework.words.sentences import say, say_count


def check_variant(variant: str) -> int:
    """Return 0 where the whole motion is possible, 1 where it stops."""
    run = solve(load(variant))
    chosen = run.variant
    tell(f"{title_of(chosen)}  ({chosen.name}, {chosen.path})")
    tell_remarks(run)
    scene = run.scene
    equations, reduction = scene.equations, scene.reduction
    tell(
        say(
            "screen.counts",
            number=len(chosen.sought),
            unknowns=", ".join(chosen.sought),
            equations=len(equations.equations),
            drives=len(chosen.drive),
        )
    )
    _tell_mobility(run)
    closure = scene.closure
    for note in reduction.notes:
        tell(note)
    for block, solution in zip(reduction.blocks, scene.solutions, strict=True):
        tell(say("screen.block", unknowns=tuple(block.unknowns), equations=tuple(block.equations)))
        for name, formula in solution:
            tell(f"    {name} = {spelled(formula)}")
        determinant = spelled(block.determinant) if solution and block.determinant is not None else say("screen.numerical")
        if block.meaning != say("determinant.never"):
            tell(say("screen.determinant", determinant=determinant, meaning=block.meaning))
        else:
            tell(say("screen.never_zero", determinant=determinant))
    if closure is None:
        tell(say("screen.no_positions"))
    else:
        key = "screen.closed" if closure.complete else "screen.open"
        tell(say_count(key, len(closure.names)))
    stop = scene.stop
    if stop is None:
        tell(say("screen.possible", end=chosen.time.end))
        return 0
    tell(say("screen.not_possible", kind=stop.name, sentence=stop.sentence))
    if scene.phases:
        tell(scene.phases)
    return 1


def _tell_mobility(run: Run) -> None:
    mobility = run.scene.mechanism.mobility
    if mobility is None:
        return
    sum_of = say("screen.mobility_sum", links=mobility.links, lower=mobility.lower_pairs, higher=mobility.higher_pairs)
    drives = (2 if run.variant.driven else 0) + len(run.variant.known_rates)
    verdict = say("screen.driven", number=drives)
    if drives and mobility.degrees != drives:
        verdict = say("screen.driven_otherwise", drives=drives)
    if not drives:
        verdict = say("screen.as_listed")
    tell(say("screen.mobility", sum_of=sum_of, degrees=mobility.degrees, verdict=verdict))
