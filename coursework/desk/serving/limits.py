"""The limits of requests: so many per second on average, so many in a burst, so many at once.

Enters: who asks, and when (s).  Leaves: the seconds to wait, 0 if the request may pass.  Used by `guard.py`.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from dataclasses import dataclass, field

MOST_KNOWN = 20_000  # clients remembered; the least recent one is forgotten first, which does it no harm


@dataclass(slots=True)
class Rate:
    """A limit for each client: `rate` requests per second on average, `burst` in quick succession."""

    rate: float
    burst: float
    _left: OrderedDict[str, tuple[float, float]] = field(default_factory=OrderedDict)

    def wait(self, who: str, now: float) -> int:
        """Count a request of `who` at the time `now` (s); return 0 if it may pass, else the whole seconds to wait."""
        left, before = self._left.pop(who, (self.burst, now))
        left = min(self.burst, left + (now - before) * self.rate)
        passes = left >= 1
        self._left[who] = (left - passes, now)
        if len(self._left) > MOST_KNOWN:
            self._left.popitem(last=False)
        return 0 if passes else max(1, math.ceil((1 - left) / self.rate))


@dataclass(slots=True)
class Limits:
    """The limits of a desk that is open to others: per browser, per address (which a whole school may share), and at once."""

    client: Rate = field(default_factory=lambda: Rate(4, 20))
    address: Rate = field(default_factory=lambda: Rate(60, 300))
    at_once: int = 2
    _running: dict[str, int] = field(default_factory=dict)

    def wait(self, client: str, address: str, now: float) -> int:
        """Return the seconds that a request has to wait, 0 if it may pass."""
        return 1 if self._running.get(client, 0) >= self.at_once else self.too_often(client, address, now)

    def too_often(self, client: str, address: str, now: float) -> int:
        """Return the seconds that a request has to wait which may run beside any others."""
        return self.address.wait(address, now) or self.client.wait(client, now)

    def begin(self, client: str) -> None:
        """Count a request that is being answered."""
        self._running[client] = self._running.get(client, 0) + 1

    def end(self, client: str) -> None:
        """Stop counting a request that has been answered."""
        left = self._running.pop(client, 1) - 1
        if left > 0:
            self._running[client] = left
