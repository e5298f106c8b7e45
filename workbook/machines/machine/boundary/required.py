"""What each step of an axis takes from its neighbours and from what is entered: velocity and acceleration at its ends.

A straight line or a dwell settles the ends of both its neighbours; between two curved phases what is entered does.
"""

from engine.laws.ends import ROUNDING, BoundaryValues
from engine.motion.handover import STRAIGHT, Handover
from engine.motion.joining import Rates, agrees
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.machines.machine.boundary.handover import BEND, KEPT, ONLY, RESTS, SPEED, AxisHandover, why_impossible

CELLS = cell_tables(__file__)

NONE = Rates()


def required_ends(one: AxisHandover) -> list[Quantity]:
    """Return the columns of what each step takes."""
    column = one.columns(CELLS["required_ends"])
    return [
        *one.steps(),
        column("way", one.of(lambda step: step.end_mode, STRAIGHT)),
        column("slope", lambda step: step.slope, order=1),
        *neighbours(one),
        *ends(one),
        *handover_modes(one),
        *faults(one),
    ]


def straight(step: Handover | None) -> int:
    """Return whether a step is a straight line or a dwell."""
    return int(step is not None and step.end_mode == STRAIGHT)


def neighbours(one: AxisHandover) -> list[Quantity]:
    """Return the columns of the steps beside each, if these are straight, and of what is entered for phases."""
    column = one.columns(CELLS["neighbours"])
    rows, around = [place + 1 for place in one.axis.places], one.axis.given.repeats
    earlier = [max((row for row in rows if row < k), default=0) for k in range(1, one.room + 1)]
    before, after = [rows[-1] if around else 0, *rows[:-1]], [*rows[1:], rows[0] if around else 0]
    following = [*one.handed[1:], one.handed[0] if around else None]
    slopes = [step.slope if step and straight(step) else 0.0 for step in one.before]

    def per_rad(entry: str, order: int) -> str:
        lift = one.over.lift(one.axis.given.unit)
        return one.over.per_rad_formula(f"INDEX([{one.entries}.{entry}],[row]){lift.taken}", order)

    return [
        column("earlier", earlier),
        column("before", one.spread(before, 0)),
        column("after", one.spread(after, 0)),
        column("line0", one.spread([*map(straight, one.before)], 0)),
        column("slope0", one.spread(slopes), order=1),
        column("line1", one.spread([*map(straight, following)], 0)),
        column("row", [max(1, k // 2) for k in range(1, one.room + 1)]),
        column("set", lambda step: int(step.entered is not None)),
        column("ev", lambda step: (step.entered or NONE).v, order=1, per_rad=per_rad("velocity", 1)),
        column("ea", lambda step: (step.entered or NONE).a, order=2, per_rad=per_rad("acceleration", 2)),
    ]


def ends(one: AxisHandover) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and whether these are settled."""
    column = one.columns(CELLS["ends"])
    return [
        column("settled0", one.of(lambda step: int(step.begin.settled), 1)),
        column("settled1", one.of(lambda step: int(step.end.settled), 1)),
        column("w0", lambda step: step.begin.required.v, order=1),
        column("w1", lambda step: step.end.required.v, order=1),
        column("q0", lambda step: step.begin.required.a, order=2),
        column("q1", lambda step: step.end.required.a, order=2),
        column("moved", lambda step: abs(step.begin.required.v) + abs(step.end.required.v), order=1),
        column("bent", lambda step: abs(step.begin.required.a) + abs(step.end.required.a), order=2),
    ]


def handover_modes(one: AxisHandover) -> list[Quantity]:
    """Return the columns of whether a straight line is against an entry, and how a law is carried out."""
    column = one.columns(CELLS["handover_modes"])

    def differs(step: Handover, line: Handover | None) -> int:
        return int(line is not None and straight(line) and not agrees(step.entered or NONE, line.slope))

    def straight_on(step: Handover) -> int:
        begin, end, d = step.begin.required, step.end.required, step.phase.duration
        return int(BoundaryValues(step.phase.lift, begin.v * d, end.v * d, begin.a * d**2, end.a * d**2).straight)

    return [
        column("off", lambda step: differs(step, step)),
        column("off0", one.spread([differs(*both) for both in zip(one.handed, one.before, strict=True)], 0)),
        column("contrary", lambda step: int(step.contrary)),
        column("straight", one.of(straight_on, 1), rounding=f"{ROUNDING:.0E}"),
        column("cannot", lambda step: int(bool(step.fault))),
        column("mode", lambda step: step.mode),
    ]


def faults(one: AxisHandover) -> list[Quantity]:
    """Return the columns of why a step cannot have its ends: at which end, what, why, and all of it as told."""
    column = one.columns(CELLS["faults"])
    ends, rates, reasons = zip(*one.spread([why_impossible(step) for step in one.handed], ("", "", "")), strict=True)
    return [
        column("verb", list(ends)),
        column("what", list(rates), speed=SPEED, bend=BEND),
        column("why", list(reasons), rests=RESTS, kept=KEPT, only=ONLY),
        column("fault", one.spread(one.faults(), "")),
    ]
