"""The Cutter sheet: what to enter, lengths and times, what the tool's shaft must do, charts and workings."""

from collections.abc import Mapping, Sequence
from itertools import chain

from engine.flying.cut import LONGER, SAME_LENGTH
from engine.laws import Dwell
from engine.laws.points import fastest
from workbook.book.cell_tables import cell_tables, charts_beside
from workbook.book.declare import FIRST, Book, Quantity, Sheet
from workbook.book.sentence import amount
from workbook.entries.facts import entry_cells
from workbook.fields.units import DEGREE, MM, PER_MINUTE, RPM, shown
from workbook.law_sheets.library import NamedLaw
from workbook.machines.flying.entries import DRUM, SAW
from workbook.machines.flying.lengths import IS_DRUM, cases, waits
from workbook.machines.flying.view import LEAST_CV, CutterView, does
from workbook.motion.pieces import ROOM
from workbook.motion.smooth import Joints

CELLS = cell_tables(__file__)
CHARTS = charts_beside(__file__)
OF_MOTION = ("Speed of the tool", "Position of the tool", "Acceleration of the tool")
OF_LOAD = ("Torque at the shaft", "Torque against speed", "Load factor")
"""the charts of the tool's motion and of its shaft's load"""

OF_KIND = {DRUM: ("fly_tools", "fly_radius", "fly_angle", "fly_beyond"), SAW: ("fly_saw", "fly_lead", "fly_room")}
JUDGED = {DRUM: ("fly_ok_tools", "fly_ok_angle"), SAW: ("fly_ok_stroke",)}
"""by kind of machine its own entries and checks; those of the other kind stand below what is printed"""
WAITS = waits("fly_length", "fly_beyond")
# the row from which the sheet is free in its whole width; that of the entries of the other kind
BELOW_CHARTS, BELOW_PRINT = 60, 70


def cutter_sheet(book: Book, machine: CutterView, joints: Joints, stroke: float, laws: Sequence[NamedLaw]) -> None:
    """Declare the sheet; ``stroke`` (m) is the tool's by the points of its drive."""
    cell = CELLS["fastest"]
    peaks = [0.0 if isinstance(law.law, Dwell) else fastest(law.law) for law in laws]
    sheet = book.sheet("Cutter", "The tool works at line speed, and makes up for the product's length in between.")
    sheet.heading("Enter", "Product and line, the kind of machine with its own entries, load and limits of its shaft.")
    place_by_kind(sheet, machine, OF_KIND, [*entry_cells(machine.given, "cutter", ["lengths"])], BELOW_PRINT)
    sheet.heading("Results")
    cycle(sheet, machine)
    kinematics(sheet, machine, stroke)
    sheet.row += 1
    place_by_kind(sheet, machine, JUDGED, verdicts(machine, joints, stroke), BELOW_PRINT + 10)
    charts(sheet)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    sheet.not_printed_below()
    sheet.row = BELOW_PRINT + 14
    cases(sheet, machine)
    sheet.heading("Workings")
    sheet.rows(*geometry(machine), *superimposed_rows(machine))
    sheet.row += 1
    cell.place(
        sheet,
        cell("law", [law.name for law in laws], number=[law.number for law in laws]),
        cell("at", peaks, fastest=[law.own(law.page.fastest) for law in laws]),
    )
    sheet.print_columns, sheet.widths = 16, {FIRST: 37}


def place_by_kind(
    sheet: Sheet, machine: CutterView, of_kind: Mapping[str, Sequence[str]], rows: Sequence[Quantity], below: int
) -> None:
    """Place entries or checks of any kind of machine, then of each; of another than this from a row ``below`` on.

    Their order is the same for any kind, as the stamp sums entries up, and Checks lists checks.
    """
    own, place = {*chain(*of_kind.values())}, sheet.checks if rows[0].role == "check" else sheet.rows
    place(*(q for q in rows if q.name not in own))
    for kind, names in of_kind.items():
        here, is_other = sheet.row, kind != machine.given.kind
        if is_other:
            sheet.row = below
            sheet.heading(f"Where the kind of machine is {kind}")
        place(*(q for q in rows if q.name in names))
        sheet.row = here if is_other else sheet.row


def cycle(sheet: Sheet, machine: CutterView) -> None:
    """Declare the case and the cycle's times and lengths."""
    cell = CELLS["cycle"]
    cut, tool = machine.cut, machine.tool
    sheet.rows(
        cell("fly_rate", shown(cut.rate, PER_MINUTE)),
        cell("fly_case", ("faster", "in step", "slower", "slower")[machine.case - 1]),
        cell("fly_does", does(cut), waits=WAITS),
        cell("fly_h", shown(cut.displacement, MM)),
        cell("fly_l0", shown(tool.design_length, MM)),
        cell("fly_limit", machine.limit, is_drum=IS_DRUM),
        cell("fly_tc", cut.cycle_time),
        cell("fly_tt", cut.tool_time),
        cell("fly_tr", cut.repositioning_time),
        cell("fly_wait", cut.waiting_time),
    )


def kinematics(sheet: Sheet, machine: CutterView, stroke: float) -> None:
    """Declare speeds, accelerations and travel, and what the motor and its reducer are chosen by."""
    cell = CELLS["kinematics"]
    cut, (low, high), task = machine.cut, machine.cut.speed_range, machine.task(machine.cut)
    slowest, fastest = (shown(v / machine.tool.radius, RPM) for v in cut.speed_range)
    per = "*1000/fly_r"
    sheet.rows(
        cell("fly_dv", cut.speed_change),
        cell("fly_domega", cut.speed_change / machine.tool.radius, per=per),
        cell("fly_low", low),
        cell("fly_high", high),
        cell("fly_rpm_low", slowest, per=per),
        cell("fly_rpm_high", fastest, per=per),
        cell("fly_a", cut.max_acceleration),
        cell("fly_dw", cut.max_angular_acceleration, per=per),
        cell("fly_a_rms", cut.rms_acceleration),
        cell("fly_dw_rms", cut.rms_angular_acceleration, per=per),
        cell("fly_stroke", shown(stroke, MM)),
        cell("fly_line_max", machine.fastest_line),
        cell("fly_w_max", cut.max_angular_speed),
        cell("fly_n", shown(cut.max_angular_speed, RPM)),
        cell("fly_torque_rms", task.torque_rms),
        cell("fly_mean", task.power_rate_mean),
        cell("fly_beta", task.load_factor),
    )


def verdicts(machine: CutterView, joints: Joints, by_points: float) -> list[Quantity]:
    """Return the checks."""
    cut, limits = machine.cut, machine.given.limits
    fastest, hardest = shown(cut.max_angular_speed, RPM), cut.max_angular_acceleration
    stroke = 0.0 if machine.is_drum else shown(by_points, MM)
    near = "*(1+check_zero)"
    law = (
        "AND(INDEX(law_wrong,fly_no)<check_zero,INDEX(law_v_low,fly_no)>=0-check_zero,"
        "MAX(fly_ends,fly_misses)<check_zero,fly_cv>=fly_least_cv)"
    )
    room = machine.given.saw.stroke
    too_fast = amount("fly_n-fly_rpm_max", fastest - limits.speed, "", " rpm too much")
    too_hard = amount("fly_dw-fly_dw_max", hardest - limits.acceleration, "", " rad/s² too much")
    too_far = amount("fly_stroke-fly_room", stroke - room, "", " mm too much")
    cell = CELLS["verdicts"].sharing(near=near, is_drum=IS_DRUM)
    return [
        cell("fly_ok_speed", fastest <= limits.speed, says=too_fast),
        cell("fly_ok_acceleration", hardest <= limits.acceleration, says=too_hard),
        cell("fly_ok_stroke", machine.is_drum or stroke <= room, says=too_far),
        joints.check("fly_ok_smooth", "The tool moves as smoothly as asked"),
        cell("fly_ok_length", True),
        cell("fly_ok_tools", True),
        cell("fly_ok_load", True),
        cell("fly_ok_range", True),
        cell("fly_ok_pieces", True, room=ROOM),
        cell("fly_ok_angle", True),
        cell("fly_ok_law", True, law=law),
    ]


def geometry(machine: CutterView) -> list[Quantity]:
    """Return angles and lengths in step with the line and of the re-positioning, and what the law is by figures."""
    cell = CELLS["geometry"]
    tool, law = machine.tool, machine.law.coefficients
    lengths = (tool.design_length, tool.tool_length, tool.repositioning_length)
    pitch, sync, back = (shown(tool.angle(length), DEGREE) for length in lengths)
    return [
        cell("fly_v", machine.line),
        cell("fly_r", shown(tool.radius, MM), is_drum=IS_DRUM),
        cell("fly_pitch", pitch, is_drum=IS_DRUM),
        cell("fly_sync", sync, is_drum=IS_DRUM),
        cell("fly_back", back),
        cell("fly_lt", shown(tool.tool_length, MM)),
        cell("fly_lr", shown(tool.repositioning_length, MM)),
        cell("fly_j", machine.load.inertia),
        cell("fly_no", machine.number),
        cell("fly_ends", max(abs(machine.law.start.v), abs(machine.law.end.v)), scale=1.0),
        cell("fly_misses", abs(machine.law.end.s - 1.0), scale=1.0),
        cell("fly_cv", law.cv),
        cell("fly_ca", law.ca),
        cell("fly_ca_rms", law.ca_rms),
    ]


def superimposed_rows(machine: CutterView) -> list[Quantity]:
    """Return the motion on top of the line's: its case, time and displacement, and where the drum waits."""
    cell = CELLS["superimposed"]
    cut = machine.cut
    return [
        cell("fly_row", machine.case),
        cell("fly_waits", float(cut.waits), waits=WAITS),
        cell("fly_tm", cut.moving_time),
        cell("fly_h1", shown(cut.superimposed, MM)),
        cell("fly_peak", cut.fastest),
        cell("fly_stop", cut.wait[0]),
        cell("fly_near", SAME_LENGTH),
        cell("fly_longer", LONGER),
        cell("fly_least_cv", LEAST_CV),
    ]


def charts(sheet: Sheet) -> None:
    """Place the tool's motion, and right of it the load of its shaft, beside what is entered and what comes out."""
    for column, width, titles in ((10, 4, OF_MOTION), (14, 3, OF_LOAD)):
        for row, title in zip((5, 24, 43), titles, strict=True):
            sheet.chart(CHARTS[title], column, row, width, height=18)
