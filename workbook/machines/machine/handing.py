"""What the phases of an axis take from their neighbours, where rests stand between them: in the table of its steps."""

from __future__ import annotations

from collections.abc import Sequence

from engine.motion.handover import Handover
from workbook.book.declare import Quantity, calc
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows
from workbook.motion.ends import Ends
from workbook.motion.neighbours import Formulas

PHASE, REST = 1, 0
"""of the number of a row in the table of steps, from 0: the remainder of a phase and of a rest"""


def halved(row: str) -> str:
    """Return the formula of the row of a phase as it is entered, from its row in the table of steps."""
    return f"({row}/2)"


def doubled(formula: str) -> str:
    """Return a formula that takes a figure of the same row, of which phases stand in every second."""
    return formula.replace(",[k])", ",2*[k])")


class StepEnds(Ends):
    """The same for a table in which phases stand in the second, fourth, sixth row, and rests between them."""

    def __init__(self, rows: PieceRows, axis: MovingAxis, used: str) -> None:
        self.axis = axis
        name = f"[axes.name.{axis.number}]", axis.given.name
        super().__init__(rows, axis.joined, axis.given.phases, used, name, entered=axis.passed)

    @property
    def name_of_phases(self) -> str:
        """The table in which the phases are entered."""
        return self.rows.at.phases.removesuffix("_steps")

    @property
    def places(self) -> Sequence[int]:
        """The row, from 0, of each step of the motion."""
        return self.axis.places

    @property
    def numbered(self) -> list[tuple[int, Handover]]:
        """The phases with the numbers, from 1, of the rows in which they are entered."""
        return [(i, self.handed[k]) for i, k in enumerate(self.axis.entered, 1)]

    def told(self, row: str) -> tuple[str, str]:
        """Return the formulas of a row's number as it is entered, and of its law."""
        return halved(row), f"INDEX([{self.name_of_phases}.law],{halved(row)})"

    def entries_at(self) -> tuple[Formulas, Formulas, Formulas]:
        """Return the formulas of what is entered: nothing for rests."""
        none = "=0*[k]"
        each = [
            self.set_by(f"[{self.name_of_phases}.velocity.{row}]", f"[{self.name_of_phases}.acceleration.{row}]")
            for row in range(1, self.axis_room + 1)
        ]
        whether, velocity, acceleration = (
            [none, *(text for formula in column for text in (formula, none))] for column in zip(*each, strict=True)
        )
        return whether, velocity, acceleration

    @property
    def axis_room(self) -> int:
        """Rows of the table in which the phases are entered."""
        return len(range(PHASE, self.room, len((REST, PHASE))))

    def beside(self) -> list[Quantity]:
        """Return the columns that tell the rows before and after: of a rest that has no length the phase behind it."""
        phases, last = self.rows.at.phases, f"2*{self.used}"
        lasts = f"INDEX([{phases}.span],{{0}})>0"
        before, after = zip(*(self._next_to(row) for row in range(self.room)), strict=True)
        wrapped = f"IF({lasts.format(f'{last}+1')},{last}+1,{last})"
        again = f"IF({lasts.format('1')},1,2)"
        return [
            calc("before", "row before", "", "",
                 f"=IF([k]=1,{wrapped},IF({lasts.format('[k]-1')},[k]-1,IF([k]=2,{wrapped},[k]-2)))", list(before),
                 format="0"),
            calc("after", "row after", "", "",
                 f"=IF([k]>{last},{again},IF({lasts.format('[k]+1')},[k]+1,IF([k]={last},{again},MIN([k]+2,{last}))))",
                 list(after), format="0"),
        ]  # fmt: skip

    def _next_to(self, row: int) -> tuple[int, int]:
        """Return the rows, from 1, before and behind a row, from 0, as the cells count them."""
        used, phases = set(self.places), max(self.numbered)[0]
        last, k = phases + phases, row + 1
        wrapped = last + 1 if last in used else last
        again = 1 if 0 in used else 2
        before = wrapped if k == 1 else k - 1 if k - 2 in used else wrapped if k == 2 else k - 2
        after = again if k > last else k + 1 if k in used else again if k == last else min(k + 2, last)
        return before, after
