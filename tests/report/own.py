"""Mechanisms that are in no file of the catalogue: a shaper, a five-bar with two drives, a boom on a cylinder."""

from __future__ import annotations

SHAPER = """\
format = 1
title  = "Shaper with a slotted lever"
source = "own"
[given]
r1 = "0.10 m"
d = "0.25 m"
L = "0.50 m"
b = "0.30 m"
yg = "0.48 m"
n = "120 rpm"
[drive]
w1 = "n"
[coordinates]
phi1 = { start = "0 deg", rate = "w1" }
phi3 = { rate = "w3", unit = "rad" }
s = { rate = "u", unit = "m" }
phi4 = { rate = "w4", unit = "rad" }
x = { rate = "vx", unit = "m" }
[time]
step = "2*pi/(48*n)"
end = "2*pi/n"
period = "2*pi/n"
[points]
A = "(0, 0)"
D = "(0, -d)"
K = "(0, yg-d)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r1"]
coordinates = ["phi1"]
[[group]]
kind = "RPR"
from = ["B", "D"]
meets = "E"
lengths = ["L"]
coordinates = ["phi3", "s"]
mode = "+1"
[[group]]
kind = "RRP"
from = ["E"]
guide = { through = "K", angle = "0" }
meets = "F"
lengths = ["b"]
coordinates = ["phi4", "x"]
mode = "+1"
[frame]
hinges = ["A", "D"]
rails = [ { through = "F", angle = "0" } ]
[ask]
quantities = ["table", "plots", "checks", "accelerations", "points", "analogs", "invariants", "plans", "graph_check"]
"""

FIVE_BAR = """\
format = 1
title  = "Five-bar with two drives"
source = "own"
[given]
r1 = "0.20 m"
r2 = "0.45 m"
r3 = "0.40 m"
r4 = "0.15 m"
d = "0.50 m"
n1 = "60 rpm"
n4 = "30 rpm"
[drive]
w1 = "n1"
w4 = "n4"
[coordinates]
phi1 = { start = "30 deg", rate = "w1" }
phi4 = { start = "120 deg", rate = "w4" }
phi2 = { rate = "w2", unit = "rad" }
phi3 = { rate = "w3", unit = "rad" }
[time]
step = "0.05 s"
end = "2 s"
period = "2 s"
[points]
A = "(0, 0)"
E = "(d, 0)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r1"]
coordinates = ["phi1"]
[[group]]
kind = "crank"
from = ["E"]
meets = "D"
lengths = ["r4"]
coordinates = ["phi4"]
[[group]]
kind = "RRR"
from = ["B", "D"]
meets = "C"
lengths = ["r2", "r3"]
coordinates = ["phi2", "phi3"]
mode = "+1"
[frame]
hinges = ["A", "E"]
[ask]
quantities = ["table", "plots", "checks", "accelerations", "points", "plans", "graph_check"]
"""

# A hydraulic cylinder between B and C lifts the boom AC: its length s is driven.
BOOM = """\
format = 1
title  = "Boom on a cylinder"
source = "own"
[given]
c = "1.30 m"
v1 = "0.06 m/s"
p = "0.6 rad/s"
xB = "0.5 m"
yB = "-0.4 m"
[drive]
us = "v1*sin(p*t)"
[coordinates]
s = { start = "1.5 m", rate = "us" }
phi = { start = "56.5095660113926 deg", rate = "w1" }
psi = { start = "81.6690103396294 deg", rate = "w2" }
[time]
step = "0.1 s"
end = "2*pi/p"
period = "2*pi/p"
check_row = 20
scheme = "exact"
[[constraint]]
name = "I"
closure = "B + s @ psi = C"
[points]
A = "(0, 0)"
B = "(xB, yB)"
C = "A + c @ phi"
[links]
1 = { points = ["A", "C"], rate = "w1" }
2 = { points = ["B"], rate = "w2" }
3 = { points = ["C"], slides = 2, rate = "w2" }
[frame]
hinges = ["A", "B"]
"""

# Stephenson's six-bar: the second dyad hangs on a point of the coupler, which is placed from its first hinge.
STEPHENSON = """format = 1
title = "Six-bar with a point of the coupler"
[given]
n1 = "60 rpm"
r1 = "0.10 m"
r2 = "0.30 m"
r3 = "0.30 m"
r4 = "0.45 m"
r5 = "0.30 m"
r6 = "0.25 m"
delta = "40 deg"
[drive]
w1 = "n1"
[coordinates]
phi1 = { start = "30 deg", rate = "w1" }
phi2 = { rate = "w2", unit = "rad" }
phi3 = { rate = "w3", unit = "rad" }
phi4 = { rate = "w4", unit = "rad" }
phi5 = { rate = "w5", unit = "rad" }
[time]
step = "2*pi/(36*n1)"
end = "2*pi/n1"
period = "2*pi/n1"
check_row = 5
[points]
A = "(0, 0)"
C = "(0.35, 0)"
E = "(0.60, 0.10)"
G = "B + r6 @ (phi2 + delta)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r1"]
coordinates = ["phi1"]
[[group]]
kind = "RRR"
from = ["B", "C"]
meets = "D"
lengths = ["r2", "r3"]
coordinates = ["phi2", "phi3"]
mode = "+1"
[[group]]
kind = "RRR"
from = ["G", "E"]
meets = "F"
lengths = ["r4", "r5"]
coordinates = ["phi4", "phi5"]
mode = "-1"
[frame]
hinges = ["A", "C", "E"]
"""
