"""Symmetric polynomials by their halves, and polynomials between prescribed ends."""

from __future__ import annotations

from typing import Sequence

from .piece import Piece


def half(c: Sequence[float], d: float) -> Piece:
    """Return a half from rest that lasts ``d``: it gains the velocity of the whole and rises by ``d``."""
    return Piece(d, **{f"c{i}": 2.0 * value / d ** (i + 1) for i, value in enumerate(c)})


def hermite(meets: int, ends: Sequence[float]) -> Piece:
    """Return the polynomial that meets one, two or three derivatives at ends: lift, v0, v1, a0, a1, j0, j1.

    With H, V, A what the begin's own y, v, a, j leave to be done at the end, the remaining powers of s are found by
    Newton's divided differences at a double, triple or fourfold end.
    """
    lift, v0, v1, a0, a1, j0, j1 = ends
    if meets == 1:
        return Piece(1.0, **_powers((0.0, v0), (lift - v0, v1 - v0)))
    if meets == 2:
        left = (lift - v0 - a0 / 2, v1 - v0 - a0, (a1 - a0) / 2)
        return Piece(1.0, **_powers((0.0, v0, a0 / 2), left))
    h, w = lift - v0 - a0 / 2 - j0 / 6, v1 - v0 - a0 - j0 / 2
    return Piece(1.0, **_powers((0.0, v0, a0 / 2, j0 / 6), (h, w, (a1 - a0 - j0) / 2, (j1 - j0) / 6)))


def _powers(begin: Sequence[float], left: Sequence[float]) -> dict[str, float]:
    """Return c0, c1, … of s = Σ begin_i ξ^i + ξⁿ Σ b_k (ξ − 1)^k; ``left`` are Taylor's coefficients of the rest at 1.

    As ξ⁻ⁿ has Taylor's coefficients (−1)^k C(n + k − 1, k) at 1, b is the product of both series.
    """
    n = len(begin)
    inverse = [1.0]
    for k in range(1, n):
        inverse.append(-inverse[-1] * (n + k - 1) / k)
    b = [sum(left[i] * inverse[k - i] for i in range(k + 1)) for k in range(n)]
    rest = [0.0] * n
    for value in b[::-1]:  # Horner's scheme in ξ − 1
        rest = [before - here for before, here in zip([0.0, *rest[:-1]], rest)]
        rest[0] += value
    s = [*begin, *rest]
    return {f"c{i - 2}": i * (i - 1) * s[i] for i in range(2, 2 * n)}
