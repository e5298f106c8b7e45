"""The Cycle sheet, a sheet for each tool: both parts over the master angle, in sequence and with overlap."""

from collections.abc import Sequence

from engine.laws.base import Array
from engine.motion import Motion
from engine.motion.pieces import ScaledLaw
from engine.overlap.picture import LANE_SHARE, lane
from engine.overlap.schedule import pieces_of_parts, size_of_parts, whole_turn
from engine.timing import FULL_TURN
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Book, Quantity, Sheet
from workbook.fields.units import DEGREE, MM, shown, si
from workbook.laws.sampling import ACCELERATION, VELOCITY, Pieces
from workbook.machines.overlap.entries import ToolEntry, TransferEntry
from workbook.machines.overlap.view import OverlapView, Station
from workbook.motion.cells import Cells, PieceRows, rows_of_parts
from workbook.motion.pieces import (
    ABOUT,
    POSITION,
    ROOM,
    at_sample,
    phase_columns,
    pieces_in_all,
    pieces_table,
    workings_at,
)
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints

CELLS = cell_tables(__file__)

SCHEDULES = {"b": (1, "one after the other"), "a": (3, "with overlap")}
"""the schedules that are sampled: their row in the table of the tool's angles, and their labels"""


def cells(key: str) -> Cells:
    """Return where a motion over the master angle stands."""
    return Cells(f"{key}_phases", f"{key}_pieces", f"{key}_count", "360", "m", "rad", degrees=True, near="overlap_eps")


TRANSFER = cells("transfer")
OF_TOOL = {"b": cells("@b"), "a": cells("@a")}


class AtAngles:
    """The tool of a schedule at angles (degrees) of the master shaft: from its arrival dwell, way out, rest, way in."""

    def __init__(self, station: Station, schedule: str, theta: Array, pieces: Pieces) -> None:
        self.row, _ = SCHEDULES[schedule]
        self.plan, self.angle = station.schedules[self.row - 1], si(theta, DEGREE)
        self.travel = self.plan.travel(self.angle)
        self.rates = self.plan.rates(self.angle, station.machine.rate)
        self.rows = rows_of(OF_TOOL[schedule], self.plan.parts, pieces)

    def columns(self, suffix: str) -> list[Quantity]:
        """Return the travel and the workings."""
        cell = CELLS["columns"]
        since, there = self.plan.since(self.angle), f"[@schedules.there.{self.row}]"
        return [
            cell(
                f"y{suffix}",
                shown(self.travel, MM),
                sampled=at_sample(self.rows, 0, suffix),
                source=POSITION,
            ),
            cell("since{suffix}", shown(since, DEGREE), suffix=suffix, there=there),
            *workings_at(self.rows, f"since{suffix}", since, suffix=suffix),
        ]

    def rate(self, order: int, name: str, suffix: str) -> Quantity:
        """Return the column of a derivative in time."""
        place = at_sample(self.rows, order, suffix)
        return CELLS["rates"](f"{name}{suffix}", self.rates[order - 1], sampled=place)


def joints_of(
    rows: PieceRows,
    motion: Motion,
    given: TransferEntry | ToolEntry,
    scope: str,
    after: str,
    cell: str,
    names: tuple[str, ...],
) -> Joints:
    """Return the joints of a motion's pieces, and how smooth it must be; ``cell`` has its name."""
    largest = f"MAX([{rows.at.phases}.v])", f"MAX([{rows.at.phases}.a])"
    of = cell, given.name
    required = RequiredSmoothness(given.smoothness, f"{scope}smooth", f"{scope}order", largest, after, of, names=names)
    return Joints.of(rows, motion, required)


def rows_of(at: Cells, parts: Sequence[ScaledLaw], pieces: Pieces) -> PieceRows:
    """Return the pieces of the transfer, or of a tool in a schedule, from its arrival."""
    return rows_of_parts(at, parts, pieces_of_parts(parts), pieces, FULL_TURN)


def transfer_columns(machine: OverlapView, theta: Array, pieces: Pieces) -> list[Quantity]:
    """Return the travel of the transfer and its workings."""
    angle, rows = si(theta, DEGREE), rows_of(TRANSFER, machine.transfer.parts, pieces)
    return [
        CELLS["transfer_columns"](
            "yt",
            shown(machine.transfer.travel(angle), MM),
            sampled=at_sample(rows, 0, "t"),
            source=POSITION,
        ),
        *workings_at(rows, "theta", angle, suffix="t"),
    ]


ALLOWED = "=IF(AND([theta]>@begin+overlap_eps,[theta]<@end-overlap_eps),@clearance,@stroke)"


def cycle_sheets(book: Book, machine: OverlapView, pieces: Pieces) -> None:
    """Declare a sheet for each tool: travel, acceleration and clearance over a turn of the master shaft."""
    for station in machine.stations:
        i, whose = station.number, "" if machine.alone else f"Tool {station.number}: "
        title, what = ("Cycle", "Both parts") if machine.alone else (f"Cycle {i}", f"Transfer and tool {i}")
        sheet = book.sheet(title, f"{what} over one turn of the master shaft, one after the other and with overlap.")
        sheet.unprinted = True
        with sheet.scoped(station.scope):
            motions(sheet, station, pieces)
        if i == 1:
            theta = machine.angles
            sheet.row += 1
            cell = CELLS["transfer_motion"]
            cell.place(
                sheet,
                cell("k", list(range(len(theta)))),
                cell("theta", theta),
                *transfer_columns(machine, theta, pieces),
            )
        sheet.heading("Workings: the motions as pieces", ABOUT)
        if i == 1:
            sheet.rows(CELLS["cycle_sheets"]("overlap_lane", LANE_SHARE))
            sheet.row += 1
            moved = transfer_pieces(sheet, machine, pieces)
        with sheet.scoped(station.scope):
            joints = tool_pieces(sheet, station, pieces)
            tables = [*OF_TOOL.values(), *([TRANSFER] if i == 1 else [])]
            most, room = f"MAX({','.join(at.count for at in tables)})", "MAX([@a_pieces.r])"
            label = f"{whose}{'the' if whose else 'The'} tables of pieces have room for all"
            says = f'{most}&" pieces, and room for "&{room}'
            sheet.checks(
                CELLS["cycle_sheets"]("@ok_pieces", True, label=label, most=most, room=room, most_rows=ROOM, says=says)
            )
            sheet.checks(joints.check("@ok_smooth", f"{whose or 'The tool: '}as smooth as asked"))
        if i == 1:
            sheet.checks(moved.check("overlap_ok_smooth", "The transfer: as smooth as asked"))


def motions(sheet: Sheet, station: Station, pieces: Pieces) -> None:
    """Declare the table over the cycle."""
    cell = CELLS["motions"]
    theta = station.machine.angles
    before, after = (AtAngles(station, schedule, theta, pieces) for schedule in SCHEDULES)
    first, *work_b = before.columns("b")
    second, *work_a = after.columns("a")
    at, moved = si(theta, DEGREE), station.machine.transfer
    heights = lane(0, moved.travel(at) / moved.stroke)
    clearance, h, i = station.clearance, station.tool.stroke, station.number
    lane_t = cell("lane_t", heights)
    cell.place(
        sheet,
        cell("theta", theta),
        cell("yt", shown(moved.travel(at), MM)),
        first,
        second,
        cell("limit", shown(clearance.allowed, MM), formula=ALLOWED),
        cell("free", shown(clearance.free, MM)),
        before.rate(2, "acc", "b"),
        after.rate(2, "acc", "a"),
        *([lane_t] if i == 1 else []),
        cell("lane_b", lane(i, before.travel / h), i=i),
        cell("lane_a", lane(i, after.travel / h), i=i),
        cell("k", list(range(len(theta)))),
        after.rate(1, "vel", "a"),
        after.rate(3, "jerk", "a"),
        *work_b,
        *work_a,
    )


def transfer_pieces(sheet: Sheet, machine: OverlapView, pieces: Pieces) -> Joints:
    """Declare the phases of the transfer and their pieces."""
    parts = machine.transfer.parts
    rows = rows_of(TRANSFER, parts, pieces)
    formulas = formulas_by_row(__file__, "phases of the transfer")
    phases(sheet, "The transfer, from the start of the cycle", parts, rows, formulas)
    moves = tuple(formulas["what"])
    joints = joints_of(rows, whole_turn(parts), machine.given.transfer, "overlap_", "°", "overlap_transfer", moves)
    sheet.rows(*joints.order())
    sheet.row += 1
    pieces_table(sheet, "Pieces of the transfer", rows, machine.room, size_of_parts(parts))
    sheet.row += 1
    joints.table(sheet, "What jumps where each piece of the transfer begins", machine.room)
    return joints


def tool_pieces(sheet: Sheet, station: Station, pieces: Pieces) -> Joints:
    """Declare the phases of a tool in both schedules, and their pieces; return the joints of it as it is set."""
    (row_in, row_out), room = station.law_rows, station.machine.room
    for schedule, (row, words) in SCHEDULES.items():
        plan = station.schedules[row - 1]
        rows = rows_of(OF_TOOL[schedule], plan.parts, pieces)
        into, out = f"[@schedules.in.{row}]", f"[@schedules.out.{row}]"
        laws = {"row_in": str(row_in), "row_out": str(row_out)}
        formulas = formulas_by_row(__file__, "phases of a tool", into=into, out=out, **laws)
        phases(sheet, f"The tool {words}, from its arrival", plan.parts, rows, formulas)
        pieces_table(sheet, f"Pieces of the tool {words}", rows, room, size_of_parts(plan.parts))
    joints = joints_of(rows, plan.motion, station.given, "@", "° after its arrival", "@name", tuple(formulas["what"]))
    sheet.row += 1
    sheet.rows(*joints.order())
    sheet.row += 1
    joints.table(sheet, "What jumps where each piece of the tool begins", room)
    return joints


def phases(
    sheet: Sheet, title: str, parts: Sequence[ScaledLaw], rows: PieceRows, formulas: dict[str, list[str]]
) -> None:
    """Declare the phases of a motion over the master angle; ``formulas`` are those of the columns, a row each."""
    cell = CELLS["phases"]
    size, degrees = size_of_parts(parts), [shown(part.duration, DEGREE) for part in parts]
    sheet.row += 1
    cell.sharing(name=rows.at.phases, title=title).place(
        sheet,
        cell("what", formulas["what"]),
        cell("k", [k for k, _ in enumerate(parts, 1)]),
        cell("no", list(rows.numbers), formula=formulas["no"]),
        cell("h", [part.h for part in parts], formula=formulas["h"], scale=size(0)),
        cell("angle", degrees, formula=formulas["angle"]),
        cell("span", [part.duration for part in parts]),
        cell("begin", [shown(part.x, DEGREE) for part in parts], formula=formulas["begin"]),
        cell("y0", [part.y for part in parts], formula=formulas["y0"], scale=size(0)),
        cell("v", [part.max_velocity for part in parts], formula=VELOCITY),
        cell("a", [part.max_acceleration for part in parts], formula=ACCELERATION),
        *phase_columns(rows),
    )
    sheet.rows(pieces_in_all(rows))
    sheet.row += 1
