"""The engine's view of the laws that are compared."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws import Dwell
from engine.laws.continuity import Meeting, continuity, meetings
from workbook.laws.library import NamedLaw
from workbook.laws.sampling import Pieces
from workbook.machines.laws.entries import MOST_CURVES, MotionLaws


class Joined(NamedTuple):
    """A row of the table of joints: a law, the number of its piece, where that begins, and its row in the stack."""

    one: NamedLaw
    k: int
    at: Meeting
    row: int  # counted from 1: behind the last piece of a law the dwell's
    first: int  # the row of the law's first piece in the table of joints, counted from 1


class Compared:
    """The laws of a book, those that are drawn at ``xi``, those compared (all but the dwell), and where pieces meet."""

    def __init__(self, machine: MotionLaws, laws: list[NamedLaw], stack: Pieces) -> None:
        self.entered = [curve.law for curve in machine.comparison.curves]
        self.laws, self.stack, self.sizes = laws, stack, machine.sizes
        chosen = [*self.entered, *(self.entered[0] for _ in range(len(self.entered), MOST_CURVES))]
        known = {one.name: one for one in laws}
        self.curves = [known[name] for name in chosen]
        self.moving = [one for one in laws if not isinstance(one.law, Dwell)]
        self.xi = np.arange(self.sizes.cycle + 1) / self.sizes.cycle

    @cached_property
    def smooth(self) -> list[tuple[int, int]]:
        """The highest derivative of s that is continuous, of each law at its ends and between them."""
        return [continuity(one.law) for one in self.moving]

    @cached_property
    def joints(self) -> list[Joined]:
        """The begin of each piece of each law, and of the rest behind it."""
        found: list[Joined] = []
        for one in self.moving:
            pieces, begun, first = self.stack.pieces[one.number], self.stack.first[one.number], len(found) + 1
            for k, at in enumerate(meetings(one.law, pieces), 1):
                row = begun + k - 1 if k <= len(pieces) else self.stack.first[1]
                found.append(Joined(one, k, at, row, first))
        return found

    def least(self, figure: str) -> float:
        """Return the least of a coefficient among the laws whose acceleration does not jump; 0 where there is none."""
        kept = [one.law.coefficients for one, orders in zip(self.moving, self.smooth, strict=True) if min(orders) > 1]
        return float(min((getattr(each, figure) for each in kept), default=0.0))
