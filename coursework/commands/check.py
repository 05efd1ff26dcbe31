"""`coursework check`: what a file says and whether its motion is possible, before anything is integrated."""

from __future__ import annotations

import click

from coursework.api import load, solve
from coursework.commands.run import tell_remarks
from coursework.formula.tree import spelled
from coursework.run import Run
from coursework.sentences import listing, say


def check_variant(variant: str) -> int:
    """Return 0 where the whole motion is possible, 1 where it stops."""
    run = solve(load(variant))
    chosen = run.variant
    click.echo(f"{chosen.title}  ({chosen.name}, {chosen.path})")
    tell_remarks(run)
    scene = run.scene
    equations, reduction = scene.equations, scene.reduction
    count = len(chosen.sought)
    click.echo(
        f"{count} unknown velocities ({', '.join(chosen.sought)}), {len(equations.equations)} equations, "
        f"{len(chosen.drive)} drive(s)"
    )
    _tell_mobility(run)
    closure = scene.closure
    for note in reduction.notes:
        click.echo(note)
    for block, solution in zip(reduction.blocks, scene.solutions, strict=True):
        click.echo(f"  {listing(block.unknowns)} from {listing(block.equations)}:")
        for name, formula in solution:
            click.echo(f"    {name} = {spelled(formula)}")
        determinant = spelled(block.determinant) if block.determinant is not None else "numerical"
        click.echo(
            f"    determinant {determinant}: zero when {block.meaning}"
            if block.meaning != say("determinant.never")
            else f"    determinant {determinant}: never zero"
        )
    if closure is None:
        click.echo("No position equations: the exact motion comes from a refined scheme.")
    else:
        state = "determine every coordinate" if closure.complete else "do not determine every coordinate"
        click.echo(f"{len(closure.names)} position equation(s) {state}.")
    stop = scene.stop
    if stop is None:
        click.echo(f"The whole motion, 0 to {chosen.time.end:g} s, is possible: no dead point.")
        return 0
    click.echo(f"Not the whole motion is possible ({stop.kind}): {stop.sentence}")
    if scene.phases:
        click.echo(scene.phases)
    return 1


def _tell_mobility(run: Run) -> None:
    mobility = run.scene.mechanism.mobility
    if mobility is None:
        return
    sum_of = f"3·{mobility.links} − 2·{mobility.lower_pairs} − {mobility.higher_pairs}"
    drives = (2 if run.variant.driven else 0) + len(run.variant.known_rates)
    verdict = f"as many as the {drives} freedom(s) driven"
    if drives and mobility.degrees != drives:
        verdict = (
            f"but {drives} are driven. The equations decide and determine every velocity; either [links] and [frame] leave out a "
            "pair (a sleeve, a rack), or the mechanism moves only by its special dimensions"
        )
    if not drives:
        verdict = "of the links as listed"
    click.echo(f"Mobility W = {sum_of} = {mobility.degrees}, {verdict}.")
