"""A motion as a table of pieces: polynomials and sines in its own units."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import repeat
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.extremes import Curve, largest_size
from engine.laws.inverse import law_pieces
from engine.laws.piece import POWERS, PlacedPiece, Sine
from engine.motion.motion import Motion
from engine.motion.phase import MotionValues


@dataclass(frozen=True)
class MotionPiece:
    """A piece of a motion, y(u) = c0 + c1 u + … + c7 u⁷ + Σ A sin(ωu + φ), in units of the motion; φ in rad."""

    phase: int  # number of its phase, from 0
    number: int  # within its phase, from 0
    begin: float  # abscissa
    duration: float  # in units of the abscissa
    c: tuple[float, ...]  # c0 to c7
    sines: tuple[Sine, ...]  # A, ω, φ of two sines
    origin: float  # abscissa at which u = 0; before ``begin`` if a motion resumes in the middle of a piece

    def at(self, u: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at u."""
        return MotionValues(*(curve(u) for curve in self.curves))

    @cached_property
    def curves(self) -> tuple[Curve, Curve, Curve, Curve]:
        """y, y', y'' and y''' over u."""
        used = max((k for k, c in enumerate(self.c, 1) if c), default=0)
        y = Curve(self.c[: max(used, 3)], tuple(sine for sine in self.sines if sine[0]))
        return y, y.slope, y.slope.slope, y.slope.slope.slope


class ScaledLaw(NamedTuple):
    """A law over a lift in a duration, with a constant velocity superimposed; in any units of y and x."""

    law: Law
    h: float  # lift
    duration: float  # δ
    x: float = 0.0  # abscissa of its begin
    y: float = 0.0  # position at its begin
    drift: float = 0.0  # superimposed velocity

    @property
    def max_velocity(self) -> float:
        """Max |y'| without the drift, C_v |h|/δ."""
        return self.law.coefficients.cv * abs(self.h) * self.rate

    @property
    def max_acceleration(self) -> float:
        """Max |y''|, C_a |h|/δ²."""
        return self.law.coefficients.ca * abs(self.h) * self.rate**2

    @property
    def rate(self) -> float:
        """1/δ; 0 if δ = 0."""
        return 1.0 / self.duration if self.duration else 0.0

    def pieces(self, phase: int = 0, whole: bool = False) -> list[MotionPiece]:
        """Return its pieces as those of the ``phase``-th, from 0; ``whole`` as in :func:`law_pieces`.

        With s_k, v_k at the begin ξ_k of a piece of the law, per unit of ξ::

        y(u) = y + drift (x_k − x + u) + h [s_k + v_k u/δ + Σ c_i (u/δ)^(i+2)/((i+1)(i+2))
               + P/ω² (sin φ + ωu/δ cos φ − sin(ωu/δ + φ))],      u from x_k = x + ξ_k δ
        """
        return [_piece(self, phase, number, placed) for number, placed in enumerate(law_pieces(self.law, whole))]


def _piece(of: ScaledLaw, phase: int, number: int, placed: PlacedPiece) -> MotionPiece:
    at, begin = of.law.evaluate(placed.begin), of.x + placed.begin * of.duration
    piece = placed.piece
    s, v, still, sines = at.s, at.v, 0.0, []
    for p, w, phi in ((piece.amplitude, piece.omega, piece.phase), (piece.amplitude2, piece.omega2, piece.phase2)):
        turns = p / w**2 if w else 0.0
        s, v = s + turns * math.sin(phi), v + turns * w * math.cos(phi)
        still += p * math.sin(phi) if piece.duration and not w else 0.0
        sines.append((-of.h * turns, w / of.duration, phi))
    a = (piece.c[0] + still, *piece.c[1:], *repeat(0.0, POWERS - len(piece.c)))
    shape = (s, v, *(c / ((i + 1) * (i + 2)) for i, c in enumerate(a)))
    c = [of.h * value / of.duration**i for i, value in enumerate(shape)]
    c[0] += of.y + of.drift * (begin - of.x)
    c[1] += of.drift
    return MotionPiece(phase, number, begin, piece.duration * of.duration, tuple(c), tuple(sines), begin)


def motion_pieces(motion: Motion, whole: bool = False) -> list[MotionPiece]:
    """Return the pieces of a motion, phase by phase, in order of the abscissa; ``whole`` as in :func:`law_pieces`."""
    pieces: list[MotionPiece] = []
    for k, (phase, at) in enumerate(zip(motion.phases, motion.ends, strict=True)):
        scaled = ScaledLaw(phase.law, phase.scale, phase.duration, float(motion.edges[k]), at.begin.y)
        pieces += scaled.pieces(k, whole)
    return pieces


class Located(NamedTuple):
    """Places of samples in a table of pieces, arrays of equal shape."""

    piece: NDArray[np.intp]  # number of the piece, from 0
    u: Array  # abscissa from its origin


@dataclass(frozen=True)
class MotionPieces:
    """A motion over a cycle as a table of pieces, in order of the abscissa."""

    pieces: Sequence[MotionPiece]
    end: float  # abscissa at which the cycle ends

    @classmethod
    def of(cls, motion: Motion) -> "MotionPieces":
        """Return the pieces of a motion."""
        return cls(tuple(motion_pieces(motion)), float(motion.edges[-1]))

    @property
    def begin(self) -> float:
        """Abscissa of the begin of the cycle."""
        return self.pieces[0].begin

    @property
    def total(self) -> float:
        """Length of the cycle, in units of the abscissa."""
        return self.end - self.begin

    @property
    def moved(self) -> list[MotionPiece]:
        """The pieces of any duration."""
        return [piece for piece in self.pieces if piece.duration > 0.0]

    @cached_property
    def fastest(self) -> float:
        """The largest |y'| of the motion."""
        return max(largest_size(piece.curves[1], piece.duration) for piece in self.moved)

    @property
    def begins(self) -> Array:
        """Begin of each piece as a share of the cycle."""
        return self._shares(np.array([piece.begin for piece in self.pieces]))

    def _shares(self, x: Array) -> Array:
        return np.asarray((x - self.begin) / self.total)

    def located(self, x: Array) -> Located:
        """Return the piece at each abscissa (n,): the last that begins at or before it, or less than rounding after it.

        At the end of the motion the left limit counts.
        """
        reached = np.minimum(self._shares(x) + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE)
        k = np.maximum(np.searchsorted(self.begins, reached, side="right") - 1, 0)
        return Located(k, x - np.array([piece.origin for piece in self.pieces])[k])

    def at(self, x: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at abscissae (n,)."""
        place, table = self.located(x), np.empty((4, x.size))
        for k in np.unique(place.piece):
            here = place.piece == k
            table[:, here] = self.pieces[k].at(place.u[here])
        return MotionValues(*table)
