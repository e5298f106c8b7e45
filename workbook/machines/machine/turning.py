"""Which way each piece of a motion moves, in cells: a piece that moves both ways turns round inside it."""

from functools import cached_property

from engine.drive.turning import MIDDLES, Directions, Turn, directions, turns_of
from engine.laws import Law
from engine.laws.points import slowest
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Book, Quantity, Sheet, calc, constant
from workbook.book.rows import filled
from workbook.machines.machine.boundary.handover import AxisHandover
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows

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
        """Where each piece moves each way."""
        both = zip(self.rows.pieces, self.may_turn, strict=True)
        return [directions(piece) if may else Directions() for piece, may in both]

    @cached_property
    def turns(self) -> list[Turn]:
        """All turns inside pieces."""
        return turns_of(self.rows.pieces, self.directions)


def moves_table(sheet: Sheet, of: AxisTurns) -> None:
    """Declare where each piece moves which way, and how often the motion has turned round inside a piece."""
    at, rows, room = of.rows.at, of.rows, of.room
    p, v = f"[{at.pieces}.p.same]", velocity(rows)
    taken = f"+(INDEX([{at.ends}.mode],{p})>0)" if at.ends else ""
    both, each = "MAX([ff],[fb])", zip(*of.directions, strict=True)
    ff, fb, lf, lb = (filled(values, room, spare) for values, spare in zip(each, Directions(), strict=True))

    def first(name: str, way: str, values: list[float]) -> Quantity:
        formula = f"=IF([may]=0,2,2-SUMPRODUCT(MAX((2-{MIDDLE})*({v}{way}0))))"
        return calc(name, f"{WAYS[way]} from", "", "", formula, values, scale=1.0, source="2: never")

    def last(name: str, way: str, values: list[float]) -> Quantity:
        formula = f"=IF([may]=0,0,SUMPRODUCT(MAX({MIDDLE}*({v}{way}0))))"
        return calc(name, f"{WAYS[way]} until", "", "", formula, values, scale=1.0, source="0: never")

    turned = [sum(turn.piece <= k for turn in of.turns) for k in range(len(rows.pieces))]
    lows = [slowest(of.law_of(piece)) for piece in rows.pieces]
    sheet.table(
        of.name, f"Which way each piece of axis {of.axis.number} moves, as shares of it", room,
        constant("r", "piece", "k", "", list(range(1, room + 1))),
        calc("low", "lowest velocity of its law", "", "", f"=INDEX(law_v_low,INDEX([{at.phases}.no],{p}))",
             filled(lows, room, lows[-1]), scale=1.0),
        calc("may", "may turn round", "", "", f"=IF([{at.pieces}.d.same]*(([low]<0-check_zero){taken})>0,1,0)",
             filled([int(may) for may in of.may_turn], room), "its law does, or it takes velocity", format="0"),
        first("ff", ">", ff), first("fb", "<", fb), last("lf", ">", lf), last("lb", "<", lb),
        calc("turns", "turns so far", "", "",
             f"=IF([r]=1,0,[turns-1])+IF({both}<1,IF(MIN([lf],[lb])>{both}-check_zero,2,1),0)",
             filled(turned, room, turned[-1]), "inside pieces", format="0"),
        blank=f"[r]>{at.count}",
    )  # fmt: skip


WAYS = {">": "forward", "<": "backward"}


def velocity(rows: PieceRows) -> str:
    """Return the formula of y' in the middles of the parts of the piece of the same row.

    It has one sine: laws with a second one go forward throughout, between rests.
    """
    t = rows.at.pieces
    u, text = f"[{t}.d.same]*{MIDDLE}", ""
    for n in range(rows.powers - 1, 0, -1):
        c = f"{n}*[{t}.c{n}.same]" if n > 1 else f"[{t}.c{n}.same]"
        text = f"{c}+{u}*({text})" if "+" in text else f"{c}+{u}*{text}" if text else c
    return f"{text}+[{t}.dA.same]*COS([{t}.om.same]*{u}+[{t}.ph.same])"


def middles_table(book: Book, sheet: Sheet) -> None:
    """Declare the middles of the parts of a piece."""
    sheet.table("middles", "Middles of 200 parts of a piece, as shares of it", len(MIDDLES),
                constant("mid", "share", "", "", MIDDLES.tolist()))  # fmt: skip
    book.name("middles", **{MIDDLE: "mid"})
