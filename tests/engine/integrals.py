"""Integrals and zeros of functions of a law by Gauss-Legendre, between the law's breaks."""

import itertools
from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from engine.laws.base import BREAK_TOLERANCE, Array

NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)
PANELS = 4  # a section


def crossings(function: Callable[[Array], Array], edges: Array) -> Array:
    """Return where a function of ξ changes its sign between samples within the sections."""
    found = []
    for begin, end in itertools.pairwise(edges):
        off = min(max(1e-9 * (end - begin), 2.0 * BREAK_TOLERANCE), 0.5 * (end - begin))
        xi = np.linspace(begin + off, end - off, 257)
        above = function(xi) > 0.0
        found += [brentq(lambda x: float(function(np.array([x]))[0]), xi[k], xi[k + 1], xtol=1e-15)
                  for k in np.flatnonzero(above[1:] != above[:-1])]  # fmt: skip
    return np.array(found)


def integral(function: Callable[[Array], Array], edges: Array) -> float:
    """Return ∫ of a function of ξ, smooth between the edges, by Gauss-Legendre: exact to rounding.

    Nodes keep off the edges by twice the tolerance of a break: there a law already has the value of the next stage.
    """
    fine = np.concatenate([[edges[0]], *(np.linspace(a, b, PANELS + 1)[1:] for a, b in itertools.pairwise(edges))])
    half = np.diff(fine)[:, None] / 2.0
    begin, end = (np.repeat(side, PANELS)[:, None] for side in (edges[:-1], edges[1:]))
    off = np.minimum(2.0 * BREAK_TOLERANCE, 0.5 * (end - begin))
    values = function(np.clip(fine[:-1, None] + half * (NODES + 1.0), begin + off, end - off))
    return float((values * WEIGHTS * half).sum())
