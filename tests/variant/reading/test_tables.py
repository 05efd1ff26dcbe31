"""A law as a table beside the variant file: what is read, and that nothing outside the folder is."""

import os
from contextlib import nullcontext

import numpy as np
import pytest

import coursework
from coursework.variant.reading import tables
from tests.commands.test_cli import call

TEXT = """[given]
l = "0.4 m"
[drive]
w1 = "1"
[coordinates]
phi1 = { start = "0.3 rad", rate = "w1" }
[unknowns]
u = "m/s"
[functions]
r = { table = "TABLE", of = "phi1" }
[time]
step = "0.01 s"
end = "0.1 s"
[[constraint]]
equation = "u = r*w1"
"""
NODES = [(k / 10, 0.1 + k**3 / 1e4) for k in range(11)]
ROWS = [f"{a},{b:.17g}" for a, b in NODES]


@pytest.fixture
def law(tmp_path):
    """Return a function that gives u(t) of the first row with a table of the given bytes."""

    def first(content, name="r.csv"):
        (tmp_path / "r.csv").write_bytes(content)
        (tmp_path / "v.toml").write_text(TEXT.replace("TABLE", name), encoding="utf-8")
        return coursework.solve(tmp_path / "v.toml", quantities=["table"]).motion.column("u")

    return first


@pytest.mark.parametrize(
    "content",
    [
        "\n".join(["phi1,r", *ROWS]).encode(),
        "\n".join(ROWS).encode(),
        "\n".join(["phi1,r", *ROWS[:2], " ", "", *ROWS[2:6], ",", *ROWS[6:], ""]).encode(),
        b"\xef\xbb\xbf" + "\r\n".join(["angle,length", *ROWS, "", ",,", ""]).encode(),
        "\n".join(["phi1 (rad),r [m]", *(" , ".join(row.split(",")) for row in ROWS)]).encode(),
        "\n".join(["phi1,r", *(",".join(f'"{cell}"' for cell in row.split(",")) for row in ROWS)]).encode(),
    ],
    ids=["header", "no header", "blank lines", "Excel", "spaces", "quotes"],
)
def test_the_same_table_in_every_dialect(law, content):
    angles = 0.3 + np.arange(11) * 0.01
    assert law(content) == pytest.approx(0.1 + (angles * 10) ** 3 / 1e4, abs=1e-15)  # a cubic lies on the quartics


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"\xff\xfe\x00", 'the table "r.csv" is not UTF-8 text. Save it as "CSV UTF-8".'),
        (b"", "r.csv: at least 5 nodes were expected (the five-point formulas), found 0."),
        (b"phi1,r\n" + b"0,1\n" * 100_000, 'the table "r.csv" has 400007 bytes; at most 262144 are read.'),
        (b"0,1\n0.1,1e999\n", "r.csv:2: finite numbers were expected."),
        (b"0,1\n0.1,1_000\n", "r.csv:2: two numbers with a comma between were expected, decimals with a point."),
        (b"0,1\n0.1,nan\n", "r.csv:2: two numbers with a comma between were expected, decimals with a point."),
        ("0,1\n0.1,٣\n".encode(), "r.csv:2: two numbers with a comma between were expected, decimals with a point."),
        (b"phi1 [rad],r [mm]\n0,1\n", "r.csv:1: the header says mm, and the numbers of a table are read in SI. Write them in m,"),
        ("угол (град),r\n0,1\n".encode(), "r.csv:1: the header says град, and the numbers of a table are read in SI."),
        (b'"phi1 deg","r"\n0,1\n', "r.csv:1: the header says deg, "),
        (b"t_s,w_rpm\n0,1\n", "r.csv:1: the header says rpm, and the numbers of a table are read in SI. Write them in rad/s,"),
        (b"0,1,2\n", "r.csv:1: two numbers with a comma between were expected, decimals with a point."),
        (
            "\n".join([*ROWS[:4], ROWS[3], *ROWS[4:]]).encode(),
            "r.csv:5: the arguments must increase from line to line, found 0.3 after 0.3.",
        ),
    ],
    ids=["bytes", "empty", "large", "infinite", "underscore", "nan", "digits", "mm", "град", "deg", "rpm", "columns", "twice"],
)
def test_what_is_no_table(law, content, sentence):
    with pytest.raises(coursework.InputError) as caught:
        law(content)
    assert "v.toml:10:15  functions.r.table: " in str(caught.value)
    assert sentence in str(caught.value)


@pytest.mark.parametrize("form", [".8g", ".8f", ".6f", ".17g", ".8e"])
def test_arguments_printed_with_eight_digits_are_equally_spaced(law, form):
    """A degree has no end of digits in radians: what a print rounds off is no unevenness."""
    angles = np.radians(np.arange(10.0, 25.0, 0.5))
    rows = [f"{angle:{form}},{0.1 + angle**3:.17g}" for angle in angles]
    error = law("\n".join(["phi1,r", *rows]).encode()) - (0.1 + (0.3 + np.arange(11) * 0.01) ** 3)
    assert np.max(np.abs(error)) < 3e-7


def test_an_exponent_of_thousands_of_digits_is_a_number(law):
    rows = [f"0e{'9' * 5000},1", *(f"{k / 10},1" for k in range(1, 9))]
    assert law("\n".join(rows).encode()) == pytest.approx(1)


def test_unevenness_is_told_just_outside_the_printed_digits(law):
    """Half a unit of the last place for the node and half for the ends."""
    even = [f"{k * 0.1:.5f},{k}" for k in range(5)]
    law("\n".join([*even[:2], "0.20001,2", *even[3:], "0.50000,5"]).encode())
    with pytest.raises(coursework.InputError, match=r"r\.csv:[34]: .* found a step of 0\.(10002|09998) where 0\.1 is usual\."):
        law("\n".join([*even[:2], "0.20002,2", *even[3:], "0.50000,5"]).encode())


@pytest.mark.parametrize(("step", "right"), [(0.0105, True), (0.0095, False)])
def test_digits_too_few_for_slopes_are_told(law, step, right):
    """Five decimals put a node up to 0.000 01 off, which must be no more than a thousandth of a step."""
    rows = [f"{0.29 + step * k:.5f},{k}" for k in range(30)]
    rows[7] = f"{0.29 + step * 7 + 0.00001:.5f},7"
    if right:
        law("\n".join(rows).encode())
        return
    with pytest.raises(coursework.InputError, match="the arguments must be equally spaced, found a step of"):
        law("\n".join(rows).encode())


@pytest.mark.parametrize("name", ["../secret.csv", "/etc/hostname.csv", "link.csv", "linked/secret.csv", "./../secret.csv"])
def test_nothing_outside_the_folder_is_read(tmp_path, name):
    inside = tmp_path / "inside"
    inside.mkdir()
    (tmp_path / "secret.csv").write_text("\n".join(ROWS), encoding="utf-8")
    (inside / "link.csv").symlink_to(tmp_path / "secret.csv")
    (inside / "linked").symlink_to(tmp_path)
    (inside / "v.toml").write_text(TEXT.replace("TABLE", name), encoding="utf-8")
    with pytest.raises(coursework.InputError) as caught:
        coursework.load(inside / "v.toml")
    sentence = f'the table "{name}" lies outside the folder of the variant. Put it beside the variant file.'
    assert str(caught.value).endswith(sentence)


def test_a_link_inside_the_folder_and_a_folder_below_are_read(tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "r.csv").write_text("\n".join(ROWS), encoding="utf-8")
    (tmp_path / "v.toml").write_text(TEXT.replace("TABLE", "data/r.csv"), encoding="utf-8")
    assert coursework.load(tmp_path / "v.toml").functions[0].table == tuple(NODES)


@pytest.mark.parametrize("name", ["", ".", "nowhere.csv", "a\\u0000b.csv", "x" * 295 + ".csv", "secret.toml", "/dev/zero"])
def test_names_that_are_no_file(tmp_path, name):
    (tmp_path / "v.toml").write_text(TEXT.replace("TABLE", name), encoding="utf-8")
    with pytest.raises(coursework.InputError, match=r"functions\.r\.table: "):
        coursework.load(tmp_path / "v.toml")


def test_a_link_that_leads_to_itself_is_no_file_and_no_fault_of_the_tool(tmp_path, monkeypatch):
    (tmp_path / "loop.csv").symlink_to("loop.csv")
    (tmp_path / "v.toml").write_text(TEXT.replace("TABLE", "loop.csv"), encoding="utf-8")
    with pytest.raises(coursework.InputError, match=r'functions\.r\.table: there is no file "loop\.csv"'):
        coursework.load(tmp_path / "v.toml")
    (tmp_path / "w.toml").symlink_to("w.toml")
    told = call("run", str(tmp_path / "w.toml"), str(tmp_path / "v.toml"), "--out", str(tmp_path / "out"))
    assert told.exit_code == 2 and "the file cannot be read: Too many levels of symbolic links" in told.stdout + told.stderr
    monkeypatch.chdir(tmp_path)
    assert "Too many levels of symbolic links" in call("check", "w").stderr  # and not: there is no variant "w", did you mean "w"?
    (tmp_path / "work").mkdir()
    told = call("grade", str(tmp_path / "work"), "--variant", "31", "--out", str(tmp_path / "loop.csv" / "out"))
    assert told.stderr.startswith("W012")


def test_a_table_needs_a_file_beside_it():
    from coursework.variant.reading.reader import parse_variant

    with pytest.raises(coursework.InputError, match=r'the table "r\.csv" is not among the files beside the variant'):
        parse_variant(TEXT.replace("TABLE", "r.csv"))


def test_no_line_of_a_file_is_quoted(law):
    """Whatever is named as a table, and however it got its name, nothing of it is told."""
    with pytest.raises(coursework.InputError) as caught:
        law(b"root:x:0:0,secret,words\n" * 9)
    assert "secret" not in str(caught.value)
    assert "root:" not in str(caught.value)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no such files")
@pytest.mark.parametrize("device", ["fifo", "/dev/zero"])
def test_files_that_never_end_are_no_tables_and_no_variants(tmp_path, device):
    path = tmp_path / "r.csv"
    if device == "fifo":
        os.mkfifo(path)
    else:
        path.symlink_to(device)
    (tmp_path / "v.toml").write_text(TEXT.replace("TABLE", "r.csv"), encoding="utf-8")
    with pytest.raises(
        coursework.InputError,
        match=r'v\.toml:10:15  functions\.r\.table: (the table "r\.csv" is no ordinary file|the table "r\.csv" lies)',
    ):
        coursework.load(tmp_path / "v.toml")
    with pytest.raises(coursework.InputError, match="this is not a file with text in it"):
        coursework.load(path)


@pytest.mark.parametrize(("nodes", "told"), [(20_000, ""), (20_001, "r.csv: 20001 nodes; at most 20000 are read.")])
def test_a_table_has_at_most_twenty_thousand_nodes(tmp_path, nodes, told):
    (tmp_path / "r.csv").write_text("\n".join(f"{k},1" for k in range(nodes)), encoding="utf-8")
    (tmp_path / "v.toml").write_text(TEXT.replace("TABLE", "r.csv"), encoding="utf-8")
    if not told:
        assert len(coursework.load(tmp_path / "v.toml").functions[0].table) == nodes
        return
    with pytest.raises(coursework.InputError, match=told):
        coursework.load(tmp_path / "v.toml")


@pytest.mark.parametrize("scheme", ["euler", "rk4"])
def test_an_equation_without_a_value_between_two_nodes_is_told_as_that(tmp_path, scheme):
    """r is 0.1027 m at 0.3 rad, 0.1064 m at 0.4 rad; it was taken to be that of the node before, where the root has a value."""
    (tmp_path / "r.csv").write_text("\n".join(["phi1,r", *ROWS]), encoding="utf-8")
    text = TEXT.replace("u = r*w1", "u = w1*sqrt(k^2 - r^2)").replace("[given]", '[given]\nk = "0.104 m"')
    (tmp_path / "v.toml").write_text(text.replace("TABLE", "r.csv"), encoding="utf-8")
    with pytest.raises(
        coursework.InputError, match=r"V019 .*constraint 1, column 8: there is no value at t = 0.04.* is no real n"
    ):
        _ = coursework.solve(tmp_path / "v.toml", scheme=scheme).motion


@pytest.mark.parametrize(("nodes", "told"), [(4, "at least 5"), (5, ""), (7, ""), (8, "at most 7")])
def test_a_table_has_five_nodes_at_least_and_as_many_as_are_allowed(nodes, told, monkeypatch):
    monkeypatch.setattr(tables, "MOST_NODES", 7)
    with pytest.raises(tables.TableFault, match=told) if told else nullcontext():
        assert len(tables._rows("r", "".join(f"{place},1\n" for place in range(nodes)))) == nodes


def test_a_table_has_a_quarter_of_a_megabyte_at_most():
    tables._require_size("r", 2**18)
    with pytest.raises(tables.TableFault, match="262145"):
        tables._require_size("r", 2**18 + 1)
