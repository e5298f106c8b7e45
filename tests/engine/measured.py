"""What is said of a law, measured at its values: coefficients, the place of its peak.

Each function returns what disagrees, in words; nothing where all is true.
"""

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq

from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.inverse import breaks, velocity_peak
from tests.engine.families import integrals

SAME = 1e-12
NEAR_ENDS = 2.0 * BREAK_TOLERANCE
"""in units of ξ, by which samples keep off the ends of stages: nearer, they are on them"""


def within(law, share):
    """ξ at shares of every stage, a row a stage, a hair off its ends."""
    edges = breaks(law)
    return edges[:-1, None] + NEAR_ENDS + (np.diff(edges)[:, None] - 2.0 * NEAR_ENDS) * share


def crossings(function: Callable[[Array], Array], edges: Array) -> Array:
    """Return where a function of ξ changes its sign between samples within the sections."""
    found = []
    for begin, end in pairwise(edges):
        off = min(max(1e-9 * (end - begin), 2.0 * BREAK_TOLERANCE), 0.5 * (end - begin))
        xi = np.linspace(begin + off, end - off, 257)
        above = function(xi) > 0.0
        found += [brentq(lambda x: float(function(np.array([x]))[0]), xi[k], xi[k + 1], xtol=1e-15)
                  for k in np.flatnonzero(above[1:] != above[:-1])]  # fmt: skip
    return np.array(found)


def coefficients(law):
    """The coefficients of a law, from its stages and the zeros of its derivatives within them."""
    edges = breaks(law)
    at = law.evaluate(within(law, np.linspace(0, 1, 2001)))
    turns = [crossings(f, edges) for f in (law.a, law.j, lambda xi: law.a(xi) ** 2 + law.v(xi) * law.j(xi))]
    more = law.evaluate(np.concatenate([*turns, [0.5]]))
    v, a, j = (np.concatenate([x.ravel(), y]) for x, y in zip(at[1:], more[1:], strict=True))
    steps = np.abs(np.concatenate([[0.0], at.a[:, -1]]) - np.concatenate([at.a[:, 0], [0.0]]))
    return {
        "cv": np.abs(v).max(), "ca_max": a.max(), "ca_min": a.min(),
        "ca_rms": math.sqrt(sum(found[3] for *_, found in integrals(law))),
        "cj": math.inf if steps.max() > 1e-6 * max(np.abs(a).max(), 1e-3) else np.abs(j).max(),
        "va_max": (v * a).max(), "va_min": (v * a).min(),
    }  # fmt: skip


def wrong_coefficients(law):
    """Coefficients that are not those of the law."""
    stated = law.coefficients
    return [
        f"coefficients: {name} is {getattr(stated, name):.9g}, measured {value:.9g}"
        for name, value in coefficients(law).items()
        if getattr(stated, name) != value and abs(getattr(stated, name) - value) > 2e-6 * max(1.0, abs(value))
    ]


def wrong_peak(law):
    """Whether the law is anywhere faster than where the engine finds it fastest."""
    greatest = law.v(within(law, np.linspace(0, 1, 2001))).max()
    found = law.v(velocity_peak(law))
    return [] if found >= greatest * (1 - SAME) else [f"peak: v is {found:.9g} at its peak, {greatest:.9g} elsewhere"]


def complaints(entry):
    """All that is said of a law, and is not so, at every set of parameters."""
    measures = (wrong_coefficients, wrong_peak)
    return [
        f"{entry.code} {law}: {words}"
        for law in (*entry.examples, *entry.beyond)
        for measure in measures
        for words in measure(law)
    ]
