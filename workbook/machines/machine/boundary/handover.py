"""The phases of an axis that hand velocity over, at their place in its book: their tables and their checks.

A straight line hands its velocity to both of its neighbours, a dwell its rest. A law of two pulses has v0 and h_a times
the law while it speeds up, v1 and h_b times it from then on; h_a and h_b follow from the stroke and from the velocity
between the pulses. A polynomial of its degree meets Hermite's conditions. Source: LCamHdl, ProfileTypes, C_C_,
D_C_ and C_D_ laws, POLY_3, POLY_5, POLY_7.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from engine.laws.ends import ROUNDING, BoundaryValues
from engine.motion.handover import NEVER, PULSES, STRAIGHT, Handover, handovers
from engine.motion.joining import Rates, agrees
from engine.motion.pieces import MotionPiece
from workbook.book.cell_tables import CellTable, cell_tables
from workbook.book.declare import Quantity
from workbook.book.rows import filled, spread
from workbook.book.sentence import CheckSentence, first_text
from workbook.entries.abscissa import Abscissa
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows

CELLS = cell_tables(__file__)

SPEED, BEND = " with a velocity", " with an acceleration"
RESTS = ": it begins and ends at rest"
ONLY = ": it takes a velocity only"
BESIDE = ": its begin is entered otherwise than the straight line or dwell there has it"


class AxisHandover:
    """The values that the phases of an axis take from their neighbours; phases stand in every second row of its steps.

    ``room`` are the rows of the table of steps; ``in_row`` has the number in the motion of the step of each used row.
    """

    def __init__(self, rows: PieceRows, axis: MovingAxis, over: Abscissa) -> None:
        self.rows, self.axis, self.over, self.motion = rows, axis, over, axis.motion
        self.handed = handovers(replace(axis.joined, motion=axis.motion), axis.entered_rates, axis.given.repeats)
        self.entries = f"axis{axis.number}"
        self.required = rows.at.required
        self.kinds = f"{self.entries}_kinds"
        self.last = f"{self.entries}_last"
        self.open, self.room = f'[axes.closes.{axis.number}]="open"', len(rows.firsts)
        self.in_row = {place: k for k, place in enumerate(axis.places)}

    def step_of(self, piece: MotionPiece) -> Handover:
        """Return the step that a piece is of."""
        return self.handed[self.in_row[piece.phase]]

    def begin_of(self, piece: MotionPiece) -> float:
        """Return the position at which the step of a piece begins."""
        return self.motion.ends[self.in_row[piece.phase]].begin.y

    def of(self, figure: Callable[[Handover], Any], spare: Any = 0.0) -> list[Any]:
        """Return a figure of each step, row by row."""
        return self.spread([figure(handover) for handover in self.handed], spare)

    def spread(self, values: list[Any], spare: Any = 0.0) -> list[Any]:
        """Return values of the steps in their rows."""
        return spread(values, self.axis.places, self.room, spare)

    @property
    def parts(self) -> dict[str, str]:
        """The names of cells and tables that formulas have as parts."""
        at = self.rows.at
        own = {"entries": self.entries, "kinds": self.kinds, "last": self.last, "open": self.open}
        return {"phases": at.phases, "pieces": at.pieces, "ends": at.ends, "asked": self.required} | own

    def columns(self, table: CellTable) -> Callable[..., Quantity]:
        """Return a function that declares a column by the name of its row: a figure of each step, or all values.

        With an ``order``, it is a derivative of the motion, or its position, and has the unit and the size of that.
        """
        cell = table.sharing(**self.parts)

        def column(name: str, figures: Any, /, order: int | None = None, **more: Any) -> Quantity:
            values = self.of(figures, 0 if order is None else 0.0) if callable(figures) else figures
            own = {} if order is None else {"unit": self.rows.at.unit(order), "scale": self.motion.size(order)}
            return cell(name, values, **own | more)

        return column

    def steps(self) -> list[Quantity]:
        """Return the columns that tables of steps begin with: row, lift, duration."""
        column = self.columns(CELLS["steps"])
        return [
            column("k", list(range(1, self.room + 1))),
            column("h", lambda step: step.phase.lift, order=0),
            column("span", self.of(lambda step: step.phase.duration), x=self.rows.at.x, scale=self.motion.total),
        ]

    @property
    def phases(self) -> list[tuple[int, Handover]]:
        """The phases with the numbers, from 1, of the rows in which they are entered."""
        return [(i, self.handed[k]) for i, k in enumerate(self.axis.entered, 1)]

    @property
    def before(self) -> list[Handover | None]:
        """The step before each; None before the first of a motion that does not repeat."""
        return [self.handed[-1] if self.axis.given.repeats else None, *self.handed[:-1]]

    def own(self, column: str, formula: str) -> str:
        """Return a formula of the phases' table where the law is carried out between rests, else a figure from here."""
        ends = self.rows.at.ends
        ended = f"INDEX([{ends}.{column}],[k])" if column else "0"
        return f"=IF(INDEX([{ends}.mode],[k])=0,{formula.removeprefix('=')},{ended})"

    def faults(self) -> list[str]:
        """Return for each step the reason that it cannot have its ends, in the words of its row of the table."""
        reasons, laws = [""] * len(self.handed), [phase.law for phase in self.axis.given.phases]
        for (i, handover), k in zip(self.phases, self.axis.entered, strict=True):
            reasons[k] = f"row {i}: {laws[i - 1]} cannot {''.join(why_impossible(handover))}" if handover.fault else ""
        return reasons

    def checks(self, name: str, label: str) -> list[Quantity]:
        """Return the checks, of names and labels that begin so, that laws can have their ends and no line objects."""
        column, table = self.columns(CELLS["checks"]), self.required
        texts, against = f"[{table}.fault]", f"[{table}.contrary]"
        axis, called = self.axis.given.name, f'[axes.name.{self.axis.number}]&" '
        fault = next(filter(None, self.faults()), "")
        contrary = next((f"{axis} row {i}{BESIDE}" for i, handover in self.phases if handover.contrary), "")
        meets = CheckSentence(f'{called}"&INDEX({texts},{first_text(texts)})', fault and f"{axis} {fault}")
        passes = CheckSentence(f'{called}row "&MATCH(1,{against},0)/2&"{BESIDE}"', contrary)
        return [
            column("{name}_meets", not fault, name=name, label=label, says=meets),
            column("{name}_passes", not contrary, name=name, label=label, says=passes),
        ]


def why_impossible(handover: Handover) -> tuple[str, str, str]:
    """Return at which end a phase cannot have what is asked for, what that is, and why; nothing where it can."""
    if not handover.fault:
        return "", "", ""
    begin, end = handover.begin.required, handover.end.required
    never, moving = handover.end_mode == NEVER, bool(begin.v or end.v)
    first = begin.v if never and moving else begin.a
    return (
        "begin" if first else "end",
        SPEED if never and moving else BEND,
        RESTS if never else ONLY,
    )


def taken_by_pieces(handover: AxisHandover, room: int) -> list[Quantity]:
    """Return the columns of the pieces' table that say what a piece takes over."""
    column = handover.columns(CELLS["taken_by_pieces"])

    def of(figure: Callable[[Handover, bool, MotionPiece], Any]) -> list[Any]:
        both = ((piece, handover.step_of(piece)) for piece in handover.rows.pieces)
        values = [figure(step, step.mode == PULSES and piece.number >= step.early, piece) for piece, step in both]
        return filled(values, room, values[-1])

    return [
        column("late", of(lambda _, late, __: int(late))),
        column("hp", of(lambda step, late, _: step.halves[late]), order=0),
        column("drift", of(lambda step, late, _: step.drifts[late]), order=1),
        column("base", of(lambda step, late, piece: step.base(late, handover.begin_of(piece))), order=0),
    ]


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
        column("why", list(reasons), rests=RESTS, only=ONLY),
        column("fault", handover.spread(handover.faults(), "")),
    ]
