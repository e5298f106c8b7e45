"""Symmetric polynomials by their halves, and polynomials between prescribed ends."""

from __future__ import annotations

from typing import Sequence

from .piece import Piece

POLYNOMIALS = {"CUB": 1, "PO5": 2, "PO7": 3}
"""laws that are polynomials, with how many derivatives can be prescribed at their ends"""
HALF = {"CUB": (1.5, -1.5), "PO5": (0.0, 7.5, -11.25, 3.75), "PO7": (0.0, 0.0, 26.25, -52.5, 32.8125, -6.5625)}
"""the acceleration of the first half per power of u/λ, over 1/λ and twice"""


def halves(code: str, share: float) -> tuple[Piece, Piece]:
    """Return the half that begins the law, and the other as seen backwards from its end."""
    return half(code, share), half(code, 1.0 - share)


def half(code: str, d: float) -> Piece:
    """Return a half from rest that lasts ``d``: it gains the velocity of the whole and rises by ``d``."""
    c = {f"c{i}": 2.0 * value / d ** (i + 1) for i, value in enumerate(HALF[code])}
    return Piece(d)._replace(**c)


def hermite(code: str, ends: Sequence[float]) -> Piece:
    """Return the polynomial of the law's degree between ends: lift, v0, v1, a0, a1, j0, j1.

    With H, V, A what the begin's own y, v, a, j leave to be done at the end, the remaining powers of s are found by
    Newton's divided differences at a double, triple or fourfold end.
    """
    lift, v0, v1, a0, a1, j0, j1 = ends
    if code == "CUB":
        return Piece(1.0)._replace(**_powers((0.0, v0), (lift - v0, v1 - v0)))
    if code == "PO5":
        left = (lift - v0 - a0 / 2, v1 - v0 - a0, (a1 - a0) / 2)
        return Piece(1.0)._replace(**_powers((0.0, v0, a0 / 2), left))
    h, w = lift - v0 - a0 / 2 - j0 / 6, v1 - v0 - a0 - j0 / 2
    return Piece(1.0)._replace(**_powers((0.0, v0, a0 / 2, j0 / 6), (h, w, (a1 - a0 - j0) / 2, (j1 - j0) / 6)))


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
