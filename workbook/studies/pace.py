"""How long designs take: measured before a study begins, to cut it into parts and to say when it will be done."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from workbook.studies.evaluate import Evaluator
from workbook.studies.plan import Plan
from workbook.studies.space import Space

TARGET = 2.0
"""seconds that a part takes, about: progress moves, and little is lost where the work is interrupted"""
MOST = 10.0
MOST_ROWS = 20_000
TOGETHER = 24
"""designs worked out together to measure what one more takes"""


@dataclass(frozen=True)
class Pace:
    """Seconds for designs that differ only in what scales: what comes first, and for each at most."""

    first: float
    each: float

    def seconds(self, space: Space) -> float:
        """Return how long all designs take one behind the other, at most (s)."""
        return space.size * (self.each + self.first / space.inner)

    def step(self, space: Space) -> int:
        """Return how many designs a part has: as many as take :data:`TARGET`; a whole group up to :data:`MOST` s."""
        inner = space.inner
        rows = int(min(MOST_ROWS, max(1.0, TARGET / max(self.each + self.first / inner, 1e-9))))
        if rows >= inner:
            return rows - rows % inner
        return inner if self.first + self.each * inner <= MOST and inner <= MOST_ROWS else rows


def paced(plan: Plan) -> Pace:
    """Return how long designs of a study take, measured at a few of them."""
    one, space = Evaluator(plan, thorough=True), plan.space
    alone = max(timed(one, space, number, number + 1) for number in {0, space.size // 2, space.size - 1})
    count = min(TOGETHER, space.inner, space.size)
    if not one.swift or count == 1:
        return Pace(0.0, alone)
    known, together = timed(one, space, 0, 1), timed(one, space, 0, count)
    each = max(0.0, together - known) / (count - 1)
    return Pace(max(0.0, alone - each), each)


def timed(one: Evaluator, space: Space, begin: int, end: int) -> float:
    """Return how long some designs take (s); of a search, as many in the middle of all ranges."""
    middle = np.full((end - begin, len(space.dimensions)), 0.5)
    columns = space.shared(middle) if space.way.kind == "evolution" else space.columns(begin, end)
    begun = time.perf_counter()
    one.table(begin, columns)
    return time.perf_counter() - begun
