"""SciPy as another hand: its Hermite polynomials are ours."""

import numpy as np
import pytest
from scipy.interpolate import BPoly

from engine import law
from engine.cams.certificate import equal_steps, spread
from engine.cams.interpolation import hermite, parabolas, quintics
from engine.motion import Motion, Phase
from engine.motion.profile import profile_of_motion

REST = law("dwell")
PHASES = ((law("MTP"), 30.0, 70.0), (REST, 0.0, 40.0), (law("polynomial 4-5-6-7"), -30.0, 150.0), (REST, 0.0, 100.0))
OF = profile_of_motion(Motion([Phase(*one) for one in PHASES]))
DENSE = 100


def dense(x: np.ndarray) -> np.ndarray:
    return (x[:-1, None] + np.diff(x)[:, None] * np.linspace(1e-7, 1.0 - 1e-7, DENSE)).ravel()


def compared(x: np.ndarray, ours, theirs) -> None:
    """Values of four orders agree at dense points."""
    at = dense(np.unique(np.concatenate([x, OF.edges])))
    for order, mine in enumerate(ours.at(at)):
        other = theirs(at, order)
        rounding = 2e-12 / float(np.diff(x).min()) ** order  # of positions of 30, over the shortest step
        assert np.abs(mine - other).max() <= 1e-9 * max(float(np.abs(other).max()), 1e-12) + rounding, order


@pytest.mark.parametrize("n", [20, 60, 300])
def test_quintics_are_scipys(n: int) -> None:
    x = spread(OF, n, 6, np.ones(len(OF.origins), dtype=np.intp), np.zeros(len(OF.origins), dtype=bool))
    at = OF.at(x)
    theirs = BPoly.from_derivatives(x, np.column_stack([at.y, at.y1, at.y2]))
    compared(x, quintics(x, at.y, at.y1, at.y2), lambda where, order: theirs(where, nu=order))


def test_cubics_of_slopes_are_scipys() -> None:
    x = equal_steps(OF, 50)
    at = OF.at(x)
    theirs = BPoly.from_derivatives(x, np.column_stack([at.y, at.y1]))
    compared(x, hermite(x, at.y, at.y1), lambda where, order: theirs(where, nu=order))
    near = np.clip(np.arange(50), 1, 48)[:, None] + [-1, 0, 1]  # three points, of which the middle one is the point's
    slopes = [np.polynomial.Polynomial.fit(x[k], at.y[k], 2).deriv()(one) for k, one in zip(near, x, strict=True)]
    local = BPoly.from_derivatives(x, np.column_stack([at.y, slopes]))
    compared(x, parabolas(x, at.y), lambda where, order: local(where, nu=order))
