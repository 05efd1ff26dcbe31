"""What the server counts, as Prometheus reads it."""

import pytest

from coursework.desk.serving.metrics import KEPT, Metrics


def told(metrics, ended=0, waiting=0):
    """Return the values by their names."""
    lines = (line.rpartition(" ") for line in metrics.text(ended, waiting).splitlines() if not line.startswith("#"))
    return {name.removeprefix("coursework_"): float(value) for name, _, value in lines}


def test_requests_are_counted_by_route_and_status_and_their_seconds_added_up():
    metrics = Metrics()
    for status, seconds in ((200, 0.25), (200, 0.5), (400, 0.125)):
        metrics.count("check", status, seconds)
    metrics.count("page", 200, 2.0)
    values = told(metrics, ended=3, waiting=7)
    assert values['requests_total{route="check",status="200"}'] == 2
    assert values['requests_total{route="check",status="400"}'] == 1
    assert values['request_seconds_count{route="check"}'] == 3
    assert values['request_seconds_sum{route="check"}'] == pytest.approx(0.875)
    assert values['request_seconds_sum{route="page"}'] == pytest.approx(2.0)
    assert (values["workers_restarted_total"], values["jobs_waiting"]) == (3, 7)


@pytest.mark.parametrize(("part", "seconds"), [(0.5, 51), (0.9, 91), (0.95, 96), (0.99, 100)])
def test_so_many_of_a_hundred_requests_took_less(part, seconds):
    metrics = Metrics()
    for second in reversed(range(1, 101)):
        metrics.count("check", 200, second)
    assert told(metrics)[f'request_seconds{{route="check",quantile="{part}"}}'] == seconds


def test_quantiles_are_of_the_latest_requests_and_the_sum_of_all():
    metrics = Metrics()
    for second in [9.0] * 10 + [1.0] * KEPT:
        metrics.count("check", 200, second)
    values = told(metrics)
    assert values['request_seconds{route="check",quantile="0.99"}'] == 1
    assert values['request_seconds_sum{route="check"}'] == 90 + KEPT
