"""The tables of what the steps of axes take from their neighbours, and what becomes of their laws."""

from __future__ import annotations

from collections.abc import Sequence

from workbook.book.declare import Sheet, calc
from workbook.machines.machine.boundary.asked import asked
from workbook.machines.machine.boundary.carried import carried
from workbook.machines.machine.boundary.extremes import extremes, points
from workbook.machines.machine.boundary.handing import Handing
from workbook.machines.machine.boundary.kinds import kinds

TITLE = "Workings: what phases take from their neighbours"
ABOUT = (
    "A straight line hands its velocity to both neighbours. y = v0 u + h_a s(ξ) up to the greatest velocity of a law "
    "of two pulses, from then on y_1 − v1 (δ − u) − h_b (1 − s(ξ)); a polynomial is Σ e_n ξⁿ. Extremes: "
    "at 201 points, at most 0.05 % below."
)


def place_boundaries(sheet: Sheet, axes: Sequence[Handing]) -> None:
    """Declare the tables of each axis that hands velocity over."""
    if not axes:
        return
    sheet.heading(TITLE, ABOUT)
    for one in axes:
        at, axis, spare = one.rows.at, f"axis {one.axis.number}", f"INDEX([{one.rows.at.phases}.span],[k])=0"
        sheet.rows(calc(one.last, f"Last step of {axis}", "", "",
                        f"=SUMPRODUCT(MAX(([{at.phases}.span]>0)*[{at.phases}.k]))", one.axis.places[-1] + 1,
                        format="0"))  # fmt: skip
        for name, title, columns in (
            (one.asked, f"What the steps of {axis} take", asked),
            (at.ends, f"How the steps of {axis} are carried out", lambda one: [*carried(one), *extremes(one)]),
            (one.kinds, f"Ends of the steps of {axis}", kinds),
        ):
            sheet.table(name, title, one.room, *columns(one), blank=spare)
    points(sheet.book, sheet)
