"""Where a drive turns round inside a piece of its motion, in cells: friction and losses change sides there."""

import numpy as np

from engine.drive.turning import PARTS
from workbook.book.declare import Quantity, Sheet, calc, check, constant
from workbook.book.rows import LEAST, NOT_ZERO, filled
from workbook.book.sentence import CheckSentence, spelled
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown
from workbook.machines.machine.boundary.bends import BENT_FROM, bends_name
from workbook.machines.machine.drive.view import DriveView
from workbook.motion.pieces import FROM_START, arguments, at_place, turned

FULL = "turns round {} times inside pieces and is cut at {}; build with larger sizes.turns and sizes.motion_pieces"
ABOUT = (
    "A piece that moves both ways is cut where it turns: beside that it has the velocity y', y'' and y''', and on "
    "their parabola y' is 0 after 2y'/(y'' ± √(y''² − 2 y' y''')), to a millionth of the piece."
)


def turns_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the places at which the motion turns round inside a piece."""
    of, turns, rows, room = view.tables.turning, view.turns, view.tables.pieces, view.turn_rows
    size, spare = view.driven.axis.motion.size, rows.pieces[0]
    pieces = filled([rows.pieces[turn.piece] for turn in turns], room, spare)
    u = np.array(filled([turn.u for turn in turns], room, 0.0))
    none = [float(curve(0.0)) for curve in spare.curves[1:]]
    v, a, j = (
        filled([getattr(turn, name) for turn in turns], room, none[k])
        for k, name in enumerate(("velocity", "acceleration", "jerk"))
    )
    at = filled([shown(turn.at, DEGREE) for turn in turns[: view.turns_cut]], room, TURN)
    ff, fb, lf, lb = (f"INDEX([{of.name}.{name}],[q])" for name in ("ff", "fb", "lf", "lb"))
    begin, half = f"INDEX({rows.at.named('at')},[q])", 0.5 / PARTS

    def among(formula: str, none: int = 0) -> str:
        return f"=IF([k]>@turned,{none},{formula})"

    sheet.heading("Workings: where it turns round", ABOUT)
    sheet.rows(
        calc("@turned", "Turns inside pieces", "", "", f"=[{of.name}.turns.last]+0", len(of.turns), format="0"),
        calc("@cut", "of these at cuts", "", "", f"=MIN(@turned,{room},{left(view)})", view.turns_cut,
             "what this table and that of the intervals have rows for", format="0"),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "@turns", "Where it turns round inside a piece", room,
        constant("k", "turn", "k", "", list(range(1, room + 1))),
        calc("q", "piece", "q", "", among(f'COUNTIF([{of.name}.turns],"<"&[k])+1', 1),
             filled([turn.piece + 1 for turn in turns], room, 1), format="0"),
        calc("again", "second of its piece", "", "", among("IF([k]=1,0,IF([q]=[q-1],1,0))"),
             filled([int(turn.again) for turn in turns], room), "1 yes, 0 no", format="0"),
        calc("after", "direction after it", "", "", among(f"IF([again]=1,SIGN({lf}-{lb}),SIGN({ff}-{fb}))"),
             filled([turn.after for turn in turns], room), format="0"),
        calc("s", "beside it: share of the piece", "", "",
             among(f"IF([again]=1,MIN({lf},{lb})+{half},MAX({ff},{fb})-{half})"),
             filled([turn.share for turn in turns], room), scale=1.0),
        calc("u", "within piece", "u", "rad", f"=[s]*INDEX([{rows.at.pieces}.d],[q]){NOT_ZERO}", u + LEAST, FROM_START),
        *arguments(rows, "", "[q]", turned(pieces, u)),
        *(calc(name, what, symbol, rows.at.unit(order), f"={at_place(rows, order, '', '[q]')}", values,
               scale=size(order))
          for order, (name, what, symbol, values) in enumerate(
              (("v", "velocity there", "y'", v), ("a", "acceleration", "y''", a), ("j", "jerk", "y'''", j)), 1)),
        calc("at", "turns round at", "θ", "°",
             f"=IF([k]>@cut,360,{begin}+DEGREES([u]-2*[v]/([a]+[after]*SQRT(MAX(0,[a]^2-2*[j]*[v])))))", at,
             "of its phases; spare rows: the end", scale=TURN, format="0.0##"),
        blank="[k]>@turned",
    )  # fmt: skip


def left(view: DriveView) -> str:
    """Return the formula, without its =, of the intervals that are left for turns."""
    at = view.tables.pieces.at
    ends = view.tables.ends
    bends = f'-2*COUNTIF([{bends_name(ends)}.mode],">={BENT_FROM}")' if ends else ""
    return f"[{at.pieces}.r.last]-{at.count}-2*COUNT([@windows.start]){bends}"


def turns_check(view: DriveView) -> Quantity:
    """Return the check that the drive is cut wherever it turns round."""
    count, cut = len(view.tables.turning.turns), view.turns_cut
    says = CheckSentence(spelled(FULL, "@turned", "@cut"), FULL.format(count, cut))
    return check("@ok_turned", f"{view.driven.called}: cut wherever it turns round", "@turned=@cut", count == cut,
                 says=says)  # fmt: skip
