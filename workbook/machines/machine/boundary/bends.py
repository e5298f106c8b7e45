"""Where the acceleration of a polynomial that takes velocity from its neighbours is largest or lowest, in cells.

There a drive's intervals are cut. The jerk of a polynomial of degree 5, and of degree 7 over ξ (1 − ξ), is
A + B ξ + C ξ²: it is 0 at W/C and at A/W, W = −(B ± √(B² − 4 A C))/2.
"""

from collections.abc import Callable

from engine.motion.handover import Handover
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.machines.machine.boundary.handover import AxisHandover

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
    room, at, phases = rows_of_phases(handover), handover.rows.at, [step for _, step in handover.phases]
    ends, steps, size = f"[{at.ends}.{{}}]", at.phases, handover.motion.size(0)
    angles = bend_angles(handover)

    def e(n: int) -> str:
        return f"INDEX({ends.format(f'e{n}')},2*[k])" if n < handover.rows.powers else "0"

    def by_degree(quintic: str, septic: str) -> str:
        return f"=IF([mode]=5,{quintic},IF([mode]=7,{septic},0))"

    def power(name: str, formula: str, figure: Callable[[Handover], float]) -> Quantity:
        return calc(name, f"power {'abc'.index(name)} of its jerk", name.upper(), at.y, formula,
                    filled([figure(step) for step in phases], room), scale=100.0 * size)  # fmt: skip

    def angle(k: int) -> Quantity:
        share = ("IF([c]=0,0,[w]/[c])", "IF([w]=0,0,[a]/[w])")[k]
        shares = filled([step.bends[k] for step in phases], room)
        return calc(f"x{k}", f"{('first', 'second')[k]} zero of its jerk", "ξ", "", f"={share}", shares, scale=1.0)

    def place(k: int) -> Quantity:
        inside = f"INDEX([{steps}.begin],2*[k])+DEGREES(INDEX([{steps}.span],2*[k]))*[x{k}]"
        return calc(f"at{k}", "acceleration largest or lowest at", "θ", "°",
                    f"=IF(([x{k}]>0)*([x{k}]<1)>0,{inside},360)",
                    angles[k * room : (k + 1) * room], "360: nowhere", scale=TURN, format="0.0##")  # fmt: skip

    sheet.table(
        bends_name(handover), f"Where the acceleration of phases of axis {handover.axis.number} bends", room,
        constant("k", "row", "k", "", list(range(1, room + 1))),
        handover.number("mode", "is carried out", f"=INDEX({ends.format('mode')},2*[k])",
                   filled([step.mode for step in phases], room, 0)),
        power("a", by_degree(f"6*{e(3)}", f"24*{e(4)}"), lambda step: step.jerk_powers[0]),
        power("b", by_degree(f"24*{e(4)}", f"60*{e(5)}+24*{e(4)}"), lambda step: step.jerk_powers[1]),
        power("c", by_degree(f"60*{e(5)}", f"0-210*{e(7)}"), lambda step: step.jerk_powers[2]),
        calc("w", "root of its jerk", "W", at.y,
             "=IF([b]^2<4*[a]*[c],0,0-([b]+IF([b]<0,0-1,1)*SQRT([b]^2-4*[a]*[c]))/2)",
             filled([step.jerk_root for step in phases], room), scale=100.0 * size),
        angle(0), angle(1), place(0), place(1),
        blank=f"[mode]<{BENT_FROM}",
    )  # fmt: skip
