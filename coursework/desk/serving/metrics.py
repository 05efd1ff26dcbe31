"""The metrics of the server: how many requests, how long they took, how many processes were replaced.

Enters: a route, a status, seconds.  Leaves: text for Prometheus.  Used by `application.py`.
No text and no name is stored.
"""

from __future__ import annotations

from collections import Counter, defaultdict, deque
from collections.abc import Iterator
from functools import partial

KEPT = 1000  # latest requests of each route, from which the quantiles are computed
QUANTILES = (0.5, 0.9, 0.95, 0.99)


class Metrics:
    """The counts since the start of the server."""

    def __init__(self) -> None:
        self._requests: Counter[tuple[str, int]] = Counter()
        self._seconds: defaultdict[str, deque[float]] = defaultdict(partial(deque, maxlen=KEPT))
        self._sums: Counter[str] = Counter()

    def count(self, route: str, status: int, seconds: float) -> None:
        """Count an answer of a route that took `seconds`."""
        self._requests[route, status] += 1
        self._seconds[route].append(seconds)
        self._sums[route] += seconds  # type: ignore[assignment]  # a sum of seconds, as Prometheus wants it

    def text(self, ended: int, waiting: int) -> str:
        """Return all metrics as Prometheus reads them; `ended`: processes that were replaced, `waiting`: jobs under way."""
        return "\n".join([*self._lines(ended, waiting), ""])

    def _lines(self, ended: int, waiting: int) -> Iterator[str]:
        yield "# TYPE coursework_requests_total counter"
        for (route, status), number in sorted(self._requests.items()):
            yield f'coursework_requests_total{{route="{route}",status="{status}"}} {number}'
        yield "# TYPE coursework_request_seconds summary"
        for route, times in sorted(self._seconds.items()):
            ordered = sorted(times)
            for part in QUANTILES:
                value = ordered[min(len(ordered) - 1, int(part * len(ordered)))]
                yield f'coursework_request_seconds{{route="{route}",quantile="{part}"}} {value:.6f}'
            yield f'coursework_request_seconds_sum{{route="{route}"}} {self._sums[route]:.6f}'
            number = sum(number for (of, _), number in self._requests.items() if of == route)
            yield f'coursework_request_seconds_count{{route="{route}"}} {number}'
        yield "# TYPE coursework_workers_restarted_total counter"
        yield f"coursework_workers_restarted_total {ended}"
        yield "# TYPE coursework_jobs_waiting gauge"
        yield f"coursework_jobs_waiting {waiting}"
