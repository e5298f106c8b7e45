"""The direction of each piece of a motion, in cells: a piece that moves both ways turns round inside it."""

from functools import cached_property

from engine.drive.turning import MIDDLES, Directions, Turn, directions, turns_of
from engine.laws import Law
from engine.laws.points import slowest
from engine.motion.pieces import MotionPiece
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Sheet
from workbook.book.rows import filled
from workbook.machines.machine.boundary.handover import AxisHandover
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows

CELLS = cell_tables(__file__)

BACKWARD = 1e-9  # share of the mean velocity: a law that is slower than minus this may turn round
MIDDLE = "mid"  # the name of the shares of a piece at which its direction is looked at


class AxisTurns:
    """The directions of an axis' pieces, and its turns inside pieces, in order.

    A piece is looked at where its law moves backward too, or where its phase takes velocity from its neighbours.
    """

    def __init__(self, rows: PieceRows, axis: MovingAxis, ends: AxisHandover | None, room: int) -> None:
        self.rows, self.axis, self.ends, self.room = rows, axis, ends, room
        self.name = rows.at.pieces.replace("_pieces", "_moves")

    @cached_property
    def may_turn(self) -> list[bool]:
        """Whether each piece may turn round."""

        def may(piece: MotionPiece) -> bool:
            takes = self.ends is not None and self.ends.step_of(piece).mode > 0
            return takes or slowest(self.law_of(piece)) < -BACKWARD

        return [piece.duration > 0.0 and may(piece) for piece in self.rows.pieces]

    def law_of(self, piece: MotionPiece) -> Law:
        """Return the law of a piece's phase, as entered."""
        return self.axis.motion.phases[self.axis.places.index(piece.phase)].named

    @cached_property
    def directions(self) -> list[Directions]:
        """The shares of each piece that move each way."""
        both = zip(self.rows.pieces, self.may_turn, strict=True)
        return [directions(piece) if may else Directions() for piece, may in both]

    @cached_property
    def turns(self) -> list[Turn]:
        """All turns inside pieces."""
        return turns_of(self.rows.pieces, self.directions)


def moves_table(sheet: Sheet, of: AxisTurns) -> None:
    """Declare where each piece moves which way, and how often the motion has turned round inside a piece."""
    cell, at, rows, room = CELLS["moves_table"], of.rows.at, of.rows, of.room
    taken = f"+(INDEX([{at.ends}.mode],[{at.pieces}.p.same])>0)" if at.ends else ""
    turned = [sum(turn.piece <= k for turn in of.turns) for k in range(len(rows.pieces))]
    lows, speed = [slowest(of.law_of(piece)) for piece in rows.pieces], velocity(rows)
    both = zip(zip(*of.directions, strict=True), Directions(), strict=True)
    ff, fb, lf, lb = (filled(values, room, spare) for values, spare in both)
    sheet.table(
        of.name,
        f"Which way each piece of axis {of.axis.number} moves, as shares of it",
        room,
        cell("r", list(range(1, room + 1))),
        cell("low", filled(lows, room, lows[-1]), at=at, scale=1.0),
        cell("may", filled([int(may) for may in of.may_turn], room), at=at, taken=taken),
        cell("ff", ff, velocity=speed, scale=1.0),
        cell("fb", fb, velocity=speed, scale=1.0),
        cell("lf", lf, velocity=speed, scale=1.0),
        cell("lb", lb, velocity=speed, scale=1.0),
        cell("turns", filled(turned, room, turned[-1])),
        blank=f"[r]>{at.count}",
    )


def velocity(rows: PieceRows) -> str:
    """Return the formula of y' in the middles of the parts of the piece of the same row.

    It has a single sine: laws with a second sine go forward throughout, between rests.
    """
    t = rows.at.pieces
    u, text = f"[{t}.d.same]*{MIDDLE}", ""
    for n in range(rows.powers - 1, 0, -1):
        c = f"{n}*[{t}.c{n}.same]" if n > 1 else f"[{t}.c{n}.same]"
        text = f"{c}+{u}*({text})" if "+" in text else f"{c}+{u}*{text}" if text else c
    return f"{text}+[{t}.dA.same]*COS([{t}.om.same]*{u}+[{t}.ph.same])"


def middles_table(book: Book, sheet: Sheet) -> None:
    """Declare the middles of the parts of a piece."""
    title = "Middles of 200 parts of a piece, as shares of it"
    sheet.table("middles", title, len(MIDDLES), CELLS["middles"]("mid", MIDDLES.tolist()))
    book.name("middles", **{MIDDLE: "mid"})
