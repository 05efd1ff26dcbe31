"""The animated picture: a frame for every row asked for, no two alike, the same bytes on every run; README's is a small one."""

import io
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

import coursework
from coursework.drawing.outline.poses import read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.report.graphs import moving_picture as moving_picture_module
from coursework.report.graphs.moving_picture import DPI, SETTINGS, Joints, Shape, draw_ground, label_text, moving_picture
from coursework.report.text.symbols import symbol
from coursework.report.text.words import Words
from coursework.words.errors import InputError
from coursework.words.sentences import load_phrases
from tests.mechanisms.library import changed, mechanism

README_PICTURE = Path(__file__).parents[3] / "reports" / "moving.gif"


def picture(**options):
    run = coursework.solve("31", end=0.06, quantities=("table",), **options)
    finer = coursework.solve("31", end=0.06, step=0.01, quantities=("table",))
    return moving_picture(run, finer.exact, load_phrases())


def test_every_frame_is_another_and_the_bytes_are_the_same():
    first = picture()
    assert SETTINGS["font.size"] * DPI / 72 >= 12  # px, as in every graph
    with Image.open(io.BytesIO(first)) as moving:
        assert moving.n_frames == 7
        frames = []
        for place in range(moving.n_frames):
            moving.seek(place)
            frames.append(moving.convert("RGB").tobytes())
    assert len({*frames}) == 7
    assert picture() == first
    assert picture(scheme="rk4") != first


@pytest.fixture(scope="module")
def rack_and_pinion():
    """The lines of variant v112 as pairs of coordinates (m), what stands still before what moves, and its places in row 1."""
    run = coursework.solve("v112", quantities=("table",))
    outline = read_outline(run.scene.mechanism)
    poses = read_poses(outline, run.scene.equations)(run.exact.t, run.exact.coordinates)
    field = Figure().add_subplot()
    draw_ground(field, outline, (poses, poses), 1.0)
    still = [line.get_xydata() for line in field.lines]
    Shape(field, outline, poses, 1.0).show(0, dashed=False)
    return still, [line.get_xydata() for line in field.lines[len(still) :]], poses.pose(0)


@pytest.mark.parametrize(("hinge", "side"), [("D", 1), ("O", -1)])
def test_a_pivot_stands_on_the_side_of_its_ground(rack_and_pinion, hinge, side):
    """The drawing of the assignment hangs D from above, for its link goes down, and stands O on the ground."""
    still, _, places = rack_and_pinion
    x, y = places[hinge].real, places[hinge].imag
    triangles = [line for line in still if len(line) == 4 and np.allclose(line[[0, -1]], (x, y))]
    assert len(triangles) == 1
    assert np.all(side * (triangles[0][1:3, 1] - y) > 0)


def test_a_rack_reaches_its_gear_from_its_slider_and_a_rail_is_hatched_below(rack_and_pinion):
    still, moving, places = rack_and_pinion
    slider, gear = places["C"], places["O"]
    rail = next(line for line in still if len(line) == 2 and np.ptp(line[:, 1]) == 0 and np.ptp(line[:, 0]) > 0.1)
    assert rail[0, 1] < slider.imag
    strokes = [line for line in still if len(line) == 2 and line[0, 1] == rail[0, 1] and np.ptp(line[:, 1]) > 0]
    assert len(strokes) > 5
    assert all(line[1, 1] < line[0, 1] for line in strokes)
    racks = [line for line in moving if len(line) == 5 and line[:, 0].max() > gear.real > slider.real >= line[:, 0].min()]
    assert len(racks) == 1
    assert racks[0][:, 1].max() == pytest.approx(slider.imag)
    assert racks[0][:, 1].min() < slider.imag


def test_a_name_stands_nearer_to_its_own_point_than_to_another():
    """Of two wheels on one line each contact had its name under the pivot beside it, as the name of that."""
    run = coursework.solve(coursework.parse_variant(mechanism("gears-and-crank")), quantities=("table",))
    outline = read_outline(run.scene.mechanism)
    poses = read_poses(outline, run.scene.equations)(run.exact.t, run.exact.coordinates)
    joints = Joints(Figure().add_subplot(), outline, poses)
    joints.show(20)
    pose = poses.pose(20)
    names = dict(zip(joints.names, (complex(*word.get_position()) for word in joints.words), strict=True))
    assert all(abs(names[name] - pose[name]) < abs(names[name] - pose[other]) for name, other in ("OP", "PO", "QK", "KQ"))
    assert all(word.get_path_effects() for word in joints.words)  # a halo, as links sweep over them


LEVER = mechanism(
    "slotted-lever", ("0.1 m", "0.15 m"), ("68.19859051363818 deg", "59.03624346792648 deg"),
    ('D = "', 'O = "(0, 0)"\nD = "'),
    ("[ask]", """[links]
1 = { points = ["O", "A"], rate = "w1" }
2 = { points = ["A"], slides = "3", rate = "w3" }
3 = { points = ["D"], rate = "w3" }
[ask]"""),
)  # fmt: skip


def test_a_lever_that_reaches_beyond_every_point_stays_in_the_window():
    run = coursework.solve(coursework.parse_variant(LEVER), quantities=("table",))
    outline = read_outline(run.scene.mechanism)
    poses = read_poses(outline, run.scene.equations)(run.exact.t, run.exact.coordinates)
    field = Figure().add_subplot()
    shape = Shape(field, outline, poses, moving_picture_module._window(field, outline, (poses, poses)))
    (left, right), (low, high) = field.get_xlim(), field.get_ylim()
    for frame in range(0, len(run.exact.t), 4):
        shape.show(frame, dashed=False)
        x, y = np.vstack([line.get_xydata() for line in field.lines]).T
        assert left < np.nanmin(x) <= np.nanmax(x) < right and low < np.nanmin(y) <= np.nanmax(y) < high


def test_the_graph_shows_what_is_off_within_the_table():
    """The table ends before the motion does; there the driven angle, exact in every row, is farthest from its last row."""
    run, longer = (coursework.solve(coursework.parse_variant(LEVER), end=end, quantities=("table",)) for end in (0.9, 1.0))
    axes = Figure().add_subplot()
    moving_picture_module._graph(axes, run, run.motion, longer.exact, Words(load_phrases()))
    assert axes.get_title(loc="left").startswith("th")


def test_a_file_without_points_has_nothing_to_show(tmp_path):
    text = (Path(__file__).parents[3] / "variants" / "31.toml").read_text(encoding="utf-8")
    bare = tmp_path / "bare.toml"
    kept = text.partition("[points]")[0] + '[ask]\nquantities = ["table"]\n'
    bare.write_text(kept, encoding="utf-8")
    run = coursework.solve(coursework.load(bare))
    with pytest.raises(InputError, match="places no points"):
        moving_picture(run, run.exact, load_phrases())


def test_the_picture_of_the_readme_moves_and_is_small():
    assert README_PICTURE.stat().st_size < 1_000_000
    with Image.open(README_PICTURE) as moving:
        assert moving.n_frames == 49


def test_symbols_without_a_unicode_subscript_are_set_by_our_own_table():
    assert label_text(symbol("w3")) == "ω₃"
    assert label_text(symbol("VMx")) == r"$V_{\mathrm{Mx}}$"
    assert "$" not in label_text(symbol("speed"))


def test_a_motion_that_stops_at_its_first_row_is_told_with_the_stop():
    """The crank of 0.4 m is turned away from D, 1.2 m from A: rods of 1 m and 0.6 m are stretched there."""
    text = coursework.load("example-1").path.read_text(encoding="utf-8")
    text = changed(text, ('"0 deg"', '"180 deg"'), ('r3 = "0.7 m"', 'r3 = "0.6 m"'))
    run = coursework.solve(coursework.parse_variant(text), quantities=("table",))
    with pytest.raises(InputError, match=r"D037 .* At the very first row, t = 0, the equations for w2 and w3 become singular"):
        moving_picture(run, run.exact, load_phrases())
