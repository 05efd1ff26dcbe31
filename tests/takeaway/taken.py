"""What a format of the takeaway makes of a file of the catalogue, made once a process; nobody changes it."""

from functools import cache

from coursework.report.output.formats import formats_for
from coursework.report.output.results import Results
from tests.solved import solved


@cache
def results_of(name: str, language: str = "en") -> Results:
    """Return a run ready to be written, its page made."""
    results = Results(solved(name), language, live=False)
    results.compute(pages=True)
    return results


@cache
def taken(name: str, suffix: str, language: str = "en") -> dict[str, bytes]:
    """Return the files of a format."""
    return dict(formats_for("run")[suffix].write(results_of(name, language)))
