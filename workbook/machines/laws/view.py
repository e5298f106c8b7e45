"""The engine's view of the laws that are compared."""

from functools import cached_property
from typing import NamedTuple

from engine.laws import Dwell
from engine.laws.continuity import Meeting, code, continuity, meetings
from engine.laws.sections import abscissae
from workbook.laws.library import NamedLaw
from workbook.laws.sampling import Pieces
from workbook.machines.laws.entries import MOST_CURVES, MotionLaws


class Joined(NamedTuple):
    """A row of the table of joints: a law, the number of its piece, and where that begins."""

    one: NamedLaw
    k: int
    at: Meeting

    @property
    def code(self) -> int:
        """What tells law, end and order in one number."""
        return code(self.one.number, self.at)


class Compared:
    """The laws of a book, those that are drawn at ``xi``, those compared (all but the dwell), and where pieces meet."""

    def __init__(self, machine: MotionLaws, laws: list[NamedLaw], stack: Pieces) -> None:
        self.entered = [curve.law for curve in machine.comparison.curves]
        self.laws, self.stack, self.sizes = laws, stack, machine.sizes
        chosen = [*self.entered, *(self.entered[0] for _ in range(len(self.entered), MOST_CURVES))]
        known = {one.name: one for one in laws}
        self.curves = [known[name] for name in chosen]
        self.moving = [one for one in laws if not isinstance(one.law, Dwell)]
        self.xi = abscissae(self.sizes.cycle)

    @cached_property
    def smooth(self) -> list[tuple[int, int]]:
        """The highest derivative of s that is continuous, of each law at its ends and between them."""
        return [continuity(one.law) for one in self.moving]

    @cached_property
    def joints(self) -> list[Joined]:
        """The begin of each piece of each law, and of the rest behind it."""
        pieces = self.stack.pieces
        return [
            Joined(one, k, at) for one in self.moving for k, at in enumerate(meetings(one.law, pieces[one.number]), 1)
        ]

    def row_of(self, joined: Joined) -> int:
        """Return the row in the stack of a piece, counted from 1: behind the last piece of a law the dwell's."""
        number, k = joined.one.number, joined.k
        return self.stack.first[number] + k - 1 if k <= len(self.stack.pieces[number]) else self.stack.first[1]

    def first_of(self, joined: Joined) -> int:
        """Return the row of the first piece of a law in the table of joints, counted from 1."""
        return 1 + next(i for i, row in enumerate(self.joints) if row.one is joined.one)

    def least(self, figure: str) -> float:
        """Return the least of a coefficient among the laws whose acceleration does not jump; 0 where there is none."""
        kept = [one.law.coefficients for one, orders in zip(self.moving, self.smooth, strict=True) if min(orders) > 1]
        return float(min((getattr(each, figure) for each in kept), default=0.0))
