"""`--format figures`: every drawing of the page three times, of the size that the page gives it."""

import io
import json
import re
import struct
from types import SimpleNamespace

import pymupdf
import pytest
from PIL import Image

from coursework.drawing.paper.sheet import HALO
from coursework.report.text.parts import Figure, Panels
from coursework.takeaway.figures.drawings import _with_density, pictures_of
from coursework.variant.catalogue import names
from tests.command import call
from tests.sample import sampled_pairs
from tests.takeaway.taken import results_of, taken

MM = 72 / 25.4  # points
DOTS = 300 / 25.4


# Words in two parts, each of which ends where it stands.
PARTED = re.compile(
    r'(<text x=")([\d.]+)(" y="[\d.]+">)([^<]*)</text><text x="([\d.]+)" y="[\d.]+">(<tspan[^<]*</tspan>)</text></g>'
)


def as_on_the_page(svg):
    """The drawing without the white words behind its words and with words in one, as the page has them for a browser."""
    return PARTED.sub(r"\1\2\3\6\4</text></g>", re.sub(r'<text fill="#fff"[^\n]*?</text>', "", svg))


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "suffix"), sampled_pairs(names(), ["figures"], {("31", "figures"), ("v107", "figures"), ("cardan", "figures")})
)
def test_every_drawing_of_the_page_is_there_as_three_files(name, suffix):
    files = taken(name, suffix)
    parts = [part for section in results_of(name).model.sections for part in section.parts]
    drawings = [part.svg for part in parts if isinstance(part, Figure)]
    drawings += [item.svg for part in parts if isinstance(part, Panels) for item in part.items]
    written = [content.decode() for path, content in files.items() if path.endswith(".svg")]
    assert sorted(map(as_on_the_page, written)) == sorted(one.replace(HALO, "").replace(' class="halo"', "") for one in drawings)
    stems = {path.rpartition(".")[0] for path in files}
    assert set(files) == {f"{stem}.{ending}" for stem in stems for ending in ("svg", "pdf", "png")}


def test_the_time_ends_where_its_unit_begins_in_programs_that_anchor_every_part_by_itself():
    """Of DejaVu Sans: a comma and a space are 0.318 of the height wide, s 0.521; the height is 9 points."""
    svg = taken("31", "figures")["figures/graph-w1.svg"].decode()
    (found,) = PARTED.findall(svg)
    wide = (2 * 0.318 + 0.521) * 9 * 0.3528
    assert found[3] == ", s"
    assert wide <= float(found[1]) - float(found[4]) <= wide + 0.6


def test_sizes_are_those_of_the_page():
    files, parts = taken("31", "figures"), [part for one in results_of("31").model.sections for part in one.parts]
    (sheet,) = [part for part in parts if getattr(part, "id", "") == "graph-check"]
    with pymupdf.open(stream=files["figures/graph-check.pdf"]) as paper:
        assert len(paper) == 1
        assert (paper[0].rect.width, paper[0].rect.height) == pytest.approx((sheet.width * MM, sheet.height * MM), abs=0.1)
        assert "must measure 100 mm" in paper[0].get_text()
    picture = files["figures/graph-check.png"]
    assert struct.unpack(">II", picture[16:24]) == pytest.approx((sheet.width * DOTS, sheet.height * DOTS), abs=1)
    density = picture.index(b"pHYs") + 4
    assert struct.unpack(">IIB", picture[density : density + 9]) == (11811, 11811, 1)  # dots a metre


def test_names_say_what_is_drawn():
    stems = {path.removesuffix(".svg") for path in taken("31", "figures") if path.endswith(".svg")}
    assert stems == {f"figures/{one}" for one in (
        "mechanism", "tangent", "graph-phi1", "graph-phi2", "graph-phi3", "graph-w1", "graph-w2", "graph-w3", "graph-w4",
        "graph-check", "accuracy",
    )}  # fmt: skip


@pytest.mark.usefixtures("folder")
def test_they_are_written_on_request_only_and_listed(folder):
    assert call("run", "31", "--quantities", "table", "--format", "csv,figures", "--out", "taken").exit_code == 0
    record = json.loads((folder / "taken/run.json").read_text(encoding="utf-8"))
    assert {*record["files"]} == {"table.csv", *(f"figures/mechanism.{ending}" for ending in ("svg", "pdf", "png"))}
    there = {path.relative_to(folder / "taken").as_posix() for path in (folder / "taken").rglob("*") if path.is_file()}
    assert there == {*record["files"], "run.json"}


def test_drawings_of_one_name_are_numbered_and_a_name_is_one_of_a_file():
    """A folder of another system takes report and Report for one file, and no sign that means something there."""
    figures = [Figure("<svg/>", 1.0, 1.0, "", [], id=name) for name in ("a", "A", "a", "b/c:d", "..", "a-2")]
    model = SimpleNamespace(sections=[SimpleNamespace(name="laws", parts=[*figures, Figure("<svg/>", 1.0, 1.0, "", [])])])
    assert [*pictures_of(model)] == ["a", "A-2", "a-3", "b-c-d", "drawing", "a-2-2", "laws"]


def test_a_png_says_its_dots_where_a_program_looks_for_them():
    Image.new("RGB", (3, 2), "red").save(content := io.BytesIO(), "PNG")
    with Image.open(io.BytesIO(_with_density(content.getvalue()))) as found:
        found.load()
        assert found.info["dpi"] == pytest.approx((300, 300), abs=0.01) and found.getpixel((2, 1)) == (255, 0, 0)
