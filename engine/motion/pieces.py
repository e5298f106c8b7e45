"""A motion as one table of pieces, in its own units: a second route to y and its derivatives; in others, for cams."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import repeat
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array, Real
from engine.laws.inverse import LawPiece, law_pieces
from engine.laws.ladder import Curve
from engine.laws.piece import POWERS, Sine
from engine.motion.motion import Motion
from engine.motion.phase import MotionValues


@dataclass(frozen=True)
class MotionPiece:
    """y(u) = c0 + c1 u + … + c7 u⁷ + Σ A sin(ωu + φ), two sines, in units of the motion."""

    phase: int  # counted from 0
    number: int  # in its phase, counted from 0
    begin: float  # it holds from here
    duration: float
    c: tuple[float, ...]
    sines: tuple[Sine, ...]
    origin: float  # of u: before ``begin`` where a motion goes on in the middle of a piece

    def at(self, u: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at u."""
        return MotionValues(*(curve.at(u) for curve in self.curves))

    @cached_property
    def curves(self) -> tuple[Curve, Curve, Curve, Curve]:
        """y, y', y'' and y''' over u."""
        used = max((k for k, c in enumerate(self.c, 1) if c), default=0)
        y = Curve(self.c[: max(used, 3)], tuple(sine for sine in self.sines if sine[0]))
        v = y.derivative()
        return y, v, v.derivative(), v.derivative().derivative()


class ScaledLaw(NamedTuple):
    """A law over a lift ``h`` in a ``duration``, from ``y`` at ``x``, moving with the velocity ``drift`` besides."""

    law: Law
    h: float
    duration: float
    x: float = 0.0
    y: float = 0.0
    drift: float = 0.0

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
        """1/δ; 0 of a phase that does not last."""
        return 1.0 / self.duration if self.duration else 0.0


def pieces_of(scaled: ScaledLaw, phase: int = 0, whole: bool = False) -> list[MotionPiece]:
    """Return the pieces of one phase, ``whole`` as in :func:`law_pieces`.

    With s_k, v_k at the begin ξ_k of a piece of the law, per unit of ξ::

    y(u) = y + drift (x_k − x + u) + h [s_k + v_k u/δ + Σ c_i (u/δ)^(i+2)/((i+1)(i+2))
           + P/ω² (sin φ + ωu/δ cos φ − sin(ωu/δ + φ))],      u from x_k = x + ξ_k δ
    """
    return [_piece(scaled, phase, number, one) for number, one in enumerate(law_pieces(scaled.law, whole))]


def _piece(of: ScaledLaw, phase: int, number: int, one: LawPiece) -> MotionPiece:
    at, begin, piece = of.law.evaluate(one.begin), of.x + one.begin * of.duration, one.piece
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
    found: list[MotionPiece] = []
    for k, (phase, at) in enumerate(zip(motion.phases, motion.ends, strict=True)):
        scaled = ScaledLaw(phase.law, phase.scale, phase.duration, float(motion.edges[k]), at.begin.y)
        found += pieces_of(scaled, k, whole)
    return found


def shares(pieces: Sequence[MotionPiece], begin: float, end: float) -> list[float]:
    """Return where each piece begins, as a share of the whole motion from ``begin`` to ``end``."""
    return [(piece.begin - begin) / (end - begin) for piece in pieces]


class Located(NamedTuple):
    """Where samples lie: which piece (from 0), u from its origin, and the argument ωu + φ of its first sine (rad)."""

    piece: NDArray[np.intp]
    u: Array
    angle: Array


def located(pieces: Sequence[MotionPiece], x: Array, begin: float, end: float) -> Located:
    """Return the piece of each x of a motion from ``begin`` to ``end``: the last that begins at or before it.

    What is nearer to a begin than :data:`BREAK_TOLERANCE` of the whole counts as on it; the end has the left limit.
    """
    reached = np.minimum((x - begin) / (end - begin) + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE)
    k = np.searchsorted(shares(pieces, begin, end), reached, side="right") - 1
    k = np.maximum(k, 0)
    origin, omega, phi = np.array([(piece.origin, *piece.sines[0][1:]) for piece in pieces]).T
    u = x - origin[k]
    return Located(k, u, omega[k] * u + phi[k])


def evaluated(pieces: Sequence[MotionPiece], x: Array, begin: float, end: float) -> MotionValues[Array]:
    """Return y, y', y'', y''' of a table of pieces at x."""
    place, table = located(pieces, x, begin, end), np.empty((4, x.size))
    for k in np.unique(place.piece):
        here = place.piece == k
        table[:, here] = pieces[k].at(place.u[here])
    return MotionValues(*table)


SAME = 1e-12  # of the cycle: breaks so near to each other are one


@dataclass(frozen=True, eq=False)
class CamProfile:
    """y(x) in n pieces, y = Σ c_k u^k + Σ A sin(ωu + φ); outside its range the first and the last piece go on."""

    edges: Array  # n + 1 places in rising order
    origins: Array  # n places from which u counts
    c: Array  # n rows of powers
    sines: Array  # n rows of sines, each A, ω, φ

    @property
    def total(self) -> float:
        """Length of the cycle."""
        return float(self.edges[-1] - self.edges[0])

    @property
    def travel(self) -> float:
        """What a cycle does not come back by, y(end) − y(begin)."""
        begin, end = self.at(self.edges[:1]).y, self.at(self.edges[-1:], left=True).y
        return float(end[0] - begin[0])

    def index(self, x: Array, left: bool = False) -> NDArray[np.intp]:
        """Return the piece at each x: the one that begins there, or with ``left`` the one that ends there."""
        found = np.searchsorted(self.edges, x, side="left" if left else "right") - 1
        return np.clip(found, 0, len(self.origins) - 1)

    def at(self, x: Array, left: bool = False) -> MotionValues[Array]:
        """Return y, y', y'', y''' at x: where it jumps what comes after, or with ``left`` what came before."""
        return MotionValues(*(math.factorial(n) * row for n, row in enumerate(self.taylor(x, self.index(x, left), 4))))

    def taylor(self, x: Array, k: NDArray[np.intp], terms: int) -> Array:
        """Return the first coefficients of y in powers of (x − place), a row a power, about places in pieces k."""
        u, c, sines = x - self.origins[k], self.c[k].T, self.sines[k]
        found = np.zeros((terms, x.size))
        for power in range(min(terms, len(c))):
            value = np.zeros(x.size)
            for higher in range(len(c) - 1, power - 1, -1):
                value = value * u + math.comb(higher, power) * c[higher]
            found[power] = value
        for a, w, phi in np.moveaxis(sines, 1, 0).transpose(0, 2, 1):
            size = a.copy()
            for power in range(terms):
                found[power] += size * np.sin(w * u + phi + power * math.pi / 2.0)
                size = size * w / (power + 1)
        return found


def profile_of(pieces: Sequence[MotionPiece], end: float, x: float = 1.0, y: float = 1.0) -> CamProfile:
    """Return the pieces that last, up to ``end``, as a profile in units of which one of theirs is ``x`` and ``y``."""
    lasting = [one for one in pieces if one.duration > 0.0]
    ends = [*(one.begin for one in lasting[1:]), np.inf]
    kept = [
        one for one, after in zip(lasting, ends, strict=True) if after - one.begin > SAME * abs(end - lasting[0].begin)
    ]
    c = np.array([one.c for one in kept])
    c = c * y / x ** np.arange(c.shape[1])
    sines = np.array([one.sines for one in kept])
    sines[sines[:, :, 0] == 0.0] = 0.0
    sines = sines[:, sines.any(axis=(0, 2))] * [y, 1.0, 1.0] / [1.0, x, 1.0]
    edges = np.array([*(one.begin for one in kept), end])
    last = int(np.flatnonzero(c.any(axis=0)).max(initial=0))
    return CamProfile(edges * x, np.array([one.origin for one in kept]) * x, c[:, : last + 1], sines)


def profile_of_motion(motion: Motion, x: float = 1.0, y: float = 1.0) -> CamProfile:
    """Return a motion as a profile in other units, x and y of them a unit of its own."""
    return profile_of(motion_pieces(motion, whole=True), float(motion.edges[-1]), x, y)


def in_units(values: MotionValues[Real], x: float, y: float) -> MotionValues[Real]:
    """Return a motion's values in other units, of which a unit of x and of y has so many."""
    return MotionValues(*(value * (y / x**order) for order, value in enumerate(values)))


def shifted_profile(of: CamProfile, by: float, travel: float | None = None) -> CamProfile:
    """Return the profile that a master sees which is ``by`` further on where it begins, over the same range.

    What runs over the end of the cycle is parted there, and goes on from the cycle before by its ``travel``, the
    profile's own unless told: a motion whose last law does not end at 1 jumps there to the sum of its lifts. Of more
    than a cycle, each whole one is a travel less.
    """
    begin, end, total = float(of.edges[0]), float(of.edges[-1]), of.total
    travel = of.travel if travel is None else travel
    whole = math.floor(by / total + SAME)
    by -= whole * total
    c = np.concatenate([of.c, of.c])  # of the cycle before, and of this one
    c[:, 0] -= np.repeat([whole + 1, whole], len(of.c)) * travel
    edges, origins = (np.concatenate([one + by - total, one + by]) for one in (of.edges[:-1], of.origins))
    ends = np.append(edges[1:], end + by)
    kept = (ends > begin + SAME * total) & (edges < end - SAME * total)
    edges = np.concatenate([[begin], edges[kept][1:], [end]])
    return CamProfile(edges, origins[kept], c[kept], np.concatenate([of.sines, of.sines])[kept])
