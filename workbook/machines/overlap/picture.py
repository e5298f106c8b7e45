"""The Picture sheet: all parts drawn at an angle of the master shaft that the engineer moves, in both schedules."""

from __future__ import annotations

import numpy as np

from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, constant, given, result
from workbook.laws import sampling
from workbook.machines.overlap.cycle import ALLOWED, LANE_SHARE, ToolState, allowed, transfer_columns
from workbook.machines.overlap.entries import TURN
from workbook.machines.overlap.places import each
from workbook.machines.overlap.view import Overlapping, Station

WIDTH, BODY, PLATE = 0.3, 1.5, 0.2  # of the picture: tool in transfer strokes, its length and the plate in tool strokes
STEP = 2.5  # from station to station in the picture, in transfer strokes
PUNCH = (
    (-0.5, 0.0),
    (-0.5, 0.8),
    (-1.0, 0.8),
    (-1.0, 1.0),
    (1.0, 1.0),
    (1.0, 0.8),
    (0.5, 0.8),
    (0.5, 0.0),
    (-0.5, 0.0),
)
WALLS = tuple((wall, side, up) for wall in (-2, -1, 0) for side, up in ((0, 0), (0, 1), (1, 1), (1, 0)))
ACROSS = (
    "=[places.x.{0}]+MAX(0-overlap_pitch,MIN(overlap_pitch,[view.yt]+overlap_pitch*([wall]+[side])"
    "+[places.open.{0}]*(1/2-[side])))"
)
UPWARDS = "=IF([up]=1,[places.top.{0}],0-picture_plate*MAX([places.h]))"
FRAME = ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))


class States:
    """All tools at the angle entered, in both schedules: arrays over the tools, lengths in mm."""

    def __init__(self, machine: Overlapping, pieces: sampling.Pieces) -> None:
        self.theta = np.array([machine.given.view])
        stations = machine.stations
        self.pairs = [tuple(ToolState(s, plan, self.theta, pieces) for plan in (s.before, s.as_set)) for s in stations]
        self.before, self.after = np.array([[state.y[0] for state in pair] for pair in self.pairs]).T
        self.limit = np.array([allowed(s, self.theta)[0] for s in stations])
        self.stroke = np.array([s.given.stroke for s in stations])
        self.moved = transfer_columns(machine, self.theta, pieces)[0].value[0]
        pitch = machine.given.transfer.stroke
        self.place = pitch * STEP * np.arange(len(stations))
        self.opening = np.array([pitch * (WIDTH + 2 * s.passage.remaining) for s in stations])
        self.top = np.array([max(s.given.stroke - s.given.passage.clearance, 0.0) for s in stations])

    def says(self) -> list[str]:
        """Return in words how each tool and the transfer stand."""
        collides = self.limit - self.after < -1e-9 * self.stroke
        where = np.where(self.limit < self.stroke, "in the way", "in place")
        return [str(words) for words in np.where(collides, "COLLISION", where)]


def picture_sheet(book: Book, machine: Overlapping, pieces: sampling.Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet(
        "Picture", "All parts at one angle of the master shaft: change the angle and both pictures move."
    )
    sheet.heading("What to enter")
    sheet.rows(
        given(
            "overlap_view",
            "Master angle to look at",
            "θ",
            "°",
            machine.given.view,
            "overlap.view",
            format="0.0##",
            source="0 to 360: step through the cycle",
        )
    )
    states = States(machine, pieces)
    outcome(sheet, machine, states)
    pictures(sheet, machine)
    sheet.heading("Workings")
    dimensions(sheet, machine, states)
    evaluated(sheet, machine, states, pieces)
    outlines(sheet, machine, states)
    sheet.print_columns = 16


def outcome(sheet: Sheet, machine: Overlapping, states: States) -> None:
    """Declare what stands where at this angle."""
    stations, free = machine.stations, states.limit - states.after
    allowing = ALLOWED.replace("[theta]", "overlap_view")

    sheet.heading("What comes out")
    sheet.rows(result("view_t", "Travel of the transfer", "y_t", "mm", "=[view.yt]", states.moved))
    sheet.row += 1
    sheet.table(
        "stands", "The tools at this angle" if len(stations) > 1 else "The tool at this angle", len(stations),
        calc("name", "tool", "", "", each(machine, "=@name"), [s.given.name for s in stations], align="left"),
        result("b", "travel, one after the other", "y", "mm", each(machine, "=[@view.yb]"), states.before),
        result("a", "travel, with overlap", "y", "mm", each(machine, "=[@view.ya]"), states.after),
        result("limit", "travel allowed", "", "mm",
               each(machine, allowing), states.limit, source="c if in the way, else h"),
        result("free", "free, with overlap", "", "mm", "=[limit]-[a]", free, source="below 0 the parts collide"),
        result("says", "the transfer is", "", "", each(machine,
            '=IF([free]<0-check_zero*@stroke,"COLLISION",IF([limit]<@stroke,"in the way","in place"))'), states.says()),
    )  # fmt: skip


def pictures(sheet: Sheet, machine: Overlapping) -> None:
    """Place the two pictures side by side."""

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


def dimensions(sheet: Sheet, machine: Overlapping, states: States) -> None:
    """Declare the sizes of the parts in the picture."""
    stations = machine.stations

    sheet.rows(
        constant("picture_width", "Width of a tool", "", "",
                 WIDTH, format="0.0##", source="as a share of the transfer's stroke"),
        constant("picture_body", "Length of a tool", "", "", BODY, format="0.0##", source="as a share of its stroke"),
        constant("picture_plate", "Thickness of the plate below the part", "", "",
                 PLATE, format="0.0##", source="as a share of the longest stroke of a tool"),
        constant("picture_step", "From station to station", "", "",
                 STEP, format="0.0##", source="as a multiple of the transfer's stroke"),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "places", "The stations in the picture", len(stations),
        constant("i", "tool", "", "", [s.number for s in stations]),
        calc("x", "middle of the station", "x", "mm", "=([i]-1)*picture_step*overlap_pitch", states.place),
        calc("open", "opening of the transfer", "", "mm",
             each(machine, "=overlap_pitch*(picture_width+2*@remaining/100)"), states.opening,
             source="the tool, and r of the stroke on both sides"),
        calc("top", "height of the transfer above the part", "", "mm",
             each(machine, "=MAX(@stroke-@clearance,0)"), states.top, source="h − c"),
        calc("h", "stroke", "h", "mm", each(machine, "=@stroke"), states.stroke),
    )  # fmt: skip


def evaluated(sheet: Sheet, machine: Overlapping, states: States, pieces: sampling.Pieces) -> None:
    """Declare the rows that evaluate the laws at this angle, and the line that marks it in the diagrams."""
    sheet.table(
        "view", "The transfer's law at this angle", 1,
        calc("theta", "master angle", "θ", "°", "=overlap_view", states.theta, scale=TURN),
        *transfer_columns(machine, states.theta, pieces),
    )  # fmt: skip
    for station, (before, after) in zip(machine.stations, states.pairs, strict=True):
        with sheet.scoped(station.scope):
            sheet.table(
                "@view", "The tool's laws at this angle" if machine.alone else f"The laws of tool {station.number}", 1,
                calc("theta", "master angle", "θ", "°", "=overlap_view", states.theta, scale=TURN),
                *before.columns("b", 1),
                *after.columns("a", 3),
            )  # fmt: skip
    top = len(machine.stations)
    sheet.table(
        "view_line", "The line in both timing diagrams", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("theta", "master angle", "θ", "°", "=overlap_view", [machine.given.view] * 2, scale=TURN),
        calc("height", "height", "", "", f"=[end]*({top}+overlap_lane)", [0.0, top + LANE_SHARE]),
    )  # fmt: skip


def outlines(sheet: Sheet, machine: Overlapping, states: States) -> None:
    """Declare the outlines of the parts: across, the transfer's way; upwards, the height of a tool."""
    pitch, h = machine.given.transfer.stroke, states.stroke.max()
    transfer(sheet, pitch, states)
    for station, place, before, after in zip(machine.stations, states.place, states.before, states.after, strict=True):
        with sheet.scoped(station.scope):
            punch(sheet, station, place, (before, after))
    fx, fy = np.array(FRAME, dtype=float).T
    across = np.where(fx == 1, states.place[-1] + pitch, -pitch)
    sheet.table(
        "frame", "Frame of the picture: keeps its scale", len(FRAME),
        constant("fx", "right side", "", "", [int(v) for v in fx]),
        constant("fy", "upper side", "", "", [int(v) for v in fy]),
        calc("x", "across", "x", "mm", "=IF([fx]=1,MAX([places.x])+overlap_pitch,0-overlap_pitch)", across),
        calc("y", "height", "z", "mm",
             "=IF([fy]=1,(1+picture_body)*MAX([places.h]),0-picture_plate*MAX([places.h]))",
             np.where(fy == 1, h * (1 + BODY), -PLATE * h)),
    )  # fmt: skip


def transfer(sheet: Sheet, pitch: float, states: States) -> None:
    """Declare the outline of the transfer: at each station three walls, of which those in its frame are seen."""
    n = len(states.place)
    i = np.repeat(np.arange(n), len(WALLS))
    wall, side, up = np.tile(np.array(WALLS, dtype=float).T, n)
    x = np.clip(states.moved + pitch * (wall + side) + states.opening[i] * (0.5 - side), -pitch, pitch)
    y = np.where(up == 1, states.top[i], -PLATE * states.stroke.max())

    def station(formula: str) -> list[str]:
        return [formula.format(k + 1) for k in i]

    sheet.table(
        "outline", "Outline of the transfer", len(i),
        constant("i", "tool", "", "", [int(v) for v in i + 1]),
        constant("wall", "wall", "", "", [int(w) for w in wall]),
        constant("side", "right side", "", "", [int(s) for s in side]),
        constant("up", "upper side", "", "", [int(s) for s in up]),
        calc("x", "across", "x", "mm", station(ACROSS), states.place[i] + x),
        calc("y", "height", "z", "mm", station(UPWARDS), y),
    )  # fmt: skip


def punch(sheet: Sheet, station: Station, place: float, travels: tuple[float, float]) -> None:
    """Declare the outline of one tool."""
    pitch, h = station.machine.given.transfer.stroke, station.given.stroke
    px, py = np.array(PUNCH).T
    before, after = (h - y + py * BODY * h for y in travels)
    whose = "the tool" if station.machine.alone else f"tool {station.number}"
    sheet.table(
        "@punch", f"Outline of {whose}", len(PUNCH),
        constant("px", "across", "", "", list(map(float, px))),
        constant("py", "along", "", "", list(map(float, py))),
        calc("x", "across", "x", "mm",
             f"=[places.x.{station.number}]+[px]*picture_width*overlap_pitch", place + px * WIDTH * pitch),
        calc("yb", "one after the other", "z", "mm", "=@stroke-[@view.yb]+[py]*picture_body*@stroke", before),
        calc("ya", "with overlap", "z", "mm", "=@stroke-[@view.ya]+[py]*picture_body*@stroke", after),
    )  # fmt: skip
