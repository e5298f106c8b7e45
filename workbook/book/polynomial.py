"""Polynomials in cells: coefficients side by side times powers; nine points that integrate them (Gauss, Lobatto)."""

from collections.abc import Iterable
from math import perm

LEAST = 1e-30
NOT_ZERO = "+tiny"
"""the end of a formula of what is raised, :data:`LEAST`: Excel has no 0^0, and so little changes nothing else"""
SHARES = (0.0, 0.0501210022942699, 0.161406860244631, 0.318441268086911, 0.5,
          0.681558731913089, 0.838593139755369, 0.94987899770573, 1.0)  # fmt: skip
WEIGHTS = (0.0138888888888889, 0.0827476807804028, 0.137269356250081, 0.173214255486523, 0.185759637188209,
           0.173214255486523, 0.137269356250081, 0.0827476807804028, 0.0138888888888889)  # fmt: skip
"""where nine points lie in an interval, and what they count in a mean. Source: Abramowitz and Stegun, 25.4.32"""


def polynomial(coefficients: str, x: str, count: int, order: int = 0) -> str:
    """Return the formula, without its =, of a derivative of a polynomial of ``count`` coefficients in a row.

    ``coefficients`` are those from that of x^``order`` on; x is never 0: see :data:`NOT_ZERO`.
    """
    powers = constants(range(count - order))
    factors = f"{constants(perm(k, order) for k in range(order, count))}," if order else ""
    return f"SUMPRODUCT({coefficients},{factors}{x}^{powers})"


def constants(numbers: Iterable[int]) -> str:
    """Return whole numbers as a row of constants in a formula."""
    return f"{{{','.join(map(str, numbers))}}}"
