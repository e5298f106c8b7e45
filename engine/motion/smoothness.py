"""How smooth a motion is: every jump of velocity, acceleration or jerk, at the joints and within the laws."""

import itertools
from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple

import numpy as np

from engine.laws.piece import gains
from engine.laws.piece_extremes import Extremes, extremes_of
from engine.motion.joining import Rates, slope
from engine.motion.motion import Motion
from engine.motion.phase import Phase
from engine.motion.pieces import MotionPiece

Smoothness = Literal["velocity", "acceleration", "jerk"]
ORDERS: tuple[Smoothness, ...] = ("velocity", "acceleration", "jerk")
JUMP = 1e-9
"""of what a motion's jumps are measured by: a smaller one is rounding"""


class Shortfall(NamedTuple):
    """Where a motion is less smooth than asked: what jumps first, by how much, at which x, and why.

    ``before`` and ``after`` are the phases on either side, counted from 0: the same phase twice where its law jumps
    within itself.
    """

    quantity: Smoothness
    jump: float
    x: float
    before: int
    after: int
    reason: str


class _PhasePiece(NamedTuple):
    """A piece of a phase that lasts: where it begins, and the rates at its begin and its end."""

    phase: int
    x: float
    begin: Rates
    end: Rates


def phase_extremes(phase: Phase) -> Extremes:
    """Return the lowest and largest y', y'' and y''' of a phase, exact, whatever its law; y''' where y'' is smooth."""
    found = extremes_of(phase.law.as_pieces(), phase.law.start.v)
    bounds = []
    for order, (low, high) in enumerate(found, 1):
        per = phase.scale / phase.duration**order
        bounds.append((min(per * low, per * high), max(per * low, per * high)))
    return Extremes(*bounds)


def shortfalls(motion: Motion, smooth: Smoothness, periodic: bool = True) -> tuple[Shortfall, ...]:
    """Return every joint, and every place within a law, at which a motion is less smooth than asked, in order of x.

    "velocity" asks for a continuous y', "acceleration" for y'' too and "jerk" for y''' too; of a periodic motion
    also from its end to its begin.
    """
    asked, scales = ORDERS.index(smooth) + 1, scales_of(motion)
    pieces = [one for k in range(len(motion.phases)) for one in _phase_pieces(motion, k)]
    pairs = list(itertools.pairwise(pieces))
    if periodic:
        pairs.append((pieces[-1], pieces[0]._replace(x=float(motion.edges[-1]))))
    return tuple(
        Shortfall(quantity, jump, other.x, one.phase, other.phase, _reason(motion, one, other))
        for one, other in pairs
        for quantity, jump in _first_jump(one.end, other.begin, scales, asked)
    )


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
            order = _order(jump, scales, smooth)
            before = Joint(piece.begin, before.lasting + 1, piece.phase, end, one.phase, jump, order)
        else:
            before = before._replace(x=piece.begin, before=-1, jump=Rates(), order=0)
        found.append(before)
    return tuple(found)


def _ends(piece: MotionPiece, span: tuple[float, float]) -> tuple[Rates, Rates]:
    _, v, a, j = piece.at(np.array(span))
    begin, end = (Rates(*values) for values in zip(v.tolist(), a.tolist(), j.tolist(), strict=True))
    return begin, end


def _order(jump: Rates, scales: Rates, smooth: Smoothness) -> int:
    asked = ORDERS.index(smooth) + 1
    found = (n for n, (size, scale) in enumerate(zip(jump, scales, strict=True), 1) if abs(size) > JUMP * scale)
    return next((n for n in found if n <= asked), 0)


def scales_of(motion: Motion) -> Rates:
    """Return what jumps are measured by: the largest |y'| and |y''| of any phase, and the latter by its 1/δ."""
    peaks = motion.peaks
    return Rates(peaks.y1, peaks.y2, peaks.y2 * max(phase.rate for phase in motion.phases))


def _phase_pieces(motion: Motion, k: int) -> Iterator[_PhasePiece]:
    phase, x = motion.phases[k], float(motion.edges[k])
    v = phase.law.start.v
    for piece in phase.law.as_pieces():
        if piece.duration > 0.0:
            ends = np.array([0.0, piece.duration])
            _, dv, a, j = gains(ends, np.array(piece.row)[:, None])
            begin, end = (
                _rates(phase, *values) for values in zip((v + dv).tolist(), a.tolist(), j.tolist(), strict=True)
            )
            yield _PhasePiece(k, x, begin, end)
            v += float(dv[1])
        x += piece.duration * phase.duration


def _rates(phase: Phase, v: float, a: float, j: float) -> Rates:
    d = phase.duration
    return Rates(phase.scale * v / d, phase.scale * a / d**2, phase.scale * j / d**3)


def _first_jump(one: Rates, other: Rates, scales: Rates, asked: int) -> list[tuple[Smoothness, float]]:
    """Return the lowest derivative that jumps, of those asked for, and by how much; nothing where none does."""
    for quantity, before, after, scale in list(zip(ORDERS, one, other, scales, strict=True))[:asked]:
        if abs(after - before) > JUMP * scale:
            return [(quantity, after - before)]
    return []


def _reason(motion: Motion, one: _PhasePiece, other: _PhasePiece) -> str:
    before, after = (motion.phases[piece.phase] for piece in (one, other))
    if one.phase == other.phase and other.x < motion.edges[one.phase + 1]:
        return f"{before.law.name} jumps within itself"
    slopes = slope(before), slope(after)
    if None not in slopes:
        return f"two straight lines of different slope: {slopes[0]:g} and {slopes[1]:g}"
    return f"{before.law.name} does not end as {after.law.name} begins"
