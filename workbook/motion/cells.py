"""Where a motion stands in a book, and what the engine has for it there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any, NamedTuple

from engine.laws.base import Array
from engine.motion import Motion
from engine.motion.pieces import MotionPiece, located, motion_pieces
from workbook.book.rows import filled
from workbook.laws.sampling import Pieces

RAISED = ("", "", "²", "³", "⁴", "⁵", "⁶", "⁷")


@dataclass(frozen=True)
class Cells:
    """Where a motion stands in a book.

    ``phases`` is the table of its phases, with the columns ``k``, ``no``, ``h``, ``span``, ``begin`` and ``y0``, in
    units of the motion, beside those that this room adds; ``pieces`` is the table of its pieces. ``count``, ``end`` and
    ``near`` are what says how many pieces there are, where the abscissa ends and how near to a begin counts as on it.
    With ``degrees``, begins and samples are in degrees, and the motion per radian. With ``drifts``, phases have a
    column ``drift``, a velocity that is added; with ``opens``, one of where they begin, if in the middle of a piece.
    """

    phases: str
    pieces: str
    count: str
    end: str
    near: str
    y: str = ""
    x: str = ""
    degrees: bool = False
    drifts: bool = False
    opens: bool = False

    def of_phase(self, column: str) -> str:
        """Return the formula of a figure of a piece's phase."""
        return f"INDEX([{self.phases}.{column}],[p])"

    def of_piece(self, column: str, q: str) -> str:
        """Return the formula of a figure of the piece that a sample has found."""
        return f"INDEX([{self.pieces}.{column}],[{q}])"

    def unit(self, order: int) -> str:
        """Return the unit of a derivative of the motion."""
        return f"{self.y}/{self.x}{RAISED[order]}" if order and self.x else self.y


class Found(NamedTuple):
    """Where samples lie: row of the piece (from 1), u from its origin, and the argument of its sine."""

    row: Array
    u: Array
    angle: Array


@dataclass(frozen=True)
class PieceRows:
    """The engine's pieces of a motion, each with its row in the stack of all laws' pieces.

    ``firsts`` and ``rates`` are, for each row of phases, the row of its law's first piece, and 1/δ (0 of a spare row).
    """

    pieces: Sequence[MotionPiece]
    rows: Sequence[int]
    firsts: Sequence[int]
    rates: Sequence[float]
    begin: float
    end: float

    @cached_property
    def counts(self) -> list[int]:
        """How many pieces each row of phases has."""
        found = Counter(piece.phase for piece in self.pieces)
        return [found[k] for k in range(len(self.firsts))]

    @property
    def before(self) -> list[int]:
        """How many pieces there are before each row of phases."""
        return list(accumulate(self.counts[:-1], initial=0))

    def column(self, figure: Callable[[MotionPiece], Any], room: int) -> list[Any]:
        """Return a figure of each piece; spare rows have that of the last."""
        return filled((figure(piece) for piece in self.pieces), room, figure(self.pieces[-1]))

    def found(self, x: Array) -> Found:
        """Return where samples of the abscissa lie."""
        place = located(self.pieces, x, self.begin, self.end)
        return Found((place.piece + 1).astype(float), place.u, place.angle)


def rows_of(motion: Motion, stack: Pieces, room: int) -> PieceRows:
    """Return the pieces of a motion; ``room`` is the number of rows of its phases, spare ones of a dwell."""
    pieces = motion_pieces(motion)
    firsts = filled((stack.first[stack.number(phase.law)] for phase in motion.phases), room, stack.first[1])
    rows = [firsts[piece.phase] + piece.number for piece in pieces]
    rates = filled((phase.rate for phase in motion.phases), room)
    return PieceRows(pieces, rows, firsts, rates, *motion.edges[[0, -1]].tolist())
