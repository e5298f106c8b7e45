"""Where the motions of a machine's axes stand in its book, and the tables of their steps and pieces."""

from collections.abc import Callable, Sequence
from typing import Any

from engine.motion import Phase
from workbook.book.declare import Book, Quantity, Sheet, calc, constant
from workbook.book.rows import filled, spread
from workbook.laws.sampling import HIGH, LOW, Pieces
from workbook.machines.machine.boundary import curves
from workbook.machines.machine.boundary.bends import bends_table
from workbook.machines.machine.boundary.handover import AxisHandover, required_ends, taken_by_pieces
from workbook.machines.machine.turning import AxisTurns, middles_table, moves_table
from workbook.machines.machine.view import MachineView, MovingAxis
from workbook.motion.cells import Cells, rows_of
from workbook.motion.pieces import ABOUT, phase_columns, pieces_in_all, pieces_table
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints

Figure = Callable[[int, Phase], Any]
STEPS = "Steps of axis {}: its phases, and the rests between them"


class AxisTables:
    """An axis at its place in a book: its pieces in cells, and their joints.

    With its ``name``, that of the table of phases, all its tables begin; that one has so many ``rows``.
    """

    def __init__(self, machine: MachineView, axis: MovingAxis, stack: Pieces) -> None:
        self.axis, self.machine, self.name = axis, machine, f"axis{axis.number}"
        self.rows = machine.given.sizes.phases
        self.steps = self.rows + self.rows + 1
        self.pieces = rows_of(self.at, axis.motion, stack, axis.places, self.steps)
        self.joints = Joints.of(self.pieces, axis.motion, self.required)
        self.ends = AxisHandover(self.pieces, axis, machine.over) if machine.hands_over else None
        self.turning = AxisTurns(self.pieces, axis, self.ends, machine.room)

    @property
    def at(self) -> Cells:
        """Where the motion stands."""
        t, base = self.name, self.axis.base
        return Cells(
            f"{t}_steps", f"{t}_pieces", f"{t}_count", "360", base, "rad", degrees=True, near="eps",
            ends=f"{t}_ends" if self.machine.hands_over else "",
        )  # fmt: skip

    @property
    def required(self) -> RequiredSmoothness:
        """How smooth the axis must be."""
        t, i, over = self.name, self.axis.number, self.machine.over
        lift = over.lift(self.axis.given.unit)
        return RequiredSmoothness(
            self.axis.given.smoothness, f"[axes.smooth.{i}]", f"{t}_order",
            (f"MAX([{t}.y1])", f"MAX([{t}.y2])"), over.after, (f"[axes.name.{i}]", self.axis.given.name),
            wraps=f'[axes.closes.{i}]<>"open"', periodic=self.axis.given.repeats,
            units=over.rates(self.axis.given.unit) if over.measured else (),
            speed=("omega", self.axis.speed) if over.measured else None, lift=(lift.shown, lift.size),
        )  # fmt: skip


def pieces_sheet(book: Book, axes: list[AxisTables]) -> None:
    """Declare the sheet of the motions as pieces."""
    sheet = book.sheet("Pieces", "Workings: the motion of each axis as steps and as pieces.")
    sheet.unprinted = True
    for one in axes:
        sheet.heading(f"Axis {one.axis.number}", ABOUT)
        sheet.rows(pieces_in_all(one.pieces), *one.joints.order())
        steps_table(sheet, one)
        room, ends = one.machine.room, one.ends
        columns, halves = (curves.pulse_extremes(ends, room), taken_by_pieces(ends, room)) if ends else ([], [])
        title, size = f"Pieces of axis {one.axis.number}", one.axis.motion.size
        pieces_table(sheet, title, one.pieces, room, size, *columns, taken=halves)
        one.joints.table(sheet, f"What jumps where each piece of axis {one.axis.number} begins", room)
        if one.axis.given.motor:
            moves_table(sheet, one.turning)
            if ends:
                bends_table(sheet, ends)
        sheet.print_rows = sheet.print_rows or sheet.row  # the first axis, to see what they are
    if any(one.axis.given.motor for one in axes):
        middles_table(book, sheet)
    if handing := [one.ends for one in axes if one.ends]:
        place_boundaries(sheet, handing)
    sheet.print_columns = 20


def steps_table(sheet: Sheet, tables: AxisTables) -> None:
    """Declare the steps: a rest before each phase and behind the last, of no length where there is none."""
    t, n, axis = tables.name, tables.rows, tables.axis
    motion, base = axis.motion, axis.base

    def each(rest: str, phase: str) -> list[str]:
        found = [rest.format(before=0, behind=1)]
        for k in range(1, n + 1):
            found += [phase.format(k), rest.format(before=k, behind=k + 1)]
        return found

    def of(figure: Figure, spare: Any) -> list[Any]:
        each = (figure(k, phase) for k, phase in enumerate(motion.phases))
        return spread(each, axis.places, tables.steps, spare)

    begin = [text.replace(f"[{t}.end.0]", "0") for text in each(f"=[{t}.end.{{before}}]", f"=[{t}.begin.{{}}]")]
    rest = f"=IF([{t}.begin.{{behind}}]-[begin]>check_zero,RADIANS([{t}.begin.{{behind}}]-[begin]),0)"
    span = [text.replace(f"[{t}.begin.{n + 1}]", "360") for text in each(rest, f"=[{t}.span.{{}}]")]
    ends, handed, start = motion.ends, tables.ends, f"[axes_taken.y0.{axis.number}]"

    def own(column: str, formula: str) -> str:
        return handed.own(column, formula) if handed else formula

    fastest: list[tuple[str, Figure]] = [("velocity", lambda _, p: p.y1_max), ("acceleration", lambda _, p: p.y2_max)]
    entered = [end for p in axis.given.phases for end in (p.start, p.stop)]
    sheet.table(
        f"{t}_steps", STEPS.format(axis.number), tables.steps,
        constant("k", "step", "k", "", list(range(1, tables.steps + 1))),
        calc("begin", "begins at", "", "°", begin, filled([0.0, *entered], tables.steps, 360.0), scale=360.0,
             format="0.0##"),
        calc("span", "duration", "δ", "rad", span, of(lambda _, p: p.duration, 0.0)),
        calc("no", "law number", "", "", each("=1", f"=[{t}.no.{{}}]"), list(tables.pieces.numbers), format="0"),
        calc("h", "lift", "h", base, each("=0", f"=[{t}.h.{{}}]"), of(lambda _, p: p.lift, 0.0)),
        calc("y0", "start position", "y_0", base, f"=IF([k]=1,{start},[y0-1]+[h-1])",
             carried_back(of(lambda k, _: ends[k].begin.y, None), motion.position + motion.lifts_sum), "lifts before",
             scale=motion.size(0)),
        calc("low", "lowest position", "", base, own("low", LOW.format(start)),
             of(lambda k, _: motion.reaches[k][0], motion.position), scale=motion.size(0)),
        calc("high", "highest position", "", base, own("high", HIGH.format(start)),
             of(lambda k, _: motion.reaches[k][1], motion.position), scale=motion.size(0)),
        *phase_columns(tables.pieces),
        *([] if not handed else [
            calc(f"y{order}", f"greatest {word}", "", tables.at.unit(order), each("=0*[k]", f"=[{t}.y{order}.{{}}]"),
                 of(figure, 0.0), scale=motion.size(order))
            for order, (word, figure) in enumerate(fastest, 1)
        ]),
    )  # fmt: skip


def carried_back(values: list[float | None], last: float) -> list[float]:
    """Return values of steps; a step that is missing has the value of the next one."""
    found: list[float] = []
    for value in reversed(values):
        found.append(last if value is None else value)
        last = found[-1]
    return found[::-1]


TAKEN = "Workings: what phases take from their neighbours"
ABOUT_TAKEN = (
    "A straight line hands its velocity to both neighbours. y = v0 u + h_a s(ξ) up to the greatest velocity of a law "
    "of two pulses, from then on y_1 − v1 (δ − u) − h_b (1 − s(ξ)); a polynomial is Σ e_n ξⁿ. Extremes: "
    "at 201 points, at most 0.05 % below."
)


def place_boundaries(sheet: Sheet, axes: Sequence[AxisHandover]) -> None:
    """Declare what the steps of each axis that hands velocity over take from their neighbours."""

    def how(one: AxisHandover) -> list[Quantity]:
        return [*curves.curves_between_ends(one), *curves.polynomial_extremes(one), *curves.step_extremes(one)]

    sheet.heading(TAKEN, ABOUT_TAKEN)
    for one in axes:
        at, axis, spare = one.rows.at, f"axis {one.axis.number}", f"INDEX([{one.rows.at.phases}.span],[k])=0"
        sheet.rows(calc(one.last, f"Last step of {axis}", "", "",
                        f"=SUMPRODUCT(MAX(([{at.phases}.span]>0)*[{at.phases}.k]))", one.axis.places[-1] + 1,
                        format="0"))  # fmt: skip
        for name, title, columns in (
            (one.required, f"What the steps of {axis} take", required_ends),
            (at.ends, f"How the steps of {axis} are carried out", how),
            (one.kinds, f"Ends of the steps of {axis}", curves.end_kinds),
        ):
            sheet.table(name, title, one.room, *columns(one), blank=spare)
    curves.points(sheet.book, sheet)
