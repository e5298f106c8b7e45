"""What is asked of a law: when it has reached a share of its rise, where it is fastest, how smooth it is."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, ROUNDING, Array, Real, require_within, unwrap
from engine.laws.family import Law
from engine.laws.ladder import acceleration, zeros
from engine.laws.piece import Piece, begins, gains, placed_pieces

KNOTS = 65  # a stage, between which a height is first located
STEPS = 120
LAST_DIGITS = 4e-16  # of ξ: within them rounding of s turns the steps to and fro
BACKWARDS = 1e-9  # a velocity below minus this, in units of the mean velocity, is a motion backwards
INSIDE = 1e-9  # of a stage: what is nearer to its end is at it


def breaks(law: Law) -> Array:
    """Return every ξ at which the law's formula changes, with 0 and 1, rising."""
    kept = [0.0]
    for xi in law.breaks:
        if kept[-1] + INSIDE < xi < 1.0 - INSIDE:
            kept.append(xi)
    return np.array([*kept, 1.0])


def velocity_extremes(law: Law) -> Array:
    """Return every ξ at which v can be largest or smallest, with 0 and 1, rising."""
    pieces, turns = law.as_pieces(), []
    for piece, begin in zip(pieces, begins(pieces), strict=True):
        d = piece.duration
        turns += [begin + u for u in zeros(acceleration(piece), d) if INSIDE * d < u < (1.0 - INSIDE) * d]
    return np.union1d(breaks(law), turns)


def velocity_peak(law: Law) -> float:
    """Return the first ξ at which v is at its largest; of a uniform stage, its begin."""
    xi = velocity_extremes(law)
    v = law.v(xi)
    return float(xi[np.argmax(v >= v.max() - 1e-12 * abs(v.max()))])


@lru_cache(maxsize=256)
def is_monotone(law: Law) -> bool:
    """Whether the law never moves backwards."""
    return bool(law.v(velocity_extremes(law)).min() >= -BACKWARDS)


def inverse(law: Law, s: Real) -> Real:
    """Return ξ with s(ξ) = s, for any law that never moves backwards: a float of a number, an array of an array.

    Newton's method between two bounds that close in, to the last digits of s: the error of ξ is that of s
    over the velocity v(ξ). Where the law stands at s, the first such ξ; the end values give 0 and 1.
    Raises ValueError where s is not a number from 0 to the law's end value, for a law that moves backwards
    and for a dwell. Replaces the reading of a table in S2, 'Cycloid Cam Profile Analysis' (38 % at 44 %).
    """
    wanted = np.asarray(s, dtype=np.float64)
    flat = wanted.reshape(-1)
    end = law.end.s
    if end <= 0.0 or not is_monotone(law):
        raise ValueError(f"{law.name} does not rise throughout; expected a law that never moves backwards")
    require_within("s", flat, 0.0, end, ROUNDING)
    xi = np.where(flat <= 0.0, 0.0, 1.0)
    inside = (flat > 0.0) & (flat < end)
    if inside.any():
        xi[inside] = _solve(law, flat[inside])
    return unwrap(s, [xi.reshape(wanted.shape)])[0]  # type: ignore[no-any-return]


def _solve(law: Law, s: Array) -> Array:
    edges = breaks(law)
    knots = np.unique(edges[:-1, None] + np.diff(edges)[:, None] * np.linspace(0.0, 1.0, KNOTS))
    above = np.clip(np.searchsorted(np.maximum.accumulate(law.s(knots)), s), 1, knots.size - 1)
    low, high = knots[above - 1], knots[above]
    xi = 0.5 * (low + high)
    for _ in range(STEPS):
        at = law.evaluate(xi)
        over = at.s >= s
        low, high = np.where(over, low, xi), np.where(over, xi, high)
        step = np.divide(at.s - s, at.v, out=np.full_like(xi, np.inf), where=at.v > 0.0)
        newton = xi - step
        following = np.where((newton >= low) & (newton <= high), newton, 0.5 * (low + high))
        moved = np.abs(following - xi).max()
        xi = following
        if moved <= LAST_DIGITS:
            break
    return xi


class LawPiece(NamedTuple):
    """A piece of a law, and the ξ at which it begins."""

    piece: Piece
    begin: float


def law_pieces(law: Law, whole: bool = False) -> list[LawPiece]:
    """Return the pieces of a law that begin before its end: monotone ones, or ``whole``, not cut at peaks."""
    pieces = law.as_pieces() if whole else law.monotone_pieces()
    found = [LawPiece(*both) for both in zip(pieces, begins(pieces), strict=True)]
    return [one for one in found if one.begin <= 1.0 - BREAK_TOLERANCE]


INTERVALS = 96  # between points, at most
HEIGHT = 1e-6  # of the rise: how near to a height the law is at the time found
REST = 1e-5  # a velocity below this, in units of the mean velocity, is too slow for a correction


class InversionPoints(NamedTuple):
    """Points of a law: arrays of the length INTERVALS + 1; spare ones are its end."""

    n: int  # intervals on each piece
    piece: Array  # number of the piece, from 1
    share: Array  # of the piece's duration
    xi: Array
    s: Array
    v: Array


@lru_cache(maxsize=256)
def inversion_points(law: Law) -> InversionPoints:
    """Return the points of a law, as many on each of its pieces: of n, the i-th at the share (1 − cos(πi/n))/2."""
    pieces = law_pieces(law)
    n, k = INTERVALS // len(pieces), np.arange(INTERVALS + 1)
    piece = np.minimum(k // n + 1, len(pieces))
    share = np.where(k >= n * len(pieces), 1.0, (1.0 - np.cos(np.pi * (k % n) / n)) / 2.0)
    begins, durations = (np.array(each) for each in zip(*((p.begin, p.piece.duration) for p in pieces), strict=True))
    xi = np.minimum(begins[piece - 1] + share * durations[piece - 1], 1.0)
    found = law.evaluate(xi)
    return InversionPoints(n, piece.astype(float), share, xi, found.s, found.v)


class PointInversion(NamedTuple):
    """Between which points heights lie, and the share of time of each: arrays."""

    heights: Array
    point: Array  # the last point that is not above, from 1
    low: InversionPoints  # that point
    high: InversionPoints  # and the next
    over: Array  # of the height over that of the lower point
    acceleration: Array  # as if it were constant from one to the other
    near: Array  # the share of time by it
    s: Array  # height there
    v: Array  # velocity there
    correction: Array  # what is missing of the height over the velocity there; 0 beside a point at rest

    @property
    def xi(self) -> Array:
        """The share of time; that of heights 0 and 1 is exact."""
        inner = (self.heights > 0.0) & (self.heights < 1.0)
        return np.where(inner, self.near + self.correction, self.heights)


def point_inversion(law: Law, heights: Array) -> PointInversion:
    """Return where a law reaches heights: u = 2Δs/(v + √(v² + 2aΔs)) between points, then what is missing over v."""
    points = inversion_points(law)
    k = np.searchsorted(points.s, np.minimum(heights + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE), side="right") - 1
    low, high = (points._replace(xi=points.xi[i], s=points.s[i], v=points.v[i]) for i in (k, k + 1))
    d, over = high.xi - low.xi, heights - low.s
    a = 2.0 * (high.s - low.s - low.v * d) / d**2
    on_low, on_high = over <= BREAK_TOLERANCE, heights >= high.s - BREAK_TOLERANCE
    inside = ~(on_low | on_high)
    root = np.sqrt(low.v**2 + 2.0 * a * over, out=np.ones_like(over), where=inside)
    near = np.select([on_low, on_high], [low.xi, high.xi], low.xi + 2.0 * over / (low.v + root))
    found = law.evaluate(near)
    moving = np.minimum(low.v, high.v) > REST
    correction = np.divide(heights - found.s, found.v, out=np.zeros_like(over), where=moving)
    return PointInversion(heights, (k + 1).astype(float), low, high, over, a, near, found.s, found.v, correction)


def inverse_by_points(law: Law, heights: Array) -> Array:
    """Return the shares of time at which a law has reached heights, by its points: :data:`HEIGHT` off in height."""
    return point_inversion(law, heights).xi


JUMP = 1e-9  # of the law's C_v, of a and j of its C_a: a smaller jump is rounding
SMOOTH = 3  # derivatives of s that are looked at: v, a and j
DERIVATIVES = ("position", "velocity", "acceleration", "jerk")  # names of s and its derivatives
Rates = tuple[float, ...]  # v, a, j


class LawJoint(NamedTuple):
    """The begin of a piece of a law, or of the rest behind it."""

    duration: float  # d, of the piece
    angles: tuple[float, float]  # ωd + φ of both sines, at its end
    begin: Rates  # rates there
    end: Rates  # and at its end
    before: int  # the last piece before it that lasts, from 1; 0 is rest
    jump: Rates  # of the rates
    order: int  # the highest continuous derivative of s, up to 3; 3 of a piece that does not last
    outer: bool  # at an end of the law


def law_joints(law: Law, pieces: Sequence[Piece]) -> tuple[LawJoint, ...]:
    """Return where each of a law's pieces begins, and the rest behind the last one, which lasts 1."""
    found: list[LawJoint] = []
    scales = law.coefficients.cv, law.coefficients.ca, law.coefficients.ca
    before, ended = 0, (0.0, 0.0, 0.0)
    for k, (piece, _, _, v, _, dv) in enumerate(placed_pieces((*pieces, Piece(1.0)), law.start.v), 1):
        behind, lasts = k > len(pieces), piece.duration > 0.0
        _, _, a, j = (x.tolist() for x in gains(np.array([0.0, piece.duration]), np.array(piece.row)[:, None]))
        begin, end = ((0.0,) * 3, (0.0,) * 3) if behind else ((v, a[0], j[0]), (v + dv, a[1], j[1]))
        jump = tuple(y - x for x, y in zip(ended, begin, strict=True)) if lasts else (0.0, 0.0, 0.0)
        jumps = (abs(size) > JUMP * scale for size, scale in zip(jump, scales, strict=True))
        order = next((n for n, jumped in enumerate(jumps) if jumped), SMOOTH)
        angles = piece.omega * piece.duration + piece.phase, piece.omega2 * piece.duration + piece.phase2
        outer = lasts and (behind or before == 0)
        found.append(LawJoint(piece.duration, angles, begin, end, before, jump, order, outer))
        if lasts:
            before, ended = k, end
    return tuple(found)


def continuity(law: Law) -> tuple[int, int]:
    """Return the highest derivative of s that is continuous, up to 3: at the ends against rest, and between them."""
    found = law_joints(law, law.as_pieces())
    ends, inside = (min([SMOOTH, *(one.order for one in found if one.outer == outer)]) for outer in (True, False))
    return ends, inside


def joint_code(number: int, one: LawJoint) -> int:
    """Return what tells law, end and order of a meeting in one number: 8 · number + 4 at an end + order."""
    return 8 * number + 4 * one.outer + one.order
