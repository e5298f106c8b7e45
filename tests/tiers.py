"""The long runs of a night: marked ``nightly``, with other seeds each night (CONTRIBUTING.md tells the tiers)."""

import pytest

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
