"""Files spoilt at random: whatever is wrong with them is a fault of the file with a sentence, never a crash of the tool."""

import re

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import coursework
from coursework.catalogue import names
from coursework.data import folder
from coursework.variant.reader import parse_variant

TEXTS = {name: (folder("variants") / f"{name}.toml").read_text(encoding="utf-8") for name in names() if "-table" not in name}
PIECES = [
    "0", "1", "-1", "1e9", "nan", "inf", "true", '""', '"0"', '"1 m"', "[", "{", "[]", "{}", "phi1", "w1", "w4", "r1", "t",
    "pi", "sin(", "cos(", ")", "(", "*", "/", "^", "+", "-", " = ", "=", "@", ".x", ".y", '"', "'", "\n", "[drive]",
    "[[constraint]]", "[points]", "D", "A", "M", "VMx", "9**9", "exp(", "sqrt(", "abs(", "log(", "asin(", "atan2(", "1/0",
    ",", "#", "φ1", "deg", "rate", "start", "closure", "driven", "kind", '"RRR"', "mode", "1000000", "1e-30", "0 @ phi1",
    "", "\ufeff", "\x00", "с",
]  # fmt: skip
WORD = re.compile(r"[^\W\d]\w*|[\d.]+|[^\s\w]")


@st.composite
def spoilt_files(draw):
    """Return a file of the catalogue with up to three words or lines exchanged, taken out or put in."""
    text = TEXTS[draw(st.sampled_from(sorted(TEXTS)))]
    for _ in range(draw(st.integers(1, 3))):
        kind = draw(st.integers(0, 3))
        words, lines = list(WORD.finditer(text)), text.split("\n")
        word = words[draw(st.integers(0, len(words) - 1))]
        if kind == 0:
            text = text[: word.start()] + draw(st.sampled_from(PIECES)) + text[word.end() :]
        elif kind == 1:
            other = words[draw(st.integers(0, len(words) - 1))]
            text = text[: word.start()] + other[0] + text[word.end() :]
        elif kind == 2:
            del lines[draw(st.integers(0, len(lines) - 1))]
            text = "\n".join(lines)
        else:
            text = text[: word.start()] + draw(st.sampled_from(PIECES)) + text[word.start() :]
    return text


# The same files every time: a new crash is looked for by raising the number, not by every run of the tests.
@settings(
    max_examples=120, derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large]
)
@given(spoilt_files())
def test_a_spoilt_file_is_computed_or_told(text):
    try:
        run = coursework.solve(parse_variant(text, "spoilt.toml"), quantities=["table", "checks"])
        names, rows = run.columns()
        assert rows.shape == (len(run.motion.t), len(names))
        assert run.stop is not None or len(run.checks) > 3
    except coursework.CourseworkError as error:
        assert str(error)
        assert str(error).replace("\n", "").isprintable()
