"""What a file of others has and a variant has not is named in a remark."""

import json

import pytest

from coursework.takeaway.foreign import linkage, pmks, pmks_plus, pylinkage
from coursework.takeaway.foreign.scheme import Scheme, Slider
from coursework.takeaway.foreign.text import Chain
from coursework.words.sentences import say
from tests.takeaway.foreign.files import (
    FOUR_BAR,
    LINKAGE,
    MECHANISM,
    PISTON,
    SHARED,
    SHARED_SLIDER,
    SLOTTED,
    changed,
)

JOINTS = json.loads(MECHANISM)["joints"]
OLDER = json.loads(LINKAGE)["joints"]
LEFT_OUT = [
    (pmks.read, f"{FOUR_BAR}coupler,follower,P,2,5".encode(), ["coupler, follower, P, 2, 5"]),
    (pmks.read, b"ground,input,R,0,0\ninput,3,R,0,1\n3,4,R,2,1\n4,5,R,2,2\n4,ground,P,2,1,10", ["4, 4"]),
    (pmks_plus.read, SHARED.replace("0B,B", "8B,B").replace("0C,C", "1C,C").encode(), ["weld B", "slide C", "force F1"]),
    (pmks_plus.read, SHARED_SLIDER.replace("5D,D", "0D,D").encode(), ["slider CD"]),
    (pylinkage.read, changed(MECHANISM, joints=[*JOINTS, {"id": "S", "type": "ball"}]), ["arc_driver cam", "ball S"]),
    (pylinkage.read, MECHANISM.replace('"ref_joint2_id": "C"', '"ref_joint2_id": "A"').replace('"B", "ref', '"C", "ref').encode(),
     ["arc_driver cam", "tracker T"]),
    (pylinkage.read, changed(MECHANISM, joints=[*JOINTS, {"id": "S", "type": "prismatic", "position": [1, 1]}]),
     ["arc_driver cam", "prismatic S"]),
    (pylinkage.read, changed(LINKAGE, joints=[*OLDER[:3], {"type": "Arc", "name": "N", "x": 1, "y": 5}, {
        "type": "Crank", "name": "M", "x": 1, "y": 4, "joint0": {"ref": "E"}}]), ["Arc N", "Crank M"]),
    (pylinkage.read, changed(LINKAGE, joints=[*OLDER[:3], *({  # each of these needs one parent more
        "type": kind, "name": kind[0], "x": 1, "y": 5,
        "joint0": {"ref": "E"}, **({"joint1": {"ref": "E"}} if kind == "Linear" else {})}
        for kind in ("Revolute", "Fixed", "Linear"))]), ["Fixed F", "Linear L", "Revolute R"]),
    (linkage.read, PISTON.replace(b'scalefactor="1.000000"', b'scalefactor="2.5"').replace(b'<slidelimit id="4"/>', b""),
     ["<fastenedto>", "actuator (link 3)", "scalefactor 2.5", "slider (connector 6)"]),
    (linkage.read, SLOTTED.replace(b'<connector id="5"/><connector id="6"/>', b""), ["input (connector 5)"]),
]  # fmt: skip


@pytest.mark.parametrize(("read", "content", "names"), LEFT_OUT, ids=[case[2][-1] for case in LEFT_OUT])
def test_what_has_no_counterpart_is_named(read, content, names):
    said = str(say("foreign.left_out", what="…")).split("…")
    told = [str(remark) for remark in read(content).remarks if str(remark).startswith(said[0]) and str(remark).endswith(said[1])]
    assert sorted(one.removeprefix(said[0]).removesuffix(said[1]) for one in told) == sorted(names)


SLOTS = {
    "on a joint that nothing reaches": ({"E": Slider(8 + 0j, 0.0)}, ["E"]),
    "on a fixed joint": ({"A": Slider(0j, 0.0)}, ["E", "A"]),
    "on the joint of a dyad": ({"C": Slider(4 + 1j, 0.0)}, ["E"]),
    "of a link that nothing reaches": ({"B": Slider(8 + 0j, 0.0, 2)}, ["E", "B"]),
    "two of them": ({"A": Slider(0j, 0.0), "E": Slider(8 + 0j, 0.0)}, ["E", "A"]),
}


@pytest.mark.parametrize("case", SLOTS)
def test_what_no_group_takes_up_is_lost_once(case):
    """A crank AB, a rod BC that a slider may guide, and a link of one joint E that hangs on nothing."""
    sliders, lost = SLOTS[case]
    joints = {"A": 0j, "B": 1 + 1j, "C": 4 + 1j, "E": 8 + 0j}
    links = (("A", "B"), ("B", "C"), ("E",))
    made = Chain(Scheme("PMKS", "", joints, frozenset("A"), links, sliders, "A", 0, 1.0, ()))
    assert made.lost == (lost if "C" in sliders else ["C", *lost])
