"""The mechanism of variant 31 without its drive: two degrees of freedom, moved by two motors; what tests share."""

from tests.mechanisms.library import mechanism


def free_31(motor='rates = ["w1", "w2"]\nstart = { w1 = "-1.5 rad/s", w2 = "-0.7 rad/s" }\n'):
    """Return the file: positions say what the written equations said with the drive in them."""
    text = mechanism("31-forces")
    begin, rest = text.split("[drive]", 1)
    _, rest = rest.split("[coordinates]", 1)
    before, rest = rest.split("[[constraint]]", 1)
    _, rest = rest.split("# --- geometry", 1)
    text = f"{begin}[coordinates]{before}# --- geometry{rest}"
    text = text.replace('driven = "M"                   # M(t) = M(0) + integral of (VMx, VMy)\n', "")
    text = text.replace('period    = "2*pi/p"', "# period").replace("check_row = 4", "# check_row")
    text = text.split("# --- texts of the page")[0]
    text = text.replace("[ask]", f"[motor]\n{motor}\n[ask]")
    return text.replace('"checks", "forces", "energy"', '"dynamics", "energy"')
