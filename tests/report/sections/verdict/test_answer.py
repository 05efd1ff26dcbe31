"""The box on page 1: the summary of all checks is left out where its own verdict says as much; nothing unchecked is judged."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import pytest

from coursework.report.sections.verdict.answer import _says_all, _verdict


def check(code: str, verdict: str = "PASS", *, headline: str = "", unjudged: tuple[str, ...] = ()) -> SimpleNamespace:
    group = "motion" if code in {"ACCURACY", "PERIOD", "STABLE"} else "computation"
    return SimpleNamespace(code=code, verdict=verdict, group=group, headline=headline, unjudged=unjudged)


CLOSE, COARSE = check("ACCURACY"), check("ACCURACY", "COARSE")
RIGHT = check("ROWS")


@pytest.mark.parametrize(
    ("checks", "all_said"),
    [
        ([RIGHT, CLOSE], True),
        ([RIGHT, COARSE], True),
        ([RIGHT, COARSE, check("PERIOD", "COARSE")], True),
        ([RIGHT, CLOSE, check("PERIOD", "SKIP"), check("ORDER", "SKIP")], True),
        ([RIGHT, CLOSE, check("STOP", "FAIL", headline="stops")], True),  # the stop has been described already
        ([RIGHT, CLOSE, check("START", unjudged=("phi1",))], True),
        # The accuracy is not known, or what is odd is none of it, or more than that.
        ([RIGHT], False),
        ([RIGHT, check("ACCURACY", "SKIP")], False),
        ([RIGHT, CLOSE, check("PERIOD", "COARSE")], False),
        ([RIGHT, check("ACCURACY", "FAIL")], False),
        ([RIGHT, COARSE, check("PERIOD", "FAIL")], False),
        ([RIGHT, COARSE, check("ORDER", "COARSE")], False),
        ([check("ROWS", "FAIL"), CLOSE], False),
        ([check("ROWS", "ERROR"), COARSE], False),
        ([RIGHT, CLOSE, check("ORDER", headline="said first")], False),
        ([RIGHT, CLOSE, check("ORDER", unjudged=("phi1",))], False),
    ],
)
def test_the_verdict_says_all_of_an_ordinary_run(checks: list[Any], all_said: bool) -> None:
    context: Any = SimpleNamespace(run=SimpleNamespace(checks=checks, tableau=object()))
    assert _says_all(context) is all_said
    context.run.tableau = None  # exact rows: accuracy is no matter of theirs
    assert not _says_all(context)


@pytest.mark.parametrize(("asks", "checks", "rows", "told"), [
    (True, [RIGHT, CLOSE], 3, ["result.right", "result.close"]), (True, [check("ROWS", "FAIL")], 3, ["result.wrong"]),
    (False, [RIGHT, CLOSE], 3, []), (True, [CLOSE], 3, []), (True, [check("STOP")], 3, []), (True, [RIGHT, CLOSE], 0, []),
])  # fmt: skip
def test_rows_are_called_right_only_where_there_are_some_and_their_computing_was_checked(
    asks: bool, checks: list[Any], rows: int, told: list[str]
) -> None:
    run = SimpleNamespace(checks=checks, asks=lambda _: asks, motion=SimpleNamespace(t=range(rows)), stop=None)
    words = Mock(side_effect=lambda key, **_: key, sentences=list)
    found: Any = _verdict(SimpleNamespace(run=run, words=words, lettered=list))  # type: ignore[arg-type]
    assert found == told
