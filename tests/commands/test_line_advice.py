"""What is told of a slip on the command line: what was typed, in every language, and no line of a file that does not have it."""

from pathlib import Path

import pytest

from tests.command import call
from tests.variant.judging.test_advice_followed import SAW

pytestmark = pytest.mark.usefixtures("folder")
NO_ARGUMENT = {
    "en": "was not expected here",
    "ru": "этого здесь не ожидалось",
    "uk": "цього тут не очікувалося",
    "zh": "此处不应有",
}


@pytest.fixture(autouse=True)
def saw(folder):
    Path("saw.toml").write_text(SAW, encoding="utf-8")


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("run saw --step 0,01", 'such as h/4, was expected, found "0,01". Decimals are written with a point.'),
        ("run saw --end 0,5", "found '0,5'. Decimals are written with a point."),
        ("run saw --set N=99", "V077 saw, check_row: row 101 is beyond the last row, 61."),
        ("run saw --check-row 99", "V077 saw, check_row: row 99 is beyond the last row, 61."),
        ("run saw --set om=q", 'V052 saw, om: symbol "q" is a coordinate'),
        ("run saw --set step=1s", "V071 saw.toml:17:7  time.end: the end (0.6 s) must be at least one step (1 s)."),
        ("run saw --quantities w4", "listing, flowchart, q, s, om, ws, vB."),
        ("check saw --step 3", 'C051 there is no option --step. "coursework COMMAND --help" lists them.'),
        ("run saw –-step 0.01", "C100 –-step begins with a dash, not with hyphens. Write --step."),
        ("run saw —format=csv", "C100 —format begins with a dash, not with hyphens. Write --format."),
        ("run –h", "C100 –h begins with a dash, not with hyphens. Write -h."),
        ("--language en check saw", "C101 --language stands behind the command: coursework COMMAND … --language."),
        ("--nope run saw", "C051 there is no option --nope."),
        ("run", "C052 VARIANT is missing."),
        ("animate saw --out saw.mp4", "W011 saw.mp4  the name of this file must end in .gif (found .mp4)."),
    ],
)
def test_a_slip_is_told_where_it_was_typed(line, told):
    result = call(*line.split())
    assert result.exit_code == 2
    assert told in result.stderr, result.stderr
    assert not Path("saw.mp4").exists()


@pytest.mark.parametrize("language", NO_ARGUMENT)
def test_one_name_too_many_is_told_in_every_language(language):
    """The parts of a name with spaces arrive as two names."""
    result = call("check", "saw", "blade", "--language", language)
    assert result.exit_code == 2
    assert f"{NO_ARGUMENT[language]}" in result.stderr and "blade" in result.stderr and "Got unexpected" not in result.stderr
    assert call("check", "saw").exit_code == 0
