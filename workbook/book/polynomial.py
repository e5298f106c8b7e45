"""Polynomials in cells: coefficients that stand side by side, times constant factors and powers."""

from collections.abc import Iterable
from math import perm

LEAST = 1e-30
NOT_ZERO = "+tiny"
"""the end of a formula of what is raised, :data:`LEAST`: Excel has no 0^0, and so little changes nothing else"""


def polynomial(coefficients: str, x: str, count: int, order: int = 0) -> str:
    """Return the formula, without its =, of a polynomial or of a derivative of it.

    The polynomial has ``count`` coefficients, side by side in a row; ``coefficients`` are those from that of
    x^``order`` on. x is the place, and never 0: see :data:`NOT_ZERO`. ``order`` is 0 for the polynomial itself.
    """
    powers = constants(range(count - order))
    factors = f"{constants(perm(k, order) for k in range(order, count))}," if order else ""
    return f"SUMPRODUCT({coefficients},{factors}{x}^{powers})"


def constants(numbers: Iterable[int]) -> str:
    """Return whole numbers as a row of constants in a formula."""
    return f"{{{','.join(map(str, numbers))}}}"
