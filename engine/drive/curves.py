"""Forces within a piece of a motion as curves, powers of u and sines, and where they change their sign. SI units."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from engine.drive.search import NOISE
from engine.drive.train import Force
from engine.laws.base import Array
from engine.laws.ladder import Curve, root, zeros
from engine.motion.pieces import MotionPiece


def position(piece: MotionPiece) -> Curve:
    """Return y of a piece as a curve over u."""
    return Curve(piece.c, tuple(sine for sine in piece.sines if sine[0]))


def evaluated(curve: Curve, u: Array) -> Array:
    """Return the values of a curve."""
    value = np.zeros(u.shape)
    for c in reversed(trimmed(curve).c):
        value = value * u + c
    for p, w, phi in curve.sines:
        value = value + p * np.sin(w * u + phi)
    return value


def force_curve(
    piece: MotionPiece, speed: float, force: Force, share: float = 1.0, inertia: float = 0.0, more: float = 0.0
) -> Curve:
    """Return ``share`` · F + ``inertia`` · ÿ + ``more`` as a curve over u."""
    velocity = position(piece).derivative()
    acceleration = velocity.derivative()
    level, c = share * force.level + more, share * force.viscous * speed
    m = (share * force.mass + inertia) * speed**2
    both = [*(m * c2 for c2 in acceleration.c), 0.0]
    polynomial = [c * c1 + other for c1, other in zip(velocity.c, both, strict=True)]
    polynomial[0] += level
    sines = [(m * p, w, phi) for p, w, phi in acceleration.sines]
    sines += [(c * p, w, phi) for p, w, phi in velocity.sines] if c else []
    return trimmed(Curve(tuple(polynomial), tuple(_joined(sines))))


def _joined(sines: Sequence[tuple[float, float, float]]) -> Iterator[tuple[float, float, float]]:
    """Yield sines with those of one ω added up."""
    for w in dict.fromkeys(w for _, w, _ in sines):
        one = sum(p * np.exp(1j * phi) for p, other, phi in sines if other == w)
        yield float(abs(one)), w, float(np.angle(one))


def trimmed(curve: Curve) -> Curve:
    """Return a curve without powers that are 0, but for the constant: so that no sine stands alone."""
    c = list(curve.c)
    while len(c) > 1 and not c[-1]:
        c.pop()
    return Curve(tuple(c) or (0.0,), curve.sines)


def sign_changes(curve: Curve, low: float, high: float) -> list[float]:
    """Return where a curve changes its sign between two points, from values that are no rounding on either side.

    Between the zeros of its derivative, and so none is missed.
    """
    f = trimmed(curve)
    slope = trimmed(f.derivative())
    turns = [u for u in zeros(slope, high) if low < u < high]
    points = [low, *turns, high]
    values = [f(u) for u in points]
    noise = NOISE * max(map(abs, values))
    kept = [(u, value) for u, value in zip(points, values, strict=True) if abs(value) > noise]
    return [root(f, slope, one[0], other[0]) for one, other in pairwise(kept) if (one[1] > 0.0) != (other[1] > 0.0)]


def largest_size(curve: Curve, d: float) -> float:
    """Return the largest size of a curve from 0 to d."""
    f = trimmed(curve)
    return max(abs(f(u)) for u in (0.0, *zeros(trimmed(f.derivative()), d), d))
