"""Parameters with the least deviations, by the method of Gauss and Newton."""

from collections.abc import Callable

import numpy as np

from engine.laws.base import Array

TURNS = 12  # iterations of Gauss and Newton
# in so many iterations the residual must fall to this share, else the law is another
SETTLED, SLOW = 3, 0.5
STEP = 1e-4  # share of the interval between points, for derivatives of the deviations by the place of a break


def gauss_newton(off: Callable[[Array], Array], fit: Array, steps: Array, near: float) -> Array | None:
    """Return parameters with small deviations, by the method of Gauss and Newton.

    Parameters
    ----------
    off : callable
        The deviations, array (n,), by the parameters, array (k,).
    fit, steps : array (k,)
        Parameters to begin with, and by how much an iteration may move each; without a limit infinite.
    near : float, unit of the deviations
        Largest deviation allowed.

    Returns
    -------
    array (k,) or None
        None where the deviations do not become so small, or fall too slowly.
    """
    missed: list[float] = []
    moves = np.diag(np.where(np.isfinite(steps), STEP * steps, 1.0))
    for _ in range(TURNS + 1):
        here = off(fit)
        missed.append(float(np.abs(here).max()))
        if missed[-1] <= near:
            return fit
        slow = len(missed) > SETTLED and missed[-1] > SLOW * missed[-SETTLED]
        if slow or not fit.size or not np.isfinite(missed[-1]):
            return None
        slopes = np.column_stack([(off(fit + move) - here) / move.sum() for move in moves])
        if not np.all(np.isfinite(slopes)):
            return None
        by = np.linalg.lstsq(slopes, -here, rcond=1e-12)[0]
        fit = fit + np.clip(by, -steps, steps)
    return None
