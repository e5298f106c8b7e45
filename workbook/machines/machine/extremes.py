"""A motion whose phases with prescribed ends have their extremes at points, as in the cells."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.laws.base import Array
from engine.laws.polynomials import BoundaryLine, BoundaryPolynomial
from engine.motion import Motion, Phase
from engine.motion.joining import BoundaryPhase
from engine.motion.pieces import MotionPiece, motion_pieces

# where a piece is looked at for its extremes, as shares of its duration
POINTS = np.linspace(0.0, 1.0, 201)


def at_points(piece: MotionPiece, order: int) -> Array:
    """Return the position (order 0) or a derivative of a piece at its points."""
    return piece.curves[order](piece.duration * POINTS)


@dataclass(frozen=True)
class MeasuredPhase(BoundaryPhase):
    """A phase with prescribed ends whose extremes are those of its ``parts`` at points.

    The velocity, acceleration and jerk of a law of two pulses are exact by the heights of its pulses.
    """

    parts: tuple[MotionPiece, ...] = ()

    def _most(self, order: int, exact: float) -> float:
        if not isinstance(self.law, BoundaryPolynomial | BoundaryLine):
            return exact
        return max(float(np.abs(at_points(piece, order)).max()) for piece in self.parts)

    @cached_property
    def y1_max(self) -> float:
        """Largest |y'|."""
        return self._most(1, super().y1_max)

    @cached_property
    def y2_max(self) -> float:
        """Largest |y''|."""
        return self._most(2, super().y2_max)

    @cached_property
    def y3_max(self) -> float:
        """Largest |y'''|; infinite where the acceleration jumps."""
        return self._most(3, super().y3_max)


class MeasuredMotion(Motion):
    """A motion with such phases."""

    @cached_property
    def reaches(self) -> tuple[tuple[float, float], ...]:
        """The lowest and the highest position of each phase."""
        reaches = list(super().reaches)
        for k, phase in enumerate(self.phases):
            if isinstance(phase, MeasuredPhase):
                y = np.concatenate([at_points(piece, 0) for piece in phase.parts])
                reaches[k] = float(y.min()), float(y.max())
        return tuple(reaches)


def measured(motion: Motion) -> Motion:
    """Return a motion with the extremes at points; itself where no phase has prescribed ends."""
    if not any(isinstance(phase, BoundaryPhase) for phase in motion.phases):
        return motion
    pieces = motion_pieces(motion)

    def of(k: int, phase: Phase) -> Phase:
        if not isinstance(phase, BoundaryPhase):
            return phase
        parts = tuple(piece for piece in pieces if piece.phase == k)
        return MeasuredPhase(phase.law, phase.lift, phase.duration, phase.origin, phase.scale, parts)

    phases = [of(k, phase) for k, phase in enumerate(motion.phases)]
    return MeasuredMotion(phases, float(motion.edges[0]), motion.position)
