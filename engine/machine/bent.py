"""Parts of a cycle between cuts, and places in it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise


def stretches(cuts: Iterable[float], total: float, near: float) -> list[tuple[float, float]]:
    """Return what lies between cuts from 0 to ``total``; cuts no farther apart than ``near`` are one."""
    found = [0.0]
    for cut in sorted(cuts):
        if cut > found[-1] + near:
            found.append(cut)
    if total - found[-1] > near:
        found.append(total)
    return list(pairwise(found))


def middle(span: tuple[float, float]) -> float:
    """Return the middle of a stretch."""
    return 0.5 * (span[0] + span[1])


def turned(angle: float, late: float, cycle: float, near: float = 0.0) -> float:
    """Return the place in the cycle of a place in a motion that is so late; so near before its begin it is on that."""
    place = angle + late
    return place - cycle * math.floor((place + near) / cycle)
