"""All zeros of a polynomial plus sines, by the ladder of its derivatives; extremes of pieces of a law."""

import itertools
import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial

from engine.laws.base import Array, Coefficients, Flags, Real
from engine.laws.piece import Piece, Sine, cut_piece, gains, placed_pieces

STEPS = 100  # of Newton's method, or of halving if a step leaves the bracket: to the last digit
# of a sum, as a share of its terms' sizes; those of a shifted polynomial cancel
ROUNDING = 64 * sys.float_info.epsilon
CELLS = 64  # parts of a half turn in which the sum of two sines is searched, as no derivative of it is simpler


@dataclass(frozen=True)
class Curve:
    """f(u) = Σ c_i uⁱ + Σ P sin(ωu + φ)."""

    c: tuple[float, ...]
    sines: tuple[Sine, ...] = ()

    def __call__(self, u: Real) -> Real:
        """Return f at a number u, or at each of an array."""
        sin: Any = np.sin if isinstance(u, np.ndarray) else math.sin
        value = 0.0 * u
        for c in reversed(self.c):
            value = value * u + c
        for p, w, phi in self.sines:
            value = value + p * sin(w * u + phi)
        return value

    @cached_property
    def slope(self) -> "Curve":
        """F'."""
        c = tuple(i * c for i, c in enumerate(self.c))[1:]
        return Curve(c, tuple((p * w, w, phi + math.pi / 2.0) for p, w, phi in self.sines))

    def root(self, low: float, high: float) -> float:
        """Return the zero between two points of different sign, by Newton's method within them."""
        rises = self(high) > 0.0
        u = 0.5 * (low + high)
        for _ in range(STEPS):
            value, rate = self(u), self.slope(u)
            if value == 0.0:
                break
            low, high = (low, u) if (value > 0.0) == rises else (u, high)
            newton = u - value / rate if rate else low
            following = newton if low < newton < high else 0.5 * (low + high)
            if following in (u, low, high):
                break
            u = following
        return u


def trim(f: Curve) -> Curve:
    """Return a curve without the highest powers that are 0."""
    powers = max((k for k, c in enumerate(f.c, 1) if c), default=0)
    return Curve(f.c[:powers], f.sines)


def zeros(f: Curve, d: float) -> list[float]:
    """Return every u from 0 to d at which f changes its sign, in rising order.

    Between two neighbouring zeros of f' the function is monotone and has at most one zero, so no zero is missed. A
    polynomial of degree n plus a sine takes n + 1 derivatives down to the sine alone, whose zeros are (kπ − φ)/ω.
    The sum of two sines is searched in cells. A value within rounding has no sign: where f only touches zero, inside
    or at an end, its last digit would decide whether there are zeros beside that place.
    """
    f = trim(f)
    if not f.c and len(f.sines) < 2:
        return _of_sine(f.sines[0], d) if f.sines else []
    if f.c:
        points = [0.0, *zeros(f.slope, d), d]
    else:
        cells = CELLS * (1 + int(max(abs(w) for _, w, _ in f.sines) * d / math.pi))
        points = [d * k / cells for k in range(cells + 1)]
    rounding = ROUNDING * (Curve(tuple(map(abs, f.c)))(d) + math.fsum(abs(p) for p, _, _ in f.sines))
    signed = [(u, value > 0.0) for u in points if abs(value := f(u)) > rounding]
    return [f.root(low, high) for (low, before), (high, after) in itertools.pairwise(signed) if before != after]


def _of_sine(sine: Sine, d: float) -> list[float]:
    amplitude, w, phi = sine
    if not amplitude or not w:
        return []
    low, high = sorted((phi / math.pi, (phi + w * d) / math.pi))
    places = ((k * math.pi - phi) / w for k in range(math.ceil(low), math.floor(high) + 1))
    return sorted(min(max(u, 0.0), d) for u in places)


def largest_size(curve: Curve, d: float) -> float:
    """Return the largest absolute value of a curve from 0 to d."""
    return max(abs(curve(u)) for u in (0.0, *zeros(curve.slope, d), d))


PARTS = 256  # of a bracket, in a round


def narrow(positive: Callable[[Array], Flags], low: Array, high: Array, rounds: int) -> Array:
    """Return the points at which a condition changes within brackets.

    An array of 256 samples costs hardly more than a sample, and narrows a bracket as far as eight halvings. If the
    condition changes more than once in a bracket, the first change among its samples counts.

    Parameters
    ----------
    positive : callable
        The condition: it takes and returns arrays of shape (n,), and differs at the ends of each bracket.
    low, high : array (n,), any unit
        The ends of the brackets.
    rounds : int
        Each narrows a bracket to a 256th.

    Returns
    -------
    array (n,)
        The middles of the brackets that are left.
    """
    share = np.linspace(0.0, 1.0, PARTS + 1)
    each = np.arange(low.size)
    for _ in range(rounds):
        points = low[:, None] + (high - low)[:, None] * share
        above = positive(points.ravel()).reshape(points.shape)
        changed = above != above[:, :1]
        changed[:, -1] = True  # also where rounding hides it
        at = changed.argmax(axis=1)
        low, high = points[each, at - 1], points[each, at]
    return 0.5 * (low + high)


POWER_CELLS = 512  # least number of parts of a piece with sines in which its power v·a is searched for extremes
ROUNDS = 4  # of narrowing a cell: a stationary value is then right to the last digit
JUMP = 1e-9  # share of the largest acceleration: a smaller jump is rounding
EDGE = 1e-7  # share of a piece: a peak that is nearer to its end counts as the end
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)  # of Gauss and Legendre, on [−1, 1]


def acceleration(piece: Piece) -> Curve:
    """Return a(u) of a piece as a curve of the least degree; a sine of ω = 0 becomes part of the constant."""
    still = math.fsum(p * math.sin(phi) for p, w, phi in piece.sines if w == 0.0)
    return trim(Curve((piece.c[0] + still, *piece.c[1:]), tuple(sine for sine in piece.sines if sine[1])))


def stationary_power_points(piece: Piece, v0: float) -> list[float]:
    """Return every u at which v·a of a piece is stationary, ``v0`` its velocity at the begin.

    Zeros of a polynomial's slope are exact. In a piece with sines the slope a² + v j is sampled for changes of sign.
    """
    a = acceleration(piece)
    if not a.sines:
        p = Polynomial(a.c or (0.0,))
        return zeros(Curve(tuple((p * p.integ(k=v0)).deriv().coef.tolist())), piece.duration)
    row = np.array(piece.row)[:, None]

    def rises(u: Array) -> Flags:
        _, v, a, j = gains(u, row)
        return np.asarray(a * a + (v0 + v) * j >= 0.0)

    cells = POWER_CELLS + int(max(abs(w) for _, w, _ in a.sines) * piece.duration * 16.0)
    grid = np.linspace(0.0, piece.duration, cells + 1)
    up = rises(grid)
    at = np.flatnonzero(up[1:] != up[:-1])
    return [float(u) for u in narrow(rises, grid[at], grid[at + 1], ROUNDS)]


def stationary_points(piece: Piece) -> list[float]:
    """Return every u at which v, a or j of a piece is stationary, in no order."""
    a = acceleration(piece)
    return [u for f in (a, a.slope, a.slope.slope) for u in zeros(f, piece.duration)]


def at_peaks(piece: Piece) -> list[Piece]:
    """Return the parts of a piece, cut where its acceleration is largest or lowest."""
    d = piece.duration
    peaks = [u / d for u in zeros(acceleration(piece).slope, d)] if d else []
    return cut_piece(piece, [share for share in peaks if EDGE < share < 1.0 - EDGE])


def turning_points(piece: Piece, v0: float) -> list[float]:
    """Return every u at which the velocity of a piece changes its sign, ``v0`` being that at its begin."""
    a = acceleration(piece)
    still = v0 + math.fsum(p / w * math.cos(phi) for p, w, phi in a.sines)
    turned = tuple((-p / w, w, phi + math.pi / 2.0) for p, w, phi in a.sines)
    return zeros(Curve((still, *(c / (i + 1) for i, c in enumerate(a.c))), turned), piece.duration)


def values_by_piece(
    pieces: Sequence[Piece], v0: float, inside: Callable[[Piece, float], Sequence[float]]
) -> list[tuple[Array, Array, Array, Array]]:
    """Return s, v, a, j of each piece of any duration at its begin, at the u of ``inside(piece, v)``, at its end."""
    values = []
    for placed in placed_pieces(pieces, v0):
        if placed.piece.duration > 0.0:
            u = np.array([0.0, *inside(placed.piece, placed.v), placed.piece.duration])
            s, v, a, j = gains(u, np.array(placed.piece.row)[:, None])
            values.append((placed.s + placed.v * u + s, placed.v + v, a, j))
    return values


@lru_cache(maxsize=1_000)
def coefficients_of(pieces: tuple[Piece, ...], v0: float = 0.0, a0: float = 0.0, a1: float = 0.0) -> Coefficients:
    """Return the coefficients of consecutive pieces, for unit rise and time.

    Parameters
    ----------
    pieces : tuple of Piece
        In order, from ξ = 0.
    v0 : float, dimensionless
        Velocity at the begin of the first piece.
    a0, a1 : float, dimensionless
        Acceleration before the pieces and after them.

    Returns
    -------
    Coefficients
        C_j is infinite if a jumps between pieces of any duration, or at either end.
    """
    values = values_by_piece(pieces, v0, lambda piece, v: stationary_points(piece) + stationary_power_points(piece, v))
    _, v, a, j = np.concatenate(values, axis=1)
    before = np.array([a0, *(accelerations[-1] for _, _, accelerations, _ in values)])
    after = np.array([*(accelerations[0] for _, _, accelerations, _ in values), a1])
    jumps = np.abs(before - after).max() > JUMP * np.abs(a).max()
    return Coefficients(
        cv=float(np.abs(v).max()),
        ca_max=float(a.max()),
        ca_min=float(a.min()),
        ca_rms=math.sqrt(math.fsum(square_integral(piece) for piece in pieces if piece.duration > 0.0)),
        cj=math.inf if jumps else float(np.abs(j).max()),
        va_max=float((v * a).max()),
        va_min=float((v * a).min()),
    )


def square_integral(piece: Piece) -> float:
    """Return ∫a² du over a piece by Gauss-Legendre on parts of at most half a turn of ωu; exact for a polynomial."""
    fastest = max((abs(w) for _, w, _ in piece.sines), default=0.0)
    parts = 1 + int(fastest * piece.duration / math.pi)
    width = piece.duration / parts
    u = (np.arange(parts)[:, None] + (NODES + 1.0) / 2.0).ravel() * width
    a = gains(u, np.array(piece.row)[:, None])[2]
    return float(np.tile(WEIGHTS, parts) @ (a * a)) * width / 2.0


@lru_cache(maxsize=1_000)
def reach_of(pieces: tuple[Piece, ...], v0: float) -> tuple[float, float]:
    """Return the lowest and the highest position of consecutive pieces, from s = 0 with the velocity ``v0``."""
    s = np.concatenate([positions for positions, *_ in values_by_piece(pieces, v0, turning_points)])
    return float(s.min()), float(s.max())
