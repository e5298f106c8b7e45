"""The places where the acceleration of a polynomial with velocity at its ends is largest or lowest, in cells.

There a drive's intervals are cut. The jerk of a polynomial of degree 5, and of degree 7 over ξ (1 − ξ), is
A + B ξ + C ξ²: it is 0 at W/C and at A/W, W = −(B ± √(B² − 4 A C))/2.
"""

from collections.abc import Callable

from engine.motion.handover import Handover
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.machines.machine.boundary.handover import AxisHandover

CELLS = cell_tables(__file__)

BENT_FROM = 5  # degree from which on the acceleration of a polynomial may bend


def bends_name(handover: AxisHandover) -> str:
    """Return the name of the table of an axis."""
    return f"{handover.entries}_bends"


def rows_of_phases(handover: AxisHandover) -> int:
    """Return the number of rows for phases: each stands in every second row of the table of steps."""
    return handover.room // 2


def polynomials(handover: AxisHandover) -> int:
    """Return how many phases are carried out as a polynomial whose acceleration may bend."""
    return sum(step.mode >= BENT_FROM for _, step in handover.phases)


def bend_angles(handover: AxisHandover) -> list[float]:
    """Return where the acceleration of each phase bends first, and then where second (°); 360 for none."""
    rows = [step for _, step in handover.phases]
    begins = [phase.start for phase in handover.axis.given.phases]
    spans = [phase.stop - phase.start for phase in handover.axis.given.phases]
    bends = []
    for i in (0, 1):
        shares = [step.bends[i] for step in rows]
        angles = [
            begin + span * share if 0.0 < share < 1.0 else TURN
            for begin, span, share in zip(begins, spans, shares, strict=True)
        ]
        bends += filled(angles, rows_of_phases(handover), TURN)
    return bends


def bends_table(sheet: Sheet, handover: AxisHandover) -> None:
    """Declare the table, a row for each phase."""
    column = handover.columns(CELLS["bends_table"])
    room = rows_of_phases(handover)
    at = handover.rows.at
    phases = [step for _, step in handover.phases]
    size, angles = handover.motion.size(0), bend_angles(handover)

    def e(n: int) -> str:
        return f"INDEX([{at.ends}.e{n}],2*[k])" if n < handover.rows.powers else "0"

    def of(figure: Callable[[Handover], float]) -> list[float]:
        return filled([figure(step) for step in phases], room)

    def power(name: str, quintic: str, septic: str) -> Quantity:
        values = of(lambda step: step.jerk_powers["abc".index(name)])
        return column(name, values, y=at.y, quintic=quintic, septic=septic, scale=100.0 * size)

    CELLS["bends_table"].sharing(i=handover.axis.number).place(
        sheet,
        column("k", list(range(1, room + 1))),
        column("mode", filled([step.mode for step in phases], room, 0)),
        power("a", f"6*{e(3)}", f"24*{e(4)}"),
        power("b", f"24*{e(4)}", f"60*{e(5)}+24*{e(4)}"),
        power("c", f"60*{e(5)}", f"0-210*{e(7)}"),
        column("w", of(lambda step: step.jerk_root), y=at.y, scale=100.0 * size),
        column("x0", of(lambda step: step.bends[0]), scale=1.0),
        column("x1", of(lambda step: step.bends[1]), scale=1.0),
        column("at0", angles[:room], scale=TURN),
        column("at1", angles[room:], scale=TURN),
        blank=f"[mode]<{BENT_FROM}",
    )
