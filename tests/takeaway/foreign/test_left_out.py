"""What a file of others has and a variant has not is named in a remark."""

import json

import pytest

from coursework.takeaway.foreign import linkage, pmks, pmks_plus, pylinkage
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
    (linkage.read, PISTON.replace(b'scalefactor="1.000000"', b'scalefactor="2.5"').replace(b'<slidelimit id="4"/>', b""),
     ["<fastenedto>", "actuator (link 3)", "scalefactor 2.5", "slider (connector 6)"]),
    (linkage.read, SLOTTED.replace(b'<connector id="5"/><connector id="6"/>', b""), ["input (connector 5)"]),
]  # fmt: skip


@pytest.mark.parametrize(("read", "content", "names"), LEFT_OUT, ids=[case[2][-1] for case in LEFT_OUT])
def test_what_has_no_counterpart_is_named(read, content, names):
    said = str(say("foreign.left_out", what="…")).split("…")
    told = [str(remark) for remark in read(content).remarks if str(remark).startswith(said[0]) and str(remark).endswith(said[1])]
    assert sorted(one.removeprefix(said[0]).removesuffix(said[1]) for one in told) == sorted(names)
