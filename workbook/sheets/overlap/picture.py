"""The Picture sheet: both parts drawn at an angle of the master shaft that the engineer moves, in both schedules."""

from __future__ import annotations

import numpy as np

from engine.laws.base import Array
from workbook.chart import Chart, Series
from workbook.declare import Book, Sheet, calc, constant, given, result
from workbook.machines.overlap_model import TURN, Overlapping
from workbook.reference import MM
from workbook.sheets import sampling
from workbook.sheets.overlap.cycle import ALLOWED, LANE_SHARE, ToolState, allowed, transfer_columns

WIDTH, BODY, PLATE = 0.3, 1.5, 0.2  # of the picture: tool in transfer strokes, its length and the plate in tool strokes
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
FRAME = ((-1, 0), (1, 0), (1, 1), (-1, 1), (-1, 0))


def picture_sheet(book: Book, machine: Overlapping, pieces: sampling.Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet(
        "Picture", "Both parts at one angle of the master shaft: change the angle and both pictures move."
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
    theta = np.array([machine.given.view])
    before, after = (ToolState(machine, plan, theta, pieces) for plan in (machine.before, machine.as_set))
    state(sheet, machine, (before, after), pieces)
    pictures(sheet)
    sheet.heading("Workings")
    h = machine.given.tool.stroke
    sheet.rows(
        constant("picture_width", "Width of the tool", "", "", WIDTH, format="0.0##", source="as a share of the transfer's stroke"),
        constant("picture_body", "Length of the tool", "", "", BODY, format="0.0##", source="as a share of its stroke"),
        constant("picture_plate", "Thickness of the plate below the part", "", "", PLATE, format="0.0##", source="as a share of the tool's stroke"),
        calc("picture_open", "Width of an opening of the transfer", "", "mm", "=overlap_pitch*(picture_width+2*overlap_remaining/100)", machine.given.transfer.stroke * (WIDTH + 2 * machine.passage.remaining), source="the tool, and r of the stroke on both sides"),
        calc("picture_top", "Height of the transfer above the part", "", "mm", "=MAX(overlap_stroke-overlap_clearance,0)", max(h - machine.given.passage.clearance, 0.0), source="h − c", scale=1.0),
    )  # fmt: skip
    sheet.row += 1
    state_workings(sheet, machine, (before, after), pieces)
    outlines(sheet, machine, theta, before.y, after.y)
    sheet.print_columns = 16


def state(sheet: Sheet, machine: Overlapping, states: tuple[ToolState, ToolState], pieces: sampling.Pieces) -> None:
    """Declare what stands where at this angle."""
    before, after = (s.y[0] for s in states)
    theta = np.array([machine.given.view])
    moved = transfer_columns(machine, theta, pieces)[0].value[0]
    limit = allowed(machine, theta)[0]
    sheet.heading("What comes out")
    sheet.rows(
        result("view_t", "Travel of the transfer", "y_t", "mm", "=[view.yt]", moved, scale=1.0),
        result("view_b", "Travel of the tool, one after the other", "y", "mm", "=[view.yb]", before, scale=1.0),
        result("view_a", "Travel of the tool, with overlap", "y", "mm", "=[view.ya]", after, scale=1.0),
        result("view_limit", "Travel allowed to the tool", "", "mm", ALLOWED.replace("[theta]", "overlap_view"), limit, scale=1.0, source="to the transfer while it is in the way, else to the part"),
        result("view_free", "Free, with overlap", "", "mm", "=view_limit-view_a", limit - after, scale=1.0, source="below 0 the parts collide"),
        result("view_says", "At this angle, the transfer is", "", "", '=IF(view_free<0-check_zero*overlap_stroke,"COLLISION",IF(view_limit<overlap_stroke,"in the way","in place"))', says(machine, limit, after)),
    )  # fmt: skip


def says(machine: Overlapping, limit: float, y: float) -> str:
    """Return in words how the parts stand."""
    h = machine.given.tool.stroke
    if limit - y < -1e-9 * h:
        return "COLLISION"
    return "in the way" if limit < h else "in place"


def state_workings(
    sheet: Sheet, machine: Overlapping, states: tuple[ToolState, ToolState], pieces: sampling.Pieces
) -> None:
    """Declare the row that evaluates the laws at this angle, and the line that marks it in the diagrams."""
    theta = np.array([machine.given.view])
    before, after = states
    sheet.table(
        "view", "The laws at this angle", 1,
        calc("theta", "master angle", "θ", "°", "=overlap_view", theta, scale=TURN),
        *transfer_columns(machine, theta, pieces),
        *before.columns("b", 1),
        *after.columns("a", 3),
    )  # fmt: skip
    sheet.table(
        "view_line", "The line in both timing diagrams", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("theta", "master angle", "θ", "°", "=overlap_view", [machine.given.view] * 2, scale=TURN),
        calc("height", "height", "", "", "=[end]*(1+overlap_lane)", [0.0, 1 + LANE_SHARE]),
    )  # fmt: skip


def outlines(sheet: Sheet, machine: Overlapping, theta: Array, before: Array, after: Array) -> None:
    """Declare the outlines of the parts: across, the transfer's way; upwards, the height of the tool."""
    g, h = machine.given, machine.given.tool.stroke
    pitch, low, body = g.transfer.stroke, -PLATE * h, BODY * h
    opening = pitch * (WIDTH + 2 * machine.passage.remaining)
    top = max(h - g.passage.clearance, 0.0)
    moved = machine.transfer.stroke * machine.transfer.law.s(np.minimum(theta / g.transfer.angle, 1.0))[0] / MM
    wall, side, up = np.array(WALLS, dtype=float).T
    x = np.clip(moved + pitch * (wall + side) + opening * (0.5 - side), -pitch, pitch)
    sheet.table(
        "outline", "Outline of the transfer", len(WALLS),
        constant("wall", "wall", "", "", [int(w) for w in wall]),
        constant("side", "right side", "", "", [int(s) for s in side]),
        constant("up", "upper side", "", "", [int(s) for s in up]),
        calc("x", "across", "x", "mm", "=MAX(0-overlap_pitch,MIN(overlap_pitch,[view.yt]+overlap_pitch*([wall]+[side])+picture_open*(1/2-[side])))", x, scale=1.0),
        calc("y", "height", "z", "mm", "=IF([up]=1,picture_top,0-picture_plate*overlap_stroke)", np.where(up == 1, top, low), scale=1.0),
    )  # fmt: skip
    px, py = np.array(PUNCH).T
    sheet.table(
        "punch", "Outline of the tool", len(PUNCH),
        constant("px", "across", "", "", list(map(float, px))),
        constant("py", "along", "", "", list(map(float, py))),
        calc("x", "across", "x", "mm", "=[px]*picture_width*overlap_pitch", px * WIDTH * pitch, scale=1.0),
        calc("yb", "one after the other", "z", "mm", "=overlap_stroke-[view.yb]+[py]*picture_body*overlap_stroke", h - before[0] + py * body, scale=1.0),
        calc("ya", "with overlap", "z", "mm", "=overlap_stroke-[view.ya]+[py]*picture_body*overlap_stroke", h - after[0] + py * body, scale=1.0),
    )  # fmt: skip
    fx, fy = np.array(FRAME, dtype=float).T
    sheet.table(
        "frame", "Frame of the picture: keeps its scale", len(FRAME),
        constant("fx", "across", "", "", [int(v) for v in fx]),
        constant("fy", "upwards", "", "", [int(v) for v in fy]),
        calc("x", "across", "x", "mm", "=[fx]*overlap_pitch", fx * pitch),
        calc("y", "height", "z", "mm", "=IF([fy]=1,(1+picture_body)*overlap_stroke,0-picture_plate*overlap_stroke)", np.where(fy == 1, h + body, low), scale=1.0),
    )  # fmt: skip


def pictures(sheet: Sheet) -> None:
    """Place the two pictures side by side."""
    sheet.row += 1
    sheet.chart_row(
        *(Chart(title, "across [mm]", "height of the tool above the part [mm]", (
            Series("transfer", "[outline.x]", "[outline.y]"),
            Series("tool", "[punch.x]", f"[punch.{column}]"),
            Series("frame", "[frame.x]", "[frame.y]", color="BFBFBF")),
            f"Outlines of transfer and tool at the angle entered: {title.lower()}")
          for title, column in (("One after the other", "yb"), ("With overlap", "ya"))),
        width=8, height=24,
    )  # fmt: skip
