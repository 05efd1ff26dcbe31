"""All faults of a file at once, each in the words of the file, and none that only follows from another."""

import re
from types import SimpleNamespace

import pytest

import coursework
from coursework.variant.formula.reader import parse
from coursework.variant.judging import at_start
from coursework.variant.reading.reader import parse_variant
from tests.command import call
from tests.mechanisms.library import mechanism

# A shaper with slotted lever and a rod to its ram, which is in no file of the catalogue.
SHAPER = mechanism(
    "shaper", ('"0 deg"', '"70 deg"'), ('coordinates = ["phi4", "x"]\nmode = "+1"', 'coordinates = ["phi4", "x"]\nmode = "-1"'),
    step="1/90", end="0.5 s", period=None, rails=None, quantities='["table"]',
)  # fmt: skip
# The code that a slip must be told with, whatever else is wrong: what stands there, and what is put in its place.
SLIPS = {
    "V106": ('b = "0.30 m"', 'b = "0,30 m"'),
    "V053": ('w1 = "n"', 'w1 = "n1"'),
    "V011": ('rate = "vx", unit', 'rate = "vx", unitt'),
    "V015": ('s = { rate = "u", unit = "m" }', 's = "0.3 m"'),
    "V160": ('step = "1/90"', 'step = "1/90 s"'),
    "V050": ('K = "(0, yg-d)"', 'K = "yg"'),
    "V343": ('from = ["B", "D"]', 'from = ["B"]'),
    "V307": ('mode = "-1"', ""),
}
GUIDE = 'guide = { through = "K", angle = "0" }'


def told(text):
    """Return what is said of a file, a line each."""
    with pytest.raises(coursework.InputError) as caught:
        parse_variant(text, "shaper.toml")
    return str(caught.value).splitlines()


def codes(text):
    return sorted(line[:4] for line in told(text))


def spoilt(*slips):
    text = SHAPER
    for slip in slips:
        assert SLIPS[slip][0] in text
        text = text.replace(*SLIPS[slip])
    return text


def test_the_file_itself_has_no_fault_and_runs():
    assert coursework.solve(parse_variant(SHAPER, "shaper")).stop is None


@pytest.mark.parametrize("slip", SLIPS)
def test_one_slip_is_one_fault(slip):
    assert codes(spoilt(slip)) == [slip]


@pytest.mark.parametrize("first", SLIPS)
@pytest.mark.parametrize("second", SLIPS)
def test_two_slips_are_two_faults(first, second):
    if first < second:
        assert codes(spoilt(first, second)) == [first, second]


def test_slips_of_every_layer_are_told_at_once_in_the_order_of_the_file():
    found = told(spoilt(*SLIPS))
    assert sorted(line[:4] for line in found) == sorted(SLIPS)
    lines = [int(re.search(r"shaper\.toml:(\d+)", line)[1]) for line in found]
    assert lines == sorted(lines)


def test_a_dimension_is_told_beside_the_faults_of_other_layers():
    text = spoilt("V343", "V053").replace('r1 = "0.10 m"', 'r1 = "0.10 s"')
    assert codes(text) == ["V053", "V205", "V343"]


def test_a_mode_is_asked_for_with_the_points_of_the_file():
    text = SHAPER.replace('kind = "RRP"', 'kind = "RRR"').replace('from = ["E"]', 'from = ["E", "K"]')
    text = text.replace(GUIDE, "").replace('["b"]', '["b", "b"]').replace(', unit = "m"', "")
    (line,) = told(text.replace('mode = "-1"', ""))
    assert 'mode = "+1" (F to the left of the ray from E to K) or mode = "-1" (F to its right)' in line


def test_what_a_list_lacks_is_said_with_its_grammar():
    (line,) = told(spoilt("V343"))
    assert line.endswith("group 2: RPR takes 2 points in from (found 1). Missing: D: the pivot of the rod.")
    (line,) = told(SHAPER.replace('from = ["E"]', "from = []"))
    assert "RRP takes 1 point in from (found 0). Missing: B: the known point that the rod hangs on." in line
    (line,) = told(SHAPER.replace('from = ["E"]', 'from = ["E", "K"]'))
    assert "(found 2). In this order: E: the known point" in line


def test_a_list_over_two_lines_is_told_at_its_slip_alone():
    (line,) = told(SHAPER.replace('from = ["E"]', 'from = ["E",\n    "K +"]'))
    assert line.startswith("V114 ")


def test_a_table_of_keys_says_which():
    (line,) = told(SHAPER.replace(GUIDE, 'guide = "K"'))
    assert "a table { through = …, angle = …, offset = … } was expected" in line
    (line,) = told(spoilt("V015"))
    assert "a table { start = …, rate = …, unit = … } was expected" in line


@pytest.mark.parametrize(
    ("written", "advised"),
    [("1/90 s", "1/90"), ("1000/90 ms", "0.001*(1000/90)"), ("2*pi/(90*n) s", "2*pi/(90*n)")],
)
def test_a_formula_with_a_unit_behind_it(written, advised):
    (line,) = told(SHAPER.replace('step = "1/90"', f'step = "{written}"'))
    assert line.endswith(f'Write "{advised}".')
    for end, rows in (("4/3", 120), ("4", 360)):
        mended = parse_variant(re.sub('end = ".*"', f'end = "{end}"', SHAPER.replace('"1/90"', f'"{advised}"')), "shaper")
        assert mended.time.steps == rows or "n" in advised


def test_a_start_is_told_in_the_unit_that_was_typed():
    free, text = "phi3 = { rate =", 'phi3 = { start = "70 deg", rate ='
    with pytest.raises(coursework.InputError, match=r"phi3 = 70 deg does not close the chain: .* at 84") as caught:
        coursework.solve(parse_variant(SHAPER.replace(free, text), "shaper")).motion  # noqa: B018
    closed = re.search(r"begins at (\S+) deg", str(caught.value))[1]
    mended = parse_variant(SHAPER.replace(free, text.replace("70", closed)), "shaper")
    assert coursework.solve(mended).stop is None


def test_a_group_that_cannot_close_names_the_points_of_the_file():
    short = parse_variant(SHAPER.replace('b = "0.30 m"', 'b = "0.001 m"'), "s")
    with pytest.raises(coursework.InputError, match=r"RRP \(E\) cannot be assembled at t = 0 s: E is 0\.\d+ m from the line"):
        coursework.solve(short).motion  # noqa: B018


DRIVEN = mechanism(
    "two-arms", ('"20 deg"', '"100 deg"'), ('"80 deg"', '"-15 deg"'),
    ("[drive]", 'V = "0.1 m/s"\np = "60 rpm"\nbeta = "20 deg"\n[drive]\nVBx = "V*cos(beta)*sin(p*t)"'),
    ("[coordinates]", 'VBy = "V*sin(beta)*sin(p*t)"\n[coordinates]'),
    ('hinges = ["O"]', 'hinges = ["O"]\nrails = [{ through = "B", angle = "beta" }]\n[closure]\ndriven = "B"'), r1="0.30 m",
    r2="0.40 m", w1=None, w2=None, step="0.02 s",
)  # fmt: skip


@pytest.mark.parametrize("angle", ["20 deg", "0 deg", "90 deg"])
def test_a_driven_point_on_a_guide_is_told_the_way_and_the_way_leads_there(angle, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    driven = (
        DRIVEN.replace("20 deg", angle) if angle == "20 deg" else DRIVEN.replace("20 deg", angle).replace('"beta"', f'"{angle}"')
    )
    (tmp_path / "slider.toml").write_text(driven, encoding="utf-8")
    told = call("check", "slider").stdout
    assert "= 1, but 2 are driven: the guide through B leaves it one velocity" in told
    coordinate = re.search(r"Write (.*?) in \[coordinates\]", told)[1]
    drive = re.search(r', (uB = ".*?") in \[drive\]', told)[1]
    holds = re.search(r"(holds = \[.*?\])", told)[1]
    text = driven.replace("[coordinates]\n", f"[coordinates]\n{coordinate}\n").replace("[drive]\n", f"[drive]\n{drive}\n")
    (tmp_path / "mended.toml").write_text(text.replace('driven = "B"', holds), encoding="utf-8")
    assert "= 1, as many as the one freedom driven." in call("check", "mended").stdout
    before, after = (coursework.solve(name, scheme="exact").table for name in ("slider", "mended"))
    assert abs(before[["phi1", "phi2"]] - after[["phi1", "phi2"]]).to_numpy().max() < 1e-9


def test_what_nobody_can_ask_for_is_told_with_all_other_faults(tmp_path):
    """The name of a quantity and that of a column, beside a unit that is wrong and a point that is none."""
    asked = SHAPER.replace('["table"]', '["table", "hodograph", "s",\n  "w33"]')
    text = asked.replace('K = "(0, yg-d)"', 'K = "yg"').replace('"0.5 s"', '"0.5 m"')
    (tmp_path / "shaper.toml").write_text(text, encoding="utf-8")
    lines = {line.partition(" = ")[0].strip(): number for number, line in enumerate(text.splitlines(), 1)}
    for command in ("check", "run"):
        told = call(command, tmp_path / "shaper.toml", *(["--out", tmp_path / "out"] if command == "run" else []))
        assert told.exit_code == 2
        found = [(line[:4], int(re.search(r"toml:(\d+)", line)[1])) for line in told.stderr.splitlines()]
        assert {("C002", lines["quantities"]), ("C002", lines["quantities"] + 1)} <= {*found}
        assert {line for _, line in found} >= {lines["K"], lines["end"]}
        assert 'there is no quantity "hodograph". Did you mean "hodographs"? Known: table, plots' in told.stderr
        assert '"s"' not in told.stderr.replace('coordinates = ["phi3", "s"]', "")


def test_a_time_that_could_not_be_read_hides_no_point_that_is_none(tmp_path):
    text = SHAPER.replace('"0.5 s"', "true").replace('K = "(0, yg-d)"', 'K = "Z + (0, yg-d)"')
    (tmp_path / "shaper.toml").write_text(text, encoding="utf-8")
    told = call("check", tmp_path / "shaper.toml").stderr
    assert "end" in told and "Z" in told


def test_of_columns_that_could_not_be_read_nothing_is_said(tmp_path):
    text = SHAPER.replace('s = { rate = "u", unit', 's = { rat = "u", unit').replace('["table"]', '["table", "u"]')
    (tmp_path / "shaper.toml").write_text(text, encoding="utf-8")
    assert "C002" not in call("check", tmp_path / "shaper.toml").stderr


@pytest.mark.parametrize(("laws", "told"), [
    ({"a": "b", "b": "c", "c": "2"}, {}), ({"a": "a + 1"}, {"a": "a → a"}),
    ({"a": "b", "b": "c", "c": "b"}, {"b": "b → c → b", "c": "c → b → c"}),  # a leads there and is none of them
    ({"a": "b + c", "b": "2", "c": "b + d", "d": "a"}, {"a": "a → c → d → a", "c": "c → d → a → c", "d": "d → a → c → d"}),
])  # fmt: skip
def test_a_law_that_needs_itself_is_told_with_its_way_and_no_other_law(laws, told):
    looks = []

    class Formulas(dict):
        def __getitem__(self, name):
            looks.append(name)
            assert len(looks) < 100, "each law is gone through once"
            return super().__getitem__(name)

    formulas = Formulas({name: SimpleNamespace(formulas=[parse(text)]) for name, text in laws.items()})
    assert {name: " → ".join(way) for name in laws if (way := at_start._circle(name, formulas))} == told


@pytest.mark.parametrize(
    "placed", [GUIDE.replace('"0"', '"x/b"'), GUIDE.replace('"0"', '"tilt"'), GUIDE.replace('"K"', '"K + (0, x)"')]
)
def test_a_group_is_not_placed_by_what_it_gives_itself(placed):
    text = SHAPER.replace(GUIDE, placed).replace("[drive]", '[functions]\ntilt = "x/b"\n[drive]')
    (line,) = told(text)
    assert "(RRP) is placed by x, which only this group gives" in line
