"""`coursework accuracy`: the accuracy study of one variant with measured times, on a page and in words.

Used by `cli.py`.
"""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import click

from coursework.api import make_run, variant_of
from coursework.commands.line.screen import in_language, tell, tell_own_file, title_of
from coursework.report.output.formats import chosen
from coursework.report.output.results import StudyResults
from coursework.report.output.write import write_set
from coursework.results.accuracy.record import AccuracyStudy
from coursework.results.accuracy.study import make_study
from coursework.results.accuracy.timing import timed_once
from coursework.run import Run
from coursework.scene.quantities import problem_of
from coursework.system.files.file_set import working_folder
from coursework.words.errors import InputError
from coursework.words.sentences import say


def accuracy_page(variant: str, out: Path | None, formats: tuple[str, ...] | None, language: str) -> int:
    """Write the study and return 0; return 1 if the motion stops, as there is nothing to study."""
    wanted = chosen(formats, "accuracy")
    tell_own_file(variant)
    read = variant_of(variant)
    run = make_run(read, quantities=("accuracy",))
    if run.stop is not None:
        tell(say("screen.nothing_to_study", sentence=run.stop.sentence))
        return 1
    study = timed_study(run)
    folder = out or Path(f"coursework-{read.name}")
    results = StudyResults(replace(run, timed=study), language, live=False)
    results.compute(pages=True)
    with working_folder(folder) as hidden:
        written = write_set(results, wanted, folder, hidden)
    tell(say("screen.error_against_cost", title=title_of(run.variant), name=run.variant.name))
    tell(*(say("screen.note", sentence=sentence) for sentence in (*study.sentences, *study.left_out)))
    tell(*(say("screen.measured_order", name=name, order=order) for name, order in study.orders.items()))
    tell(*(say("screen.spent", label=label, seconds=spent) for label, spent in study.overhead))
    tell(say("screen.reference", label=study.reference_label))
    tell(say("screen.written_to", out=folder, files=", ".join(written)))
    return 0


def timed_study(run: Run) -> AccuracyStudy:
    """Return the study with times, also of imports and the reduction.  Raises `InputError` if the exact motion has no rows."""
    scene = run.scene
    if not scene.follows_laws:  # the study of motion under forces: the error of the energy against the number of slopes
        from coursework.scene.motor_scene import MotorScene

        assert isinstance(scene, MotorScene)
        with click.progressbar(length=30, label=in_language(say("screen.progress.measure")), file=sys.stderr) as bar:
            return scene.energy_study(lambda _label: bar.update(1))
    if not len(run.exact.t):
        raise InputError(say("fault.C022"))
    problem = problem_of(scene.variant, scene.rates, scene.start, scene.exact, scene.closure)
    command = [sys.executable, "-c", "import numpy"]
    imports = timed_once(lambda: subprocess.run(command, check=True))[1]
    reduction = sum(scene.ledger.seconds[name] for name in ("equations", "reduction", "rates"))
    overhead = ((say("study.imports"), imports), (say("study.reduction"), reduction))
    made = scene.results.by_scheme
    with click.progressbar(length=45, label=in_language(say("screen.progress.measure")), file=sys.stderr) as bar:
        return make_study(
            problem, run.exact, made.motion.scheme,
            timed=True, overhead=overhead, progress=lambda _label: bar.update(1),
        )  # fmt: skip
