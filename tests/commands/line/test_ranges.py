"""What numbers an option takes: the table beside the help, and each end of it with a value just inside and just outside."""

from __future__ import annotations

import math

import click

from coursework.commands.cli import main
from tests.command import call

# The least and the most that each option takes; a budget must be more than 0.
SOME = math.ulp(0.0)
LIMITED = ("run", "animate", "listing", "check", "accuracy", "edit")
RANGES: dict[tuple[str, str], tuple[float, float]] = {
    ("run", "--check-row"): (1, math.inf), ("run", "--jobs"): (1, math.inf),
    **{(name, option): (SOME, math.inf) for name in LIMITED for option in ("--budget", "--memory")},
    ("grade", "--jobs"): (0, 256), ("grade", "--limit"): (0.1, 3600), ("grade", "--memory"): (256, 65536),
    ("assign", "--help-level"): (0, 1), ("edit", "--port"): (0, 65535), ("serve", "--port"): (0, 65535),
    ("serve", "--workers"): (1, 64),
}  # fmt: skip
# What stands where nothing is chosen, for those that must not change under a class.
DEFAULTS = {("grade", "--limit"): 10.0, ("grade", "--memory"): 1024, ("grade", "--jobs"): 0, ("assign", "--help-level"): 0,
            ("run", "--jobs"): 1, ("edit", "--port"): 8531, ("serve", "--port"): 8531,
            **{(name, "--budget"): 60.0 for name in LIMITED}, **{(name, "--memory"): 1024.0 for name in LIMITED}}  # fmt: skip


def ranged() -> dict[tuple[str, str], click.Parameter]:
    """Every option of every command that takes a number of a range."""
    return {
        (name, option.opts[0]): option
        for name, command in main.commands.items()
        for option in command.params
        if isinstance(option.type, (click.IntRange, click.FloatRange))
    }


def is_taken(option: click.Parameter, number: float) -> bool:
    try:
        option.type.convert(f"{number:.17g}", option, None)
    except click.BadParameter:
        return False
    return True


def test_each_option_takes_its_least_and_most_and_nothing_beyond() -> None:
    assert ranged().keys() == RANGES.keys()
    for key, option in ranged().items():
        is_whole = isinstance(option.type, click.IntRange)
        for end, way in zip(RANGES[key], (-1, 1), strict=True):
            beyond = end + way if is_whole else math.nextafter(end, way * math.inf)
            if not is_whole:
                assert not is_taken(option, math.nan), key
            if math.isfinite(end):
                assert (is_taken(option, end), is_taken(option, beyond)) == (True, False), (key, end)


def test_options_of_a_range_have_the_defaults_that_the_help_names() -> None:
    assert {key: option.default for key, option in ranged().items() if key in DEFAULTS} == DEFAULTS
    assert DEFAULTS.keys() | {("run", "--check-row"), ("serve", "--workers")} == RANGES.keys()


def test_the_help_of_a_listing_names_every_scheme_and_what_its_options_are():
    told = " ".join(call("listing", "--help").stdout.split())
    assert "rk4, exact; under forces also semi-implicit (default" in told
    assert '"auto" with --error.' in told and "Language of comments and messages" in told
