"""The values that each step of an axis takes from its neighbours and from its entries: velocity, acceleration at ends.

A straight line or a dwell settles the ends of both its neighbours; between two curved phases what is entered does.
"""

from engine.laws.ends import ROUNDING, BoundaryValues
from engine.motion.handover import STRAIGHT, Handover
from engine.motion.joining import Rates, agrees
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.machines.machine.boundary.handover import BEND, FOLLOWS, ONLY, RESTS, SPEED, AxisHandover, why_impossible

CELLS = cell_tables(__file__)

NONE = Rates()


def required_ends(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of what each step takes."""
    column = handover.columns(CELLS["required_ends"])
    return [
        *handover.steps(),
        column("way", handover.of(lambda step: step.end_mode, STRAIGHT)),
        column("slope", lambda step: step.slope, order=1),
        *neighbours(handover),
        *ends(handover),
        *handover_modes(handover),
        *faults(handover),
    ]


def straight(step: Handover | None) -> int:
    """Return whether a step is a straight line or a dwell."""
    return int(step is not None and step.end_mode == STRAIGHT)


def neighbours(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of the steps beside each, if these are straight, and of what is entered for phases."""
    column = handover.columns(CELLS["neighbours"])
    rows, around = [place + 1 for place in handover.axis.places], handover.axis.given.repeats
    earlier = [max((row for row in rows if row < k), default=0) for k in range(1, handover.room + 1)]
    before, after = [rows[-1] if around else 0, *rows[:-1]], [*rows[1:], rows[0] if around else 0]
    following = [*handover.handed[1:], handover.handed[0] if around else None]
    slopes = [step.slope if step and straight(step) else 0.0 for step in handover.before]

    def per_rad(entry: str, order: int) -> str:
        lift = handover.over.lift(handover.axis.given.unit)
        return handover.over.per_rad_formula(f"INDEX([{handover.entries}.{entry}],[row]){lift.taken}", order)

    return [
        column("earlier", earlier),
        column("before", handover.spread(before, 0)),
        column("after", handover.spread(after, 0)),
        column("line0", handover.spread([*map(straight, handover.before)], 0)),
        column("slope0", handover.spread(slopes), order=1),
        column("line1", handover.spread([*map(straight, following)], 0)),
        column("row", [max(1, k // 2) for k in range(1, handover.room + 1)]),
        column("set", lambda step: int(step.entered is not None)),
        column("ev", lambda step: (step.entered or NONE).v, order=1, per_rad=per_rad("velocity", 1)),
        column("ea", lambda step: (step.entered or NONE).a, order=2, per_rad=per_rad("acceleration", 2)),
    ]


def ends(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and whether these are settled."""
    column = handover.columns(CELLS["ends"])
    return [
        column("settled0", handover.of(lambda step: int(step.begin.settled), 1)),
        column("settled1", handover.of(lambda step: int(step.end.settled), 1)),
        column("w0", lambda step: step.begin.required.v, order=1),
        column("w1", lambda step: step.end.required.v, order=1),
        column("q0", lambda step: step.begin.required.a, order=2),
        column("q1", lambda step: step.end.required.a, order=2),
        column("moved", lambda step: abs(step.begin.required.v) + abs(step.end.required.v), order=1),
        column("bent", lambda step: abs(step.begin.required.a) + abs(step.end.required.a), order=2),
    ]


def handover_modes(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of whether a straight line is against an entry, and how a law is carried out."""
    column = handover.columns(CELLS["handover_modes"])

    def differs(step: Handover, line: Handover | None) -> int:
        return int(line is not None and straight(line) and not agrees(step.entered or NONE, line.slope))

    def straight_on(step: Handover) -> int:
        begin, end, d = step.begin.required, step.end.required, step.phase.duration
        return int(BoundaryValues(step.phase.lift, begin.v * d, end.v * d, begin.a * d**2, end.a * d**2).straight)

    return [
        column("off", lambda step: differs(step, step)),
        column(
            "off0", handover.spread([differs(*both) for both in zip(handover.handed, handover.before, strict=True)], 0)
        ),
        column("contrary", lambda step: int(step.contrary)),
        column("straight", handover.of(straight_on, 1), rounding=f"{ROUNDING:.0E}"),
        column("cannot", lambda step: int(bool(step.fault))),
        column("mode", lambda step: step.mode),
    ]


def faults(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of the reason that a step cannot have its ends: end, rate, reason, sentence."""
    column = handover.columns(CELLS["faults"])
    ends, rates, reasons = zip(
        *handover.spread([why_impossible(step) for step in handover.handed], ("", "", "")), strict=True
    )
    return [
        column("verb", list(ends)),
        column("what", list(rates), speed=SPEED, bend=BEND),
        column("why", list(reasons), rests=RESTS, kept=FOLLOWS, only=ONLY),
        column("fault", handover.spread(handover.faults(), "")),
    ]
