"""The one way benchmarks take time: both sides alternately, in processor time, the least of several rounds.

Enters: two pieces of work.  Leaves: their ratio.  A busy machine only ever adds to a time, so rounds go on while the limit
is missed; a work that is really too slow stays too slow in every round.
"""

import time

ROUNDS = 8


def spent(work, repeats, clock=time.process_time):
    """Return the least processor time (s) of one call; `clock` is another where other programs are at work for it."""
    times = []
    for _ in range(repeats):
        begun = clock()
        work()
        times.append(clock() - begun)
    return min(times)


def ratio(ours, yardstick, *, most=0.0, repeats=9, clock=time.process_time):
    """Return time of `ours` over time of `yardstick`; further rounds are made while it is above `most`."""
    mine = bare = float("inf")
    for _ in range(ROUNDS):
        mine, bare = min(mine, spent(ours, repeats, clock)), min(bare, spent(yardstick, repeats, clock))
        if mine <= most * bare:
            break
    return mine / bare
