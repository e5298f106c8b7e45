"""A drive of a changing ratio over its motion: also where phases pass the points of a table."""

from __future__ import annotations

from engine.mechanisms.linkage import near_end
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.linked.driven import LinkedDriven, PlacedDriven
from workbook.machines.machine.linked.passes import Passes
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.stretched import Stretched


class LinkedWork(PlacedWork):
    """Such a drive over the stretches of its axis' motion."""

    varies = True
    too_few = "too near to a dead centre, or power turns round too often, for the places of this sheet"

    def __init__(self, one: AxisRows, driven: LinkedDriven) -> None:
        super().__init__(one, driven)
        self.linked = driven
        self.passes = Passes(one, driven)

    @property
    def rows(self) -> int:
        """Rows of the table of stretches."""
        return super().rows + self.passes.rows

    @property
    def turn_rows(self) -> int:
        """Rows of the table of where power turns round."""
        return super().turn_rows + self.passes.turns

    @property
    def further(self) -> list[tuple[float, str]]:
        """Where else a stretch begins: where phases pass points of a table."""
        return [*super().further, *self.passes.further]

    @property
    def further_in(self) -> float:
        """By how much a stretch's position counts as farther than it is: at the end of a table."""
        return -min(0.0, near_end(self.linked.linkage))


def over_motion(one: AxisRows, driven: Driven) -> Stretched:
    """Return a drive over its axis' motion, as its torque is worked out."""
    if isinstance(driven, LinkedDriven):
        return LinkedWork(one, driven)
    return PlacedWork(one, driven) if isinstance(driven, PlacedDriven) else Stretched(one, driven)
