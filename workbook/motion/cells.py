"""The cells of a motion in a book, and the engine's values for them."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from engine.laws import Dwell
from engine.motion import Motion
from engine.motion.pieces import MotionPiece, ScaledLaw, motion_pieces
from workbook.book.rows import spread
from workbook.laws.sampling import Pieces

RAISED = ("", "", "²", "³", "⁴", "⁵", "⁶", "⁷")


FIRST = "=MATCH([no],piece_number,0)"  # the row of the first piece of a phase's law


def last_before(number: str, xi: str) -> str:
    """Return the formula of the row of a law's last piece that begins before ξ: before 1, no spare row does."""
    return f"MATCH(2*{number}+{xi}-break_eps,piece_key,1)"


def of_law(column: str) -> str:
    """Return the formula of an entry of the law's piece, in the row ``m`` of the stack."""
    return f"INDEX(piece_{column},[m])"


@dataclass(frozen=True)
class Cells:
    """The cells of a motion in a book; over time, a sample finds its piece by the share of the whole."""

    phases: str  # the table of its phases: ``k``, ``no``, ``h``, ``span``, ``begin``, ``y0``, in units of the motion
    pieces: str  # the table of its pieces
    count: str  # what says how many pieces there are
    end: str  # what says where the abscissa ends; it begins at 0
    y: str  # units of position and abscissa
    x: str
    degrees: bool = False  # whether begins and samples are in degrees, and the motion per radian
    near: str = ""  # what says how near to a begin counts as on it, in degrees
    drifts: bool = False  # whether phases have a column ``drift``, a velocity that is added
    opens: bool = False  # whether they have a column of their begin within a piece
    ends: str = ""  # the table of what phases take from their neighbours, in books that have it

    def of_phase(self, column: str) -> str:
        """Return the formula of a figure of a piece's phase."""
        return f"INDEX([{self.phases}.{column}],[p])"

    def of_end(self, column: str) -> str:
        """Return the formula of a figure of what a piece's phase takes from its neighbours."""
        return f"INDEX([{self.ends}.{column}],[p])"

    @property
    def required(self) -> str:
        """The table of what is asked for at the ends of phases."""
        return self.ends.replace("_ends", "_asked")

    @property
    def base(self) -> str:
        """The formula of the position that the law of a piece is counted from."""
        return "[base]" if self.ends else self.of_phase("y0")

    @property
    def drift(self) -> str:
        """The formula of the velocity that is added on a piece; empty where none is."""
        return "[drift]" if self.ends else self.of_phase("drift") if self.drifts else ""

    def named(self, column: str) -> str:
        """Return the defined name of a column of the pieces' table; ``c`` is that of all coefficients."""
        return f"{self.pieces.removesuffix('_pieces')}_{column}"

    def piece(self, x: str) -> str:
        """Return the formula, without its =, of the piece of a sample: the last that begins at or before it."""
        if self.degrees:
            return f"MATCH(MIN([{x}]+{self.near},{self.end}-{self.near}),{self.named('at')},1)"
        return f"MATCH(MIN([{x}]/{self.end}+break_eps,1-break_eps),[{self.pieces}.share],1)"

    def unit(self, order: int) -> str:
        """Return the unit of a derivative of the motion."""
        return f"{self.y}/{self.x}{RAISED[order]}" if order else self.y


@dataclass(frozen=True)
class PieceRows:
    """A motion ``at`` its place: the engine's pieces of it, each with its row in the stack of all laws' pieces."""

    at: Cells
    stack: Pieces
    pieces: Sequence[MotionPiece]
    rows: Sequence[int]
    numbers: Sequence[int]  # for each row of phases: the number of its law,
    firsts: Sequence[int]  # the row of the first piece that it has of it,
    lifts: Sequence[float]  # its lift,
    rates: Sequence[float]  # and 1/δ; 0 of a spare row
    end: float  # of the abscissa, which begins at 0

    @cached_property
    def marks(self) -> tuple[str, ...]:
        """The ends of the names of columns of each sine that a piece may have: two where any law has a second."""
        second = any(piece.omega2 for pieces in self.stack.pieces.values() for piece in pieces)
        return ("", "2") if second else ("",)

    @cached_property
    def powers(self) -> int:
        """The greatest number of coefficients of a piece's polynomial: two more than the accelerations of laws."""
        return self.stack.room + 2

    @cached_property
    def counts(self) -> list[int]:
        """The number of pieces of each row of phases."""
        counts = Counter(piece.phase for piece in self.pieces)
        return [counts[k] for k in range(len(self.firsts))]


def rows_of_parts(
    at: Cells,
    parts: Sequence[ScaledLaw],
    pieces: Sequence[MotionPiece],
    stack: Pieces,
    end: float,
    begun: Sequence[int] = (),
) -> PieceRows:
    """Return the pieces of a motion of parts, from 0 to its ``end``; each may begin with any piece of its law."""
    numbers = [
        1 if isinstance(part.law, Dwell) else stack.number(part.law) for part in parts
    ]  # there is a single dwell
    starts = [stack.first[number] for number in numbers]
    firsts = [start + first for start, first in zip(starts, begun, strict=True)] if begun else starts
    rows = [starts[piece.phase] + piece.number for piece in pieces]
    lifts, rates = [part.h for part in parts], [part.rate for part in parts]
    return PieceRows(at, stack, pieces, rows, numbers, firsts, lifts, rates, end)


def rows_of(at: Cells, motion: Motion, stack: Pieces, places: Sequence[int], room: int) -> PieceRows:
    """Return the pieces of a motion whose phases stand at ``places`` of ``room`` rows."""
    pieces = [replace(piece, phase=places[piece.phase]) for piece in motion_pieces(motion)]
    parts = (ScaledLaw(phase.named, phase.lift, phase.duration) for phase in motion.phases)
    placed = spread(parts, places, room, ScaledLaw(Dwell(), 0.0, 0.0))
    return rows_of_parts(at, placed, pieces, stack, float(motion.edges[-1]))
