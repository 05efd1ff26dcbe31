"""One page of every kind, each made once a session: reports, accuracy, a sheet, a key, feedback, both pages of a class.

The data are hard on a page: a long name, one from right to left, cells of seventeen digits.
"""

from __future__ import annotations

from pathlib import Path

import coursework
from coursework.report.pages import build_model, render_html
from tests.command import call
from tests.report.made import model_of, page_of, solved

LONG = "Bartholomew Featherstonehaugh-Cholmondeley von und zu Hohenlohe-Langenburg"
ROSTER = f'id,name,email\nada,Ada Example,a@x.org\nlong,"{LONG}",b@x.org\nright,محمد بن عبد الله,c@x.org\n'
KINDS = ("report", "stopped", "accuracy", "sheet", "key", "assigned", "feedback", "class")


def make(folder: Path) -> dict[str, Path]:
    """Write the pages into a folder; return where each stands."""
    found = {}
    pages = {
        "report": page_of(model_of(solved("31"), live=True)),
        "stopped": page_of(model_of(coursework.solve(coursework.load("31").with_data(given={"alpha": 0.02})), live=True)),
        "accuracy": render_html(build_model(coursework.solve("31", quantities=["accuracy"]))),
    }
    for kind, page in pages.items():
        found[kind] = folder / f"{kind}.html"
        found[kind].write_text(page, encoding="utf-8")
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    call("assign", folder / "roster.csv", "--template", "31", "--seed", "1", "--out", folder / "assigned")
    rows = (folder / "assigned" / "key" / "long.csv").read_text(encoding="utf-8").splitlines()
    handed = folder / "handed" / "long"
    handed.mkdir(parents=True)
    (handed / "table.csv").write_text("\n".join([*rows[:8], rows[8].replace(",", ",9", 4), *rows[9:]]), encoding="utf-8")
    variant = folder / "assigned" / "long.toml"
    call("grade", folder / "handed", "--variant", variant, "--out", folder / "marks", "--jobs", "0")
    return found | {
        "sheet": folder / "assigned/sheets/long.html", "key": folder / "assigned/key/long.html",
        "assigned": folder / "assigned/class.html", "feedback": folder / "marks/feedback/long.html",
        "class": folder / "marks/class.html",
    }  # fmt: skip
