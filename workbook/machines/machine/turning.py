"""Which way each piece of a motion moves, in cells: a piece that moves both ways turns round inside it."""

from functools import cached_property

from engine.drive.turning import MIDDLES, Directions, Turn, directions, turns_of
from engine.laws.points import slowest
from engine.motion import Phase
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
        in_row = {place: k for k, place in enumerate(self.axis.places)}

        def may(k: int, phase: Phase) -> bool:
            return slowest(phase.named) < -BACKWARD or (self.ends is not None and self.ends.handed[k].mode > 0)

        phases = [may(k, phase) for k, phase in enumerate(self.axis.motion.phases)]
        return [piece.duration > 0.0 and phases[in_row[piece.phase]] for piece in self.rows.pieces]

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
    mode = f",INDEX([{at.ends}.mode],[p])>0" if at.ends else ""
    way = f"IF([{at.pieces}.d.same]>0,IF(OR({LOW.format(at.phases)}<0-check_zero{mode}),1,0),0)"
    v = velocity(rows)
    both, each = "MAX([ff],[fb])", zip(*of.directions, strict=True)
    ff, fb, lf, lb = (filled(values, room, spare) for values, spare in zip(each, Directions(), strict=True))

    def first(name: str, way: str, values: list[float]) -> Quantity:
        formula = f"=IF([may]=0,2,2-SUMPRODUCT(MAX((2-{MIDDLE})*({v}{way}0))))"
        return calc(name, f"{WAYS[way]} from", "", "", formula, values, scale=1.0, source="2: never")

    def last(name: str, way: str, values: list[float]) -> Quantity:
        formula = f"=IF([may]=0,0,SUMPRODUCT(MAX({MIDDLE}*({v}{way}0))))"
        return calc(name, f"{WAYS[way]} until", "", "", formula, values, scale=1.0, source="0: never")

    turned = [0, *(sum(turn.piece <= k for turn in of.turns) for k in range(len(rows.pieces)))]
    sheet.table(
        of.name, f"Which way each piece of axis {of.axis.number} moves, as shares of it", room,
        constant("r", "piece", "k", "", list(range(1, room + 1))),
        calc("p", "step", "", "", f"=[{at.pieces}.p.same]",
             filled([piece.phase + 1 for piece in rows.pieces], room, rows.pieces[-1].phase + 1), format="0"),
        calc("may", "may turn round", "", "", f"={way}", filled([int(may) for may in of.may_turn], room), format="0",
             source="its law moves back, or it takes velocity"),
        first("ff", ">", ff), first("fb", "<", fb), last("lf", ">", lf), last("lb", "<", lb),
        calc("turns", "turns so far", "", "",
             f"=IF([r]=1,0,[turns-1])+IF({both}<1,IF(MIN([lf],[lb])>{both}-check_zero,2,1),0)",
             filled(turned[1:], room, turned[-1]), "inside pieces", format="0"),
        blank=f"[r]>{at.count}",
    )  # fmt: skip


LOW = "INDEX(law_v_low,INDEX([{}.no],[p]))"
WAYS = {">": "forward", "<": "backward"}


def velocity(rows: PieceRows) -> str:
    """Return the formula of y' in the middles of the parts of the piece of the same row, but for a factor."""
    t = rows.at.pieces
    u, text = f"[{t}.d.same]*{MIDDLE}", ""
    for n in range(rows.powers - 1, 0, -1):
        c = f"{n}*[{t}.c{n}.same]" if n > 1 else f"[{t}.c{n}.same]"
        text = f"{c}+{u}*({text})" if "+" in text else f"{c}+{u}*{text}" if text else c
    for mark in rows.marks:
        text += f"+[{t}.dA{mark}.same]*COS([{t}.om{mark}.same]*{u}+[{t}.ph{mark}.same])"
    return text


def middles_table(book: Book, sheet: Sheet) -> None:
    """Declare the middles of the parts of a piece."""
    sheet.table("middles", "Middles of 200 parts of a piece, as shares of it", len(MIDDLES),
                constant("mid", "share", "", "", MIDDLES.tolist()))  # fmt: skip
    book.name("middles", **{MIDDLE: "mid"})
