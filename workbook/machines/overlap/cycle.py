"""The Cycle sheet, one for each tool: both parts over the master angle, one after the other and with overlap."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from engine.laws.base import Array
from engine.overlap import Schedule
from engine.overlap.picture import LANE_SHARE, lane
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.entries.units import DEGREE, MM, shown, si
from workbook.laws import sampling
from workbook.machines.overlap.entries import TURN
from workbook.machines.overlap.view import Overlapping, Station

TRAVELS = {"": "travel of the tool", "b": "travel, one after the other", "a": "travel, with overlap"}
PART = (
    "=1+IF([since{0}]+overlap_eps>=@dwell,1,0)+IF([since{0}]+overlap_eps>=@dwell+[@schedules.out.{1}],1,0)"
    "+IF([since{0}]+overlap_eps>=360-[@schedules.in.{1}],1,0)"
)
ABSCISSA = (
    "=CHOOSE([part{0}],0,MAX(0,([since{0}]-@dwell)/[@schedules.out.{1}]),0,"
    "MAX(0,([since{0}]-360+[@schedules.in.{1}])/[@schedules.in.{1}]))"
)


class AtAngles:
    """The tool of one schedule at angles of the master shaft: from its arrival dwell, way out, rest, way in."""

    def __init__(self, station: Station, plan: Schedule, theta: Array, pieces: sampling.Pieces) -> None:
        """Take angles in degrees."""
        self.station, self.plan, self.pieces = station, plan, pieces
        self.angle = si(theta, DEGREE)
        self.state = plan.state(self.angle)
        self.travel = plan.travel(self.angle)
        self.y = shown(self.travel, MM)

    def columns(self, suffix: str, row: int) -> list[Quantity]:
        """Return the workings and the travel; ``row`` is the schedule's in the table of the tool's angles."""
        given, library = self.station.given, self.station.machine.library
        codes = np.array(["DWL", given.law_out, "DWL", given.law_in])
        since, part, xi = self.state
        names = [*library]
        numbers = np.array([names.index(code) + 1 for code in codes])[part - 1]
        found = np.empty((self.pieces.width, len(xi)))
        values = {d: np.empty(len(xi)) for d in "sa"}
        for number in np.unique(numbers):
            here = numbers == number
            found[:, here] = self.pieces.locate(int(number), xi[here])
            at = library[names[number - 1]].evaluate(xi[here])
            values["s"][here], values["a"][here] = at.s, at.a
        row_in, row_out = self.station.law_rows
        return [
            calc(f"y{suffix}", TRAVELS[suffix], "y", "mm",
                 f"=@stroke*CHOOSE([part{suffix}],1,1-[s{suffix}],0,[s{suffix}])", self.y,
                 source="h s in, h (1 − s) out"),
            calc(f"since{suffix}", "angle since its arrival", "", "°",
                 f"=[theta]-[@schedules.there.{row}]-360*INT(([theta]-[@schedules.there.{row}])/360+break_tolerance)",
                 shown(since, DEGREE), scale=TURN),
            calc(f"part{suffix}", "phase", "", "",
                 PART.format(suffix, row), part, format="0", source="1 dwell, 2 out, 3 rest, 4 in"),
            calc(f"xi{suffix}", "abscissa", "ξ", "", ABSCISSA.format(suffix, row), xi),
            calc(f"n{suffix}", "law number", "", "",
                 f"=CHOOSE([part{suffix}],1,[used.no.{row_out}],1,[used.no.{row_in}])", numbers, format="0"),
            *self.pieces.finding(f"[n{suffix}]", f"xi{suffix}", found, suffix),
            *self.pieces.columns(values, "sa", suffix),
        ]  # fmt: skip

    def acceleration(self, suffix: str, row: int, label: str) -> Quantity:
        """Return the column of the acceleration in m/s², from the engine's motion of the tool."""
        value = self.plan.acceleration(self.angle, self.station.machine.rate)
        formula = (
            f"=CHOOSE([part{suffix}],0,0-[a{suffix}]/[@schedules.t_out.{row}]^2,"
            f"0,[a{suffix}]/[@schedules.t_in.{row}]^2)*@stroke/1000"
        )
        return result(f"acc{suffix}", label, "a", "m/s²", formula, value, source="± h a/t_m²")


def transfer_columns(machine: Overlapping, theta: Array, pieces: sampling.Pieces) -> list[Quantity]:
    """Return the travel of the transfer and its workings."""
    moved, angle = machine.transfer, si(theta, DEGREE)
    number = pieces.number(moved.law)
    xi = moved.xi(angle)
    return [
        result("yt", "travel of the transfer", "y_t", "mm",
               "=overlap_pitch*[st]", shown(moved.travel(angle), MM), source="h_t s"),
        calc("xit", "its abscissa", "ξ", "", "=MIN([theta]/overlap_angle,1)", xi),
        *pieces.finding("[used.no.1]", "xit", pieces.locate(number, xi), "t"),
        *pieces.columns({"s": moved.law.s(xi)}, "s", "t"),
    ]  # fmt: skip


ALLOWED = "=IF(AND([theta]>@begin+overlap_eps,[theta]<@end-overlap_eps),@clearance,@stroke)"


def cycle_sheets(book: Book, machine: Overlapping, pieces: sampling.Pieces) -> None:
    """Declare a sheet for each tool: travel, acceleration and clearance over one turn of the master shaft."""
    for station in machine.stations:
        i = station.number
        title, what = ("Cycle", "Both parts") if machine.alone else (f"Cycle {i}", f"Transfer and tool {i}")
        sheet = book.sheet(title, f"{what} over one turn of the master shaft, one after the other and with overlap.")
        if station.number == 1:
            sheet.rows(lane_height())
            sheet.row += 1
        with sheet.scoped(station.scope):
            motions(sheet, station, pieces)


def lane_height() -> Quantity:
    """Return the height of a part in the timing diagrams."""
    return constant(
        "overlap_lane",
        "Height of a part in the diagrams",
        "",
        "",
        LANE_SHARE,
        format="0.0",
        source="as a share of its lane",
    )


def motions(sheet: Sheet, station: Station, pieces: sampling.Pieces) -> None:
    """Declare the table over the cycle."""
    theta = station.machine.angles
    before, after = (AtAngles(station, plan, theta, pieces) for plan in (station.before, station.as_set))
    first, *work_b = before.columns("b", 1)
    second, *work_a = after.columns("a", 3)
    moved, lane_t, work_t = transfer_over_cycle(station, theta, pieces)
    found, h, i = station.clearance, station.tool.stroke, station.number
    sheet.table(
        "@motions", "Travel, acceleration and clearance over the master angle", len(theta),
        calc("theta", "master angle", "θ", "°", "=[k]*360/[@motions.k.last]", theta, format="0.0##"),
        moved, first, second,
        result("limit", "travel allowed to the tool", "", "mm",
               ALLOWED, shown(found.allowed, MM), source="c while the transfer is in the way, else h"),
        result("free", "free with overlap", "", "mm", "=[limit]-[ya]", shown(found.free, MM),
               source="below 0: collision"),
        before.acceleration("b", 1, "acceleration, one after the other"),
        after.acceleration("a", 3, "acceleration, with overlap"),
        *lane_t,
        calc("lane_b", "tool, one after the other", "", "",
             f"={i}+[yb]/@stroke*overlap_lane", lane(i, before.travel, h)),
        calc("lane_a", "tool, with overlap", "", "",
             f"={i}+[ya]/@stroke*overlap_lane", lane(i, after.travel, h)),
        constant("k", "sample", "k", "", list(range(len(theta)))),
        *work_t, *work_b, *work_a,
    )  # fmt: skip


def transfer_over_cycle(
    station: Station, theta: Array, pieces: sampling.Pieces
) -> tuple[Quantity, list[Quantity], list[Quantity]]:
    """Return travel, lane in the diagrams and workings of the transfer; the first tool's table has them for all."""
    machine = station.machine
    moved, *work = transfer_columns(machine, theta, pieces)
    if station.number > 1:
        return replace(moved, formula="=INDEX([tool1_motions.yt],[k]+1)", source="as beside the first tool"), [], []
    heights = lane(0, machine.transfer.travel(si(theta, DEGREE)), machine.transfer.stroke)
    drawn = calc("lane_t", "transfer in the diagrams", "", "", "=[yt]/overlap_pitch*overlap_lane", heights)
    return moved, [drawn], work
