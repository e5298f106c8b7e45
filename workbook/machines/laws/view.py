"""The engine's view of the laws that are compared."""

from typing import NamedTuple

import numpy as np

from engine.laws import Dwell
from engine.laws.inverse import LawJoint, continuity, law_joints
from workbook.law_sheets.library import NamedLaw
from workbook.laws.sampling import Pieces
from workbook.machines.laws.entries import MOST_CURVES, MotionLaws


class JointRow(NamedTuple):
    """A row of the table of joints: a law, the number of its piece, where that begins, and its row in the stack."""

    law: NamedLaw
    k: int
    at: LawJoint
    row: int  # counted from 1: behind the last piece of a law the dwell's
    first: int  # the row of the law's first piece in the table of joints, counted from 1


class ComparedLaws:
    """The laws of a book, those that are drawn at ``xi``, those compared (all but the dwell), and where pieces meet."""

    def __init__(self, machine: MotionLaws, laws: list[NamedLaw], stack: Pieces) -> None:
        self.entered = [curve.law for curve in machine.comparison.curves]
        self.laws, self.stack, self.sizes = laws, stack, machine.sizes
        chosen = [*self.entered, *(self.entered[0] for _ in range(len(self.entered), MOST_CURVES))]
        known = {law.name: law for law in laws}
        self.curves = [known[name] for name in chosen]
        self.moving = [law for law in laws if not isinstance(law.law, Dwell)]
        self.xi = np.arange(self.sizes.cycle + 1) / self.sizes.cycle
        # the order of each law's continuity at its ends and between them
        self.smooth: list[tuple[int, int]] = []
        # the begin of each piece of each law, and of the rest behind it
        self.joints: list[JointRow] = []
        for law in self.moving:
            pieces = stack.pieces[law.number]
            begun = stack.first[law.number]
            first = len(self.joints) + 1
            joints = law_joints(law.law, pieces)
            self.smooth.append(continuity(joints))
            for k, at in enumerate(joints, 1):
                row = begun + k - 1 if k <= len(pieces) else stack.first[1]
                self.joints.append(JointRow(law, k, at, row, first))

    def least(self, figure: str) -> float:
        """Return the least of a coefficient among the laws whose acceleration does not jump; 0 where there is none."""
        smooth_coefficients = [
            law.law.coefficients for law, orders in zip(self.moving, self.smooth, strict=True) if min(orders) > 1
        ]
        return float(min((getattr(each, figure) for each in smooth_coefficients), default=0.0))
