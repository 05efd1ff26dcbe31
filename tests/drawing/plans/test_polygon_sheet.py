"""What stands on a plan: images beside arrows, what rests at the pole, parts n and k; all on the sheet, short ones apart."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest

from coursework.drawing.paper.record import Drawing
from coursework.drawing.plans.foot import _screen_bar, sheet_over_foot
from coursework.words.sentences import load_phrases
from tests.drawing import measured
from tests.drawing.check_sheet.checked import check_of
from tests.drawing.plans.test_polygons import drawings_of, shafts

NAMES = ["31", "example-1", "example-4", "v107", "whitworth"]
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")


def said(drawing: Drawing) -> list[tuple[str, measured.Word]]:
    return [
        (word.text.translate(_LOWERED).replace("\u00a0", " ").replace("′", "'"), word) for word in measured.words(drawing.svg)
    ]


def boxes(drawing: Drawing) -> list[tuple[float, float, float, float]]:
    """Return the frames (left, top, right, bottom; mm) of closed paths with four corners and no fill: that of the inset."""
    found = []
    for node in ElementTree.fromstring(drawing.svg).iter():
        way = node.get("d", "")
        if way.endswith("Z") and node.get("fill") == "none" and len(points := measured.points(way)) == 4:
            found.append((points[0].real, points[0].imag, points[2].real, points[2].imag))
    return found


@pytest.mark.parametrize("plan", ["velocity", "acceleration"])
@pytest.mark.parametrize("name", NAMES)
def test_images_and_parts_have_their_names_beside_them(name: str, plan: str) -> None:
    drawing = drawings_of(name)[f"{plan}-plan"]
    drawn, words = shafts(drawing), said(drawing)
    (pole,) = {tail for (kind, *_), (tail, _) in drawn.items() if kind == "absolute"}
    (at_pole,) = (word for word in words if word[0].startswith(f"p{plan[0]}"))
    assert measured.apart(at_pole[1], pole.conjugate()) < 5
    resting = at_pole[0].split(", ")[1:]
    box = boxes(drawing)
    apart = [
        word
        for word in words
        if not any(a <= word[1].box[0] and word[1].box[2] <= c and b <= word[1].box[1] for a, b, c, _ in box)
    ]
    for (kind, start, end), (tail, tip) in drawn.items():
        low = end.lower() + ("" if start == "pole" else start.lower())
        if kind == "absolute":
            assert end.lower() not in resting
            assert min(measured.apart(word, tip.conjugate()) for text, word in apart if text == end.lower()) < 6
        elif kind in {"normal", "coriolis"} and abs(tip - tail) > 4:
            letter = "n" if kind == "normal" else "k"
            [word] = [word for text, word in apart if text == letter + low]
            assert min(measured.apart(word, (tail + (tip - tail) * k / 20).conjugate()) for k in range(21)) < 4
    parts = [text for text, _ in apart if re.match(r"[nk][a-z]\d?", text)]
    assert len(parts) == sum(kind in {"normal", "coriolis"} and abs(tip - tail) > 4 for (kind, *_), (tail, tip) in drawn.items())


@pytest.mark.parametrize("plan", ["velocity", "acceleration"])
@pytest.mark.parametrize("name", NAMES)
def test_arrows_and_their_room_are_on_the_sheet_and_short_ones_in_a_box_of_their_own(name: str, plan: str) -> None:
    drawing = drawings_of(name)[f"{plan}-plan"]
    drawn, again, box = shafts(drawing), shafts(drawing, inset=True), boxes(drawing)
    ends = [end.conjugate() for pair in drawn.values() for end in pair]
    left, right = min(end.real for end in ends), max(end.real for end in ends)
    every = [*ends, *(complex(x, y) for a, b, c, d in box for x, y in ((a, b), (c, d)))]
    assert min(end.real for end in every) > 1.9 and max(end.real for end in every) < drawing.width - 1.9
    assert min(end.imag for end in every) > 1.9 and max(end.imag for end in every) < drawing.height - 15
    assert bool(again) == bool(box)
    if not box:
        assert abs(left + right - drawing.width) < 6  # in the middle
        return
    ((a, b, c, d),) = box
    assert all(
        a < end.real < c and b < end.imag < d for pair in again.values() for end in (pair[0].conjugate(), pair[1].conjugate())
    )
    assert not any(a < end.real < c and b < end.imag < d for end in ends)
    for (_, start, end), (_, tip) in again.items():
        text = end.lower() if start == "pole" else start.lower() + end.lower()
        assert min(measured.apart(word, tip.conjugate()) for found, word in said(drawing) if found == text) < 5


def test_a_blank_plan_has_what_is_given_alone() -> None:
    """Of v107 the velocity of M is given, by the drive; the pole and what rests by the frame stay."""
    check = check_of("v107")
    _, plan = check.sheets(blank=True)
    _, whole = check.sheets()
    assert {*shafts(plan)} == {("absolute", "pole", "M")} < {*shafts(whole)}
    assert shafts(plan, inset=True) == {} and boxes(plan) == [] and not plan.steps and whole.steps
    poles = [[text for text, _ in said(one) if text.startswith("pv")] for one in (plan, whole)]
    assert poles == [["pv, o"], ["pv, o, p"]]  # that P rests too is found by the construction
    assert plan.exact and whole.exact


@pytest.mark.parametrize("plan", ["velocity", "acceleration"])
@pytest.mark.parametrize("name", NAMES)
def test_a_plan_has_its_margins_and_stands_over_its_foot(name: str, plan: str) -> None:
    """9 mm beside the tips of arrows, 11 mm beside the pole, 2 mm beside the inset; the foot is 17 mm high."""
    drawing = drawings_of(name)[f"{plan}-plan"]
    drawn = shafts(drawing)
    (pole,) = {tail.conjugate() for (kind, *_), (tail, _) in drawn.items() if kind == "absolute"}
    tips = [end.conjugate() for ends in drawn.values() for end in ends]
    inset = boxes(drawing)
    tops = [pole.imag - 11, *(tip.imag - 9 for tip in tips), *(top - 2 for _, top, _, _ in inset)]
    lows = [pole.imag + 11, *(tip.imag + 9 for tip in tips), *(low + 2 for *_, low in inset)]
    lefts = [pole.real - 11, *(tip.real - 9 for tip in tips), *(left - 2 for left, *_ in inset)]
    rights = [pole.real + 11, *(tip.real + 9 for tip in tips), *(right + 2 for *_, right, _ in inset)]
    assert (min(tops), max(lows)) == pytest.approx((0.0, drawing.height - 17.0), abs=0.02)
    assert (min(lefts) + max(rights)) / 2 == pytest.approx(drawing.width / 2, abs=0.02) and min(lefts) > -0.02


@pytest.mark.parametrize(("amount", "told"), [
    (0.5, "10 m"), (0.501, "20 m"), (0.0249, "0.5 m"), (1.01e-8, "1·10⁻⁶ m"), (0.99e-8, ""), (2.49e5, "5000000 m"),
    (2.51e5, ""),
])  # fmt: skip
def test_the_bar_of_a_screen_is_a_round_amount_from_20_to_100_mm_long(amount: float, told: str) -> None:
    sheet = sheet_over_foot(170.0, 60.0)
    _screen_bar(sheet, 3 + 55j, (amount, "m"), load_phrases("en").written)
    words = [word.text.replace("\u00a0", " ") for word in measured.words(sheet.svg().replace(' display="none"', ""))]
    assert words == ([told] if told else [])
