"""One tool and the transfer: what to enter, the three schedules, checks, charts, and the way to the angles.

The names stand in the tool's scope: ``@stroke`` is ``tool2_stroke`` for the second (:mod:`workbook.book.declare`).
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from workbook.book.cell_tables import cell_tables, charts_beside
from workbook.book.declare import Quantity, Sheet
from workbook.book.sentence import amount
from workbook.entries.facts import entry_cells
from workbook.fields.units import DEGREE, MM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap.cycle import AtAngles
from workbook.machines.overlap.entries import LEAST
from workbook.machines.overlap.view import Station

CELLS = cell_tables(__file__)
CHARTS = charts_beside(__file__)

SHARES = {"in": "@split", "out": "(1-@split)"}  # of what is free for both ways
CORNERS = (
    "transfer gets in the way",
    "transfer is in place",
    "tool sets off",
    "tool arrives",
    "tool leaves",
    "tool is back",
)


def declare(
    sheet: Sheet,
    station: Station,
    pieces: Pieces,
    beside: int,
    below: int,
    shared: Sequence[Quantity] = (),
    workings: Sequence[Quantity] = (),
) -> None:
    """Declare a tool: charts from the row ``beside``, tables from ``below``; ``shared`` are checks of all tools."""
    with sheet.scoped(station.scope):
        sheet.rows(*entry_cells(station.given, station.key))
        outcome(sheet, station)
        sheet.checks(*shared)
        charts(sheet, beside)
        sheet.row = max(sheet.row, below)
        schedules(sheet, station)
        margins(sheet, station)
        sheet.not_printed_below()
        sheet.heading("Workings")
        sheet.rows(*workings)
        steps(sheet, station)
        corners_table(sheet, station, pieces)


def outcome(sheet: Sheet, station: Station) -> None:
    """Declare the results, in short, and the checks."""
    cell = CELLS["outcome"]
    before, _, after = station.peaks
    way_in, way_out = station.angles_set
    sheet.heading("Results")
    sheet.rows(
        cell("@new_in", way_in),
        cell("@new_out", way_out),
        cell("@a0", before),
        cell("@a1", after),
        cell("@ratio", station.as_set.times_lower(station.before)),
        cell("@least", station.least),
        cell("@limit", station.longest.limit),
    )
    sheet.checks(*checks(station))


def checks(station: Station) -> tuple[Quantity, ...]:
    """Return the checks of the tool."""
    cell = CELLS["checks"]
    clearance, margin = station.clearance, station.given.passage.margin
    least = amount("@least", station.least, "least clearance ", " mm")
    missing = amount("@margin-@least", margin - station.least, "", " mm too little stay free")
    return (
        cell("@ok_collide", not clearance.collides, says=least),
        cell("@ok_margin", clearance.meets_margin, says=missing),
        cell("@ok_angle", True),
        cell("@ok_turn", True),
        cell("@ok_entry", True),
    )


def charts(sheet: Sheet, row: int) -> None:
    """Place the travel under its limit, and the accelerations."""
    for column, title in ((11, "Travel of the tool, and what the transfer allows"), (15, "Acceleration of the tool")):
        chart = replace(CHARTS[title], x_range=(0, 360, 30))
        sheet.chart(chart, column=column, row=row, width=4, height=18)


def schedules(sheet: Sheet, station: Station) -> None:
    """Declare the table of the three schedules."""
    cell = CELLS["schedules"]
    plans, rate = station.schedules, station.machine.rate
    away, there, leaves, back = shown(np.array([plan.edges for plan in plans]).T, DEGREE)
    way_in, way_out = shown(np.array([(plan.angle_in, plan.angle_out) for plan in plans]).T, DEGREE)
    time_in, time_out = np.array([plan.times(rate) for plan in plans]).T
    peak_in, peak_out = np.array([plan.movement_peaks(rate) for plan in plans]).T
    row_in, row_out = station.law_rows
    angles = {
        way: [
            f"=@free0*{share}",
            f"={longest(way, f'@rest_{way}')}",
            f'=IF(@set_{way}="",[@schedules.{way}.2]-@allowance,@set_{way})',
        ]
        for way, share in SHARES.items()
    }
    sheet.row += 1
    cell.place(
        sheet,
        cell("what", ["one after the other", "overlap, the longest", "overlap, as set"]),
        cell("in", way_in, formula=angles["in"]),
        cell("out", way_out, formula=angles["out"]),
        cell("away", away),
        cell("there", there),
        cell("leaves", leaves),
        cell("back", back),
        cell("t_in", time_in),
        cell("t_out", time_out),
        cell("a_in", peak_in, row_in=row_in),
        cell("a_out", peak_out, row_out=row_out),
        cell("a", station.peaks),
        cell("ratio", [plan.times_lower(station.before) for plan in plans]),
        cell("k", [1, 2, 3]),
    )


def longest(way: str, rest: str) -> str:
    """Return the formula, without =, of the longest angle of a way of which a share is left as the transfer moves."""
    most = f"@room*{SHARES[way]}"
    return f"IF({rest}>0,MIN(@free_{way}/{rest},{most}),{most})"


def steps(sheet: Sheet, station: Station) -> None:
    """Declare the way from the entries to the angles, as S2 goes it."""
    cell = CELLS["steps"]
    left, before = station.engine.left, station.before
    (first, last), shorter = station.blocked_rows, min(before.angle_in, before.angle_out)
    begin, end, free_in, free_out, both = (shown(angle, DEGREE) for angle in left)
    rest_in, rest_out = station.engine.remaining_shares(np.array(station.passage.margin))
    sheet.rows(
        cell("@free0", shown(before.angle_in + before.angle_out, DEGREE)),
        cell("@begin", begin, first=first),
        cell("@end", end, last=last),
        cell("@effective", shown(left.end - left.begin, DEGREE)),
        cell("@free_in", free_in),
        cell("@free_out", free_out),
        cell("@rest_in", float(rest_in)),
        cell("@rest_out", float(rest_out)),
        cell("@room", both),
        cell("@least_left", shown(shorter - station.passage.allowance, DEGREE)),
        cell("@least_way", LEAST),
    )


def corners_table(sheet: Sheet, station: Station, pieces: Pieces) -> None:
    """Declare the corners of the diagram, at which the clearance is least."""
    cell = CELLS["corners"]
    at = station.engine.critical_angles(station.as_set)
    theta = shown(at.angle, DEGREE)
    edges = [f"=[@schedules.{edge}.3]" for edge in ("away", "there", "leaves", "back")]
    sheet.row += 1
    cell.place(
        sheet,
        cell("what", list(CORNERS)),
        cell("raw", shown(at.raw, DEGREE), formula=["=@begin", "=@end", *edges]),
        cell("theta", theta),
        cell("inside", at.inside.astype(float)),
        cell("free", shown(at.free, MM)),
        *AtAngles(station, "a", theta, pieces).columns(""),
    )


def margins(sheet: Sheet, station: Station) -> None:
    """Declare what a margin costs: charts and table, in the tool's scope."""
    CELLS["margins"].begin(sheet)
    sheet.chart_row(CHARTS["Acceleration ratio against margin"], CHARTS["Peak acceleration against margin"], width=7)
    cell, sweep, n = CELLS["margins"], station.margins, station.machine.sizes.margins
    row_in, row_out = station.law_rows
    longest_in = longest("in", "(1-INDEX([@inverse_in.xi],[k]+2))")
    longest_out = longest("out", "INDEX([@inverse_out.xi],[k]+2)")
    cell.place(
        sheet,
        cell("margin", shown(sweep.margin, MM)),
        cell("in", shown(sweep.angle_in, DEGREE), longest=longest_in),
        cell("out", shown(sweep.angle_out, DEGREE), longest=longest_out),
        cell("a", sweep.acceleration, row_in=row_in, row_out=row_out),
        cell("ratio", sweep.ratio),
        cell("k", list(range(n + 1))),
    )
    cell = CELLS["margin_line"]
    cell.place(
        sheet,
        cell("end", [0, 1]),
        cell("x", station.given.passage.margin),
        cell("ratio", [0.0, float(sweep.ratio.max())]),
        cell("a", [0.0, float(sweep.acceleration.max())]),
    )
