"""The long runs of a night: marked ``nightly``, with other seeds each night (CONTRIBUTING.md tells the tiers)."""

from collections import defaultdict
from random import Random

import pytest

PARTS = 16
"""of a night, one of which runs with every change"""

CASES = 1
"""of a test that has a list of them, in one night; what is drawn is drawn anew and runs whole"""

night = 0
"""The seed of this run, as ``--hypothesis-seed`` gives it (conftest.py); 0 where nobody gives one."""


def nights(runs):
    """So many numbers of runs, each a test of its own, for a night only."""
    return [pytest.param(k, marks=pytest.mark.nightly, id=f"night {k}") for k in range(runs)]


def by_day(names, *day):
    """The names as parameters, those of ``day`` every day and the others for a night: each template has its share."""
    return [pytest.param(name, marks=[] if name in day else pytest.mark.nightly) for name in names]


def seed(number):
    """The seed of one thing drawn in this night: another one in every other night, and never one of a day's."""
    return f"{night}, {number}"


def sampled(items):
    """Leave all cases but n of a test that is marked ``sample(n)`` to a night: of those that are not there already."""
    cases = defaultdict(list)
    for item in items:
        if item.get_closest_marker("sample") and not item.get_closest_marker("nightly"):
            cases[item.nodeid.partition("[")[0]].append(item)
    for some in cases.values():
        (count,) = some[0].get_closest_marker("sample").args
        by_day = {k * len(some) // count for k in range(count)}
        for k, item in enumerate(some):
            if k not in by_day:
                item.add_marker("nightly")


def of_this_night(items):
    """Return the tests without the listed cases of other nights: this night's seed chooses one of each test."""
    listed = defaultdict(list)
    for item in items:
        if item.get_closest_marker("nightly") and "night " not in item.nodeid:
            listed[item.nodeid.partition("[")[0]].append(item.nodeid)
    chosen = {
        case for test, cases in listed.items() for case in Random(seed(test)).sample(cases, min(CASES, len(cases)))
    }
    left = {case for cases in listed.values() for case in cases} - chosen
    return [item for item in items if item.nodeid not in left]


def shared(items, commit):
    """Return the nightly tests of a share: every sixteenth, from one on that the hash of a commit chooses."""
    nightly = [item for item in items if item.get_closest_marker("nightly")]
    return nightly[int(commit[:8], 16) % PARTS :: PARTS]
