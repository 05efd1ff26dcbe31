"""The Chinese face on paper: every sign of the words is in it, and a page in Chinese is set with it."""

from __future__ import annotations

import pymupdf
from click.testing import CliRunner

from coursework.commands.cli import main
from tests.report.cut_font import FACE, FAMILY, signs_of, wanted


def test_every_wide_sign_of_the_words_is_in_the_face():
    assert sorted(wanted() - signs_of(FACE)) == []


def test_a_page_in_chinese_is_set_in_that_face(tmp_path):
    told = CliRunner().invoke(main, ["run", "31", "--language", "zh", "--format", "pdf", "--out", str(tmp_path)])
    assert "已写入" in told.output and "滚轮、直角构件、曲柄与连杆  (31)" in told.output
    dead = CliRunner().invoke(
        main, ["run", "31", "--language", "zh", "--set", "alpha=0.02rad", "--format", "csv", "--out", str(tmp_path)]
    )
    assert "停止（死点）：在 t = 0.116889 s" in dead.output
    planned = CliRunner().invoke(main, ["run", "31", "--language", "zh", "--plan"])
    assert "graph_check 需要" in planned.output and "各页面需要" in planned.output
    with pymupdf.open(tmp_path / "report.pdf") as paper:
        faces = {face[3].split("+")[-1] for face in paper[0].get_fonts()}
        text = paper[0].get_text()
    assert any(face.lower().startswith(FAMILY.replace(" ", "").lower()) for face in faces)
    assert "平面机构的运动分析" in text and "\ufffd" not in text
