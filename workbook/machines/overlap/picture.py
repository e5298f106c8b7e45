"""The Picture sheet: all parts drawn at an angle of the master shaft that the engineer moves, in both schedules."""

import numpy as np

from engine.overlap.picture import BODY, FRAME, LANE_SHARE, PLATE, PUNCH, STEP, WALLS, WIDTH
from engine.overlap.plan import colliding
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, constant, given, result
from workbook.fields.units import DEGREE, MM, shown, si
from workbook.laws import sampling
from workbook.machines.overlap.cycle import ALLOWED, SCHEDULES, AtAngles, transfer_columns
from workbook.machines.overlap.view import OverlapView

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
        found = [s.engine.clearance(s.as_set, angle) for s in stations]
        self.allowed = np.array([c.allowed[0] for c in found])
        self.free = np.array([c.free[0] for c in found])
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
    sheet.heading("Enter")
    sheet.rows(given("overlap_view", "Master angle to look at", "θ", "°", machine.given.view, "overlap.view",
                     format="0.0##", source="0 to 360: step through the cycle"))  # fmt: skip
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
    sheet.rows(result("view_t", "Travel of the transfer", "y_t", "mm", "=[view.yt]", shown(states.moved, MM)))
    sheet.row += 1
    sheet.table(
        "stands", "The tools at this angle" if len(stations) > 1 else "The tool at this angle", len(stations),
        calc("name", "tool", "", "", machine.each("=@name"), [s.given.name for s in stations], align="left"),
        result("b", "travel, one after the other", "y", "mm", machine.each("=[@view.yb]"), shown(states.before, MM)),
        result("a", "travel, with overlap", "y", "mm", machine.each("=[@view.ya]"), shown(states.after, MM)),
        result("limit", "travel allowed", "", "mm",
               machine.each(allowing), shown(states.allowed, MM), "c if in the way, else h"),
        result("free", "free, with overlap", "", "mm", "=[limit]-[a]", shown(states.free, MM),
               "below 0 the parts collide"),
        result("says", "the transfer is", "", "", machine.each(SAYS), states.says()),
    )  # fmt: skip

    def lines(column: str) -> tuple[Series, ...]:
        tools = (Series("=@name", "[@punch.x]", f"[@punch.{column}]").within(s.scope) for s in machine.stations)
        moved = Series("=overlap_transfer", "[outline.x]", "[outline.y]")
        return (moved, *tools, Series("frame", "[frame.x]", "[frame.y]", color="BFBFBF"))

    sheet.row += 1
    sheet.chart_row(
        *(Chart(title, "across [mm]", "height of the tool above the part [mm]", lines(column),
                f"Outlines of transfer and tools at the angle entered: {title.lower()}")
          for title, column in (("One after the other", "yb"), ("With overlap", "ya"))),
        width=8, height=24,
    )  # fmt: skip


def workings(sheet: Sheet, machine: OverlapView, states: States, pieces: sampling.Pieces) -> None:
    """Declare the sizes of the parts, their laws at this angle, and the line that marks it in the diagrams."""
    stations, scene = machine.stations, machine.scene
    sheet.rows(
        constant("picture_width", "Width of a tool", "", "",
                 WIDTH, "as a share of the transfer's stroke", format="0.0##"),
        constant("picture_body", "Length of a tool", "", "", BODY, "as a share of its stroke", format="0.0##"),
        constant("picture_plate", "Thickness of the plate below the part", "", "",
                 PLATE, "as a share of the longest stroke of a tool", format="0.0##"),
        constant("picture_step", "From station to station", "", "",
                 STEP, "as a multiple of the transfer's stroke", format="0.0##"),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "places", "The stations in the picture", len(stations),
        constant("i", "tool", "", "", [s.number for s in stations]),
        calc("x", "middle of the station", "X", "mm", "=([i]-1)*picture_step*overlap_pitch", shown(scene.middles, MM)),
        calc("open", "opening of the transfer", "", "mm",
             machine.each("=overlap_pitch*(picture_width+2*@remaining/100)"), shown(scene.openings, MM),
             "the tool, and s_r of the stroke on both sides"),
        calc("top", "height of the transfer above the part", "", "mm",
             machine.each("=MAX(@stroke-@clearance,0)"), shown(scene.tops, MM), "h − c"),
        calc("h", "stroke", "h", "mm", machine.each("=@stroke"), shown(scene.strokes, MM)),
    )  # fmt: skip
    sheet.table(
        "view", "The transfer's law at this angle", 1,
        calc("theta", "master angle", "θ", "°", "=overlap_view", states.theta),
        *transfer_columns(machine, states.theta, pieces),
    )  # fmt: skip
    for station, (before, after) in zip(machine.stations, states.pairs, strict=True):
        with sheet.scoped(station.scope):
            sheet.table(
                "@view", "The tool's laws at this angle" if machine.alone else f"The laws of tool {station.number}", 1,
                calc("theta", "master angle", "θ", "°", "=overlap_view", states.theta),
                *before.columns("b"),
                *after.columns("a"),
            )  # fmt: skip
    top = len(machine.stations)
    sheet.table(
        "view_line", "The line in both timing diagrams", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("theta", "master angle", "θ", "°", "=overlap_view", machine.given.view),
        calc("height", "height", "", "", f"=[end]*({top}+overlap_lane)", [0.0, top + LANE_SHARE]),
    )  # fmt: skip


def outlines(sheet: Sheet, machine: OverlapView, states: States) -> None:
    """Declare the outlines: at each station three walls of the transfer, seen in its frame; tools by their height."""
    numbers, walls, sides, ups = zip(*((s.number, *corner) for s in machine.stations for corner in WALLS), strict=True)
    outline = machine.scene.walls(states.moved)
    sheet.table(
        "outline", "Outline of the transfer", len(numbers),
        constant("i", "tool", "", "", list(numbers)),
        constant("wall", "wall", "", "", list(walls)),
        constant("side", "right side", "", "", list(sides)),
        constant("up", "upper side", "", "", list(ups)),
        calc("x", "across", "X", "mm", [ACROSS.format(i) for i in numbers], shown(outline.x, MM)),
        calc("y", "height", "z", "mm", [UPWARDS.format(i) for i in numbers], shown(outline.z, MM)),
    )  # fmt: skip
    across, along = zip(*PUNCH, strict=True)
    for station, before, after in zip(machine.stations, states.before, states.after, strict=True):
        i = station.number
        (x, first), (_, second) = (machine.scene.punch(i - 1, travel) for travel in (before, after))
        whose = "the tool" if machine.alone else f"tool {i}"
        with sheet.scoped(station.scope):
            sheet.table(
                "@punch", f"Outline of {whose}", len(PUNCH),
                constant("px", "across", "", "", list(across)),
                constant("py", "along", "", "", list(along)),
                calc("x", "across", "X", "mm", f"=[places.x.{i}]+[px]*picture_width*overlap_pitch", shown(x, MM)),
                *(calc(f"y{one}", words, "z", "mm", f"=@stroke-[@view.y{one}]+[py]*picture_body*@stroke", shown(z, MM))
                  for (one, (_, words)), z in zip(SCHEDULES.items(), (first, second), strict=True)),
            )  # fmt: skip
    frame, (fx, fy) = machine.scene.frame(), zip(*FRAME, strict=True)
    sheet.table(
        "frame", "Frame of the picture: keeps its scale", len(FRAME),
        constant("fx", "right side", "", "", list(fx)),
        constant("fy", "upper side", "", "", list(fy)),
        calc("x", "across", "X", "mm", "=IF([fx]=1,MAX([places.x])+overlap_pitch,0-overlap_pitch)", shown(frame.x, MM)),
        calc("y", "height", "z", "mm", "=IF([fy]=1,(1+picture_body)*MAX([places.h]),0-picture_plate*MAX([places.h]))",
             shown(frame.z, MM)),
    )  # fmt: skip
