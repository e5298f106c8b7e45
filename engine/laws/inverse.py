"""The inverse ξ(s) of a law, exact and by points; its fastest instant; its continuity at the joints of its pieces."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array, Real, require_within, unwrap
from engine.laws.extremes import acceleration, zeros
from engine.laws.family import Law
from engine.laws.piece import Piece, PlacedPiece, begins, gains, placed_pieces

KNOTS = 65  # points of each stage, between which a height is first located
STEPS = 120  # of Newton's method, at most
LAST_DIGITS = 4e-16  # of ξ: smaller steps come from the rounding of s
BACKWARDS = 1e-9  # share of the mean velocity: a law that is slower than minus this moves backwards
INSIDE = 1e-9  # share of a stage: a place nearer to its end counts as the end


def breaks(law: Law) -> Array:
    """Return every ξ at which the law's formula changes, with 0 and 1, rising."""
    edges = [0.0]
    for xi in law.breaks:
        if edges[-1] + INSIDE < xi < 1.0 - INSIDE:
            edges.append(xi)
    return np.array([*edges, 1.0])


def velocity_extremes(law: Law) -> Array:
    """Return every ξ at which v can be largest or smallest, with 0 and 1, rising."""
    pieces, turns = law.as_pieces(), []
    for piece, begin in zip(pieces, begins(pieces), strict=True):
        d = piece.duration
        turns += [begin + u for u in zeros(acceleration(piece), d) if INSIDE * d < u < (1.0 - INSIDE) * d]
    return np.union1d(breaks(law), turns)


def velocity_peak(law: Law) -> float:
    """Return the first ξ at which v is largest; the begin of a stage at constant velocity."""
    xi = velocity_extremes(law)
    v = law.v(xi)
    return float(xi[np.argmax(v >= v.max() - 1e-12 * abs(v.max()))])


@lru_cache(maxsize=256)
def is_monotone(law: Law) -> bool:
    """Return whether the law never moves backwards."""
    return bool(law.v(velocity_extremes(law)).min() >= -BACKWARDS)


def inverse(law: Law, s: Real) -> Real:
    """Return ξ with s(ξ) = s, by Newton's method between two bounds that close in, to the last digits of s.

    The positions s, of any shape, are in units of the lift; where the law rests at s it is the first ξ. Its error is
    that of s over the velocity v(ξ). Raises ValueError for a law that moves backwards or dwells, and outside 0 to s(1).
    Source: S2, 'Cycloid Cam Profile Analysis', which reads the inverse from a table (38 % of the rise at 44 %).
    """
    wanted = np.asarray(s, dtype=np.float64)
    flat = wanted.reshape(-1)
    end = law.end.s
    if end <= 0.0 or not is_monotone(law):
        raise ValueError(f"{law.name} does not rise throughout; expected a law that never moves backwards")
    require_within(0.0, end, s=flat)
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


def law_pieces(law: Law, whole: bool = False) -> list[PlacedPiece]:
    """Return the pieces of a law that begin before its end, cut at peaks of the acceleration unless ``whole``."""
    pieces = law.as_pieces() if whole else law.monotone_pieces()
    placed = placed_pieces(pieces, law.entry_velocity)
    return [place for place in placed if place.begin <= 1.0 - BREAK_TOLERANCE]


INTERVALS = 96  # between points, at most
HEIGHT = 1e-6  # of the rise: error in height of the inverse by points
REST = 1e-5  # share of the mean velocity: next to a slower point the inverse is not corrected


class InversionPoints(NamedTuple):
    """Points of a law between which it is inverted: arrays of shape (INTERVALS + 1,); spare rows repeat ξ = 1."""

    n: int  # intervals on each piece
    piece: Array  # number of the piece, from 1
    share: Array  # of the piece's duration, 0 to 1
    xi: Array  # ξ of the point
    s: Array  # position there
    v: Array  # velocity there


@lru_cache(maxsize=256)
def inversion_points(law: Law) -> InversionPoints:
    """Return the points of a law, n on each of its monotone pieces: the i-th at the share (1 − cos(πi/n))/2 of it."""
    pieces = law_pieces(law)
    n, k = INTERVALS // len(pieces), np.arange(INTERVALS + 1)
    piece = np.minimum(k // n + 1, len(pieces))
    share = np.where(k >= n * len(pieces), 1.0, (1.0 - np.cos(np.pi * (k % n) / n)) / 2.0)
    begins, durations = (np.array(each) for each in zip(*((p.begin, p.piece.duration) for p in pieces), strict=True))
    xi = np.minimum(begins[piece - 1] + share * durations[piece - 1], 1.0)
    motion = law.evaluate(xi)
    return InversionPoints(n, piece.astype(float), share, xi, motion.s, motion.v)


class PointInversion(NamedTuple):
    """Steps of the inverse by points, for heights: arrays of the heights' shape."""

    heights: Array  # s, 0 to 1
    point: Array  # number of the last point that is not above the height, from 1
    low: InversionPoints  # that point
    high: InversionPoints  # the next point
    over: Array  # height above the lower point
    acceleration: Array  # taken as constant between the two points
    near: Array  # ξ by this acceleration
    s: Array  # the law's position at ``near``
    v: Array  # the law's velocity there
    correction: Array  # of ξ: (height − s)/v; 0 beside a point at rest

    @property
    def xi(self) -> Array:
        """ξ of each height, corrected; exact at the heights 0 and 1."""
        inner = (self.heights > 0.0) & (self.heights < 1.0)
        return np.where(inner, self.near + self.correction, self.heights)


def point_inversion(law: Law, heights: Array) -> PointInversion:
    """Return when a law reaches heights: u = 2Δs/(v + √(v² + 2aΔs)) after a point, then a step of Newton's method."""
    points = inversion_points(law)
    reached = np.minimum(heights + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE)
    k = np.searchsorted(points.s, reached, side="right") - 1
    low, high = (points._replace(xi=points.xi[i], s=points.s[i], v=points.v[i]) for i in (k, k + 1))
    d, over = high.xi - low.xi, heights - low.s
    a = 2.0 * (high.s - low.s - low.v * d) / d**2
    on_low, on_high = over <= BREAK_TOLERANCE, heights >= high.s - BREAK_TOLERANCE
    inside = ~(on_low | on_high)
    root = np.sqrt(low.v**2 + 2.0 * a * over, out=np.ones_like(over), where=inside)
    near = np.select([on_low, on_high], [low.xi, high.xi], low.xi + 2.0 * over / (low.v + root))
    motion = law.evaluate(near)
    moving = np.minimum(low.v, high.v) > REST
    correction = np.divide(heights - motion.s, motion.v, out=np.zeros_like(over), where=moving)
    return PointInversion(heights, (k + 1).astype(float), low, high, over, a, near, motion.s, motion.v, correction)


def inverse_by_points(law: Law, heights: Array) -> Array:
    """Return ξ at which a law reaches heights, by its points: to :data:`HEIGHT` of the rise."""
    return point_inversion(law, heights).xi


JUMP = 1e-9  # of C_v for a jump of v, of C_a for a jump of a or j: a smaller jump is rounding
SMOOTH = 3  # order of the highest derivative of s that is examined: v, a and j
DERIVATIVES = ("position", "velocity", "acceleration", "jerk")  # names of s and its derivatives
Rates = tuple[float, ...]  # v, a, j


class LawJoint(NamedTuple):
    """The joint at which a piece of a law, or the rest after the law, begins."""

    duration: float  # d of the piece, in units of ξ
    angles: tuple[float, float]  # ωd + φ of both sines at the end of the piece (rad)
    begin: Rates  # v, a, j of the piece at the joint
    end: Rates  # v, a, j at the end of the piece
    before: int  # number of the last piece of any duration before it, from 1; 0 is rest
    jump: Rates  # of v, a, j at the joint
    order: int  # of the highest continuous derivative of s, up to 3; 3 for a piece without duration
    outer: bool  # whether the joint is an end of the law


def law_joints(law: Law, pieces: Sequence[Piece]) -> tuple[LawJoint, ...]:
    """Return the joints at which each of a law's pieces begins, and the rest after the last, of duration 1."""
    joints: list[LawJoint] = []
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
        joints.append(LawJoint(piece.duration, angles, begin, end, before, jump, order, outer))
        if lasts:
            before, ended = k, end
    return tuple(joints)


def continuity(joints: Sequence[LawJoint]) -> tuple[int, int]:
    """Return the order of a law's highest continuous derivative of s, up to 3: at its ends next to rest, and inside."""
    ends = min([SMOOTH, *(joint.order for joint in joints if joint.outer)])
    inside = min([SMOOTH, *(joint.order for joint in joints if not joint.outer)])
    return ends, inside


def joint_code(number: int, joint: LawJoint) -> int:
    """Return a number for law, end and order of a joint: 8 · number of the law + 4 at an end + order."""
    return 8 * number + 4 * joint.outer + joint.order
