"""Reversals of a drive inside a piece of its motion, in cells: friction and losses change sides there."""

import numpy as np

from engine.drive.turning import PARTS
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import LEAST, NOT_ZERO, filled
from workbook.book.sentence import CheckSentence, sentence_formula
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown
from workbook.machines.machine.boundary.curves import BENT_FROM, bends_name
from workbook.machines.machine.drive.view import DriveView
from workbook.motion.pieces import FROM_START, arguments, at_place, sine_arguments

CELLS = cell_tables(__file__)

FULL = "turns round {} times inside pieces and is cut at {}; build with larger sizes.turns and sizes.motion_pieces"


def turns_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the places at which the motion turns round inside a piece."""
    turns, room = len(view.tables.turning.turns), view.turn_rows
    cell = CELLS["counts"]
    cell.begin(sheet)
    sheet.rows(
        cell("@turned", turns, axis_turns=view.tables.turning.name),
        cell("@cut", view.turns_cut, room=room, left=left(view)),
    )
    sheet.row += 1
    CELLS["turns"].place(sheet, *columns(view), blank="[k]>@turned")


def columns(view: DriveView) -> list[Quantity]:
    """Return the columns of the turns: the place beside each, the velocities there, and where the motion turns."""
    cell = CELLS["turns"]
    of, turns, rows, room = view.tables.turning.name, view.turns, view.tables.pieces, view.turn_rows
    size, spare = view.driven.axis.motion.size, rows.pieces[0]
    pieces = filled([rows.pieces[turn.piece] for turn in turns], room, spare)
    u = np.array(filled([turn.u for turn in turns], room, 0.0))
    v, a, j = (
        filled([getattr(turn, name) for turn in turns], room, float(curve(0.0)))
        for name, curve in zip(("velocity", "acceleration", "jerk"), spare.curves[1:], strict=True)
    )
    at = filled([shown(turn.at, DEGREE) for turn in turns[: view.turns_cut]], room, TURN)
    return [
        cell("q", filled([turn.piece + 1 for turn in turns], room, 1), axis_turns=of),
        cell("again", filled([int(turn.again) for turn in turns], room)),
        cell("after", filled([turn.after for turn in turns], room), axis_turns=of),
        cell("s", filled([turn.share for turn in turns], room), axis_turns=of, half=0.5 / PARTS),
        cell("u", u + LEAST, pieces=rows.at.pieces, not_zero=NOT_ZERO, source=FROM_START),
        *arguments(rows, "", "[q]", sine_arguments(pieces, u)),
        *(
            cell(name, values, unit=rows.at.unit(order), there=at_place(rows, order, "", "[q]"), scale=size(order))
            for order, (name, values) in enumerate((("v", v), ("a", a), ("j", j)), 1)
        ),
        cell("at", at, begin=rows.at.named("at")),
    ]


def left(view: DriveView) -> str:
    """Return the formula, without its =, of the intervals that are left for turns."""
    at = view.tables.pieces.at
    ends = view.tables.ends
    bends = f'-2*COUNTIF([{bends_name(ends)}.mode],">={BENT_FROM}")' if ends else ""
    return f"[{at.pieces}.r.last]-{at.count}-2*COUNT([@windows.start]){bends}"


def turns_check(view: DriveView) -> Quantity:
    """Return the check that the drive is cut wherever it turns round."""
    cell = CELLS["turns_check"].sharing(**view.parts)
    count, cut = len(view.tables.turning.turns), view.turns_cut
    says = CheckSentence(sentence_formula(FULL, "@turned", "@cut"), FULL.format(count, cut))
    return cell("@ok_turned", count == cut, says=says)
