"""The tool over a cycle as one table of pieces: a second route to its motion."""

from dataclasses import replace
from typing import NamedTuple

from engine.flying.cut import Cut
from engine.laws import Dwell, Law
from engine.laws.base import BREAK_TOLERANCE
from engine.motion.joining import Rates
from engine.motion.pieces import MotionPiece, Scaled, pieces_of
from engine.motion.smoothness import Joint, Smoothness, joints


class CutPart(NamedTuple):
    """A part of the cycle: a motion by a law, besides a drift, of which it has some pieces; it begins at ``opens``."""

    scaled: Scaled
    opens: float
    first: int
    """its first piece of the law, from 0"""
    taken: int

    @property
    def law(self) -> Law:
        """The law of the superimposed motion; a dwell where there is none."""
        return self.scaled.law

    @property
    def h(self) -> float:
        """The displacement by the law (m)."""
        return self.scaled.h

    @property
    def rate(self) -> float:
        """1 over the duration of the law; 0 of none."""
        return self.scaled.rate

    def pieces(self, number: int, whole: bool = False) -> list[MotionPiece]:
        """Return its pieces, as those of the part of a number."""
        found = pieces_of(self.scaled, number, whole)[self.first : self.first + self.taken] if self.taken else []
        return [replace(piece, begin=max(piece.begin, self.opens)) for piece in found]


def cut_parts(cut: Cut, whole: bool = False) -> tuple[CutPart, CutPart, CutPart, CutPart]:
    """Return the parts of a cycle: it moves by its law up to the wait, waits, moves on, and works at line speed.

    The law that a wait interrupts goes on in the middle of a piece, later by the wait. Without a wait the first part
    has all pieces of the law, the second and the third none; without a time to work, neither has the fourth.
    ``whole`` pieces are not cut where the acceleration is largest.
    """
    v, t, h, wait = cut.line_speed, cut.moving_time, cut.superimposed, cut.waiting_time
    begin, end = cut.wait
    begins = [piece.begin / t for piece in pieces_of(Scaled(cut.law, 1.0, t), whole=whole)]
    peak = cut.fastest if cut.waits else 1.0
    before = sum(xi < peak - BREAK_TOLERANCE for xi in begins)
    again = sum(xi <= min(peak + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE) for xi in begins) - 1
    stands = v * cut.fastest * t + h * cut.law.s(cut.fastest) if cut.waits else 0.0
    moved = v * t + h * cut.law.end.s
    return (
        CutPart(Scaled(cut.law, h, t, drift=v), 0.0, 0, before),
        CutPart(Scaled(Dwell(), 0.0, wait, begin, stands), begin, 0, int(cut.waits)),
        CutPart(Scaled(cut.law, h, t, wait, drift=v), end, again, len(begins) - again if cut.waits else 0),
        CutPart(Scaled(Dwell(), 0.0, cut.tool_time, cut.repositioning_time, moved, v), cut.repositioning_time, 0,
                int(cut.tool_time > 0.0)),
    )  # fmt: skip


def spans(cut: Cut) -> list[tuple[float, float]]:
    """Return from where to where the motion has each of its pieces, counted from their origins (s)."""
    found = cut_pieces(cut)
    ends = [*(piece.begin for piece in found[1:]), cut.cycle_time]
    return [(piece.begin - piece.origin, end - piece.origin) for piece, end in zip(found, ends, strict=True)]


def cut_joints(cut: Cut, smooth: Smoothness) -> tuple[Joint, ...]:
    """Return where the pieces of the tool's motion begin, and what jumps there of what must not.

    Jumps are measured by the tool's highest speed and acceleration, and by this over the time of the law.
    """
    return joints(cut_pieces(cut), rates_of(cut), smooth, spans=spans(cut))


def rates_of(cut: Cut) -> Rates:
    """Return the sizes of velocity, acceleration and jerk by which jumps are measured: m/s, m/s², m/s³."""
    hardest = cut.max_acceleration
    return Rates(max(abs(v) for v in cut.speed_range), hardest, hardest / cut.moving_time)


def cut_pieces(cut: Cut, whole: bool = False) -> list[MotionPiece]:
    """Return the pieces of the tool's motion over the cycle, in m and s; ``whole`` as :func:`cut_parts` has it."""
    parts = enumerate(cut_parts(cut, whole))
    return [piece for number, part in parts for piece in part.pieces(number, whole)]
