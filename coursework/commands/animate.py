"""`coursework animate`: the moving mechanism as one animated picture, for a slide or a page.

Enters: a variant.  Leaves: NAME.gif, or the file of --out.  Used by `cli.py`.
"""

from __future__ import annotations

from pathlib import Path

from coursework.api import make_run, variant_of
from coursework.commands.line.screen import tell, tell_own_file
from coursework.system.files.whole_files import write_bytes, wrong_ending
from coursework.words.sentences import load_phrases, say

FRAMES_A_ROW = 2


def animate_variant(variant: str, out: Path | None, scheme: str | None, language: str) -> int:
    """Write the picture and return 0."""
    from coursework.report.graphs.moving_picture import moving_picture

    if out is not None and out.suffix.lower() != ".gif":
        raise wrong_ending(out, ".gif")
    tell_own_file(variant)
    read = variant_of(variant)
    run = make_run(read, scheme, quantities=("table",))
    finer = make_run(read, scheme, step=run.step / FRAMES_A_ROW, quantities=("table",))
    path = out or Path(f"{read.name}.gif")
    picture = moving_picture(run, finer.exact, load_phrases(language))
    write_bytes(path, picture)
    tell(say("screen.animated", path=str(path), size=len(picture) / 1000))
    return 0
