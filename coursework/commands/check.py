"""`coursework check`: what a file contains and whether its motion is possible, before anything is integrated.

Used by `cli.py`.
"""

from __future__ import annotations

from coursework.api import make_run, variant_of
from coursework.commands.contradictions import terms_named
from coursework.commands.line.screen import tell, tell_own_file, title_of
from coursework.commands.mobility import of_mobility
from coursework.commands.run_on_screen import tell_remarks
from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.textbook.cramer import cramer
from coursework.motion.singular.lines import always_told
from coursework.results.checks.computed_right.beginning import start_of
from coursework.results.checks.computed_right.equations import open_to_doubt, proposed_ties, unlike_links
from coursework.run import Run
from coursework.scene.quantities import ANALOGS, ENERGY, FORCES, GRAPH_CHECK, INVARIANTS
from coursework.scene.scene import Scene
from coursework.variant.formula.made import as_read
from coursework.variant.record.held import followed
from coursework.words.sentence import Sentence
from coursework.words.sentences import say, say_count


def check_variant(variant: str) -> int:
    """Print the results; return 0 if the whole motion is possible, 1 if it stops or its start is not a closed position."""
    tell_own_file(variant)
    run = make_run(variant_of(variant))
    with terms_named(run.variant):
        return _tell(run)


def _tell(run: Run) -> int:
    chosen = run.variant
    tell(f"{title_of(chosen)}  ({chosen.name}, {chosen.path})")
    tell_remarks(run)
    scene = run.scene
    equations, reduction = scene.equations, scene.reduction
    wanted = {*run.asked} | ({FORCES.name} if chosen.motor is not None or ENERGY.name in run.asked else set())
    for one in (FORCES, ANALOGS, INVARIANTS, GRAPH_CHECK):
        if one.name in wanted and len(scene.motion.t):
            run.of(one)  # raises what `run` would find wrong with masses and forces, or with what it draws or tables
    free = chosen.motor.rates if chosen.motor is not None else ()
    if chosen.sought:  # if forces move each link by itself, nothing is left to solve
        helping = {name for law in chosen.drive for formula in law.formulas for name in formula.names()}
        helping -= {*chosen.rates, *followed(chosen)}
        drives = sum(law.name not in helping for law in chosen.drive) - len(free)
        size = {"number": len(chosen.sought), "equations": len(equations.equations), "drives": drives}
        tell(say("screen.counts", **size, unknowns=", ".join(chosen.sought)))
    if free:
        tell(say_count("dynamics.free", len(free), rates=", ".join(free)))
    tell(*of_mobility(run))
    closure = scene.closure
    tell(*reduction.notes)
    _tell_blocks(scene)
    if closure is None:
        tell(say("screen.all_free" if free else "screen.no_positions"))
        for told in () if free else (unlike_links(equations, scene.motion), *proposed_ties(equations, scene.start)):
            if told is not None:
                tell(told)
    elif not closure.names:
        tell(say("screen.all_driven"))
    else:
        key = "screen.closed" if closure.complete else "screen.open"
        tell(say_count(key, len(closure.names)))
        at_once = scene.stop is not None and not scene.stop.time  # a dead point at the start hides the result of the geometry
        if not at_once and (doubt := open_to_doubt(closure)):
            if (unlike := unlike_links(equations, scene.motion)) is not None:
                tell(unlike)
            tell(doubt[0])
    begun = start_of(closure)
    if begun.sentence not in {say("check.START.pass"), say("check.START.skip")}:
        tell(begun.sentence)
    stop = scene.stop
    if stop is None:
        if begun.verdict == "FAIL":
            return 1  # links that do not close cannot move
        tell(say("screen.possible", end=chosen.time.end))
        tell(*scene.passed)
        return 0
    tell(say("screen.not_possible", kind=stop.name, sentence=stop.sentence))
    if scene.phases:
        tell(scene.phases)
    return 1


def _tell_blocks(scene: Scene) -> None:
    pairs = cramer(scene.equations, scene.reduction, [bool(solution) for solution in scene.solutions])
    for place, (block, solution, pair) in enumerate(zip(scene.reduction.blocks, scene.solutions, pairs, strict=True)):
        tell(say("screen.block", unknowns=tuple(block.unknowns), equations=tuple(block.equations)))
        for name, formula in solution:
            tell(f"    {name} = {as_read(formula)}")
        found = pair.determinant if pair is not None else block.determinant  # of a pair with the signs of the page
        determinant = as_read(found) if solution and found is not None else say("screen.numerical")
        if block.meaning != say("determinant.never"):
            lines = always_told(scene.flow, scene.closure, place, block) if block.meaning == _bare(block) else None
            meaning = lines or block.meaning
            tell(say("screen.determinant", determinant=determinant, meaning=meaning))
        else:
            tell(say("screen.never_zero", determinant=determinant))


def _bare(block: Block) -> Sentence:
    """Return what is said of a block where nothing is known of the lines of its links."""
    if block.condition is None:
        return say("determinant.large", count=block.size, names=", ".join(block.equations))
    return say("determinant.zero", formula=as_read(block.condition))
