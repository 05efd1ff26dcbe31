"""`--format dxf`: scheme, twelve positions, graph-analytical check and plans for a drawing office.

Enters: `Results`.  Leaves: one DXF file (AutoCAD 2010) per drawing, in mm at the scale of its sheet; links, joints, ground,
velocities, dimensions and text have their own layers, arrows are leaders, hatching is a hatch.
Used by the list of formats, by name.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from coursework.drawing.paper.sheet import HALO
from coursework.report.output.results import Results
from coursework.scene.quantities import TRAJECTORIES
from coursework.system.extras import require
from coursework.takeaway.figures.drafting import Draft
from coursework.takeaway.figures.drawings import Picture, pictures_of
from coursework.takeaway.figures.shapes import shapes_of
from coursework.words.errors import CourseworkError, NotToBeHad
from coursework.words.sentences import say

FOLDER = "dxf"


def write(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of each drawing.  Raises `NotToBeHad` if there are no drawings, or no ezdxf."""
    require("ezdxf", "dxf", "dxf")
    drawings = {name: one for name, one in _pictures(results).items() if HALO in one.svg}
    if not drawings:
        raise NotToBeHad(say("fault.W042"))
    for name, one in drawings.items():
        yield f"{FOLDER}/{name}.dxf", dxf_of(one)


def _pictures(results: Results) -> dict[str, Picture]:
    """Return the drawings of the page, and the twelve positions if the mechanism has them, even if they were not asked for."""
    found = pictures_of(results.model)
    if not results.run.asks(TRAJECTORIES):
        with suppress(CourseworkError, ArithmeticError):
            for one in results.run.of(TRAJECTORIES):
                found[one.id] = Picture(one.id, one.svg, one.width, one.height, str(one.alt))
    return found


def dxf_of(picture: Picture) -> bytes:
    """Return a drawing as DXF; the same drawing always gives the same bytes."""
    import ezdxf

    options: Any = ezdxf.options  # type: ignore[attr-defined]  # it exists, but is not declared
    kept = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True  # else the file has the time and a random id
    try:
        draft = Draft(picture.width, picture.height)
        for shape in shapes_of(picture.svg, picture.height):
            draft.draw(shape)
        for kind in sorted(draft.document.entitydb.dxf_types_in_use()):
            draft.document.classes.add_class(kind)  # else they stand in the order of a set, which differs between processes
        text = io.StringIO()
        draft.document.write(text)
    finally:
        options.write_fixed_meta_data_for_testing = kept
    return text.getvalue().encode("utf-8", "surrogateescape")
