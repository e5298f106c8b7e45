"""The Cycle sheet: both parts over the master angle, one after the other and with overlap."""

from __future__ import annotations

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array
from engine.overlap import Schedule
from workbook.chart import Chart, Series
from workbook.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.machines.overlap_model import TURN, Overlapping
from workbook.reference import MM
from workbook.sheets import sampling
from workbook.sheets.stack import CODES

EPS = TURN * BREAK_TOLERANCE
LANE_SHARE = 0.8
PART = (
    "=1+IF([since{0}]+overlap_eps>=overlap_dwell,1,0)+IF([since{0}]+overlap_eps>=overlap_dwell+[schedules.out.{1}],1,0)"
    "+IF([since{0}]+overlap_eps>=360-[schedules.in.{1}],1,0)"
)
ABSCISSA = (
    "=CHOOSE([part{0}],0,MAX(0,([since{0}]-overlap_dwell)/[schedules.out.{1}]),0,"
    "MAX(0,([since{0}]-360+[schedules.in.{1}])/[schedules.in.{1}]))"
)


def turned(theta: Array) -> Array:
    """Return angles in degrees within one turn; what is just below a whole turn counts as on it."""
    return theta - TURN * np.floor(theta / TURN + BREAK_TOLERANCE)


class ToolState:
    """The tool of one schedule at angles of the master shaft: from its arrival dwell, way out, rest, way in."""

    def __init__(self, machine: Overlapping, plan: Schedule, theta: Array, pieces: sampling.Pieces) -> None:
        """Take angles in degrees."""
        self.machine, self.plan, self.pieces = machine, plan, pieces
        arrival, way_in, way_out = np.degrees([plan.arrival, plan.way_in, plan.way_out])
        leave = machine.given.tool.dwell
        self.x = turned(theta - arrival)
        starts = (leave, leave + way_out, TURN - way_in)
        self.part = 1 + sum((self.x + EPS >= s).astype(int) for s in starts)
        out, into = (self.x - leave) / way_out, (self.x - TURN + way_in) / way_in
        self.xi = np.clip(np.select([self.part == 2, self.part == 4], [out, into], 0.0), 0.0, 1.0)
        self.y = plan.positions(np.deg2rad(theta)).tool / MM

    def columns(self, suffix: str, row: int) -> list[Quantity]:
        """Return the workings and the travel; ``row`` is the schedule's in the table of the tool's angles."""
        codes = np.array(["DWL", self.machine.given.tool.law_out, "DWL", self.machine.given.tool.law_in])
        numbers = np.array([CODES.index(code) + 1 for code in codes])[self.part - 1]
        found = np.empty((3, len(self.x)))
        values = {d: np.empty(len(self.x)) for d in "sa"}
        for number in np.unique(numbers):
            here = numbers == number
            found[:, here] = self.pieces.locate(int(number), self.xi[here])
            at = self.machine.library[CODES[number - 1]].evaluate(self.xi[here])
            values["s"][here], values["a"][here] = at.s, at.a
        q, u, x = found
        return [
            calc(f"y{suffix}", "travel of the tool", "y", "mm", f"=overlap_stroke*CHOOSE([part{suffix}],1,1-[s{suffix}],0,[s{suffix}])", self.y, scale=1.0, source="h s in, h (1 − s) out"),
            calc(f"since{suffix}", "angle since its arrival", "", "°", f"=[theta]-[schedules.there.{row}]-360*INT(([theta]-[schedules.there.{row}])/360+break_tolerance)", self.x, scale=TURN),
            calc(f"part{suffix}", "phase", "", "", PART.format(suffix, row), self.part, format="0", source="1 dwell, 2 out, 3 rest, 4 in"),
            calc(f"xi{suffix}", "abscissa", "ξ", "", ABSCISSA.format(suffix, row), self.xi, scale=1.0),
            calc(f"n{suffix}", "law number", "", "", f"=CHOOSE([part{suffix}],1,[used.no.3],1,[used.no.2])", numbers, format="0"),
            *sampling.finding(f"[n{suffix}]", f"xi{suffix}", (q, u, x), suffix),
            *sampling.columns(values, "sa", suffix),
        ]  # fmt: skip

    def acceleration(self, suffix: str, row: int, label: str) -> Quantity:
        """Return the column of the acceleration in m/s², from the engine's motion of the tool."""
        motion = self.plan.diagram.axis("tool").motion
        snapped = np.minimum(np.deg2rad(np.maximum(self.x, 0.0)), 2 * np.pi)
        value = motion.at(snapped).y2 * self.machine.omega**2
        formula = (
            f"=CHOOSE([part{suffix}],0,0-[a{suffix}]/[schedules.t_out.{row}]^2,0,[a{suffix}]/[schedules.t_in.{row}]^2)"
            "*overlap_stroke/1000"
        )
        return result(f"acc{suffix}", label, "a", "m/s²", formula, value, scale=1e-3, source="± h a/t_m²")


def transfer_columns(machine: Overlapping, theta: Array, pieces: sampling.Pieces) -> list[Quantity]:
    """Return the travel of the transfer and its workings."""
    law, number = machine.transfer.law, CODES.index(machine.given.transfer.law) + 1
    xi = np.minimum(theta / machine.given.transfer.angle, 1.0)
    s = law.s(xi)
    return [
        result("yt", "travel of the transfer", "y_t", "mm", "=overlap_pitch*[st]", machine.transfer.stroke * s / MM, scale=1.0, source="h_t s"),
        calc("xit", "its abscissa", "ξ", "", "=MIN([theta]/overlap_angle,1)", xi, scale=1.0),
        *sampling.finding("[used.no.1]", "xit", pieces.locate(number, xi), "t"),
        *sampling.columns({"s": s}, "s", "t"),
    ]  # fmt: skip


def allowed(machine: Overlapping, theta: Array) -> Array:
    """Return in mm how far the tool may go: to the transfer while that is in the way, else to the part."""
    begin, end = machine.blocked
    away = (theta > begin + EPS) & (theta < end - EPS)
    return np.where(away, machine.given.passage.clearance, machine.given.tool.stroke)


ALLOWED = "=IF(AND([theta]>overlap_begin+overlap_eps,[theta]<overlap_end-overlap_eps),overlap_clearance,overlap_stroke)"


def cycle_sheet(book: Book, machine: Overlapping, pieces: sampling.Pieces) -> None:
    """Declare the sheet: travel, acceleration and clearance over one turn of the master shaft."""
    sheet = book.sheet("Cycle", "Both parts over one turn of the master shaft, one after the other and with overlap.")
    theta = machine.angles
    before, after = (ToolState(machine, plan, theta, pieces) for plan in (machine.before, machine.as_set))
    first, *work_b = before.columns("b", 1)
    second, *work_a = after.columns("a", 3)
    moved, *work_t = transfer_columns(machine, theta, pieces)
    limit, h = allowed(machine, theta), machine.given.tool.stroke
    sheet.rows(
        constant(
            "overlap_lane",
            "Height of a part in the diagrams",
            "",
            "",
            LANE_SHARE,
            format="0.0",
            source="as a share of its lane",
        )
    )
    sheet.row += 1
    lane_t = LANE_SHARE * machine.transfer.law.s(np.minimum(theta / machine.given.transfer.angle, 1.0))
    sheet.table(
        "motions", "Travel, acceleration and clearance over the master angle", len(theta),
        calc("theta", "master angle", "θ", "°", "=[k]*360/[motions.k.last]", theta, format="0.0##"),
        moved, first, second,
        result("limit", "travel allowed to the tool", "", "mm", ALLOWED, limit, scale=1.0, source="c while the transfer is in the way, else h"),
        result("free", "free with overlap", "", "mm", "=[limit]-[ya]", limit - after.y, scale=1.0, source="below 0: collision"),
        before.acceleration("b", 1, "acceleration, one after the other"),
        after.acceleration("a", 3, "acceleration, with overlap"),
        calc("lane_t", "transfer in the diagrams", "", "", "=[yt]/overlap_pitch*overlap_lane", lane_t, scale=1.0),
        calc("lane_b", "tool, one after the other", "", "", "=1+[yb]/overlap_stroke*overlap_lane", 1 + LANE_SHARE * before.y / h),
        calc("lane_a", "tool, with overlap", "", "", "=1+[ya]/overlap_stroke*overlap_lane", 1 + LANE_SHARE * after.y / h),
        constant("k", "sample", "k", "", list(range(len(theta)))),
        *work_t, *work_b, *work_a,
    )  # fmt: skip


def diagrams(sheet: Sheet, machine: Overlapping) -> None:
    """Place both timing diagrams side by side, the travel under its limit, the accelerations."""
    names = f"{machine.given.transfer.name} · {machine.given.tool.name} (bottom to top)"
    for column, title, lane in ((11, "One after the other", "lane_b"), (18, "With overlap", "lane_a")):
        sheet.chart(
            Chart(
                f"Timing diagram: {title[0].lower()}{title[1:]}", "master angle θ [°]", names,
                (Series("transfer", "[motions.theta]", "[motions.lane_t]"), Series("tool", "[motions.theta]", f"[motions.{lane}]"),
                 Series("angle of the picture", "[view_line.theta]", "[view_line.height]", dashed=True, color="7F7F7F")),
                f"Timing diagram of transfer and tool over one turn of the master shaft: {title.lower()}",
                (0, 360, 30), (0, 2, 1), hide_y=True,
            ),
            column=column, row=5, width=7, height=18,
        )  # fmt: skip
    sheet.chart(
        Chart(
            "Travel of the tool, and what the transfer allows", "master angle θ [°]", "travel y [mm]",
            (Series("one after the other", "[motions.theta]", "[motions.yb]"), Series("with overlap", "[motions.theta]", "[motions.ya]"),
             Series("allowed", "[motions.theta]", "[motions.limit]", dashed=True)),
            "Travel of the tool in both schedules, below the travel that the transfer allows it", (0, 360, 30),
        ),
        column=11, row=24, width=7, height=18,
    )  # fmt: skip
    sheet.chart(
        Chart(
            "Acceleration of the tool", "master angle θ [°]", "acceleration [m/s²]",
            (Series("one after the other", "[motions.theta]", "[motions.accb]"), Series("with overlap", "[motions.theta]", "[motions.acca]")),
            "Acceleration of the tool over the cycle, one after the other and with overlap", (0, 360, 30),
        ),
        column=18, row=24, width=7, height=18,
    )  # fmt: skip
