"""The Picture sheet: all parts drawn at an angle of the master shaft that the engineer moves, in both schedules."""

import numpy as np

from engine.overlap.picture import BODY, FRAME, PLATE, PUNCH, STEP, WALLS, WIDTH
from engine.overlap.plan import colliding
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet
from workbook.fields.units import DEGREE, MM, shown, si
from workbook.laws import sampling
from workbook.machines.overlap.cycle import ALLOWED, SCHEDULES, AtAngles, transfer_columns
from workbook.machines.overlap.view import OverlapView

CELLS = cell_tables(__file__)

SAYS = '=IF([free]<0-inverse_bound*@stroke,"COLLISION",IF([limit]<@stroke,"in the way","in place"))'
ACROSS = (
    "=[places.x.{0}]+MAX(0-overlap_pitch,MIN(overlap_pitch,[view.yt]+overlap_pitch*([wall]+[side])"
    "+[places.open.{0}]*(1/2-[side])))"
)
UPWARDS = "=IF([up]=1,[places.top.{0}],0-picture_plate*MAX([places.h]))"


class States:
    """All parts at the angle entered, in both schedules: arrays over the tools, lengths in m."""

    def __init__(self, machine: OverlapView, pieces: sampling.Pieces) -> None:
        self.theta = np.array([machine.given.view])
        angle, stations = si(self.theta, DEGREE), machine.stations
        self.pairs = [tuple(AtAngles(s, plan, self.theta, pieces) for plan in SCHEDULES) for s in stations]
        self.before, self.after = np.array([[state.travel[0] for state in pair] for pair in self.pairs]).T
        clearances = [s.engine.clearance(s.as_set, angle) for s in stations]
        self.allowed = np.array([c.allowed[0] for c in clearances])
        self.free = np.array([c.free[0] for c in clearances])
        self.strokes = machine.scene.strokes
        self.moved = float(machine.transfer.travel(angle)[0])

    def says(self) -> list[str]:
        """Return in words how each tool and the transfer stand."""
        where = np.where(self.allowed < self.strokes, "in the way", "in place")
        return [str(words) for words in np.where(colliding(self.free, self.strokes), "COLLISION", where)]


def picture_sheet(book: Book, machine: OverlapView, pieces: sampling.Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet(
        "Picture", "All parts at one angle of the master shaft: change the angle and both pictures move."
    )
    sheet.one_page = True
    sheet.heading("Enter")
    sheet.rows(CELLS["picture_sheet"]("overlap_view", machine.given.view))
    states = States(machine, pieces)
    outcome(sheet, machine, states)
    sheet.not_printed_below()
    sheet.heading("Workings")
    workings(sheet, machine, states, pieces)
    outlines(sheet, machine, states)
    sheet.print_columns = 16


def outcome(sheet: Sheet, machine: OverlapView, states: States) -> None:
    """Declare what stands where at this angle, and place the two pictures side by side."""
    stations = machine.stations
    allowing = ALLOWED.replace("[theta]", "overlap_view")
    sheet.heading("Results")
    sheet.rows(CELLS["outcome"]("view_t", shown(states.moved, MM)))
    sheet.row += 1
    cell = CELLS["stands"]
    cell.sharing(tools="tools" if len(stations) > 1 else "tool").place(
        sheet,
        cell("name", [s.given.name for s in stations], formula=machine.each("=@name")),
        cell("b", shown(states.before, MM), formula=machine.each("=[@view.yb]")),
        cell("a", shown(states.after, MM), formula=machine.each("=[@view.ya]")),
        cell("limit", shown(states.allowed, MM), formula=machine.each(allowing)),
        cell("free", shown(states.free, MM)),
        cell("says", states.says(), formula=machine.each(SAYS)),
    )

    def lines(column: str) -> tuple[Series, ...]:
        tools = (Series("=@name", "[@punch.x]", f"[@punch.{column}]").within(s.scope) for s in machine.stations)
        moved = Series("=overlap_transfer", "[outline.x]", "[outline.y]")
        return (moved, *tools, Series("frame", "[frame.x]", "[frame.y]", color="BFBFBF"))

    sheet.row += 1
    sheet.chart_row(
        *(
            Chart(
                title,
                "across [mm]",
                "height of the tool above the part [mm]",
                lines(column),
                f"Outlines of transfer and tools at the angle entered: {title.lower()}",
            )
            for title, column in (("One after the other", "yb"), ("With overlap", "ya"))
        ),
        width=8,
        height=24,
    )


def workings(sheet: Sheet, machine: OverlapView, states: States, pieces: sampling.Pieces) -> None:
    """Declare the sizes of the parts, their laws at this angle, and the line that marks it in the diagrams."""
    stations, scene = machine.stations, machine.scene
    cell = CELLS["workings"]
    sheet.rows(
        cell("picture_width", WIDTH),
        cell("picture_body", BODY),
        cell("picture_plate", PLATE),
        cell("picture_step", STEP),
    )
    sheet.row += 1
    cell = CELLS["places"]
    cell.place(
        sheet,
        cell("i", [s.number for s in stations]),
        cell("x", shown(scene.middles, MM)),
        cell(
            "open", shown(scene.openings, MM), formula=machine.each("=overlap_pitch*(picture_width+2*@remaining/100)")
        ),
        cell("top", shown(scene.tops, MM), formula=machine.each("=MAX(@stroke-@clearance,0)")),
        cell("h", shown(scene.strokes, MM), formula=machine.each("=@stroke")),
    )
    sheet.table(
        "view",
        "The transfer's law at this angle",
        1,
        CELLS["view"]("theta", states.theta),
        *transfer_columns(machine, states.theta, pieces),
    )
    for station, (before, after) in zip(machine.stations, states.pairs, strict=True):
        with sheet.scoped(station.scope):
            sheet.table(
                "@view",
                "The tool's laws at this angle" if machine.alone else f"The laws of tool {station.number}",
                1,
                CELLS["view"]("theta", states.theta),
                *before.columns("b"),
                *after.columns("a"),
            )


def outlines(sheet: Sheet, machine: OverlapView, states: States) -> None:
    """Declare the outlines: at each station three walls of the transfer, seen in its frame; tools by their height."""
    numbers, walls, sides, ups = zip(*((s.number, *corner) for s in machine.stations for corner in WALLS), strict=True)
    outline = machine.scene.walls(states.moved)
    cell = CELLS["outline"]
    cell.place(
        sheet,
        cell("i", list(numbers)),
        cell("wall", list(walls)),
        cell("side", list(sides)),
        cell("up", list(ups)),
        cell("x", shown(outline.x, MM), formula=[ACROSS.format(i) for i in numbers]),
        cell("y", shown(outline.z, MM), formula=[UPWARDS.format(i) for i in numbers]),
    )
    across, along = zip(*PUNCH, strict=True)
    for station, before, after in zip(machine.stations, states.before, states.after, strict=True):
        i = station.number
        (x, first), (_, second) = (machine.scene.punch(i - 1, travel) for travel in (before, after))
        whose = "the tool" if machine.alone else f"tool {i}"
        with sheet.scoped(station.scope):
            cell = CELLS["punch"]
            cell.sharing(whose=whose).place(
                sheet,
                cell("px", list(across)),
                cell("py", list(along)),
                cell("x", shown(x, MM), i=i),
                *(cell(f"y{schedule}", shown(z, MM)) for schedule, z in zip(SCHEDULES, (first, second), strict=True)),
            )
    frame, (fx, fy) = machine.scene.frame(), zip(*FRAME, strict=True)
    cell = CELLS["frame"]
    cell.place(
        sheet, cell("fx", list(fx)), cell("fy", list(fy)), cell("x", shown(frame.x, MM)), cell("y", shown(frame.z, MM))
    )
