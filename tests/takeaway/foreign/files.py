"""Files as PMKS, pylinkage and Linkage write them, each by hand after what those projects say of their formats."""

import json

FOUR_BAR = """\
ground,input,R,0,0
input,coupler,R,0,1.5
coupler,follower,R,3,4
follower,ground,R,5,0
coupler,R,2,5
"""

# The same in PMKS+, in metres and turned 30 times a minute: 1500 thousandths are "NS", 23 * 64 + 28; the force is left out.
SHARED = (
    "https://app.pmksplus.com/?3u.BG.U,0.2112.6A,A,0,0,0.0B,B,0,NS,0.0C,C,ku,_W,0.4D,D,1E8,0,0.0E,E,VG,1E8,0..YRAB,AB,0,0,0,0,c5cae9,"
    "A,B,,.YRBCE,BCE,0,0,0,0,303e9f,B,C,E,,.YRCD,CD,0,0,0,0,0d125a,C,D,,..2F1,BCE,Q,0,0,0,0,0..NQ"
)
# A slider on a line of 30 degrees, 524 thousandths of a radian, in centimetres and turned 20 times a minute clockwise.
SHARED_SLIDER = (
    "0P.SS.K,0.1012.6A,A,0,0,0.0B,B,0,NS,0.0C,C,ku,0,0.5D,D,ku,0,8C..YRAB,AB,0,0,0,0,c5cae9,A,B,,.YRBC,BC,0,0,0,0,303e9f,B,C,,"
    ".YPCD,CD,0,0,0,0,0d125a,C,D,,...JAQ"
)

# A crank and a slider on a slanted line; the gear has no counterpart.
SLIDER = (
    "https://designengrlab.github.io/PMKS/pmks.html?mech=ground,2,R,0.000,0.000,0.000,ttft%7C2,3,R,0.300,0.400,0.000,ffff"
    "%7C3,ground,RP,1.500,0.200,10.000,tfff%7C2,9,G,0.100,0.100,0.000,ffff%7C"
)

# Two cranks whose gears meet at x = 1 carry a dyad between them.
GEARED = """\
ground,input,R,0,0
input,left,R,0,1
ground,wheel,R,3,0
wheel,right,R,3,2
left,right,R,2,4
wheel,input,G,1,0
"""

# Joints and links; the motor that swings has no counterpart.
MECHANISM = json.dumps({
    "name": "Crank and rocker", "ground": "G",
    "joints": [
        {"id": "A", "type": "ground", "position": [0.0, 0.0]}, {"id": "D", "type": "ground", "position": [3.0, 0.0]},
        {"id": "B", "type": "revolute", "position": [0.0, 1.0]}, {"id": "C", "type": "revolute", "position": [3.0, 2.0]},
        {"id": "T", "type": "tracker", "position": [1.0, 1.0], "ref_joint1_id": "B", "ref_joint2_id": "C"},
    ],
    "links": [
        {"id": "G", "type": "ground", "joints": ["A", "D"]},
        {"id": "crank", "type": "driver", "joints": ["A", "B"], "angular_velocity": 0.1,
         "initial_angle": 1.5707963267948966, "motor_joint": "A"},
        {"id": "rod", "type": "link", "joints": ["B", "C"]}, {"id": "rocker", "type": "link", "joints": ["C", "D"]},
        {"id": "cam", "type": "arc_driver", "joints": ["D"], "angular_velocity": 0.2},
    ],
})  # fmt: skip

# Joints that name their parents: a second dyad hangs on a point of the coupler.
LINKAGE = json.dumps({
    "name": "Six links", "solve_order": ["B", "C", "E", "F"],
    "joints": [
        {"type": "Crank", "name": "B", "x": 0.0, "y": 1.0, "distance": 1.0, "angle": -0.31,
         "joint0": {"inline": True, "type": "Static", "x": 0.0, "y": 0.0, "name": "A"}},
        {"type": "Revolute", "name": "C", "x": 3.0, "y": 2.0, "distance0": 3.1622776601683795, "distance1": 2.0,
         "joint0": {"ref": "B"}, "joint1": {"inline": True, "type": "Static", "x": 3.0, "y": 0.0, "name": "D"}},
        {"type": "Fixed", "name": "E", "x": 1.0, "y": 3.0, "distance": 2.23606797749979, "angle": 0.7,
         "joint0": {"ref": "B"}, "joint1": {"ref": "C"}},
        {"type": "Linear", "name": "F", "x": 5.0, "y": 3.5, "revolute_radius": 4.031128874149275, "joint0": {"ref": "E"},
         "joint1": {"inline": True, "type": "Static", "x": 4.0, "y": 3.5, "name": "K"},
         "joint2": {"inline": True, "type": "Static", "x": 6.0, "y": 3.5, "name": "L"}},
    ],
})  # fmt: skip


# A joint that slides on a line of the coupler.
MOVING_LINE = json.dumps({
    "name": "A line of the coupler",
    "joints": [
        *json.loads(LINKAGE)["joints"][:3],
        {"type": "Crank", "name": "G", "x": 6.0, "y": 1.0, "distance": 1.0, "angle": -0.62,
         "joint0": {"inline": True, "type": "Static", "x": 6.0, "y": 0.0, "name": "H"}},
        {"type": "Linear", "name": "J", "x": 2.0, "y": 5.0,
         "joint0": {"ref": "G"}, "joint1": {"ref": "B"}, "joint2": {"ref": "E"}},
    ],
})  # fmt: skip


def linkage2(connectors, links, more=""):
    """A file of Linkage."""
    lines = [f"\t<connector {attributes}/>" if not inside else f"\t<connector {attributes}>{inside}</connector>"
             for attributes, inside in connectors]  # fmt: skip
    lines += [f'\t<Link id="{number}"{told}>{"".join(f"<connector id={chr(34)}{one}{chr(34)}/>" for one in joints)}</Link>'
              for number, (joints, told) in enumerate(links)]  # fmt: skip
    head = '<program zoom="1" xoffset="0" yoffset="0" scalefactor="1.000000" units="Millimeters"/>'
    return "\n".join(["<linkage2>", f"\t{head}", *lines, more, "\t<selected>", "\t</selected>", "</linkage2>"]).encode()


# 96 units are an inch: a crank of 25.4 mm, turned 30 times a minute.
ROCKER = linkage2(
    [('id="7" x="0" y="0" anchor="true" input="true" rpm="30.000000"', ""), ('id="10" x="288" y="0" anchor="true"', ""),
     ('id="12" x="0" y="96" draw="true"', ""), ('id="2" x="288" y="192"', ""), ('id="5" x="500" y="500"', "")],
    [((12, 7), ""), ((7, 10), ""), ((2, 12), ""), ((2, 10), "")],
)  # fmt: skip
PISTON = linkage2(
    [('id="1" x="0" y="0" anchor="true" input="true" rpm="-15.000000"', ""), ('id="2" x="0" y="96"', ""),
     ('id="3" x="96" y="0" anchor="true"', ""), ('id="4" x="480" y="0" anchor="true"', ""),
     ('id="6" x="288" y="0" slider="true"', '<slidelimit id="3"/><slidelimit id="4"/>')],
    [((1, 2), ""), ((3, 4), ""), ((6, 2), ""), ((6, 4), ' actuator="true" throw="10"')],
    more='\t<connector id="9" x="0" y="0" anchor="true"><fastenedto/></connector>',
)  # fmt: skip
# The pin of the crank slides in the slot of a lever, and a second crank turns three times as fast.
SLOTTED = linkage2(
    [('id="1" x="0" y="0" anchor="true" input="true" rpm="10.000000"', ""),
     ('id="2" x="96" y="0" slider="true"', '<slidelimit id="3"/><slidelimit id="4"/>'),
     ('id="3" x="0" y="-192" anchor="true"', ""), ('id="4" x="192" y="192"', ""),
     ('id="5" x="960" y="0" anchor="true" input="true" rpm="-30.000000"', ""), ('id="6" x="960" y="96"', "")],
    [((1, 2), ""), ((3, 4), ""), ((5, 6), "")],
)  # fmt: skip
FILES = {
    "four.pmks.csv": FOUR_BAR.encode(), "mechanism.json": MECHANISM.encode(), "linkage.json": LINKAGE.encode(),
    "rocker.linkage2": ROCKER, "piston.linkage2": PISTON,
}  # fmt: skip


def changed(text, **parts):
    """A file of pylinkage with other values of some keys."""
    return json.dumps({**json.loads(text), **parts}).encode()
