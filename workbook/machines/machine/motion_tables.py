"""The cells of the motions of a machine's axes, and the tables of their steps and pieces."""

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import accumulate
from typing import Any

from engine.drive.turning import MIDDLES, Directions, Turn, directions, turns_of
from engine.laws import Law
from engine.laws.points import slowest
from engine.motion import Phase
from engine.motion.pieces import MotionPiece
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.rows import filled, spread
from workbook.laws.sampling import HIGH, LOW, Pieces
from workbook.machines.machine.boundary import curve_extremes
from workbook.machines.machine.boundary.curves import bends_table, curves_between_ends, end_kinds
from workbook.machines.machine.boundary.handover import AxisHandover, required_ends, taken_by_pieces
from workbook.machines.machine.view import MachineView, MovingAxis
from workbook.motion.cells import Cells, PieceRows, rows_of
from workbook.motion.pieces import ABOUT, phase_columns, pieces_in_all, pieces_table
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints

CELLS = cell_tables(__file__)

Figure = Callable[[int, Phase], Any]
BACKWARD = 1e-9  # share of the mean velocity: a law that is slower than minus this may turn round
MIDDLE = "mid"  # the name of the shares of a piece at which its direction is looked at
STEPS = "Steps of axis {}: its phases, and the rests between them"


class AxisTables:
    """An axis at its place in a book: its pieces in cells, and their joints.

    With its ``name``, that of the table of phases, all its tables begin; the table of phases has ``rows`` rows, and
    its workings beside it are called ``taken``; ``room`` are the rows of its pieces, ``moves`` the name of the table of
    their directions.
    """

    def __init__(self, machine: MachineView, axis: MovingAxis, stack: Pieces) -> None:
        self.axis, self.machine, self.name = axis, machine, f"axis{axis.number}"
        self.taken = f"{self.name}_taken"
        self.moves, self.rows = f"{self.name}_moves", machine.given.sizes.phases
        self.steps = self.rows + self.rows + 1
        self.room = machine.given.sizes.pieces_of(axis.number)
        self.pieces = rows_of(self.at, axis.motion, stack, axis.places, self.steps)
        self.joints = Joints.of(self.pieces, axis.motion, self.required)
        self.ends = AxisHandover(self.pieces, axis, machine.over) if machine.hands_over else None

    @property
    def at(self) -> Cells:
        """The cells of the motion."""
        t, base = self.name, self.axis.base
        return Cells(
            f"{t}_steps",
            f"{t}_pieces",
            f"{t}_count",
            "360",
            base,
            "rad",
            degrees=True,
            near="eps",
            ends=f"{t}_ends" if self.machine.hands_over else "",
        )

    @property
    def required(self) -> RequiredSmoothness:
        """The smoothness that the axis must have."""
        t, i, over = self.name, self.axis.number, self.machine.over
        lift = over.lift(self.axis.given.unit)
        return RequiredSmoothness(
            self.axis.given.smoothness,
            f"[axes.smooth.{i}]",
            f"{t}_order",
            (f"MAX([{t}_taken.y1])", f"MAX([{t}_taken.y2])"),
            over.after,
            (f"[axes.name.{i}]", self.axis.given.name),
            wraps=f'[axes.closes.{i}]<>"open"',
            periodic=self.axis.given.repeats,
            units=over.rates(self.axis.given.unit) if over.measured else (),
            speed=("omega", self.axis.speed) if over.measured else None,
            lift=(lift.shown, lift.size),
        )

    @cached_property
    def may_turn(self) -> list[bool]:
        """Whether each piece may turn round: its law moves backward too, or its phase takes velocity from others."""
        ends, pieces = self.ends, self.pieces.pieces
        takes = (ends is not None and ends.step_of(piece).mode > 0 for piece in pieces)
        each = zip(pieces, takes, strict=True)
        return [piece.duration > 0.0 and (taken or slowest(self.law_of(piece)) < -BACKWARD) for piece, taken in each]

    def law_of(self, piece: MotionPiece) -> Law:
        """Return the law of a piece's phase, as entered."""
        return self.axis.motion.phases[self.axis.places.index(piece.phase)].named

    @cached_property
    def directions(self) -> list[Directions]:
        """The shares of each piece that move each way."""
        both = zip(self.pieces.pieces, self.may_turn, strict=True)
        return [directions(piece) if may else Directions() for piece, may in both]

    @cached_property
    def turns(self) -> list[Turn]:
        """All turns inside pieces, in order."""
        return turns_of(self.pieces.pieces, self.directions)


def pieces_sheet(book: Book, axes: list[AxisTables]) -> None:
    """Declare the sheet of the motions as pieces."""
    sheet = book.sheet("Pieces", "Workings: the motion of each axis as steps and as pieces.")
    sheet.unprinted = True
    for axis in axes:
        sheet.heading(f"Axis {axis.axis.number}", ABOUT)
        sheet.rows(pieces_in_all(axis.pieces), *axis.joints.order())
        title = STEPS.format(axis.axis.number)
        steps = [*step_columns(axis), *phase_columns(axis.pieces), *(fastest(axis) if axis.ends else [])]
        sheet.table(f"{axis.name}_steps", title, axis.steps, *steps)
        room, ends = axis.room, axis.ends
        columns = curve_extremes.pulse_extremes(ends, room) if ends else []
        halves = taken_by_pieces(ends, room) if ends else []
        title, size = f"Pieces of axis {axis.axis.number}", axis.axis.motion.size
        pieces_table(sheet, title, axis.pieces, room, size, *columns, taken=halves)
        axis.joints.table(sheet, f"What jumps where each piece of axis {axis.axis.number} begins", room)
        if axis.axis.given.motor:
            moves_table(sheet, axis)
            if ends:
                bends_table(sheet, ends)
        sheet.print_rows = sheet.print_rows or sheet.row  # the first axis, to see what they are
    if any(axis_tables.axis.given.motor for axis_tables in axes):
        title = "Middles of 200 parts of a piece, as shares of it"
        sheet.table("middles", title, len(MIDDLES), CELLS["middles"]("mid", MIDDLES.tolist()))
        book.name("middles", **{MIDDLE: "mid"})
    if handing := [axis_tables.ends for axis_tables in axes if axis_tables.ends]:
        place_boundaries(sheet, handing)
    sheet.print_columns = 20


def of_steps(tables: AxisTables, figure: Figure, spare: Any = 0.0) -> list[Any]:
    """Return a figure of each step, by its number and phase, in the rows of the table."""
    each = (figure(k, phase) for k, phase in enumerate(tables.axis.motion.phases))
    return spread(each, tables.axis.places, tables.steps, spare)


def row_by_row(tables: AxisTables, rest: str, phase: str) -> list[str]:
    """Return formulas of all rows by those of a rest, by the phases ``before`` and ``behind``, and of a phase."""
    texts = [rest.format(before=0, behind=1)]
    for k in range(1, tables.rows + 1):
        texts += [phase.format(k), rest.format(before=k, behind=k + 1)]
    return texts


def step_columns(tables: AxisTables) -> list[Quantity]:
    """Return the columns of where steps begin, how long they last, their laws, lifts and positions."""
    t, axis, handed = tables.name, tables.axis, tables.ends
    motion, base, end = axis.motion, axis.base, f"[{tables.taken}.begin.{tables.rows + 1}]"
    start, size = f"[axes_taken.y0.{axis.number}]", motion.size(0)
    entered = [end for p in axis.given.phases for end in (p.start, p.stop)]

    def each(rest: str, phase: str) -> list[str]:
        return row_by_row(tables, rest, phase)

    cell = CELLS["step_columns"].sharing(base=base, size=size)

    def reached(name: str, formula: str, i: int) -> Quantity:
        values = of_steps(tables, lambda k, _: motion.reaches[k][i], motion.position)
        own = handed.own(name, formula) if handed else formula
        return cell(name, values, base=base, formula=own, scale=size)

    begin = [
        text.replace(f"[{t}_taken.end.0]", "0")
        for text in each(f"=[{t}_taken.end.{{before}}]", f"=[{t}_taken.begin.{{}}]")
    ]
    rest = f"=IF([{t}_taken.begin.{{behind}}]-[begin]>check_zero,RADIANS([{t}_taken.begin.{{behind}}]-[begin]),0)"
    span = [text.replace(end, "360") for text in each(rest, f"=[{t}_taken.span.{{}}]")]
    positions = of_steps(tables, lambda k, _: motion.ends[k].begin.y, None)
    return [
        cell("k", list(range(1, tables.steps + 1))),
        cell("begin", filled([0.0, *entered], tables.steps, 360.0), formula=begin),
        cell("span", of_steps(tables, lambda _, p: p.duration), formula=span),
        cell("no", list(tables.pieces.numbers), formula=each("=1", f"=[{t}_taken.no.{{}}]")),
        cell("h", of_steps(tables, lambda _, p: p.lift), formula=each("=0", f"=[{t}_taken.h.{{}}]")),
        cell("y0", carried_back(positions, motion.position + motion.lifts_sum), start=start),
        reached("low", LOW.format(start), 0),
        reached("high", HIGH.format(start), 1),
    ]


def fastest(tables: AxisTables) -> list[Quantity]:
    """Return the columns of the greatest velocity and acceleration of the steps."""

    def most(name: str, order: int, figure: Figure) -> Quantity:
        formula = row_by_row(tables, "=0*[k]", f"=[{tables.taken}.{name}.{{}}]")
        unit, scale = tables.at.unit(order), tables.axis.motion.size(order)
        return CELLS["fastest"](name, of_steps(tables, figure), unit=unit, formula=formula, scale=scale)

    return [most("y1", 1, lambda _, p: p.y1_max), most("y2", 2, lambda _, p: p.y2_max)]


def carried_back(values: list[float | None], last: float) -> list[float]:
    """Return values of steps; a step that is missing has the value of the next step."""
    following = accumulate(reversed(values), lambda after, value: after if value is None else value, initial=last)
    return [*following][:0:-1]


def place_boundaries(sheet: Sheet, axes: Sequence[AxisHandover]) -> None:
    """Declare what the steps of each axis that hands velocity over take from their neighbours."""
    CELLS["taken"].begin(sheet)
    for handover in axes:
        at, axis, last = handover.rows.at, f"axis {handover.axis.number}", handover.axis.places[-1] + 1
        sheet.rows(CELLS["taken"]("{last}", last, last=handover.last, axis=axis, phases=at.phases))
        carried_out = [
            *curves_between_ends(handover),
            *curve_extremes.polynomial_extremes(handover),
            *curve_extremes.step_extremes(handover),
        ]
        for name, title, columns in (
            (handover.required, f"What the steps of {axis} take", required_ends(handover)),
            (at.ends, f"How the steps of {axis} are carried out", carried_out),
            (handover.kinds, f"Ends of the steps of {axis}", end_kinds(handover)),
        ):
            sheet.table(name, title, handover.room, *columns, blank=f"INDEX([{at.phases}.span],[k])=0")
    curve_extremes.points(sheet.book, sheet)


def moves_table(sheet: Sheet, tables: AxisTables) -> None:
    """Declare where each piece moves which way, and how often the motion has turned round inside a piece."""
    cell, rows, room = CELLS["moves_table"], tables.pieces, tables.room
    at = rows.at
    taken = f"+(INDEX([{at.ends}.mode],[{at.pieces}.p.same])>0)" if at.ends else ""
    turned = [sum(turn.piece <= k for turn in tables.turns) for k in range(len(rows.pieces))]
    lows, speed = [slowest(tables.law_of(piece)) for piece in rows.pieces], velocity(rows)
    both = zip(zip(*tables.directions, strict=True), Directions(), strict=True)
    ff, fb, lf, lb = (filled(values, room, spare) for values, spare in both)
    sheet.table(
        tables.moves,
        f"Which way each piece of axis {tables.axis.number} moves, as shares of it",
        room,
        cell("r", list(range(1, room + 1))),
        cell("low", filled(lows, room, lows[-1]), at=at, scale=1.0),
        cell("may", filled([int(may) for may in tables.may_turn], room), at=at, taken=taken),
        cell("ff", ff, velocity=speed, scale=1.0),
        cell("fb", fb, velocity=speed, scale=1.0),
        cell("lf", lf, velocity=speed, scale=1.0),
        cell("lb", lb, velocity=speed, scale=1.0),
        cell("turns", filled(turned, room, turned[-1])),
        blank=f"[r]>{at.count}",
    )


def velocity(rows: PieceRows) -> str:
    """Return the formula of y' in the middles of the parts of the piece of the same row.

    It has a single sine: laws with a second sine go forward throughout, between rests.
    """
    t = rows.at.pieces
    u, text = f"[{t}.d.same]*{MIDDLE}", ""
    for n in range(rows.powers - 1, 0, -1):
        c = f"{n}*[{t}.c{n}.same]" if n > 1 else f"[{t}.c{n}.same]"
        text = f"{c}+{u}*({text})" if "+" in text else f"{c}+{u}*{text}" if text else c
    return f"{text}+[{t}.dA.same]*COS([{t}.om.same]*{u}+[{t}.ph.same])"
