"""What a format of the takeaway makes of a file of the catalogue, made once a process; nobody changes it."""

from functools import cache

from coursework.report.output.formats import formats_for
from coursework.report.output.results import Results
from tests.solved import solved


@cache
def results_of(name: str, language: str = "en", pages: bool = True) -> Results:
    """Return a run ready to be written, with all that its page needs if there are `pages`."""
    results = Results(solved(name), language, live=False)
    results.compute(pages)
    return results


@cache
def taken(name: str, suffix: str, language: str = "en") -> dict[str, bytes]:
    """Return the files of a format."""
    wanted = formats_for("run")[suffix]
    return dict(wanted.write(results_of(name, language, wanted.paged)))
