"""Files of other programs: the mechanism is theirs, its velocities too, and what has no counterpart is listed in the file."""

import contextlib
import json
import math
import random
import re

import numpy as np
import pytest

import coursework
from coursework.takeaway.foreign import linkage, pmks, pmks_plus, pylinkage
from coursework.takeaway.foreign.scheme import MOST_BYTES, Slider
from coursework.takeaway.foreign.text import text_of
from coursework.words.errors import InputError
from tests.command import call
from tests.takeaway.foreign.files import (
    FILES,
    FOUR_BAR,
    GEARED,
    LINKAGE,
    MECHANISM,
    MOVING_LINE,
    PISTON,
    ROCKER,
    SHARED,
    SHARED_SLIDER,
    SLIDER,
    SLOTTED,
    changed,
    linkage2,
)

pytestmark = pytest.mark.usefixtures("folder")
INCH = 0.0254


def taken(folder, given, content=None):
    if content is not None:
        (folder / given).write_bytes(content)
    called = call("new", "own", "--from", given)
    assert called.exit_code == 0, called.output
    variant = coursework.load(folder / "own.toml")
    assert all(bool(group.mode) == (group.kind != "crank") for group in variant.groups)  # a crank has one position
    return coursework.solve(variant)


def of(run, point, what="position"):
    """A point of each row, or its velocity, as complex numbers."""
    return getattr(run.points[point], what).to_numpy() @ (1, 1j)


def meeting(first, length, second, other, side):
    """Where two circles meet, on the left (+1) or right (-1) of the way from one middle to the other."""
    way = second - first
    along = (abs(way) ** 2 + length**2 - other**2) / (2 * abs(way))
    return first + way / abs(way) * (along + side * 1j * math.sqrt(length**2 - along**2))


def velocities(place, t, h=1e-5):
    return (place(t + h) - place(t - h)) / (2 * h)


def four_bar(crank, start, speed, pivot, rod, rocker, fixed, side):
    def place(t):
        pin = pivot + crank * np.exp(1j * (start + speed * t))
        return meeting(pin, rod, fixed, rocker, side)

    return place


def test_a_four_bar_of_pmks_moves_as_it_does_there(folder):
    run = taken(folder, "four.pmks.csv", FOUR_BAR.encode())
    place = four_bar(1.5, math.pi / 2, 1.0, 0j, abs(3 + 2.5j), abs(2 - 4j), 5 + 0j, 1)
    for row in (0, 5, 20):
        t = run.motion.t[row]
        assert of(run, "C")[row] == pytest.approx(place(t), abs=1e-9)
        assert of(run, "C", "velocity")[row] == pytest.approx(velocities(place, t), abs=1e-7)
    tracer = abs(2 + 5j - 1.5j)  # from the pin of the crank, with the coupler
    assert abs(of(run, "E") - of(run, "B"))[7] == pytest.approx(tracer)


def test_a_share_address_of_pmks_plus(folder):
    run = taken(folder, SHARED)
    place = four_bar(1.5, math.pi / 2, math.pi, 0j, abs(3 + 2.5j), abs(2 - 4j), 5 + 0j, 1)
    assert of(run, "C", "velocity")[9] == pytest.approx(velocities(place, run.motion.t[9]), abs=1e-6)
    assert abs(of(run, "E") - of(run, "B"))[3] == pytest.approx(abs(2 + 3.5j))
    assert any("force F1" in remark for remark in run.variant.remarks)


def test_a_file_of_pmks_plus_with_a_slider(folder):
    run = taken(folder, "arm.pmks", SHARED_SLIDER.encode())
    assert [group.kind for group in run.variant.groups] == ["crank", "RRP"] and run.variant.remarks == ()
    assert run.motion.column("w1")[0] == pytest.approx(-20 * math.tau / 60)
    ways = (of(run, "C") - 0.03) / np.exp(0.524j)
    assert np.abs(ways.imag).max() < 1e-12 and ways[0] == pytest.approx(0, abs=1e-12)


def test_a_share_address_of_pmks_gives_a_slider_and_lists_the_gear(folder):
    run = taken(folder, SLIDER)
    assert [group.kind for group in run.variant.groups] == ["crank", "RRP"]
    assert any("2, 9, G" in remark for remark in run.variant.remarks)
    line = np.exp(1j * math.radians(10))
    assert np.abs(((of(run, "C") - (1.5 + 0.2j)) / line).imag).max() < 1e-9
    assert np.abs(of(run, "C") - of(run, "B")) == pytest.approx(abs(1.5 + 0.2j - 0.3 - 0.4j))


@pytest.mark.parametrize(("name", "speed"), [("mechanism.json", 0.1), ("linkage.json", -0.31)])
def test_both_files_of_pylinkage(folder, name, speed):
    run = taken(folder, name, FILES[name])
    place = four_bar(1.0, math.pi / 2, speed, 0j, math.sqrt(10), 2.0, 3 + 0j, 1)
    t = run.motion.t[4]
    assert of(run, run.variant.groups[1].meets, "velocity")[4] == pytest.approx(velocities(place, t), abs=1e-7)
    lost = {"mechanism.json": ("arc_driver cam",), "linkage.json": ()}[name]
    assert all(any(one in remark for remark in run.variant.remarks) for one in lost)
    if name == "mechanism.json":  # the tracker goes with the rod
        assert abs(of(run, "T") - of(run, "B"))[7] == pytest.approx(1.0) and len(run.variant.remarks) == 3


def test_gears_of_pmks_turn_a_second_crank(folder):
    run = taken(folder, "geared.csv", GEARED.encode())
    assert [group.kind for group in run.variant.groups] == ["crank", "crank", "RRR"]
    assert not any("G" in remark for remark in run.variant.remarks)
    t = run.motion.t[5]
    left, right = np.exp(1j * (math.pi / 2 + t)), 3 + 2 * np.exp(1j * (math.pi / 2 - t / 2))
    assert of(run, "D")[5] == pytest.approx(right)
    assert of(run, "E")[5] == pytest.approx(meeting(left, abs(2 + 3j), right, abs(-1 + 2j), 1))


def test_a_lever_of_linkage_slides_on_the_pin_of_the_crank(folder):
    run = taken(folder, "slotted.linkage2", SLOTTED)
    assert [group.kind for group in run.variant.groups] == ["crank", "crank", "RPR"]
    t, names = run.motion.t[6], sorted(run.points.columns.get_level_values(0).unique())
    pin, pivot = INCH * np.exp(1j * math.tau / 6 * t), -2j * INCH
    start = INCH - pivot
    lever = pivot + abs(2 + 4j) * INCH * np.exp(1j * (np.angle((2 + 4j) / start) + np.angle(pin - pivot)))
    far = 10 * INCH + INCH * np.exp(1j * (math.pi / 2 - 3 * math.tau / 6 * t))
    for place in (pin, lever, far):
        assert min(abs(of(run, name)[6] - place) for name in names) < 1e-12


def test_a_slot_of_a_moving_link_may_begin_anywhere(folder):
    told = json.loads(MOVING_LINE)
    told["joints"][-1] |= {"x": 5.0, "y": 1.0, "joint1": {"ref": "E"}, "joint2": {"ref": "C"}}
    run = taken(folder, "line.json", json.dumps(told).encode())
    tracer, rod, slides = (of(run, name) for name in ("E", "C", run.variant.groups[3].meets))
    assert len(rod) > 1 and np.abs(((slides - tracer) / (rod - tracer)).imag).max() < 1e-12


def test_a_joint_slides_on_a_line_of_a_moving_link(folder):
    run = taken(folder, "line.json", MOVING_LINE.encode())
    assert [group.kind for group in run.variant.groups] == ["crank", "crank", "RRR", "RRP"]
    first, rod, slides = (of(run, run.variant.groups[k].meets) for k in (0, 2, 3))
    crank = of(run, run.variant.groups[1].meets)
    assert abs(slides - crank) == pytest.approx(np.full(len(first), abs(-4 + 4j)))
    assert np.angle((slides - first) / (rod - first)) == pytest.approx(np.full(len(first), np.angle((2 + 4j) / (3 + 1j))))


def test_a_second_dyad_hangs_on_a_point_of_the_coupler(folder):
    run = taken(folder, "linkage.json", LINKAGE.encode())
    assert [group.kind for group in run.variant.groups] == ["crank", "RRR", "RRP"]
    names = run.variant.groups[1].meets, run.variant.groups[2].meets
    assert all(len(name) == 1 for name in names)
    slider = of(run, names[1])
    assert slider.imag == pytest.approx(3.5) and slider[0].real == pytest.approx(5.0)


def test_linkage_counts_96_units_an_inch(folder):
    run = taken(folder, "rocker.linkage2", ROCKER)
    place = four_bar(INCH, math.pi / 2, math.pi, 0j, math.sqrt(10) * INCH, 2 * INCH, 3 * INCH + 0j, 1)
    found = run.variant.groups[1].meets
    assert of(run, found, "velocity")[3] == pytest.approx(velocities(place, run.motion.t[3]), abs=1e-8)
    assert any("5" in remark for remark in run.variant.remarks)  # a connector that nothing leads to


def test_a_slider_of_linkage_and_what_has_no_counterpart(folder):
    run = taken(folder, "piston.linkage2", PISTON)
    assert [group.kind for group in run.variant.groups] == ["crank", "RRP"]
    assert run.motion.column("w1")[0] == pytest.approx(-math.pi / 2)
    slider = of(run, run.variant.groups[1].meets)
    assert slider[0] == pytest.approx(3 * INCH) and np.ptp(slider.imag) < 1e-12
    assert any("actuator" in remark for remark in run.variant.remarks)


HOSTILE = {
    "entities": (linkage.read, b'<!DOCTYPE a [<!ENTITY b "bbbb">]><linkage2>&b;</linkage2>'),
    "deep": (linkage.read, b"<linkage2>" + b"<a>" * 5000),
    "broken": (linkage.read, b"<linkage2"),
    "far": (linkage.read, linkage2([('id="1" x="1e300" y="0"', "")], [])),
    "nowhere": (linkage.read, linkage2([('id="1" x="1" y="0"', "")], [((1, 2), "")])),
    "undriven": (linkage.read, linkage2([('id="1" x="1" y="0"', "")], [])),
    "no length": (linkage.read, ROCKER.replace(b'x="0" y="96"', b'x="0" y="0"')),
    "fixed crank": (pylinkage.read, MECHANISM.replace('"type": "revolute"', '"type": "ground"').encode()),
    "slide alone": (pmks_plus.read, SHARED.replace("0B,B", "5B,B").encode()),
    "nested": (pylinkage.read, b"[" * 100_000),
    "text": (pylinkage.read, b'{"joints": "B"}'),
    "nan": (pylinkage.read, MECHANISM.replace("1.0", "NaN").encode()),
    "many": (pylinkage.read, json.dumps({"joints": [{"id": str(k)} for k in range(101)]}).encode()),
    "empty": (pmks.read, b""),
    "no crank": (pmks.read, FOUR_BAR.replace("input", "crank").encode()),
    "no position": (pylinkage.read, changed(MECHANISM, joints=[{"id": "A", "type": "ground", "position": [1]}])),
    "no axis": (
        pylinkage.read,
        changed(MECHANISM, joints=[{"id": "A", "type": "prismatic", "position": [1, 1], "axis": [1]}]),
    ),
    "no joints": (pylinkage.read, changed(MECHANISM, links=[{"type": "link", "joints": "AB"}])),
    "no driver": (pylinkage.read, changed(MECHANISM, links=[])),
    "no parent": (
        pylinkage.read,
        changed(LINKAGE, joints=[{"type": "Fixed", "name": "E", "x": 1, "y": 1, "joint0": {"ref": "B"}}]),
    ),
    "no older crank": (pylinkage.read, changed(LINKAGE, joints=[{"type": "Static", "name": "A", "x": 1, "y": 1}])),
    "not shared": (pmks_plus.read, b"https://app.pmksplus.com/"),
    "no unit": (pmks_plus.read, SHARED.replace("2112", "9112").encode()),
    "no crank there": (pmks_plus.read, SHARED.replace("6A,A", "4A,A").encode()),
    "short joint": (pmks_plus.read, SHARED.replace("0B,B,0,NS,0", "0B,B,0").encode()),
    "unknown joint": (pmks_plus.read, SHARED.replace("A,B,,", "A,Z,,").encode()),
    "few": (pmks.read, b"ground,input,R,0"),
    "letters": (pmks.read, b"ground,input,R,x,y"),
    "bytes": (pmks.read, bytes(range(256))),
    "no base": (pmks_plus.read, b"3u.BG.U,0.2112.6A,A,!,0,0..YRAB,AB..."),
    "long": (pmks_plus.read, b"3u.BG.U,0.2112.6A,A,zzzzzzzzzzzzzzzz,0,0..YRAB..."),
}


@pytest.mark.parametrize("case", HOSTILE)
def test_what_cannot_be_read_is_told_in_a_sentence(case):
    read, content = HOSTILE[case]
    with pytest.raises(InputError) as refused:
        read(content)
    assert refused.value.faults[0].code in ("C094", "C095")


SPOILT = re.compile(rb"-?[0-9][0-9.]*|[A-Za-z]+")
PUT = (b"", b"0", b"1e308", b"1e-320", b"nan", b"1e400", b"[]", b"{}", b"x")


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.long) for seed in range(1, 40))])
def test_a_spoilt_file_is_read_or_refused(seed):
    chance = random.Random(seed)
    seeds = [
        (pmks.read, FOUR_BAR.encode()), (pmks.read, GEARED.encode()), (pmks_plus.read, SHARED.encode()),
        (pmks_plus.read, SHARED_SLIDER.encode()), (pylinkage.read, MECHANISM.encode()), (pylinkage.read, MOVING_LINE.encode()),
        (linkage.read, ROCKER), (linkage.read, PISTON), (linkage.read, SLOTTED),
    ]  # fmt: skip
    for _ in range(100):
        read, content = chance.choice(seeds)
        words = [*SPOILT.finditer(content)]
        for word in sorted(chance.sample(words, chance.choice((1, 1, 2))), key=lambda word: -word.start()):
            content = (
                content[: word.start()] + chance.choice((*PUT, chance.choice(words)[0], 2 * word[0])) + content[word.end() :]
            )
        with contextlib.suppress(InputError):
            written = text_of(read(content), "own", str)
            assert not re.search(r'"-?(?:nan|inf)', written.partition("[given]")[2])


@pytest.mark.parametrize("rate", ["1e-320", "1e-12"])
def test_a_second_crank_too_fast_for_a_number_is_left_out(rate):
    scheme = linkage.read(SLOTTED.replace(b'rpm="10.000000"', f'rpm="{rate}"'.encode()))
    assert not scheme.turned and "input (5)" in str(scheme.remarks)


def test_a_block_of_pmks_slides_at_its_angle():
    scheme = pmks.read(b"ground,input,R,0,0\ninput,3,R,0,1\n3,4,R,2,1\n4,ground,P,2,1,10")
    assert scheme.sliders == {"3": Slider(2 + 1j, math.radians(10))}


def test_names_of_a_foreign_file_stay_text_in_the_file(folder):
    named = MECHANISM.replace("Crank and rocker", '\\"\\n[given]\\nr = \\"1 m').replace('"B"', '"../B\\u0007"')
    run = taken(folder, "mechanism.json", named.encode())
    assert run.variant.groups[0].meets == "C" and "[given]" in run.variant.title
    assert sorted(path.name for path in folder.iterdir()) == ["mechanism.json", "own.toml"]


def test_a_file_too_large_and_one_with_other_data_are_refused(folder):
    (folder / "a.json").write_bytes(b" " * (MOST_BYTES + 1))
    assert "C096" in call("new", "own", "--from", "a.json").stderr
    (folder / "a.json").write_bytes(MECHANISM.encode())
    assert "C097" in call("new", "own", "--from", "a.json", "--set", "r1=2m").stderr
    assert [path.name for path in folder.iterdir()] == ["a.json"]
