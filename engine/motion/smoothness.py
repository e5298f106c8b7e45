"""How smooth a motion is: every jump of velocity, acceleration or jerk, at the joints and within the laws."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from engine.motion.joining import Rates
from engine.motion.motion import Motion
from engine.motion.pieces import MotionPiece, motion_pieces

Smoothness = Literal["velocity", "acceleration", "jerk"]
ORDERS: tuple[Smoothness, ...] = ("velocity", "acceleration", "jerk")
JUMP = 1e-9
"""of what a motion's jumps are measured by: a smaller one is rounding"""


class Joint(NamedTuple):
    """Where a piece of a motion begins: what jumps there, and what it ends with.

    What does not last takes over what is before it: ``lasting`` counts the pieces that last up to here, ``phase`` is
    the phase of the last of these and ``end`` its rates at its end. ``before`` is the phase of the one before,
    ``jump`` what jumps, and ``order`` the least derivative that does, of those asked for: 0 where none does.
    """

    x: float
    lasting: int
    phase: int
    end: Rates
    before: int
    jump: Rates
    order: int

    @property
    def size(self) -> float:
        """The jump of that derivative."""
        return self.jump[self.order - 1] if self.order else 0.0


def joints(
    pieces: Sequence[MotionPiece], scales: Rates, smooth: Smoothness, periodic: bool = True,
    spans: Sequence[tuple[float, float]] = (),
) -> tuple[Joint, ...]:  # fmt: skip
    """Return where the pieces of a motion begin; of a periodic one, the first follows the last.

    ``spans`` are the begin and end of each piece, from its origin, where a motion does not have them whole.
    """
    found: list[Joint] = []
    asked = ORDERS.index(smooth) + 1
    whole = spans or [(0.0, piece.duration) for piece in pieces]
    lasting = [(piece, span) for piece, span in zip(pieces, whole, strict=True) if piece.duration > 0.0]
    last = Joint(0.0, 0, lasting[-1][0].phase, _ends(*lasting[-1])[1], -1, Rates(), 0)
    before = last._replace(phase=-1, end=Rates())
    for piece, span in zip(pieces, whole, strict=True):
        if piece.duration > 0.0:
            one = last if before.lasting == 0 else before
            begin, end = _ends(piece, span)
            joined = periodic or before.lasting > 0
            jump = Rates(*(y - x for x, y in zip(one.end, begin, strict=True))) if joined else Rates()
            jumps = (n for n in range(asked) if abs(jump[n]) > JUMP * scales[n])
            order = next(jumps, -1) + 1
            before = Joint(piece.begin, before.lasting + 1, piece.phase, end, one.phase, jump, order)
        else:
            before = before._replace(x=piece.begin, before=-1, jump=Rates(), order=0)
        found.append(before)
    return tuple(found)


def _ends(piece: MotionPiece, span: tuple[float, float]) -> tuple[Rates, Rates]:
    _, v, a, j = piece.at(np.array(span))
    begin, end = (Rates(*values) for values in zip(v.tolist(), a.tolist(), j.tolist(), strict=True))
    return begin, end


def scales_of(motion: Motion) -> Rates:
    """Return what jumps are measured by: the largest |y'| and |y''| of any phase, and the latter by its 1/δ."""
    peaks = motion.peaks
    return Rates(peaks.y1, peaks.y2, peaks.y2 * max(phase.rate for phase in motion.phases))


def shortfalls(motion: Motion, smooth: Smoothness, periodic: bool = True) -> tuple[Joint, ...]:
    """Return where a motion is less smooth than asked, between its phases and within their laws, in order of x.

    "velocity" asks for a continuous y', "acceleration" for y'' too and "jerk" for y''' too; of a periodic motion
    also from its end to its begin.
    """
    found = joints(motion_pieces(motion), scales_of(motion), smooth, periodic)
    return tuple(joint for joint in found if joint.order)
