"""The animated picture: a frame for every row asked for, no two alike, the same bytes on every run; README's is a small one."""

import io
from pathlib import Path

import pytest
from PIL import Image

import coursework
from coursework.errors import InputError
from coursework.report.moving_picture import label_text, moving_picture
from coursework.report.symbols import symbol
from coursework.sentences import load_phrases

README_PICTURE = Path(__file__).parents[2] / "reports" / "moving.gif"


def picture(**options):
    run = coursework.solve("31", end=0.06, quantities=("table",), **options)
    finer = coursework.solve("31", end=0.06, step=0.01, quantities=("table",))
    return moving_picture(run, finer.exact, load_phrases())


def test_every_frame_is_another_and_the_bytes_are_the_same():
    first = picture()
    with Image.open(io.BytesIO(first)) as moving:
        assert moving.n_frames == 7
        frames = []
        for place in range(moving.n_frames):
            moving.seek(place)
            frames.append(moving.convert("RGB").tobytes())
    assert len({*frames}) == 7
    assert picture() == first
    assert picture(scheme="rk4") != first


def test_a_file_without_points_has_nothing_to_show(tmp_path):
    text = (Path(__file__).parents[2] / "variants" / "31.toml").read_text(encoding="utf-8")
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
