"""An option of the command line that a file quotes can be read off the paper: two hyphens, not a dash."""

import itertools
from dataclasses import replace
from pathlib import Path

import pymupdf

import coursework


def test_two_hyphens_are_two_on_paper(tmp_path: Path) -> None:
    variant = replace(coursework.load("31"), remarks=("Computed with --step h/18.",))
    run = coursework.solve(variant, quantities=["table", "checks"])
    coursework.write_report(run, tmp_path / "report.pdf")
    seen = 0
    for page in pymupdf.open(tmp_path / "report.pdf"):
        for span in page.get_texttrace():
            for one, two in itertools.pairwise(span["chars"]):
                if chr(one[0]) == chr(two[0]) == "-":
                    seen += 1
                    assert one[1] == two[1] > 0, "two letters, and one glyph for both"
    assert seen
