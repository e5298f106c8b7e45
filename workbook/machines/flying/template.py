"""Flying machining (S5): a rotary drum or a flying saw that follows the line while it works."""

from math import pi, radians
from typing import Any

import numpy as np

from engine.flying.pieces import cut_joints, cut_parts, cut_pieces, rates_of
from engine.motion.profile import profile_of
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Book, Sheet
from workbook.book.public_names import names_in, names_sheet, place_names
from workbook.book.summary import summary_sheet
from workbook.entries.facts import vary
from workbook.entries.rules import limits
from workbook.fields.units import DEGREE, MM, PER_MINUTE, RPM, shown
from workbook.law_sheets import library
from workbook.law_sheets.book_laws import BookLaws
from workbook.laws.sampling import Pieces
from workbook.machines.flying.drive import drive_sheet
from workbook.machines.flying.entries import DRUM, CutterEntry, FlyingCutter
from workbook.machines.flying.lengths import lengths_sheet
from workbook.machines.flying.ratios import RatiosSheet
from workbook.machines.flying.sheet import cutter_sheet
from workbook.machines.flying.view import CutterView, ToolDrive, check
from workbook.motion import pieces
from workbook.motion.cells import Cells, PieceRows, last_before, rows_of_parts
from workbook.motion.exported import Exportable, export_sheet
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints
from workbook.selection.entries import Limits
from workbook.selection.page import catalogue_sheet, selection_sheet
from workbook.selection.variations import vary_selection
from workbook.template import Template, finish
from workbook.template_outputs import CamAxis, ExactJudgement, deviations, judged_limits

CELLS = cell_tables(__file__)


def declare(given: FlyingCutter) -> Book:
    """Declare the book."""
    cell = CELLS["declare"]
    book_laws = BookLaws(given.laws, given.sizes)
    view = CutterView(given, book_laws.laws)
    book = Book(given.template, given.title, limit=limits(type(given)), print_also=given.print_also)
    cut, book.sizes = view.cut, view.scales
    fastest, beta = shown(cut.max_angular_speed, RPM), view.task(cut).load_factor
    about = (
        "A tool that follows the line while it works: the motion of its drum or slide, and what its drive must give."
    )
    summary_sheet(
        book,
        given,
        about,
        [
            cell("about_rate", shown(cut.rate, PER_MINUTE)),
            cell("about_line", view.fastest_line),
            cell("about_n", fastest),
            cell("about_dw", cut.max_angular_acceleration),
            cell("about_beta", beta),
        ],
    )
    rows = rows_of(view, book_laws.stack)
    drive = ToolDrive(view, given.selection, given.limits, given.sizes)
    cutter_sheet(book, view, joints_of(view, rows), drive.stroke, book_laws.named)
    lengths_sheet(book, view)
    cycle_sheet(book, view, rows, book_laws.stack)
    drive_sheet(book, drive, rows)
    selection_sheet(book, drive.choosing(), limits=given.limits)
    RatiosSheet(drive).declare(book)
    catalogue_sheet(book, given.selection, given.sizes)
    book_laws.sheets(book)
    shaft = shown(cut.tool.angle(1.0), DEGREE)
    export_sheet(
        book,
        given,
        [
            Exportable(name, f'="{name}"', rows, ("s", y, f"{y}/s", f"{y}/s²"), (1.0, unit), times, cut.size)
            for name, y, unit, times in (
                ("tool", "mm", shown(1.0, MM), "*1000"),
                ("shaft", "°", shaft, "*1000/fly_r*180/PI()"),
            )
        ],
    )
    place_names(names_sheet(book), names_in(__file__)["Results"], "machine")
    return finish(book, ("S5", "S1", "S3"))


def axes(machine: FlyingCutter) -> list[CamAxis]:
    """Return the tool along its path, and the shaft that drives it; both go on from where a cycle ends."""
    cut = CutterView(machine, library.laws(machine.laws)).cut
    profile = profile_of(cut_pieces(cut, whole=True), cut.cycle_time)
    shaft = shown(cut.tool.angle(1.0), DEGREE)
    return [
        CamAxis("tool", profile.in_units(1.0, shown(1.0, MM)), "s", "mm"),
        CamAxis("shaft", profile.in_units(1.0, shaft), "s", "°"),
    ]


def judgement(given: FlyingCutter) -> ExactJudgement:
    """Return the limits of the drive as its sheet and the exact engine have them, and lines on its results."""
    view = CutterView(given, BookLaws(given.laws, given.sizes).laws)
    drive = ToolDrive(view, given.selection, given.limits, given.sizes)
    judged = judged_limits("Drive", "drive_", drive.limit_checks, drive.exact)
    return ExactJudgement(judged, [*deviations("Drive", drive.results, drive.exact)])


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn."""
    k = turn % library.SIX
    entries = data["cutter"]
    library.vary_laws(data["laws"], k, library.factors(k), data["sizes"]["pieces"])
    law = library.pick_in_turn(turn + 4, library.single_humped(data["laws"]))
    if law in library.own_in(data["laws"]):
        data["laws"][law]["pieces"] = library.RISING
    vary(entries, CutterEntry, k)
    drum, saw = entries["drum"], entries["saw"]
    if entries["kind"] == DRUM:
        whole = 2 * pi * drum["radius"] / drum["tools"]
        least = radians(drum["tool_angle"]) * drum["radius"]
    else:
        whole, least = 3.0 * saw["tool_length"], saw["tool_length"]
    # shorter, far too long, as long as designed, longer
    share, span = (0.7, 9.0, 1.0, 1.0, 8.0, 1.7)[k], whole - least
    entries |= {
        "product_length": least + share * span if share != 1.0 else whole,
        "lengths": {"shortest": least + 0.3 * span, "longest": least + (4.0 + 2 * k) * span},
        "law": law,
    }
    vary_selection(data["selection"], k, data["sizes"])
    vary(data["limits"], Limits, k)
    return data


VARIED = library.varying(FlyingCutter, varied, library.single_humped)
TEMPLATE = Template("flying-cutter", FlyingCutter, declare, VARIED, check, axes=axes, judgement=judgement)


AT = Cells("stretches", "tool_pieces", "fly_pieces", "fly_tc", "m", "s", drifts=True, opens=True)
SPLIT = "IF(fly_waits=1,fly_peak,1)"
PARTS = formulas_by_row(__file__, "parts of the cycle")
WHERE = "The parts of the cycle: beside the law the tool moves at line speed, which stands in the column drift."


def rows_of(machine: CutterView, stack: Pieces) -> PieceRows:
    """Return the pieces of the tool's motion."""
    cut, parts = machine.cut, cut_parts(machine.cut)
    begun = [part.first for part in parts]
    return rows_of_parts(AT, [part.scaled for part in parts], cut_pieces(cut), stack, cut.cycle_time, begun)


def joints_of(machine: CutterView, rows: PieceRows) -> Joints:
    """Return the joints of the tool's pieces, and how smooth it must be."""
    smooth, largest = machine.given.smoothness, ("MAX(ABS(fly_low),ABS(fly_high))", "fly_a")
    quickest = f"[{AT.phases}.rate.1]"
    required = RequiredSmoothness(
        smooth, "fly_smooth", "fly_order", largest, " s", names=tuple(PARTS["what"]), quickest=quickest
    )
    return Joints(rows, required, cut_joints(machine.cut, smooth), rates_of(machine.cut))


def cycle_sheet(book: Book, machine: CutterView, rows: PieceRows, stack: Pieces) -> None:
    """Declare the sheet."""
    cell = CELLS["cycle"]
    sheet = book.sheet("Cycle", "The tool over one cycle: it re-positions first, then works at line speed.")
    sheet.unprinted = True
    cut, t = machine.cut, machine.times
    at, load = cut.at(t), machine.load
    radius = machine.tool.radius
    speed, acceleration = at.speed / radius, at.acceleration / radius
    sheet.row += 1
    cell.sharing(steps=len(t) - 1).place(
        sheet,
        cell("t", t),
        cell("s", shown(at.position, MM), sampled=pieces.at_sample(rows, 0), source=pieces.POSITION),
        cell("v", at.speed, sampled=pieces.at_sample(rows, 1)),
        cell("a", at.acceleration, sampled=pieces.at_sample(rows, 2)),
        cell("j", at.jerk, sampled=pieces.at_sample(rows, 3)),
        cell("n", shown(speed, RPM)),
        cell("w", speed),
        cell("dw", acceleration),
        cell("torque", load.torque + load.inertia * acceleration),
        cell("angle", shown(at.position / radius, DEGREE)),
        cell("product", shown(cut.line_speed * t, MM)),
        cell("line", machine.line),
        cell("k", list(range(len(t)))),
        *pieces.workings_at(rows, "t", t),
    )
    motion_tables(sheet, machine, rows, stack)


def motion_tables(sheet: Sheet, machine: CutterView, rows: PieceRows, stack: Pieces) -> None:
    """Declare the parts of the cycle, and the pieces of the tool's motion."""
    sheet.heading("Workings: the tool's motion as pieces", pieces.ABOUT)
    sheet.note(WHERE)
    at, law = np.array([machine.cut.fastest]), machine.law
    position, velocity = stack.columns({"s": law.s(at), "v": law.v(at)}, "sv")
    CELLS["standing"].place(
        sheet,
        CELLS["standing"]("xi", at),
        *stack.finding("fly_no", machine.number, "xi", at),
        position,
        velocity._replace(symbol="s'"),  # v is the tool's, in m/s
    )
    parts = cut_parts(machine.cut)
    of = [part.scaled for part in parts]
    figures = {
        "h": [part.h for part in of],
        "span": [part.duration for part in of],
        "begin": [part.x for part in of],
        "opens": [part.begin for part in parts],
        "drift": [part.drift for part in of],
        "y0": [part.y for part in of],
    }
    cell = CELLS["motion_tables"]
    first, none = "=MATCH(fly_no,piece_number,0)", "=MATCH(1,piece_number,0)"
    cell.place(
        sheet,
        cell("what", PARTS["what"]),
        cell("k", [1, 2, 3, 4]),
        *(cell(name, values, formula=PARTS[name]) for name, values in figures.items()),
        *pieces.phase_table_columns(
            rows,
            [first, none, f"={last_before('fly_no', f'MIN({SPLIT}+2*break_eps,1)')}", none],
            [
                f"={last_before('fly_no', SPLIT)}-[first]+1",
                "=fly_waits",
                f"=IF(fly_waits=1,{last_before('fly_no', '1')}-[first]+1,0)",
                "=IF([span]>0,1,0)",
            ],
        ),
    )
    joints = joints_of(machine, rows)
    sheet.rows(pieces.pieces_in_all(rows), *joints.order())
    sheet.row += 1
    pieces.pieces_table(sheet, "Pieces of the tool's motion", rows, machine.room, machine.cut.size)
    sheet.row += 1
    joints.table(sheet, "What jumps where each piece begins", machine.room)
