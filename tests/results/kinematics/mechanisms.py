"""Mechanisms that are in no file of the catalogue, with closed forms for their strokes and extremes."""

from __future__ import annotations

# Crank 0.10 m, pivot of the lever 0.25 m below, lever 0.50 m, ram on a guide 0.48 m above the pivot, 120 rpm.
SHAPER = """format = 1
title = "Shaper with a slotted lever"
[given]
r1 = "0.10 m"
d = "0.25 m"
L = "0.50 m"
b = "0.30 m"
y = "0.48 m"
n = "120 rpm"
[drive]
w1 = "n"
[coordinates]
phi1 = { start = "90 deg", rate = "w1" }
phi3 = { rate = "w3", unit = "rad" }
s3 = { rate = "u3", unit = "m" }
phi4 = { rate = "w4", unit = "rad" }
s5 = { rate = "u5", unit = "m" }
[time]
step = "2*pi/(100*n)"
end = "2*pi/n"
period = "2*pi/n"
[points]
A = "(0, 0)"
D = "(0, -d)"
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
coordinates = ["phi3", "s3"]
mode = "+1"
[[group]]
kind = "RRP"
from = ["E"]
guide = { through = "(0, y - d)", angle = "0" }
meets = "F"
lengths = ["b"]
coordinates = ["phi4", "s5"]
mode = "+1"
[frame]
hinges = ["A", "D"]
rails = [ { through = "(0, y - d)", angle = "0" } ]
"""

# Crank 0.1 m, rod 0.5 m; the guide runs e below the pivot of the crank.
SLIDER = """format = 1
title = "Slider-crank with an offset"
[given]
r = "0.1 m"
l = "0.5 m"
e = "{e} m"
w0 = "10 rad/s"
[drive]
w1 = "{drive}"
[coordinates]
phi1 = {{ start = "{start!r} rad", rate = "w1" }}
phi2 = {{ rate = "w2", unit = "rad" }}
s = {{ rate = "u", unit = "m" }}
[time]
step = "2*pi/(40*w0)"
end = "2*pi/w0"
[points]
A = "(0, 0)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r"]
coordinates = ["phi1"]
[[group]]
kind = "RRP"
from = ["B"]
guide = {{ through = "A", angle = "0", offset = "-e" }}
meets = "C"
lengths = ["l"]
coordinates = ["phi2", "s"]
mode = "+1"
[frame]
hinges = ["A"]
rails = [ {{ through = "C", angle = "0" }} ]
"""

_CHAIN = """[time]
step = "2*pi/(40*w0)"
end = "2*pi/w0"
[points]
A = "(0, 0)"
D = "({d}, 0)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["{a} m"]
coordinates = ["phi1"]
"""

# Crank a, coupler b, rocker c, frame d.
FOURBAR = (
    """format = 1
title = "Four-bar linkage"
[given]
w0 = "10 rad/s"
d = "{d} m"
[drive]
w1 = "w0"
[coordinates]
phi1 = {{ start = "0.3 rad", rate = "w1" }}
phi2 = {{ rate = "w2", unit = "rad" }}
phi3 = {{ rate = "w3", unit = "rad" }}
"""
    + _CHAIN.replace("{d}", "d")
    + """[[group]]
kind = "RRR"
from = ["B", "D"]
meets = "C"
lengths = ["{b} m", "{c} m"]
coordinates = ["phi2", "phi3"]
mode = "-1"
[frame]
hinges = ["A", "D"]
"""
)
ROCKER = FOURBAR.format(a=0.1, b=0.35, c=0.25, d=0.4)
# A double crank: the follower goes round.
ROUND = FOURBAR.format(a=0.4, b=0.35, c=0.3, d=0.1)

# Two cranks of 0.1 m that turn against each other 0.6 m apart, and two links of 0.5 m: a mirror of itself.
TWO_CRANKS = """format = 1
title = "Five-bar linkage"
[given]
w0 = "10 rad/s"
[drive]
w1 = "w0"
w2 = "-w0"
[coordinates]
phi1 = { start = "0.3 rad", rate = "w1" }
phi2 = { start = "2.841592653589793 rad", rate = "w2" }
phi3 = { rate = "w3", unit = "rad" }
phi4 = { rate = "w4", unit = "rad" }
[time]
step = "2*pi/(40*w0)"
end = "2*pi/w0"
period = "2*pi/w0"
[points]
A = "(0, 0)"
D = "(0.6, 0)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["0.1 m"]
coordinates = ["phi1"]
[[group]]
kind = "crank"
from = ["D"]
meets = "C"
lengths = ["0.1 m"]
coordinates = ["phi2"]
[[group]]
kind = "RRR"
from = ["B", "C"]
meets = "P"
lengths = ["0.5 m", "0.5 m"]
coordinates = ["phi3", "phi4"]
mode = "+1"
[frame]
hinges = ["A", "D"]
"""

# A crank at constant speed, and a point that is driven up and down: two drives of two kinds.
FIVE_BAR = """format = 1
title = "Five-bar with a driven point and a crank"
[given]
r1 = "0.08 m"
r2 = "0.35 m"
r3 = "0.30 m"
V = "0.2 m/s"
p = "8 1/s"
n = "40 rpm"
[drive]
VMx = "0"
VMy = "V*cos(p*t)"
w1 = "n"
[coordinates]
phi1 = { start = "60 deg", rate = "w1" }
phi2 = { start = "0.9 rad", rate = "w2" }
phi3 = { start = "-0.9 rad", rate = "w3" }
[time]
step = "0.02 s"
end = "1.5 s"
[[constraint]]
name = "1"
equation = "-r1*w1*sin(phi1) - r2*w2*sin(phi2) - r3*w3*sin(phi3) = VMx"
[[constraint]]
name = "2"
equation = "r1*w1*cos(phi1) + r2*w2*cos(phi2) + r3*w3*cos(phi3) = VMy"
[points]
A = "(0, 0)"
B = "A + r1 @ phi1"
C = "B + r2 @ phi2"
M = "C + r3 @ phi3"
[links]
1 = { points = ["A", "B"], rate = "w1" }
2 = { points = ["B", "C"], rate = "w2" }
3 = { points = ["C", "M"], rate = "w3" }
[frame]
hinges = ["A"]
[closure]
driven = "M"
"""
